/** A page that is opened from disk, as beginners do first. */

import { copyFile, mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import type { Page } from "@playwright/test";
import type { RiverSeed } from "../../../src/apps/widget/element.ts";
import { complaints } from "../riverpage.ts";
import { BUILT, test as base, expect } from "./hosts.ts";
import { canonical, expectPicture, heard, listen } from "./post.ts";

const RECIPE = "seed=rimu&attractors=300&style=ink&labels=none";
const NAMED = "seed=rimu&attractors=1500&style=ink&labels=some";

/** open: opens a page from a folder on disk, in which it is alone with one script of the widget. */
const test = base.extend<{ open: (page: Page, script: string, river: string) => Promise<void> }>({
  // biome-ignore lint/correctness/noEmptyPattern: the form that Playwright wants
  open: async ({}, use) => {
    const folder = await mkdtemp(join(tmpdir(), "riverseed-disk-"));
    await use(async (page, script, river) => {
      const [, name = ""] = /src="([^"]+)"/.exec(script) ?? [];
      await copyFile(join(BUILT, name), join(folder, name));
      const file = join(folder, "post.html");
      await writeFile(
        file,
        `<!doctype html><html lang="en"><meta charset="utf-8"><title>A post</title>${script}${river}`,
      );
      await page.goto(pathToFileURL(file).href);
    });
    await rm(folder, { recursive: true });
  },
});

const CLASSIC = '<script src="river-seed.classic.js"></script>';

test("the classic script shows the core's picture, alone in its folder @core", async ({ page, open }) => {
  const said = complaints(page);
  const events = await listen(page);
  await open(page, CLASSIC, `<river-seed recipe="${RECIPE}"><p>A river.</p></river-seed>`);
  await heard(events, "complete");
  await expectPicture(page, canonical(RECIPE));
  expect(said).toEqual([]);
});

test("it has names, and makes a PNG and an SVG", async ({ page, open }) => {
  const events = await listen(page);
  await open(page, CLASSIC, `<river-seed recipe="${NAMED}" still></river-seed>`);
  await heard(events, "complete");
  const said = await page.locator("river-seed").evaluate(async (river: RiverSeed) => {
    const { width } = await createImageBitmap(await river.toBlob({ longSide: 320 }));
    const svg = await river.toSVG();
    const bare = river.cloneNode() as RiverSeed;
    bare.labels = "none";
    document.body.append(bare);
    await bare.finished;
    const bytes = async (one: RiverSeed): Promise<string> =>
      new Uint8Array(await (await one.toBlob({ longSide: 320 })).arrayBuffer()).join();
    return [width, svg.includes('id="labels"'), (await bytes(river)) !== (await bytes(bare))];
  });
  expect(said).toEqual([320, true, true]);
  expect((await events()).filter(({ type }) => type === "error")).toEqual([]);
});

test("the module script cannot be loaded from there, so the author's words stay", async ({ page, open }) => {
  const script = '<script type="module" src="river-seed.js"></script>';
  await open(page, script, `<river-seed recipe="${RECIPE}"><p>This map needs a web server.</p></river-seed>`);
  await expect(page.getByText("This map needs a web server.")).toBeVisible();
  expect(await page.evaluate(() => customElements.get("river-seed"))).toBeUndefined();
});
