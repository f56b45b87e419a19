import { expect, type Page, test } from "@playwright/test";
import { violations } from "./axe.ts";
import { expectAddress, finished, openWithPanel } from "./riverpage.ts";

const LINK = "seed=rimu&land=valley&attractors=1500&meander-rounds=4&aspect=1.2&style=ink&labels=none";

function padlock(page: Page, name: string) {
  return page.getByRole("button", { name: `Keep ${name}`, exact: true });
}

function country(page: Page, name: string) {
  return page.getByRole("group", { name: "Countries" }).getByRole("button", { name });
}

test("the padlock of a group keeps all its values, those too that stand in front @core", async ({ page }) => {
  await openWithPanel(page, LINK);
  await padlock(page, "all of Land").click();
  for (const name of ["all of Land", "Land", "How much sea", "How wild a coast"])
    await expect(padlock(page, name)).toHaveAttribute("aria-pressed", "true");
  await expect(padlock(page, "all of Growth")).toHaveAttribute("aria-pressed", "false");
  await country(page, "Rainforest").click();
  await expectAddress(page, "attractors", "45000");
  for (const [key, value] of [
    ["land", "valley"],
    ["aspect", "1.2"],
    ["sea", null],
  ] as const)
    await expectAddress(page, key, value);
  expect(await violations(page)).toEqual([]);
});

test("a group of which some is kept says so, is shut by a press and opened by another; all is remembered", async ({
  page,
}) => {
  await openWithPanel(page, LINK);
  await padlock(page, "How much sea").click();
  await expect(padlock(page, "all of Land")).toHaveAttribute("aria-pressed", "mixed");
  await page.reload();
  await finished(page);
  await expect(padlock(page, "How much sea")).toHaveAttribute("aria-pressed", "true");
  await expect(padlock(page, "all of Land")).toHaveAttribute("aria-pressed", "mixed");
  await padlock(page, "all of Land").click();
  await expect(padlock(page, "all of Land")).toHaveAttribute("aria-pressed", "true");
  await padlock(page, "all of Land").press("Enter");
  for (const name of ["all of Land", "How much sea"])
    await expect(padlock(page, name)).toHaveAttribute("aria-pressed", "false");
  // The heading beside it opens and closes, and nothing else does.
  await expect(page.locator(".group:has(> summary :text-is('Land'))")).not.toHaveAttribute("open");
});

test("a pattern changes nothing that is kept, and does not say that it did", async ({ page }) => {
  await openWithPanel(page, "seed=rimu&growth=colonize&attractors=800&meander-rounds=4");
  await padlock(page, "all of Meanders").click();
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
  await country(page, "Lakeland").click();
  await expectAddress(page, "attractors", "18000");
  await expectAddress(page, "land", "valley");
});
