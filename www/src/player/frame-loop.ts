/**
 * The frame loop: decides how far to go before the next picture. It knows the time and nothing of pixels; the river is
 * the same to the bit however the work is sliced. Its course is one of five cases, and each frame takes one step from
 * there.
 */

import type { Phase } from "../engine/types.ts";
import { progressOf } from "./progress.ts";

/** The time in which a tree grows up at 1x, whatever its shape and however fine it is. */
export const GROWTH_SECONDS = 2;
/** The time in which the sea rises into valleys at 1x, with the short search for its level. */
export const RISE_SECONDS = 0.7;
/** The pace at which rivers meander at 1x. Many rounds share `MEANDER_SECONDS`, and so are faster. */
export const ROUNDS_PER_SECOND = 40;
export const MEANDER_SECONDS = 1.2;
/** The time for steps in a frame that animates: painting, and the rest of the page, need the other 10 ms. */
export const FRAME_BUDGET_MS = 6;
/** The time for steps in a frame when somebody waits for the finished river. */
export const SETTLE_BUDGET_MS = 10;
/** The time for steps before a river that follows a hand is painted, in the same frame and within 50 ms in all. */
export const DRAFT_BUDGET_MS = 24;
/** After this time without a change the hand is at rest, and the exact river is made. */
export const REST_MS = 150;
/**
 * The time for painting in a frame, exceeded by one part at most. A picture that takes longer is painted over several
 * frames and shown in the last.
 */
export const PAINT_BUDGET_MS = 10;
/**
 * After steps that took longer than this, painting waits for the next frame: one callback with both would be noticed.
 */
export const LONG_STEPS_MS = 20;
/** The time between two pictures of a river that somebody waits for: each picture delays the end. */
export const SETTLE_QUIET_MS = 250;
/**
 * The time from which on a new map is shown once it has coasts and rivers, before these bend: then the exact map is still long
 * in coming, and differs little.
 */
export const FIRST_QUIET_MS = 60;
/**
 * The longest time that one frame animates: after a pause in frames (a hidden tab, a busy machine) it does not catch
 * up.
 */
const LONGEST_STEP_MS = 100;

/** A river that grows: the core's, or a stand-in in a test. */
export interface Growing {
  readonly phase: Phase;
  /** The share of the phase that is done, from 0 to 1. */
  readonly progress: number;
  /** The total number of rounds that rivers meander. */
  readonly rounds: number;
  /** Makes some steps. Returns whether there is more for this caller to do. */
  advance(steps: number): boolean;
  restart(): void;
}

export interface Frames {
  /** Requests a frame. Work that is out of sight comes after all that is seen. */
  request(callback: (now: number) => void, isUnseen?: boolean): number;
  cancel(handle: number): void;
  now(): number;
  /**
   * The time in a frame for steps, and for painting, of a river that somebody waits for, if not `SETTLE_BUDGET_MS` and
   * `PAINT_BUDGET_MS`: longer in a thread that has nothing else to do.
   */
  readonly waitMs?: number | undefined;
}

/**
 * growing: animated, including the sea's rise and the bends; paused; settling: on its way to the end as fast as the page allows; finished.
 */
export type State = "growing" | "paused" | "settling" | "finished";

type Course =
  | { is: "paused" }
  | { is: "finished" }
  /**
   * `last` is the time of the last frame; `pace` is the phase that is being animated, and the seconds, at 1x, that it
   * has been.
   */
  | { is: "growing"; last?: number | undefined; pace?: { phase: Phase; spent: number } | undefined }
  | Settling
  | Following
  /** On its way to a share of the progress, to be paused there. */
  | { is: "seeking"; share: number };

/** The course to the finished river without animation. */
interface Settling {
  is: "settling";
  /** The phase in which it began. */
  from: Phase;
  /** True if the grown tree is worth a picture before it becomes rivers. */
  showsTree: boolean;
  /** True once a picture has shown anything new. */
  hasShown: boolean;
  shownAt: number;
}

/** The course after a moving hand: to something that can be shown, and to the finished river when the hand rests. */
interface Following {
  is: "following";
  from: Phase;
  /** The time of the hand's last move. */
  since: number;
  /** The part of the new river that pictures have shown. */
  shown: "nothing" | "tree" | "rivers";
  shownAt: number;
}

/**
 * The picture to be painted: none; due in some frame; next, in a frame without steps; or begun, to be completed in the
 * next frame.
 */
