/** The visitor's last choices in the Save dialog, remembered if the browser allows storage. */

import type { Keeper } from "../../../controls/disclosure.ts";
import { FORMAT_NAMES, type Format } from "../../../files/format-names.ts";
import { OWN_SIZES, PRINT_DPI, SHEETS, type Sheet, SIZES } from "../../../files/order.ts";

export type Kind = "png" | Format | "card" | "animation";
export const KINDS: readonly Kind[] = ["png", ...FORMAT_NAMES, "card", "animation"];

export type SizeName = keyof typeof SIZES | "own";
export const SIZE_NAMES: readonly SizeName[] = [...(Object.keys(SIZES) as (keyof typeof SIZES)[]), "own"];

/** A kind of file; the portrait is what *Send* makes. */
export type FileKind = Kind | "portrait";

/** The choices of the Save dialog. */
export interface Choices {
  kind: Kind;
  size: SizeName;
  /** The longer side of a picture of custom size, in pixels. */
  ownSize: number;
  isTransparent: boolean;
  hasNames: boolean;
  /** The longer side of a game pack's rasters, in pixels. */
  rasterSize: number;
  /** True if those rasters are squares. */
  isSquare: boolean;
}

/** The choices for a file, which may be of a kind that the dialog does not offer. */
export type FileChoices = Omit<Choices, "kind"> & { kind: FileKind };

/** The sizes of rasters: a power of two and one, as game engines ask for. */
export const RASTER_SIZES: readonly number[] = [1025, 2049, 4097];

const KEPT_AS = "riverseed-save";

/** The choices at first. */
export const FIRST: Choices = {
  kind: "png",
  size: "screen",
  ownSize: 3000,
  isTransparent: false,
  hasNames: true,
  rasterSize: 1025,
  isSquare: false,
};

export class SaveChoices {
  #now: Choices;

  constructor(private readonly keeper: () => Keeper) {
    this.#now = { ...FIRST, ...this.#kept() };
  }

  get now(): Readonly<Choices> {
    return this.#now;
  }

  set(changes: Partial<Choices>): void {
    this.#now = { ...this.#now, ...changes };
    try {
      this.keeper().setItem(KEPT_AS, JSON.stringify(this.#now));
    } catch {
      // The choice holds for this visit all the same.
    }
  }

  /** Returns the remembered choices that are still valid. Anything may be in the storage. */
  #kept(): Partial<Choices> {
    try {
      const kept: unknown = JSON.parse(this.keeper().getItem(KEPT_AS) ?? "{}");
      return typeof kept === "object" && kept !== null ? choicesOf(kept as Record<keyof Choices, unknown>) : {};
    } catch {
      return {};
    }
  }
}

function choicesOf(kept: Record<keyof Choices, unknown>): Partial<Choices> {
  const { kind, size, ownSize, isTransparent, hasNames, rasterSize, isSquare } = kept;
  const known = <Value>(value: unknown, all: readonly Value[]): Value | undefined => all.find((one) => one === value);
  const own = typeof ownSize === "number" ? ownSizeOf(String(ownSize)) : undefined;
  const read = {
    kind: known(kind, KINDS),
    size: known(size, SIZE_NAMES),
    ownSize: own,
    isTransparent: known(isTransparent, [true, false]),
    hasNames: known(hasNames, [true, false]),
    rasterSize: known(rasterSize, RASTER_SIZES),
    isSquare: known(isSquare, [true, false]),
  };
  return Object.fromEntries(Object.entries(read).filter(([, value]) => value !== undefined));
}

/** Reads a typed size; returns nothing if no picture can have it. */
export function ownSizeOf(text: string): number | undefined {
  const { min, max } = OWN_SIZES;
  const size = /^\s*\d{1,6}\s*$/.test(text) ? Number(text) : Number.NaN;
  return size >= min && size <= max ? size : undefined;
}

/** Returns the sheet of paper that the chosen picture fills, if any, and the dots per inch of pictures for print. */
export function paperOf({ size }: Pick<Choices, "size">): Partial<Omit<Sheet, "paper">> {
  // A custom size is one that somebody needs for print; screens do not ask for dots per inch.
  if (size === "own") return { dpi: PRINT_DPI };
  const { shorterSide, dpi } = SHEETS[size] ?? {};
  return shorterSide === undefined || dpi === undefined ? {} : { shorterSide, dpi };
}

/** Returns the longer side of the chosen picture, in pixels. */
export function longerSideOf({ size, ownSize }: Readonly<Pick<Choices, "size" | "ownSize">>): number {
  return size === "own" ? ownSize : SIZES[size];
}
