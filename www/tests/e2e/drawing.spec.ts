import { deflateSync } from "node:zlib";
import { expect, type Page, test } from "@playwright/test";
import { engine } from "../core.ts";
import { violations } from "./axe.ts";
import {
  address,
  expectAddress,
  expectPictureOfAddress,
  finished,
  openFinished,
  openUnfolded,
  shown,
} from "./riverpage.ts";

const SMALL = "seed=kauri&attractors=300&style=ink&labels=none";
const BLOB = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11].map((i) => {
  const angle = (i / 12) * 2 * Math.PI;
  const radius = 0.3 + 0.06 * Math.sin(3 * angle);
  return [0.5 + radius * Math.cos(angle), 0.5 + radius * Math.sin(angle)] as const;
});

async function openTool(page: Page, link = SMALL): Promise<void> {
  await openFinished(page, link);
  await page.getByRole("button", { name: "Draw", exact: true }).click();
  await expect(page.getByRole("group", { name: "Drawing a land" })).toBeVisible();
}

for (const width of [1440, 1024]) {
  test(`beside an open panel nothing covers the tools: ${width} wide`, async ({ page }) => {
    await page.setViewportSize({ width, height: 800 });
    await openUnfolded(page, SMALL);
    await page.getByRole("button", { name: "Draw", exact: true }).click();
    const tools = page.getByRole("group", { name: "Drawing a land" });
    for (const name of ["Import…", "Done"]) await tools.getByRole("button", { name }).click({ trial: true });
    const [group, styles] = [await tools.boundingBox(), await page.locator("#styles").boundingBox()];
    expect((group?.x ?? 0) + (group?.width ?? 0)).toBeLessThanOrEqual(styles?.x ?? 0);
  });
}

/** Draws a line through fractions of the map, with the mouse. */
async function draw(page: Page, line: readonly (readonly [number, number])[]): Promise<void> {
  const box = await page.locator("#sketch").boundingBox();
  if (!box) throw new Error("nothing to draw on");
  const [first, ...rest] = line.map(([x, y]) => [box.x + x * box.width, box.y + y * box.height] as const);
  if (!first) return;
  await page.mouse.move(...first);
  await page.mouse.down();
  for (const place of rest) await page.mouse.move(...place, { steps: 3 });
  await page.mouse.up();
}

function linesIn(page: Page): engine.Lines {
  return engine.outlineLines(address(page).get("outline") ?? "");
}

/** A PNG of one byte a pixel, or three. */
function png(
  width: number,
  height: number,
  pixel: (x: number, y: number) => readonly [number, number, number],
): Buffer {
  const rows = Array.from({ length: height }, (_, y) => [
    0,
    ...Array.from({ length: width }, (_, x) => pixel(x, y)).flat(),
  ]);
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  head.set([8, 2, 0, 0, 0], 8);
  const data = deflateSync(Buffer.from(rows.flat()));
  const signature = Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]);
  return Buffer.concat([signature, chunk("IHDR", head), chunk("IDAT", data), chunk("IEND", Buffer.alloc(0))]);
}

function chunk(name: string, data: Buffer): Buffer {
  const body = Buffer.concat([Buffer.from(name), data]);
  const ends = Buffer.alloc(8);
  ends.writeUInt32BE(data.length, 0);
  ends.writeUInt32BE(crc32(body), 4);
  return Buffer.concat([ends.subarray(0, 4), body, ends.subarray(4)]);
}

function crc32(bytes: Buffer): number {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let i = 0; i < 8; i++) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
  }
  return (crc ^ 0xffffffff) >>> 0;
}

/** An island with a ridge on a sea twice as wide as high. */
const ISLAND = png(200, 100, (x, y) => {
  if (Math.abs(y - 50) < 3 && Math.abs(x - 100) < 30) return [220, 30, 30];
  return Math.hypot((x - 100) / 80, (y - 50) / 40) < 1 ? [255, 255, 255] : [0, 0, 0];
});

async function choose(page: Page, buffer: Buffer): Promise<void> {
  await page.locator("#picture").setInputFiles({ name: "land.png", mimeType: "image/png", buffer });
}

test("a coast drawn with the mouse is in the link, and the link draws the same picture afresh @core", async ({
  page,
}) => {
  await openTool(page);
  const before = await shown(page);
  await draw(page, BLOB);
  await expectAddress(page, "land", "drawn");
  await expect(page.locator("#drawing-status")).toContainText("1 coast, ");
  await expectPictureOfAddress(page);
  const drawn = await shown(page);
  expect(drawn.sha256).not.toBe(before.sha256);
  expect(linesIn(page).coasts).toHaveLength(1);
  const link = page.url();
  await page.goto("about:blank");
  await page.goto(link);
  await finished(page);
  expect(await shown(page)).toEqual(drawn);
  await expect(page.locator("#notices")).toBeHidden();
});

