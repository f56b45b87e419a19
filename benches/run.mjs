#!/usr/bin/env node
// Prints the project's figures, each beside its floor and its aim: natively, as wasm in Node, and in the page.
//
//   make bench                    everything
//   node benches/run.mjs WORD…    only groups whose names contain a word; scripts/wasm.mjs figures must have run
//
// The machine may be busy, so times are those that a process spent on a processor, where that can be known (native: on
// Linux). What is compared runs in turn, ratios are taken within a turn, and their median counts.
//
// groups/ says what is measured: a group has the two sides (sides.mjs) do tasks (workload.rs), mostly in turn (turns.mjs), and yields lines
// of the table (table.mjs).

import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

import { GROUPS as annotation } from "./groups/annotation.mjs";
import { GROUPS as drawing } from "./groups/drawing.mjs";
import { GROUPS as files } from "./groups/files.mjs";
import { GROUPS as growth } from "./groups/growth.mjs";
import { GROUPS as maps } from "./groups/maps.mjs";
import { GROUPS as page } from "./groups/page.mjs";
import { GROUPS as relief } from "./groups/relief.mjs";
import { GROUPS as rivers } from "./groups/rivers.mjs";
import { nativeSide, wasmSide } from "./sides.mjs";
import { printHeading, printLine } from "./table.mjs";

process.chdir(join(dirname(fileURLToPath(import.meta.url)), ".."));

const words = process.argv.slice(2).map((word) => word.toLowerCase());
const isChosen = ([name]) => words.length === 0 || words.some((word) => name.toLowerCase().includes(word));
const groups = Object.entries({
  ...growth,
  ...drawing,
  ...rivers,
  ...relief,
  ...maps,
  ...annotation,
  ...files,
  ...page,
});

const missed = [];
const sides = { native: await nativeSide(), wasm: wasmSide() };
try {
  console.log(
    "N uniform attractors, one mouth, reach R spacings, kill and step ½ spacing, no trimming; growth is timed",
  );
  console.log("from the recipe to the last node. Processor time, medians.");
  for (const [name, measure] of groups.filter(isChosen)) {
    printHeading(name);
    for await (const line of measure(sides)) {
      if (printLine(line)) missed.push(line.what);
    }
  }
} finally {
  sides.native.close();
}
console.log(
  missed.length === 0 ? "\nAll floors that were measured are met." : `\nMISSED ${missed.length}: ${missed.join("; ")}`,
);
