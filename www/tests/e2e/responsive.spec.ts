import { expect, test } from "@playwright/test";
import { openFinished, openUnfolded } from "./riverpage.ts";

const SIZES = [
  { name: "desk", width: 1440, height: 900 },
  { name: "tablet", width: 820, height: 1180 },
  { name: "phone", width: 390, height: 844 },
  { name: "small phone", width: 320, height: 568 },
  { name: "phone on its side", width: 844, height: 390 },
];

for (const { name, ...viewport } of SIZES) {
  test.describe(`${name}, ${viewport.width} by ${viewport.height}`, () => {
    test.use({ viewport });

    for (const link of ["", "aspect=4", "aspect=0.25"]) {
      test(`the picture is in sight and nothing scrolls sideways: ?${link}`, async ({ page }) => {
        await openFinished(page, link);
        const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        expect(overflow).toBeLessThanOrEqual(0);
        const box = await page.locator("#frame").boundingBox();
        if (!box) throw new Error("no picture");
        expect(box.x).toBeGreaterThanOrEqual(0);
        expect(box.y).toBeGreaterThanOrEqual(0);
        expect(box.x + box.width).toBeLessThanOrEqual(viewport.width);
        expect(box.y + box.height).toBeLessThanOrEqual(viewport.height);
        if (viewport.height > 480)
          await expect(page.getByRole("button", { name: "Restart" })).toBeInViewport({ ratio: 1 });
        const aspect = await page.locator("canvas").evaluate((canvas: HTMLCanvasElement) => {
          const { width, height } = canvas.getBoundingClientRect();
          return width / height;
        });
        const asked = Number(new URLSearchParams(link).get("aspect") ?? 1.6);
        expect(Math.abs(aspect / asked - 1)).toBeLessThan(0.02);
      });
    }

    test("every control can be brought into sight and is large enough for a finger", async ({ page }) => {
      await openUnfolded(page, "attractors=300&curl=1");
      for (const control of await page.locator("button, input, select, summary, label.side").all()) {
        if (!(await control.isVisible())) continue;
        await control.scrollIntoViewIfNeeded();
        await expect(control).toBeInViewport();
        const { width, height } = (await control.boundingBox()) ?? { width: 0, height: 0 };
        const isBox = (await control.getAttribute("type")) === "checkbox";
        // A checkbox is as large as the label around it.
        if (!isBox)
          expect(Math.min(width, height), await control.evaluate((e) => e.outerHTML)).toBeGreaterThanOrEqual(24);
      }
    });

    test("what has the focus is not hidden behind the picture", async ({ page }) => {
      await openFinished(page, "attractors=300");
      await page.locator("#seed").focus();
      for (let i = 0; i < 30; i++) {
        await page.keyboard.press("Tab");
        const hidden = await page.evaluate(() => {
          const element = document.activeElement;
          if (!element || element === document.body) return "";
          const { left, top, width, height } = element.getBoundingClientRect();
          const hit = document.elementFromPoint(left + width / 2, top + height / 2);
          return hit && (element.contains(hit) || hit.contains(element)) ? "" : element.outerHTML;
        });
        expect(hidden).toBe("");
      }
    });
  });
}

/** The widths at which the layout changes, and the desk's smallest, with their neighbours. */
for (const width of [320, 519, 520, 820, 859, 860, 999, 1000, 1040, 1090, 1200, 1280, 1440]) {
  test(`the legend stays under the picture and beside nothing, drawing or not, ${width} wide`, async ({ page }) => {
    await page.setViewportSize({ width, height: 720 });
    await openFinished(page, "attractors=300");
    const legend = page.locator(".legend");
    const frame = await page.locator("#frame").boundingBox();
    const before = await legend.boundingBox();
    if (!frame || !before) throw new Error("no legend");
    const expectInStage = async (selector: string): Promise<void> => {
      const stage = await page.locator(".stage").boundingBox();
      if (!stage) throw new Error("no stage");
      for (const part of await legend.locator(selector).all()) {
        const { x, y, width, height } = (await part.boundingBox()) ?? { x: 0, y: 0, width: 0, height: 0 };
        if (width === 0) continue;
        const name = await part.evaluate((element) => element.outerHTML);
        expect(x, name).toBeGreaterThanOrEqual(stage.x);
        expect(x + width, name).toBeLessThanOrEqual(stage.x + stage.width);
        expect(y, name).toBeGreaterThanOrEqual(frame.y + frame.height);
        expect(y + height, name).toBeLessThanOrEqual(stage.y + stage.height);
      }
    };
    await expectInStage("p, button, input");
    await page.getByRole("button", { name: "Draw", exact: true }).click();
    await expect(page.locator("#tools")).toBeVisible();
    await expectInStage("p, button");
    expect(await page.locator("#frame").boundingBox()).toEqual(frame);
    // Phones may need a second row of buttons.
    if (width >= 520) expect(Math.abs(((await legend.boundingBox())?.height ?? 0) - before.height)).toBeLessThan(4);
  });
}

for (const [width, height] of [
  [1440, 900],
  [1280, 800],
  [1100, 700],
  [820, 1180],
  [390, 844],
] as const) {
  test(`the screen shows the picture's own pixels, not a stretched copy, ${width} by ${height}`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    await openFinished(page, "land=island&attractors=300");
    const screen = `data:image/png;base64,${(await page.screenshot()).toString("base64")}`;
    const different = await page.locator("canvas").evaluate(async (canvas: HTMLCanvasElement, screen) => {
      const image = new Image();
      image.src = screen;
      await image.decode();
      const { width, height } = canvas;
      const copied = (source: CanvasImageSource, left = 0, top = 0): Uint8ClampedArray => {
        const context = Object.assign(document.createElement("canvas"), { width, height }).getContext("2d");
        context?.drawImage(source, left, top);
        return context?.getImageData(0, 0, width, height).data ?? new Uint8ClampedArray();
      };
      const { left, top } = canvas.getBoundingClientRect();
      const seen = copied(image, -Math.round(left), -Math.round(top));
      const own = copied(canvas);
      return [...own].filter((byte, i) => byte !== seen[i]).length;
    }, screen);
    expect(different).toBe(0);
  });
}

test("a screen with fine pixels gets a fine picture, up to two to the CSS pixel", async ({ browser }) => {
  for (const [ratio, expected] of [
    [1, 1],
    [2, 2],
    [3, 2],
  ] as const) {
    const page = await browser.newPage({ viewport: { width: 400, height: 800 }, deviceScaleFactor: ratio });
    await openFinished(page, "attractors=300");
    const scale = await page.locator("canvas").evaluate((canvas: HTMLCanvasElement) => {
      return canvas.width / canvas.getBoundingClientRect().width;
    });
    expect(scale).toBeCloseTo(expected, 1);
    await page.close();
  }
});
