/** The lines that a person draws, as many points as the pen gave: what undo goes back over. */

import type { Lines } from "../engine/types.ts";

export type LineKind = "coast" | "ridge";

export interface Line {
  readonly kind: LineKind;
  /** x and y in turn, in fractions of the map's width and height. */
  readonly points: readonly number[];
}

/** Points nearer than this add nothing but work. */
const NEAREST = 0.001;

export class Sketch {
  #lines: readonly Line[] = [];
  #past: (readonly Line[])[] = [];
  #live: { kind: LineKind; points: number[] } | undefined;

  /** All lines, the one under the pen included. */
  get lines(): readonly Line[] {
    return this.#live ? [...this.#lines, this.#live] : this.#lines;
  }

  get counts(): Counts {
    const ridges = this.lines.filter(({ kind }) => kind === "ridge").length;
    return { coasts: this.lines.length - ridges, ridges };
  }

  /** Whether the pen is down. */
  get isLive(): boolean {
    return this.#live !== undefined;
  }

  get canUndo(): boolean {
    return this.#past.length > 0;
  }

  /** Takes lines over from elsewhere; undo takes them back one by one. */
  open({ coasts, ridges }: Lines): void {
    const line = (kind: LineKind) => (points: Float32Array) => ({ kind, points: [...points] });
    const lines = [...coasts.map(line("coast")), ...ridges.map(line("ridge"))];
    this.#live = undefined;
    this.#past = lines.map((_, i) => lines.slice(0, i));
    this.#lines = lines;
  }

  /** Puts other lines in the place of all; undo brings the old ones back. */
  replace({ coasts, ridges }: Lines): void {
    const before = this.#lines;
    const past = this.#past;
    this.open({ coasts, ridges });
    this.#past = [...past, before];
  }

  begin(kind: LineKind, x: number, y: number): void {
    this.#live = { kind, points: [inside(x), inside(y)] };
  }

  /** Draws on to a place. Returns whether that is far enough from the last to matter. */
  extend(x: number, y: number): boolean {
    const points = this.#live?.points;
    if (!points) return false;
    const [nextX, nextY] = [inside(x), inside(y)];
    const [lastX = 0, lastY = 0] = points.slice(-2);
    if (Math.abs(nextX - lastX) < NEAREST && Math.abs(nextY - lastY) < NEAREST) return false;
    points.push(nextX, nextY);
    return true;
  }

  /** Lifts the pen. A mere touch is no line. */
  end(): void {
    const live = this.#live;
    this.#live = undefined;
    if (live && live.points.length >= 4) this.#become([...this.#lines, live]);
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

/** The points of all lines of a kind, for the core. */
export function pointsOf(lines: readonly Line[], kind: LineKind): Float32Array[] {
  return lines.filter((line) => line.kind === kind).map((line) => Float32Array.from(line.points));
}

/** A pen that leaves the map draws along its border: land that does so runs on beyond. */
function inside(x: number): number {
  return Math.min(1, Math.max(0, x));
}

/** How many lines there are. */
export interface Counts {
  readonly coasts: number;
  readonly ridges: number;
}

/** How many of all lines were kept, in words. */
export function tally({ coasts, ridges }: Lines, all: Counts): string {
  const counted = (count: number, one: string) => `${count} ${one}${count === 1 ? "" : "s"}`;
  const share = (kept: number, of: number, one: string) => (kept < of ? `${kept} of ` : "") + counted(of, one);
  const points = [...coasts, ...ridges].reduce((sum, line) => sum + line.length / 2, 0);
  const kept = [share(coasts.length, all.coasts, "coast")];
  if (all.ridges > 0) kept.push(share(ridges.length, all.ridges, "ridge"));
  return `${kept.join(" and ")}, ${counted(points, "point")}`;
}
