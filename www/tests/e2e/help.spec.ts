import { expect, type Page, test } from "@playwright/test";
import { address, expectAddress, openFinished, openUnfolded, openWithPanel, showCountries } from "./riverpage.ts";

const LINK = "country=usual&seed=kauri&attractors=1000&style=ink&labels=none";

function seed(page: Page): string | null {
  return address(page).get("seed");
}

test("a sheet says what each key does, and goes by Escape @core", async ({ page }) => {
  await openFinished(page, LINK);
  await page.keyboard.press("?");
  const sheet = page.getByRole("dialog", { name: "Riverseed" });
  await expect(sheet).toBeVisible();
  await expect(sheet.getByText("a new seed by chance")).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(sheet).toBeHidden();
  await page.getByRole("button", { name: "Help and keys" }).click();
  await expect(sheet).toBeVisible();
});

test("no key does two things", async ({ page }) => {
  await openFinished(page, LINK);
  await page.keyboard.press("?");
  const rows = page.locator("#keys > div").filter({ hasNotText: "Ctrl" });
  const keys = await rows.locator("kbd").allTextContents();
  expect(keys.length).toBeGreaterThan(20);
  expect(keys.filter((key, i) => keys.indexOf(key) !== i)).toEqual([]);
});

test("keys stand for buttons, but not where text is typed", async ({ page }) => {
  await openFinished(page, LINK);
  await page.keyboard.press("r");
  await expect.poll(() => seed(page)).not.toBe("kauri");
  await page.keyboard.press("p");
  await expect(page.locator("#panel")).toBeVisible();
  await page.getByRole("textbox", { name: "Seed" }).fill("");
  await page.keyboard.type("pts?");
  await expectAddress(page, "seed", "pts?");
  await expect(page.locator("#panel")).toBeVisible();
  await expect(page.getByRole("dialog")).toBeHidden();
});

test("a macro sets what it stands for, and its lock keeps that from presets", async ({ page }) => {
  await openWithPanel(page, LINK);
  const rivers = page.getByRole("slider", { name: "How many rivers" });
  await rivers.focus();
  await page.keyboard.press("End");
  await expectAddress(page, "channel-area", "1");
  await expect(rivers).toHaveAttribute("aria-valuetext", "very many");
  await page.getByRole("button", { name: "Keep How many rivers" }).click();
  await showCountries(page);
  await page.getByRole("button", { name: "Desert" }).click();
  await expectAddress(page, "country", "desert");
  expect(address(page).get("channel-area")).toBe("1");
  await page.getByRole("button", { name: "Reset How many rivers" }).click();
  await expectAddress(page, "channel-area", null);
});

test("the wheel moves the slider that has the focus, and no other", async ({ page }) => {
  await openUnfolded(page, `${LINK}&growth=colonize`);
  const [sea, coast] = ["How much sea", "How wild a coast"].map((name) => page.getByRole("slider", { name }));
  if (!sea || !coast) throw new Error("no sliders");
  await sea.focus();
  await sea.hover();
  await page.mouse.wheel(0, -100);
  await expectAddress(page, "sea", "0.73");
  await coast.hover();
  await page.mouse.wheel(0, 100);
  await expect(coast).toHaveValue("1");
});

test("sliders that make another river have few stops, and say so", async ({ page }) => {
  await openUnfolded(page, `${LINK}&growth=colonize`);
  const curl = page.locator('[data-key="curl"]');
  await expect(curl).toContainText("Each notch is another river.");
  await curl.getByRole("slider").press("ArrowRight");
  await expectAddress(page, "curl", "0.8");
  // Who knows the number has it.
  await curl.locator(".exact").fill("0.83");
  await curl.locator(".exact").press("Enter");
  await expectAddress(page, "curl", "0.83");
});

test("the panel tells how river-like the rivers are, and of the next ones as well", async ({ page }) => {
  await openWithPanel(page, "seed=kauri");
  await page.getByText("How river-like?").click();
  const rows = page.locator(".measures > div");
  await expect(rows).toHaveCount(27);
  await expect(rows.first()).toContainText(/as in nature|than in nature/);
  await expect(page.locator(".measured")).toContainText("parcels unreached");
  await expect(page.locator(".kept")).toContainText("Checked on this map: nothing runs uphill");
  const before = await rows.allTextContents();
  await page.keyboard.press("r");
  await expect.poll(() => rows.allTextContents()).not.toEqual(before);
});

test("the bar has the kind of land, and shows a drawn one only where there is one", async ({ page }) => {
  await openFinished(page, LINK);
  const land = page.getByRole("combobox", { name: "Kind of land" });
  await land.selectOption("archipelago");
  await expectAddress(page, "land", "archipelago");
  await expect(land.locator("option[value=drawn]")).toBeHidden();
  await page.goto("./?land=drawn&outline=.MzMzzMMzzMzM&attractors=300");
  await expect(land).toHaveValue("drawn");
});

test("a teacher comes to the six ways by two clicks, and is told what to do there", async ({ page }) => {
  await openFinished(page, LINK);
  await page.getByRole("button", { name: "Help and keys" }).click();
  const sheet = page.getByRole("dialog", { name: "Riverseed" });
  await expect(sheet).toContainText("Play and pause them together");
  await sheet.getByRole("button", { name: "teach" }).click();
  await expect(sheet).toBeHidden();
  const six = page.getByRole("dialog", { name: "Six ways to grow" });
  await expect(six).toBeVisible();
  expect(address(page).get("view")).toBe("six");
  await page.keyboard.press("Escape");
  await expect(six).toBeHidden();
});
