/** The viewport: the picture's place on the page, which has the river's shape and follows the window. */

import { backingSize, type CanvasSize, observeSize, RESIZE_PAUSE_MS } from "../browser/canvas.ts";
import type { Charts } from "../engine/charts.ts";
import type { FullCore, FullRiver } from "../engine/full.ts";
import type { Phase, Summary } from "../engine/types.ts";
import { askChart } from "../player/chart-maker.ts";
import type { State } from "../player/frame-loop.ts";
import { RiverPlayer, type ShowMode } from "../player/river-player.ts";
import { displayFrames } from "../player/scheduler.ts";

/** Most maps have no labels. */
export const lateCharts = async (): Promise<Charts> => (await import("../engine/charts.ts")).loadCharts();

export interface ViewportElements {
  /** Holds the picture and what stands under it; takes on the river's shape. */
  sheet: HTMLElement;
  /** Has the river's shape. */
  frame: HTMLElement;
  canvas: HTMLCanvasElement;
}

export interface ViewportEvents {
  /** Something on the viewport changed: the state, or in it the river. */
  changed(state: State, phase: Phase, summary: Summary): void;
  failed(error: unknown): void;
}

export class RiverViewport {
  #resizing: ReturnType<typeof setTimeout> | undefined;
  readonly #observer = new ResizeObserver(() => this.#resizeSoon());
  readonly #player: RiverPlayer<FullRiver>;

  /** Puts a river on the canvas at tick 0. Throws what the core throws. */
  constructor(
    private readonly core: FullCore,
    private readonly elements: ViewportElements,
    link: string,
    events: ViewportEvents,
  ) {
    this.#player = new RiverPlayer(
      { ...core, loadCharts: lateCharts },
      elements.canvas,
      { text: link },
      displayFrames,
      {
        ...events,
        sizeFor: (aspect) => this.#sizeFor(aspect),
      },
    );
    observeSize(this.#observer, elements.frame);
    document.addEventListener("visibilitychange", () => this.#followVisibility());
  }

  /** The link of the river that is on the viewport. */
  get link(): string {
    return this.#player.link;
  }

  /** A river of a link, for a file: as far as the one on the viewport has come, and with a future of its own. */
  copy(link: string): FullRiver {
    const river = this.#player.river?.copy();
    if (!river) return new this.core.engine.River(link);
    try {
      river.change(link);
      return river;
    } catch (error) {
      river.free();
      throw error;
    }
  }

  /** What a chart of the river on the viewport says; nothing while that is not finished. */
  async askChart<Said>(ask: Parameters<typeof askChart<Said>>[2]): Promise<Said | undefined> {
    const charts = await lateCharts();
    // By now there may be another, or none.
    const river = this.#player.river;
    return river && this.state === "finished" ? askChart(river, charts, ask) : undefined;
  }

  get state(): State {
    return this.#player.state;
  }

  set speed(speed: number) {
    this.#player.speed = speed;
  }

  toggle(): void {
    this.#player.toggle();
  }

  replay(): void {
    this.#player.replay();
  }

  /** Shows the first river. */
  start(how: ShowMode): void {
    this.#player.start(how);
  }

  show(link: string, how: ShowMode): void {
    this.#player.show({ text: link }, how);
  }

  /** After a failure that leaves the engine in an unknown state, nothing of it is called again. */
  close(): void {
    this.#player.close();
    this.#observer.disconnect();
    clearTimeout(this.#resizing);
  }

  /** Makes the frame the river's shape, and the picture the frame's size. */
  #sizeFor(aspect: number): CanvasSize {
    this.elements.sheet.style.setProperty("--aspect", String(aspect));
    const box = this.elements.frame.getBoundingClientRect();
    const size = backingSize(box, window.devicePixelRatio);
    return { ...size, ratio: box.width > 0 ? size.width / box.width : 1 };
  }

  #resizeSoon(): void {
    clearTimeout(this.#resizing);
    this.#resizing = setTimeout(() => this.#player.resize(), RESIZE_PAUSE_MS);
  }

  #followVisibility(): void {
    if (document.hidden) this.#player.rest();
    else this.#player.wake();
  }
}
