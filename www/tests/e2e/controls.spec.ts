import { expect, type Locator, type Page, test } from "@playwright/test";
import { isAdjustable } from "../../src/controls/controls.ts";
import { engine } from "../core.ts";
import { table } from "../table.ts";
import { violations } from "./axe.ts";
import {
  address,
  expectAddress,
  expectPictureOfAddress,
  finished,
  fixChance,
  openFinished,
  openFold,
  openSettings,
  openUnfolded,
  ownClock,
  recordPhases,
  recordStates,
  shown,
  stopClock,
} from "./riverpage.ts";
import { core } from "./tiers.ts";

/** Few attractors: these tests are about controls. */
const SMALL = "seed=kauri&country=usual&growth=colonize&attractors=300&edition=1&style=ink&labels=none";

/** As rivers grow unless a link says otherwise; with fewer parcels they hardly capture one another. */
const DRAINED = "seed=kauri&country=usual&attractors=3000&edition=1&style=ink&labels=none";

const adjustable = table.parameters.filter(isAdjustable);

/** Those with a control of the table's own: names are a list (`names.spec.ts`). */
const controlled = adjustable.filter(({ key }) => key !== "names");

/** Those that a picture of a few attractors shows at once: labels and scenery come later, and want room. */
const drawn = controlled.filter(({ stage }) => stage !== "name");

/** Land is in front, and the style on the strip: their rows are not among those that are hidden without effect. */
function isAtHand(key: string): boolean {
  return key === "land" || key === "style";
}

function reasonIn(link: string, key: string): string | undefined {
  return new Map(engine.readLink(link).idle).get(key);
}

/** Many mouths on one coast. */
const MANY = `${SMALL}&land=island&mouths=30`;

/** A coast at which great rivers build deltas if they have sediment. */
const COAST = "seed=kauri&country=usual&land=island&attractors=800&width=24&edition=1&style=ink&labels=none";

/** Recipes in one of which every control has something to do. */
const CONTEXTS = [
  SMALL,
  `${SMALL}&land=rectangle&curl=0`,
  MANY,
  DRAINED,
  `${DRAINED}&pattern=trellis`,
  `${DRAINED}&pattern=radial`,
  "seed=kauri&country=usual&growth=brownian&edition=1",
  `${SMALL}&meander=none`,
  `${SMALL}&valleys=0&style=atlas`,
  `${COAST}&deltas=0.7`,
];

/** Many rivers that meander for long: here they come near each other. */
const CLOSE = `${SMALL.replace("kauri", "rimu")}&land=rectangle&mouths=3&curl=0&trim=60&tributary-spacing=0&great-rivers=16&meander-elsewhere=1&meander-rounds=200&meander-strength=1&flat-share=1`;

function contextOf(key: string): string {
  if (["neck", "oxbows", "clearance"].includes(key)) return CLOSE;
  if (key === "mouth-spacing") return MANY;
  if (key === "deltas") return COAST;
  if (key === "waves") return `${COAST}&deltas=0.7`;
  if (key === "trim-variation") return `${SMALL}&trim=30`;
  if (key === "growth" || key === "great-rivers") return DRAINED;
  const link = CONTEXTS.find((one) => reasonIn(one, key) === undefined);
  if (link === undefined) throw new Error(`${key} does nothing in any recipe here`);
  return link;
}

function row(page: Page, key: string): Locator {
  return page.locator(`[data-key="${key}"]`);
}

/** What the panel says of some rows, read at once: there are many of them. */
function rowsIn(page: Page, keys: readonly string[]): Promise<{ text: string; help: string; isUsable: boolean[] }[]> {
  return page.evaluate((keys) => {
    const plain = (element?: Element | null): string => element?.textContent?.replace(/\s+/g, " ").trim() ?? "";
    return keys.map((key) => {
      const row = document.querySelector(`[data-key="${key}"]`);
      const fields = [...(row?.querySelectorAll("input, select") ?? [])];
      const isUsable = fields.map((field) => !field.matches(":disabled"));
      return { text: plain(row), help: plain(row?.querySelector(".help")), isUsable };
    });
  }, keys);
}

