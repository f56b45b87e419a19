/** The looks inside a map: the key of each, and the sentence and legend that explain it. */

import { count } from "../../../browser/count.ts";
import { el } from "../../../browser/dom.ts";
import type { Overlay, OverlayName, Reaches } from "../../page-worker/protocol.ts";

export interface Look {
  name: OverlayName;
  key: string;
  label: string;
  /** True if it is available while the map grows, too. */
  isLive?: boolean;
  /** The growths that have it; all if undefined. */
  of?: readonly string[];
  /** Explains what one sees, for rivers of a growth. */
  sentence(growth: string): string;
  legend?(overlay: Overlay, growth: string): HTMLElement[];
}

/** The number of colours. Streams of this order and higher ones share the last. */
export const MOST_KINDS = 6;

export const LOOKS: readonly Look[] = [
  {
    name: "attractors",
    key: "A",
    label: "Attractors or parcels",
    isLive: true,
    // A Brownian tree has none.
    of: ["colonize", "drainage"],
    sentence: (growth) =>
      growth === "drainage"
        ? "Each dot is a parcel: a piece of land that drains to one of those beside it."
        : "Each dot is an attractor: a point that draws the nearest river towards it, until one comes near.",
    legend: ({ counts }, growth) => (counts ? attractorsLegend(counts, growth === "drainage") : []),
  },
  {
    name: "sources",
    key: "T",
    label: "Tips",
    isLive: true,
    sentence: () => "Each dot is a source: the tip of a stream, farthest from the sea.",
  },
  {
    name: "reach",
    key: "K",
    label: "Reach and kill",
    isLive: true,
    of: ["colonize"],
    sentence: () =>
      "If a river ended here, attractors in the large circle would draw it on, and those in the small one would be used up. Point to a place, or move the map.",
    legend: ({ reaches }) => (reaches ? reachesLegend(reaches) : []),
  },
  {
    name: "orders",
    key: "O",
    label: "Orders",
    sentence: () => "Streams by Strahler’s order: where two of the highest order meet, it rises by one.",
    legend: ({ kinds }) => ordersLegend(kinds.map((streams) => streams.length)),
  },
  {
    name: "basins",
    key: "B",
    label: "Basins",
    sentence: () => "Each area is the land of one river that reaches the sea: all its water goes there.",
  },
  {
    name: "flow",
    key: "D",
    label: "Direction of flow",
    sentence: () => "Arrows point downstream, each where a stream ends in a greater one or in the sea.",
  },
  {
    name: "curvature",
    key: "C",
    label: "Curvature",
    sentence: () =>
      "Lines across the great rivers point to the outside of each bend: the sharper the bend, the longer.",
  },
  {
    name: "captures",
    key: "X",
    label: "Captured streams",
    isLive: true,
    of: ["drainage"],
    sentence: () =>
      "Each dot is where one of the greatest captured streams was turned aside. Before, its water ran along the dashed line.",
  },
  {
    name: "held",
    key: "F",
    label: "Frozen courses",
    sentence: () => "These stretches stay where they are while others meander.",
  },
  {
    name: "masks",
    key: "M",
    label: "Masks",
    isLive: true,
    sentence: () => "What no river may cross: water, and the lines of ridges.",
  },
];

function attractorsLegend({ all, left }: { all: number; left: number }, isOfDrainage: boolean): HTMLElement[] {
  const [alive, dead] = isOfDrainage ? ["No way to the sea yet", "With a way"] : ["Alive", "Used up"];
  return [legendOf("dot", [`${alive}: ${count(left)}.`, 2], [`${dead}: ${count(all - left)}.`, 1])];
}

function reachesLegend({ reach, kill, kilometre }: Reaches): HTMLElement[] {
  const inWords = (length: number): string => `${(length / kilometre).toFixed(1)} km.`;
  return [legendOf("ring", [`Reach: ${inWords(reach)}`, 1], [`Kill: ${inWords(kill)}`, 2])];
}

function ordersLegend(counts: readonly number[]): HTMLElement[] {
  const row = (many: number, i: number): [string, number] => [
    `Order ${i + 1}: ${count(many)} ${many === 1 ? "stream" : "streams"}`,
    Math.min(i + 1, MOST_KINDS),
  ];
  return [legendOf("swatch", ...counts.map(row))];
}

/** Makes a legend: rows of words, each with a sample of its kind. */
function legendOf(mark: string, ...rows: readonly (readonly [words: string, kind: number])[]): HTMLElement {
  const row = ([words, kind]: readonly [string, number]): HTMLElement =>
    el("li", {}, el("span", { class: mark, "data-kind": kind, "aria-hidden": "true" }), words);
  return el("ul", {}, ...rows.map(row));
}
