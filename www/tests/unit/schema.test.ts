import { readFileSync } from "node:fs";
import { Ajv2020 } from "ajv/dist/2020.js";
import { expect, test } from "vitest";
import { table } from "../table.ts";
import { engine } from "../whole.ts";

const schema = JSON.parse(readFileSync(new URL("../../../src/export/network.schema.json", import.meta.url), "utf8"));
const validate = new Ajv2020({ strict: true, allErrors: true, allowUnionTypes: true }).compile(schema);

// biome-ignore lint/suspicious/noExplicitAny: what is tested is whether it has the form that it should have
type Network = any;

/** The JSON form of a link's finished rivers, as it comes back from a file. */
function networkOf(link: string): Network {
  const river = new engine.River(link);
  while (river.advance(1000));
  const network = river.network();
  river.free();
  return JSON.parse(JSON.stringify(network));
}

const WITH_LAKES =
  "seed=kauri&land=rectangle&aspect=1.5&growth=colonize&valleys=0&attractors=1500&trim=39&great-rivers=16&flat-share=1&meander-elsewhere=1&meander-rounds=90&meander-strength=1&neck=4&oxbows=1&meander=bend";
const LINKS = [
  WITH_LAKES,
  "seed=kauri&land=rectangle&attractors=600",
  "seed=kea&land=archipelago&attractors=600&mouths=9&curl=0.9&stretch=5&meander=flow&style=atlas",
  "seed=totara&land=island&growth=brownian&sensitivity=40&trim=50",
  // Land shut off from the sea: no rivers at all.
  "land=drawn&roughness=0&aspect=1&attractors=100&outline=.MzMzzMMzzMzMMzzM..M1M1zKM1zKzKM1zKM1M1..M4M4zHM4zHzHM4zHM4M4",
];

function wrong(network: Network): string[] {
  validate(network);
  return (validate.errors ?? []).map(({ instancePath, message }) => `${instancePath} ${message}`);
}

for (const link of LINKS) {
  test(`what is written is valid, with attractors and without: ${link}`, () => {
    const network = networkOf(link);
    expect(wrong(network)).toEqual([]);
    expect(wrong({ ...network, attractors: { x: [1, 2.5], y: [3, 4] } })).toEqual([]);
  }, 60_000);
}

test("lakes are among what is written", () => {
  expect(networkOf(WITH_LAKES).oxbows.length).toBeGreaterThan(10);
}, 60_000);

test("what is not of the form is refused, where it is not", () => {
  const network = { ...networkOf(WITH_LAKES), attractors: { x: [1], y: [2] } };
  const wrongs: [string, unknown][] = [
    ["/recipe/seed", 7],
    ["/recipe/aspect", 5],
    ["/recipe/style", "neon"],
    ["/resolved/spacing", "12"],
    ["/domain/width", -1],
    ["/growth/complete", "yes"],
    ["/measures/tokunaga-c", "many"],
    ["/pattern/radial", -1],
    ["/nodes/parent/0", -2],
    ["/nodes/order/0", 0],
    ["/rivers/0/parent", "none"],
    ["/rivers/0/points/0", [1, 2]],
    ["/oxbows/0/born", 1.5],
    ["/attractors/x/0", null],
  ];
  for (const [place, value] of wrongs) {
    const bad = structuredClone(network);
    const path = place.split("/").slice(1);
    const last = path.pop() ?? "";
    path.reduce((inner: Network, name) => inner[name], bad)[last] = value;
    expect(wrong(bad).map((error) => error.split(" ")[0])).toEqual([place]);
  }
}, 60_000);

/** Returns whether the country may decide a parameter, so that a recipe need not hold it. */
function isDecided(name: string): boolean {
  return table.parameters.some(({ key, decided }) => key === name && decided);
}

test("no member may be missing, and none be there that is not told of", () => {
  const network = { ...networkOf(WITH_LAKES), attractors: { x: [1], y: [2] } };
  const places: ((network: Network) => Network)[] = [
    (network) => network,
    ({ recipe }) => recipe,
    ({ resolved }) => resolved,
    ({ domain }) => domain,
    ({ growth }) => growth,
    ({ measures }) => measures,
    ({ pattern }) => pattern,
    ({ nodes }) => nodes,
    ({ rivers }) => rivers[0],
    ({ oxbows }) => oxbows[0],
    ({ attractors }) => attractors,
  ];
  for (const place of places) {
    const more = structuredClone(network);
    place(more).more = 1;
    expect(wrong(more)).toHaveLength(1);
    const isRecipe = place(network) === network.recipe;
    const mayBeLeftOut = (name: string): boolean => name === "attractors" || (isRecipe && isDecided(name));
    for (const name of Object.keys(place(network)).filter((name) => !mayBeLeftOut(name))) {
      const less = structuredClone(network);
      delete place(less)[name];
      expect(wrong(less), name).toHaveLength(1);
    }
  }
}, 60_000);
