/**
 * The composition of a picture with a title: all of the land, and above it or at its left a box of open sea for the
 * title.
 */

/** Left, top, right and bottom. */
export type Edges = readonly [left: number, top: number, right: number, bottom: number];

export interface Composition {
  /** The part of the map that the picture shows, as `River.frame` takes it. No other name stands beside the title. */
  readonly framing: readonly number[];
  /** The box of the title, in pixels of the picture. */
  readonly title: Edges;
}

interface Sides {
  readonly width: number;
  readonly height: number;
}

/** The margin around everything, and the space between title and land, as shares of the picture's shorter side. */
const MARGIN = 0.055;
const GAP = 0.04;
/** The height of a title above the land, and the sides of one beside it, as shares of the free part of the picture. */
const ABOVE = 0.19;
const BESIDE = { width: 0.42, height: 0.36 };
/** How far names keep from the picture's sides, over its margin. */
const FROM_SIDES = 0.4;

/**
 * Returns what has to be shown of a map: the box around its land, or all of it if the land ends at its border, which is
 * seen then. In widths of the map.
 */
export function shownOf(land: Edges, aspect: number): Edges {
  /** Less than anybody sees. */
  const HAIR = 1e-3;
  const map: Edges = [0, 0, 1, 1 / aspect];
  return land.some((edge, i) => Math.abs(edge - (map[i] ?? 0)) < HAIR) ? map : land;
}

/**
 * Composes a picture whose sides are in pixels. `land` is what has to be shown of the map, in widths of the map. Of the two
 * places for the title it takes the one that shows the land larger.
 */
export function composed(picture: Sides, land: Edges): Composition {
  const shorter = Math.min(picture.width, picture.height);
  const free = inset([0, 0, picture.width, picture.height], MARGIN * shorter);
  const gap = GAP * shorter;
  const [above, beside] = [titleAbove(free, gap, land), titleBeside(free, gap, land)];
  const { title, corner, scale, covered } = beside.scale > above.scale ? beside : above;
  const least = FROM_SIDES * MARGIN * shorter;
  const [left, top] = [land[0] - corner[0] / scale, land[1] - corner[1] / scale];
  return {
    framing: [left, top, picture.width / scale, ...covered.map((depth) => Math.max(depth, least) / scale)],
    title,
  };
}

/** Where title and land stand. */
interface Place {
  title: Edges;
  /** The corner of the land on the picture, and the pixels that the map is wide. */
  corner: readonly [x: number, y: number];
  scale: number;
  /** How far the title reaches in from the left, the top, the right and the bottom of the picture. */
  covered: Edges;
}

/** Puts the title above the land, and both in the middle. */
function titleAbove([left, top, right, bottom]: Edges, gap: number, land: Edges): Place {
  const height = ABOVE * (bottom - top);
  const scale = scaleOf(land, right - left, bottom - top - height - gap);
  const [wide, high] = sizeOf(land, scale);
  const start = (top + bottom - height - gap - high) / 2;
  const title: Edges = [left, start, right, start + height];
  return {
    title,
    corner: [(left + right - wide) / 2, title[3] + gap],
    scale,
    covered: [0, title[3], 0, 0],
  };
}

/** Puts the title at the left of the land, which stands at the right. */
function titleBeside([left, top, right, bottom]: Edges, gap: number, land: Edges): Place {
  const [width, tall] = [BESIDE.width * (right - left), BESIDE.height * (bottom - top)];
  const scale = scaleOf(land, right - left - width - gap, bottom - top);
  const [wide, high] = sizeOf(land, scale);
  const corner = [right - (right - left - width - gap + wide) / 2, (top + bottom - high) / 2] as const;
  const title: Edges = [left, (top + bottom - tall) / 2, left + width, (top + bottom + tall) / 2];
  return { title, corner, scale, covered: [title[2], 0, 0, 0] };
}

/** Returns how many pixels wide the map may be for its land to fit. */
function scaleOf(land: Edges, width: number, height: number): number {
  const [wide, high] = sizeOf(land, 1);
  return Math.min(width / wide, height / high);
}

function sizeOf([left, top, right, bottom]: Edges, scale: number): readonly [width: number, height: number] {
  return [(right - left) * scale, (bottom - top) * scale];
}

function inset([left, top, right, bottom]: Edges, by: number): Edges {
  return [left + by, top + by, right - by, bottom - by];
}
