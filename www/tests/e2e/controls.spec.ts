import { expect, type Locator, type Page, test } from "@playwright/test";
import { isAdjustable } from "../../src/controls.ts";
import { engine, pictureOf } from "../core.ts";
import { address, expectAddress, finished, openFinished, recordStates, shown } from "./riverpage.ts";

/** Few attractors: these tests are about controls. */
const SMALL = "seed=kauri&attractors=300&edition=1";

const adjustable = engine.parameters().filter(isAdjustable);

function row(page: Page, key: string): Locator {
  return page.locator(`[data-key="${key}"]`);
}

/** The picture on the page is the one its address promises. */
async function expectPictureOfAddress(page: Page): Promise<void> {
  await finished(page);
  await expect
    .poll(async () => {
      const { width, height, sha256 } = await shown(page);
      return sha256 === pictureOf(address(page).toString(), width, height).sha256;
    })
    .toBe(true);
}

test("every row of the table has a control with its label, help and value", async ({ page }) => {
  await openFinished(page);
  await expect(page.locator("[data-key]")).toHaveCount(adjustable.length);
  for (const { key, label, help } of adjustable) {
    await expect(row(page, key)).toContainText(label);
    await expect(row(page, key)).toContainText(help);
  }
});

for (const { key, label, stage, default: value } of adjustable.filter(({ min }) => min !== undefined)) {
  test(`the slider of ${key} changes the picture, and reset brings it back`, async ({ page }) => {
    const states = await recordStates(page);
    await openFinished(page, key === "attractors" ? "" : SMALL);
    const before = await shown(page);
    const began = (await states()).length;
    const slider = row(page, key).getByRole("slider");
    await expect(slider).toHaveAccessibleName(label);
    await slider.focus();
    for (let i = 0; i < 3; i++) await page.keyboard.press("PageUp");
    await expect.poll(() => address(page).has(key)).toBe(true);
    await expectPictureOfAddress(page);
    const exact = row(page, key).locator(".exact");
    await expect.poll(async () => (await exact.inputValue()) === address(page).get(key)).toBe(true);
    await row(page, key)
      .getByRole("button", { name: `Reset ${label} to ${value}` })
      .click();
    await expectAddress(page, key, null);
    await expect(slider).toBeFocused();
    await expect.poll(() => shown(page)).toEqual(before);
    // Late stages never grow the river again; early ones do so without animation.
    const since = (await states()).slice(began);
    expect(since).not.toContain("growing");
    if (stage === "prune" || stage === "paint") expect(since).toEqual([]);
  });
}

test("a slider that is dragged ends on the picture of its last value", async ({ page }) => {
  await openFinished(page, "seed=kauri&attractors=3000");
  const slider = row(page, "curl").getByRole("slider");
  await slider.scrollIntoViewIfNeeded();
  const box = await slider.boundingBox();
  if (!box) throw new Error("the slider is not shown");
  const y = box.y + box.height / 2;
  await page.mouse.move(box.x + 8, y);
  await page.mouse.down();
  for (let i = 1; i <= 60; i++) await page.mouse.move(box.x + 8 + (i / 60) * box.width * 0.6, y);
  await page.mouse.up();
  await expect.poll(() => Number(address(page).get("curl"))).toBeGreaterThan(1);
  await expectPictureOfAddress(page);
});

test("choices change the picture", async ({ page }) => {
  await openFinished(page, SMALL);
  for (const { key, choices } of adjustable.filter(({ kind }) => kind === "choice")) {
    await row(page, key).getByRole("combobox").selectOption({ index: 1 });
    await expectAddress(page, key, choices?.[1]?.value ?? "");
    await expectPictureOfAddress(page);
  }
});

test("sides are ticked, and the last one stays", async ({ page }) => {
  await openFinished(page, SMALL);
  const sides = row(page, "sides");
  await sides.getByLabel("West").check();
  await expectAddress(page, "sides", "sw");
  await expectPictureOfAddress(page);
  await sides.getByLabel("South").uncheck();
  await expectAddress(page, "sides", "w");
  await sides.getByLabel("West").click();
  await expect(sides.getByLabel("West")).toBeChecked();
  await expect(page.locator("#notices")).toBeHidden();
});

