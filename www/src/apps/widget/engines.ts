/**
 * The engines of an element's rivers: the smallest that paints a map, and the whole one for what no other does. Each can do
 * all that the one before can, so a larger one that is there is taken.
 */

import { loadLabel } from "../../engine/label.ts";
import { load as loadMake } from "../../engine/make.ts";
import { limited, SCRIPT_MS } from "../../engine/time-limits.ts";
import type { River } from "../../engine/types.ts";
import type { WholeCore } from "../../engine/whole.ts";
import type { LinkToRead, RiverMaker } from "../../player/river-player.ts";
import type { Init } from "./protocol.ts";

type Maker = RiverMaker<River>;

/** The names of the larger engines in the package. */
const LABEL = "riverseed_label_bg.wasm";
const WHOLE = "riverseed_engine_bg.wasm";

export class Engines {
  #bare: Maker | undefined;
  #labelling: Maker | undefined;

  private constructor(private readonly wasmUrl: string | undefined) {}

  /** Loads the engine of the first map. Calls `progress` for every part that arrives. */
  static async open({ wasmUrl, link }: Init, progress: () => void = () => {}): Promise<Engines> {
    const engines = new Engines(wasmUrl);
    if (needsNoNames(link)) engines.#bare = await loadMake(wasmUrl, progress);
    else await engines.#labels(progress);
    return engines;
  }

  /** Returns an engine for the map of a link: `now` if that will do, or else one that is there. */
  makerFor(link: LinkToRead, now?: Maker): Maker | Promise<Maker> {
    const isBareEnough = needsNoNames(link);
    if (now && (now !== this.#bare || isBareEnough)) return now;
    const bare = isBareEnough ? this.#bare : undefined;
    return this.#labelling ?? bare ?? this.#labels();
  }

  /** Loads the whole engine. */
  async whole(): Promise<WholeCore> {
    const { loadWhole } = await limited(SCRIPT_MS, "its script", () => import("../../engine/whole.ts"));
    const whole = await loadWhole(this.#beside(WHOLE));
    this.#labelling ??= whole;
    return whole;
  }

  async #labels(progress?: () => void): Promise<Maker> {
    const labelling = await loadLabel(this.#beside(LABEL), progress);
    this.#labelling ??= labelling;
    return this.#labelling;
  }

  #beside(name: string): string | undefined {
    return this.wasmUrl && new URL(name, this.wasmUrl).href;
  }
}

/** Returns whether the smallest engine may do for a map: it is asked for by a link, and has no names, or carries its letters. */
function needsNoNames({ text, options, letters, isAnnotated }: LinkToRead): boolean {
  return !isAnnotated && options?.values === undefined && (Boolean(letters) || isBare(text));
}

/**
 * Returns whether a link asks for no labels, title, woods or hills. Nothing has read it yet, so one that could is taken for one that
 * does: a preset, for example, or a word that there is none of. Woods may still be drawn by the country of its word; the smallest engine
 * finds that out, and leaves the map to a larger one.
 */
export function isBare(link: string): boolean {
  const values = new URLSearchParams(link);
  const isOff = (key: string, off: readonly string[]): boolean =>
    values.getAll(key).every((text) => off.includes(text));
  return (
    values.get("labels") === "none" &&
    !values.has("preset") &&
    isOff("labels", ["none"]) &&
    isOff("cartouche", ["auto", "none"]) &&
    isOff("woods", ["0"]) &&
    isOff("hills", ["0"])
  );
}
