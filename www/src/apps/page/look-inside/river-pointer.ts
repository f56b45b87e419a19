/**
 * Shows a river: its way to the sea in bold, its basin highlighted, and a card that describes it. The river is pointed
 * at with a mouse, tapped, reached with keys on the map, or has its name focused in the panel.
 */

import { el, mapLayer, setText, svg } from "../../../browser/dom.ts";
import type { PointedRiver, RiverPlace } from "../../page-worker/protocol.ts";
import type { Insets, Point } from "../map/camera.ts";
import { isOnMap } from "../map/gestures.ts";
import { courseOf, measuresOf, titleOf } from "./river-words.ts";

export interface RiverPointerElements {
  stage: HTMLElement;
  /** The picture's place. */
  frame: HTMLElement;
  /** The element in the map's place. */
  mapPlace: HTMLElement;
}

export interface RiverPointerEvents {
  /** Returns the river at a place of the finished map, if there is one. */
  river(place: RiverPlace): Promise<PointedRiver | undefined>;
  /** Returns the marks of the greatest rivers. */
  greatest(): Promise<readonly string[]>;
  /** Measures how much of the picture's place other things cover. */
  covered(): Insets;
  failed(error: unknown): void;
}

/** The distance in CSS pixels at which a river is hit; larger for a finger. */
const REACH_PX = { mouse: 9, touch: 22 };
/** The limits of a tap in movement and time. */
const TAP_PX = 10;
const TAP_MS = 600;
/** The gap between the card and its place; below, the width under which the card avoids the whole highlighted part. */
const CARD_GAP_PX = 16;
const NARROW_PX = 600;

type How = "pointer" | "key";

export class RiverPointer {
  readonly #card = new Card();
  readonly #lines = new Lines();
  readonly #announcement = el("p", { class: "unseen", role: "status" });
  #isFinished = false;
  #wanted: { place: RiverPlace; how: How } | undefined;
  #frameHandle: number | undefined;
  #isAsking = false;
  #shown: { river: PointedRiver; how: How } | undefined;
  #tap: { x: number; y: number; at: number } | undefined;
  #walkedTo = -1;

