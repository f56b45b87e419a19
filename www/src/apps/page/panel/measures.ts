/** Compares measures of the rivers on show with rivers of the world, in plain words. There is never a single score. */

import { el, setText } from "../../../browser/dom.ts";
import type { Disclosures } from "../../../controls/disclosure.ts";
import { named } from "../../../engine/errors.ts";
import type { MapPromise, Measure } from "../../../engine/types.ts";
import type { Measured } from "../../page-worker/protocol.ts";

/** A measure in words for people who are not hydrologists. */
interface Plain {
  name: string;
  label: string;
  /** The words for a value below and above the range in nature. */
  below: string;
  above: string;
}

const PLAIN: readonly Plain[] = [
  { name: "bifurcation-ratio", label: "Small streams for each larger one", below: "fewer", above: "more" },
  { name: "length-ratio", label: "How much longer each larger one is", below: "less", above: "more" },
  { name: "tokunaga-t1", label: "Side branches just below its size", below: "fewer", above: "more" },
  { name: "tokunaga-c", label: "How many more the smaller they are", below: "fewer", above: "more" },
  { name: "hack-exponent", label: "How long basins are drawn out", below: "rounder", above: "longer" },
  { name: "area-exponent", label: "How fast great valleys become rarer", below: "more slowly", above: "faster" },
  { name: "sinuosity", label: "How winding", below: "straighter", above: "more winding" },
  { name: "upstream-bends", label: "Bends that lean upstream", below: "", above: "" },
  { name: "junction-angle", label: "The angle at which rivers meet", below: "sharper", above: "wider" },
  { name: "tributary-angle", label: "The angle at which the smallest join", below: "", above: "" },
  { name: "junction-spacing", label: "How far from one junction to the next", below: "nearer", above: "farther" },
  { name: "nearest-line", label: "Beside its neighbour, or across", below: "more across", above: "more alongside" },
  { name: "turn-kurtosis", label: "Straight reaches and sudden bends", below: "fewer", above: "more" },
  { name: "turn-autocorrelation", label: "How bends follow each other", below: "more zigzag", above: "less zigzag" },
  { name: "gap-variation", label: "How uneven the gaps between rivers", below: "more even", above: "less even" },
  { name: "anisotropy", label: "How far neighbours go one way", below: "less", above: "more" },
  { name: "knots", label: "Rivers that crowd without joining", below: "", above: "" },
  { name: "hooks", label: "Brooks that are bent like fishhooks", below: "", above: "" },
  { name: "beside", label: "Rivers beside their valleys", below: "", above: "" },
  { name: "pattern", label: "Pattern", below: "", above: "" },
  { name: "umbrellas", label: "Trunks that meet like ribs of an umbrella", below: "", above: "" },
  { name: "parallels", label: "Rivers that run side by side", below: "", above: "" },
  { name: "along-coast", label: "Rivers that run along a coast", below: "", above: "" },
  { name: "coast-dimension", label: "How ragged coasts are", below: "", above: "" },
  { name: "lake-share", label: "Share of the land under lakes", below: "", above: "" },
  { name: "lake-exponent", label: "How fast large lakes become rarer", below: "", above: "" },
  { name: "deltas", label: "Great mouths with a delta", below: "", above: "" },
];

const NATURAL = "as in nature";
const TOO_SMALL = "too little to tell";

/** A row as it is shown and copied. */
export interface Told {
  label: string;
  help: string;
  value: string;
  /** The comparison with nature; empty if there is none. */
  verdict: string;
  nature: string;
  /** The places of the value and of nature's range on the bar, from 0 to 1. */
  bar?: { value: number; least: number; most: number } | undefined;
}

export function told(measures: readonly Measure[]): Told[] {
  return PLAIN.flatMap((plain) => {
    const measure = measures.find(({ name }) => name === plain.name);
    return measure ? [toldOf(measure, plain)] : [];
  });
}

function toldOf({ help: says, unit, places, value, distances, nature }: Measure, { label, below, above }: Plain): Told {
  const written = (number: number): string => `${number.toFixed(places)}${unit === "" ? "" : ` ${unit}`}`;
  const range = nature ? `${nature.least.toFixed(places)} to ${written(nature.most)} (${nature.source})` : "";
  const patterns = Object.entries(distances ?? {});
  const help = says || patterns.map(([name, far]) => `${name} ${far.toFixed(places)}`).join(", ");
  if (value === undefined) return { label, help, value: "", verdict: TOO_SMALL, nature: range };
  const row = { label, help, value: patterns[0]?.[0] ?? written(value), verdict: "", nature: range };
  if (!nature) return row;
  const { least, most } = nature;
  // Judged as it is written: nobody should read that 45 is less than 45.
  const shown = Number(value.toFixed(places));
  const verdict = shown < least ? `${below} than in nature` : shown > most ? `${above} than in nature` : NATURAL;
  return { ...row, verdict, bar: barOf(value, least, most) };
}

