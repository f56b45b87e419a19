import { expect, type Locator, type Page, test } from "@playwright/test";
import { openFinished, openSettings, openWithPanel } from "./riverpage.ts";

const SMALL = "seed=kauri&growth=colonize&attractors=300&style=ink&labels=none";

/** A heading under All settings. */
function group(page: Page, heading: string): Locator {
  return page.locator(".settings .group").filter({ has: page.locator(`h2:text-is("${heading}")`) });
}

async function openWithSettings(page: Page, link: string): Promise<void> {
  await openFinished(page, link);
  await openSettings(page);
}

test("at first what shapes a map most stands in the panel, and all else behind doors and headings, folded", async ({
  page,
}) => {
  await openWithPanel(page, SMALL);
  await expect(page.locator(".front .control")).toHaveCount(7);
  await expect(page.locator(".group > summary:visible")).toHaveText([
    "Names on the map",
    "All settings",
    "For the curious",
    "How river-like?",
  ]);
  await expect(page.locator(".group[open]")).toHaveCount(0);
  await openSettings(page);
  // A map in ink has a relief to set, since lakes lie in it.
  const headings = [
    "Land",
    "Growth",
    "Drainage",
    "Bends",
    "Finish",
    "Rivers",
    "Meanders",
    "Relief",
    "Names",
    "Scenery",
  ];
  await expect(page.locator(".settings .group > summary h2:visible")).toHaveText(headings);
  await expect(page.locator(".settings .group[open]")).toHaveCount(0);
  await expect(page.getByRole("slider", { name: "Curl" })).toHaveCount(0);
});

test("drainage has nothing to set on a map of Brownian trees", async ({ page }) => {
  await openWithSettings(page, "seed=kauri&growth=brownian&style=ink&labels=none");
  await expect(page.locator('.settings h2:visible:text-is("Meanders")')).toHaveCount(1);
  await expect(page.locator('.settings h2:visible:text-is("Drainage")')).toHaveCount(0);
});

test("groups fold and unfold by mouse and keys, and are so again next time @core", async ({ page }) => {
  await openWithSettings(page, SMALL);
  await group(page, "Bends").locator("summary").click();
  await expect(page.getByRole("slider", { name: "Curl" })).toBeVisible();
  await group(page, "Meanders").locator("summary").first().focus();
  await page.keyboard.press("Enter");
  await expect(page.getByRole("slider", { name: "Strength" })).toBeVisible();
  await group(page, "Meanders").locator("summary").first().click();
  await expect(page.getByRole("slider", { name: "Strength" })).toHaveCount(0);
  await page.reload();
  await expect(group(page, "Bends")).toHaveAttribute("open");
  await expect(group(page, "Meanders")).not.toHaveAttribute("open");
  await expect(page.getByRole("slider", { name: "Curl" })).toBeVisible();
});

test("how a group was left is kept at once, so that a page that is closed right then loses nothing", async ({
  page,
}) => {
  await openWithSettings(page, SMALL);
  const kept = await group(page, "Bends")
    .locator("summary")
    .evaluate(async (summary) => {
      (summary as HTMLElement).click();
      await Promise.resolve();
      return localStorage.getItem("riverseed-folds");
    });
  expect(JSON.parse(kept ?? "{}")).toMatchObject({ Bends: true });
});

test("what is seldom wanted stands under More", async ({ page }) => {
  await openWithSettings(page, SMALL);
  await expect(page.getByRole("slider", { name: "Neck" })).toHaveCount(0);
  await group(page, "Meanders").locator("summary").first().click();
  await page.getByText("More of Meanders").click();
  await expect(page.getByRole("slider", { name: "Neck" })).toBeVisible();
});

test("a folded group says how many of its values are changed", async ({ page }) => {
  await openWithSettings(page, `${SMALL}&curl=0.4&momentum=0.1`);
  await expect(group(page, "Bends").locator("summary")).toContainText("2 changed");
  await expect(group(page, "Growth").locator("summary")).toContainText("2 changed");
  const reset = page.getByRole("button", { name: "Reset all" });
  await reset.press("Enter");
  await expect(group(page, "Bends")).toBeHidden();
  // There is nothing left to reset.
  await expect(reset).toBeHidden();
  await expect(page.getByRole("button", { name: "Close the panel" })).toBeFocused();
});

test("a page that may keep nothing works all the same", async ({ page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(globalThis, "localStorage", {
      get() {
        throw new DOMException("no", "SecurityError");
      },
    });
  });
  await openWithSettings(page, SMALL);
  await group(page, "Bends").locator("summary").click();
  await expect(page.getByRole("slider", { name: "Curl" })).toBeVisible();
});
