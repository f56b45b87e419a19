/**
 * The viewport: the picture's place on the page, which is the whole window, and the part of the map that is seen in it. The river itself
 * is in the renderer: commands go there, and reports come back. The viewport remembers what was asked for last, and what was reported last.
 */

import { backingSize, type CanvasSize, type Framing, observeSize, RESIZE_PAUSE_MS } from "../../../browser/canvas.ts";
import { isRecoverable, named, PageError } from "../../../engine/errors.ts";
import type { Measure } from "../../../engine/full.ts";
import type { Phase, Summary } from "../../../engine/types.ts";
import type { Format } from "../../../files/format-names.ts";
import type { Report } from "../../../host/protocol.ts";
import type { State } from "../../../player/frame-loop.ts";
import type { ShowMode } from "../../../player/river-player.ts";
import type { Thumbnail } from "../../../player/thumbnails.ts";
import type {
  About,
  Answer,
  Answers,
  Making,
  Moment,
  Overlay,
  OverlayName,
  PointedRiver,
  Question,
  QuestionAbout,
  RiverPlace,
} from "../../page-worker/protocol.ts";
import type { PageRenderHost } from "../backend.ts";
import { Camera, type Insets, type Point, type Stage, transformBetween } from "./camera.ts";
import { Gestures, KEY_ZOOM } from "./gestures.ts";

export interface ViewportElements {
  /** The picture's place. */
  frame: HTMLElement;
  /** Another one, after the renderer had to be replaced: a canvas that is handed over does not come back. */
  canvas: HTMLCanvasElement;
  /** Lies where the map does. */
  mapPlace: HTMLElement;
  zoom: { closer: HTMLButtonElement; farther: HTMLButtonElement; all: HTMLButtonElement };
}

export interface ViewportEvents {
  /** Something on the viewport changed: the state, or in it the river. It is of the link that was shown last. */
  changed(state: State, phase: Phase, summary: Summary): void;
  failed(error: PageError): void;
}

/** The way another renderer takes over a river in a state: not at the same step, but to the same end. */
const HOW: Record<State, ShowMode> = { growing: "watch", paused: "watch", settling: "settle", finished: "still" };

/** A map to be shown: its canonical link, and its width over its height. */
export interface MapLink {
  link: string;
  aspect: number;
}

/** The map that was asked for last. */
interface Wanted extends MapLink {
  how: ShowMode;
  /** Its number among the links since the renderer has the canvas; only reports of it count, or of later ones. */
  number: number;
  /** The part of the map that its picture will show, until it does. */
  framing?: Framing | undefined;
}

/** The map that was reported last. */
interface Shown extends MapLink {
  state: State;
}

type SceneReport = Exclude<Report<Answer>, { is: "answer" }>;

export class RiverViewport {
  /** Its number at the render host, while it has a river there. */
  #id: number | undefined;
  #wanted: Wanted;
  #shown: Shown | undefined;
  #speed = 1;
  /** The state that was asked for, until it is reported: there may be no river yet, or a worker that no longer answers. */
  #asked: State | undefined;
  #events: ViewportEvents | undefined;
  /** Reports from before anybody listened. */
  readonly #untold: ((events: ViewportEvents) => void)[] = [];
  /** Counts the links that were shown since the renderer has the canvas. */
  #links = 0;
  /** The canvas that is not seen before there is something on it. */
  #next: HTMLCanvasElement | undefined;
  #isOver = false;
  #isCovered = false;
  readonly #camera = new Camera();
  /** The part of the map that the picture shows. */
  #framing: Framing | undefined;
  #resizing: ReturnType<typeof setTimeout> | undefined;
  readonly #observer = new ResizeObserver(() => this.#resizeSoon());
  readonly #client = { hear: (report: Report<Answer>) => this.#hear(report), moved: () => this.#move() };