for (const link of CONTEXTS) {
  test(`every row of the table has a control with its label, and its help or why it is idle: ?${link}${core(link === CONTEXTS[0])}`, async ({
    page,
  }) => {
    await openUnfolded(page, link);
    await expect(page.locator("[data-key]")).toHaveCount(adjustable.length);
    const idle = controlled.filter(({ key }) => reasonIn(link, key) !== undefined && !isAtHand(key));
    await expect(page.locator(".idle-line")).toContainText(`${idle.length} settings have no effect on this map.`);
    const rows = await rowsIn(
      page,
      controlled.map(({ key }) => key),
    );
    for (const [i, { key, label, help }] of controlled.entries()) {
      const reason = reasonIn(link, key);
      expect(rows[i]?.text, key).toContain(label);
      expect(rows[i]?.help, key).toBe(reason === undefined ? help : `No effect: ${reason}.`);
      expect(rows[i]?.isUsable, key).toEqual(rows[i]?.isUsable.map(() => reason === undefined));
    }
  });
}

test("an idle control keeps its value and has it again @core", async ({ page }) => {
  await openUnfolded(page, `${SMALL}&land=island&sea=0.3`);
  const land = page.getByLabel("Land", { exact: true });
  const sea = page.getByRole("slider", { name: "How much sea", exact: true });
  await expect(sea).toBeEnabled();
  await land.selectOption("rectangle");
  await expect(row(page, "sea")).toContainText("No effect: the whole rectangle is land, so there is no coast.");
  await expect(row(page, "sea").locator(".exact")).toHaveValue("0.3");
  await expect(row(page, "sea").getByRole("button")).toHaveCount(0);
  await expect(sea).toHaveCount(0);
  await expectAddress(page, "sea", "0.3");
  await land.selectOption("island");
  await expect(sea).toHaveValue("0.3");
  await expectPictureOfAddress(page);
});

test("settings without effect are counted and hidden, with headings that have no others, until they are asked for @core", async ({
  page,
}) => {
  await openFinished(page, SMALL);
  await openSettings(page);
  const idle = controlled.filter(({ key }) => reasonIn(SMALL, key) !== undefined && !isAtHand(key));
  const line = page.locator(".idle-line");
  await expect(line).toContainText(`${idle.length} settings have no effect on this map.`);
  await openFold(page, "Bends");
  await expect(row(page, "curl")).toBeVisible();
  await expect(row(page, "channel-area")).toBeHidden();
  await openFold(page, "Growth");
  await expect(row(page, "reach")).toBeVisible();
  await expect(row(page, "sensitivity")).toBeHidden();
  const shown = line.getByRole("checkbox", { name: "Show them, and why" });
  await shown.check();
  await expect(row(page, "sensitivity")).toContainText("No effect: ");
  await page.reload();
  await finished(page);
  await expect(shown).toBeChecked();
  await expect(row(page, "sensitivity")).toBeVisible();
  await shown.uncheck();
  await expect(row(page, "sensitivity")).toBeHidden();
  // All that rivers without meanders leave idle.
  await openFold(page, "Meanders");
  await row(page, "meander").getByRole("combobox").selectOption("none");
  await expect(row(page, "meander-rounds")).toBeHidden();
  await expect(page.getByText("More of Meanders")).toBeHidden();
  expect(await violations(page)).toEqual([]);
});

test("in a window too low for the strip the style is among the settings", async ({ page }) => {
  await page.setViewportSize({ width: 844, height: 390 });
  await openFinished(page, SMALL);
  await openSettings(page);
  await row(page, "style").getByRole("combobox").selectOption("survey");
  await expectAddress(page, "style", "survey");
  await page.setViewportSize({ width: 844, height: 900 });
  await expect(row(page, "style")).toBeHidden();
});

test("rivers that do not meander leave their controls idle, and have them again", async ({ page }) => {
  await openUnfolded(page, `${SMALL}&meander-rounds=20`);
  const fields = [
    "meander-rounds",
    "meander-strength",
    "meander-mix",
    "meander-elsewhere",
    "great-rivers",
    "flat-share",
    "neck",
    "clearance",
    "taper",
  ];
  await row(page, "meander").getByRole("combobox").selectOption("none");
  for (const key of fields) await expect(row(page, key)).toContainText("do not meander");
  await expectPictureOfAddress(page);
  await row(page, "meander").getByRole("combobox").selectOption("flow");
  await expect(row(page, "meander-mix").locator(".exact")).toBeDisabled();
  await expect(row(page, "meander-rounds").locator(".exact")).toHaveValue("20");
  await expect(row(page, "meander-rounds").getByRole("slider")).toBeEnabled();
  await expectPictureOfAddress(page);
});

