/**
 * The frame loop: how far to go before the next picture. It knows the time and nothing of pixels; what grows and meanders
 * is the same to the bit however the work is sliced.
 */

import type { Phase } from "../engine/types.ts";

/** At 1x a tree grows up in this time, whatever its shape and however fine it is. */
export const GROWTH_SECONDS = 2;
/** At 1x rivers meander at this pace, or a round at most every other frame; many rounds share the time there is for all. */
export const ROUNDS_PER_SECOND = 40;
export const MEANDER_SECONDS = 1.2;
/** What steps may take of a frame that animates: painting, and the rest of the page, need the other 10 ms. */
export const FRAME_BUDGET_MS = 6;
/** What they may take of a frame when somebody waits for the finished river. */
export const SETTLE_BUDGET_MS = 10;
/** The same until something of a river that follows a hand is seen, which it is in the same frame: as many rounds as 50 ms leave room for. */
export const DRAFT_BUDGET_MS = 24;
/** A hand that has changed nothing for so long rests: what it has left is then made exactly. */
export const REST_MS = 150;
/** What painting may take of a frame, and a part of it more: a picture that takes longer is painted over several, and seen in the last. */
export const PAINT_BUDGET_MS = 10;
/** After steps that took longer than this, painting is left to the next frame: one callback with both would be felt. */
export const LONG_STEPS_MS = 20;
/** While somebody waits for a river that takes longer than this, it is shown so often: each picture delays the end. */
export const SETTLE_QUIET_MS = 250;
/** After a pause in frames (a hidden tab, a busy machine) it goes on from where it was, it does not catch up. */
const LONGEST_STEP_MS = 100;

/** What grows: the core's river, or a stand-in in a test. */
export interface Growing {
  readonly phase: Phase;
  /** How far the phase has come, from 0 to 1. */
  readonly progress: number;
  /** How many rounds rivers meander in all. */
  readonly rounds: number;
  /** Goes on by some steps. Returns whether there is more to do, here. */
  advance(steps: number): boolean;
  restart(): void;
}

export interface Frames {
  request(callback: (now: number) => void): number;
  cancel(handle: number): void;
  now(): number;
}

/**
 * growing: animated, meanders too; paused: animated, held; settling: to the end as fast as the page bears; finished: nothing to do.
 */
export type State = "growing" | "paused" | "settling" | "finished";

export interface FrameLoopEvents {
  /**
   * Does a part of showing what there is; of rivers that follow a hand a draft will do. Returns whether there is more to do: until there is
   * not, nothing is to be seen.
   */
  draw(asDraft: boolean): boolean;
  /** Something was shown that may give way to another recipe. */
  ready(): void;
  changed(state: State): void;
  failed(error: unknown): void;
}

/** How a phase is spread over its time; times and shares run from 0 to 1. */
interface Pace {
  seconds: number;
  shareAt(time: number): number;
  timeAt(share: number): number;
}

/** Fast at first, so that there is soon something to be seen: after half of the time four fifths have grown. */
const EASE = 2.5;
const GROWING: Pace = {
  seconds: GROWTH_SECONDS,
  shareAt: (time) => 1 - (1 - time) ** EASE,
  timeAt: (share) => 1 - (1 - share) ** (1 / EASE),
};

export class FrameLoop {
  #speed = 1;
  #state: State = "paused";
  #handle: number | undefined;
  #last: number | undefined;
  /** The phase that is being animated, and the seconds, at 1x, that it has been. */
  #paced: Phase | undefined;
  #spent = 0;
  #shownAt = 0;
  #redraw = false;
  #isResting = false;
  #isOver = false;
  /** While settling: in which phase it began, whether the tree is worth a picture before it becomes rivers, and whether any grown one was shown. */
  #from: Phase = "growing";
  #showsTree = false;
  #isShown = false;
  /** While it follows a hand: since when that may rest; whether rivers were shown. */
  #movedAt: number | undefined;
  #isDrafted = false;
  /** The next frame paints and makes no steps: the last one had no time to, or not for all. */
  #paintsNext = false;
  #isPainting = false;

  constructor(
    private readonly river: Growing,
    private readonly frames: Frames,
    private readonly events: FrameLoopEvents,
  ) {}

  get state(): State {
    return this.#state;
  }

