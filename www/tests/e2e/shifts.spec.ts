import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import type { Page } from "@playwright/test";
import { finished } from "./riverpage.ts";
import { openSlowly } from "./states.ts";
import { core } from "./tiers.ts";
import { expect, test } from "./widget/hosts.ts";

/** The built site. */
const SITE = fileURLToPath(new URL("../../dist", import.meta.url));

/** A tenth is what the web calls good; of what happens by itself on the page next to nothing may move. */
const MOST = 0.02;

/** A layout shift as the browser reports it. */
interface Shift extends PerformanceEntry {
  value: number;
  sources: { node: Node | null }[];
}

/** Has the page remember what moves on it by itself. Call before `goto`. */
async function watchShifts(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const shifts: { value: number; what: string }[] = [];
    Object.assign(globalThis, { shifts });
    new PerformanceObserver((list) => {
      for (const { value, sources } of list.getEntries() as Shift[]) {
        const what = sources.map(({ node }) => (node instanceof Element ? node.outerHTML.slice(0, 60) : "text"));
        shifts.push({ value, what: what.join(", ") });
      }
    }).observe({ type: "layout-shift", buffered: true });
  });
}

async function expectNextToNoShift(page: Page): Promise<void> {
  const shifts = await page.evaluate(
    () => (globalThis as unknown as { shifts: { value: number; what: string }[] }).shifts,
  );
  const sum = shifts.reduce((all, { value }) => all + value, 0);
  expect(sum, JSON.stringify(shifts, null, 1)).toBeLessThanOrEqual(MOST);
}

for (const [width, height] of [
  [1440, 900],
  [1024, 768],
  [820, 1180],
  [390, 844],
] as const) {
  for (const link of ["", "seed=a+longer+word&land=island&aspect=2.2&attractors=900&trim=33"]) {
    test(`next to nothing moves from the first sight to the finished river, ${width} by ${height}: ?${link}${core(link === "" && (width === 1440 || width === 390))}`, async ({
      page,
    }) => {
      await page.setViewportSize({ width, height });
      await watchShifts(page);
      await openSlowly(page, link);
      await expectNextToNoShift(page);
    });
  }

  for (const last of ['<section class="bar"', '<section class="panel"', '<dialog class="sharing"']) {
    test(`next to nothing moves when the page comes in two parts, ${width} by ${height}, the second from ${last}${core(width === 390 && last.includes("panel"))}`, async ({
      page,
      blog,
    }) => {
      const html = await readFile(join(SITE, "index.html"), "utf8");
      const cut = html.indexOf(last);
      expect(cut).toBeGreaterThan(0);
      let send = (_rest: string): void => {};
      const rest = new Promise<string>((done) => {
        send = done;
      });
      blog.folder("/", SITE);
      blog.answer("/", { body: html.slice(0, cut), rest });
      await page.setViewportSize({ width, height });
      await watchShifts(page);
      await page.goto(blog.origin, { waitUntil: "commit" });
      await page.locator("#frame").waitFor({ state: "attached" });
      await page.waitForFunction(() => document.styleSheets.length > 0, null, { polling: 50 });
      // Some looks later the first part would be painted, if a page were painted in parts.
      for (let looks = 0; looks < 100; looks++) await page.title();
      send(html.slice(cut));
      await finished(page);
      await expectNextToNoShift(page);
    });
  }
}