test("a preset is a way of space colonization, and goes back to it", async ({ page }) => {
  await openUnfolded(page, "seed=kauri&growth=brownian&sensitivity=40&attractors=300");
  await expect(page.locator('#presets [aria-pressed="true"]')).toHaveCount(0);
  await page.getByRole("button", { name: "Momentum", exact: true }).click();
  await expectAddress(page, "growth", "colonize");
  await expect(page.getByRole("slider", { name: "Momentum" })).toBeEnabled();
  await expectPictureOfAddress(page);
});

/** Parameters by the recipe that they are tried in, so that those of one recipe are tried on one page, a few of them on each. */
function byContext(parameters: typeof drawn): [link: string, few: typeof drawn][] {
  const groups = new Map<string, typeof drawn>();
  for (const parameter of parameters) {
    const link = parameter.key === "attractors" ? "seed=kauri&country=usual" : contextOf(parameter.key);
    groups.set(link, [...(groups.get(link) ?? []), parameter]);
  }
  return [...groups].flatMap(([link, all]) => inFews(all).map((few): [string, typeof drawn] => [link, few]));
}

/** So that two workers have about the same to do, and a failure is found soon. */
const A_FEW = 8;

function inFews<Item>(all: readonly Item[]): Item[][] {
  return all.length <= A_FEW ? [[...all]] : [all.slice(0, A_FEW), ...inFews(all.slice(A_FEW))];
}

const keysOf = (few: typeof drawn): string => few.map(({ key }) => key).join(", ");

for (const [link, few] of byContext(drawn.filter(({ min }) => min !== undefined))) {
  test(`each of these sliders changes the picture, and reset brings it back: ${keysOf(few)}`, async ({ page }) => {
    test.setTimeout(few.length * 120_000);
    const states = await recordStates(page);
    const phases = await recordPhases(page);
    await openUnfolded(page, link);
    // With the names, which come last.
    await expectPictureOfAddress(page);
    const before = await shown(page);
    for (const { key, label, stage, max, decided, default: value } of few)
      await test.step(key, async () => {
        const began = [(await states()).length, (await phases()).length] as const;
        const slider = row(page, key).getByRole("slider");
        await expect(slider).toHaveAccessibleName(label);
        await slider.focus();
        for (let i = 0; i < 3; i++) await page.keyboard.press(Number(value) === max ? "PageDown" : "PageUp");
        await expect.poll(() => address(page).has(key)).toBe(true);
        await expectPictureOfAddress(page);
        expect((await shown(page)).sha256).not.toBe(before.sha256);
        const exact = row(page, key).locator(".exact");
        await expect.poll(async () => (await exact.inputValue()) === address(page).get(key)).toBe(true);
        await row(page, key)
          .getByRole("button", { name: `Reset ${label} to ${decided ? "auto" : value}` })
          .click();
        await expectAddress(page, key, null);
        await expect(slider).toBeFocused();
        await expect.poll(() => shown(page)).toEqual(before);
        // Early stages grow the river again, without animation; late ones do not grow it.
        expect((await states()).slice(began[0])).not.toContain("growing");
        if (!["land", "grow"].includes(stage)) expect((await phases()).slice(began[1])).not.toContain("growing");
      });
  });
}

