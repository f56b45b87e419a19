/** Finds the things that have a name, or could have one, at a place of a finished map. */

import { type Kind, kindOf } from "../../engine/mark.ts";
import type { Inspector, LabelFacts } from "../../engine/types.ts";
import { awayFrom, nearest, type Shape } from "./picking.ts";
import type { Nameable, NameablePlace } from "./protocol.ts";

/** A place of a map, with its width. */
export interface Placed extends Nameable {
  size: number;
}

/** The knowledge that the question is answered from. */
export interface Known {
  inspector: Pick<Inspector, "at" | "of" | "areaAt">;
  /** Width and height of the map, in units. */
  size: readonly [width: number, height: number];
  /** Names by mark. */
  names: ReadonlyMap<string, string>;
  places: readonly Placed[];
}

type Near = Nameable & Shape;
type Spot = Exclude<NameablePlace, { mark: string }>;

/** Things by whose point or line they are hit. A river is nearer than the crest of a range, which nobody sees. */
const POINTS: readonly Kind[] = ["cape", "bay", "strait"];

/** Areas, which have no line of their own. */
const AREAS: readonly Kind[] = ["sea", "lake", "land", "island"];

/** Returns the meanders and places of a map, with their names. */
export function placedOn(inspector: Pick<Inspector, "places">, names: ReadonlyMap<string, string>): Placed[] {
  return inspector.places().map(({ mark, size, line }) => ({
    mark,
    kind: kindOf(mark),
    name: names.get(mark) ?? "",
    line,
    size,
  }));
}

/**
 * Returns what is at a place: names, rivers and points of places, the nearest first; then ranges and bays around it, and
 * last the sea, the lake or the land that it is in. Of a mark it returns the thing itself.
 */
export function nameablesAt(place: NameablePlace, known: Known, labels: readonly LabelFacts[]): Nameable[] {
  if ("mark" in place) return [thingOf(place.mark, known, labels)].filter((thing) => thing !== undefined);
  const letters = place.hasLabels ? labels.flatMap((label) => labelled(label, known)) : [];
  const areas = areaAround(place, known).map((area) => asNamed(area, letters));
  const around = [...rangesAround(place, known), ...baysAround(place, known), ...areas];
  return unlike([...near(place, known, letters), ...around]);
}

function near(spot: Spot, known: Known, letters: readonly Near[]): Near[] {
  const { inspector, size, names, places } = known;
  const river = inspector.at(spot.x, spot.y, spot.reach * size[0]);
  const rivers: Near[] = river ? [riverAt(river, names)] : [];
  const points = places.filter(({ kind }) => POINTS.includes(kind)).map(asLine);
  return nearest([...letters, ...rivers, ...points], spot, spot.reach, tallness(known));
}

function rangesAround(spot: Spot, known: Known): Near[] {
  const ranges = known.places.filter(({ kind }) => kind === "range").map(asLine);
  return nearest(ranges, spot, spot.reach, tallness(known));
}

function baysAround(spot: Spot, known: Known): Placed[] {
  const tall = tallness(known);
  const away = (bay: Placed): number => awayFrom(bay, spot, tall);
  return known.places
    .filter((place) => place.kind === "bay" && away(place) <= place.size / 2)
    .sort((one, other) => away(one) - away(other));
}

function areaAround({ x, y }: Spot, { inspector, places }: Known): Placed[] {
  const mark = inspector.areaAt(x, y);
  return places.filter((place) => place.mark === mark);
}

function thingOf(mark: string, known: Known, labels: readonly LabelFacts[]): Nameable | undefined {
  const { inspector, names, places } = known;
  const place = places.find((place) => place.mark === mark);
  if (place)
    return isArea(place)
      ? asNamed(
          place,
          labels.flatMap((label) => labelled(label, known)),
        )
      : place;
  const river = /^\d+$/.test(mark) ? inspector.of(Number(mark)) : undefined;
  if (river) return riverAt(river, names);
  const label = labels.find((label) => label.mark === mark);
  const name = names.get(mark);
  if (name === undefined || !isMap(mark)) return undefined;
  return { mark, kind: "map", name, ...(label ? { line: label.line, em: label.em } : { line: [] }) };
}

function riverAt({ mark, x, y }: { mark: number; x: number; y: number }, names: Known["names"]): Near {
  return { mark: `${mark}`, kind: "river", name: names.get(`${mark}`) ?? "", line: [x, y], half: 0 };
}

function isArea({ kind }: Placed): boolean {
  return AREAS.includes(kind);
}

/** Returns an area as its name on the picture, if that is among the letters: a line through its midst would strike it out. */
function asNamed(area: Placed, letters: readonly Near[]): Nameable {
  return letters.find(({ mark }) => mark === area.mark) ?? area;
}

function asLine(place: Placed): Near {
  return { ...place, half: 0 };
}

/** Returns what a label names. Labels of places have no mark, but say their name, maybe without its article. */
function labelled({ mark, text, em, line }: LabelFacts, { names, places }: Known): Near[] {
  const says = ({ name }: Placed): boolean => name === text || name === `The ${text}`;
  const place = places.find((place) => (mark === "" ? says(place) : place.mark === mark));
  const letters = { line, em, half: em / 2, isSpaced: true };
  if (place) return [{ mark: place.mark, kind: place.kind, name: place.name, ...letters }];
  const kind = isMap(mark) ? "map" : "river";
  return mark === "" ? [] : [{ mark, kind, name: names.get(mark) ?? "", ...letters }];
}

function isMap(mark: string): boolean {
  return mark === "t";
}

/** Leaves out what was there before, and all that only picking needs. */
function unlike(things: readonly Nameable[]): Nameable[] {
  const isFirst = ({ mark }: Nameable, i: number): boolean => things.findIndex((other) => other.mark === mark) === i;
  const told = ({ mark, kind, name, line, em }: Nameable): Nameable => ({
    mark,
    kind,
    name,
    line,
    ...(em ? { em } : {}),
  });
  return things.filter(isFirst).map(told);
}

function tallness({ size: [width, height] }: Known): number {
  return height / width;
}