test("the land follows the pen before it is lifted", async ({ page }) => {
  await openTool(page);
  const box = await page.locator("#sketch").boundingBox();
  if (!box) throw new Error("nothing to draw on");
  const at = ([x, y]: readonly [number, number]) => [box.x + x * box.width, box.y + y * box.height] as const;
  await page.mouse.move(...at(BLOB[0] ?? [0, 0]));
  await page.mouse.down();
  for (const place of BLOB.slice(1, 8)) await page.mouse.move(...at(place), { steps: 3 });
  await expectAddress(page, "land", "drawn");
  const half = address(page).get("outline");
  for (const place of BLOB.slice(8)) await page.mouse.move(...at(place), { steps: 3 });
  await expect.poll(() => address(page).get("outline")).not.toBe(half);
  await page.mouse.up();
  await expectPictureOfAddress(page);
});

for (const pointerType of ["pen", "touch"]) {
  test(`a ${pointerType} draws too, and a second one at the same time does not disturb it`, async ({ page }) => {
    await openTool(page);
    await page.locator("#sketch").evaluate(
      (sketch, { pointerType, line }) => {
        const { left, top, width, height } = sketch.getBoundingClientRect();
        const send = (type: string, [x = 0, y = 0]: readonly number[] = [], pointerId = 7): void => {
          const place = { clientX: left + x * width, clientY: top + y * height };
          sketch.dispatchEvent(
            new PointerEvent(type, { pointerId, pointerType, bubbles: true, cancelable: true, ...place }),
          );
        };
        // A made-up pointer cannot be captured.
        sketch.setPointerCapture = () => {};
        send("pointerdown", line[0]);
        for (const place of line) {
          send("pointerdown", [0, 0], 8);
          send("pointermove", place);
          send("pointermove", [1, 1], 8);
        }
        send("pointerup", line.at(-1));
      },
      { pointerType, line: BLOB },
    );
    await expectAddress(page, "land", "drawn");
    const [coast = new Float32Array()] = linesIn(page).coasts;
    expect(coast.length / 2).toBe(BLOB.length);
    expect(await page.locator("#sketch").evaluate((sketch) => getComputedStyle(sketch).touchAction)).toBe("none");
    await expectPictureOfAddress(page);
  });
}

test("a real finger draws and does not scroll @core", async ({ browser }) => {
  const page = await browser.newPage({ viewport: { width: 390, height: 844 }, hasTouch: true });
  await openTool(page);
  const box = await page.locator("#sketch").boundingBox();
  if (!box) throw new Error("nothing to draw on");
  const session = await page.context().newCDPSession(page);
  const touch = (type: "touchStart" | "touchMove" | "touchEnd", place?: readonly [number, number]) =>
    session.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: place ? [{ x: box.x + place[0] * box.width, y: box.y + place[1] * box.height }] : [],
    });
  for (const [i, place] of BLOB.entries()) await touch(i === 0 ? "touchStart" : "touchMove", place);
  await touch("touchEnd");
  await expect.poll(() => linesIn(page).coasts[0]?.length).toBe(2 * BLOB.length);
  expect(await page.evaluate(() => scrollY)).toBe(0);
  await page.close();
});

test("ridges, undo and clear change the link, and escape ends drawing", async ({ page }) => {
  await openTool(page);
  await draw(page, BLOB);
  await expect.poll(() => linesIn(page).coasts.length).toBe(1);
  await page.getByRole("button", { name: "Ridge" }).click();
  await draw(page, [
    [0.4, 0.45],
    [0.6, 0.55],
  ]);
  await expect.poll(() => linesIn(page).ridges.length).toBe(1);
  await expectPictureOfAddress(page);
  await page.keyboard.press("Control+z");
  await expect.poll(() => linesIn(page).ridges.length).toBe(0);
  await page.getByRole("button", { name: "Clear" }).click();
  await expectAddress(page, "outline", null);
  await page.getByRole("button", { name: "Undo line" }).click();
  await expect.poll(() => linesIn(page).coasts.length).toBe(1);
  await page.getByRole("button", { name: "Undo line" }).click();
  await expectAddress(page, "outline", null);
  await expect(page.getByRole("button", { name: "Undo line" })).toBeDisabled();
  await page.keyboard.press("Escape");
  await expect(page.getByRole("group", { name: "Drawing a land" })).toBeHidden();
  await expect(page.getByRole("button", { name: "Draw", exact: true })).toBeFocused();
});

