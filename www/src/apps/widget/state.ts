/** How far an element is with the rivers that its attributes ask for, as scripts can read it. */

import type { Phase } from "../../engine/types.ts";
import type { Status } from "../../host/protocol.ts";
import type { CompleteDetail } from "./events.ts";

/** `idle` until the element begins, `loading` until the engine has read the link; then the engine's phases, or `failed`. */
export type RiverSeedPhase = "idle" | "loading" | Phase | "failed";

/** The rivers that are asked for: how they stand under their canonical link, or that they failed. */
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
    // Nobody has to wait for it: the browser is not to report what the event `error` has reported.
    this.promise.catch(() => {});
  }
}
