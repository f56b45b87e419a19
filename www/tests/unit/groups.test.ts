import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { grouped, isAdjustable } from "../../src/controls/controls.ts";
import { table } from "../table.ts";

const PAGE = new URL("../../../docs/parameters.md", import.meta.url);

test("what the default way of growing uses stands before what only others use", () => {
  const headings = [...grouped(table.parameters.filter(isAdjustable)).keys()];
  expect(headings.slice(0, 4)).toEqual(["Land", "Growth", "Drainage", "Bends"]);
});

test("the panel holds every parameter once, in the order of the page of parameters", () => {
  const groups = grouped(table.parameters);
  expect([...groups.values()].flat().map(({ key }) => key)).toHaveLength(table.parameters.length);
  const page = readFileSync(PAGE, "utf8");
  const written = [...page.matchAll(/^## (.*)$/gm)]
    .map(([, heading]) => heading ?? "")
    .filter((one) => groups.has(one));
  const adjustable = [...groups.keys()].filter((heading) => heading !== "Seed");
  expect(written.filter((heading) => heading !== "Seed")).toEqual(adjustable);
});
