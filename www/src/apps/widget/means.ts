/** The means by which a renderer of widgets makes rivers and their files. */

import type { Core } from "../../engine/make.ts";
import type { River } from "../../engine/types.ts";
import { pngOf, svgOf } from "../../files/files.ts";
import type { Means } from "../../host/renderer.ts";
import { loadTeller, loadWriter } from "./late.ts";
import type { Question } from "./protocol.ts";

/**
 * Returns the means. `wasmUrl` is the engine's address if it is not beside the script; `holdOn` is called before a long
 * step.
 */
export function meansOf(
  { engine, memory }: Core,
  wasmUrl: string | undefined,
  holdOn: () => void = () => {},
): Means<River, Question, Blob> {
  const maker = { engine, memory, loadTeller: () => loadTeller(wasmUrl), loadWriter: () => loadWriter(wasmUrl) };
  return {
    maker,
    async answer({ link: { text, options }, format, longSide }) {
      if (format === "png") return pngOf(new engine.River(text, options), { ...maker, holdOn }, longSide);
      return svgOf(new engine.River(text, options), { ...maker, holdOn });
    },
  };
}
