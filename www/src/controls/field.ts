/** What every control is, and how its parts find each other. */

import type { Parameter } from "../engine/full.ts";

/** Told the key and the new value as link text. */
export type Change = (key: string, text: string) => void;

/** What is particular to a kind: its field, and where the focus goes when the reset button vanishes. */
export interface Field {
  readonly element: HTMLElement;
  readonly label: HTMLElement;
  readonly aside?: HTMLElement;
  /** What is to be known of it before it is moved. */
  readonly remark?: string;
  /** Shows a value, given as link text. */
  show(text: string): void;
  focus(): void;
}

export function fieldId({ key }: Parameter): string {
  return `field-${key}`;
}

export function helpId({ key }: Parameter): string {
  return `help-${key}`;
}