test("a river is drawn by hand, a touch is a mouth, and both go with undo @core", async ({ page }) => {
  await openTool(page);
  await draw(page, BLOB);
  await expect.poll(() => linesIn(page).coasts.length).toBe(1);
  const river = page.getByRole("button", { name: "River" });
  await river.focus();
  await page.keyboard.press("Enter");
  await expect(river).toHaveAttribute("aria-pressed", "true");
  await expect(page.locator("#drawing-status")).toContainText("Draw a river from its mouth");
  await draw(page, [
    [0.95, 0.5],
    [0.7, 0.45],
    [0.5, 0.6],
  ]);
  await expect.poll(() => linesIn(page).rivers.length).toBe(1);
  await expectPictureOfAddress(page);
  const one = await shown(page);
  await draw(page, [[0.3, 0.3]]);
  await expect.poll(() => linesIn(page).rivers[1]?.length).toBe(2);
  await expect(page.locator("#drawing-status")).toContainText("1 coast and 2 rivers, ");
  await expect(page.locator("#sketch path.river")).toHaveCount(2);
  await expectPictureOfAddress(page);
  expect((await shown(page)).sha256).not.toBe(one.sha256);
  await page.keyboard.press("Control+z");
  await expect.poll(() => linesIn(page).rivers.length).toBe(1);
  await expectPictureOfAddress(page);
  expect(await shown(page)).toEqual(one);
});

test("rivers drawn without a coast start at the edges of the map", async ({ page }) => {
  await openTool(page);
  await page.getByRole("button", { name: "River" }).click();
  await draw(page, [[0.98, 0.5]]);
  await expectAddress(page, "land", "drawn");
  await expect(page.locator("#drawing-status")).toContainText("1 river, 1 point.");
  await expectPictureOfAddress(page);
  await expect(page.locator("#notices")).toBeHidden();
});

test("Clear and Undo by keyboard keep the focus among the tools", async ({ page }) => {
  await openTool(page);
  await draw(page, BLOB);
  await expectAddress(page, "land", "drawn");
  const clear = page.getByRole("button", { name: "Clear" });
  await clear.focus();
  await page.keyboard.press("Enter");
  await expect(clear).toBeDisabled();
  await expect(page.getByRole("button", { name: "Coast" })).toBeFocused();
  const undo = page.getByRole("button", { name: "Undo line" });
  await undo.focus();
  await page.keyboard.press("Enter");
  await expect(undo).toBeFocused();
  await page.keyboard.press("Enter");
  await expect(undo).toBeDisabled();
  await expect(page.getByRole("button", { name: "Coast" })).toBeFocused();
});

test("what is too small for a land is said, and stays to be drawn on", async ({ page }) => {
  await openTool(page);
  await draw(page, [
    [0.5, 0.5],
    [0.52, 0.5],
    [0.51, 0.53],
  ]);
  await expect(page.locator("#drawing-status")).toContainText("too small");
  await expect(page.locator("#sketch path")).toHaveCount(1);
  await draw(page, BLOB);
  await expect(page.locator("#drawing-status")).toContainText("2 coasts, ");
  await expectAddress(page, "land", "drawn");
});

test("a drawn land of a link is there to be drawn on", async ({ page }) => {
  const { outline } = engine.traceImage(
    new Uint8Array(64 * 64 * 4).map((_, i) => ((i >> 2) % 64 < 30 ? 255 : 0)),
    64,
    64,
  );
  await openTool(page, `${SMALL}&land=drawn&outline=${outline}`);
  await expect(page.locator("#sketch path")).toHaveCount(1);
  await draw(page, BLOB);
  await expect.poll(() => linesIn(page).coasts.length).toBe(2);
});

test("choosing a drawn land in the list opens the tool", async ({ page }) => {
  await openUnfolded(page, SMALL);
  await page.locator("#field-land").selectOption("drawn");
  await expect(page.getByRole("group", { name: "Drawing a land" })).toBeVisible();
});

test("a picture is traced: its coast, its ridge and its shape are the map's, and what is kept is shown @core", async ({
  page,
}) => {
  await openFinished(page, SMALL);
  await choose(page, ISLAND);
  await expectAddress(page, "aspect", "2");
  expect(linesIn(page).coasts).toHaveLength(1);
  expect(linesIn(page).ridges).toHaveLength(1);
  await expect(page.locator("#drawing-status")).toContainText("Kept of the picture: 1 coast and 1 ridge, ");
  await expect(page.locator("#sketch path")).toHaveCount(2);
  await expectPictureOfAddress(page);
});