type Picture = "none" | "due" | "next" | "begun";

/** The presence of an audience: here; past, so that it finds a finished river when it comes back; away for now; gone for good. */
type Audience = "here" | "past" | "away" | "gone";

export interface FrameLoopEvents {
  /**
   * Paints a part of the picture, as a draft if the river follows a hand. Returns whether there is more to do: only the
   * complete picture is shown.
   */
  draw(asDraft: boolean): boolean;
  /** Called when something has been shown, so that another recipe may replace it. */
  ready(): void;
  changed(state: State): void;
  failed(error: unknown): void;
}

/** The way a phase is spread over its time. Times and shares run from 0 to 1. */
interface Pace {
  seconds: number;
  shareAt(time: number): number;
  timeAt(share: number): number;
}

/** Makes growth fast at first, so that there is soon something to see: after half the time four fifths have grown. */
const EASE = 2.5;
const GROWING: Pace = {
  seconds: GROWTH_SECONDS,
  shareAt: (time) => 1 - (1 - time) ** EASE,
  timeAt: (share) => 1 - (1 - share) ** (1 / EASE),
};

export class FrameLoop {
  #speed = 1;
  #course: Course = { is: "paused" };
  #picture: Picture = "none";
  #audience: Audience = "here";
  #handle: number | undefined;

  constructor(
    private readonly river: Growing,
    private readonly frames: Frames,
    private readonly events: FrameLoopEvents,
  ) {}

