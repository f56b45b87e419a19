import { expect, type Page, test } from "@playwright/test";
import { openFinished, openPanel, openUnfolded, resize, showAll } from "./riverpage.ts";
import { core } from "./tiers.ts";

type Size = readonly [number, number];

/** Windows on a desk and in the hand. A page is opened in the first of a row, and then its window is made the others'. */
const ROWS: Record<string, readonly [Size, ...Size[]]> = {
  "on a desk and a tablet": [
    [1440, 900],
    [820, 1180],
  ],
  "on phones": [
    [390, 844],
    [320, 568],
    [844, 390],
  ],
};

for (const [where, sizes] of Object.entries(ROWS)) {
  const opened = async (page: Page, open: typeof openFinished, link: string): Promise<void> => {
    await resize(page, ...sizes[0]);
    await open(page, link);
  };

  for (const link of ["attractors=300", "attractors=300&aspect=4", "attractors=300&aspect=0.25"]) {
    test(`all of the map is in sight, beside what lies over the picture, and nothing scrolls sideways: ${where}, ?${link}${core(link === "attractors=300")}`, async ({
      page,
    }) => {
      await opened(page, openFinished, link);
      await showAll(page);
      for (const [width, height] of sizes) {
        await resize(page, width, height);
        await expectWhole(page, width, Number(new URLSearchParams(link).get("aspect") ?? 1.6));
      }
    });
  }

  test(`every control can be brought into sight and is large enough for a finger: ${where}${core(where === "on phones")}`, async ({
    page,
  }) => {
    await opened(page, openUnfolded, "attractors=300&curl=1");
    for (const size of sizes) {
      await resize(page, ...size);
      await expectFitForFingers(page, `${size}`);
    }
  });

  test(`what has the focus is not hidden behind the picture: ${where}`, async ({ page }) => {
    await opened(page, openFinished, "attractors=300");
    for (const size of sizes) {
      await resize(page, ...size);
      await expectFocusInSight(page, `${size}`);
    }
  });
}

async function expectWhole(page: Page, windowWidth: number, aspect: number): Promise<void> {
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  expect(overflow).toBeLessThanOrEqual(0);
  const map = await page.locator("#map-place").boundingBox();
  const bar = await page.locator(".bar").boundingBox();
  if (!map || !bar) throw new Error("no map");
  expect(map.x).toBeGreaterThanOrEqual(0);
  expect(map.y).toBeGreaterThanOrEqual(0);
  expect(map.x + map.width).toBeLessThanOrEqual(windowWidth);
  expect(map.y + map.height).toBeLessThanOrEqual(bar.y);
  expect(Math.abs(map.width / map.height / aspect - 1)).toBeLessThan(0.02);
  for (const name of ["A new seed by chance", "Replay", "Send", "Save", "Share", "Shape…"])
    await expect(page.getByRole("button", { name, exact: true })).toBeInViewport({ ratio: 1 });
}

async function expectFitForFingers(page: Page, size: string): Promise<void> {
  const controls = page.locator("button, input, select, summary, label.side");
  // In the page, in one go: there are hundreds.
  const wrong = await controls.evaluateAll(async (all) => {
    const isInSight = (control: Element): Promise<boolean> =>
      new Promise((done) => {
        control.scrollIntoView({ block: "center", inline: "center" });
        const observer = new IntersectionObserver(([entry]) => {
          observer.disconnect();
          done((entry?.intersectionRatio ?? 0) > 0);
        });
        observer.observe(control);
      });
    const found: string[] = [];
    let count = 0;
    for (const control of all) {
      const size = (): number => {
        const { width, height } = control.getBoundingClientRect();
        return Math.min(width, height);
      };
      if (!control.checkVisibility({ visibilityProperty: true }) || size() === 0) continue;
      count++;
      // Names that come meanwhile move what is below them: then once more.
      if (!(await isInSight(control)) && !(await isInSight(control))) found.push(`out of sight: ${control.outerHTML}`);
      // A checkbox is as large as the label around it.
      const isBox = control.getAttribute("type") === "checkbox";
      if (!isBox && size() < 24) found.push(`${size()} pixels: ${control.outerHTML}`);
    }
    return { found, count };
  });
  expect(wrong.found, size).toEqual([]);
  expect(wrong.count, size).toBeGreaterThan(100);
}

