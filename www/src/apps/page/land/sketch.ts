/** The lines that a visitor draws, with all points of the pen, and their undo history. */

import type { Lines } from "../../../engine/whole.ts";

/** The kinds of lines, in the order of their tools. */
export const LINE_KINDS = ["coast", "ridge", "river"] as const;
export type LineKind = (typeof LINE_KINDS)[number];

export interface Line {
  readonly kind: LineKind;
  /** Alternating x and y, in fractions of the map's width and height. */
  readonly points: readonly number[];
}

/** The least distance of two points, below which more points add nothing. */
const NEAREST = 0.001;

export class Sketch {
  #lines: readonly Line[] = [];
  #past: (readonly Line[])[] = [];
  #live: { kind: LineKind; points: number[] } | undefined;

  /** All lines, including the one under the pen. */
  get lines(): readonly Line[] {
    return this.#live ? [...this.#lines, this.#live] : this.#lines;
  }

  get counts(): Counts {
    const of = (kind: LineKind) => this.lines.filter((line) => line.kind === kind).length;
    return { coasts: of("coast"), ridges: of("ridge"), rivers: of("river") };
  }

  /** True while the pen is down. */
  get isLive(): boolean {
    return this.#live !== undefined;
  }

  get canUndo(): boolean {
    return this.#past.length > 0;
  }

  /** Takes lines over from elsewhere; undo removes them one by one. */
  open({ coasts, ridges, rivers }: Lines): void {
    const line = (kind: LineKind) => (points: Float32Array) => ({ kind, points: [...points] });
    const lines = [...coasts.map(line("coast")), ...ridges.map(line("ridge")), ...rivers.map(line("river"))];
    this.#live = undefined;
    this.#past = lines.map((_, i) => lines.slice(0, i));
    this.#lines = lines;
  }

  /** Replaces all lines; undo brings the old ones back. */
  replace(lines: Lines): void {
    const before = this.#lines;
    const past = this.#past;
    this.open(lines);
    this.#past = [...past, before];
  }

  begin(kind: LineKind, x: number, y: number): void {
    this.#live = { kind, points: [inside(x), inside(y)] };
  }

  /** Extends the line to a place. Returns whether that is far enough from the last point to matter. */
  extend(x: number, y: number): boolean {
    const points = this.#live?.points;
    if (!points) return false;
    const [nextX, nextY] = [inside(x), inside(y)];
    const [lastX = 0, lastY = 0] = points.slice(-2);
    if (Math.abs(nextX - lastX) < NEAREST && Math.abs(nextY - lastY) < NEAREST) return false;
    points.push(nextX, nextY);
    return true;
  }

  /** Lifts the pen. A mere touch is dropped, except as the mouth of a river. */
  end(): void {
    const live = this.#live;
    this.#live = undefined;
    if (live && (live.points.length >= 4 || live.kind === "river")) this.#become([...this.#lines, live]);
  }

  /** Forgets the line under the pen. */
  cancel(): void {
    this.#live = undefined;
  }

  undo(): void {
    this.#live = undefined;
    this.#lines = this.#past.pop() ?? this.#lines;
  }

  clear(): void {
    this.#live = undefined;
    if (this.#lines.length > 0) this.#become([]);
  }

  #become(lines: readonly Line[]): void {
    this.#past.push(this.#lines);
    this.#lines = lines;
  }
}

/** Returns the points of all lines of a kind, for the core. */
export function pointsOf(lines: readonly Line[], kind: LineKind): Float32Array[] {
  return lines.filter((line) => line.kind === kind).map((line) => Float32Array.from(line.points));
}

/** Clamps a coordinate to the map. Land along the border continues beyond it. */
function inside(x: number): number {
  return Math.min(1, Math.max(0, x));
}

/** The number of lines of each kind. */
export interface Counts {
  readonly coasts: number;
  readonly ridges: number;
  /** Undefined for a traced picture, which has none. */
  readonly rivers?: number;
}

/** Says in words how many of all lines were kept. */
export function tally({ coasts, ridges, rivers }: Lines, all: Counts): string {
  const counted = (count: number, one: string) => `${count} ${one}${count === 1 ? "" : "s"}`;
  const share = (kept: number, of: number, one: string) => (kept < of ? `${kept} of ` : "") + counted(of, one);
  const points = [...coasts, ...ridges, ...rivers].reduce((sum, line) => sum + line.length / 2, 0);
  const kinds = [
    [coasts, all.coasts, "coast"],
    [ridges, all.ridges, "ridge"],
    [rivers, all.rivers ?? 0, "river"],
  ] as const;
  const shown = kinds.filter(([, drawn]) => drawn > 0);
  const kept = shown.map(([lines, drawn, one]) => share(lines.length, drawn, one));
  return `${kept.join(" and ")}, ${counted(points, "point")}`;
}
