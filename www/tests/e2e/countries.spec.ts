import { expect, test } from "@playwright/test";
import { table } from "../table.ts";
import { complaints, openFinished, openPanel } from "./riverpage.ts";

test("every kind of country has a picture on its button, which is not fetched before the panel opens", async ({
  page,
}) => {
  const said = complaints(page);
  const fetched: string[] = [];
  page.on("request", (request) => {
    const [, name] = /\/countries\/(.*)\.webp$/.exec(request.url()) ?? [];
    if (name !== undefined) fetched.push(name);
  });
  await openFinished(page, "attractors=300");
  expect(fetched).toEqual([]);
  await openPanel(page);
  const all = table.countries;
  const pictures = page.locator("#countries img");
  await expect(pictures).toHaveCount(all.length);
  for (const [i, { label }] of all.entries()) {
    const picture = pictures.nth(i);
    await picture.scrollIntoViewIfNeeded();
    await expect.poll(() => picture.evaluate((img: HTMLImageElement) => img.complete && img.naturalWidth)).toBe(216);
    // It says nothing that the button does not say.
    await expect(page.getByRole("button", { name: label, exact: true })).toBeVisible();
  }
  expect(fetched.sort()).toEqual(all.map(({ name }) => name).sort());
  expect(said).toEqual([]);
});

test("on phones the kinds of country stand in one row, and what follows is in sight @core", async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await openFinished(page, "attractors=300");
  await openPanel(page);
  const tops = await page
    .locator("#countries .preset")
    .evaluateAll((all) => all.map((one) => (one as HTMLElement).offsetTop));
  expect(new Set(tops).size).toBe(1);
  await expect(page.locator("[data-key=sea]").first()).toBeInViewport();
});
