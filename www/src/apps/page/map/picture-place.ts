/**
 * The picture's place on the page: its canvas, how large that is, and the part of the map that is seen there. What moves
 * the map moves the old picture at once, and has another painted when the hand rests.
 */

import { backingSize, type CanvasSize, type Framing, observeSize, RESIZE_PAUSE_MS } from "../../../browser/canvas.ts";
import { type Bounds, Camera, type Insets, type Point, type Stage, transformBetween } from "./camera.ts";
import { Gestures, KEY_ZOOM } from "./gestures.ts";
import type { LastPicture, Seen } from "./last-picture.ts";
import type { Line } from "./line.ts";
import { WholeMap } from "./whole-map.ts";

export interface PlaceElements {
  /** The picture's place. */
  frame: HTMLElement;
  /** The canvas. It is replaced with the renderer, since a canvas that was handed over does not come back. */
  canvas: HTMLCanvasElement;
  /** The element in the map's place. */
  mapPlace: HTMLElement;
  zoom: { closer: HTMLButtonElement; farther: HTMLButtonElement; all: HTMLButtonElement };
}

/** What the place has to know of its map. */
export interface PlacedMap {
  /** The width over the height of the map that was asked for last. */
  readonly aspect: number;
  /** True if the picture is of a finished map. */
  readonly isFinished: boolean;
}

/** Says whether the page is being printed: paper has another size, and nobody waits there for another picture. */
const isOnPaper = (): boolean => window.matchMedia("print").matches;

export class PicturePlace {
  readonly #camera = new Camera();
  readonly #wholeMap = new WholeMap();
  /** A new canvas, which is shown once it has a picture. */
  #next: HTMLCanvasElement | undefined;
  /** The number of times the map was moved. While its picture is not painted in its new place, the frame is `moving`. */
  #moves = 0;
  /** The part of the map that the picture shows. */
  #framing: Framing | undefined;
  /** The part that the picture of the map that was asked for last will show; undefined once it does. */
  #coming: Framing | undefined;
  #resizing: ReturnType<typeof setTimeout> | undefined;
  readonly #observer = new ResizeObserver(() => this.#resizeSoon());

