/**
 * The parameters as attributes. The keys are listed here because a browser asks an element's class what to observe
 * before the engine is loaded. A unit test compares the lists with the core's table.
 */

import prefixed from "./prefixed.json" with { type: "json" };

/** Parameters whose values are numbers; below, those whose values are text. */
// biome-ignore format: a list of words
export const NUMBERS = [
  "edition", "aspect", "span", "sea", "drowning", "roughness", "mouths", "mouth-spacing", "sensitivity", "attractors", "reach", "kill", "step", "momentum",
  "curl", "stretch", "valleys", "valley-spacing", "concavity", "captures", "hardness", "hardness-scale", "bending",
  "bending-variation", "strike", "center-x", "center-y", "fall", "channel-area", "head-variation", "trim", "trim-variation", "tributary-spacing", "simplify", "width", "bank-variation", "deltas", "waves", "meander-rounds", "meander-strength", "meander-mix", "meander-elsewhere",
  "great-rivers", "flat-share", "neck", "oxbows", "clearance", "taper", "mountains", "plains", "rills", "lakes", "shade", "warmth", "rain", "rain-shadow", "wind", "label-size", "language", "woods", "hills",
] as const;
export const TEXTS = [
  "seed",
  "country",
  "land",
  "outline",
  "sides",
  "shores",
  "growth",
  "scatter",
  "pattern",
  "courses",
  "meander",
  "ground",
  "labels",
  "names",
  "cartouche",
  "style",
] as const;

/** Keys that mean something else in HTML; as attributes they have a prefix. `scripts/manifest.mjs` reads the file, too. */
const PREFIXED: ReadonlySet<string> = new Set(prefixed);

export function attributeOf(key: string): string {
  return PREFIXED.has(key) ? `river-${key}` : key;
}
