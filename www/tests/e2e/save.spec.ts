import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { expect, type Page, test } from "@playwright/test";
import { type DecodedPng, decode } from "fast-png";
import { pictureOf as fileOf } from "../../src/files/picture.ts";
import { pictureOf } from "../core.ts";
import { engine, memory } from "../whole.ts";
import { complaints, openFinished } from "./riverpage.ts";
import {
  bytesOf,
  choose,
  chooseOwnSize,
  chooseSize,
  download,
  type Saved,
  said,
  saveButton,
  saved,
  saving,
} from "./saving.ts";

const LINK = "seed=puriri&attractors=300&land=island&style=atlas&labels=none";
const NAMED = LINK.replace("labels=none", "labels=some");

/** RGBA, whatever a picture has. */
function pixelsOf({ data, channels, width, height }: DecodedPng): Uint8Array {
  if (channels === 4) return Uint8Array.from(data);
  const pixels = new Uint8Array(width * height * 4).fill(255);
  for (let i = 0; i < width * height; i++) pixels.set(data.subarray(i * 3, i * 3 + 3), i * 4);
  return pixels;
}

function sha256(bytes: Uint8Array): string {
  return createHash("sha256").update(bytes).digest("hex");
}

function share(pixels: Uint8Array, is: (pixel: Uint8Array) => boolean): number {
  let count = 0;
  for (let i = 0; i < pixels.length; i += 4) if (is(pixels.subarray(i, i + 4))) count++;
  return (4 * count) / pixels.length;
}

test("the picture for screens is the command line's of that size, to the bit, and carries its link @core", async ({
  page,
}) => {
  await openFinished(page, NAMED);
  const { name, bytes } = await download(page, "Picture");
  expect(name).toBe("puriri-atlas-2000.png");
  const picture = decode(bytes);
  expect([picture.width, picture.height, picture.channels]).toEqual([2000, 1250, 3]);
  expect(picture.text).toEqual({ riverseed: new engine.River(NAMED).fileLink });
  expect(sha256(pixelsOf(picture))).toBe(pictureOf(NAMED, 2000, 1250).sha256);
});

test("a picture of one's own size is the one that a native program painted", async ({ page }) => {
  const golden = decode(readFileSync(new URL("../../../tests/golden/tower.png", import.meta.url)));
  await openFinished(page, golden.text["riverseed"]);
  await choose(page, "Picture");
  await chooseOwnSize(page, 480);
  const { name, bytes } = await saved(page);
  expect(name).toBe("tower-ink-480.png");
  const picture = decode(bytes);
  expect([picture.width, picture.height]).toEqual([240, 480]);
  expect(Buffer.from(picture.data as Uint8Array).equals(Buffer.from(golden.data as Uint8Array))).toBe(true);
});

for (const [size, width, height] of [
  ["a4", 3508, 2480],
  ["a3", 4961, 3508],
] as const) {
  test(`a picture for paper has its shape and says its dots per inch: ${size}`, async ({ page }) => {
    await openFinished(page, LINK.replace("atlas", "ink"));
    await choose(page, "Picture");
    await chooseSize(page, size);
    const { name, bytes } = await saved(page);
    expect(name).toBe(`puriri-ink-${size}.png`);
    expect([bytes.readUInt32BE(16), bytes.readUInt32BE(20)]).toEqual([width, height]);
    const density = bytes.indexOf("pHYs") + 4;
    expect([0, 4].map((at) => bytes.readUInt32BE(density + at))).toEqual([11_811, 11_811]);
    expect(bytes[density + 8]).toBe(1);
  });
}

test("without its ground a map has no sea, and its land is as it was", async ({ page }) => {
  await openFinished(page, NAMED);
  await choose(page, "Picture");
  await chooseOwnSize(page, 500);
  const whole = pixelsOf(decode((await saved(page)).bytes));
  await saving(page).getByRole("radio", { name: "Transparent" }).check();
  const picture = decode((await saved(page)).bytes);
  expect(picture.channels).toBe(4);
  const cut = pixelsOf(picture);
  expect([...cut.subarray(0, 4)]).toEqual([0, 0, 0, 0]);
  expect(share(cut, (pixel) => pixel[3] === 0)).toBeGreaterThan(0.2);
  expect(share(cut, (pixel) => pixel[3] === 255)).toBeGreaterThan(0.2);
  let most = 0;
  for (const [i, value] of cut.entries())
    if (cut[i | 3] === 255) most = Math.max(most, Math.abs(value - (whole[i] ?? 0)));
  expect(most).toBeLessThanOrEqual(2);
});

