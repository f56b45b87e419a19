/** The plate: the canvas, the river on it, and the loop that grows and draws it. */

import type { Phase, River, Summary } from "../pkg/riverseed.js";
import { Blitter } from "./blit.ts";
import { backingSize } from "./canvas.ts";
import { Growth, type State } from "./growth.ts";
import type { Core } from "./wasm.ts";

/**
 * watch: see it grow and meander; settle: as soon as may be, for a slider that is being dragged: the tree when it is grown,
 * then its finished rivers; still: nothing but finished rivers.
 */
export type How = "watch" | "settle" | "still";

export interface PlateParts {
  /** Holds the picture and what stands under it; is told the river's shape. */
  sheet: HTMLElement;
  /** Has the river's shape. */
  frame: HTMLElement;
  canvas: HTMLCanvasElement;
}

export interface PlateEvents {
  /** Something on the plate changed: the state, or in it the river. */
  changed(state: State, phase: Phase, summary: Summary): void;
  failed(error: unknown): void;
}

/** While the river grows or meanders its numbers are read this often: counting all its sources is not free, and nobody reads faster. */
const COUNT_EVERY_MS = 250;
/** While a window is dragged wider the old picture is stretched; it is drawn anew when the hand rests this long. */
const RESIZE_PAUSE_MS = 120;

export class Plate {
  #wanted: { link: string; how: How } | undefined;
  #link: string;
  #applying = 0;
  #resizing: ReturnType<typeof setTimeout> | undefined;
  #counted = Number.NEGATIVE_INFINITY;
  #told: Phase | undefined;
  #canRun = true;
  readonly #growth: Growth;
  readonly #blitter: Blitter;
  readonly #observer: ResizeObserver;

  private constructor(
    private readonly parts: PlateParts,
    context: CanvasRenderingContext2D,
    private readonly river: River,
    memory: WebAssembly.Memory,
    link: string,
    private readonly events: PlateEvents,
  ) {
    this.#link = link;
    this.#blitter = new Blitter(context, memory);
    const frames = { request: requestAnimationFrame.bind(window), cancel: cancelAnimationFrame.bind(window) };
    this.#growth = new Growth(
      river,
      { ...frames, now: () => performance.now() },
      {
        draw: () => this.#draw(),
        ready: () => this.#followWish(),
        changed: () => this.#tell(),
        failed: (error) => this.events.failed(error),
      },
    );
    this.#observer = new ResizeObserver(() => this.#resizeSoon());
    this.#observe();
    document.addEventListener("visibilitychange", () => this.#followVisibility());
  }

  /** Puts a river on the canvas at tick 0. Throws what the core throws. */
  static open(core: Core, parts: PlateParts, link: string, events: PlateEvents): Plate {
    const context = parts.canvas.getContext("2d", { alpha: false });
    if (!context) throw new Error("this browser gives no 2D canvas");
    // Any size will do to learn the river's shape, on which the canvas's size depends.
    const river = new core.engine.River(link, 16, 16);
    return new Plate(parts, context, river, core.memory, link, events);
  }

  /** The link of the river that is on the plate. */
  get link(): string {
    return this.#link;
  }

  get state(): State {
    return this.#growth.state;
  }

  set speed(speed: number) {
    this.#growth.speed = speed;
  }

  toggle(): void {
    if (this.#canRun) this.#attempt(() => this.#growth.toggle());
  }

  replay(): void {
    if (this.#canRun) this.#attempt(() => this.#growth.replay());
  }

  /** Shows the first river. */
  start(how: How): void {
    this.#attempt(() => {
      this.#fit();
      this.#grow(how);
    });
  }

  /**
   * Shows another recipe. While a dragged slider's river still settles unseen, only the latest of the links that come in
   * is remembered: otherwise each new value would throw the work for the last away, and none would ever be seen.
   */
  show(link: string, how: How): void {
    this.#wanted = { link, how };
    if (how === "watch" || !this.#growth.isBusy) this.#applySoon();
  }

  #applySoon(): void {
    this.#applying ||= requestAnimationFrame(() => this.#applyNow());
  }

  #applyNow(): void {
    cancelAnimationFrame(this.#applying);
    this.#applying = 0;
    if (this.#canRun) this.#attempt(() => this.#apply());
  }

  #apply(): void {
    const wanted = this.#wanted;
    if (!wanted) return;
    this.#wanted = undefined;
    const stage = this.river.change(wanted.link);
    this.#link = wanted.link;
    if (stage === "none") return;
    this.#fit();
    if (stage === "land" || stage === "grow") this.#grow(wanted.how);
    else if (stage === "paint" || this.river.phase === "growing") this.#growth.redraw();
    else this.#growth.settle(false);
  }

  #grow(how: How): void {
    if (how === "watch") this.#growth.watch();
    else this.#growth.settle(how === "settle");
  }

  #paint(): void {
    if (this.river.paint()) this.#blitter.blit(this.river);
  }

  #draw(): void {
    this.#paint();
    const still = this.state === "finished" || this.state === "paused";
    const isNews = still || this.#told !== this.river.phase;
    if (isNews || performance.now() - this.#counted >= COUNT_EVERY_MS) this.#tell();
  }

  #tell(): void {
    this.#counted = performance.now();
    this.#told = this.river.phase;
    this.events.changed(this.state, this.#told, this.river.summary());
  }

  /** At once, not in the next frame: what follows a pen or a slider is seen twice as often. */
  #followWish(): void {
    if (this.#wanted) this.#applyNow();
  }

  /** Makes the frame the river's shape and the picture the frame's size; the river stays the same. */
  #fit(): void {
    const { sheet, frame, canvas } = this.parts;
    sheet.style.setProperty("--aspect", String(this.river.aspect));
    const { width, height } = backingSize(frame.getBoundingClientRect(), window.devicePixelRatio);
    if (width === 0 || height === 0) return;
    const same = width === this.river.width && height === this.river.height;
    if (same && width === canvas.width && height === canvas.height) return;
    this.river.resize(width, height);
    // Setting its size empties a canvas, so it is filled again before the browser can show that.
    canvas.width = width;
    canvas.height = height;
    this.#paint();
  }

  /** Follows the frame's size, in the screen's pixels if the browser can: they change alone between two screens. */
  #observe(): void {
    try {
      this.#observer.observe(this.parts.frame, { box: "device-pixel-content-box" });
    } catch {
      this.#observer.observe(this.parts.frame);
    }
  }

  #resizeSoon(): void {
    clearTimeout(this.#resizing);
    this.#resizing = setTimeout(() => {
      if (this.#canRun) this.#attempt(() => this.#fit());
    }, RESIZE_PAUSE_MS);
  }

  #followVisibility(): void {
    if (document.hidden || !this.#canRun) this.#growth.rest();
    else this.#growth.wake();
  }

  #attempt(work: () => void): void {
    try {
      work();
    } catch (error) {
      this.events.failed(error);
    }
  }

  /** After a failure that leaves the engine in an unknown state, nothing of it is called again. */
  close(): void {
    this.#canRun = false;
    this.#growth.rest();
    this.#observer.disconnect();
    clearTimeout(this.#resizing);
  }
}