async function expectFocusInSight(page: Page, size: string): Promise<void> {
  await page.locator("#seed").focus();
  for (let i = 0; i < 30; i++) {
    await page.keyboard.press("Tab");
    const hidden = await page.evaluate(async () => {
      // A row that scrolls to what has the focus does so with the next frame.
      await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
      const element = document.activeElement;
      if (!element || element === document.body) return "";
      const { left, top, width, height } = element.getBoundingClientRect();
      const hit = document.elementFromPoint(left + width / 2, top + height / 2);
      return hit && (element.contains(hit) || hit.contains(element)) ? "" : element.outerHTML;
    });
    expect(hidden, size).toBe("");
  }
}

test("the screen shows the picture's own pixels, not a stretched copy, in windows of every size @core", async ({
  page,
}) => {
  await openFinished(page, "land=island&attractors=300");
  await page.evaluate(() => {
    for (const over of document.querySelectorAll<HTMLElement>(
      ".masthead, .caption, .zoom, .bar, .styles, .notices, .welcome",
    ))
      over.style.visibility = "hidden";
  });
  const different = async (): Promise<number> => {
    const screen = `data:image/png;base64,${(await page.screenshot()).toString("base64")}`;
    return page.locator("#canvas").evaluate(async (canvas: HTMLCanvasElement, screen) => {
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
  };
  const sizes: readonly Size[] = [
    [1440, 900],
    [1280, 800],
    [1100, 700],
    [820, 1180],
    [390, 844],
  ];
  for (const size of sizes) {
    await resize(page, ...size);
    // Once the map is painted in its place.
    await expect.poll(different, `${size}`).toBe(0);
  }
});

test("a screen with fine pixels gets a fine picture, up to two to the CSS pixel @core", async ({ browser }) => {
  for (const [ratio, expected] of [
    [1, 1],
    [2, 2],
    [3, 2],
  ] as const) {
    const page = await browser.newPage({ viewport: { width: 400, height: 800 }, deviceScaleFactor: ratio });
    await openFinished(page, "attractors=300");
    const scale = await page.locator("#canvas").evaluate((canvas: HTMLCanvasElement) => {
      return canvas.width / canvas.getBoundingClientRect().width;
    });
    expect(scale).toBeCloseTo(expected, 1);
    await page.close();
  }
});

for (const panel of ["closed", "open"]) {
  test(`what lies over the map lies over nothing else, the panel ${panel}${core(panel === "open")}`, async ({
    page,
  }) => {
    for (const [width, height] of [
      [320, 568],
      [768, 1024],
      [1024, 768],
      [1280, 800],
      [1440, 900],
    ] as const) {
      await page.setViewportSize({ width, height });
      await openFinished(page, "attractors=300&curl=99");
      await expect(page.locator("#notices")).toBeVisible();
      if (panel === "open") await openPanel(page);
      // A sheet from below lies over the styles, and a notice over that.
      const isSheet = panel === "open" && width < 1000;
      const always = ".bar, .panel, .masthead h1, .masthead p, .gallery-link, .title, #caption, .zoom";
      const beside = isSheet ? always : `${always}, .styles`;
      const where = `${width} by ${height}`;
      expect(await overlapping(page, beside), where).toEqual([]);
      await page.getByRole("button", { name: "Draw", exact: true }).click();
      await expect(page.locator("#tools")).toBeVisible();
      const drawing = `${beside}, .tools${isSheet ? "" : ", .notices"}`;
      expect(await overlapping(page, drawing), `${where}, drawing`).toEqual([]);
    }
  });
}

/** Which of some elements, as far as they are seen, lie over each other. */
function overlapping(page: Page, selectors: string): Promise<string[]> {
  return page.evaluate((selectors) => {
    const seen = [...document.querySelectorAll(selectors)].filter((element) => element.checkVisibility());
    const pairs = seen.flatMap((one, i) => seen.slice(i + 1).map((other) => [one, other] as const));
    const named = ({ id, className, tagName }: Element): string => id || className || tagName;
    const areOver = ([one, other]: readonly [Element, Element]): boolean => {
      const [a, b] = [one.getBoundingClientRect(), other.getBoundingClientRect()];
      return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
    };
    return pairs.filter(areOver).map((pair) => pair.map(named).join(" and "));
  }, selectors);
}
