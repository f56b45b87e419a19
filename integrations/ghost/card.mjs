#!/usr/bin/env node
// Prints the HTML card of a map, and writes its picture and the element's files into the folder `riverseed`, for systems that build nothing.
//
//   node card.mjs kauri --site /assets/ [--alt TEXT]     --site is where that folder will be

import { parseArgs } from "node:util";
import { baseOf, copyElement, embed, html, RiverSeedError } from "./river-seed.mjs";

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: { site: { type: "string", default: "/" }, alt: { type: "string" } },
});

try {
  console.log(html(await embed(positionals[0], { folder: "riverseed", base: baseOf(values.site), alt: values.alt })));
  await copyElement("riverseed");
} catch (error) {
  if (!(error instanceof RiverSeedError)) throw error;
  console.error(error.message);
  process.exitCode = 1;
}
