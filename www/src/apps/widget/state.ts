/** The state of an element's requested rivers, as scripts can read it. */

import type { Phase } from "../../engine/types.ts";
import type { Status } from "../../host/protocol.ts";
import type { CompleteDetail } from "./events.ts";

/**
 * The phase of an element: `idle` until it begins, `loading` until the engine has read the link, then the engine's
 * phases, or `failed`.
 */
export type RiverSeedPhase = "idle" | "loading" | Phase | "failed";

/** The requested rivers: their status and canonical link, or that they failed. */
export type Present = (Status & { link: string }) | "failed";

/** A promise that is settled from outside. */
export class Outcome {
  done!: (detail: CompleteDetail) => void;
  failed!: (reason: Error) => void;
  readonly promise = new Promise<CompleteDetail>((done, failed) => {
    this.done = done;
    this.failed = failed;
  });

  constructor() {
    // Nobody has to wait for the promise: the browser should not report a failure that the event `error` has reported.
    this.promise.catch(() => {});
  }
}
