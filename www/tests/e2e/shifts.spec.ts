import { expect, test } from "@playwright/test";
import { linkOf } from "../../src/browser/address.ts";
import { engine } from "../core.ts";
import { openSlowly } from "./states.ts";

/** A tenth is what the web calls good; of what happens by itself on the page next to nothing may move. */
const MOST = 0.02;

interface Shift extends PerformanceEntry {
  value: number;
  sources: { node: Node | null }[];
}

for (const [width, height] of [
  [1440, 900],
  [1024, 768],
  [820, 1180],
  [390, 844],
] as const) {
  for (const link of ["", "seed=a+longer+word&land=island&aspect=2.2&attractors=900&trim=33"]) {
    test(`next to nothing moves from the first sight to the finished river, ${width} by ${height}: ?${link}`, async ({
      page,
    }) => {
      await page.setViewportSize({ width, height });
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
      await openSlowly(page, link);
      const shifts = await page.evaluate(
        () => (globalThis as unknown as { shifts: { value: number; what: string }[] }).shifts,
      );
      const sum = shifts.reduce((all, { value }) => all + value, 0);
      expect(sum, JSON.stringify(shifts, null, 1)).toBeLessThanOrEqual(MOST);
    });
  }
}

for (const link of [
  "",
  "?aspect=2.2",
  "?aspect=0.4&fbclid=1",
  "?aspect=0.4#utm_source=post",
  "#aspect=3&seed=a",
  "?aspect=99",
  "?aspect=wide",
]) {
  test(`the picture's place has the river's shape before the engine has come: ${link}`, async ({ page }) => {
    await page.route("**/*.wasm", () => {});
    await page.goto(`./${link}`);
    await expect(page.getByText("Preparing the rivers…")).toBeVisible();
    const { width, height } = (await page.locator("#frame").boundingBox()) ?? { width: 0, height: 0 };
    const aspect = new Map(engine.readLink(linkOf(new URL(link, "http://localhost/"))).values).get("aspect");
    expect(width / height).toBeCloseTo(Number(aspect), 1);
  });
}
