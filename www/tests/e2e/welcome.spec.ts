import { expect, type Page, test } from "@playwright/test";
import { violations } from "./axe.ts";
import { expectAddress, finished, fixChance, openFinished } from "./riverpage.ts";

const LINK = "seed=Ardenmoor&attractors=300&land=island&style=ink&labels=few";
const LINE = "Ardenmoor, a country grown from its name. What is yours like?";

const welcome = (page: Page) => page.locator("#welcome");
const word = (page: Page) => page.getByRole("textbox", { name: "Your name or any word" });

test("who comes by a link is met by one line and a box for a word, which does not take the focus @core", async ({
  page,
}) => {
  await openFinished(page, LINK);
  await expect(welcome(page)).toContainText(LINE);
  await expect(word(page)).toBeVisible();
  expect(await page.evaluate(() => document.activeElement === document.body)).toBe(true);
  await expect(page.locator("#welcome-line")).toHaveAttribute("aria-live", "polite");
  expect(await violations(page)).toEqual([]);
});

test("a word of one's own grows another country, and the line goes for good @core", async ({ page }) => {
  await openFinished(page, LINK);
  await word(page).fill("Anna");
  await page.getByRole("button", { name: "Grow", exact: true }).click();
  await expectAddress(page, "seed", "Anna");
  await expect(page.getByLabel("Seed", { exact: true })).toHaveValue("Anna");
  await expect(welcome(page)).toBeHidden();
  await finished(page);
  await page.goBack();
  await expectAddress(page, "seed", "Ardenmoor");
  await expect(welcome(page)).toBeHidden();
  await page.reload();
  await finished(page);
  await expect(welcome(page)).toBeHidden();
});

test("without a word nothing grows: the box has the focus", async ({ page }) => {
  await openFinished(page, LINK);
  await page.getByRole("button", { name: "Grow", exact: true }).click();
  await expect(word(page)).toBeFocused();
  await expect(welcome(page)).toBeVisible();
});

for (const [how, act] of [
  ["hides it", (page: Page) => page.getByRole("button", { name: "Hide this line" }).click()],
  ["throws the dice", (page: Page) => page.getByRole("button", { name: "A new seed by chance" }).click()],
  ["types a word into the bar", (page: Page) => page.getByLabel("Seed", { exact: true }).fill("Anna")],
] as const) {
  test(`it goes for good once somebody ${how}`, async ({ page }) => {
    await fixChance(page);
    await openFinished(page, LINK);
    await expect(welcome(page)).toBeVisible();
    await act(page);
    await expect(welcome(page)).toBeHidden();
    await openFinished(page, LINK);
    await expect(welcome(page)).toBeHidden();
  });
}

test("who loads the page again without having done anything is met again", async ({ page }) => {
  await openFinished(page, LINK);
  await page.reload();
  await finished(page);
  await expect(welcome(page)).toBeVisible();
});

test("a country that was made in this tab is no news to it, nor is the bare page", async ({ page }) => {
  await openFinished(page);
  await expect(welcome(page)).toBeHidden();
  await expectAddress(page, "edition", "1");
  await page.reload();
  await finished(page);
  await expect(welcome(page)).toBeHidden();
});

test("six maps side by side and the page for iframes meet nobody", async ({ page }) => {
  await page.goto(`./?${LINK}&view=six`);
  await expect(page.getByRole("dialog", { name: "Six ways to grow" })).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(welcome(page)).toBeHidden();
  await page.goto(`./embed.html?${LINK}`);
  await expect(page.locator("river-seed")).toBeVisible();
  await expect(page.getByText("What is yours like?")).toHaveCount(0);
});

test("it makes way for the panel, for drawing and for the map alone", async ({ page }) => {
  await openFinished(page, LINK);
  await page.getByRole("button", { name: "Shape…" }).click();
  await expect(welcome(page)).toBeHidden();
  await page.getByRole("button", { name: "Close the panel" }).click();
  await expect(welcome(page)).toBeVisible();
  await page.getByRole("button", { name: "Draw", exact: true }).click();
  await expect(welcome(page)).toBeHidden();
  await page.getByRole("button", { name: "Done", exact: true }).click();
  await page.keyboard.press("w");
  await expect(welcome(page)).toBeHidden();
});

for (const [width, height] of [
  [1440, 900],
  [1000, 700],
  [844, 390],
  [390, 844],
  [320, 568],
] as const) {
  test(`it covers neither the title nor a control, ${width} by ${height}`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    await openFinished(page, LINK);
    await expect(welcome(page)).toBeVisible();
    const box = await welcome(page).boundingBox();
    if (!box) throw new Error("no line");
    expect(box.x).toBeGreaterThanOrEqual(0);
    expect(box.x + box.width).toBeLessThanOrEqual(width);
    const covered = await page.evaluate(({ x, y, width, height }) => {
      const others = document.querySelectorAll("#title, .masthead h1, .masthead a, .zoom, .styles, .bar");
      return [...others].filter((other) => {
        if (!other.checkVisibility({ visibilityProperty: true })) return false;
        const { left, top, right, bottom } = other.getBoundingClientRect();
        return right > left && left < x + width && right > x && top < y + height && bottom > y;
      }).length;
    }, box);
    expect(covered).toBe(0);
  });
}