  /** Times the ordinary speed; `Infinity` grows as fast as the budget allows. */
  set speed(speed: number) {
    this.#speed = speed;
    // From where it stands, however fast it came there.
    this.#paced = undefined;
  }

  /** Whether another recipe would throw away what nobody has seen yet. */
  get isBusy(): boolean {
    return this.#isPainting || (this.#state === "settling" && !this.#isShown);
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
    if (this.#runs) this.#enter("paused");
  }

  /** Stands still where the river is, be it its end, and shows it: somebody has moved it. */
  hold(): void {
    this.#enter("paused");
  }

  toggle(): void {
    if (this.#runs) this.pause();
    else this.play();
  }

  /** Animates from the mouths again. */
  replay(): void {
    this.river.restart();
    this.watch();
  }

  /** To the finished river without animation, in slices; if asked for, the grown tree is shown on the way. */
  settle(showsTree: boolean): void {
    this.#shownAt = this.frames.now();
    this.#from = this.river.phase;
    this.#showsTree = showsTree;
    this.#isShown = this.#isDrafted = false;
    this.#enter("settling");
  }

  /**
   * After a hand that still moves: to something that can be shown, a grown tree, or rivers as far as they have meandered by then; and to
   * the finished river when the hand rests. If it has been shown otherwise, and the hand rests, there at once.
   */
  follow(isShown = false): void {
    this.settle(true);
    this.#movedAt = isShown ? Number.NEGATIVE_INFINITY : this.frames.now();
    this.#isShown = this.#isDrafted = isShown;
  }

  /** The frame that is due, now. */
  hurry(): void {
    if (this.#handle === undefined) return;
    this.frames.cancel(this.#handle);
    this.#frame(this.frames.now());
  }

  /** One more picture, whatever the state: something late changed. */
  redraw(): void {
    this.#redraw = true;
    this.#wake();
  }

  /** No more steps until it is seen again. A picture that is due is still painted. */
  rest(): void {
    this.#isResting = true;
    this.#last = undefined;
    if (!this.#redraw) this.halt();
  }

  wake(): void {
    this.#isResting = false;
    this.#goOn();
  }

  /** No more frames, unless something is asked for again. */
  halt(): void {
    if (this.#handle !== undefined) this.frames.cancel(this.#handle);
    this.#handle = undefined;
    this.#last = undefined;
  }

  /** No frames any more, whatever is asked for: the one that this may be in does not go on, either. */
  close(): void {
    this.halt();
    this.#isOver = true;
  }

  #goOn(): void {
    if (this.#redraw || this.#isStepping) this.#wake();
  }

  get #runs(): boolean {
    return this.#state === "growing" || this.#state === "settling";
  }

  get #isStepping(): boolean {
    return this.#runs && !this.#isResting;
  }

  #enter(state: State): void {
    this.#last = undefined;
    this.#paced = undefined;
    this.#movedAt = undefined;
    this.#redraw = true;
    this.#paintsNext = this.#isPainting = false;
    this.#become(state);
    this.#wake();
  }

  #become(state: State): void {
    if (state === this.#state) return;
    this.#state = state;
    this.events.changed(state);
  }

  #wake(): void {
    if (!this.#isOver) this.#handle ??= this.frames.request((now) => this.#frame(now));
  }

  #frame(now: number): void {
    this.#handle = undefined;
    try {
      this.#step(now);
    } catch (error) {
      this.halt();
      this.events.failed(error);
    }
  }

  #step(now: number): void {
    const began = this.frames.now();
    const before = this.river.phase;
    const isDue = this.#isStepping && before !== "finished" && !this.#paintsNext;
    if (isDue && !this.#waitsForRest) this.#proceed(now, before);
    const shows = this.#paintsNext || this.#isWorthShowing(now, before);
    // A hand waits for no other frame: its steps have a budget that leaves room for a draft.
    const isForHand = this.#movedAt !== undefined && !this.#isShown;
    this.#paintsNext = shows && !isForHand && !this.#paintsNext && this.frames.now() - began > LONG_STEPS_MS;
    if (shows && !this.#paintsNext) this.#show(now);
    this.#goOn();
  }

  /** Whether there is a picture to be painted. Of a river that settles, seldom. */
  #isWorthShowing(now: number, before: Phase): boolean {
    const { phase } = this.river;
    if (this.#state !== "settling" || phase === "finished") return true;
    const isGrown = before === "growing" && phase !== before;
    if (this.#movedAt !== undefined && (phase === "meandering" || phase === "relief")) return !this.#isDrafted;
    return (isGrown && this.#showsTree) || now - this.#shownAt >= SETTLE_QUIET_MS;
  }

  #show(now: number): void {
    const { phase } = this.river;
    this.#isPainting = this.#paint();
    this.#redraw = this.#paintsNext = this.#isPainting;
    if (this.#isPainting) return;
    this.#shownAt = now;
    this.#isShown ||= this.#showsNew(phase);
    this.#isDrafted ||= this.#isShown && phase !== "shaping";
    if (this.#runs && phase === "finished") this.#become("finished");
    if (!this.isBusy) this.events.ready();
  }

  /** Whether a picture in this phase shows something of what settles: until there are other rivers, or another relief, the old stay in it. */
  #showsNew(phase: Phase): boolean {
    if (phase === "shaping") return this.#from === "growing";
    if (phase === "relief") return this.#movedAt !== undefined;
    return phase !== "growing";
  }

  /** Whether the hand that it follows may move on, and has seen something. */
  get #waitsForRest(): boolean {
    return this.#movedAt !== undefined && this.#isShown && this.frames.now() - this.#movedAt < REST_MS;
  }

  /** Paints within the budget. Returns whether there is more to do. */
  #paint(): boolean {
    const end = this.frames.now() + PAINT_BUDGET_MS;
    const asDraft = this.#movedAt !== undefined && this.river.phase !== "finished";
    while (this.events.draw(asDraft)) {
      if (this.frames.now() >= end) return true;
    }
    return false;
  }

  /** Makes the steps that are due, within the budget. */
  #proceed(now: number, phase: Phase): void {
    if (this.#state === "settling") {
      if (this.#movedAt !== undefined && !this.#isShown) this.#makeDraft(phase);
      else this.#advance(phase, 1, SETTLE_BUDGET_MS);
      return;
    }
    const elapsed = this.#last === undefined ? 0 : Math.min(now - this.#last, LONGEST_STEP_MS);
    this.#last = now;
    this.#animate(phase, (elapsed * this.#speed) / 1000);
  }

  /** Steps until there is something new to be shown, or the budget is spent. */
  #makeDraft(before: Phase): void {
    const end = this.frames.now() + DRAFT_BUDGET_MS;
    const { river } = this;
    const isGrown = (): boolean => before === "growing" && river.phase !== before;
    do river.advance(1);
    while (!isGrown() && river.phase !== "relief" && river.phase !== "finished" && this.frames.now() < end);
  }

  /** Advances by some seconds of the animation. What does not fit makes it longer, rather than falling ever further behind. */
  #animate(phase: Phase, seconds: number): void {
    const pace = this.#paceOf(phase);
    if (this.#paced !== phase) {
      this.#paced = phase;
      this.#spent = pace.seconds * pace.timeAt(this.river.progress);
    }
    const spent = this.#spent + seconds;
    const share = spent < pace.seconds ? pace.shareAt(spent / pace.seconds) : 1;
    if (this.#advance(phase, share, FRAME_BUDGET_MS)) this.#spent = spent;
  }

  #paceOf(phase: Phase): Pace {
    if (phase === "growing") return GROWING;
    const seconds = phase === "meandering" ? Math.min(MEANDER_SECONDS, this.river.rounds / ROUNDS_PER_SECOND) : 0;
    return { seconds, shareAt: (time) => time, timeAt: (share) => share };
  }

  /**
   * Steps until so much of the phase is done, 1 for its end; returns whether there was time for them. One step at a time: a step
   * is far longer than asking the clock, and the longest bounds how late a frame can be. Another phase begins with another frame,
   * so that its first picture is seen.
   */
  #advance(phase: Phase, share: number, budgetMs: number): boolean {
    const end = this.frames.now() + budgetMs;
    const isDue = (): boolean => this.river.phase === phase && (share === 1 || this.river.progress < share);
    while (isDue()) {
      // Either that was the last step, or others make it.
      if (!this.river.advance(1)) return true;
      if (this.frames.now() >= end) return !isDue();
    }
    return true;
  }
}