test("without names a picture and a drawing have none, and all else is the same", async ({ page }) => {
  await openFinished(page, NAMED);
  await choose(page, "Picture");
  await chooseOwnSize(page, 500);
  const names = saving(page).getByRole("checkbox", { name: "With names" });
  await expect(names).toBeChecked();
  await names.uncheck();
  const bare = decode((await saved(page)).bytes);
  const { sha256: expected } = pictureOf(LINK, bare.width, bare.height);
  expect(sha256(pixelsOf(bare))).toBe(expected);
  await choose(page, "Drawing");
  expect((await saved(page)).bytes.toString("utf8")).not.toContain('id="labels"');
  await names.check();
  expect((await saved(page)).bytes.toString("utf8")).toContain('id="labels"');
});

test("a map that shows no names is said to have none to leave out", async ({ page }) => {
  await openFinished(page, LINK);
  await choose(page, "Picture");
  await expect(saving(page).getByRole("checkbox", { name: "With names" })).toBeDisabled();
  await expect(saving(page)).toContainText("This map shows none");
});

/** Saves what a button saves. */
async function savedBy(page: Page, button: string): Promise<Saved> {
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name: button }).click(),
  ]);
  return { name: download.suggestedFilename(), bytes: await bytesOf(download) };
}

test("a card is a picture of 1200 × 630 with the map's title, from the dialog and from Share @core", async ({
  page,
}) => {
  await openFinished(page, LINK);
  const card = await download(page, "Card");
  expect(card.name).toBe("puriri-atlas-card.png");
  const picture = decode(card.bytes);
  expect([picture.width, picture.height]).toEqual([1200, 630]);
  const course = { tell: () => {}, pause: () => Promise.resolve() };
  const made = await fileOf({ kind: "card", link: engine.readLink(LINK).link }, { engine, memory }, course);
  expect(sha256(pixelsOf(picture))).toBe(sha256(pixelsOf(decode(new Uint8Array(await made.arrayBuffer())))));
  await page.getByRole("button", { name: "Share", exact: true }).click();
  await page.getByRole("radio", { name: "Blog" }).check();
  await page.getByText("My blog allows no scripts").click();
  expect((await savedBy(page, "Save card")).bytes.equals(card.bytes)).toBe(true);
});

/** What a browser shows of a video: its length and size, and how much its pictures differ at some times from the last. */
function played(page: Page, { name, bytes }: Saved): Promise<{ seconds: number; size: number[]; apart: number[] }> {
  return page.evaluate(
    async ([base64, type]) => {
      const video = document.createElement("video");
      video.muted = true;
      document.body.append(video);
      video.src = URL.createObjectURL(new Blob([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], { type }));
      await new Promise((done, failed) => {
        video.onloadeddata = done;
        video.onerror = () => failed(new Error(video.error?.message));
      });
      const context = new OffscreenCanvas(120, 75).getContext("2d", { willReadFrequently: true });
      if (!context) throw new Error("no context");
      const pictures: Uint8ClampedArray[] = [];
      for (const share of [0.05, 0.3, 0.6, 0.9, 0.99]) {
        // Once a place is found, its picture may still be on its way.
        const shown = new Promise((done) => video.requestVideoFrameCallback(done));
        video.currentTime = video.duration * share;
        await shown;
        context.drawImage(video, 0, 0, 120, 75);
        pictures.push(context.getImageData(0, 0, 120, 75).data);
      }
      const last = pictures.pop() ?? new Uint8ClampedArray();
      const apart = pictures.map((one) => one.reduce((sum, value, i) => sum + Math.abs(value - (last[i] ?? 0)), 0));
      await video.play();
      return { seconds: video.duration, size: [video.videoWidth, video.videoHeight], apart };
    },
    [bytes.toString("base64"), `video/${name.split(".").pop()}`] as const,
  );
}

