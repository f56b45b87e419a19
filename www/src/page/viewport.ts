/** The viewport: the picture's place on the page, which is the whole window, and the part of the map that is seen in it. */

import { backingSize, type CanvasSize, type Framing, observeSize, RESIZE_PAUSE_MS } from "../browser/canvas.ts";
import type { Charts } from "../engine/charts.ts";
import type { FullCore, FullRiver } from "../engine/full.ts";
import type { Phase, Summary } from "../engine/types.ts";
import { askChart } from "../player/chart-maker.ts";
import type { State } from "../player/frame-loop.ts";
import { RiverPlayer, type ShowMode } from "../player/river-player.ts";
import { displayFrames } from "../player/scheduler.ts";
import { type Thumbnail, thumbnails } from "../player/thumbnails.ts";
import { Camera, type Insets, type Point, type Stage, transformBetween } from "./camera.ts";
import { Gestures, KEY_ZOOM } from "./gestures.ts";

/** Most maps have no labels. */
export const lateCharts = async (): Promise<Charts> => (await import("../engine/charts.ts")).loadCharts();

export interface ViewportElements {
  /** The picture's place. */
  frame: HTMLElement;
  canvas: HTMLCanvasElement;
  /** Lies where the map does. */
  mapPlace: HTMLElement;
  zoom: { closer: HTMLButtonElement; farther: HTMLButtonElement; all: HTMLButtonElement };
}

export interface ViewportEvents {
  /** What of the picture's place other things cover. */
  covered(): Insets;
  /** Something on the viewport changed: the state, or in it the river. */
  changed(state: State, phase: Phase, summary: Summary): void;
  failed(error: unknown): void;
}

export class RiverViewport {
  #resizing: ReturnType<typeof setTimeout> | undefined;
  readonly #observer = new ResizeObserver(() => this.#resizeSoon());
  readonly #player: RiverPlayer<FullRiver>;
  readonly #camera = new Camera();
  #aspect = 1;
  /** What the picture shows, until there is another. */
  #shown: Framing | undefined;

  /** Puts a river on the canvas at tick 0. Throws what the core throws. */
  constructor(
    private readonly core: FullCore,
    private readonly elements: ViewportElements,
    link: string,
    private readonly events: ViewportEvents,
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
    this.#listenToZoom();
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

  /** Small pictures of the river on the viewport, as long as it stays. */
  async drawThumbnails(
    styles: readonly string[],
    size: { width: number; height: number },
    draw: (thumbnail: Thumbnail) => void,
  ): Promise<void> {
    const { link } = this;
    const isOver = (): boolean => this.link !== link || this.state !== "finished";
    const pause = (): Promise<boolean> => new Promise((done) => setTimeout(() => done(!isOver())));
    if (!(await pause())) return;
    for await (const thumbnail of thumbnails(this.copy(link), this.core.memory, styles, size, pause)) draw(thumbnail);
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

  /** Shows the first river. */
  start(how: ShowMode): void {
    this.#player.start(how);
  }

  show(link: string, how: ShowMode): void {
    this.#player.show({ text: link }, how);
  }

  /** Other things cover more or less of the picture's place. */
  refit(): void {
    this.#followCamera();
  }

  /** After a failure that leaves the engine in an unknown state, nothing of it is called again. */
  close(): void {
    this.#player.close();
    this.#observer.disconnect();
    clearTimeout(this.#resizing);
  }

  #listenToZoom(): void {
    const { frame, zoom } = this.elements;
    const zoomBy = (factor: number, about?: Point): void => {
      this.#camera.zoomBy(factor, about, this.#stage());
      this.#followCamera();
    };
    const all = (): void => {
      this.#camera.reset();
      this.#followCamera();
    };
    const move = (dx: number, dy: number): void => {
      this.#camera.moveBy(dx, dy, this.#stage());
      this.#followCamera();
    };
    // Keys move the map where the focus is on it.
    frame.tabIndex = 0;
    new Gestures(frame, { move, zoom: zoomBy, all });
    zoom.closer.addEventListener("click", () => zoomBy(KEY_ZOOM));
    zoom.farther.addEventListener("click", () => zoomBy(1 / KEY_ZOOM));
    zoom.all.addEventListener("click", all);
  }

  #stage(): Stage {
    const { width, height } = this.elements.frame.getBoundingClientRect();
    return { width, height, insets: this.events.covered(), aspect: this.#aspect };
  }

  /** The picture is moved at once, and painted anew when the hand rests. */
  #followCamera(): void {
    const stage = this.#stage();
    if (!(stage.width > 0 && stage.height > 0)) return;
    this.#placeMap(stage);
    if (this.#shown) {
      const transform = transformBetween(this.#shown, this.#camera.framingOn(stage), stage.width);
      this.elements.canvas.style.transform = transform;
    }
    this.#resizeSoon();
  }

  #placeMap(stage: Stage): void {
    const { x, y, width, height } = this.#camera.boxOn(stage);
    const { mapPlace, frame, zoom } = this.elements;
    frame.style.setProperty("--window", String(stage.width / stage.height));
    Object.assign(mapPlace.style, { left: `${x}px`, top: `${y}px`, width: `${width}px`, height: `${height}px` });
    zoom.closer.disabled = this.#camera.isClosest;
    zoom.farther.disabled = zoom.all.disabled = this.#camera.showsAll;
  }

  /** How many pixels the picture has, and what it shows. */
  #sizeFor(aspect: number): CanvasSize {
    this.#aspect = aspect;
    const { frame, canvas } = this.elements;
    const size = backingSize(frame.getBoundingClientRect(), window.devicePixelRatio);
    const stage = this.#stage();
    if (size.width === 0 || size.height === 0) return { ...size, ratio: 1 };
    this.#placeMap(stage);
    const framing = this.#camera.framingOn(stage);
    this.#shown = framing;
    canvas.style.transform = "";
    frame.dataset["framing"] = framing.join(" ");
    return { ...size, ratio: size.width / stage.width, framing };
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
