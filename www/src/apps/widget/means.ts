/** What a renderer of widgets makes rivers with, and how it makes their files. */

import type { River } from "../../engine/types.ts";
import type { Core } from "../../engine/wasm.ts";
import { pngOf, svgOf } from "../../files/files.ts";
import type { Means } from "../../host/renderer.ts";
import { loadCharts, loadFull } from "./late.ts";
import type { Question } from "./protocol.ts";

/** The address is that of the engine, if it is not beside the script; a step that takes long is announced. */
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
      // The lean engine writes no files.
      const full = await loadFull(wasmUrl);
      return svgOf(new full.engine.River(text, options), { ...maker, holdOn });
    },
  };
}
