import { expect, type Page, test } from "@playwright/test";
import { violations } from "./axe.ts";
import { address, expectAddress, finished, openWithPanel, showCountries } from "./riverpage.ts";

const LINK = "seed=rimu&land=valley&attractors=1500&meander-rounds=4&aspect=1.2&style=ink&labels=none";

function padlock(page: Page, name: string) {
  return page.getByRole("button", { name: `Keep ${name}`, exact: true });
}

function country(page: Page, name: string) {
  return page.getByRole("group", { name: "Countries" }).getByRole("button", { name });
}

async function press(page: Page, name: string): Promise<void> {
  await showCountries(page);
  await country(page, name).click();
}

test("there is a padlock for each that stands in front, and that of the land keeps its shape, too @core", async ({
  page,
}) => {
  await openWithPanel(page, LINK);
  await expect(page.locator(".keep")).toHaveCount(8);
  await padlock(page, "Land").click();
  await expect(padlock(page, "Land")).toHaveAttribute("aria-pressed", "true");
  await expect(padlock(page, "How much sea")).toHaveAttribute("aria-pressed", "false");
  await press(page, "Rainforest");
  await expectAddress(page, "country", "rainforest");
  await expectAddress(page, "attractors", null);
  for (const [key, value] of [
    ["land", "valley"],
    ["aspect", "1.2"],
  ] as const)
    await expectAddress(page, key, value);
  expect(await violations(page)).toEqual([]);
});

test("what is kept is remembered, and a padlock of which some is kept says so, is shut by a press and opened by another", async ({
  page,
}) => {
  await page.addInitScript(() => localStorage.setItem("riverseed-kept", '["meander-rounds","sea"]'));
  await openWithPanel(page, LINK);
  await expect(padlock(page, "How much sea")).toHaveAttribute("aria-pressed", "true");
  await expect(padlock(page, "How winding")).toHaveAttribute("aria-pressed", "mixed");
  await padlock(page, "How winding").click();
  await expect(padlock(page, "How winding")).toHaveAttribute("aria-pressed", "true");
  await padlock(page, "How winding").press("Enter");
  await expect(padlock(page, "How winding")).toHaveAttribute("aria-pressed", "false");
  expect(await page.evaluate(() => localStorage.getItem("riverseed-kept"))).toBe('["sea"]');
});

test("what was kept by a padlock that is gone is kept no longer", async ({ page }) => {
  await page.addInitScript(() => localStorage.setItem("riverseed-kept", '["drowning","concavity","width"]'));
  await openWithPanel(page, `${LINK}&drowning=0.5&width=9`);
  await press(page, "Archipelago");
  await expectAddress(page, "country", "archipelago");
  await expectAddress(page, "width", "9");
  expect(address(page).get("drowning")).toBeNull();
  await padlock(page, "How wide").click();
  expect(await page.evaluate(() => localStorage.getItem("riverseed-kept"))).toBe("[]");
});

test("a pattern changes nothing that is kept, and does not say that it did", async ({ page }) => {
  await openWithPanel(page, "seed=rimu&growth=colonize&attractors=800&meander-rounds=4");
  await padlock(page, "How winding").click();
  await page.getByText("For the curious").click();
  const pattern = page.getByRole("group", { name: "Presets" }).getByRole("button").first();
  await pattern.click();
  await finished(page);
  await expectAddress(page, "meander-rounds", "4");
  await expectAddress(page, "meander", null);
  await expect(page.locator("#notices")).not.toContainText("Meander");
});

test("in a browser that remembers nothing padlocks shut all the same", async ({ page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(window, "localStorage", {
      get: () => {
        throw new DOMException("denied", "SecurityError");
      },
    });
  });
  await openWithPanel(page, LINK);
  await padlock(page, "Land").click();
  await expect(padlock(page, "Land")).toHaveAttribute("aria-pressed", "true");
  await press(page, "Lakeland");
  await expectAddress(page, "country", "lakeland");
  await expectAddress(page, "land", "valley");
});
