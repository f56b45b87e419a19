/** The page's renderer on the page itself, in slices, for browsers that refuse workers. */

import type { WholeCore } from "../../engine/whole.ts";
import type { Backend, Report } from "../../host/protocol.ts";
import { Renderer } from "../../host/renderer.ts";
import { meansOf } from "./means.ts";
import type { Answer, Question } from "./protocol.ts";

export function open(core: WholeCore, tell: (report: Report<Answer>) => void): Backend<Question> {
  const renderer = new Renderer(meansOf(core), tell);
  // The engine belongs to the page, and stays.
  return { isReplaceable: false, take: (command) => renderer.take(command), close: () => {} };
}
