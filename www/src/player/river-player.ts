/**
 * A river on a canvas: grows and draws it, and says how far it is. It knows no document, so that it works in a worker as well.
 */

import type { CanvasSize, Framing } from "../browser/canvas.ts";
import type { Phase, ReadOptions, River, Summary } from "../engine/types.ts";
import { Blitter } from "./blit.ts";
import { ChartMaker, type LoadCharts } from "./chart-maker.ts";
import { FrameLoop, type Frames, type Growing, REST_MS, type State } from "./frame-loop.ts";
import type { SharedClock } from "./shared-clock.ts";

export type Canvas = HTMLCanvasElement | OffscreenCanvas;

/**
 * watch: see it grow and meander; settle: as soon as may be, for a slider that is being dragged: the tree when it is grown, or a draft of
 * the rivers, and when the hand rests its finished rivers; still: nothing but finished rivers.
 */
export type ShowMode = "watch" | "settle" | "still";

/** A link, and how it is to be read. */
export interface LinkToRead {
  text: string;
  options?: ReadOptions;
}

export interface PlayerEvents {
  /** The canvas is about to hold a river of this shape: how many pixels should it have? None if it is not shown. */
  sizeFor(aspect: number): CanvasSize;
  /** The river is of another link from now on. */
  created?(river: River): void;
  /** Something of the picture changed: the state, or in it the river. */
  changed(state: State, phase: Phase, summary: Summary): void;
  failed(error: unknown): void;
}

/** While the river grows or meanders its numbers are read this often: counting all its sources is not free, and nobody reads faster. */
const COUNT_EVERY_MS = 250;

/** A hand is followed at once, but for what comes sooner than this after the last: that waits for a frame, and the latest alone is shown. */
const AT_ONCE_MS = 16;

/** A draft on courses that are there may take so long at once: a hand sees it sooner than in parts, a frame each. */
const DRAFT_AT_ONCE_MS = 46;

/** A river that can show a part of its map, and drafts, as those of the full engine can. */
interface Framed {
  frame(framing: Float32Array): void;
  paintDraft(text: string, options?: ReadOptions): boolean | undefined;
}

interface Wanted {
  link: LinkToRead;
  how: ShowMode;
}

/** What of an engine makes rivers: a lean one, or a full one. */
export interface RiverMaker<R> {
  readonly engine: { readonly River: new (text: string, options?: ReadOptions) => R };
  readonly memory: WebAssembly.Memory;
  /** Fetches what makes charts of its rivers. */
  readonly loadCharts: LoadCharts;
}

export class RiverPlayer<R extends River & Partial<Framed> = River> {
  #wanted: Wanted | undefined;
  /** The one that is shown by a draft of what there is, until the hand rests; and the one whose draft is being painted. */
  #drafted: { wanted: Wanted; at: number } | undefined;
  #drafting: Wanted | undefined;
  #shown: LinkToRead;
  #link = "";
  #followedAt = Number.NEGATIVE_INFINITY;
  /** Before then there are no labels: the hand may move on. */
  #labelsFrom = Number.NEGATIVE_INFINITY;
  #labelling: number | undefined;
  #applying: number | undefined;
  #counted = Number.NEGATIVE_INFINITY;
  #told: Phase | undefined;
  #canRun = true;
  #ratio = 1;
  #framing: Framing | undefined;
  readonly #river: R;
  /** As it grows by the clock that it shares with others, if there is one. */
  readonly #growing: Growing;
  readonly #loop: FrameLoop;
  readonly #blitter: Blitter;
  readonly #chartMaker: ChartMaker;