test("a slider that is dragged ends on the picture of its last value @core", async ({ page }) => {
  await openUnfolded(page, "seed=kauri&growth=colonize&attractors=3000");
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

test("a slider of meanders that is dragged shows rivers on the way and grows nothing", async ({ page }) => {
  const phases = await recordPhases(page);
  await openUnfolded(page, SMALL);
  const began = (await phases()).length;
  const slider = row(page, "meander-strength").getByRole("slider");
  await slider.scrollIntoViewIfNeeded();
  const box = await slider.boundingBox();
  if (!box) throw new Error("the slider is not shown");
  const y = box.y + box.height / 2;
  const seen = new Set<string>();
  await page.mouse.move(box.x + box.width / 2, y);
  await page.mouse.down();
  for (let i = 1; i <= 12; i++) {
    await page.mouse.move(box.x + box.width * (0.5 + i * 0.04), y);
    seen.add((await shown(page)).sha256);
  }
  expect(seen.size).toBeGreaterThan(3);
  await page.mouse.up();
  await expect.poll(() => Number(address(page).get("meander-strength"))).toBeGreaterThan(0.9);
  await expectPictureOfAddress(page);
  expect((await phases()).slice(began)).not.toContain("growing");
});

for (const [link, few] of byContext(drawn.filter(({ key, kind }) => kind === "choice" && key !== "style"))) {
  test(`the choices of each of these change the picture: ${keysOf(few)}`, async ({ page }) => {
    test.setTimeout(few.length * 120_000);
    await openUnfolded(page, link);
    // With the names, which come last.
    await expectPictureOfAddress(page);
    const before = await shown(page);
    for (const { key, choices } of few)
      await test.step(key, async () => {
        const choice = row(page, key).getByRole("combobox");
        const first = await choice.inputValue();
        const drawn = new Map(engine.readLink(link).values).get(key);
        const other = choices?.find(({ value }) => value !== drawn)?.value ?? "";
        const chosen = key === "country" ? "archipelago" : other;
        await choice.selectOption(chosen);
        await expectAddress(page, key, chosen);
        await expectPictureOfAddress(page);
        expect((await shown(page)).sha256).not.toBe(before.sha256);
        await choice.selectOption(first);
        await expect.poll(() => shown(page)).toEqual(before);
      });
  });
}

test("sides are ticked, and the last one stays", async ({ page }) => {
  await openUnfolded(page, `${SMALL}&land=rectangle`);
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

test("an exact value can be typed; one out of range is clamped and said @core", async ({ page }) => {
  await openUnfolded(page, SMALL);
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

for (const preset of table.presets) {
  test(`the preset ${preset.name} is a button`, async ({ page }) => {
    await openUnfolded(page, `${SMALL}&curl=1.7&momentum=0.2`);
    const button = page.getByRole("button", { name: preset.label, exact: true });
    await button.click();
    await expect(button).toHaveAttribute("aria-pressed", "true");
    await expect(page.locator('#presets [aria-pressed="true"]')).toHaveCount(1);
    await expect(page.locator("#presets")).toContainText(preset.help);
    const expected = engine.readLink(`seed=kauri&attractors=300&style=ink&labels=none&preset=${preset.name}`).link;
    await expect.poll(() => new URL(page.url()).search).toBe(`?${expected}`);
    await expectPictureOfAddress(page);
  });
}

test("the dice give a new seed that can be read @core", async ({ page }) => {
  await fixChance(page);
  await openUnfolded(page, SMALL);
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

test("typing a seed grows it, Enter at once, an empty box nothing @core", async ({ page }) => {
  await openUnfolded(page, SMALL);
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

test("an address pasted in place of a seed opens its map, and tells that it was mended", async ({ page }) => {
  await openUnfolded(page, SMALL);
  const field = page.getByLabel("Seed", { exact: true });
  const link = "seed=Waikato&growth=colonize&attractors=300&curl=1&style=ink&labels=none";
  await field.fill(`<https://rivers.example/?${link.replaceAll("&", "&amp;")}>`);
  await expect.poll(() => new URL(page.url()).search).toBe(`?${engine.readLink(link).link}`);
  await expect(field).toHaveValue("Waikato");
  await expect(page.locator("#notices")).toContainText("has been mended");
  await expectPictureOfAddress(page);
  await field.fill("Why? a=b & 100%");
  await expectAddress(page, "seed", "Why? a=b & 100%");
  await expectAddress(page, "curl", "1");
  await field.fill("word ".repeat(20));
  await expectAddress(page, "seed", "word ".repeat(13).slice(0, 64).trim());
  await expect(page.locator("#notices")).toContainText("at most 64 are allowed");
});

test("Reset all goes back to the defaults and keeps the seed", async ({ page }) => {
  await openUnfolded(page, "seed=kea&curl=1&trim=63&style=skeleton&aspect=2");
  await page.getByRole("button", { name: "Reset all" }).click();
  await expect.poll(() => new URL(page.url()).search).toBe(`?${engine.readLink("seed=kea").link}`);
  await expectPictureOfAddress(page);
});

test("everything can be reached and used by keyboard alone @core", async ({ page }) => {
  await openUnfolded(page, SMALL);
  // The focus begins at the top again, and what was unfolded is so still.
  await page.reload();
  await finished(page);
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
  for (const id of ["play", "speed", "seed", "dice", "download", "reset", "shape", "draw", "share", "zoom-in"])
    expect(order).toContain(id);
  for (const { label } of table.presets) expect(order).toContain(label);
  for (const { key, kind } of controlled) {
    // The strip has the style.
    if (kind === "sides" || key === "style") continue;
    if (reasonIn(SMALL, key) === undefined) expect(order).toContain(`field-${key}`);
    else expect(order).not.toContain(`field-${key}`);
  }
  for (const side of ["n", "e", "s", "w"]) expect(order).toContain(side);
  for (const heading of new Set(adjustable.map(({ group }) => group)))
    expect(order.some((name) => name.startsWith(heading))).toBe(true);
});

test("Space plays and pauses from the page, and stays a space in the seed @core", async ({ page }) => {
  await ownClock(page);
  await openFinished(page, "seed=kauri&attractors=300");
  await stopClock(page);
  await page.keyboard.press("Space");
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "growing");
  await page.keyboard.press("Space");
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "paused");
  await page.getByLabel("Seed", { exact: true }).focus();
  await page.keyboard.press("End");
  await page.keyboard.type(" x");
  await expect(page.getByLabel("Seed", { exact: true })).toHaveValue("kauri x");
});

test("how much sea suits the land is shown where the slider stands, and can be had again", async ({ page }) => {
  await openUnfolded(page, SMALL);
  const slider = page.getByRole("slider", { name: "How much sea" });
  const exact = page.locator("#exact-sea");
  await expect(exact).toHaveValue("auto");
  await expect(slider).toHaveValue("0.72");
  await expect(slider).toHaveAttribute("aria-valuetext", "automatic: 0.72");
  await page.getByRole("combobox", { name: "Land", exact: true }).selectOption("basin");
  await expect(slider).toHaveValue("0.18");
  await exact.fill("0.4");
  await exact.press("Enter");
  await expectAddress(page, "sea", "0.4");
  await expect(slider).toHaveAttribute("aria-valuetext", "0.4");
  await exact.fill("auto");
  await exact.press("Enter");
  await expectAddress(page, "sea", null);
  await expect(exact).toHaveValue("auto");
});

test("what the word decides says auto and stands where it was decided; moved it is named, and can be given back @core", async ({
  page,
}) => {
  await openUnfolded(page, "seed=Kestrel&attractors=300&labels=none");
  const width = new Map(engine.readLink("seed=Kestrel&attractors=300").values).get("width") ?? "";
  const [slider, exact] = [row(page, "width").getByRole("slider"), page.locator("#exact-width")];
  await expect(exact).toHaveValue("auto");
  await expect(slider).toHaveAttribute("aria-valuetext", new RegExp(`^automatic: ${width}`));
  await exact.fill("9.5");
  await exact.press("Enter");
  await expectAddress(page, "width", "9.5");
  await page.getByLabel("Seed", { exact: true }).fill("moa");
  await expectAddress(page, "seed", "moa");
  await expectAddress(page, "width", "9.5");
  await row(page, "width").getByRole("button", { name: "Reset Width to auto" }).click();
  await expectAddress(page, "width", null);
  await expect(exact).toHaveValue("auto");
});

test("choices and sides that the word decides have an entry that says what is drawn @core", async ({ page }) => {
  await openUnfolded(page, "seed=rimu&country=coast&attractors=300&labels=none");
  const sides = new Map(engine.readLink("seed=rimu&country=coast&attractors=300").values).get("sides") ?? "";
  const land = page.getByRole("combobox", { name: "Land", exact: true });
  await expect(land).toHaveValue("auto");
  await expect(land.locator("option:checked")).toHaveText(/^auto: ./);
  const row = page.locator("[data-key=sides]");
  const auto = row.getByLabel("auto", { exact: true });
  await expect(auto).toBeChecked();
  for (const side of sides) await expect(row.locator(`[value=${side}]`)).toBeChecked();
  await auto.uncheck();
  await expectAddress(page, "sides", sides);
  await auto.check();
  await expectAddress(page, "sides", null);
});
