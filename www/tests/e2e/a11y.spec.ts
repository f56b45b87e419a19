import { expect, test } from "@playwright/test";
import { violations } from "./axe.ts";
import { finished, openFinished, openPanel, openStopped, openUnfolded, unfold } from "./riverpage.ts";
import { OPENED } from "./states.ts";
import { core } from "./tiers.ts";

for (const colorScheme of ["light", "dark"] as const) {
  for (const width of [1440, 820, 390]) {
    test(`axe finds nothing: ${colorScheme}, ${width} wide${core(colorScheme === "light" ? width === 1440 : width === 390)}`, async ({
      page,
    }) => {
      await page.emulateMedia({ colorScheme });
      await page.setViewportSize({ width, height: 900 });
      await openFinished(page, "preset=trimmed-curl&attractors=300&mouths=900");
      expect(await violations(page)).toEqual([]);
      await openPanel(page);
      await page.keyboard.press("?");
      await expect(page.getByRole("dialog", { name: "Riverseed" })).toBeVisible();
      expect(await violations(page)).toEqual([]);
      await page.keyboard.press("Escape");
      await unfold(page);
      await page.getByRole("button", { name: "Save", exact: true }).click();
      await expect(page.getByRole("dialog")).toBeVisible();
      expect(await violations(page)).toEqual([]);
      await page.keyboard.press("Escape");
      await page.getByRole("button", { name: "Share" }).click();
      await expect(page.getByRole("dialog")).toBeVisible();
      expect(await violations(page)).toEqual([]);
    });
  }

  test(`axe finds nothing in any state that the page can be in: ${colorScheme}${core(colorScheme === "light")}`, async ({
    page,
  }) => {
    await page.emulateMedia({ colorScheme });
    await openFinished(page, "preset=trimmed-curl&attractors=300");
    for (const [state, open] of Object.entries(OPENED)) {
      await open(page);
      expect(await violations(page), state).toEqual([]);
    }
  });
}

test("axe finds nothing in a failure @core", async ({ page }) => {
  await page.route("**/*.wasm", (route) => route.abort());
  await page.goto("./");
  await expect(page.getByRole("alert")).toBeVisible();
  expect(await violations(page)).toEqual([]);
});

test("axe finds nothing in forced colours, and the sliders are the system's", async ({ page }) => {
  await page.emulateMedia({ forcedColors: "active" });
  await openUnfolded(page, "attractors=300");
  expect(await violations(page)).toEqual([]);
  const appearance = await page.locator("#field-curl").evaluate((slider) => getComputedStyle(slider).appearance);
  expect(appearance).toBe("auto");
});

test("the picture is one image with a name, and growth can be paused @core", async ({ page }) => {
  await openStopped(page, "seed=rimu&attractors=300&style=ink&labels=none");
  await expect(page.getByRole("button", { name: "Pause" })).toBeVisible();
  await page.clock.resume();
  await finished(page);
  await expect(page.getByRole("img", { name: /seed “rimu”/ })).toBeVisible();
});

test("text can be twice as large without anything being cut off sideways", async ({ page }) => {
  await page.setViewportSize({ width: 640, height: 800 });
  await openUnfolded(page, "attractors=300");
  await page.evaluate(() => {
    document.documentElement.style.fontSize = "30px";
  });
  expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
});
