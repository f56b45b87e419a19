/**
 * The frame loop: how much to grow before the next picture. It knows the time and nothing of pixels; what it grows
 * is the same to the bit however the work is sliced.
 */

/** At 1x the front crosses the height of the picture in this time. */
export const HEIGHT_SECONDS = 5;
/** What growing may take of a frame that animates: painting, and the rest of the page, need the other 10 ms. */
export const FRAME_BUDGET_MS = 6;
/** What it may take of a frame when somebody waits for the finished river. */
export const SETTLE_BUDGET_MS = 10;
/** While somebody waits for a river that takes longer than this, it is shown so often: each picture delays the end. */
export const SETTLE_QUIET_MS = 250;
/** After a pause in frames (a hidden tab, a busy machine) growth goes on from where it was, it does not catch up. */
const LONGEST_STEP_MS = 100;

/** What grows: the core's river, or a stand-in in a test. */
export interface Growing {
  readonly ticksPerHeight: number;
  advance(ticks: number): boolean;
  restart(): void;
}

export interface Frames {
  request(callback: (now: number) => void): number;
  cancel(handle: number): void;
  now(): number;
}

/**
 * growing: animated; paused: animated, held; settling: to the end as fast as the page bears; finished: nothing to do.
 */
export type State = "growing" | "paused" | "settling" | "finished";

export interface Audience {
  /** Show what has grown. */
  draw(): void;
  changed(state: State): void;
  failed(error: unknown): void;
}

export class Growth {
  /** Times the ordinary speed; `Infinity` grows as fast as the budget allows. */
  speed = 1;
  #state: State = "paused";
  #handle: number | undefined;
  #last: number | undefined;
  /** Ticks that are due and not yet grown, with their fraction. */
  #owed = 0;
  #shownAt = 0;
  #redraw = false;

  constructor(
    private readonly river: Growing,
    private readonly frames: Frames,
    private readonly audience: Audience,
  ) {}

  get state(): State {
    return this.#state;
  }

  /** Animates a river from where it stands. */
  watch(): void {
    this.#enter("growing");
  }

  /** Goes on; a finished river starts again. */
  play(): void {
    if (this.#state === "finished") this.river.restart();
    this.watch();
  }

  pause(): void {
    if (this.#state === "growing" || this.#state === "settling") this.#enter("paused");
  }

  toggle(): void {
    if (this.#state === "growing" || this.#state === "settling") this.pause();
    else this.play();
  }

  /** Animates from the mouths again. */
  replay(): void {
    this.river.restart();
    this.watch();
  }

  /** To the finished river without animation, in slices. */
  settle(): void {
    this.#shownAt = this.frames.now();
    this.#enter("settling");
  }

  /** One more picture, whatever the state: something late changed. */
  redraw(): void {
    this.#redraw = true;
    this.#wake();
  }

  /** No more frames; for good, or until the tab is seen again. */
  rest(): void {
    if (this.#handle !== undefined) this.frames.cancel(this.#handle);
    this.#handle = undefined;
    this.#last = undefined;
  }

  wake(): void {
    if (this.#redraw || this.#state === "growing" || this.#state === "settling") this.#wake();
  }

  #enter(state: State): void {
    this.#last = undefined;
    this.#owed = 0;
    this.#redraw = true;
    this.#become(state);
    this.#wake();
  }

  #become(state: State): void {
    if (state === this.#state) return;
    this.#state = state;
    this.audience.changed(state);
  }

  #wake(): void {
    this.#handle ??= this.frames.request((now) => this.#frame(now));
  }

  #frame(now: number): void {
    this.#handle = undefined;
    try {
      this.#step(now);
    } catch (error) {
      this.rest();
      this.audience.failed(error);
    }
  }

  #step(now: number): void {
    const finished = this.#grow(now);
    const quiet = this.#state === "settling" && !finished && now - this.#shownAt < SETTLE_QUIET_MS;
    if (!quiet) {
      this.#redraw = false;
      this.#shownAt = now;
      this.audience.draw();
    }
    if (finished) this.#become("finished");
    this.wake();
  }

  /** Grows what is due, within the budget. True when this frame finished the river. */
  #grow(now: number): boolean {
    if (this.#state === "settling") return this.#advance(Number.POSITIVE_INFINITY, SETTLE_BUDGET_MS);
    if (this.#state !== "growing") return false;
    const elapsed = this.#last === undefined ? 0 : Math.min(now - this.#last, LONGEST_STEP_MS);
    this.#last = now;
    return this.#advance(this.#due(elapsed), FRAME_BUDGET_MS);
  }

  #due(elapsedMs: number): number {
    if (this.speed === Number.POSITIVE_INFINITY) return Number.POSITIVE_INFINITY;
    const ticksPerMs = (this.river.ticksPerHeight * this.speed) / (HEIGHT_SECONDS * 1000);
    return this.#owed + elapsedMs * ticksPerMs;
  }

  /** One tick at a time: a tick is far longer than asking the clock, and the longest bounds how late a frame can be. */
  #advance(due: number, budgetMs: number): boolean {
    const end = this.frames.now() + budgetMs;
    while (due >= 1) {
      if (this.river.advance(1)) return true;
      due -= 1;
      if (this.frames.now() >= end) break;
    }
    // Whole ticks that did not fit are dropped: growth takes longer rather than falling ever further behind.
    this.#owed = due % 1 || 0;
    return false;
  }
}
