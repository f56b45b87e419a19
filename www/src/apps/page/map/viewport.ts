/**
 * The viewport: the picture's place on the page, which is the whole window, and the part of the map that is seen in it.
 * The river itself is in the renderer: commands go there, and reports come back. The viewport remembers the last
 * request and the last report.
 */

import { backingSize, type CanvasSize, type Framing, observeSize, RESIZE_PAUSE_MS } from "../../../browser/canvas.ts";
import { isRecoverable, named, PageError } from "../../../engine/errors.ts";
import type { Measure, Phase, Summary } from "../../../engine/types.ts";
import type { Format, RasterOrder } from "../../../files/format-names.ts";
import type { Report } from "../../../host/protocol.ts";
import type { State } from "../../../player/frame-loop.ts";
import type { ShowMode } from "../../../player/river-player.ts";
import type { Picture, Thumbnail } from "../../../player/thumbnails.ts";
import type {
  About,
  Answer,
  Answers,
  Making,
  Moment,
  NameablePlace,
  Nameables,
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
import { LastPicture } from "./last-picture.ts";
import { WholeMap } from "./whole-map.ts";

export interface ViewportElements {
  /** The picture's place. */
  frame: HTMLElement;
  /** The canvas. It is replaced with the renderer, since a canvas that was handed over does not come back. */
  canvas: HTMLCanvasElement;
  /** The element in the map's place. */
  mapPlace: HTMLElement;
  zoom: { closer: HTMLButtonElement; farther: HTMLButtonElement; all: HTMLButtonElement };
}

export interface ViewportEvents {
  /** Called when the state or the river changed. It belongs to the link that was shown last. */
  changed(state: State, phase: Phase, summary: Summary): void;
  failed(error: PageError): void;
}

/** The way in which a new renderer shows a river by its state: not from the same step, but to the same end. */
const HOW: Record<State, ShowMode> = { growing: "watch", paused: "watch", settling: "settle", finished: "still" };

/** In windows narrower than this, in CSS pixels, a first view is of the land alone. */
const NARROW_PX = 620;

/** A map to be shown: its canonical link, and its width over its height. */
export interface MapLink {
  link: string;
  aspect: number;
}

/** The map that was asked for last. */
interface Wanted extends MapLink {
  how: ShowMode;
  /** Its number among the links that this renderer was sent. Only reports of it or of later links count. */
  number: number;
  /** The part of the map that its picture will show; undefined once it does. */
  framing?: Framing | undefined;
}

/** The map that was reported last. */
interface Shown extends MapLink {
  state: State;
}

/** Paper has another size, and nobody waits there for another picture. */
const isOnPaper = (): boolean => window.matchMedia("print").matches;

type SceneReport = Exclude<Report<Answer>, { is: "answer" }>;

export class RiverViewport {
  /** Its client number at the render host, while it has a river there. */
  #id: number | undefined;
  #wanted: Wanted;
  #shown: Shown | undefined;
  #speed = 1;
  /** The requested state, until it is reported: there may be no river yet, or a worker that no longer answers. */
  #asked: State | undefined;
  #events: ViewportEvents | undefined;
  /** Reports that came before there was a listener. */
  readonly #untold: ((events: ViewportEvents) => void)[] = [];
  /** The number of links that this renderer was sent after the first. */
  #links = 0;
  /** A new canvas, which is shown once it has a picture. */
  #next: HTMLCanvasElement | undefined;
  #isOver = false;
  #isCovered = false;
  /** True before the first map of a link that may have been made for a wider window. */
  #isToShowLand = false;
  #awaited = { map: false, land: false };
  readonly #camera = new Camera();
  readonly #lastPicture: LastPicture;
  readonly #wholeMap = new WholeMap();
  /** The number of times the map was moved. While its picture is not painted in its new place, the frame is `moving`. */
  #moves = 0;
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
    this.#wanted = { ...first, how: "still", number: 0 };
    this.#lastPicture = new LastPicture(elements.frame);
    this.#listenToHand();
    observeSize(this.#observer, elements.frame);
    document.addEventListener("visibilitychange", () => this.#rest());
  }

  /** Registers the listener, and tells it everything that was reported before. */
  listen(events: ViewportEvents): void {
    this.#events = events;
    for (const tell of this.#untold.splice(0)) tell(events);
  }

  /** The link of the river on show; empty while there is none. */
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

  /** True while something covers the whole viewport: then the river rests. */
  set isCovered(isCovered: boolean) {
    this.#isCovered = isCovered;
    this.#rest();
  }

  toggle(): void {
    const state = this.#asked ?? this.state;
    this.#asked = state === "growing" || state === "settling" ? "paused" : "growing";
    this.#send({ do: "toggle" });
  }

  /** Shows the first river. If its link may come from a wider window, a narrow one shows its land alone. */
  start(how: ShowMode, isFromElsewhere: boolean): void {
    this.#wanted.how = how;
    this.#isToShowLand = isFromElsewhere;
    void this.#enter();
  }

  show({ link, aspect }: MapLink, how: ShowMode): void {
    // Another word is another country, of which nobody knows where to look.
    if (seedOf(link) !== seedOf(this.#wanted.link)) {
      this.#camera.reset();
      this.#isToShowLand = false;
    }
    this.#wholeMap.forget();
    this.#wanted = { link, aspect, how, number: this.#wanted.number, framing: this.#wanted.framing };
    this.#asked = undefined;
    if (this.#id === undefined) return;
    this.#wanted.number = ++this.#links;
    this.#await({ map: true });
    if (how === "still") this.#lastPicture.keep(this.elements.canvas);
    else this.#lastPicture.drop();
    const size = this.#size();
    this.#wanted.framing = size.framing;
    this.#send({ do: "show", link: { text: link }, how, size });
  }

  /** Moves the map after other things have come to cover more or less of the picture's place. */
  refit(): void {
    this.#followCamera();
  }

  /**
   * Makes thumbnails of the finished map on show in some styles; `size` is in device pixels. Returns none if another
   * map is shown before all are made.
   */
  async thumbnails(styles: readonly string[], size: { width: number; height: number }): Promise<readonly Thumbnail[]> {
    return (await this.#ask({ about: "thumbnails", of: this.#id, styles, size })) ?? [];
  }

  /**
   * Draws the finished map of another link, without letters; `size` is in device pixels. Returns nothing if another map
   * is shown before it is drawn.
   */
  picture(link: string, size: { width: number; height: number }): Promise<Picture | undefined> {
    return this.#ask({ about: "picture", of: this.#id, link, size });
  }

  /** Measures the finished map on show. */
  async measures(): Promise<readonly Measure[]> {
    return (await this.#ask({ about: "measures", of: this.#id })) ?? [];
  }

  /** Makes a file of a link's finished rivers, starting from the river on show. */
  file(link: string, format: Format, rasters?: RasterOrder): Promise<Blob> {
    return this.#ask({ about: "file", of: this.#id, link, format, rasters });
  }

  /**
   * Returns the greatest names on the map, three texts each; none while it is not finished, or not the one that was
   * shown last.
   */
  async names(count: number): Promise<readonly string[]> {
    const names = await this.#ask({ about: "names", of: this.#id, count });
    return names?.link === this.#wanted.link ? names.texts : [];
  }

  /** Returns the river at a place of the finished map, if there is one and the map is the one that was shown last. */
  async river(place: RiverPlace): Promise<PointedRiver | undefined> {
    const river = await this.#ask({ about: "river", of: this.#id, place });
    return river?.link === this.#wanted.link ? river : undefined;
  }

  /** Returns what has a name, or could have one, at a place of the finished map, if it is the one that was shown last. */
  async nameables(place: NameablePlace): Promise<Nameables | undefined> {
    const found = await this.#ask({ about: "nameables", of: this.#id, place });
    // A map that is not on show yet would take away what is opened over the last one.
    return found?.link === this.#wanted.link && found.link === this.link ? found : undefined;
  }

  /**
   * Returns an overlay of the map; none while there is none of this name, or if the map is not the one that was shown
   * last.
   */
  async overlay(name: OverlayName): Promise<Overlay | undefined> {
    const overlay = await this.#ask({ about: "overlay", of: this.#id, name });
    return overlay?.link === this.#wanted.link ? overlay : undefined;
  }

  /** Returns the progress of the map, if it is the one that was shown last. If a moment is given, goes there first. */
  async making(to?: Moment): Promise<Making | undefined> {
    const making = await this.#ask({ about: "making", of: this.#id, to });
    return making?.link === this.#wanted.link ? making : undefined;
  }

  /** Returns the parameter `names`, as `now` gives it, with another name for something, or with its usual one. */
  async renamed(now: () => string, mark: string, name: string | undefined): Promise<string> {
    const names = now();
    const renamed = await this.#ask({ about: "renamed", names, mark, name });
    // Something else may have been renamed meanwhile.
    return names === now() ? renamed : this.renamed(now, mark, name);
  }

  /** Closes the viewport for good, after a failure that leaves the engine in an unknown state. */
  close(): void {
    this.#isOver = true;
    if (this.#id !== undefined) this.renderHost.leave(this.#id);
    this.#id = undefined;
    this.#observer.disconnect();
    clearTimeout(this.#resizing);
  }

  // ---- commands and questions

  #send(command: Parameters<PageRenderHost["send"]>[1]): void {
    if (this.#id !== undefined) this.renderHost.send(this.#id, command);
  }

  async #ask<Key extends About>(question: QuestionAbout<Key>): Promise<Answers[Key]> {
    // An answer has the type that belongs to its question.
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

  /**
   * Moves to a new renderer, since the old one no longer answers. The old picture stays until the new one is painted.
   */
  #move(): void {
    this.#id = undefined;
    if (this.#isOver) return;
    this.#next = this.elements.canvas.cloneNode() as HTMLCanvasElement;
    void this.#enter();
  }

  // ---- reports

  #hear(report: Report<Answer>): void {
    if (report.is === "shown") this.#show(report);
    if (report.is === "failed") this.#fail(report);
  }

  #show({ reading, state, phase, summary, isUnnamed }: Extract<SceneReport, { is: "shown" }>): void {
    this.#reveal();
    this.#shown = { link: reading.link, aspect: reading.aspect, state };
    this.#asked = undefined;
    // Another link is on its way.
    if (reading.links < this.#wanted.number) return;
    this.#becomeFramed(this.#wanted.framing);
    this.#wanted.framing = undefined;
    // Before that the sea may still rise over much of the land.
    if (state === "finished" && this.#isToShowLand) void this.#showLand();
    this.#await({ map: false });
    // Without its names, a map is not yet what the last one was.
    if (state === "finished" && !isUnnamed) this.#lastPicture.fade();
    this.#tell((events) => events.changed(state, phase, summary));
  }

  #fail({ code, message, links = 0 }: Extract<SceneReport, { is: "failed" }>): void {
    const error = new PageError(code, message);
    if (isRecoverable(error) && code !== "no-labels") {
      // Another link is on its way and may succeed. Without a first river none does.
      if (links < this.#links && this.#shown) return;
      // The old river stays, in its own shape.
      const { aspect } = this.#shown ?? this.#wanted;
      this.#wanted = { ...this.#wanted, link: this.link, aspect, number: 0 };
      void this.#resize();
      this.#await({ map: false });
      this.#lastPicture.drop();
    }
    if (code === "no-labels") this.#lastPicture.fade();
    this.#tell((events) => events.failed(error));
  }

  /** Shows the land alone, in a narrow window: the sea around it would make a stamp of a wide map. */
  async #showLand(): Promise<void> {
    this.#isToShowLand = false;
    const { width, height } = this.elements.frame.getBoundingClientRect();
    const isUpright = height > width;
    if (width >= NARROW_PX || !isUpright || this.#wanted.aspect < 1) return;
    const [moves, { link }] = [this.#moves, this.#wanted];
    this.#await({ land: true });
    // If it fails, the whole map stays.
    const land = await this.#ask({ about: "land", of: this.#id }).catch(() => undefined);
    // A hand may have moved the map meanwhile, or another one may be on its way.
    if (land && moves === this.#moves && link === this.#wanted.link) {
      this.#camera.show(land, this.#stage());
      this.#followCamera();
      await this.#resize();
    }
    this.#await({ land: false });
  }

  /** Marks the frame while the map that was asked for, or the view of its land, is not there yet. */
  #await(change: { map?: boolean; land?: boolean }): void {
    this.#awaited = { ...this.#awaited, ...change };
    const { dataset } = this.elements.frame;
    if (this.#awaited.map || this.#awaited.land) dataset["pending"] = "";
    else delete dataset["pending"];
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

  // ---- the place, and the part of the map that is seen there

  #listenToHand(): void {
    const { frame, zoom } = this.elements;
    const follow = (move: (stage: Stage) => void): void => {
      this.#isToShowLand = false;
      this.#keepWhole();
      move(this.#stage());
      this.#lastPicture.drop();
      this.#followCamera();
    };
    const zoomBy = (factor: number, about?: Point): void =>
      follow((stage) => this.#camera.zoomBy(factor, about, stage));
    const all = (): void => follow(() => this.#camera.reset());
    const move = (dx: number, dy: number): void => follow((stage) => this.#camera.moveBy(dx, dy, stage));
    // Keys move the map while it has the focus.
    frame.tabIndex = 0;
    new Gestures(frame, { move, zoom: zoomBy, all });
    zoom.closer.addEventListener("click", () => zoomBy(KEY_ZOOM));
    zoom.farther.addEventListener("click", () => zoomBy(1 / KEY_ZOOM));
    zoom.all.addEventListener("click", all);
  }

  /** Keeps the picture of the whole map before the hand moves into it. */
  #keepWhole(): void {
    if (!this.#camera.showsAll || this.state !== "finished") return;
    const stage = this.#stage();
    const isPainted = `${this.#camera.framingOn(stage)}` === `${this.#framing}`;
    if (isPainted) this.#wholeMap.keep(this.elements.canvas, this.#camera.boxOn(stage), stage);
  }

  /** Returns the picture's place for the map that was requested last. */
  #stage(): Stage {
    const { width, height } = this.elements.frame.getBoundingClientRect();
    return { width, height, insets: this.covered(), aspect: this.#wanted.aspect };
  }

  /** Moves the picture at once, and has it painted again when the hand rests. On paper it stays as it is. */
  #followCamera(): void {
    if (isOnPaper()) return;
    const stage = this.#stage();
    this.#moves++;
    this.elements.frame.dataset["moving"] = "";
    this.#placeMap(stage);
    this.#movePicture(stage);
    this.#resizeSoon();
  }

  #placeMap(stage: Stage): void {
    const { x, y, width, height } = this.#camera.boxOn(stage);
    const { mapPlace, frame, zoom } = this.elements;
    if (this.#camera.showsAll) delete frame.dataset["zoomed"];
    else frame.dataset["zoomed"] = "";
    const shares = { across: width / stage.width, left: x / width, top: y / width, aspect: stage.aspect };
    for (const [name, share] of Object.entries(shares)) frame.style.setProperty(`--map-${name}`, String(share));
    frame.style.setProperty("--window", String(stage.width / stage.height));
    Object.assign(mapPlace.style, { left: `${x}px`, top: `${y}px`, width: `${width}px`, height: `${height}px` });
    zoom.closer.disabled = this.#camera.isClosest;
    const hadFocus = [zoom.farther, zoom.all].some((button) => button === document.activeElement);
    zoom.farther.hidden = zoom.all.hidden = this.#camera.showsAll;
    // A hidden button loses the focus: it goes to the one that stays.
    if (hadFocus && this.#camera.showsAll) zoom.closer.focus();
  }

  /** Moves the old picture to the place of the new one, until that is painted. */
  #movePicture(stage: Stage): void {
    if (!this.#framing) return;
    const transform = transformBetween(this.#framing, this.#camera.framingOn(stage), stage.width);
    this.elements.canvas.style.transform = transform;
  }

  /** Takes note of the part of the map that the picture shows now. */
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
    if (isOnPaper()) return;
    this.#resizing = setTimeout(() => void this.#resize(), RESIZE_PAUSE_MS);
  }

  async #resize(): Promise<void> {
    const [of, moves] = [this.#id, this.#moves];
    const size = this.#size();
    if (of === undefined || size.width === 0) {
      delete this.elements.frame.dataset["moving"];
      return;
    }
    // The map that was requested last and is still on its way is painted at this size, too.
    if (this.#wanted.framing) this.#wanted.framing = size.framing;
    this.#send({ do: "resize", size });
    // The answer comes when the resizing is done.
    await this.#ask({ about: "now", of }).catch(() => {});
    if (!this.#wanted.framing) this.#becomeFramed(size.framing);
    // The new picture comes from a worker, and may be shown later than what the page itself draws.
    await twoFrames();
    if (moves === this.#moves) delete this.elements.frame.dataset["moving"];
  }

  get #isUnseen(): boolean {
    return document.hidden || this.#isCovered;
  }

  #rest(): void {
    this.#send({ do: this.#isUnseen ? "rest" : "wake" });
  }
}

function seedOf(link: string): string | null {
  return new URLSearchParams(link).get("seed");
}

/** Waits until the browser has shown a frame. */
function twoFrames(): Promise<void> {
  return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done())));
}