  constructor(
    private readonly renderHost: PageRenderHost,
    private readonly elements: ViewportElements,
    first: MapLink,
    /** Measures how much of the picture's place other things cover. */
    private readonly covered: () => Insets,
  ) {
    this.#wanted = { ...first, how: "watch", number: 0 };
    this.#listenToHand();
    observeSize(this.#observer, elements.frame);
    document.addEventListener("visibilitychange", () => this.#rest());
  }

  /** Tells somebody how it goes from now on, and how it went until now. */
  listen(events: ViewportEvents): void {
    this.#events = events;
    for (const tell of this.#untold.splice(0)) tell(events);
  }

  /** The link of the river that is on the viewport; empty while there is none. */
  get link(): string {
    return this.#shown?.link ?? "";
  }

  get state(): State {
    return this.#shown?.state ?? "paused";
  }

  set speed(speed: number) {
    this.#speed = speed;
    this.#send({ do: "speed", speed });
  }

  /** Something lies over all of it: it need not go on meanwhile. */
  set isCovered(isCovered: boolean) {
    this.#isCovered = isCovered;
    this.#rest();
  }

  toggle(): void {
    const state = this.#asked ?? this.state;
    this.#asked = state === "growing" || state === "settling" ? "paused" : "growing";
    this.#send({ do: "toggle" });
  }

  /** Shows the first river. */
  start(how: ShowMode): void {
    this.#wanted.how = how;
    void this.#enter();
  }

  show({ link, aspect }: MapLink, how: ShowMode): void {
    this.#wanted = { link, aspect, how, number: this.#wanted.number, framing: this.#wanted.framing };
    this.#asked = undefined;
    if (this.#id === undefined) return;
    this.#wanted.number = ++this.#links;
    this.elements.frame.dataset["pending"] = "";
    const size = this.#size();
    this.#wanted.framing = size.framing;
    this.#send({ do: "show", link: { text: link }, how, size });
  }

  /** Other things cover more or less of the picture's place. */
  refit(): void {
    this.#followCamera();
  }

  /** Small pictures of the finished map on show in some styles, in their own pixels; none if another is shown before all are made. */
  async thumbnails(styles: readonly string[], size: { width: number; height: number }): Promise<readonly Thumbnail[]> {
    return (await this.#ask({ about: "thumbnails", of: this.#id, styles, size })) ?? [];
  }

  /** Measures the finished map on show. */
  async measures(): Promise<readonly Measure[]> {
    return (await this.#ask({ about: "measures", of: this.#id })) ?? [];
  }

  /** A link's finished rivers as a file, made from the river on show as far as that has come. */
  file(link: string, format: Format): Promise<Blob> {
    return this.#ask({ about: "file", of: this.#id, link, format });
  }

  /** The greatest names on the map, three texts each; none while it is not finished, or not the one that was shown last. */
  async names(count: number): Promise<readonly string[]> {
    const names = await this.#ask({ about: "names", of: this.#id, count });
    return names?.link === this.#wanted.link ? names.texts : [];
  }

  /** The river at a place of the finished map; none if there is none, or the map is not the one that was shown last. */
  async river(place: RiverPlace): Promise<PointedRiver | undefined> {
    const river = await this.#ask({ about: "river", of: this.#id, place });
    return river?.link === this.#wanted.link ? river : undefined;
  }

  /** Returns something to lay over the map; none while there is nothing of the kind, or if it is not the one that was shown last. */
  async overlay(name: OverlayName): Promise<Overlay | undefined> {
    const overlay = await this.#ask({ about: "overlay", of: this.#id, name });
    return overlay?.link === this.#wanted.link ? overlay : undefined;
  }

  /** Tells how far the map has come, if it is the one that was shown last; if a moment is given, after going there. */
  async making(to?: Moment): Promise<Making | undefined> {
    const making = await this.#ask({ about: "making", of: this.#id, to });
    return making?.link === this.#wanted.link ? making : undefined;
  }

  /** The parameter `names`, as it is now, with another name for something, or its usual one. */
  async renamed(now: () => string, mark: string, name: string | undefined): Promise<string> {
    const names = now();
    const renamed = await this.#ask({ about: "renamed", names, mark, name });
    // Something else may have been given a name meanwhile.
    return names === now() ? renamed : this.renamed(now, mark, name);
  }

  /** After a failure that leaves the engine in an unknown state, nothing of it is called again. */
  close(): void {
    this.#isOver = true;
    if (this.#id !== undefined) this.renderHost.leave(this.#id);
    this.#id = undefined;
    this.#observer.disconnect();
    clearTimeout(this.#resizing);
  }

  // ---- what it says

  #send(command: Parameters<PageRenderHost["send"]>[1]): void {
    if (this.#id !== undefined) this.renderHost.send(this.#id, command);
  }

  async #ask<Key extends About>(question: QuestionAbout<Key>): Promise<Answers[Key]> {
    // An answer is of the kind of its question.
    return (await this.renderHost.ask(question as Question)) as Answers[Key];
  }

  async #enter(): Promise<void> {
    try {
      const id = await this.renderHost.enter(this.#client);
      if (this.#isOver) this.renderHost.leave(id);
      else this.#open(id);
    } catch (thrown) {
      if (!this.#isOver) this.#tell((events) => events.failed(named(thrown)));
    }
  }

  #open(id: number): void {
    const { link, how } = this.#wanted;
    const state = this.#asked ?? (this.#shown?.link === link ? this.#shown.state : undefined);
    const canvas = this.#next ?? this.elements.canvas;
    this.#id = id;
    this.#links = this.#wanted.number = 0;
    const size = this.#size();
    this.#wanted.framing = size.framing;
    this.#send({ do: "open", canvas, link: { text: link }, how: state ? HOW[state] : how, size });
    this.#send({ do: "speed", speed: this.#speed });
    if (state === "paused") this.#send({ do: "pause" });
    if (this.#isUnseen) this.#rest();
  }

  /** The renderer answers no more, and there is a new one: there it goes on with the same river. The old picture stays until then. */
  #move(): void {
    this.#id = undefined;
    if (this.#isOver) return;
    this.#next = this.elements.canvas.cloneNode() as HTMLCanvasElement;
    void this.#enter();
  }

  // ---- what it hears

  #hear(report: Report<Answer>): void {
    if (report.is === "shown") this.#show(report);
    if (report.is === "failed") this.#fail(report);
  }

  #show({ reading, state, phase, summary }: Extract<SceneReport, { is: "shown" }>): void {
    this.#reveal();
    this.#shown = { link: reading.link, aspect: reading.aspect, state };
    this.#asked = undefined;
    // Another link is on its way.
    if (reading.links < this.#wanted.number) return;
    delete this.elements.frame.dataset["pending"];
    this.#becomeFramed(this.#wanted.framing);
    this.#wanted.framing = undefined;
    this.#tell((events) => events.changed(state, phase, summary));
  }

  #fail({ code, message, links = 0 }: Extract<SceneReport, { is: "failed" }>): void {
    const error = new PageError(code, message);
    if (isRecoverable(error) && code !== "no-chart") {
      // Another link is on its way, which may do; but without a first river nothing follows.
      if (links < this.#links && this.#shown) return;
      // The river that was there stays, in its own shape.
      const { aspect } = this.#shown ?? this.#wanted;
      this.#wanted = { ...this.#wanted, link: this.link, aspect, number: 0 };
      void this.#resize();
      delete this.elements.frame.dataset["pending"];
    }
    this.#tell((events) => events.failed(error));
  }

  #tell(what: (events: ViewportEvents) => void): void {
    if (this.#events) what(this.#events);
    else this.#untold.push(what);
  }

  #reveal(): void {
    const next = this.#next;
    if (!next) return;
    this.#next = undefined;
    this.elements.canvas.replaceWith(next);
    this.elements.canvas = next;
  }

  // ---- its place, and the part of the map that is seen there

  #listenToHand(): void {
    const { frame, zoom } = this.elements;
    const follow = (move: (stage: Stage) => void): void => {
      move(this.#stage());
      this.#followCamera();
    };
    const zoomBy = (factor: number, about?: Point): void =>
      follow((stage) => this.#camera.zoomBy(factor, about, stage));
    const all = (): void => follow(() => this.#camera.reset());
    const move = (dx: number, dy: number): void => follow((stage) => this.#camera.moveBy(dx, dy, stage));
    // Keys move the map where the focus is on it.
    frame.tabIndex = 0;
    new Gestures(frame, { move, zoom: zoomBy, all });
    zoom.closer.addEventListener("click", () => zoomBy(KEY_ZOOM));
    zoom.farther.addEventListener("click", () => zoomBy(1 / KEY_ZOOM));
    zoom.all.addEventListener("click", all);
  }

  /** The picture's place for the map that was asked for last. */
  #stage(): Stage {
    const { width, height } = this.elements.frame.getBoundingClientRect();
    return { width, height, insets: this.covered(), aspect: this.#wanted.aspect };
  }

  /** The picture is moved at once, and painted anew when the hand rests. */
  #followCamera(): void {
    const stage = this.#stage();
    this.#placeMap(stage);
    this.#movePicture(stage);
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

  /** Until it is painted for what is to be seen, the picture stands where that will be. */
  #movePicture(stage: Stage): void {
    if (!this.#framing) return;
    const transform = transformBetween(this.#framing, this.#camera.framingOn(stage), stage.width);
    this.elements.canvas.style.transform = transform;
  }

  /** The picture has been painted for something else. */
  #becomeFramed(framing: Framing | undefined): void {
    if (!framing || this.#isOver) return;
    this.#framing = framing;
    this.elements.frame.dataset["framing"] = framing.join(" ");
    this.#movePicture(this.#stage());
  }

  /** Returns the number of pixels of the picture, and the part of the map that it shows. */
  #size(): CanvasSize {
    const size = backingSize(this.elements.frame.getBoundingClientRect(), window.devicePixelRatio);
    if (size.width === 0 || size.height === 0) return { ...size, ratio: 1 };
    const stage = this.#stage();
    this.#placeMap(stage);
    return { ...size, ratio: size.width / stage.width, framing: this.#camera.framingOn(stage) };
  }

  #resizeSoon(): void {
    clearTimeout(this.#resizing);
    this.#resizing = setTimeout(() => void this.#resize(), RESIZE_PAUSE_MS);
  }

  async #resize(): Promise<void> {
    const of = this.#id;
    const size = this.#size();
    if (of === undefined || size.width === 0) return;
    // The map that was asked for last, not there yet, is painted at this size, too.
    if (this.#wanted.framing) this.#wanted.framing = size.framing;
    this.#send({ do: "resize", size });
    // Answered once that is done.
    await this.#ask({ about: "now", of }).catch(() => {});
    if (!this.#wanted.framing) this.#becomeFramed(size.framing);
  }

  get #isUnseen(): boolean {
    return document.hidden || this.#isCovered;
  }

  #rest(): void {
    this.#send({ do: this.#isUnseen ? "rest" : "wake" });
  }
}
