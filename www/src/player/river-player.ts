/**
 * Grows and draws a river on a canvas, and reports its progress. It uses no document, so that it works in a worker as
 * well.
 */

import type { CanvasSize } from "../browser/canvas.ts";
import type { LabelFacts, Phase, ReadOptions, River } from "../engine/types.ts";
import { Blitter } from "./blit.ts";
import { type Drafting, Drafts } from "./drafts.ts";
import { FrameLoop, type Frames, type Growing, REST_MS, type State } from "./frame-loop.ts";
import { progressOf } from "./progress.ts";
import type { SharedClock } from "./shared-clock.ts";
import type { Canvas, LinkToRead, Reading, ShowMode, Status, Wanted } from "./showing.ts";

export type * from "./showing.ts";

export interface PlayerEvents {
  /** Returns the size that the canvas should have for a river of this shape; 0 if it is not shown. */
  sizeFor(aspect: number): CanvasSize;
  /** Called when the link, the state or the river changed. */
  changed(reading: Reading, status: Status): void;
  failed(error: unknown): void;
  /**
   * Called when the letters that a link carries are for another map or picture, and this engine places none. The player is
   * closed then; `how` is the way to show the map with another engine.
   */
  unlettered?(how: ShowMode): void;
}

/**
 * The time between two reports while a river grows or meanders: counting its sources takes time, and nobody reads
 * faster.
 */
const COUNT_EVERY_MS = 250;

/**
 * Changes by a hand are shown at once, unless they come sooner than this after the last: then the latest one is shown
 * in the next frame.
 */
const AT_ONCE_MS = 16;

/** The methods of the whole engine's rivers that others lack. */
interface Controlled extends Drafting {
  frame(framing: Float32Array): void;
  labels(): LabelFacts[];
}

/** The part of an engine that makes rivers. */
export interface RiverMaker<R> {
  readonly engine: { readonly River: new (text: string, options?: ReadOptions) => R };
  readonly memory: WebAssembly.Memory;
}

export class RiverPlayer<R extends River & Partial<Controlled> = River> {
  /** The link to change to, until that is done. */
  #wanted: Wanted | undefined;
  #reading: Reading;
  /** The number of links it was asked to show after the first. */
  #links = 0;
  #followedAt = Number.NEGATIVE_INFINITY;
  #applying: number | undefined;
  /** The time before which no labels are made, since the hand may move on, and the frame that checks for it. */
  #labelling: { from: number; handle: number } | undefined;
  /** The phase and time of the last report. */
  #told: { phase: Phase; at: number } | undefined;
  #canRun = true;
  #view: Pick<CanvasSize, "ratio" | "framing"> = { ratio: 1 };
  readonly #river: R;
  /** The river, or the member of the shared clock that stands in for it while it grows. */
  readonly #growing: Growing;
  readonly #loop: FrameLoop;
  readonly #blitter: Blitter;
  readonly #drafts: Drafts;

