import { expect, type Locator, type Page, test } from "@playwright/test";
import { engine } from "../core.ts";
import { table } from "../table.ts";
import { violations } from "./axe.ts";
import { address, complaints, expectAddress, finished, openFinished, openPanel, openWithPanel } from "./riverpage.ts";

/** A map that somebody has made, unlike any country of the page. */
const MADE = "seed=rimu&land=island&attractors=300&meander-rounds=4&labels=none";
const STYLED = MADE.replace("&labels", "&style=past-courses&labels");

test("every kind of country has a picture on its button, which is not fetched before the panel opens", async ({
  page,
}) => {
  const said = complaints(page);
  const fetched: string[] = [];
  page.on("request", (request) => {
    const [, name] = /\/countries\/(.*)\.webp$/.exec(request.url()) ?? [];
    if (name !== undefined) fetched.push(name);
  });
  await openFinished(page, "country=usual&attractors=300");
  expect(fetched).toEqual([]);
  await openPanel(page);
  const all = table.countries;
  // With those that stand first, the one that leaves it to the word, and the one for more.
  await expect(page.locator("#countries .preset:visible")).toHaveCount(6);
  await page.getByRole("button", { name: "More countries" }).click();
  await expect(page.getByRole("button", { name: all[4]?.label ?? "", exact: true })).toBeFocused();
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
    .locator("#countries .preset:visible")
    .evaluateAll((all) => all.map((one) => (one as HTMLElement).offsetTop));
  expect(new Set(tops).size).toBe(1);
  await expect(page.locator("[data-front=sea]")).toBeInViewport();
});

/** The button of a style on the strip, and the country that goes with it. */
function onStrip(page: Page, name: string): Locator {
  return page.getByRole("region", { name: "Style" }).getByRole("button", { name, exact: true });
}

/** Waits until the address is the one of a link. */
function expectLink(page: Page, link: string): Promise<void> {
  const wanted = new URLSearchParams(engine.readLink(link).sharedLink).toString();
  return expect.poll(() => address(page).toString()).toBe(wanted);
}

test("a style leaves the map as it is, and offers the country it is best on: one step, which can be undone @core", async ({
  page,
}) => {
  await openFinished(page, MADE);
  await page.getByRole("button", { name: "More styles" }).click();
  const [style, best] = [onStrip(page, "Past courses"), onStrip(page, "Best on: Old river")];
  await expect(best).toBeHidden();
  await style.click();
  await expectLink(page, STYLED);
  await expect(best).toBeVisible();
  await finished(page);
  expect(await violations(page)).toEqual([]);
  await best.click();
  await expectLink(page, "seed=rimu&country=old-river&style=past-courses&labels=none");
  await expect(best).toBeHidden();
  await expect(style).toBeFocused();
  await finished(page);
  await page.getByRole("button", { name: "Undo", exact: true }).click();
  await expectLink(page, STYLED);
  await expect(best).toBeVisible();
  await onStrip(page, "Atlas").click();
  await expect(best).toBeHidden();
});

test("the country that a style offers leaves alone what is kept, and is not offered twice", async ({ page }) => {
  await openWithPanel(page, STYLED);
  await page.getByRole("button", { name: "Keep Land", exact: true }).click();
  const best = onStrip(page, "Best on: Old river");
  await best.click();
  await expectAddress(page, "country", "old-river");
  // The island that it was.
  await expectAddress(page, "land", "island");
  await expect(best).toBeHidden();
});

test("on a phone the country that a style offers comes into sight beside it", async ({ page }) => {
  await page.setViewportSize({ width: 360, height: 740 });
  await openFinished(page, MADE);
  await page.getByRole("button", { name: "More styles" }).click();
  const [style, best] = [onStrip(page, "Past courses"), onStrip(page, "Best on: Old river")];
  // At the end of the row, so that what comes after it is out of sight.
  await style.evaluate((button) => button.scrollIntoView({ inline: "end" }));
  await style.click();
  await expect(best).toBeInViewport({ ratio: 1 });
  await expect(style).toBeInViewport({ ratio: 1 });
});

const countries = (page: Page): Locator => page.getByRole("group", { name: "Countries" });

/** The button of a kind of country. */
const country = (page: Page, name: string): Locator => countries(page).getByRole("button", { name, exact: true });

test("a country that is pressed is named, and takes back what it decides; undone, all is as it was @core", async ({
  page,
}) => {
  await openWithPanel(page, "seed=rimu&attractors=300&width=9.5&labels=none");
  await expect(country(page, "As the word decides")).toHaveAttribute("aria-pressed", "true");
  await country(page, "Island").click();
  await expectLink(page, "seed=rimu&country=island&labels=none");
  await expect(country(page, "Island")).toHaveAttribute("aria-pressed", "true");
  await expect(country(page, "As the word decides")).toHaveAttribute("aria-pressed", "false");
  await country(page, "As the word decides").click();
  await expectLink(page, "seed=rimu&labels=none");
  for (const _ of [1, 2]) await page.getByRole("button", { name: "Undo", exact: true }).click();
  await expectLink(page, "seed=rimu&attractors=300&width=9.5&labels=none");
});

test("the country that a word has drawn is marked among the others, which nobody has pressed @core", async ({
  page,
}) => {
  for (const word of ["Kestrel", "Thornwick"]) {
    await openWithPanel(page, `seed=${word}&attractors=300&labels=none`);
    const drawn = new Map(engine.readLink(`seed=${word}`).values).get("country");
    const label = table.countries.find(({ name }) => name === drawn)?.label ?? "";
    await expect(countries(page).locator("[aria-current]")).toHaveText(label);
    await expect(country(page, label)).toHaveAttribute("aria-pressed", "false");
    await expect(country(page, label)).toBeVisible();
  }
});

test("dice throw another country, unless it is kept: then the one on show is named @core", async ({ page }) => {
  await openWithPanel(page, "seed=Kestrel&country=usual&attractors=300&labels=none");
  const dice = page.getByRole("button", { name: "A new seed by chance" });
  await dice.click();
  await expectAddress(page, "country", null);
  await expectAddress(page, "attractors", "300");
  await page.goto("./?seed=Kestrel&attractors=300&labels=none");
  await finished(page);
  await page.getByRole("button", { name: "Keep Country" }).click();
  const drawn = new Map(engine.readLink("seed=Kestrel").values).get("country") ?? "";
  await expectAddress(page, "country", drawn);
  await dice.click();
  await expect.poll(() => address(page).get("seed")).not.toBe("Kestrel");
  await expectAddress(page, "country", drawn);
});

test("what was kept at another visit changes no link, and says what it keeps when the word changes @core", async ({
  page,
}) => {
  await page.addInitScript(() => localStorage.setItem("riverseed-kept", '["country","width"]'));
  await openFinished(page, "seed=Kestrel&labels=none&attractors=300");
  await expectLink(page, "seed=Kestrel&labels=none&attractors=300");
  const values = new Map(engine.readLink("seed=Kestrel&attractors=300").values);
  await page.getByRole("textbox", { name: "Seed" }).fill("moa");
  await expectAddress(page, "seed", "moa");
  await expectAddress(page, "country", values.get("country") ?? "");
  await expectAddress(page, "width", values.get("width") ?? "");
});