  get state(): State {
    return stateOf(this.#course);
  }

  /** The speed as a multiple of the ordinary one. `Infinity` grows as fast as the budget allows. */
  set speed(speed: number) {
    this.#speed = speed;
    // The new pace starts from the present progress.
    if (this.#course.is === "growing") this.#course.pace = undefined;
  }

  /** True while another recipe would throw away work that nobody has seen yet. */
  get isBusy(): boolean {
    return this.#picture === "begun" || hidesNews(this.#course);
  }

  /** Animates the river from its present state. */
  watch(): void {
    this.#enter({ is: "growing" });
  }

  /** Continues, or starts again if the river is finished. */
  play(): void {
    if (this.state === "finished") this.river.restart();
    this.watch();
  }

  pause(): void {
    if (this.#runs) this.#enter({ is: "paused" });
  }

  /** Pauses at the current step, even the last, and repaints: somebody has moved the river there. */
  hold(): void {
    this.#enter({ is: "paused" });
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

  /** Goes to the finished river without animation, in slices. With `showsTree` the grown tree is shown on the way. */
  settle(showsTree: boolean): void {
    const [shownAt, from] = [this.frames.now(), this.river.phase];
    this.#enter({ is: "settling", from, showsTree, hasShown: false, shownAt });
  }

  /**
   * Goes to a share of the progress, from 0 to 1, without animation, in slices, and pauses there. Rivers only grow
   * forward: for an earlier share they grow again.
   */
  seek(share: number): void {
    if (progressOf(this.river) > share) this.river.restart();
    this.#enter({ is: "seeking", share });
  }

  /**
   * Follows a moving hand: to a grown tree, or to rivers as far as they have meandered by then, and to the finished
   * river when the hand rests. With `isShown` a draft has been shown and the hand is at rest, so it goes to the
   * finished river at once.
   */
  follow(isShown = false): void {
    const [shownAt, from] = [this.frames.now(), this.river.phase];
    const since = isShown ? Number.NEGATIVE_INFINITY : shownAt;
    this.#enter({ is: "following", from, since, shown: isShown ? "rivers" : "nothing", shownAt });
  }

  /** Runs the requested frame now. */
  hurry(): void {
    if (this.#handle === undefined) return;
    this.frames.cancel(this.#handle);
    this.#frame(this.frames.now());
  }

  /** Paints one more picture, whatever the state. */
  redraw(): void {
    if (this.#picture === "none") this.#picture = "due";
    this.#wake();
  }

  /** Stops making steps until `wake`. A picture that is due is still painted. */
  rest(): void {
    this.#meet("away");
    if (this.#picture === "none") this.halt();
    else this.#forgetTime();
  }

  /** Goes to the end without animation while nobody looks, and paints the finished river alone. */
  finishUnseen(): void {
    this.#meet("past");
    this.#goOn();
  }

  /** Goes on for an audience, from as far as the river has grown. */
  wake(): void {
    this.#meet("here");
    this.#goOn();
  }

  /** Cancels the requested frame. A later request starts again. */
  halt(): void {
    if (this.#handle !== undefined) this.frames.cancel(this.#handle);
    this.#handle = undefined;
    this.#forgetTime();
  }

  /** Stops for good, whatever is requested later. A frame that is running does not request another. */
  close(): void {
    this.halt();
    this.#audience = "gone";
  }

  #meet(audience: Audience): void {
    if (this.#audience === audience || this.#audience === "gone") return;
    // Seen and unseen rivers wait in different lines.
    if (this.#isPassed || audience === "past") this.halt();
    if (this.#course.is === "growing") this.#course.pace = undefined;
    this.#audience = audience;
  }

  #goOn(): void {
    if (this.#picture !== "none" || this.#isStepping) this.#wake();
  }

  get #runs(): boolean {
    return this.state === "growing" || this.state === "settling";
  }

  get #isStepping(): boolean {
    return this.#runs && this.#audience !== "away";
  }

  get #settleMs(): number {
    return this.frames.waitMs ?? SETTLE_BUDGET_MS;
  }

  get #isPassed(): boolean {
    return this.#audience === "past";
  }

  /** Forgets the last frame's time, so that the animation goes on from where it was. */
  #forgetTime(): void {
    if (this.#course.is === "growing") this.#course.last = undefined;
  }

  #enter(course: Course): void {
    this.#picture = "due";
    this.#become(course);
    this.#wake();
  }

  #become(course: Course): void {
    const before = this.state;
    this.#course = course;
    if (this.state !== before) this.events.changed(this.state);
  }

  #wake(): void {
    if (this.#audience !== "gone") this.#handle ??= this.frames.request((now) => this.#frame(now), this.#isPassed);
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

  /**
   * Makes the steps that are due, then the picture. A picture that the last frame had no time for comes first, without
   * steps.
   */
  #step(now: number): void {
    if (this.#picture === "next" || this.#picture === "begun") this.#show(now);
    else {
      const [began, before] = [this.frames.now(), this.river.phase];
      if (this.#isStepping && before !== "finished") this.#proceed(now, before);
      // A draft does not wait for another frame: the budget of its steps leaves room for it.
      const mayWait = this.#course.is !== "following" || this.#course.shown !== "nothing";
      if (this.#isWorthShowing(now, before)) {
        if (mayWait && this.frames.now() - began > LONG_STEPS_MS) this.#picture = "next";
        else this.#show(now);
      }
    }
    this.#goOn();
  }

  /** Makes the steps that are due, within the budget. */
  #proceed(now: number, phase: Phase): void {
    const course = this.#course;
    if (course.is === "settling" || (course.is === "growing" && this.#isPassed)) {
      this.#advance(phase, 1, this.#settleMs);
    } else if (course.is === "growing") {
      const elapsed = course.last === undefined ? 0 : Math.min(now - course.last, LONGEST_STEP_MS);
      course.last = now;
      this.#animate(course, phase, (elapsed * this.#speed) / 1000);
    } else if (course.is === "seeking") this.#seek(course.share);
    else if (course.is === "following") this.#follow(course, phase);
  }

  /** Makes steps to a share of the progress, within the budget, and pauses there. */
  #seek(share: number): void {
    const end = this.frames.now() + this.#settleMs;
    while (this.river.phase !== "finished" && progressOf(this.river) < share) {
      this.river.advance(1);
      if (this.frames.now() >= end) return;
    }
    if (this.river.phase !== "finished") this.#become({ is: "paused" });
  }

  /** Makes a draft until something has been shown; then waits for the hand to rest. */
  #follow({ shown, since }: Following, phase: Phase): void {
    if (shown === "nothing") this.#makeDraft(phase);
    else if (this.frames.now() - since >= REST_MS) this.#advance(phase, 1, this.#settleMs);
  }

  /** Returns whether a picture should be painted. A settling river is painted seldom, and one that nobody sees at its end. */
  #isWorthShowing(now: number, before: Phase): boolean {
    const { phase } = this.river;
    const course = this.#course;
    if (course.is === "seeking" || (this.#isPassed && this.#runs)) return phase === "finished";
    if ((course.is !== "settling" && course.is !== "following") || phase === "finished") return true;
    const isFollowing = course.is === "following";
    if (isFollowing && (phase === "meandering" || phase === "relief")) return course.shown !== "rivers";
    const isGrown = before === "growing" && phase !== before;
    const isFirst = !isFollowing && !course.hasShown && course.from === "growing" && phase === "meandering";
    const quietMs = isFirst ? FIRST_QUIET_MS : SETTLE_QUIET_MS;
    return (isGrown && (isFollowing || course.showsTree)) || now - course.shownAt >= quietMs;
  }

  #show(now: number): void {
    const { phase } = this.river;
    this.#picture = this.#paint() ? "begun" : "none";
    if (this.#picture === "begun") return;
    note(this.#course, phase, now);
    if (this.#runs && phase === "finished") this.#become({ is: "finished" });
    if (!this.isBusy) this.events.ready();
  }

  /** Paints within the budget. Returns whether there is more to do. */
  #paint(): boolean {
    const isWatched = this.#course.is === "growing" && !this.#isPassed;
    const end = this.frames.now() + (isWatched ? PAINT_BUDGET_MS : (this.frames.waitMs ?? PAINT_BUDGET_MS));
    const asDraft = this.#course.is === "following" && this.river.phase !== "finished";
    while (this.events.draw(asDraft)) {
      if (this.frames.now() >= end) return true;
    }
    return false;
  }

  /** Makes steps until there is something new to show, or the budget is spent. */
  #makeDraft(before: Phase): void {
    const end = this.frames.now() + DRAFT_BUDGET_MS;
    const { river } = this;
    const isGrown = (): boolean => before === "growing" && river.phase !== before;
    do river.advance(1);
    while (!isGrown() && river.phase !== "relief" && river.phase !== "finished" && this.frames.now() < end);
  }

  /** Advances by some seconds of the animation. Steps that do not fit in the budget make the animation longer. */
  #animate(course: Extract<Course, { is: "growing" }>, phase: Phase, seconds: number): void {
    const pace = this.#paceOf(phase);
    if (course.pace?.phase !== phase) {
      course.pace = { phase, spent: pace.seconds * pace.timeAt(this.river.progress) };
    }
    const spent = course.pace.spent + seconds;
    const share = spent < pace.seconds ? pace.shareAt(spent / pace.seconds) : 1;
    if (this.#advance(phase, share, FRAME_BUDGET_MS)) course.pace.spent = spent;
  }

  #paceOf(phase: Phase): Pace {
    if (phase === "growing") return GROWING;
    return { seconds: this.#secondsOf(phase), shareAt: (time) => time, timeAt: (share) => share };
  }

  /** The time of a phase that goes on evenly; 0 for those of which nothing is seen on the way. */
  #secondsOf(phase: Phase): number {
    if (phase === "drowning") return RISE_SECONDS;
    return phase === "meandering" ? Math.min(MEANDER_SECONDS, this.river.rounds / ROUNDS_PER_SECOND) : 0;
  }

  /**
   * Makes steps until this share of the phase is done, 1 for its end. Returns whether there was time for them. It
   * checks the clock after every step: a step takes far longer than that, and the longest step bounds how late a frame
   * can be. The next phase begins with the next frame, so that its first picture is seen.
   */
  #advance(phase: Phase, share: number, budgetMs: number): boolean {
    const end = this.frames.now() + budgetMs;
    const isDue = (): boolean => this.river.phase === phase && (share === 1 || this.river.progress < share);
    while (isDue()) {
      // That was the last step, or other rivers move the shared clock.
      if (!this.river.advance(1)) return true;
      if (this.frames.now() >= end) return !isDue();
    }
    return true;
  }
}

function stateOf({ is }: Course): State {
  return is === "following" || is === "seeking" ? "settling" : is;
}

/** Returns whether a river is settling and no picture has shown anything new of it. */
function hidesNews(course: Course): boolean {
  return course.is === "settling" ? !course.hasShown : course.is === "following" && course.shown === "nothing";
}

/**
 * Notes what a picture has shown of a settling river. The old rivers and relief stay in the picture until there are new
 * ones.
 */
function note(course: Course, phase: Phase, now: number): void {
  if (course.is !== "settling" && course.is !== "following") return;
  course.shownAt = now;
  const isOfRivers =
    phase === "meandering" || phase === "finished" || (phase === "relief" && course.is === "following");
  const isOfTree = phase === "drowning" || phase === "shaping";
  const isNews = isOfRivers || (isOfTree && course.from === "growing");
  if (course.is === "settling") course.hasShown ||= isNews;
  else if (isNews || course.shown !== "nothing") {
    course.shown = isOfTree && course.shown !== "rivers" ? "tree" : "rivers";
  }
}
