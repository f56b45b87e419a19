/**
 * Macros: sliders in plain words that set several parameters together, or a different parameter for each growth. They
 * set ordinary values: a link does not contain them.
 */

import { el, setText, setValue } from "../browser/dom.ts";
import { AUTO } from "../engine/link-text.ts";
import type { Parameter } from "../engine/table.ts";
import { nearestText, rangeOf } from "./values.ts";
import { stepByWheel } from "./wheel.ts";

export interface Macro {
  readonly name: string;
  readonly label: string;
  readonly help: string;
  /** A word for each stop, from the least to the most. */
  readonly words: readonly string[];
  readonly parts: readonly Part[];
  /** A value that has to be changed first for the macro to have an effect. */
  readonly unless?: { readonly key: string; readonly is: string; readonly becomes: string };
}

/** A parameter that a macro sets, with its values at evenly spaced stops. */
interface Part {
  readonly key: string;
  /** The growth that it applies to; all if undefined. */
  readonly growth?: string;
  readonly stops: readonly number[];
}

/**
 * The macros. They do not change how the network grows, except for the number of streams of Brownian trees. The middle
 * stop is the table's default.
 */
export const MACROS: readonly Macro[] = [
  {
    name: "rivers",
    label: "How many rivers",
    help: "How small a stream may be to be drawn.",
    words: ["very few", "few", "usual", "many", "very many"],
    parts: [
      { key: "trim", growth: "drainage", stops: [80, 36, 18, 9, 0] },
      { key: "channel-area", growth: "drainage", stops: [60, 12, 3, 2, 1] },
      { key: "tributary-spacing", growth: "drainage", stops: [4, 2.4, 1.6, 1, 0.4] },
      { key: "trim", growth: "colonize", stops: [120, 50, 18, 8, 0] },
      { key: "sensitivity", growth: "brownian", stops: [40, 24, 16, 11, 8] },
    ],
  },
  {
    name: "winding",
    label: "How winding",
    help: "How long the great rivers have meandered, and how much all others do.",
    words: ["straight", "calm", "usual", "winding", "very winding"],
    parts: [
      { key: "meander-rounds", stops: [0, 8, 18, 60, 160] },
      { key: "meander-elsewhere", stops: [0, 0.15, 0.3, 0.5, 0.8] },
    ],
    unless: { key: "meander", is: "none", becomes: "bend" },
  },
];

/** The number of steps of a macro's slider. */
const PLACES = 100;

/** Returns the values that a macro sets at a place from 0 to 1. */
export function valuesAt(
  macro: Macro,
  place: number,
  table: ReadonlyMap<string, Parameter>,
  values: ReadonlyMap<string, string>,
): [key: string, text: string][] {
  const { unless } = macro;
  const first =
    unless && values.get(unless.key) === unless.is ? [[unless.key, unless.becomes] as [string, string]] : [];
  const set = partsOf(macro, values).flatMap(({ key, stops }) => {
    const parameter = table.get(key);
    const range = parameter && rangeOf(parameter);
    return range ? [[key, nearestText(between(stops, place), range)] as [string, string]] : [];
  });
  return [...first, ...set];
}

/** Returns the place of a macro, from 0 to 1, by the value of its first part. */
export function placeOf(macro: Macro, values: ReadonlyMap<string, string>): number {
  const { unless } = macro;
  const [part] = partsOf(macro, values);
  if (!part || (unless && values.get(unless.key) === unless.is)) return 0;
  return placeAmong(part.stops, Number(values.get(part.key)));
}

/** Returns the keys of the parameters that a macro may set. */
export function keysOf({ parts, unless }: Macro): string[] {
  return [...parts.map(({ key }) => key), ...(unless ? [unless.key] : [])];
}

function partsOf({ parts }: Macro, values: ReadonlyMap<string, string>): Part[] {
  return parts.filter(({ growth }) => growth === undefined || growth === values.get("growth"));
}

