import { expect, type Locator, type Page, test } from "@playwright/test";
import { engine } from "../whole.ts";
import { violations } from "./axe.ts";
import {
  address,
  complaints,
  expectAddress,
  finished,
  openFinished,
  openFold,
  openPanel,
  openSettings,
  openWithPanel,
  shown,
} from "./riverpage.ts";
import { download } from "./saving.ts";

const LINK = "country=usual&seed=kauri&land=island&growth=drainage&attractors=1500&meander-rounds=5&style=ink";

/** The greatest names of a link's map, mark and name in turn. */
function greatest(link: string): string[][] {
  const river = new engine.River(link);
  while (river.advance(1000));
  return river.greatest(12).map(({ mark, name }) => [mark, name]);
}

async function picture(page: Page): Promise<string> {
  return (await shown(page)).sha256;
}

test("a map that gets labels is told in words, too", async ({ page }) => {
  await openWithPanel(page, `${LINK}&labels=none`);
  const bare = await picture(page);
  await openSettings(page);
  await openFold(page, "Names");
  await page.getByLabel("Labels", { exact: true }).selectOption("some");
  await expect.poll(() => picture(page)).not.toBe(bare);
  const rivers = greatest(LINK).filter(([mark]) => /^\d/.test(mark ?? ""));
  await expect(page.locator("#canvas")).toHaveAttribute(
    "aria-label",
    new RegExp(`Its greatest rivers: ${rivers[0]?.[1]}, `),
  );
});

test("names on the map are listed, can be typed over, and are in the link @core", async ({ page }) => {
  await openWithPanel(page, `${LINK}&labels=some`);
  await page.getByRole("heading", { name: "Names" }).click();
  const fields = page.locator(".names input");
  const names = greatest(LINK);
  await expect
    .poll(() => fields.evaluateAll((all) => all.map((one) => (one as HTMLInputElement).value)))
    .toEqual(names.map(([, name]) => name));
  const before = await picture(page);
  await fields.first().fill("Silver_Water <b>");
  await fields.first().press("Enter");
  const mark = names[0]?.[0];
  await expect(page).toHaveURL(new RegExp(`names=${mark}\\.Silver\\+Water`));
  await expect(fields.first()).toHaveValue("Silver Water <b>");
  await expect.poll(() => picture(page)).not.toBe(before);
  // Escape takes back what is typed, not what is said.
  await fields.first().fill("Other");
  await fields.first().press("Escape");
  await expect(fields.first()).toHaveValue("Silver Water <b>");
  await page.getByRole("button", { name: "Reset Silver Water <b>" }).click();
  await expect(fields.first()).toHaveValue(names[0]?.[1] ?? "");
  await expect(page).not.toHaveURL(/names=/);
  await expect(fields.first()).toBeFocused();
});

// ---- named where it lies

const NAMED = `${LINK}&labels=some`;

const card = (page: Page): Locator => page.getByRole("dialog").and(page.locator(".river-card"));
const field = (page: Page): Locator => card(page).getByRole("textbox");

/** A place of a link's map that has a name, and a point of it in shares of the map's sides. */
function placeOf(link: string, letter: string): { mark: string; x: number; y: number } {
  const river = new engine.River(link);
  while (river.advance(1000));
  while (river.raiseRelief());
  const places = river.inspector()?.places() ?? [];
  const place = places.find(({ mark }) => mark.startsWith(letter) && mark !== "i0");
  const [x = 0, y = 0] = place?.line ?? [];
  return { mark: place?.mark ?? "", x, y };
}

/** Where a point of the map is on the page. */
async function onPage(page: Page, { x, y }: { x: number; y: number }): Promise<{ x: number; y: number }> {
  const box = await page.locator("#map-place").boundingBox();
  if (!box) throw new Error("the map has no place");
  return { x: box.x + x * box.width, y: box.y + y * box.height };
}