test("an animation is a video of the growth that plays, six seconds long @core", async ({ page }) => {
  const said = complaints(page);
  await openFinished(page, `seed=puriri&attractors=800&aspect=1.5&style=atlas&land=island`);
  const video = await download(page, "Animation");
  expect(video.name).toMatch(/^puriri-atlas\.(mp4|webm)$/);
  await page.goto("about:blank");
  const { seconds, size, apart } = await played(page, video);
  expect(seconds).toBeGreaterThan(5.5);
  expect(seconds).toBeLessThan(6.2);
  expect(size).toEqual([1200, 800]);
  // It comes nearer to the finished map, which stays for the last second.
  const [first = 0, , third = 0, held = 0] = apart;
  expect(first).toBeGreaterThan(third);
  expect(held).toBeLessThan(third / 10);
  expect(said).toEqual([]);
});

test("an animation can be cancelled", async ({ page }) => {
  await openFinished(page, LINK);
  await choose(page, "Animation");
  await saveButton(page).click();
  await expect(saving(page).getByRole("progressbar")).toHaveAttribute("value", /0\.\d/);
  await saving(page).getByRole("button", { name: "Cancel" }).click();
  await expect(said(page)).toContainText("was cancelled: nothing is saved.");
  await expect.poll(() => page.workers().length).toBe(1);
});

test("a browser that encodes no video says so, and offers all else", async ({ page }) => {
  await page.addInitScript(() => {
    localStorage.setItem("riverseed-save", JSON.stringify({ kind: "animation" }));
    Reflect.deleteProperty(window, "VideoEncoder");
  });
  await openFinished(page, LINK);
  await page.getByRole("button", { name: "Save", exact: true }).click();
  const animation = saving(page).getByRole("radio", { name: /^Animation/ });
  await expect(animation).toBeDisabled();
  await expect(animation).toHaveAccessibleName(/does not let this page encode video/);
  await expect(saving(page).getByRole("radio", { name: /^Picture/ })).toBeChecked();
});

test("a file in the making can be cancelled: nothing is saved, and the next one is", async ({ page }) => {
  const files: string[] = [];
  page.on("download", (download) => files.push(download.suggestedFilename()));
  await openFinished(page, LINK);
  await choose(page, "Picture");
  await chooseSize(page, "poster");
  await saveButton(page).click();
  const progress = saving(page).getByRole("progressbar");
  await expect(progress).toHaveAttribute("value", /0\.\d/);
  const cancel = saving(page).getByRole("button", { name: "Cancel" });
  await expect(cancel).toBeFocused();
  await cancel.click();
  await expect(said(page)).toHaveText("puriri-atlas-8192.png was cancelled: nothing is saved.");
  await expect(progress).toBeHidden();
  await expect(saveButton(page)).toBeFocused();
  // The worker is gone, and only that of the rivers is left.
  await expect.poll(() => page.workers().length).toBe(1);
  await chooseOwnSize(page, 300);
  await saved(page);
  expect(files).toEqual(["puriri-atlas-300.png"]);
});

test("two clicks make one file", async ({ page }) => {
  const files: string[] = [];
  page.on("download", (download) => files.push(download.suggestedFilename()));
  await openFinished(page, LINK);
  await choose(page, "Picture");
  await chooseOwnSize(page, 400);
  await saveButton(page).evaluate((button: HTMLButtonElement) => {
    button.click();
    button.click();
    button.form?.requestSubmit();
  });
  await expect(said(page)).toHaveText("puriri-atlas-400.png is in your downloads.");
  await choose(page, "Network");
  await saved(page);
  expect(files).toEqual(["puriri-atlas-400.png", "puriri.json"]);
});

test("while a file is made the dialog may be closed; what becomes of it is said beside the buttons", async ({
  page,
}) => {
  await openFinished(page, LINK);
  await choose(page, "Picture");
  await chooseSize(page, "a4");
  const coming = page.waitForEvent("download");
  await saveButton(page).click();
  await expect(saving(page).getByRole("progressbar")).toBeVisible();
  await page.keyboard.press("Escape");
  expect((await coming).suggestedFilename()).toBe("puriri-atlas-a4.png");
  await expect(page.locator("#shared")).toHaveText("puriri-atlas-a4.png is in your downloads.");
});

test("what is no size is refused in words, with the range", async ({ page }) => {
  await openFinished(page, LINK);
  await choose(page, "Picture");
  for (const [typed, shown] of [
    ["9000", "9000"],
    ["255", "255"],
    ["", "nothing"],
    ["300.5", "300.5"],
  ] as const) {
    await chooseOwnSize(page, typed);
    await saveButton(page).click();
    await expect(said(page)).toHaveText(`Longer side: ${shown} is not a whole number from 256 to 8192 pixels.`);
    await expect(saving(page).getByRole("spinbutton")).toBeFocused();
  }
});