  constructor(
    private readonly elements: PlaceElements,
    private readonly line: Line,
    private readonly lastPicture: LastPicture,
    private readonly map: () => PlacedMap,
    /** Measures how much of the place other things cover. */
    private readonly covered: () => Insets,
    /** Is told when a hand moves the map. */
    private readonly taken: () => void,
  ) {
    this.#listenToHand();
    observeSize(this.#observer, elements.frame);
  }

  get moves(): number {
    return this.#moves;
  }

  /** Returns the canvas for the next picture. */
  get canvas(): HTMLCanvasElement {
    return this.#next ?? this.elements.canvas;
  }

  /** What is seen of the map that was asked for last. */
  get seen(): Seen {
    return this.#seenOn(this.#stage());
  }

  /** Makes another canvas for the next picture. The old one stays until that is painted. */
  renewCanvas(): void {
    this.#next = this.elements.canvas.cloneNode() as HTMLCanvasElement;
  }

  /** Leaves the map on show for another. Another country is shown whole: nobody knows where to look. */
  leave(isForAnotherCountry: boolean): void {
    if (isForAnotherCountry) this.#camera.reset();
    this.#wholeMap.forget();
  }

  /** Returns the size of the picture of the map that is asked for now. */
  sizeOfNext(): CanvasSize {
    const size = this.#size();
    this.#coming = size.framing;
    return size;
  }

  /** Puts a new canvas in its place, now that it has a picture. */
  reveal(): void {
    const next = this.#next;
    if (!next) return;
    this.#next = undefined;
    this.elements.canvas.replaceWith(next);
    this.elements.canvas = next;
  }

  /** Takes note that the picture is of the map that was asked for last. */
  arrived(): void {
    this.#becomeFramed(this.#coming);
    this.#coming = undefined;
  }

  /** Shows a part of the map as large as it can be, and waits until it is painted. */
  async show(part: Bounds): Promise<void> {
    this.#camera.show(part, this.#stage());
    this.refit();
    await this.resize();
  }

  /** Moves the picture at once, and has it painted again when the hand rests. On paper it stays as it is. */
  refit(): void {
    if (isOnPaper()) return;
    const stage = this.#stage();
    this.#moves++;
    this.elements.frame.dataset["moving"] = "";
    this.#placeMap(stage);
    this.#movePicture(stage);
    this.lastPicture.follow(this.#seenOn(stage));
    this.#resizeSoon();
  }

  /** Has the picture painted in the size of its place. */
  async resize(): Promise<void> {
    const [of, moves] = [this.line.id, this.#moves];
    const size = this.#size();
    if (of === undefined || size.width === 0) {
      delete this.elements.frame.dataset["moving"];
      return;
    }
    // The map that was requested last and is still on its way is painted at this size, too.
    if (this.#coming) this.#coming = size.framing;
    this.line.send({ do: "resize", size });
    // The answer comes when the resizing is done.
    await this.line.ask({ about: "now", of }).catch(() => {});
    if (!this.#coming) this.#becomeFramed(size.framing);
    // The new picture comes from a worker, and may be shown later than what the page itself draws.
    await twoFrames();
    if (moves === this.#moves) delete this.elements.frame.dataset["moving"];
  }

  /** Follows the window no longer. */
  close(): void {
    this.#observer.disconnect();
    clearTimeout(this.#resizing);
  }

  #listenToHand(): void {
    const { frame, zoom } = this.elements;
    const follow = (move: (stage: Stage) => void): void => {
      this.#keepWhole();
      move(this.#stage());
      this.taken();
      this.refit();
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
    if (!this.#camera.showsAll || !this.map().isFinished) return;
    const stage = this.#stage();
    const isPainted = `${this.#camera.framingOn(stage)}` === `${this.#framing}`;
    if (isPainted) this.#wholeMap.keep(this.elements.canvas, this.#camera.boxOn(stage), stage);
  }

  /** Returns the place, for the map that was requested last. */
  #stage(): Stage {
    const { width, height } = this.elements.frame.getBoundingClientRect();
    return { width, height, insets: this.covered(), aspect: this.map().aspect };
  }

  #seenOn(stage: Stage): Seen {
    return { framing: this.#camera.framingOn(stage), whole: new Camera().framingOn(stage), width: stage.width };
  }

  #placeMap(stage: Stage): void {
    const { x, y, width, height } = this.#camera.boxOn(stage);
    const { mapPlace, frame } = this.elements;
    if (this.#camera.showsAll) delete frame.dataset["zoomed"];
    else frame.dataset["zoomed"] = "";
    const shares = { across: width / stage.width, left: x / width, top: y / width, aspect: stage.aspect };
    for (const [name, share] of Object.entries(shares)) frame.style.setProperty(`--map-${name}`, String(share));
    frame.style.setProperty("--window", String(stage.width / stage.height));
    Object.assign(mapPlace.style, { left: `${x}px`, top: `${y}px`, width: `${width}px`, height: `${height}px` });
    this.#offerZoom();
  }

  #offerZoom(): void {
    const { closer, farther, all } = this.elements.zoom;
    closer.disabled = this.#camera.isClosest;
    const hadFocus = [farther, all].some((button) => button === document.activeElement);
    farther.hidden = all.hidden = this.#camera.showsAll;
    // A hidden button loses the focus: it goes to the one that stays.
    if (hadFocus && this.#camera.showsAll) closer.focus();
  }

  /** Moves the old picture to the place of the new one, until that is painted. */
  #movePicture(stage: Stage): void {
    if (!this.#framing) return;
    const transform = transformBetween(this.#framing, this.#camera.framingOn(stage), stage.width);
    this.elements.canvas.style.transform = transform;
  }

  /** Takes note of the part of the map that the picture shows now. */
  #becomeFramed(framing: Framing | undefined): void {
    if (!framing || this.line.isOver) return;
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
    this.#resizing = setTimeout(() => void this.resize(), RESIZE_PAUSE_MS);
  }
}

/** Waits until the browser has shown a frame. */
function twoFrames(): Promise<void> {
  return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done())));
}
