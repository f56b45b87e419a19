/**
 * What most pages never need: the studio on the page itself, in slices, where workers are refused; and what to do when there is
 * none at all.
 */

import { load } from "../engine/wasm.ts";
import type { Backend, News } from "./orders.ts";
import { Studio } from "./studio.ts";

export { advice } from "../engine/advice.ts";

export async function open(tell: (news: News) => void, wasmUrl: string | undefined): Promise<Backend> {
  const studio = new Studio(await load(wasmUrl), tell);
  // The engine is the one that the page's script holds: it stays.
  return { isReplaceable: false, take: (order) => studio.take(order), close: () => {} };
}
