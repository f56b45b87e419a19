import { expect, type Page, test } from "@playwright/test";
import { engine } from "../core.ts";
import { violations } from "./axe.ts";
import { address, expectAddress, finished, openUnfolded } from "./riverpage.ts";

/** A map that somebody has chosen: what presets do not speak of, and what they change unasked. */
const CHOSEN = "seed=kauri&land=island&attractors=300&simplify=12&meander=flow&curl=0.3&style=ink&labels=none";

function press(page: Page, name: string): Promise<void> {
  return page.getByRole("button", { name, exact: true }).click();
}

test("what a preset changes unasked is said, and taken back by one click @core", async ({ page }) => {
  await openUnfolded(page, CHOSEN);
  const notices = page.locator("#notices");
  await press(page, "Curl");
  await expect(notices).toHaveRole("status");
  await expect(notices.getByRole("listitem")).toContainText("Simplify from 12 % to 0 %");
  await expect(notices).toContainText("Meanders from “bends skew and travel” to “none”");
  await expectAddress(page, "meander", "none");
  expect(await violations(page)).toEqual([]);
  await notices.getByRole("button", { name: "Undo" }).click();
  await expect(notices).toBeHidden();
  await expect(page.getByRole("button", { name: "Curl", exact: true })).toBeFocused();
  await finished(page);
  await expect.poll(() => address(page).toString()).toBe(new URLSearchParams(engine.readLink(CHOSEN).link).toString());
});

test("the way back leads before the first of several presets, and goes with the next change", async ({ page }) => {
  await openUnfolded(page, CHOSEN);
  const notices = page.locator("#notices");
  await press(page, "Curl");
  await press(page, "Trimmed original");
  await expect(notices).toContainText("“Trimmed original” also changed");
  await notices.getByRole("button", { name: "Undo" }).click();
  await expectAddress(page, "meander", "flow");
  await press(page, "Momentum");
  await expect(notices).toBeVisible();
  await page.getByRole("button", { name: "A new seed by chance" }).click();
  await expect(notices).toBeHidden();
  await expectAddress(page, "meander", "none");
});

test("a preset that changes nothing unasked says nothing", async ({ page }) => {
  await openUnfolded(page, "preset=original&land=island&attractors=300");
  await press(page, "Curl");
  await finished(page);
  await expect(page.locator("#notices")).toBeHidden();
});
