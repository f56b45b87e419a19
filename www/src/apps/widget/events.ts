/** The element's events. None bubbles: they are about this element and nothing around it. */

import type { Code } from "../../engine/errors.ts";
import type { Notice, Phase, Summary } from "../../engine/types.ts";

/** The river is seen for the first time. */
export interface ReadyDetail {
  /** Its canonical link: what is shown, defaults left out. */
  link: string;
  /** What in the attributes and the recipe had to be corrected. */
  notices: readonly Notice[];
}

/** It goes on; dispatched a few times a second. */
export interface ProgressDetail {
  phase: Phase;
  summary: Summary;
}

/** It is finished. */
export interface CompleteDetail {
  link: string;
  summary: Summary;
}

/** There is no river to be seen, or no other than before. */
export interface ErrorDetail {
  code: Code;
  /** What happened, for the owner of the page. */
  message: string;
  /** What can be done about it. */
  advice: string;
}

export interface RiverSeedEventMap {
  ready: CustomEvent<ReadyDetail>;
  progress: CustomEvent<ProgressDetail>;
  complete: CustomEvent<CompleteDetail>;
  error: CustomEvent<ErrorDetail>;
}