  /** Puts a river on the canvas at tick 0. Throws the core's errors. */
  constructor(
    core: RiverMaker<R>,
    private readonly canvas: Canvas,
    private readonly first: LinkToRead,
    private readonly frames: Frames,
    private readonly events: PlayerEvents,
    private readonly clock?: SharedClock,
  ) {
    this.#blitter = new Blitter(contextOf(canvas), core.memory);
    this.#river = new core.engine.River(first.text, first.options);
    this.#reading = this.#readRiver();
    this.#drafts = new Drafts(this.#river, () => frames.now());
    this.#growing = clock?.join(this.#river) ?? this.#river;
    this.#loop = new FrameLoop(this.#growing, frames, {
      draw: (asDraft) => this.#draw(asDraft),
      ready: () => this.#followWanted(),
      changed: () => this.#tell(),
      failed: (error) => events.failed(error),
    });
  }

  /** The canonical link of the river on the canvas. */
  get link(): string {
    return this.#reading.link;
  }

  /** The number of links it was asked to show after the first. */
  get links(): number {
    return this.#links;
  }

  /**
   * The river on the canvas, for questions. Undefined once the player is closed, since after a failure it may not be
   * used.
   */
  get river(): R | undefined {
    return this.#canRun ? this.#river : undefined;
  }

  get state(): State {
    return this.#loop.state;
  }

  /** The names on the picture. */
  get labels(): readonly LabelFacts[] {
    return this.river?.labels?.() ?? [];
  }

  set speed(speed: number) {
    this.#loop.speed = speed;
  }

  /** Shows the first river. */
  start(how: ShowMode): void {
    this.#attempt(() => {
      if (!this.#takeLetters(this.first, how)) return;
      this.#fit();
      this.#grow(how);
    });
  }

  toggle(): void {
    this.#onWanted(() => this.#loop.toggle());
  }

  play(): void {
    this.#onWanted(() => this.#loop.play());
  }

  pause(): void {
    this.#onWanted(() => this.#loop.pause());
  }

  /** Pauses, and shows the river as it is. */
  hold(): void {
    this.#onWanted(() => this.#loop.hold());
  }

  replay(): void {
    this.#onWanted(() => this.#loop.replay());
  }

  /** Goes to the finished river without animation. */
  finish(): void {
    if (this.state !== "finished") this.#attempt(() => this.#loop.settle(false));
  }

  /** Goes to a share of the progress and pauses there. */
  seek(share: number): void {
    this.#onWanted(() => this.#loop.seek(share));
  }

  /** Makes no steps until `wake`, while nobody sees the river. */
  rest(): void {
    this.#attempt(() => this.#loop.rest());
  }

  /** Goes to the finished river, without pictures, while nobody sees it. */
  finishUnseen(): void {
    this.#attempt(() => this.#loop.finishUnseen());
  }

  wake(): void {
    this.#attempt(() => this.#loop.wake());
  }

  /**
   * Shows another recipe. While the river of a dragged slider is settling and has not been seen, only the latest link
   * is remembered: otherwise each new value would discard the work for the last one, and none would ever be seen.
   */
  show(link: LinkToRead, how: ShowMode): void {
    this.#wanted = { link, how };
    this.#links++;
    if (how !== "watch" && this.#loop.isBusy) return;
    const follow = (): void => {
      this.#applyNow();
      if (how === "settle") this.#attempt(() => this.#loop.hurry());
      this.#followedAt = this.frames.now();
    };
    const isHandAlone = how === "settle" && this.#river.paintDraft !== undefined && this.#applying === undefined;
    if (isHandAlone && this.frames.now() - this.#followedAt >= AT_ONCE_MS) follow();
    else this.#applying ??= this.frames.request(follow);
  }

  /** Gives the canvas the size that it should have. The river stays the same. */
  resize(): void {
    this.#attempt(() => this.#fit());
  }

  /** Stops for good. The river is not freed, since after some failures it may not be used. */
  close(): void {
    this.#canRun = false;
    this.clock?.leave(this.#growing);
    this.#loop.close();
    for (const handle of [this.#applying, this.#labelling?.handle])
      if (handle !== undefined) this.frames.cancel(handle);
  }

  /** Stops for good and frees the river. May be called only once. */
  free(): void {
    this.close();
    this.#river.free();
  }

  #applyNow(): void {
    if (this.#applying !== undefined) this.frames.cancel(this.#applying);
    this.#applying = undefined;
    this.#attempt(() => this.#apply());
  }

  #apply(): void {
    const wanted = this.#wanted;
    if (!wanted || this.#showsDraft(wanted)) return;
    const isDrafted = this.#drafts.areShown;
    // The hand has seen a draft of this link, and has not moved since.
    const isAtRest = this.#drafts.seenSince(wanted) !== undefined;
    this.#wanted = undefined;
    const stage = this.#change(wanted, isDrafted);
    this.#reading = this.#readRiver();
    if (!this.#takeLetters(wanted.link, wanted.how)) return;
    if (stage === "none") {
      // The picture stays, unless it is a draft, but its link is reported. A settling river goes on.
      if (isDrafted || this.state === "settling") this.#loop.redraw();
      this.#tell();
      return;
    }
    this.#fit();
    const { phase } = this.#river;
    // A style may show the relief of finished rivers for the first time, and then it has to be made.
    const isDrawing = (stage === "paint" || stage === "name") && (phase === "finished" || this.state !== "finished");
    if (stage === "land" || stage === "grow") this.#grow(wanted.how, isAtRest);
    else if (isDrawing || phase === "growing") this.#loop.redraw();
    else if (wanted.how === "settle" && (stage !== "relief" || isDrafted)) this.#loop.follow(isDrafted);
    else this.#loop.settle(false);
    if (wanted.how === "settle" && stage === "relief" && !isDrafted) this.#labelAtRest(this.frames.now() + REST_MS);
  }

  /** Changes the river to a link. If the link is refused, a draft is painted over. */
  #change(wanted: Wanted, isDrafted: boolean): ReturnType<River["change"]> {
    try {
      return this.#drafts.leaveFor(wanted);
    } catch (error) {
      if (isDrafted) this.#loop.redraw();
      throw error;
    }
  }

  /** Hands the river its letters. Returns whether the map can have them. */
  #takeLetters({ letters }: LinkToRead, how: ShowMode): boolean {
    if (letters === undefined) return true;
    const { width, height, ratio } = this.events.sizeFor(this.#river.aspect);
    if (this.#river.takeLetters(letters, width, height, ratio)) return true;
    this.#leave(how);
    return false;
  }

  /** Closes, since another engine has to show the map. */
  #leave(how: ShowMode): void {
    this.close();
    this.events.unlettered?.(how);
  }

  /** Paints one more picture, unless a draft is shown: then one will be painted when the hand rests. */
  #redraw(): void {
    if (!this.#drafts.areShown) this.#loop.redraw();
  }

  /**
   * Shows a draft for sliders of width, relief and coasts; the exact river follows when the hand has rested for
   * `REST_MS`. Returns whether a draft is on the canvas or has been begun.
   */
  #showsDraft(wanted: Wanted): boolean {
    const { state } = this;
    const isThere = state === "finished" || (state === "settling" && this.#river.phase === "relief");
    if (wanted.how !== "settle" || !isThere || !this.#canRun) return false;
    const now = this.frames.now();
    const seenAt = this.#drafts.seenSince(wanted);
    const isResting = seenAt !== undefined && now - seenAt >= REST_MS;
    if (isResting || (seenAt === undefined && !this.#paintDraft(wanted, now))) return false;
    this.#applying ??= this.frames.request(() => this.#applyNow());
    return true;
  }

  /** Paints a part of a draft. Returns whether a draft is possible. */
  #paintDraft(wanted: Wanted, now: number): boolean {
    if (!this.#drafts.isOnCanvas && wanted.link.text === this.link) return false;
    const drafted = this.#drafts.paint(wanted, now);
    if (drafted === "impossible") return false;
    // No more steps for the old river.
    this.#loop.halt();
    if (drafted === "whole") this.#blitter.blit(this.#river);
    return true;
  }

  #labelAtRest(from: number): void {
    const handle = this.#labelling?.handle ?? this.frames.request(() => this.#labelNow());
    this.#labelling = { from, handle };
  }

  #labelNow(): void {
    const from = this.#labelling?.from ?? 0;
    this.#labelling = undefined;
    if (this.frames.now() < from) this.#labelAtRest(from);
    else if (this.state === "finished") this.#attempt(() => this.#redraw());
  }

  #readRiver(): Reading {
    const { link, seed, aspect, notices } = this.#river;
    return { link, seed, aspect, notices, links: this.#links };
  }

  /**
   * Grows the river. `isAtRest` means that the hand has seen a draft and waits for the exact map, so that there are no
   * more drafts.
   */
  #grow(how: ShowMode, isAtRest = false): void {
    if (how === "watch") this.#loop.watch();
    else if (how === "settle" && !isAtRest) this.#loop.follow();
    else this.#loop.settle(isAtRest);
  }

  #draw(asDraft: boolean): boolean {
    const drafted = asDraft ? this.#river.paintUnfinished?.() : undefined;
    const isMore = drafted === undefined || drafted === "impossible" ? this.#paint() : drafted === "part";
    if (isMore) return true;
    if (this.#river.lacksLetters) {
      this.#leave("still");
      return false;
    }
    this.#blitter.blit(this.#river);
    const isStill = this.state === "finished" || this.state === "paused";
    const told = this.#told;
    const isNews = isStill || told?.phase !== this.#river.phase;
    if (isNews || this.frames.now() - told.at >= COUNT_EVERY_MS) this.#tell();
    return false;
  }

  /** Does a part of painting. Returns whether there is more to do. */
  #paint(): boolean {
    const mayLabel = !this.#labelling || this.frames.now() >= this.#labelling.from;
    return this.#river.paint(!mayLabel);
  }

  #tell(): void {
    if (!this.#canRun) return;
    const { phase } = this.#river;
    this.#told = { phase, at: this.frames.now() };
    this.events.changed(this.#reading, {
      state: this.state,
      phase,
      progress: progressOf(this.#river),
      summary: this.#river.summary(),
    });
  }

  /**
   * Changes to the remembered link at once, not in the next frame: then a pen or a slider is followed twice as often.
   */
  #followWanted(): void {
    if (this.#wanted) this.#applyNow();
  }

  /** Does some work on the river that was requested last, which may still wait for a frame. */
  #onWanted(work: () => void): void {
    this.#followWanted();
    this.#attempt(work);
  }

  #fit(): void {
    const { canvas } = this;
    const river = this.#river;
    const { width, height, ratio, framing } = this.events.sizeFor(river.aspect);
    if (width === 0 || height === 0) return;
    const before = this.#view;
    // Letters are measured in quarters of a ratio.
    const isAsDense = Math.round(ratio * 4) === Math.round(before.ratio * 4);
    const isAsLarge = width === river.width && height === river.height && isAsDense;
    const isFramed = `${framing}` === `${before.framing}`;
    if (isAsLarge && isFramed && width === canvas.width && height === canvas.height) return;
    if (!isAsLarge) river.resize(width, height, ratio);
    river.frame?.(new Float32Array(framing ?? []));
    this.#view = framing ? { ratio, framing } : { ratio };
    // Setting its size clears a canvas, so it is painted again before the browser can show that.
    canvas.width = width;
    canvas.height = height;
    while (this.#paint());
    if (river.lacksLetters) {
      this.#leave("still");
      return;
    }
    this.#blitter.blit(river);
    // A draft is shown again, in the new size.
    this.#drafts.forget();
  }

  /** Does some work and reports its failure. Does nothing once the player is closed. */
  #attempt(work: () => void): void {
    if (!this.#canRun) return;
    try {
      work();
    } catch (error) {
      this.events.failed(error);
    }
  }
}

/** Returns a context that replaces pixels rather than mixing them. */
export function contextOf(canvas: Canvas): CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D {
  // Both kinds of canvas take the same arguments, but the union of their types does not allow it.
  const context = (canvas as OffscreenCanvas).getContext("2d", { alpha: false });
  if (!context) throw new Error("this browser gives no 2D canvas");
  return context;
}
