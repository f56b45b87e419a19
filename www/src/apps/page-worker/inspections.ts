/**
 * Answers questions about the rivers of a finished map by an inspector, which is made for the first question and kept
 * for that map. Overlays of unfinished maps come from the river itself.
 */

import { dotsOf, linesOf, ringsOf } from "../../browser/path-text.ts";
import type { Inspector } from "../../engine/types.ts";
import type { WholeRiver } from "../../engine/whole.ts";
import type { RiverPlayer } from "../../player/river-player.ts";
import { nameablesAt, type Placed, placedOn } from "./nameables.ts";
import type {
  LiveOverlayName,
  NameablePlace,
  Nameables,
  Overlay,
  OverlayName,
  PointedRiver,
  RiverPlace,
} from "./protocol.ts";

type Player = RiverPlayer<WholeRiver>;

/** The time for making a relief before other messages are handled. */
const SLICE_MS = 8;
/** The number of colours of basins. */
const BASIN_KINDS = 6;

interface Inspected {
  inspector: Inspector;
  size: readonly [width: number, height: number];
  /** Names by mark. */
  names: ReadonlyMap<string, string>;
  places: readonly Placed[];
}

interface Kept {
  player: Player;
  link: string;
  made: Promise<Inspected | undefined>;
}

export class Inspections {
  #kept: Kept | undefined;