/** Places a value on a bar on which nature's range is the middle third. Values far off are at its ends. */
function barOf(value: number, least: number, most: number): Told["bar"] {
  const from = least - (most - least);
  const share = (value - from) / (3 * (most - least));
  return { value: Math.min(1, Math.max(0, share)), least: 1 / 3, most: 2 / 3 };
}

/** Sums up all rows in one sentence. */
export function summed(rows: readonly Told[]): string {
  const off = rows.filter(({ verdict }) => verdict.endsWith(" than in nature"));
  if (!rows.some(({ verdict }) => verdict === NATURAL || off.length > 0)) return "Too few rivers to measure.";
  if (off.length === 0) return "All that can be compared is as in nature.";
  const words = off.map(({ label, verdict }) => `${label.toLowerCase()}: ${verdict.replace(" than in nature", "")}`);
  return `As in nature, but for these: ${words.join("; ")}.`;
}

/** Says in one sentence which of the promises of every map this one keeps, and how much was looked at. */
export function kept(promises: readonly MapPromise[]): string {
  const broken = promises.filter(({ broken }) => broken > 0);
  if (broken.length > 0) {
    const words = broken.map(
      ({ says, broken: places }) => `${says}: broken in ${counted(places)} ${places === 1 ? "place" : "places"}.`,
    );
    return `This map breaks a promise. ${words.join(" ")}`;
  }
  const words = promises.map(({ says, counted: what, count }) => `${lowered(says)} (${counted(count)} ${what})`);
  return `Checked on this map: ${words.join(", ")}.`;
}

function counted(count: number): string {
  return count.toLocaleString("en");
}

function lowered(says: string): string {
  return says.charAt(0).toLowerCase() + says.slice(1);
}

/** Writes the rows as lines of text. */
export function asText(rows: readonly Told[]): string {
  const line = ({ label, value, verdict, nature }: Told): string =>
    [`${label}: ${value === "" ? verdict : value}`, value === "" ? "" : verdict, nature && `nature: ${nature}`]
      .filter((part) => part !== "")
      .join("; ");
  return rows.map(line).join("\n");
}

export interface MeasuresEvents {
  /** Returns the measures of the finished map on show and what was found of its promises; none while there is no such map. */
  measures(): Promise<Measured | undefined>;
  copy(text: string): Promise<void>;
}

export class MeasuresView {
  readonly element: HTMLDetailsElement;
  readonly #summary = el("p");
  readonly #kept = el("p", { class: "kept" });
  readonly #rows = el("dl", { class: "measures" });
  readonly #rest = el("p", { class: "help" });
  readonly #copy = el("button", { type: "button" }, "Copy as text");
  #told: readonly Told[] = [];

  constructor(
    disclosures: Disclosures,
    private readonly events: MeasuresEvents,
  ) {
    const heading = el("summary", {}, el("h2", {}, "How river-like?"));
    const study = el("p", {}, "Can you tell them apart? ", el("a", { href: "./real-or-grown.html" }, "Real or grown?"));
    const all = el("div", { class: "measured" }, this.#summary, this.#kept, this.#rows, this.#rest, this.#copy, study);
    this.element = disclosures.details("How river-like?", false, { class: "group" }, heading, all);
    this.element.addEventListener("toggle", () => void this.refresh());
    this.#copy.addEventListener("click", () => void events.copy(this.#text()));
    this.#show(undefined);
  }

  /** Measures the finished map again. Only while the view is open, since measuring takes time. */
  async refresh(rest?: string): Promise<void> {
    if (rest !== undefined) setText(this.#rest, rest);
    if (!this.element.open) return;
    try {
      this.#show(await this.events.measures());
    } catch (error) {
      this.#show(undefined);
      setText(this.#summary, `Not measured: ${named(error).message}`);
    }
  }

  #text(): string {
    return `${asText(this.#told)}\n${this.#kept.textContent}`;
  }

  #show(measured: Measured | undefined): void {
    const rows = told(measured?.measures ?? []);
    this.#told = rows;
    setText(this.#kept, measured ? kept(measured.promises) : "");
    this.#copy.disabled = rows.length === 0;
    setText(this.#summary, rows.length === 0 ? "Measured when the rivers are finished." : summed(rows));
    this.#rows.replaceChildren(...rows.map(rowOf));
  }
}

function rowOf({ label, help, value, verdict, nature, bar }: Told): HTMLElement {
  const said = [
    el("span", { class: "measure-value" }, value),
    ...(bar ? [barElement(bar)] : []),
    el("span", {}, verdict),
  ];
  const source = nature === "" ? [] : [el("dd", { class: "help" }, `In nature ${nature}.`)];
  return el("div", { title: help }, el("dt", {}, label), el("dd", { class: "measure" }, ...said), ...source);
}

/** Makes the bar. It is hidden from screen readers, since the words beside it say the same. */
function barElement({ value, least, most }: NonNullable<Told["bar"]>): HTMLElement {
  const tick = el("i");
  tick.style.insetInlineStart = `${100 * value}%`;
  const element = el("span", { class: "measure-bar", "aria-hidden": "true" }, tick);
  element.style.setProperty("--least", `${100 * least}%`);
  element.style.setProperty("--most", `${100 * most}%`);
  return element;
}
