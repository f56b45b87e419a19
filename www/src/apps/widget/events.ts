/** The element's events. They do not bubble, since they are only about this element. */

import type { Code } from "../../engine/errors.ts";
import type { Notice, Phase, Summary } from "../../engine/types.ts";

/** The detail of `ready`: the river is shown for the first time. */
export interface ReadyDetail {
  /** Its canonical link, without defaults. */
  link: string;
  /** Corrections of the attributes and the recipe. */
  notices: readonly Notice[];
}

/** The detail of `corrected`: attributes or the recipe have values that cannot be, at first or after a change. */
export interface CorrectedDetail {
  /** The canonical link of what is shown instead. */
  link: string;
  notices: readonly Notice[];
}

/** The detail of `progress`, which is dispatched a few times a second while the river grows. */
export interface ProgressDetail {
  phase: Phase;
  /** The share of the way to the finished river, from 0 to 1. */
  progress: number;
  summary: Summary;
}

/** The detail of `complete`: the river is finished. */
export interface CompleteDetail {
  link: string;
  summary: Summary;
}

/** The detail of `error`: there is no river to show, or only the previous one. */
export interface ErrorDetail {
  code: Code;
  /** A description of the failure for the owner of the page. */
  message: string;
  /** A sentence that says what can be done. */
  advice: string;
}

export interface RiverSeedEventMap {
  ready: CustomEvent<ReadyDetail>;
  corrected: CustomEvent<CorrectedDetail>;
  progress: CustomEvent<ProgressDetail>;
  complete: CustomEvent<CompleteDetail>;
  error: CustomEvent<ErrorDetail>;
}

/** The events of every element, and those of this one. */
type Events = Omit<HTMLElementEventMap, keyof RiverSeedEventMap> & RiverSeedEventMap;

/** The methods by which events are listened to, with their types. */
export interface Audible {
  addEventListener<Type extends keyof Events>(
    type: Type,
    listener: (this: this, event: Events[Type]) => void,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  removeEventListener<Type extends keyof Events>(
    type: Type,
    listener: (this: this, event: Events[Type]) => void,
    options?: boolean | EventListenerOptions,
  ): void;
  removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void;
}
