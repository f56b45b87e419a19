/** The means by which a renderer of widgets makes rivers and their files. */

import type { River } from "../../engine/types.ts";
import type { Core } from "../../engine/wasm.ts";
import { pngOf, svgOf } from "../../files/files.ts";
import type { Means } from "../../host/renderer.ts";
import { loadCharts, loadFull } from "./late.ts";
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
  const maker = { engine, memory, loadCharts: () => loadCharts(wasmUrl) };
  return {
    maker,
    async answer({ link: { text, options }, format, longSide, wasmUrl }) {
      if (format === "png") return pngOf(new engine.River(text, options), { ...maker, holdOn }, longSide);
      // The lean engine cannot write files.
      const full = await loadFull(wasmUrl);
      return svgOf(new full.engine.River(text, options), { ...maker, holdOn });
    },
  };
}
