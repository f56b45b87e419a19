/** The means by which a renderer of widgets makes rivers and their files. */

import type { River } from "../../engine/types.ts";
import { pngOf, svgOf } from "../../files/files.ts";
import type { Means } from "../../host/renderer.ts";
import type { Engines } from "./engines.ts";
import type { Question } from "./protocol.ts";

/** Returns the means. `holdOn` is called before a long step. */
export function meansOf(engines: Engines, holdOn: () => void = () => {}): Means<River, Question, Blob> {
  return {
    makerFor: (link, now) => engines.makerFor(link, now),
    async answer({ link: { text, options }, format, longSide }) {
      if (format === "png") {
        const { engine, memory } = await engines.makerFor({ text });
        return pngOf(new engine.River(text, options), { memory, holdOn }, longSide);
      }
      const { engine } = await engines.whole();
      return svgOf(new engine.River(text, options), { holdOn });
    },
  };
}
