import { expect, test, vi } from "vitest";
import { Engines, isBare } from "../../../src/apps/widget/engines.ts";
import { presets } from "../../../src/engine/parameters.json";
import { engine, memory } from "../../core.ts";

const [BARE, LABELLING, WHOLE] = ["make", "label", "whole"].map((name) => ({ engine, memory, name }));
const { loads } = vi.hoisted(() => ({ loads: [] as string[] }));

vi.mock("../../../src/engine/make.ts", () => ({ load: loader("make", () => BARE) }));
vi.mock("../../../src/engine/label.ts", () => ({ loadLabel: loader("label", () => LABELLING) }));
vi.mock("../../../src/engine/whole.ts", () => ({ loadWhole: loader("whole", () => WHOLE) }));

function loader(name: string, loaded: () => unknown) {
  return (url?: string) => {
    loads.push(url ? `${name} from ${url}` : name);
    return Promise.resolve(loaded());
  };
}

const PLAIN = { text: "seed=kauri&attractors=100&labels=none", letters: "" };
const NAMED = { text: "seed=kauri&attractors=100", letters: "" };
const CARRIED = { ...NAMED, letters: "BCD" };

test("a link that is bare asks for no labels, title, woods or hills, however it is written", () => {
  const styles = ["ink", "atlas", "survey", "blueprint", "ink-wash"];
  for (const labels of ["", "none", "None", "few", "many", "nonsense"])
    for (const more of ["", "cartouche=none", "cartouche=plain", "woods=0.5", "hills=1", "woods=0", "labels=many"])
      for (const style of styles) {
        const link = new URLSearchParams(`seed=kauri&attractors=10&style=${style}&${more}`);
        if (labels !== "") link.append("labels", labels);
        const river = new engine.River(`${link}`);
        if (isBare(`${link}`)) expect(river.isAnnotated, `${link}`).toBe(false);
        river.free();
      }
  for (const link of [PLAIN.text, `?${PLAIN.text}`, `${PLAIN.text}&cartouche=none`])
    expect(isBare(link), link).toBe(true);
  for (const { name } of presets) expect(isBare(`${PLAIN.text}&preset=${name}`)).toBe(false);
});

test("a bare map has the smallest engine until one asks for more, and what is there does for all", async () => {
  loads.length = 0;
  const engines = await Engines.open({ wasmUrl: undefined, link: PLAIN });
  expect([engines.makerFor(PLAIN), loads]).toEqual([BARE, ["make"]]);
  expect(await engines.makerFor(NAMED)).toBe(LABELLING);
  // A river stays where it is, unless it wants what is not there.
  expect([engines.makerFor(PLAIN), engines.makerFor(PLAIN, BARE)]).toEqual([LABELLING, BARE]);
  expect([engines.makerFor(NAMED, BARE), engines.makerFor(NAMED, LABELLING)]).toEqual([LABELLING, LABELLING]);
  expect(loads).toEqual(["make", "label"]);
});

test("a map with labels never loads the smallest engine, and once all of it is there nothing more", async () => {
  loads.length = 0;
  const address = "https://cdn.example/widget/riverseed_bg.wasm";
  const engines = await Engines.open({ wasmUrl: address, link: NAMED });
  expect(engines.makerFor(PLAIN)).toBe(LABELLING);
  expect(await engines.whole()).toBe(WHOLE);
  const beside = (name: string): string => `from https://cdn.example/widget/riverseed_${name}_bg.wasm`;
  expect(loads).toEqual([`label ${beside("label")}`, `whole ${beside("engine")}`]);
});

test("only the larger engines read what may be no link", async () => {
  loads.length = 0;
  const engines = await Engines.open({ wasmUrl: undefined, link: { ...CARRIED, options: { values: "" } } });
  expect([engines.makerFor(PLAIN), loads]).toEqual([LABELLING, ["label"]]);
});

test("a map that carries its letters has the smallest engine, and the next one if they do not hold", async () => {
  loads.length = 0;
  const engines = await Engines.open({ wasmUrl: undefined, link: CARRIED });
  expect([engines.makerFor(CARRIED), engines.makerFor(CARRIED, BARE), loads]).toEqual([BARE, BARE, ["make"]]);
  expect(await engines.makerFor({ ...CARRIED, letters: "" }, BARE)).toBe(LABELLING);
  expect([engines.makerFor(CARRIED), loads]).toEqual([LABELLING, ["make", "label"]]);
});

test("a map whose country has woods has the next engine, once the smallest one has found them", async () => {
  loads.length = 0;
  const engines = await Engines.open({ wasmUrl: undefined, link: PLAIN });
  expect(await engines.makerFor({ ...PLAIN, isAnnotated: true }, BARE)).toBe(LABELLING);
  expect([engines.makerFor(PLAIN, BARE), loads]).toEqual([BARE, ["make", "label"]]);
});
