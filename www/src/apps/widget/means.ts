/** The means by which a renderer of widgets makes rivers and their files. */

import type { River } from "../../engine/types.ts";
import { pngOf, svgOf } from "../../files/files.ts";
import type { Means } from "../../host/renderer.ts";
import type { LinkToRead } from "../../player/river-player.ts";
import type { Engines } from "./engines.ts";
import type { Question } from "./protocol.ts";

/** Returns the means. `holdOn` is called before a long step. */
export function meansOf(engines: Engines, holdOn: () => void = () => {}): Means<River, Question, Blob> {
  return {
    makerFor: (link, now) => engines.makerFor(link, now),
    async answer({ link: { text, options }, format, longSide }) {
      if (format === "png") {
        const { river, memory } = await riverWithAll(engines, { text, ...(options && { options }) });
        return pngOf(river, { memory, holdOn }, longSide);
      }
      const { engine } = await engines.whole();
      return svgOf(new engine.River(text, options), { holdOn });
    },
  };
}

/** Makes the river of a link, in an engine that paints all of its map: its country may have woods that the link does not name. */
async function riverWithAll(engines: Engines, link: LinkToRead): Promise<{ river: River; memory: WebAssembly.Memory }> {
  const maker = await engines.makerFor(link);
  const river = new maker.engine.River(link.text, link.options);
  const able = river.isAnnotated ? await engines.makerFor({ ...link, isAnnotated: true }, maker) : maker;
  if (able === maker) return { river, memory: maker.memory };
  river.free();
  return { river: new able.engine.River(link.text, link.options), memory: able.memory };
}