/** The source of the greatest river, on the page, and its mark. */
async function source(page: Page): Promise<{ x: number; y: number; mark: string }> {
  await page.locator("#frame").focus();
  await page.keyboard.press("n");
  await expect(page.locator(".river-card")).toBeVisible();
  const mark = (await page.locator("#frame").getAttribute("data-river")) ?? "";
  const box = await page.locator(".river-pointer .spot").boundingBox();
  await page.keyboard.press("Escape");
  await expect(page.locator(".river-card")).toBeHidden();
  if (!box) throw new Error("no river");
  return { x: box.x + box.width / 2, y: box.y + box.height / 2, mark };
}

/** The shortest way to another name: click, type, Enter. */
async function rename(page: Page, at: { x: number; y: number }, name: string): Promise<void> {
  await page.mouse.click(at.x, at.y);
  await expect(field(page)).toBeFocused();
  await page.keyboard.type(name);
  await page.keyboard.press("Enter");
  await expect(card(page)).toBeHidden();
}

test("a river that is clicked is named where it lies: on the map, in the list, in the link, and in files @core", async ({
  page,
}) => {
  const said = complaints(page);
  await openFinished(page, NAMED);
  const { mark, ...at } = await source(page);
  const before = await picture(page);
  await page.mouse.move(at.x, at.y);
  await expect(page.locator(".river-card")).toBeVisible();
  // A pointer only looks: there is nothing to press.
  await expect(card(page)).toHaveCount(0);
  await page.mouse.click(at.x, at.y);
  await expect(card(page)).toContainText("Name of this river");
  await expect(field(page)).toBeFocused();
  const madeUp = await field(page).inputValue();
  expect(madeUp).not.toBe("");
  await page.keyboard.type("Silverrun");
  await page.keyboard.press("Enter");
  await expect(card(page)).toBeHidden();
  await expectAddress(page, "names", `${mark}.Silverrun`);
  await expect.poll(() => picture(page)).not.toBe(before);
  await expect(page.locator("#frame")).toBeFocused();
  const file = await download(page, "Map data");
  expect(file.bytes.toString()).toContain('"Silverrun"');
  await openPanel(page);
  await page.getByRole("heading", { name: "Names" }).click();
  await expect(page.getByRole("textbox", { name: "The greatest river" })).toHaveValue("Silverrun");
  await page.getByRole("button", { name: "Close the panel" }).click();
  await finished(page);
  const again = await source(page);
  await page.mouse.click(again.x, again.y);
  await card(page).getByRole("button", { name: "Use the made-up name" }).click();
  await expectAddress(page, "names", null);
  await expect(card(page)).toBeHidden();
  await page.mouse.click(again.x, again.y);
  await expect(field(page)).toHaveValue(madeUp);
  await expect(card(page).getByRole("button", { name: "Use the made-up name" })).toBeHidden();
  expect(said).toEqual([]);
});

test("an island and the sea are named by a click on them, and a click elsewhere keeps what was typed @core", async ({
  page,
}) => {
  await openFinished(page, NAMED);
  const island = placeOf(NAMED, "i");
  // Any place at sea is the sea's.
  const sea = { x: 0.03, y: 0.5 };
  await rename(page, await onPage(page, island), "Mossholm");
  await expectAddress(page, "names", `${island.mark}.Mossholm`);
  await finished(page);
  // A click elsewhere keeps what was typed.
  const { x, y } = await onPage(page, sea);
  await expect.poll(() => page.locator("#canvas").evaluate((canvas) => canvas.style.transform)).toBe("");
  await page.mouse.click(x, y);
  await expect(card(page)).toContainText("Name of this sea");
  await page.keyboard.type("The Wide");
  const again = await onPage(page, island);
  await page.mouse.click(again.x, again.y);
  await expect.poll(() => address(page).get("names")).toContain("The Wide");
  await expect(field(page)).toHaveValue("Mossholm");
  await page.keyboard.press("Escape");
  await expect(card(page)).toBeHidden();
  await expect(page.locator("#frame")).toBeFocused();
});