/** Interpolates the value at a place from 0 to 1 among stops. */
function between(stops: readonly number[], place: number): number {
  const at = Math.min(Math.max(place, 0), 1) * (stops.length - 1);
  const i = Math.min(Math.floor(at), stops.length - 2);
  const [low = 0, high = 0] = [stops[i], stops[i + 1]];
  return low + (high - low) * (at - i);
}

/** Returns the place from 0 to 1 of a value among rising or falling stops. Values beyond the ends are clamped. */
function placeAmong(stops: readonly number[], value: number): number {
  const [first = 0, last = 0] = [stops[0], stops.at(-1)];
  const rises = last > first;
  const i = stops.findIndex((stop) => (rises ? stop >= value : stop <= value));
  if (i === 0) return 0;
  if (i < 0) return 1;
  const [low = 0, high = 0] = [stops[i - 1], stops[i]];
  return (i - 1 + (value - low) / (high - low)) / (stops.length - 1);
}

export interface MacroControl {
  readonly element: HTMLElement;
  show(map: Shown): void;
}

/** The values on show, what the link says of them, and what it says by default. */
interface Shown {
  values: ReadonlyMap<string, string>;
  asked: ReadonlyMap<string, string>;
  defaults: ReadonlyMap<string, string>;
}

/** Makes the slider of a macro, which shows its value as a word. */
export function macroControl(
  macro: Macro,
  table: ReadonlyMap<string, Parameter>,
  set: (values: readonly (readonly [key: string, text: string])[]) => void,
): MacroControl {
  const { name, label, help, words } = macro;
  const id = `macro-${name}`;
  const described = `${id}-help`;
  let values: ReadonlyMap<string, string> = new Map();
  let fallback: [key: string, text: string][] = [];
  const slider = el("input", { type: "range", id, min: 0, max: PLACES, step: 1, "aria-describedby": described });
  const word = el("span", { class: "value word" });
  const reset = el("button", { type: "button", class: "reset", "aria-label": `Reset ${label}` }, "reset");
  reset.addEventListener("click", () => {
    set(fallback);
    slider.focus();
  });
  const commit = (): void => set(valuesAt(macro, slider.valueAsNumber / PLACES, table, values));
  slider.addEventListener("input", commit);
  stepByWheel(slider, (direction) => {
    slider.valueAsNumber += direction;
    commit();
  });
  const head = el("div", { class: "control-head" }, el("label", { for: id }, label), reset, word);
  const element = el(
    "fieldset",
    { role: "none", class: "control", "data-macro": name, title: help },
    head,
    slider,
    el("p", { class: "help", id: described }, help),
  );
  slider.classList.add("field");
  return {
    element,
    show({ values: shown, asked, defaults }) {
      values = shown;
      fallback = keysOf(macro).flatMap((key) => changed(key, asked, defaults));
      reset.hidden = fallback.length === 0;
      const place = placeOf(macro, shown);
      // A slider that already stands for these values stays under the finger.
      const isThere = valuesAt(macro, slider.valueAsNumber / PLACES, table, shown).every(
        ([key, text]) => shown.get(key) === text,
      );
      if (!isThere) setValue(slider, String(Math.round(place * PLACES)));
      slider.style.setProperty("--share", String(slider.valueAsNumber / PLACES));
      const told = words[Math.round(place * (words.length - 1))] ?? "";
      const isAuto = partsOf(macro, shown).every(({ key }) => asked.get(key) === AUTO);
      setText(word, isAuto ? AUTO : told);
      slider.setAttribute("aria-valuetext", isAuto ? `automatic: ${told}` : told);
    },
  };
}

function changed(
  key: string,
  asked: ReadonlyMap<string, string>,
  defaults: ReadonlyMap<string, string>,
): [key: string, text: string][] {
  const [text, usual] = [asked.get(key), defaults.get(key)];
  return usual === undefined || text === usual ? [] : [[key, usual]];
}
