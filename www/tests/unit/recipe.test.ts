import { expect, test, vi } from "vitest";
import { isAdjustable } from "../../src/controls/controls.ts";
import { goingTo } from "../../src/controls/countries.ts";
import { isShown, unaskedChanges } from "../../src/controls/presets.ts";
import { Recipe } from "../../src/engine/recipe.ts";
import { engine } from "../core.ts";
import { table } from "../table.ts";

const { parameters, presets } = table;
const fresh = () => new Recipe(engine.readLink);

test("an empty link is the defaults and what its word decides, without a note", () => {
  const recipe = fresh();
  recipe.open("");
  expect(recipe.notices.size).toBe(0);
  for (const { key, decided, default: value } of parameters)
    expect(recipe.asked.get(key), key).toBe(decided ? "auto" : value);
  expect(recipe.asked).toEqual(recipe.defaults);
  recipe.open("country=usual");
  for (const { key, default: value } of parameters)
    if (key !== "country" && key !== "sea") expect(recipe.values.get(key), key).toBe(value);
  expect(recipe.values.get("sea")).toBe("0.72");
});

test("a word decides a country and its values, which the link does not name", () => {
  const recipe = fresh();
  const countries = new Set(
    ["Thornwick", "Kestrel", "Ithaca", "Kauri"].map((word) => {
      recipe.set([["seed", word]]);
      expect(recipe.link).toBe(`seed=${word}&edition=1`);
      expect(recipe.asked.get("country")).toBe("auto");
      return recipe.values.get("country");
    }),
  );
  expect(countries.size).toBeGreaterThan(2);
  expect(countries).not.toContain("auto");
});

test("what is named stays when the word changes, and what is taken back follows it again", () => {
  const recipe = fresh();
  recipe.open("seed=rimu");
  const usual = recipe.values.get("width");
  recipe.set([["width", "9.5"]]);
  recipe.set([["seed", "moa"]]);
  expect([recipe.link, recipe.values.get("width"), recipe.asked.get("width")]).toEqual([
    "seed=moa&edition=1&width=9.5",
    "9.5",
    "9.5",
  ]);
  recipe.set([
    ["seed", "rimu"],
    ["width", "auto"],
  ]);
  expect([recipe.link, recipe.values.get("width"), recipe.asked.get("width")]).toEqual([
    "seed=rimu&edition=1",
    usual,
    "auto",
  ]);
});

test("going back to what is shown names nothing else", () => {
  const recipe = fresh();
  recipe.open("seed=rimu&width=9.5");
  recipe.restore(recipe.shown);
  expect(recipe.link).toBe("seed=rimu&edition=1&width=9.5");
});

test("a value that stands for the usual one is named, and its value is what is drawn", () => {
  const recipe = fresh();
  recipe.open("land=island&sea=0");
  expect([recipe.asked.get("sea"), recipe.values.get("sea")]).toEqual(["0", "0.72"]);
});

test("going to a country names it, and takes back all that it decides but for what is kept", () => {
  const recipe = fresh();
  recipe.open("seed=rimu&edition=1&aspect=2&width=9.5&trim=40&land=island&labels=none");
  const [alps] = table.countries.filter(({ name }) => name === "alps");
  if (!alps) throw new Error("there are no alps");
  recipe.set(goingTo(alps, parameters, new Set(["width"])));
  expect(recipe.link).toBe("seed=rimu&edition=1&country=alps&aspect=2&width=9.5&labels=none");
});

test("a damaged link is opened mended, with a note that stays until it is dismissed", () => {
  const recipe = fresh();
  recipe.open("seed=rimu&amp;curl=0.6");
  recipe.set([["trim", "9"]]);
  expect(recipe.link).toBe("seed=rimu&edition=1&curl=0.6&trim=9");
  expect([...recipe.notices]).toEqual([["link", "the link was damaged on its way, and has been mended"]]);
  recipe.dismissNotices();
  expect(recipe.notices.size).toBe(0);
});

test("a word keeps its signs when it is typed", () => {
  const recipe = fresh();
  for (const word of ["Why?", "a=b&c#d", "100%25", "seed=rimu&land=valley", "x://y?land=valley"]) {
    recipe.set([["seed", word]]);
    expect(recipe.seed).toBe(word);
    recipe.open(recipe.link);
    expect([recipe.seed, recipe.notices.size]).toEqual([word, 0]);
  }
});