test("the title is named by a click on its letters", async ({ page }) => {
  const link = `${NAMED}&cartouche=plain`;
  await openFinished(page, link);
  await expect.poll(() => page.locator("#canvas").evaluate((canvas) => canvas.style.transform)).toBe("");
  const { width, height, framing } = await shown(page);
  const river = new engine.River(link);
  river.resize(width, height);
  river.frame(new Float32Array(framing));
  while (river.advance(1000));
  while (river.paint());
  const title = river.labels().find(({ mark }) => mark === "t");
  const [x = 0, y = 0] = title?.line ?? [];
  await rename(page, await onPage(page, { x, y }), "Thessaly");
  await expectAddress(page, "names", "t.Thessaly");
});

test("of a name and a river at one place the other is a press away", async ({ page }) => {
  await openFinished(page, NAMED);
  const { mark, ...at } = await source(page);
  await page.mouse.click(at.x, at.y);
  await card(page)
    .getByRole("button", { name: /, the land$/ })
    .click();
  await expect(card(page)).toContainText("Name of this land");
  await expect(field(page)).toBeFocused();
  await card(page)
    .getByRole("button", { name: /, the river$/ })
    .first()
    .click();
  await expect(card(page)).toContainText("Name of this river");
  await expect(page.locator("#frame")).toHaveAttribute("data-river", mark);
  // A click beside everything closes it, and the next one means what it hits.
  await page.keyboard.press("Escape");
  await expect(card(page)).toBeHidden();
});

test("keys alone name a river, and Escape leaves it as it is @core", async ({ page }) => {
  await openFinished(page, NAMED);
  await page.locator("#frame").focus();
  await page.keyboard.press("n");
  await expect(page.locator(".river-card")).toBeVisible();
  const mark = await page.locator("#frame").getAttribute("data-river");
  await page.keyboard.press("Enter");
  await expect(field(page)).toBeFocused();
  await expect(field(page)).toHaveAccessibleName("Name of this river");
  await page.keyboard.type("Nothing");
  await page.keyboard.press("Escape");
  await expect(card(page)).toBeHidden();
  await expect(page.locator("#frame")).toBeFocused();
  expect(address(page).has("names")).toBe(false);
  await page.keyboard.press("n");
  await expect(page.locator(".river-card")).toBeVisible();
  await page.keyboard.press("Shift+N");
  await page.keyboard.press("Enter");
  await expect(field(page)).toBeFocused();
  await page.keyboard.type("Silverrun");
  await page.keyboard.press("Tab");
  await expect(card(page).getByRole("button", { name: "Save" })).toBeFocused();
  await page.keyboard.press("Enter");
  await expect.poll(() => address(page).get("names")).toContain(".Silverrun");
  await expect(page.locator("#frame")).toBeFocused();
  await expect(page.locator("#sheet > .unseen[role=status]").last()).toHaveText("Named: Silverrun.");
  expect(mark).toMatch(/^\d+$/);
});

test("on a phone two taps and a word name a river @core", async ({ browser }) => {
  const context = await browser.newContext({ hasTouch: true, isMobile: true, viewport: { width: 390, height: 844 } });
  const page = await context.newPage();
  await openFinished(page, `${NAMED}&aspect=0.7`);
  const { mark, ...at } = await source(page);
  await page.touchscreen.tap(at.x, at.y);
  await expect(page.locator(".river-name")).toHaveText(/\w/);
  // No keyboard comes up unasked.
  await expect(field(page)).toBeHidden();
  await card(page).getByRole("button", { name: "Rename" }).tap();
  await expect(field(page)).toBeFocused();
  await page.keyboard.type("Silverrun");
  await page.keyboard.press("Enter");
  await expectAddress(page, "names", `${mark}.Silverrun`);
  await expect(card(page)).toBeHidden();
  await context.close();
});

