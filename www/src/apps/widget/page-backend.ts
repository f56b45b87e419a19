/**
 * Code that most pages never need: the renderer on the page itself, in slices, for browsers that refuse workers; and
 * the advice after a failure.
 */

import { named } from "../../engine/errors.ts";
import { load } from "../../engine/make.ts";
import type { Backend } from "../../host/protocol.ts";
import { Renderer } from "../../host/renderer.ts";
import { meansOf } from "./means.ts";
import type { Question, Report } from "./protocol.ts";

export { advice } from "../../engine/advice.ts";

export async function open(tell: (report: Report) => void, wasmUrl: string | undefined): Promise<Backend<Question>> {
  const core = await load(wasmUrl).catch((thrown: unknown) => {
    throw named(thrown);
  });
  const renderer = new Renderer(meansOf(core, wasmUrl), tell);
  // The engine belongs to the page's script, and stays.
  return { isReplaceable: false, take: (command) => renderer.take(command), close: () => {} };
}