test("changing one value leaves the others", () => {
  const recipe = fresh();
  recipe.open("seed=two%20words%20%26%20more&curl=0.6");
  recipe.set([["trim", "9"]]);
  expect(recipe.seed).toBe("two words & more");
  expect(recipe.values.get("curl")).toBe("0.6");
  expect(recipe.values.get("trim")).toBe("9");
});

test("a note stays while other values change, and goes when its own does", () => {
  const recipe = fresh();
  recipe.open("curl=99");
  recipe.set([["trim", "9"]]);
  expect([...recipe.notices.keys()]).toEqual(["curl"]);
  recipe.set([["curl", "1"]]);
  expect(recipe.notices.size).toBe(0);
});

test("two notes about one key are both kept", () => {
  const recipe = fresh();
  recipe.open("curl=99&curl=1");
  expect(recipe.notices.get("curl")).toMatch(/99.*; /);
});

test("each preset is shown by its own values and by no other preset's", () => {
  for (const preset of presets) {
    const recipe = fresh();
    recipe.open("seed=rimu&attractors=900&curl=1.7&momentum=0.3&trim=40&growth=brownian");
    recipe.set(preset.values);
    const shown = presets.filter((one) => isShown(one, recipe.values));
    expect(shown.map(({ name }) => name)).toEqual([preset.name]);
    expect(recipe.seed).toBe("rimu");
    expect(recipe.values.get("attractors")).toBe("900");
  }
});

test("all presets name the same keys, so that one leaves nothing of another", () => {
  const [first, ...others] = presets.map(({ values }) => values.map(([key]) => key));
  for (const keys of others) expect(keys).toEqual(first);
});

test("a preset sets what it names, whatever another names and the table's defaults are", () => {
  const preset = { name: "bent", label: "Bent", help: "", values: [["curl", "1.5"]] } as const;
  const other = { name: "bare", label: "Bare", help: "", values: [["trim", "40"]] } as const;
  const { values } = engine.readLink("curl=1.5&trim=7");
  expect(isShown(preset, new Map(values))).toBe(true);
  expect(unaskedChanges(preset, [preset, other], parameters, new Map(values))).toBeUndefined();
});

test("what a preset changes unasked is told, in words", () => {
  const changes = (link: string, name: string): string | undefined => {
    const preset = presets.find((one) => one.name === name);
    if (!preset) throw new Error(`no preset ${name}`);
    return unaskedChanges(preset, presets, parameters, new Map(engine.readLink(link).values));
  };
  const said = changes("land=island&curl=1.5&trim=40&simplify=12&meander=flow&growth=brownian", "trimmed-curl");
  expect(said).toMatch(/^“Trimmed curl” also changed .*\.$/);
  expect(said).toContain("Simplify from 12 % to 0 %");
  expect(said).toContain("Meanders from “bends skew and travel” to “none”");
  expect(said).toContain("Growth from “");
  // What presets are there for, and what no preset touches.
  expect(said).not.toMatch(/Curl from|Trim from|Seed/);
  for (const { name } of presets) {
    expect(changes(`preset=${name}`, name)).toBeUndefined();
    expect(changes(`preset=original&land=island`, name)?.includes("Meanders") ?? false).toBe(false);
  }
});

test("a preset's button gives what the preset's link gives", () => {
  for (const preset of presets) {
    const byLink = engine.readLink(`preset=${preset.name}`).link;
    const recipe = fresh();
    recipe.open("");
    recipe.set(preset.values);
    expect(recipe.link).toBe(byLink);
  }
});

test("there is a control for everything but the seed and the outline, which have their own, and the edition, which has one value", () => {
  const without = parameters.filter((parameter) => !isAdjustable(parameter)).map(({ key }) => key);
  expect(without).toEqual(["seed", "edition", "outline"]);
});

