/** On a server there is no browser: importing the package does nothing there, and markup is rendered as text. */

import { spawnSync } from "node:child_process";
import { createElement } from "react";
import { renderToString } from "react-dom/server";
import { expect, test } from "vitest";
import { createSSRApp, h } from "vue";
import { renderToString as renderVue } from "vue/server-renderer";
import { pictureOf } from "../core.ts";
import { engine } from "../whole.ts";
import { CONSUMERS } from "./installed.ts";

/** More than any program here writes: files of a map have a megabyte and more. */
const MOST_BYTES = 64_000_000;

/** A program in Node, in a process of its own: nothing of the test runner's is there. */
function runs(program: string): string {
  const words = ["--input-type=module", "--eval", program];
  const { stdout, stderr } = spawnSync(process.execPath, words, {
    cwd: CONSUMERS,
    encoding: "utf8",
    maxBuffer: MOST_BYTES,
  });
  return stdout + stderr;
}

for (const entry of ["riverseed", "riverseed/define", "riverseed/river-seed.js", "riverseed/core", "riverseed/node"]) {
  test(`${entry} can be imported, and leaves the server as it was`, () => {
    const program = `
      const before = Object.getOwnPropertyNames(globalThis).join();
      await import("${entry}");
      console.log(before === Object.getOwnPropertyNames(globalThis).join());`;
    expect(runs(program)).toBe("true\n");
  });
}

test("the engine grows rivers on a server that hands it the wasm", () => {
  const program = `
    import { readFileSync } from "node:fs";
    import { createRequire } from "node:module";
    import { load } from "riverseed/core";
    const wasm = createRequire(import.meta.url).resolve("riverseed/riverseed_bg.wasm");
    const { engine } = await load("data:application/wasm;base64," + readFileSync(wasm, "base64"));
    const river = new engine.River("seed=kauri");
    while (river.advance(1000));
    console.log(river.summary().sources);`;
  expect(runs(program)).toBe(`${pictureOf("seed=kauri", 60, 40).summary.sources}\n`);
});

interface Feature {
  properties: Record<string, unknown>;
}

const NAMED = "seed=kauri&attractors=300&labels=many&names=t.Home&woods=0.5&style=ink";

test("in Node a link becomes an SVG file, GeoJSON and names, as the page makes them", () => {
  const program = `
    import { grow } from "riverseed/node";
    const map = grow("${NAMED}");
    const { link, summary } = map;
    console.log(JSON.stringify({ link, sources: summary.sources, svg: map.svg(), geojson: map.geojson(), names: map.names() }));
    map.free();`;
  const made = JSON.parse(runs(program));
  const river = new engine.River(NAMED);
  while (river.advance(1000));
  expect(made.svg).toBe(river.svg());
  while (river.raiseRelief());
  expect(made.geojson).toEqual(JSON.parse(JSON.stringify(river.geojson())));
  expect(made.geojson.type).toBe("FeatureCollection");
  expect(made.link).toBe(river.link);
  expect(made.sources).toBe(river.summary().sources);
  const rivers = made.geojson.features.filter(({ properties }: Feature) => properties["name"] !== undefined);
  const known = new Set(made.names.map(({ name }: { name: string }) => name));
  expect(rivers.length).toBeGreaterThan(5);
  expect(
    rivers.map(({ properties }: Feature) => properties["name"]).filter((name: string) => !known.has(name)),
  ).toEqual([]);
  expect(made.names).toContainEqual({ mark: "t", name: "Home", isOwn: true });
  river.free();
});

test("in Node parameters are listed with their ranges, and a link beyond them is refused by name", () => {
  const program = `
    import { grow, PageError, parameters } from "riverseed/node";
    const { min, max } = parameters().find(({ key }) => key === "curl");
    try {
      grow("seed=kauri&curl=" + (max + 1) + "&whatever=1");
    } catch (error) {
      console.log(JSON.stringify([min, max, error instanceof PageError, error.code, error.message]));
    }`;
  expect(JSON.parse(runs(program))).toEqual([
    0,
    2,
    true,
    "bad-params",
    expect.stringMatching(/curl: 3 .*0 and 2.*whatever/),
  ]);
});

test("React renders it as text, beside an import of it", () => {
  const program = 'import "riverseed/define"; console.log("imported")';
  expect(runs(program)).toBe("imported\n");
  const post = createElement("river-seed", { seed: "kauri", "river-width": 20 });
  expect(renderToString(post)).toBe('<river-seed seed="kauri" river-width="20"></river-seed>');
});

test("Vue renders it as text", async () => {
  const post = createSSRApp({ render: () => h("river-seed", { seed: "kauri", "river-width": 20 }) });
  expect(await renderVue(post)).toBe('<river-seed seed="kauri" river-width="20"></river-seed>');
});
