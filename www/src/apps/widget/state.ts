/** The state of an element's requested rivers, as scripts can read it, and the promise of their end. */

import type { Phase } from "../../engine/types.ts";
import type { Status } from "../../host/protocol.ts";
import type { CompleteDetail } from "./events.ts";
import type { Seen } from "./protocol.ts";

/**
 * The phase of an element: `idle` until it begins, `loading` until the engine has read the link, then the engine's
 * phases, or `failed`.
 */
export type RiverSeedPhase = "idle" | "loading" | Phase | "failed";

/** The status of rivers that have begun, and their canonical link. */
type Present = Status & { link: string };

/** The rivers that an element's attributes ask for, even if the canvas still shows others. */
export class Requested {
  /** Undefined until the engine has read their link. */
  #present: Present | "failed" | undefined;
  #outcome = new Outcome();

  /** Their status, if they have begun and not failed. */
  get now(): Present | undefined {
    return this.#present === "failed" ? undefined : this.#present;
  }

  /** Their phase, once the engine has read their link. */
  get phase(): Phase | "failed" | undefined {
    return this.#present === "failed" ? "failed" : this.#present?.phase;
  }

  get finished(): Promise<CompleteDetail> {
    return this.#outcome.promise;
  }

  /** Begins anew with other rivers or the same ones. The pending promise rejects with `why` as its reason. */
  renew(why = ""): void {
    this.#present = undefined;
    this.#outcome.failed(new DOMException(why, "AbortError"));
    this.#outcome = new Outcome();
  }

  /** Begins anew if the rivers are finished. */
  growAgain(): void {
    if (this.now?.state === "finished") this.renew();
  }

  advance({ reading: { link }, ...status }: Seen): void {
    if (status.state !== "finished") this.growAgain();
    this.#present = { link, ...status };
    if (status.state === "finished") this.#outcome.done({ link, summary: status.summary });
  }

  fail(error: Error): void {
    this.#present = "failed";
    this.#outcome.failed(error);
  }
}

/** A promise that is settled from outside. */
class Outcome {
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