  /**
   * Returns the river at a place of a player's map; none if there is none, or if the map is not finished or has changed
   * meanwhile.
   */
  async river(player: Player | undefined, place: RiverPlace): Promise<PointedRiver | undefined> {
    if (player?.state !== "finished") return;
    const kept = this.#keptFor(player);
    const inspected = await kept.made;
    if (!inspected || this.#kept !== kept || player.link !== kept.link) return;
    const { inspector, size, names } = inspected;
    const river =
      "mark" in place ? inspector.of(Number(place.mark)) : inspector.at(place.x, place.y, place.reach * size[0]);
    if (!river) return;
    const nameOf = (mark: number): string => names.get(String(mark)) ?? "";
    const into = Array.from(river.into, nameOf);
    const { isBasinSmall, lake, ...facts } = river;
    const basin = isBasinSmall ? "" : river.basin;
    // A mark means the whole river, which is shown from its source.
    const orderHere = "mark" in place ? river.order : river.orderHere;
    return {
      ...facts,
      basin,
      orderHere,
      link: kept.link,
      size,
      mark: String(river.mark),
      name: nameOf(river.mark),
      into,
      ...(lake && { lake: { ...lake, name: names.get(lake.mark) ?? "" } }),
    };
  }

  /** Returns what has a name, or could have one, at a place of a player's map; none if it is not finished or has changed. */
  async nameables(player: Player | undefined, place: NameablePlace): Promise<Nameables | undefined> {
    if (player?.state !== "finished") return;
    const kept = this.#keptFor(player);
    const inspected = await kept.made;
    if (!inspected || this.#kept !== kept || player.link !== kept.link) return;
    const { link } = kept;
    const { labels } = player;
    const labelled = labels.map(({ mark }) => mark);
    return { link, size: inspected.size, things: nameablesAt(place, inspected, labels), labelled };
  }

  /** Returns an overlay of a player's map, if there is one of this name. */
  async overlay(player: Player | undefined, name: OverlayName): Promise<Overlay | undefined> {
    if (player?.river && isLive(name)) return live(player.river, player.link, name);
    if (isLive(name) || player?.state !== "finished") return;
    const kept = this.#keptFor(player);
    const inspected = await kept.made;
    if (!inspected || !player.river || this.#kept !== kept || player.link !== kept.link) return;
    const { inspector, size } = inspected;
    return { link: kept.link, size, kinds: overlays[name](inspector) };
  }

  #keptFor(player: Player): Kept {
    const kept = this.#kept;
    if (kept?.player === player && kept.link === player.link) return kept;
    // Questions that still wait for the old one get no answer. Its inspector is freed, if it was made.
    kept?.made.then(
      (inspected) => inspected?.inspector.free(),
      () => {},
    );
    const made = this.#make(player, player.link);
    const next = { player, link: player.link, made };
    this.#kept = next;
    const forget = (): void => {
      if (this.#kept === next) this.#kept = undefined;
    };
    made.then((inspected) => inspected ?? forget(), forget);
    return next;
  }

  /** Makes the inspector of a map, once its relief is there, which determines basins. */
  async #make(player: Player, link: string): Promise<Inspected | undefined> {
    const river = (): WholeRiver | undefined =>
      player.link === link && player.state === "finished" ? player.river : undefined;
    while (riseFor(river(), SLICE_MS)) await new Promise((done) => setTimeout(done));
    return inspected(river());
  }
}

/** The lines of a finished map that each overlay shows, kind by kind. */
const overlays: Record<Exclude<OverlayName, LiveOverlayName>, (inspector: Inspector) => string[][]> = {
  orders,
  basins,
  flow: orders,
  held: (inspector) => [[inspector.held()]],
  curvature: (inspector) => [[inspector.curvature()]],
};

/** The points and lines of any map that the other overlays show. */
const liveOverlays: Record<LiveOverlayName, (river: WholeRiver) => string[][]> = {
  attractors,
  sources: (river) => [[dotsOf(river.tips())]],
  reach: attractors,
  cut: (river) => [[linesOf(river.cut())]],
  masks: (river) => [[ringsOf(river.coasts())], [linesOf(river.ridges())]],
  captures: (river) => {
    const ways = river.formerWays();
    return [[linesOf(ways)], [linesOf(ways.map((way) => way.slice(0, 2)))]];
  },
};

function isLive(name: OverlayName): name is LiveOverlayName {
  return name in liveOverlays;
}

function live(river: WholeRiver, link: string, name: LiveOverlayName): Overlay {
  const laid = { link, size: sizeOf(river), kinds: liveOverlays[name](river) };
  if (name !== "attractors" && name !== "reach") return laid;
  const { attractors: all, unreached: left } = river.summary();
  return { ...laid, counts: { all, left }, reaches: river.lengths() };
}

/** Returns all attractors, and on top of them those that are left. */
function attractors(river: WholeRiver): string[][] {
  return [[dotsOf(river.scattered())], [dotsOf(river.left())]];
}

function sizeOf(river: WholeRiver): [width: number, height: number] {
  const { width, height } = river.lengths();
  return [width, height];
}

/** Returns the streams of all orders. */
function orders(inspector: Inspector): string[][] {
  const all: string[][] = [];
  for (let order = 1; ; order++) {
    const ofOrder = inspector.streams(order);
    if (ofOrder.length === 0) return all;
    all.push(ofOrder);
  }
}

/** Returns the basins of the rivers that reach the sea, distributed over `BASIN_KINDS` kinds. */
function basins(inspector: Inspector): string[][] {
  const kinds: string[][] = Array.from({ length: BASIN_KINDS }, () => []);
  for (const [i, mark] of inspector.mouths().entries()) kinds[i % BASIN_KINDS]?.push(inspector.of(mark)?.basin ?? "");
  return kinds;
}

/** Makes a part of the relief, which determines basins. Returns whether there is more to do. */
function riseFor(river: WholeRiver | undefined, milliseconds: number): boolean {
  const end = performance.now() + milliseconds;
  let isLeft = river?.raiseRelief() ?? false;
  while (isLeft && performance.now() < end) isLeft = river?.raiseRelief() ?? false;
  return isLeft;
}

function inspected(river: WholeRiver | undefined): Inspected | undefined {
  const inspector = river?.inspector();
  if (!river || !inspector) return;
  const names = new Map(inspector.names());
  return { inspector, size: sizeOf(river), names, places: placedOn(inspector, names) };
}
