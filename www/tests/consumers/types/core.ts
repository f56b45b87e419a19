/** The engine by itself: a river without an element. */

import { load, type Summary } from "riverseed/core";

export async function numbersOf(link: string): Promise<Summary> {
  const { engine } = await load("/riverseed_bg.wasm");
  const river = new engine.River(engine.readLink(link).link);
  while (river.advance(1000));
  const summary = river.summary();
  river.free();
  return summary;
}
