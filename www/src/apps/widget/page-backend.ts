/**
 * Code that most pages never need: the renderer on the page itself, in slices, for browsers that refuse workers; and
 * the advice after a failure.
 */

import { named } from "../../engine/errors.ts";
import type { Backend } from "../../host/protocol.ts";
import { Renderer } from "../../host/renderer.ts";
import { Engines } from "./engines.ts";
import { meansOf } from "./means.ts";
import type { Init, Question, Report } from "./protocol.ts";

export { advice } from "../../engine/advice.ts";

export async function open(tell: (report: Report) => void, init: Init): Promise<Backend<Question>> {
  const engines = await Engines.open(init).catch((thrown: unknown) => {
    throw named(thrown);
  });
  const renderer = new Renderer(meansOf(engines), tell);
  // The engine belongs to the page's script, and stays.
  return { isReplaceable: false, take: (command) => renderer.take(command), close: () => {} };
}
