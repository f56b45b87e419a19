/** Between a value's text (as a link has it) and what a control needs. Ranges and defaults come from the table alone. */

import { count } from "../browser/count.ts";
import type { Parameter } from "../engine/full.ts";

/** A numeric parameter with its range: what a slider is made from. */
export interface Range {
  min: number;
  max: number;
  step: number;
  isLog: boolean;
}

/** Steps of a slider on a logarithmic scale: fine enough for any width on a screen. */
export const LOG_STEPS = 1000;

export function rangeOf(parameter: Parameter): Range | undefined {
  const { kind, min, max, step, scale } = parameter;
  if ((kind !== "integer" && kind !== "number") || min === undefined || max === undefined) return undefined;
  const fallback = kind === "integer" ? 1 : (max - min) / LOG_STEPS;
  return { min, max, step: step ?? fallback, isLog: scale === "log" && min > 0 };
}

/** Where on its slider a value stands: the value itself, or 0 to LOG_STEPS on a logarithmic scale. */
export function position(value: number, range: Range): number {
  if (!range.isLog) return value;
  return Math.round((LOG_STEPS * Math.log(value / range.min)) / Math.log(range.max / range.min));
}

/** The value at a place on the slider, as text. */
export function textAt(place: number, range: Range): string {
  if (!range.isLog) return nearestText(place, range);
  const value = range.min * (range.max / range.min) ** (place / LOG_STEPS);
  const grain = grainAt(value, range);
  return numberText(snap(Math.round(value / grain) * grain, range), range.step);
}

/** The next value a key press reaches from `value` on a logarithmic scale: a share of it, and one step at least. */
export function logStep(value: number, direction: 1 | -1, share: number, range: Range): string {
  const reached = direction > 0 ? value * (1 + share) : value / (1 + share);
  const atLeast = direction > 0 ? Math.max(reached, value + range.step) : Math.min(reached, value - range.step);
  return numberText(snap(atLeast, range), range.step);
}

/**
 * The power of ten that a logarithmic slider rounds to near `value`: what a pixel of a slider of 300 px is worth, so that
 * nobody is given 12,347 attractors who pointed at 12,000.
 */
function grainAt(value: number, { min, max, step }: Range): number {
  const pixel = (value * Math.log(max / min)) / 300;
  return Math.max(step, 10 ** Math.floor(Math.log10(pixel)));
}

/** The value nearest to another that a parameter can have, as text. */
export function nearestText(value: number, range: Range): string {
  return numberText(snap(value, range), range.step);
}

function snap(value: number, { min, max, step }: Range): number {
  const onGrid = Math.round(value / step) * step;
  return Math.min(max, Math.max(min, onGrid));
}

/** Without the noise of binary fractions: 0.1 + 0.2 is 0.3 when the step is 0.1. */
export function numberText(value: number, step: number): string {
  const fraction = String(step).split(".")[1]?.length ?? 0;
  return String(Number(value.toFixed(step < 1e-6 ? 9 : fraction)));
}

/** How far along its slider a value is, 0 to 1, to colour the part behind the thumb. */
export function share(value: number, range: Range): number {
  const [low, high] = range.isLog ? [0, LOG_STEPS] : [range.min, range.max];
  return high > low ? (position(value, range) - low) / (high - low) : 0;
}

/** The sides in a value: their initials stand one after another (`sw`). */
export function sidesOf(text: string): string[] {
  return [...text];
}

/** The chosen sides as a value, in the order of the table, which is the canonical spelling. */
export function sidesText(chosen: ReadonlySet<string>, parameter: Parameter): string {
  const order = parameter.choices?.map((choice) => choice.value) ?? [];
  return order.filter((side) => chosen.has(side)).join("");
}

/** A value in words: a choice by its label, in quotes. */
export function inWords({ kind, unit, choices }: Parameter, text: string): string {
  const labelOf = (value: string) => choices?.find((choice) => choice.value === value)?.label ?? value;
  if (kind === "choice") return `“${labelOf(text)}”`;
  if (kind === "sides") return sidesOf(text).map(labelOf).join(" and ");
  return spoken(text, unit);
}

/** A value as spoken by a screen reader: `0.6 rad`, `12,000`. */
export function spoken(text: string, unit: string | undefined): string {
  const value = Number(text);
  const number = Number.isInteger(value) ? count(value) : text;
  return unit ? `${number} ${unit}` : number;
}
