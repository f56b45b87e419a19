import { expect, type Page, test } from "@playwright/test";
import { decode } from "fast-png";
import { address, complaints, openFinished } from "./riverpage.ts";

const LINK = "seed=Ardenmoor&attractors=300&land=island&style=ink&labels=few";
const LINE = "Ardenmoor, a country grown from its name. What is yours like?";

test.use({ permissions: ["clipboard-read", "clipboard-write"] });

const sendButton = (page: Page) => page.getByRole("button", { name: "Send", exact: true });
const sending = (page: Page) => page.getByRole("dialog", { name: "Send this country" });
const picture = (page: Page) => sending(page).getByRole("img", { name: "The picture: Ardenmoor" });

/** The answers of a system's share sheet: it takes what it is given, or fails by the name of an error, one after the other. */
type Answer = "take" | "AbortError" | "NotAllowedError" | "DataError";

/** Gives the page a share sheet that takes files, or one that does not. Call before `goto`. */
async function withShareSheet(page: Page, answers: readonly Answer[], takesFiles = true): Promise<void> {
  await page.addInitScript(
    ([answers, takesFiles]) => {
      const left = [...answers];
      const given: unknown[] = [];
      Object.assign(globalThis, { given });
      Object.assign(navigator, {
        canShare: ({ files }: ShareData) => files === undefined || takesFiles,
        share: async ({ files = [], text, url }: ShareData) => {
          const [file] = files;
          const bytes = [...new Uint8Array((await file?.arrayBuffer()) ?? new ArrayBuffer(0))];
          given.push({ count: files.length, name: file?.name, type: file?.type, text, url, bytes });
          const answer = left.shift() ?? "take";
          if (answer !== "take") throw new DOMException("as the test says", answer);
        },
      });
    },
    [answers, takesFiles] as const,
  );
}

/** No share sheet, as on most desks; some browsers for tests have one. */
async function withoutShareSheet(page: Page): Promise<void> {
  await page.addInitScript(() => {
    for (const name of ["share", "canShare"]) Object.defineProperty(navigator, name, { value: undefined });
  });
}

interface Given {
  count: number;
  name: string;
  type: string;
  text: string;
  url: string;
  bytes: number[];
}

const given = (page: Page): Promise<Given[]> => page.evaluate(() => Reflect.get(globalThis, "given"));

/** Opens the map and waits until its name is known. */
async function open(page: Page, link = LINK): Promise<void> {
  await openFinished(page, link);
  await expect(page).toHaveTitle("Ardenmoor · Riverseed");
}

test("one press hands the share sheet the picture, the line and the link, and nothing is in the way after @core", async ({
  page,
}) => {
  const said = complaints(page);
  await withShareSheet(page, ["take"]);
  await open(page);
  await sendButton(page).click();
  await expect.poll(async () => (await given(page)).length).toBe(1);
  const [{ bytes, ...rest } = { bytes: [] }] = await given(page);
  expect(rest).toEqual({
    count: 1,
    name: "ardenmoor-ink-portrait.png",
    type: "image/png",
    text: LINE,
    url: `${new URL(page.url()).origin}/?${address(page)}`,
  });
  const { width, height } = decode(Uint8Array.from(bytes));
  expect([width, height]).toEqual([1200, 1500]);
  await expect(sending(page)).toBeHidden();
  await expect(page.locator("#shared")).toHaveText("");
  expect(said).toEqual([]);
});

test("who closes the share sheet is told nothing, and may send again", async ({ page }) => {
  await withShareSheet(page, ["AbortError", "take"]);
  await open(page);
  await sendButton(page).click();
  await expect.poll(async () => (await given(page)).length).toBe(1);
  await expect(page.locator("#shared")).toHaveText("");
  await expect(sending(page)).toBeHidden();
  await sendButton(page).click();
  await expect.poll(async () => (await given(page)).length).toBe(2);
});

test("where the picture took longer than a press counts, it is shown with a button that sends it", async ({ page }) => {
  await withShareSheet(page, ["NotAllowedError", "AbortError", "take"]);
  await open(page);
  await sendButton(page).click();
  await expect(picture(page)).toBeVisible();
  const now = sending(page).getByRole("button", { name: "Send now" });
  await expect(now).toBeFocused();
  await now.click();
  await expect.poll(async () => (await given(page)).length).toBe(2);
  await expect(picture(page)).toBeVisible();
  await now.click();
  await expect(sending(page)).toBeHidden();
  const all = await given(page);
  expect(all).toHaveLength(3);
  for (const one of all) expect(one).toEqual(all[0]);
});