test("the dice let own names go, Back brings them back, and a slider keeps them @core", async ({ page }) => {
  await openWithPanel(page, `${NAMED}&names=t.Home`);
  await page.getByRole("button", { name: "Close the panel" }).click();
  await page
    .getByRole("button", { name: /random|dice|chance/i })
    .first()
    .click();
  await expectAddress(page, "names", null);
  await finished(page);
  expect(address(page).get("seed")).not.toBe("kauri");
  await page.goBack();
  await expectAddress(page, "names", "t.Home");
  expect(address(page).get("seed")).toBe("kauri");
  await finished(page);
  await page.locator("#land").selectOption("continent");
  await expectAddress(page, "names", null);
  await page.getByRole("button", { name: "Undo" }).click();
  await expectAddress(page, "names", "t.Home");
  await finished(page);
  await openPanel(page);
  const before = page.url();
  await page.locator("#panel input[type=range]:visible").first().press("ArrowRight");
  await expect.poll(() => page.url()).not.toBe(before);
  await finished(page);
  await expectAddress(page, "names", "t.Home");
});

test("a name that is too long, or one too many, is refused where it was typed", async ({ page }) => {
  const many = Array.from({ length: 40 }, (_, i) => `${900_000 + i}.x`).join("_");
  await openFinished(page, `${NAMED}&names=${many}`);
  const { x, y } = await source(page);
  await page.mouse.click(x, y);
  await expect(field(page)).toBeFocused();
  await page.keyboard.type("Silverrun");
  await page.keyboard.press("Enter");
  await expect(card(page).getByRole("alert")).toContainText("there are 41 names, at most 40 are allowed");
  await expect(field(page)).toHaveAttribute("aria-invalid", "true");
  await openFinished(page, NAMED);
  await page.mouse.click(x, y);
  await expect(field(page)).toBeFocused();
  await field(page).fill("x".repeat(41));
  await page.keyboard.press("Enter");
  await expect(card(page).getByRole("alert")).toContainText("41 characters, at most 40 are allowed");
  await expect(field(page)).toBeFocused();
  await page.keyboard.press("Escape");
  await expect(card(page)).toBeHidden();
});

test("a name in the list shows its place on the map while it is pointed at or has the focus", async ({ page }) => {
  await openWithPanel(page, NAMED);
  await page.getByRole("heading", { name: "Names" }).click();
  const spot = page.locator(".river-pointer .letters");
  const row = page.locator(".names li", { hasText: "island" }).first();
  await row.hover();
  await expect(spot).toHaveAttribute("d", /^M/);
  await expect(page.locator(".river-name")).toHaveText(await row.locator("input").inputValue());
  await page.mouse.move(5, 5);
  await expect(page.locator(".river-pointer")).toBeHidden();
  await page.getByRole("textbox", { name: "Cape" }).first().focus();
  await expect(page.locator(".river-pointer")).toBeVisible();
  await page.getByRole("textbox", { name: "The greatest river" }).focus();
  await expect(page.locator(".river-pointer .basin")).toHaveAttribute("d", /^M.{20}/);
});

for (const colorScheme of ["light", "dark"] as const) {
  for (const width of [1440, 390, 320]) {
    test(`axe finds nothing in a dialog of names: ${colorScheme}, ${width} wide`, async ({ page }) => {
      await page.emulateMedia({ colorScheme });
      await page.setViewportSize({ width, height: 800 });
      await openFinished(page, `${NAMED}&names=69.Silverrun`);
      const { x, y } = await source(page);
      await page.mouse.click(x, y);
      await expect(field(page)).toBeFocused();
      await field(page).fill("x".repeat(41));
      await page.keyboard.press("Enter");
      await expect(card(page).getByRole("alert")).toBeVisible();
      expect(await violations(page)).toEqual([]);
      const box = await card(page).boundingBox();
      expect(box?.x ?? -1).toBeGreaterThanOrEqual(0);
      expect((box?.x ?? 0) + (box?.width ?? 0)).toBeLessThanOrEqual(width);
    });
  }
}