test("fresh seeds are words that a link reads back", () => {
  for (let i = 0; i < 50; i++) {
    const seed = engine.freshSeed();
    expect(engine.readLink(`seed=${encodeURIComponent(seed)}`).notices).toEqual([]);
    expect(seed).toMatch(/^[\p{L}\p{N} '’-]{2,64}$/u);
  }
});

test("on a dark page a recipe without a style is shown in the dark one, and its link stays canonical", () => {
  const recipe = new Recipe(engine.readLink, "", () => true);
  recipe.open("seed=rimu");
  expect(recipe.link).toBe("seed=rimu&edition=1");
  expect(recipe.shown).toBe("seed=rimu&edition=1&style=night");
  expect(recipe.values.get("style")).toBe("night");
  recipe.set([["trim", "9"]]);
  expect(recipe.link).toBe("seed=rimu&edition=1&trim=9");
  recipe.restore(recipe.shown);
  expect(recipe.link).toBe("seed=rimu&edition=1&trim=9");
});

test("on a dark page a style that was chosen is shown, and told by the link, which is read back to the same", () => {
  const recipe = new Recipe(engine.readLink, "", () => true);
  for (const style of ["ink", "atlas", "dark"]) {
    recipe.open("seed=rimu");
    recipe.set([["style", style]]);
    expect(recipe.values.get("style")).toBe(style);
    expect(recipe.link).toBe(`seed=rimu&edition=1&style=${style}`);
    recipe.open(recipe.link);
    expect(recipe.values.get("style")).toBe(style);
    recipe.restore(recipe.shown);
    expect(recipe.values.get("style")).toBe(style);
  }
});

test("a style that was chosen on a light page is told by the link, and so it is shown on dark ones, too", () => {
  const recipe = fresh();
  recipe.open("seed=rimu");
  expect(recipe.link).toBe("seed=rimu&edition=1");
  recipe.set([["style", "atlas"]]);
  expect([recipe.link, recipe.shown]).toEqual(["seed=rimu&edition=1&style=atlas", "seed=rimu&edition=1"]);
  const onDark = new Recipe(engine.readLink, "", () => true);
  onDark.open(recipe.link);
  expect(onDark.values.get("style")).toBe("atlas");
});

test("when pages become dark, a style that was chosen stays, and where none was the dark one is the default", () => {
  let isDark = false;
  const recipe = new Recipe(engine.readLink, "", () => isDark);
  const flip = (): void => {
    isDark = !isDark;
    recipe.refresh();
  };
  const style = () => [recipe.values.get("style"), recipe.defaults.get("style")];
  recipe.open("seed=rimu");
  expect(style()).toEqual(["atlas", "atlas"]);
  flip();
  expect(style()).toEqual(["night", "night"]);
  flip();
  recipe.set([["style", "atlas"]]);
  recipe.restore(recipe.shown);
  flip();
  expect(style()).toEqual(["atlas", "night"]);
  expect(recipe.link).toBe("seed=rimu&edition=1&style=atlas");
});

test("what a widget does not grow is told, of a recipe that is shown whole", () => {
  const recipe = fresh();
  recipe.open("country=usual&attractors=90000");
  expect(recipe.values.get("attractors")).toBe("90000");
  expect(recipe.notices.size).toBe(0);
  expect(recipe.widgetNotices).toEqual([
    expect.stringMatching(/^attractors: 90000 exceeds the widget's limit: \d+ is used$/),
  ]);
  recipe.open("");
  expect(recipe.widgetNotices).toEqual([]);
});

test("a link is read once when it is opened, once a change, and the defaults when they are first asked for", () => {
  const readLink = vi.fn(engine.readLink);
  const recipe = new Recipe(readLink, "seed=rimu&aspect=2");
  expect([recipe.seed, recipe.aspect, recipe.link, recipe.shown.length > 0]).toEqual(["rimu", 2, recipe.shown, true]);
  expect(readLink).toHaveBeenCalledTimes(1);
  for (const sea of ["0.3", "0.4", "0.5"]) recipe.set([["sea", sea]]);
  expect(readLink).toHaveBeenCalledTimes(4);
  for (let i = 0; i < 2; i++)
    expect(recipe.defaults.get("aspect")).toBe(engine.readLink("").values.find(([key]) => key === "aspect")?.[1]);
  expect(readLink).toHaveBeenCalledTimes(5);
});
