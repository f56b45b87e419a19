/**
 * What most pages never need: the renderer on the page itself, in slices, where workers are refused; and what to do when there is
 * none at all.
 */

import { load } from "../../engine/wasm.ts";
import type { Backend } from "../../host/protocol.ts";
import { Renderer } from "../../host/renderer.ts";
import { meansOf } from "./means.ts";
import type { Question, Report } from "./protocol.ts";

export { advice } from "../../engine/advice.ts";

export async function open(tell: (report: Report) => void, wasmUrl: string | undefined): Promise<Backend<Question>> {
  const renderer = new Renderer(meansOf(await load(wasmUrl), wasmUrl), tell);
  // The engine is the one that the page's script holds: it stays.
  return { isReplaceable: false, take: (command) => renderer.take(command), close: () => {} };
}
