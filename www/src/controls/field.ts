/** The common interface of all controls' fields, and the ids by which their parts refer to each other. */

import type { Parameter } from "../engine/table.ts";

/** A parameter as a control shows it. */
export interface Shown extends Parameter {
  /** Set for a number in front, so that its ids differ from those under *All settings*. It has no field for an exact value. */
  idSuffix?: string;
}

/** Takes a change: the key, and the new value as link text. */
export type Change = (key: string, text: string) => void;

/** The part of a control that depends on the kind of parameter. It takes the focus when the reset button vanishes. */
export interface Field {
  readonly element: HTMLElement;
  readonly label: HTMLElement;
  readonly aside?: HTMLElement;
  /** A remark to read before the field is changed. */
  readonly remark?: string;
  /** Shows what a link says. `automatic` is the value that the text stands for, if it is decided elsewhere. */
  show(text: string, automatic?: string): void;
  focus(): void;
}

export function fieldId({ key, idSuffix = key }: Shown): string {
  return `field-${idSuffix}`;
}

export function helpId({ key, idSuffix = key }: Shown): string {
  return `help-${idSuffix}`;
}