test("an exact value can be typed; one out of range is clamped and said", async ({ page }) => {
  await openFinished(page, SMALL);
  const curl = page.getByLabel("Curl, exact value");
  await curl.fill("0.123");
  await curl.press("Enter");
  await expectAddress(page, "curl", "0.123");
  await expect(page.locator("#notices")).toBeHidden();
  await curl.fill("77");
  await curl.press("Enter");
  await expect(curl).toHaveValue("2");
  await expect(page.locator("#notices")).toContainText("curl: 77 is not between 0 and 2");
  await curl.fill("1");
  await curl.press("Enter");
  await expect(page.locator("#notices")).toBeHidden();
});

for (const preset of engine.presets()) {
  test(`the preset ${preset.name} is a button`, async ({ page }) => {
    await openFinished(page, `${SMALL}&curl=1.7&momentum=0.2`);
    const button = page.getByRole("button", { name: preset.label, exact: true });
    await button.click();
    await expect(button).toHaveAttribute("aria-pressed", "true");
    await expect(page.locator('#presets [aria-pressed="true"]')).toHaveCount(1);
    await expect(page.locator("#presets")).toContainText(preset.help);
    const expected = engine.readLink(`seed=kauri&attractors=300&preset=${preset.name}`).link;
    await expect.poll(() => new URL(page.url()).search).toBe(`?${expected}`);
    await expectPictureOfAddress(page);
  });
}

test("the dice give a new seed that can be read", async ({ page }) => {
  await openFinished(page, SMALL);
  const field = page.getByLabel("Seed", { exact: true });
  const seen = new Set(["kauri"]);
  for (let i = 0; i < 3; i++) {
    await page.getByRole("button", { name: "A new seed by chance" }).click();
    const seed = await field.inputValue();
    expect(seed).toMatch(/\p{L}{2}/u);
    expect(seen.has(seed)).toBe(false);
    seen.add(seed);
    await expectAddress(page, "seed", seed);
  }
  await expectPictureOfAddress(page);
});

test("typing a seed grows it, Enter at once, an empty box nothing", async ({ page }) => {
  await openFinished(page, SMALL);
  const field = page.getByLabel("Seed", { exact: true });
  await field.fill("Waikato");
  await expectAddress(page, "seed", "Waikato");
  await expectPictureOfAddress(page);
  await field.fill("Clutha");
  await field.press("Enter");
  await expect(page.locator("#title")).toHaveText("Clutha");
  await field.fill("");
  await field.press("Enter");
  await expect(page.locator("#title")).toHaveText("Clutha");
  await field.blur();
  await expect(field).toHaveValue("Clutha");
});

test("Reset all goes back to the defaults and keeps the seed", async ({ page }) => {
  await openFinished(page, "seed=kea&curl=1&trim=20&style=skeleton&aspect=2");
  await page.getByRole("button", { name: "Reset all" }).click();
  await expect.poll(() => new URL(page.url()).search).toBe(`?${engine.readLink("seed=kea").link}`);
  await expectPictureOfAddress(page);
});

test("everything can be reached and used by keyboard alone", async ({ page }) => {
  await openFinished(page, SMALL);
  const order: string[] = [];
  for (;;) {
    await page.keyboard.press("Tab");
    const name = await page.evaluate(() => {
      const { activeElement: element } = document;
      // The end, or once around: every element is met once.
      if (!(element instanceof HTMLElement) || element === document.body || element.dataset["met"]) return "";
      element.dataset["met"] = "yes";
      return element.id || element.getAttribute("value") || element.textContent?.trim() || element.tagName;
    });
    if (name === "") break;
    order.push(name);
  }
  for (const id of ["play", "restart", "speed", "seed", "dice", "download", "copy", "reset"])
    expect(order).toContain(id);
  for (const { label } of engine.presets()) expect(order).toContain(label);
  for (const { key, kind } of adjustable) if (kind !== "sides") expect(order).toContain(`field-${key}`);
  for (const side of ["n", "e", "s", "w"]) expect(order).toContain(side);
});

test("Space plays and pauses from the page, and stays a space in the seed", async ({ page }) => {
  await openFinished(page, "seed=kauri&attractors=4000");
  await page.keyboard.press("Space");
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "growing");
  await page.keyboard.press("Space");
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "paused");
  await page.getByLabel("Seed", { exact: true }).focus();
  await page.keyboard.press("End");
  await page.keyboard.type(" x");
  await expect(page.getByLabel("Seed", { exact: true })).toHaveValue("kauri x");
});
