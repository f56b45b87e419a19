/** Describes a river in words: the caption, the picture's text alternative, and the sentence of the finished state. */

import { type Count, count } from "../browser/count.ts";
import type { Phase, Summary } from "../engine/types.ts";
import type { State } from "./frame-loop.ts";

function counted(value: number, one: string, many: string, written: Count): string {
  return `${written(value)} ${value === 1 ? one : many}`;
}

function oxbowsOf(summary: Summary, written: Count): string {
  return counted(summary.oxbows, "oxbow lake", "oxbow lakes", written);
}

/** Writes the network's size in words. */
export function sizeOf(summary: Summary, written: Count): string {
  const rivers = counted(summary.mouths, "river", "rivers", written);
  const sources = counted(summary.sources, "source", "sources", written);
  const oxbows = summary.oxbows === 0 ? "" : `, ${oxbowsOf(summary, written)}`;
  return `${rivers}, ${sources}, Strahler order ${written(summary.order)}${oxbows}`;
}

/** Counts the attractors, or parcels of drainage, that no river reaches. A Brownian tree has neither. */
function unreachedOf({ growth, attractors, unreached }: Summary): string {
  if (attractors === 0) return "";
  const name = growth === "drainage" ? "parcel" : "attractor";
  return `; ${count(unreached)} of ${counted(attractors, name, `${name}s`, count)} unreached`;
}

/** Gives the numbers of a finished map: its size, how many nodes growth made, and how much it did not reach. */
export function numbersOf(summary: Summary): string {
  const nodes = counted(summary.nodes, "node", "nodes", count);
  return `${sizeOf(summary, count)}, ${nodes}${unreachedOf(summary)}.`;
}

/** Writes the sentence of the finished state. */
export function sentence(summary: Summary): string {
  return `${sizeOf(summary, count)}.${summary.stopped ? ` ${summary.stopped}` : ""}`;
}

/** Writes the text alternative of the picture; it has a size once it is finished. */
export function alternative(seed: string, phase: Phase, summary: Summary, written: Count): string {
  const size = phase === "finished" ? sizeOf(summary, written) : `still ${doing(phase)}`;
  return `River network grown from the seed “${seed}”: ${size}.`;
}

/** Names a phase. The step between growing and meandering is too short to have a name. */
function doing(phase: Phase): string {
  if (phase === "relief") return "raising the land";
  if (phase === "drowning") return "drowning its valleys";
  return phase === "meandering" ? "meandering" : "growing";
}

/** Returns the line under the map's title. That of a finished map may be empty, for the caller to fill. */
export function caption(state: State, phase: Phase, summary: Summary): string {
  if (state === "finished") return summary.stopped ?? "";
  return state === "paused" ? `Paused while ${doing(phase)}` : headed(doing(phase));
}

function headed(word: string): string {
  return word.charAt(0).toUpperCase() + word.slice(1);
}
