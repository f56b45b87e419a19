/**
 * Converts between the link text of values and the state of controls. Ranges and defaults come from the table alone.
 */

import { count } from "../browser/count.ts";
import type { Parameter } from "../engine/table.ts";

/** The range of a numeric parameter, from which its slider is made. */
export interface Range {
  min: number;
  max: number;
  step: number;
  isLog: boolean;
}

/** The number of steps of a logarithmic slider, fine enough for any width on a screen. */
export const LOG_STEPS = 1000;

export function rangeOf(parameter: Parameter): Range | undefined {
  const { kind, min, max, step, scale } = parameter;
  if ((kind !== "integer" && kind !== "number") || min === undefined || max === undefined) return undefined;
  const fallback = kind === "integer" ? 1 : (max - min) / LOG_STEPS;
  return { min, max, step: step ?? fallback, isLog: scale === "log" && min > 0 };
}

/** Returns the position of a value on its slider: the value itself, or 0 to LOG_STEPS on a logarithmic scale. */
export function position(value: number, range: Range): number {
  if (!range.isLog) return value;
  return Math.round((LOG_STEPS * Math.log(value / range.min)) / Math.log(range.max / range.min));
}

/** Returns the value at a position on the slider, as text. */
export function textAt(place: number, range: Range): string {
  if (!range.isLog) return nearestText(place, range);
  const value = range.min * (range.max / range.min) ** (place / LOG_STEPS);
  return numberText(snap(rounded(value, range), range), range.step);
}

/** Rounds a value of a logarithmic slider, so that pointing at 12,000 attractors does not give 12,347. */
function rounded(value: number, range: Range): number {
  const { min, max, step } = range;
  const grain = grainAt(value, range);
  // The greatest value below, where the slider rounds to a tenth of that.
  const below = grain > step ? (Math.round(3000 / Math.log(max / min)) * grain) / 10 : min;
  return Math.max(below, Math.round(value / grain) * grain);
}

/** Returns the next value after `value` on a logarithmic scale, a share of it or at least one step away, as text. */
export function logStep(value: number, direction: 1 | -1, share: number, range: Range): string {
  const reached = direction > 0 ? value * (1 + share) : value / (1 + share);
  const atLeast = direction > 0 ? Math.max(reached, value + range.step) : Math.min(reached, value - range.step);
  return numberText(snap(atLeast, range), range.step);
}

/** Returns the power of ten to which a logarithmic slider rounds near `value`: at most one pixel of a slider of 300 px. */
function grainAt(value: number, { min, max, step }: Range): number {
  const pixel = (value * Math.log(max / min)) / 300;
  return Math.max(step, 10 ** Math.floor(Math.log10(pixel)));
}

/** Returns the nearest value that a parameter can have, as text. */
export function nearestText(value: number, range: Range): string {
  return numberText(snap(value, range), range.step);
}

function snap(value: number, { min, max, step }: Range): number {
  const onGrid = Math.round(value / step) * step;
  return Math.min(max, Math.max(min, onGrid));
}

/** Writes a number without the noise of binary fractions: 0.1 + 0.2 is 0.3 when the step is 0.1. */
export function numberText(value: number, step: number): string {
  const fraction = String(step).split(".")[1]?.length ?? 0;
  return String(Number(value.toFixed(step < 1e-6 ? 9 : fraction)));
}

/** Returns the place of a value along its slider, from 0 to 1, to colour the part before the thumb. */
export function share(value: number, range: Range): number {
  const [low, high] = range.isLog ? [0, LOG_STEPS] : [range.min, range.max];
  return high > low ? (position(value, range) - low) / (high - low) : 0;
}

/** Returns the value at a place along its slider, from 0 to 1, as text. */
export function placeText(place: number, range: Range): string {
  const [low, high] = range.isLog ? [0, LOG_STEPS] : [range.min, range.max];
  return textAt(low + (high - low) * place, range);
}

/** Splits a value into sides, of which it lists the initials (`sw`). */
export function sidesOf(text: string): string[] {
  return [...text];
}

/** Writes the chosen sides as a value, in the order of the table, which is the canonical spelling. */
export function sidesText(chosen: ReadonlySet<string>, parameter: Parameter): string {
  const order = parameter.choices?.map((choice) => choice.value) ?? [];
  return order.filter((side) => chosen.has(side)).join("");
}

/** Writes a value in words. A choice is written as its label, in quotes. */
export function inWords({ kind, unit, choices }: Parameter, text: string): string {
  const labelOf = (value: string) => choices?.find((choice) => choice.value === value)?.label ?? value;
  if (kind === "choice") return `“${labelOf(text)}”`;
  if (kind === "sides") return sidesOf(text).map(labelOf).join(" and ");
  return spoken(text, unit);
}

/** Writes a value as a screen reader speaks it: `0.6 rad`, `12,000`. */
export function spoken(text: string, unit: string | undefined): string {
  const value = Number(text);
  const number = Number.isInteger(value) ? count(value) : text;
  return unit ? `${number} ${unit}` : number;
}
