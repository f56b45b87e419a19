import { expect, type Page, test } from "@playwright/test";
import { pictureOf } from "../core.ts";
import { expectAddress, finished, openFinished, openUnfolded, shown } from "./riverpage.ts";

const LINK = "seed=rimu&attractors=300&labels=none";

/** Waits until the page shows what the core draws of a link. */
async function expectPicture(page: Page, link: string): Promise<void> {
  const isShown = async (): Promise<boolean> => {
    const { width, height, sha256, framing } = await shown(page);
    return sha256 === pictureOf(link, width, height, framing).sha256;
  };
  await expect.poll(isShown).toBe(true);
}

test.use({ colorScheme: "dark" });

test("a dark page shows the dark style, and its address does not name it @core", async ({ page }) => {
  await openFinished(page, LINK);
  await expectPicture(page, `${LINK}&style=night`);
  await expectAddress(page, "style", null);
  await page.emulateMedia({ colorScheme: "light", reducedMotion: "reduce" });
  await expectPicture(page, LINK);
});

test("a style that is chosen on a dark page stays, in the address too", async ({ page }) => {
  await openUnfolded(page, LINK);
  await expect(page.getByRole("button", { name: "Night", exact: true })).toHaveAttribute("aria-pressed", "true");
  await page.getByRole("button", { name: "Atlas", exact: true }).click();
  await expectAddress(page, "style", "atlas");
  await page.reload();
  await finished(page);
  await expectPicture(page, LINK);
});

test("what counts as changed follows the page when it turns dark or light", async ({ page }) => {
  await openUnfolded(page, LINK);
  // The strip has the style where there is room for it; the panel, where there is none.
  await page.setViewportSize({ width: 844, height: 390 });
  const resetAll = page.getByRole("button", { name: "Reset all" });
  const reset = page.locator('[data-reset="style"]');
  const style = page.locator('[data-key="style"] select');
  await page.emulateMedia({ colorScheme: "light", reducedMotion: "reduce" });
  await expect(style).toHaveValue("atlas");
  await expect(reset).toBeHidden();
  await style.selectOption("night");
  await expect(resetAll).toBeVisible();
  await expect(reset).toHaveAccessibleName("Reset Style to atlas");
  await page.emulateMedia({ colorScheme: "dark", reducedMotion: "reduce" });
  await expect(reset).toBeHidden();
  await style.selectOption("atlas");
  await expect(reset).toHaveAccessibleName("Reset Style to night");
});