test("a share sheet that refuses the picture leaves what needs none", async ({ page }) => {
  await withShareSheet(page, ["DataError"]);
  await open(page);
  await sendButton(page).click();
  await expect(picture(page)).toBeVisible();
  await expect(sending(page).getByRole("status")).toContainText("did not take the picture");
  await expect(sending(page).getByRole("button", { name: "Send now" })).toBeHidden();
  await sending(page).getByRole("button", { name: "Copy link" }).click();
  await expect(sending(page).getByRole("status")).toHaveText("Link copied.");
});

for (const [how, prepare] of [
  ["no share sheet", withoutShareSheet],
  ["a share sheet that takes no files", (page: Page) => withShareSheet(page, [], false)],
] as const) {
  test(`with ${how} the dialog shows the picture, and copies and saves it`, async ({ page }) => {
    await prepare(page);
    await open(page);
    await sendButton(page).click();
    await expect(sending(page)).toContainText(LINE);
    await expect(picture(page)).toBeVisible();
    expect(await picture(page).evaluate((img: HTMLImageElement) => [img.naturalWidth, img.naturalHeight])).toEqual([
      1200, 1500,
    ]);
    await expect(sending(page).getByRole("button", { name: "Send now" })).toBeHidden();
    await sending(page).getByRole("button", { name: "Copy link" }).click();
    await expect(sending(page).getByRole("status")).toHaveText("Link copied.");
    expect(new URL(await page.evaluate(() => navigator.clipboard.readText())).search).toBe(`?${address(page)}`);
    await sending(page).getByRole("button", { name: "Copy picture" }).click();
    await expect(sending(page).getByRole("status")).toHaveText("Picture copied.");
    const types = await page.evaluate(async () => (await navigator.clipboard.read()).flatMap(({ types }) => types));
    expect(types).toContain("image/png");
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      sending(page).getByRole("button", { name: "Save picture" }).click(),
    ]);
    expect(download.suggestedFilename()).toBe("ardenmoor-ink-portrait.png");
    await page.keyboard.press("Escape");
    await expect(sending(page)).toBeHidden();
    await expect(sendButton(page)).toBeFocused();
  });
}

test("a browser that copies no pictures is not asked to", async ({ page }) => {
  await withoutShareSheet(page);
  await page.addInitScript(() => Reflect.deleteProperty(globalThis, "ClipboardItem"));
  await open(page);
  await sendButton(page).click();
  await expect(picture(page)).toBeVisible();
  await expect(sending(page).getByRole("button", { name: "Copy picture" })).toBeHidden();
});

test("a picture that cannot be made is said to be so, and the link can still be copied", async ({ page }) => {
  await withoutShareSheet(page);
  await open(page);
  await page.route("**/*.wasm", (route) => route.abort());
  await sendButton(page).click();
  await expect(sending(page).getByRole("status")).toContainText("The picture could not be made");
  await sending(page).getByRole("button", { name: "Copy link" }).click();
  await expect(sending(page).getByRole("status")).toHaveText("Link copied.");
});

test("many presses make one picture", async ({ page }) => {
  await withShareSheet(page, []);
  await open(page);
  await sendButton(page).evaluate((button) => {
    for (let i = 0; i < 20; i++) (button as HTMLButtonElement).click();
  });
  await expect.poll(async () => (await given(page)).length).toBe(1);
  await expect(page.locator("#shared")).toHaveText("");
  expect(await given(page)).toHaveLength(1);
});

for (const [width, height] of [
  [390, 844],
  [320, 568],
] as const) {
  test(`all of the dialog can be reached, ${width} wide`, async ({ page }) => {
    await withoutShareSheet(page);
    await page.setViewportSize({ width, height });
    await open(page);
    await expect(sendButton(page)).toBeInViewport({ ratio: 1 });
    await sendButton(page).click();
    await expect(picture(page)).toBeVisible();
    expect(await sending(page).evaluate((dialog) => dialog.scrollWidth - dialog.clientWidth)).toBeLessThanOrEqual(0);
    for (const button of await sending(page).getByRole("button").all()) {
      await button.evaluate((element) => element.scrollIntoView({ block: "center" }));
      await expect(button).toBeInViewport({ ratio: 1 });
    }
  });
}

test("page, files and picture say the country's own title once it is known", async ({ page }) => {
  await withShareSheet(page, []);
  await openFinished(page, "seed=tay2&attractors=300&land=island&style=ink&labels=few&names=t.Ardenmoor");
  await expect(page.locator("#title")).toHaveText("Ardenmoor");
  await expect(page).toHaveTitle("Ardenmoor · Riverseed");
  await sendButton(page).click();
  await expect.poll(async () => (await given(page)).length).toBe(1);
  const [{ name, text } = { name: "", text: "" }] = await given(page);
  expect({ name, text }).toEqual({
    name: "ardenmoor-ink-portrait.png",
    text: "Ardenmoor, a country grown from “tay2”. What is yours like?",
  });
});