  /** Puts a river on the canvas at tick 0. Throws what the core throws. */
  constructor(
    core: RiverMaker<R>,
    private readonly canvas: Canvas,
    link: LinkToRead,
    private readonly frames: Frames,
    private readonly events: PlayerEvents,
    private readonly clock?: SharedClock,
  ) {
    this.#blitter = new Blitter(contextOf(canvas), core.memory);
    this.#river = new core.engine.River(link.text, link.options);
    this.#shown = link;
    this.#tellOfLink();
    this.#chartMaker = new ChartMaker(core.loadCharts, {
      arrived: () => this.#attempt(() => this.#redraw()),
      failed: (error) => this.#attempt(() => events.failed(error)),
    });
    this.#growing = clock?.join(this.#river) ?? this.#river;
    this.#loop = new FrameLoop(this.#growing, frames, {
      draw: (asDraft) => this.#draw(asDraft),
      ready: () => this.#followWanted(),
      changed: () => this.#tell(),
      failed: (error) => events.failed(error),
    });
  }

  /** The canonical link of the river that is on the canvas. */
  get link(): string {
    return this.#link;
  }

  /** The river on the canvas, to be looked at; after a failure nothing of it may be called, so there is none. */
  get river(): R | undefined {
    return this.#canRun ? this.#river : undefined;
  }

  get state(): State {
    return this.#loop.state;
  }

  set speed(speed: number) {
    this.#loop.speed = speed;
  }

  /** Shows the first river. */
  start(how: ShowMode): void {
    this.#attempt(() => {
      this.#fit();
      this.#grow(how);
    });
  }

  toggle(): void {
    this.#attempt(() => this.#loop.toggle());
  }

  play(): void {
    this.#attempt(() => this.#loop.play());
  }

  pause(): void {
    this.#attempt(() => this.#loop.pause());
  }

  /** Stands still, and shows the river as it is. */
  hold(): void {
    this.#attempt(() => this.#loop.hold());
  }

  replay(): void {
    this.#attempt(() => this.#loop.replay());
  }

  /** To the finished river without animation, whatever it is doing. */
  finish(): void {
    if (this.state !== "finished") this.#attempt(() => this.#loop.settle(false));
  }

  /** Nobody sees it: no steps until somebody does. */
  rest(): void {
    this.#attempt(() => this.#loop.rest());
  }

  wake(): void {
    this.#attempt(() => this.#loop.wake());
  }

  /**
   * Shows another recipe. While a dragged slider's river still settles unseen, only the latest of the links that come in
   * is remembered: otherwise each new value would throw the work for the last away, and none would ever be seen.
   */
  show(link: LinkToRead, how: ShowMode): void {
    this.#wanted = { link, how };
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

  /** Gives the canvas the size it should have; the river stays the same. */
  resize(): void {
    this.#attempt(() => this.#fit());
  }

  /** Stops for good. The river is not freed: after some failures nothing may be asked of it. */
  close(): void {
    this.#canRun = false;
    this.clock?.leave(this.#growing);
    this.#loop.close();
    for (const handle of [this.#applying, this.#labelling]) if (handle !== undefined) this.frames.cancel(handle);
  }

  /** Stops for good, if it has not, and gives the river's memory back, once. */
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
    const isDrafted = this.#isDrafted;
    // It has seen a draft of this very link, and has not moved since.
    const isAtRest = this.#drafted?.wanted === wanted;
    this.#wanted = this.#drafted = this.#drafting = undefined;
    const stage = this.#change(wanted.link, isDrafted);
    this.#shown = wanted.link;
    this.#tellOfLink();
    if (stage === "none") {
      // The picture stays, unless it is a draft; that it is of this link is news. What settles goes on.
      if (isDrafted || this.state === "settling") this.#loop.redraw();
      this.#tell();
      return;
    }
    this.#fit();
    const { phase } = this.#river;
    // Of finished rivers a style may show a relief that none has shown before, and that is yet to be made.
    const isDrawing = (stage === "paint" || stage === "name") && (phase === "finished" || this.state !== "finished");
    if (stage === "land" || stage === "grow") this.#grow(wanted.how, isAtRest);
    else if (isDrawing || phase === "growing") this.#loop.redraw();
    else if (wanted.how === "settle" && (stage !== "relief" || isDrafted)) this.#loop.follow(isDrafted);
    else this.#loop.settle(false);
    if (wanted.how === "settle" && stage === "relief" && !isDrafted) this.#labelAtRest(this.frames.now() + REST_MS);
  }

  get #isDrafted(): boolean {
    return (this.#drafted ?? this.#drafting) !== undefined;
  }

  /** Goes over to a link. One that is refused leaves no draft behind. */
  #change({ text, options }: LinkToRead, isDrafted: boolean): ReturnType<River["change"]> {
    try {
      return this.#river.change(text, options);
    } catch (error) {
      if (isDrafted) this.#loop.redraw();
      throw error;
    }
  }

  /** One more picture, unless a draft is shown: then there will be one anyway, at rest. */
  #redraw(): void {
    if (!this.#isDrafted) this.#loop.redraw();
  }

  /**
   * Another width is shown at once on the courses that are there, which it will change a little, other mountains nearly as they will be, and
   * other coasts around the rivers that are there: the river goes over to them when the hand rests. Returns whether that is so, and not yet.
   */
  #showsDraft(wanted: Wanted): boolean {
    const { state } = this;
    const isThere = state === "finished" || (state === "settling" && this.#river.phase === "relief");
    if (wanted.how !== "settle" || !isThere || !this.#canRun) return false;
    const now = this.frames.now();
    if (this.#drafted?.wanted !== wanted) {
      if (!this.#drafted && wanted.link.text === this.#link) return false;
      // What was begun is seen first: a fast hand would starve it.
      if (!this.#paintDraft(this.#drafting ?? wanted, now)) return false;
    } else if (now - this.#drafted.at >= REST_MS) return false;
    this.#applying ??= this.frames.request(() => this.#applyNow());
    return true;
  }

  /** Paints a draft, or as much of it as there is time for. Returns whether there can be one. */
  #paintDraft(wanted: Wanted, now: number): boolean {
    const { text, options } = wanted.link;
    let isMore: boolean | undefined;
    do isMore = this.#river.paintDraft?.(text, options);
    while (isMore && this.frames.now() - now < DRAFT_AT_ONCE_MS);
    this.#drafting = isMore ? wanted : undefined;
    if (isMore === undefined) return false;
    // Nothing is made exactly of what the hand has left.
    this.#loop.halt();
    if (isMore) return true;
    this.#blitter.blit(this.#river);
    this.#drafted = { wanted, at: now };
    return true;
  }

  #labelAtRest(time: number): void {
    this.#labelsFrom = time;
    this.#labelling ??= this.frames.request(() => {
      this.#labelling = undefined;
      if (this.frames.now() < this.#labelsFrom) this.#labelAtRest(this.#labelsFrom);
      else if (this.state === "finished") this.#attempt(() => this.#redraw());
    });
  }

  #tellOfLink(): void {
    this.#link = this.#river.link;
    this.events.created?.(this.#river);
  }

  /** After a draft the hand rests, and waits for the exact map: there are no more drafts. */
  #grow(how: ShowMode, isAtRest = false): void {
    if (how === "watch") this.#loop.watch();
    else if (how === "settle" && !isAtRest) this.#loop.follow();
    else this.#loop.settle(isAtRest);
  }

  #draw(asDraft: boolean): boolean {
    const { text, options } = this.#shown;
    const isMore = asDraft ? this.#river.paintDraft?.(text, options) : undefined;
    if (isMore ?? this.#paint()) return true;
    this.#blitter.blit(this.#river);
    const still = this.state === "finished" || this.state === "paused";
    const isNews = still || this.#told !== this.#river.phase;
    if (isNews || this.frames.now() - this.#counted >= COUNT_EVERY_MS) this.#tell();
    return false;
  }

  /** Does a part of painting. Returns whether there is more to do. */
  #paint(): boolean {
    const mayLabel = this.frames.now() >= this.#labelsFrom;
    return (mayLabel && this.#chartMaker.lay(this.#river, this.#ratio, this.#framing)) || this.#river.paint();
  }

  #tell(): void {
    this.#counted = this.frames.now();
    this.#told = this.#river.phase;
    this.events.changed(this.state, this.#told, this.#river.summary());
  }

  /** At once, not in the next frame: what follows a pen or a slider is seen twice as often. */
  #followWanted(): void {
    if (this.#wanted) this.#applyNow();
  }

  #fit(): void {
    const { canvas } = this;
    const river = this.#river;
    const { width, height, ratio, framing } = this.events.sizeFor(river.aspect);
    if (width === 0 || height === 0) return;
    // As finely as letters are measured.
    const isAsDense = Math.round(ratio * 4) === Math.round(this.#ratio * 4);
    const isAsLarge = width === river.width && height === river.height && isAsDense;
    const isFramed = `${framing}` === `${this.#framing}`;
    if (isAsLarge && isFramed && width === canvas.width && height === canvas.height) return;
    if (!isAsLarge) river.resize(width, height);
    river.frame?.(new Float32Array(framing ?? []));
    this.#ratio = ratio;
    this.#framing = framing;
    // Setting its size empties a canvas, so it is filled again before the browser can show that.
    canvas.width = width;
    canvas.height = height;
    while (this.#paint());
    this.#blitter.blit(river);
    // A draft is shown again, in the new size.
    this.#drafted = this.#drafting = undefined;
  }

  /** Whatever is asked after the end is passed over. */
  #attempt(work: () => void): void {
    if (!this.#canRun) return;
    try {
      work();
    } catch (error) {
      this.events.failed(error);
    }
  }
}

/** What is put on a canvas without mixing it with what was there. */
export function contextOf(canvas: Canvas): CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D {
  // Both kinds of canvas take the same, which their types do not say of the two together.
  const context = (canvas as OffscreenCanvas).getContext("2d", { alpha: false });
  if (!context) throw new Error("this browser gives no 2D canvas");
  return context;
}
