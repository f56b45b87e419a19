import { expect, type Page, test } from "@playwright/test";
import { core } from "./tiers.ts";

/** The heading is upright, the line below it italic. */
const TEXTS = ["h1", ".masthead p"];

for (const face of ["garamond-italic", "garamond"])
  test(`text is set in one family though ${face} comes too late${core(face === "garamond-italic")}`, async ({
    page,
  }) => {
    let release = (): void => {};
    const held = new Promise<void>((done) => {
      release = done;
    });
    await page.route(`**/${face}-*.woff2`, async (route) => {
      await held;
      await route.continue();
    });
    await page.goto("./?attractors=300", { waitUntil: "commit" });
    await expect.poll(() => families(page)).toEqual(["Iowan Old Style", "Iowan Old Style"]);
    // Not in the same visit, even when it comes: nothing jumps.
    release();
    await page.evaluate(() => document.fonts.ready);
    expect(await families(page)).toEqual(["Iowan Old Style", "Iowan Old Style"]);
  });

/** Returns the first family that each text asks for. */
function families(page: Page): Promise<(string | undefined)[]> {
  return page.evaluate(
    (texts) =>
      texts.map((text) => {
        const element = document.querySelector(text);
        return element ? getComputedStyle(element).fontFamily.split(",")[0]?.replaceAll('"', "") : undefined;
      }),
    TEXTS,
  );
}
