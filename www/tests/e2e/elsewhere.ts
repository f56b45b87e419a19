/** Pages on another origin than the site's, and what is to be seen on them. */

import type { Locator, Page } from "@playwright/test";
import { embeddedPictureOf } from "../core.ts";
import type { Host } from "./widget/hosts.ts";

/** Where a page elsewhere is opened: the browser's page, somebody else's host, and the site's address. */
export interface Elsewhere {
  page: Page;
  blog: Host;
  baseURL: string | undefined;
}

/** Opens a page of somebody else's; in it `SITE/` stands for the site's address. */
export async function openElsewhere({ page, blog, baseURL }: Elsewhere, body: string): Promise<void> {
  if (baseURL === undefined) throw new Error("the tests have no base address");
  const html = `<!doctype html><html lang="en"><title>A post</title><link rel="icon" href="data:,"><body><h1>A post</h1>${body}`;
  blog.answer("/post.html", { body: html.replaceAll("SITE/", baseURL) });
  await page.goto(`${blog.origin}/post.html`);
}

/** What the screen shows where an element stands. */
export async function seen(page: Page, element: Locator): Promise<{ width: number; height: number; sha256: string }> {
  await element.scrollIntoViewIfNeeded();
  const shot = (await page.screenshot({ clip: await placeOf(element) })).toString("base64");
  return await page.evaluate(async (shot) => {
    const bytes = Uint8Array.from(atob(shot), (sign) => sign.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext("2d");
    context?.drawImage(image, 0, 0);
    const { data } = context?.getImageData(0, 0, image.width, image.height) ?? { data: new Uint8ClampedArray() };
    const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", data));
    const sha256 = Array.from(digest, (byte) => byte.toString(16).padStart(2, "0")).join("");
    return { width: image.width, height: image.height, sha256 };
  }, shot);
}

/** The pixels of the screen that an element covers: its edges go to the nearest ones. */
async function placeOf(element: Locator): Promise<{ x: number; y: number; width: number; height: number }> {
  const box = await element.boundingBox();
  if (!box) throw new Error("the element is nowhere");
  const [x, y] = [Math.round(box.x), Math.round(box.y)];
  return { x, y, width: Math.round(box.x + box.width) - x, height: Math.round(box.y + box.height) - y };
}

/** Whether the screen shows the finished river of a link in an element, to the pixel. */
export async function showsRiver(page: Page, element: Locator, link: string): Promise<boolean> {
  const { width, height, sha256 } = await seen(page, element);
  return sha256 === embeddedPictureOf(link, width, height).sha256;
}
