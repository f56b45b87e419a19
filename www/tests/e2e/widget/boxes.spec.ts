import { readFileSync } from "node:fs";
import { core } from "../tiers.ts";
import { expect, test } from "./hosts.ts";
import { frames, heard, listen, post } from "./post.ts";

const SIZED = "width: 640px; height: 400px";

/** Boxes as blogs center their posts with them; `@` stands for the element. */
const BOXES: Readonly<Record<string, string>> = {
  block: "<div>@</div>",
  "a row": '<div style="display: flex">@</div>',
  "a centred row": '<div style="display: flex; justify-content: center">@</div>',
  "a row, centred in height": '<div style="display: flex; align-items: center; min-height: 500px">@</div>',
  "a centred column": '<div style="display: flex; flex-direction: column; align-items: center">@</div>',
  "a centred grid": '<div style="display: grid; place-items: center">@</div>',
  "a grid of two":
    '<div style="display: grid; grid-template-columns: auto auto">@<p>Beside it are words, as in posts.</p></div>',
  "a float": '<div style="overflow: auto"><div style="float: left">@</div></div>',
  "a table": "<table><tr><td>@</td></tr></table>",
  "an inline block": '<div style="display: inline-block">@</div>',
  "a fitted box": '<div style="width: fit-content">@</div>',
  "a placed box": '<div style="position: relative; height: 500px"><div style="position: absolute">@</div></div>',
  "a list in a row": '<ul style="display: flex; list-style: none; padding: 0"><li>@</li><li>Words</li></ul>',
};

const POSTER = `<img alt="" width="1200" height="750" style="display: block; width: 100%; height: auto"
  src="data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' width='1200' height='750' viewBox='0 0 12 8'/%3E">`;
/** What docs/element.md recommends for the time before the script has come. */
const BEFORE =
  "<style>river-seed:not(:defined) { display: block; aspect-ratio: 1.6; min-height: 0; overflow: hidden }</style>";

for (const [what, poster] of [
  ["without a poster", ""],
  ["with a poster", POSTER],
] as const) {
  for (const width of [1280, 390]) {
    test(`the element has a size in every kind of box, ${what}, ${width} wide${core(width === 390 && poster !== "")}`, async ({
      page,
      blog,
    }) => {
      // All of them are seen, so all of them begin.
      await page.setViewportSize({ width, height: 9000 });
      const events = await listen(page);
      const boxes = Object.entries(BOXES).map(([name, box]) => {
        return `<section>${box.replace("@", `<river-seed id="${name}" attractors="100" labels="none" still loading="eager">${poster}</river-seed>`)}</section>`;
      });
      blog.answer("/", { body: post(BEFORE + boxes.join("")) });
      await page.goto(blog.origin);
      await heard(events, "complete", boxes.length);
      await frames(page, 5);
      const rivers = page.locator("river-seed");
      for (const name of Object.keys(BOXES)) {
        const { width: across, height: down } = (await page.locator(`[id="${name}"]`).boundingBox()) ?? {
          width: 0,
          height: 0,
        };
        // On a narrow page what stands beside it takes its share.
        const least = width > 1000 ? 640 : 150;
        expect(across, name).toBeGreaterThanOrEqual(least);
        expect(across / down, name).toBeCloseTo(1.6, 1);
      }
      expect(await page.evaluate(() => document.documentElement.scrollWidth), "nothing sticks out").toBe(width);
      expect(await rivers.count()).toBe(boxes.length);
    });
  }
}

test("an author's size stands", async ({ page, blog }) => {
  await page.setViewportSize({ width: 1280, height: 3000 });
  const events = await listen(page);
  const shapes = [SIZED, "width: 100px", "inline-size: 1000px", "height: 123px"];
  const rivers = shapes.map(
    (style) => `<div style="display: flex"><river-seed attractors="100" still style="${style}"></river-seed></div>`,
  );
  blog.answer("/", { body: post(rivers.join("")) });
  await page.goto(blog.origin);
  await heard(events, "complete", shapes.length);
  const sizes = await page
    .locator("river-seed")
    .evaluateAll((all) => all.map((one) => [one.clientWidth, one.clientHeight]));
  expect(sizes).toEqual([
    [640, 400],
    [100, 63],
    [1000, 625],
    [197, 123],
  ]);
});

test("an element that its box leaves no width says so", async ({ page, blog }) => {
  await page.clock.install();
  const said: string[] = [];
  page.on("console", (message) => said.push(message.text()));
  const hidden = '<div style="display: none"><river-seed></river-seed></div>';
  blog.answer("/", { body: post(`${hidden}<div style="width: 0"><river-seed></river-seed></div>`) });
  await page.goto(blog.origin);
  await page.waitForFunction(() => customElements.get("river-seed"));
  await page.clock.runFor(2100);
  expect(said).toEqual([expect.stringMatching(/^river-seed: its box leaves it no width/)]);
});

test("a page that takes all styles away gives the element its size back by the rule that is documented", async ({
  page,
  blog,
}) => {
  const documented = readFileSync(new URL("../../../../docs/element.md", import.meta.url), "utf8");
  const [rule = ""] = /river-seed \{ display: block; position[^}]*\}/.exec(documented) ?? [];
  await page.setViewportSize({ width: 800, height: 1000 });
  const events = await listen(page);
  const styles = `<style>body * { all: unset } ${rule}</style>`;
  blog.answer("/", { body: post(`${styles}<river-seed attractors="100" still></river-seed>`) });
  await page.goto(blog.origin);
  await heard(events, "complete");
  const box = await page.locator("river-seed").boundingBox();
  expect(box?.width).toBeGreaterThan(640);
  expect((box?.width ?? 0) / (box?.height ?? 1)).toBeCloseTo(1.6, 1);
});