  constructor(
    private readonly elements: RiverPointerElements,
    private readonly events: RiverPointerEvents,
  ) {
    const { stage, frame, mapPlace } = elements;
    mapPlace.append(this.#lines.element);
    frame.after(this.#card.element);
    stage.append(this.#announcement);
    frame.addEventListener("pointermove", (event) => this.#onMove(event));
    frame.addEventListener("pointerleave", () => this.#leave());
    frame.addEventListener("pointerdown", (event) => this.#onDown(event));
    frame.addEventListener("pointerup", (event) => this.#onUp(event));
    frame.addEventListener("keydown", (event) => void this.#onFrameKey(event));
    this.#listenToNames();
    // The card follows its place, however that is moved.
    new MutationObserver(() => this.#placeCard()).observe(mapPlace, { attributeFilter: ["style"] });
  }

  /** Follows the map's state. A river is shown only on a finished map. */
  follow(state: string): void {
    this.#isFinished = state === "finished";
    this.#walkedTo = -1;
    this.hide();
  }

  /** Hides the river that is shown. */
  escape(): boolean {
    const wasShown = this.#shown !== undefined;
    this.hide();
    return wasShown;
  }

  hide(): void {
    this.#wanted = undefined;
    if (!this.#shown) return;
    this.#shown = undefined;
    this.#card.hide();
    this.#lines.hide();
    delete this.elements.frame.dataset["river"];
    this.#announcement.textContent = "";
  }

  // ---- pointers

  #onMove(event: PointerEvent): void {
    if (event.pointerType === "touch") return;
    // Dragging moves the map.
    if (event.buttons !== 0 || !isOnMap(event)) this.#leave();
    else this.#ask(this.#placeOf(event, REACH_PX.mouse), "pointer");
  }

  #leave(): void {
    if (this.#wanted?.how === "pointer") this.#wanted = undefined;
    if (this.#shown?.how === "pointer") this.hide();
  }

  #onDown(event: PointerEvent): void {
    const isTap = event.pointerType === "touch" && event.isPrimary && isOnMap(event);
    this.#tap = isTap ? { x: event.clientX, y: event.clientY, at: event.timeStamp } : undefined;
  }

  #onUp(event: PointerEvent): void {
    const tap = this.#tap;
    this.#tap = undefined;
    if (!tap || !event.isPrimary || event.timeStamp - tap.at > TAP_MS) return;
    if (Math.hypot(event.clientX - tap.x, event.clientY - tap.y) > TAP_PX) return;
    this.#ask(this.#placeOf(event, REACH_PX.touch), "key");
  }

  #placeOf({ clientX, clientY }: PointerEvent, reachPx: number): RiverPlace {
    const { left, top, width, height } = this.elements.mapPlace.getBoundingClientRect();
    return { x: (clientX - left) / width, y: (clientY - top) / height, reach: reachPx / width };
  }

  // ---- keys

  /** Walks through the greatest rivers with N, and back with Shift+N. */
  async #onFrameKey(event: KeyboardEvent): Promise<void> {
    const isPlain = !(event.ctrlKey || event.metaKey || event.altKey);
    if (event.key.toLowerCase() !== "n" || !isPlain || event.target !== this.elements.frame) return;
    event.preventDefault();
    if (!this.#isFinished) return;
    const marks = await this.events.greatest();
    if (marks.length === 0) return;
    const step = event.shiftKey ? -1 : 1;
    const from = this.#walkedTo < 0 && step < 0 ? 0 : this.#walkedTo;
    this.#walkedTo = (from + step + marks.length) % marks.length;
    const mark = marks[this.#walkedTo];
    if (mark !== undefined) this.#ask({ mark }, "key");
  }

  /** Shows a river while its name in the panel has the focus. */
  #listenToNames(): void {
    const markOf = ({ target }: Event): string | undefined =>
      target instanceof Element ? target.closest<HTMLElement>(".names [data-mark]")?.dataset["mark"] : undefined;
    document.addEventListener("focusin", (event) => {
      const mark = markOf(event);
      if (mark !== undefined && isRiver(mark)) this.#ask({ mark }, "key");
    });
    document.addEventListener("focusout", (event) => {
      if (markOf(event) !== undefined) this.hide();
    });
  }

  // ---- questions, at most one per frame, for the last place only

  #ask(place: RiverPlace, how: How): void {
    if (!this.#isFinished || this.elements.stage.hasAttribute("data-drawing")) return;
    this.#wanted = { place, how };
    this.#frameHandle ??= requestAnimationFrame(() => {
      this.#frameHandle = undefined;
      void this.#answer();
    });
  }

  async #answer(): Promise<void> {
    const wanted = this.#wanted;
    if (this.#isAsking || !wanted) return;
    this.#isAsking = true;
    const river = await this.events.river(wanted.place).catch((error) => {
      this.events.failed(error);
      return undefined;
    });
    this.#isAsking = false;
    if (this.#wanted === wanted) this.#show(river, wanted.how);
    else if (this.#wanted) this.#ask(this.#wanted.place, this.#wanted.how);
  }

  #show(river: PointedRiver | undefined, how: How): void {
    if (!river) {
      this.hide();
      return;
    }
    this.#shown = { river, how };
    this.elements.frame.dataset["river"] = river.mark;
    this.#lines.show(river);
    this.#card.show(river);
    this.#placeCard();
    // Rivers under a moving mouse are not read aloud.
    if (how === "key") this.#announcement.textContent = this.#card.text;
  }

  #placeCard(): void {
    if (!this.#shown) return;
    const { frame, mapPlace } = this.elements;
    const { x, y } = this.#shown.river;
    const map = mapPlace.getBoundingClientRect();
    const place = frame.getBoundingClientRect();
    const { left, top, right, bottom } = this.events.covered();
    const free = { left, top, right: place.width - right, bottom: place.height - bottom };
    const spot = { x: map.left - place.left + x * map.width, y: map.top - place.top + y * map.height };
    this.#card.place(spot, this.#lines.extent, free);
  }
}

/** The edges of a part of the page, in CSS pixels. */
type Edges = Insets;

/** The drawing of the way to the sea and of the basin. */
class Lines {
  readonly element = mapLayer("river-pointer");
  readonly #paths = ["basin", "way-halo", "way", "spot-halo", "spot"].map((name) => svg("path", { class: name }));

  constructor() {
    this.element.append(...this.#paths);
  }

  show({ basin, way, x, y, size: [width, height] }: PointedRiver): void {
    this.element.removeAttribute("hidden");
    this.element.setAttribute("viewBox", `0 0 ${width} ${height}`);
    const spot = `M${x * width} ${y * height}h0`;
    for (const [i, data] of [basin, way, way, spot, spot].entries()) {
      if (this.#paths[i]?.getAttribute("d") !== data) this.#paths[i]?.setAttribute("d", data);
    }
  }

  hide(): void {
    this.element.setAttribute("hidden", "");
  }

  /** Its top and bottom on the page. */
  get extent(): { top: number; bottom: number } {
    const [basin, way] = this.#paths.map((path) => path.getBoundingClientRect());
    if (!basin || !way) return { top: 0, bottom: 0 };
    // The basin of a river may be empty.
    const boxes = basin.height > 0 ? [basin, way] : [way];
    return { top: Math.min(...boxes.map(({ top }) => top)), bottom: Math.max(...boxes.map(({ bottom }) => bottom)) };
  }
}

/** The card that describes a river in words. */
class Card {
  readonly #title = el("p", { class: "river-name", dir: "auto" });
  readonly #measures = el("p");
  readonly #course = el("p");
  readonly element = el("div", { class: "river-card", hidden: true }, this.#title, this.#measures, this.#course);

  get text(): string {
    return [this.#title, this.#measures, this.#course].map(({ textContent }) => `${textContent}.`).join(" ");
  }

  show(river: PointedRiver): void {
    setText(this.#title, titleOf(river));
    setText(this.#measures, measuresOf(river));
    setText(this.#course, courseOf(river));
    this.element.hidden = false;
  }

  hide(): void {
    this.element.hidden = true;
  }

  /**
   * Puts the card beside a spot if there is room. On narrow screens, where it would cover half the map, it goes below
   * or above the highlighted part.
   */
  place(spot: Point, lit: Pick<Edges, "top" | "bottom">, free: Edges): void {
    const { offsetWidth: width, offsetHeight: height } = this.element;
    const isNarrow = free.right - free.left < NARROW_PX;
    const beside = (before: number, after: number, length: number, from: number, to: number): number => {
      const wanted = after + CARD_GAP_PX + length <= to ? after + CARD_GAP_PX : before - CARD_GAP_PX - length;
      return Math.max(from, Math.min(wanted, to - length));
    };
    const down = isNarrow ? lit : { top: spot.y, bottom: spot.y };
    this.element.style.left = `${beside(spot.x, spot.x, width, free.left, free.right)}px`;
    this.element.style.top = `${beside(down.top, down.bottom, height, free.top, free.bottom)}px`;
  }
}

/** Returns whether a mark is a river's. Marks of seas, lakes, islands, meanders and the map begin with a letter. */
export function isRiver(mark: string): boolean {
  return /^\d/.test(mark);
}
