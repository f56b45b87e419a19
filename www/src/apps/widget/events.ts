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
  progress: CustomEvent<ProgressDetail>;
  complete: CustomEvent<CompleteDetail>;
  error: CustomEvent<ErrorDetail>;
}