test("what a picture has too much of is said, and a long one is not squeezed", async ({ page }) => {
  // Four rows of twenty islands on a sea five times as long as wide.
  const islands = png(500, 100, (x, y) => (x % 25 < 15 && y % 25 < 15 ? [255, 255, 255] : [0, 0, 0]));
  await openFinished(page, SMALL);
  await choose(page, islands);
  await expectAddress(page, "aspect", "4");
  await expect(page.locator("#drawing-status")).toContainText(
    /Kept of the picture: \d+ of 80 coasts, \d+ points\..* continue beyond/,
  );
});

test("a picture of heights is told", async ({ page }) => {
  const rise = (at: number, side: number): number => Math.min(at, side - 1 - at);
  const heights = png(200, 100, (x, y) => {
    const grey = Math.min(255, 6 * Math.min(rise(x, 200), rise(y, 100)));
    return [grey, grey, grey];
  });
  await openFinished(page, SMALL);
  await choose(page, heights);
  await expect(page.locator("#drawing-status")).toContainText(/Kept of the picture: .* It looks like a heightmap, /);
  await choose(page, ISLAND);
  await expect(page.locator("#drawing-status")).toContainText(/Kept of the picture: 1 coast and 1 ridge, [^.]*\.$/);
});

test("a picture can be dropped onto the map, and pasted", async ({ page }) => {
  for (const type of ["drop", "paste"]) {
    await openFinished(page, SMALL);
    await page.locator("#frame").evaluate(
      (frame, { type, bytes }) => {
        const data = new DataTransfer();
        data.items.add(new File([new Uint8Array(bytes)], "land.png", { type: "image/png" }));
        const options = { bubbles: true, cancelable: true };
        const event =
          type === "drop"
            ? new DragEvent(type, { ...options, dataTransfer: data })
            : new ClipboardEvent(type, { ...options, clipboardData: data });
        frame.dispatchEvent(event);
      },
      { type, bytes: [...ISLAND] },
    );
    await expectAddress(page, "land", "drawn");
  }
});

test("a picture that cannot be a land is refused with a message, and the map stays @core", async ({ page }) => {
  await openFinished(page, SMALL);
  const before = await shown(page);
  for (const [name, buffer, message] of [
    ["all black", png(40, 40, () => [0, 0, 0]), "all water"],
    ["all white", png(40, 40, () => [255, 255, 255]), "all land"],
    ["tiny", png(4, 4, () => [255, 255, 255]), "too small: 4 x 4"],
    ["no picture", Buffer.from("not a picture"), "cannot read this file as a picture"],
    ["too large", tooLarge(), "5000 × 20 pixels"],
  ] as const)
    await test.step(name, async () => {
      await choose(page, buffer);
      await expect(page.locator("#notices")).toContainText(message);
      expect(await shown(page)).toEqual(before);
      await page.getByRole("button", { name: "Dismiss" }).click();
      await expect(page.locator("#notices")).toBeHidden();
    });
});

test("opening the tool leaves a linked land as it is", async ({ page }) => {
  await openTool(page);
  await draw(page, BLOB);
  await expectAddress(page, "land", "drawn");
  const linked = page.url();
  await page.goto("about:blank");
  await openFinished(page, new URL(linked).search.slice(1));
  await page.getByRole("button", { name: "Draw", exact: true }).click();
  await expect(page.locator("#sketch path")).not.toHaveCount(0);
  for (let i = 0; i < 10; i++) await page.evaluate(() => new Promise((done) => requestAnimationFrame(done)));
  expect(page.url()).toBe(linked);
});

/** The head of a PNG of too many pixels: its size alone is looked at. */
function tooLarge(): Buffer {
  const picture = png(20, 20, () => [0, 0, 0]);
  picture.writeUInt32BE(5000, 16);
  return picture;
}

for (const width of [1440, 390]) {
  test(`axe finds nothing while drawing, ${width} wide, and nothing scrolls sideways`, async ({ page }) => {
    await page.setViewportSize({ width, height: 900 });
    await openTool(page);
    await draw(page, BLOB);
    await expectAddress(page, "land", "drawn");
    expect(await violations(page)).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
    for (const button of await page.locator("#tools button").all()) {
      await expect(button).toBeInViewport({ ratio: 1 });
      expect((await button.boundingBox())?.height).toBeGreaterThanOrEqual(24);
    }
  });
}