test("what was chosen is chosen the next time, and a page that may remember nothing works the same", async ({
  page,
}) => {
  await openFinished(page, LINK);
  await choose(page, "Picture");
  await chooseOwnSize(page, 320);
  await saving(page).getByRole("radio", { name: "Transparent" }).check();
  await openFinished(page, LINK);
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await expect(saving(page).getByRole("spinbutton")).toHaveValue("320");
  expect(decode((await saved(page)).bytes).channels).toBe(4);
  await page.addInitScript(() => {
    Object.defineProperty(window, "localStorage", {
      get: () => {
        throw new DOMException("denied", "SecurityError");
      },
    });
  });
  await openFinished(page, LINK);
  expect((await download(page, "Picture")).name).toBe("puriri-atlas-2000.png");
});

test("where workers are refused, the page makes the same file, and can be told to stop", async ({ page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(window, "Worker", {
      value: class {
        constructor() {
          throw new DOMException("refused", "SecurityError");
        }
      },
    });
  });
  await openFinished(page, NAMED);
  await choose(page, "Picture");
  await chooseSize(page, "poster");
  await saveButton(page).click();
  await expect(saving(page).getByRole("progressbar")).toHaveAttribute("value", /0\.\d/);
  await saving(page).getByRole("button", { name: "Cancel" }).click();
  await expect(said(page)).toContainText("was cancelled");
  await chooseOwnSize(page, 500);
  const picture = decode((await saved(page)).bytes);
  expect(sha256(pixelsOf(picture))).toBe(pictureOf(NAMED, picture.width, picture.height).sha256);
});

test("where a worker does not begin, the page makes the file", async ({ page }) => {
  await page.route(/picture-worker-/, (route) => route.fulfill({ status: 404, body: "not here" }));
  await openFinished(page, LINK);
  await choose(page, "Picture");
  await chooseOwnSize(page, 300);
  expect(decode((await saved(page)).bytes).width).toBe(300);
});

test("a file that cannot be made is told of in words, and the map stays", async ({ page }) => {
  await openFinished(page, NAMED);
  await page.route(/riverseed_engine_bg[^/]*\.wasm$/, (route) => route.abort());
  await choose(page, "Picture");
  await saveButton(page).click();
  await expect(said(page)).toContainText(/puriri-atlas-2000\.png could not be made: .*Failed to fetch/);
  await expect(saveButton(page)).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "finished");
});

test("the dialog is used by keys, and gives the focus back @core", async ({ page }) => {
  await openFinished(page, LINK);
  const button = page.getByRole("button", { name: "Save", exact: true });
  await button.focus();
  await page.keyboard.press("Enter");
  await expect(saving(page)).toBeVisible();
  await saving(page)
    .getByRole("radio", { name: /^Picture/ })
    .focus();
  for (let i = 0; i < 3; i++) await page.keyboard.press("ArrowDown");
  await expect(saving(page).getByRole("radio", { name: /^Network/ })).toBeChecked();
  const [download] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("Enter")]);
  expect(download.suggestedFilename()).toBe("puriri.json");
  await page.keyboard.press("Escape");
  await expect(saving(page)).toBeHidden();
  await expect(button).toBeFocused();
});

for (const [width, height] of [
  [1440, 900],
  [390, 844],
  [320, 568],
] as const) {
  test(`everything in the dialog can be reached and nothing is cut off sideways, ${width} wide`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    await openFinished(page, LINK.replace("puriri", "W".repeat(64)));
    await choose(page, "Picture");
    await chooseSize(page, "own");
    const overflow = await saving(page).evaluate((dialog) => dialog.scrollWidth - dialog.clientWidth);
    expect(overflow).toBeLessThanOrEqual(0);
    const name = await saved(page);
    expect(name.name).toBe(`${"w".repeat(40)}-atlas-3000.png`);
    expect(await saving(page).evaluate((dialog) => dialog.scrollWidth - dialog.clientWidth)).toBeLessThanOrEqual(0);
    for (const control of await saving(page).locator("input:visible, button:visible, select:visible").all()) {
      await control.evaluate((element) => element.scrollIntoView({ block: "center" }));
      await expect(control).toBeInViewport({ ratio: 1 });
    }
  });
}
