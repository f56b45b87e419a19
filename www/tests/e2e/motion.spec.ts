import { expect, test } from "@playwright/test";
import { finished, fixChance, ownClock, recordStates, stopClock } from "./riverpage.ts";

test("who prefers less motion sees finished rivers only, and can still play one @core", async ({ page }) => {
  const states = await recordStates(page);
  await fixChance(page);
  await ownClock(page);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.goto("./?attractors=500");
  await finished(page);
  await page.getByRole("button", { name: "A new seed by chance" }).click();
  await expect.poll(states).toEqual(["settling", "finished", "settling", "finished"]);
  await stopClock(page);
  await page.getByRole("button", { name: "Replay" }).click();
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "growing");
  await page.clock.resume();
  await finished(page);
});

test("the preference is followed when it changes", async ({ page }) => {
  await fixChance(page);
  const states = await recordStates(page);
  await page.goto("./?attractors=300");
  await finished(page);
  expect(await states()).toEqual(["settling", "finished"]);
  await page.emulateMedia({ reducedMotion: "reduce" });
  await page.getByRole("button", { name: "A new seed by chance" }).click();
  await expect.poll(states).toEqual(["settling", "finished", "settling", "finished"]);
});
