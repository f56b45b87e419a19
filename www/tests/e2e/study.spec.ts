import { expect, type Page, test } from "@playwright/test";
import { violations } from "./axe.ts";
import { complaints, fixChance } from "./riverpage.ts";

async function answer(page: Page, with_: "Real" | "Grown"): Promise<void> {
  const count = (await page.locator("#count").textContent()) ?? "";
  const button = page.getByRole("button", { name: with_ });
  await expect(button).toBeEnabled();
  await button.click();
  if (count !== "10 of 10") await expect(page.locator("#count")).not.toHaveText(count);
}

for (const colorScheme of ["light", "dark"] as const)
  test(`a reader tells ten pieces of river apart, and is told what gave ours away: ${colorScheme}`, async ({
    page,
  }) => {
    await page.emulateMedia({ colorScheme });
    await page.setViewportSize({ width: 320, height: 640 });
    const said = complaints(page);
    await fixChance(page);
    await page.goto("./real-or-grown.html");
    await expect(page.locator("#count")).toHaveText("1 of 10");
    expect(await violations(page)).toEqual([]);
    for (let i = 0; i < 10; i++) {
      await answer(page, "Grown");
      await expect(page.locator("#verdict")).toHaveText(/^(Right: grown from \w+|No: real, .*km across)\.$/);
    }
    await expect(page.locator("#end h2")).toHaveText(/^\d+ of 10 right$/);
    const right = Number.parseInt((await page.locator("#end h2").textContent()) ?? "", 10);
    await expect(page.locator("#end li")).toHaveCount(right);
    await expect(page.locator("#end")).toContainText(`in all: ${right} of 10`);
    expect(await violations(page)).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(320);
    await page.getByRole("button", { name: "Ten more" }).click();
    await expect(page.locator("#count")).toHaveText("1 of 10");
    expect(said).toEqual([]);
  });
