/** Goes back and forth through the making of a map, in the renderer. */

import type { Timeline, WholeRiver } from "../../engine/whole.ts";
import type { RiverPlayer } from "../../player/river-player.ts";
import type { Making, Moment } from "./protocol.ts";

type Player = RiverPlayer<WholeRiver>;

/** The time for steps before other messages are handled. */
const SLICE_MS = 8;

interface Kept {
  player: Player;
  link: string;
  timeline: Timeline;
}

export class Timelines {
  #kept: Kept | undefined;
  /** Counts the requests to go somewhere. */
  #wishes = 0;

  async making(player: Player | undefined, to: Moment | undefined): Promise<Making | undefined> {
    if (!player?.river) return;
    const kept = this.#keptFor(player);
    if (kept && to) await this.#go(kept, to);
    const { river, link } = player;
    if (!river) return;
    // The sea rises before the first bend, and relief and lakes come after the last.
    const within = { drowning: 0, relief: 1 } as Partial<Record<typeof river.phase, number>>;
    const progress = within[river.phase] ?? river.progress;
    return { link, at: river.moment(), progress, lengths: kept?.timeline.making() };
  }

  /** Returns the timeline of a map, which is kept from when the map is first finished until there is another map. */
  #keptFor(player: Player): Kept | undefined {
    const kept = this.#kept;
    if (kept?.player === player && kept.link === player.link) return kept;
    kept?.timeline.free();
    this.#kept = undefined;
    const timeline = player.state === "finished" ? player.river?.timeline() : undefined;
    if (timeline) this.#kept = { player, link: player.link, timeline };
    return this.#kept;
  }

  /** Goes to a moment, and shows the map on the way as often as time allows. */
  async #go(kept: Kept, { part, step }: Moment): Promise<void> {
    const wish = ++this.#wishes;
    const { player, link, timeline } = kept;
    const river = (): WholeRiver | undefined =>
      wish === this.#wishes && this.#kept === kept && player.link === link ? player.river : undefined;
    player.hold();
    while (advance(river(), SLICE_MS, (river) => river.seek(timeline, part, step)))
      await new Promise((done) => setTimeout(done));
    if (!river()) return;
    if (part === "map") player.finish();
    else player.hold();
  }
}

/** Makes steps for some time. Returns whether there is more to do. */
function advance(river: WholeRiver | undefined, milliseconds: number, step: (river: WholeRiver) => boolean): boolean {
  if (!river) return false;
  const end = performance.now() + milliseconds;
  let isLeft = step(river);
  while (isLeft && performance.now() < end) isLeft = step(river);
  return isLeft;
}
