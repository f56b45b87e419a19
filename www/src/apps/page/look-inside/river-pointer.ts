/**
 * Shows a river: its way to the sea in bold, its basin highlighted, and a card that describes it. The river is pointed
 * at with a mouse or reached with keys on the map. Whatever is pinned stays on show instead: it is being named, or its
 * name in the panel is pointed at or has the focus.
 */

import { el } from "../../../browser/dom.ts";
import { isCombined, isTaken } from "../../../browser/keys.ts";
import type { Nameable, Nameables, PointedRiver, RiverPlace } from "../../page-worker/protocol.ts";
import type { Insets } from "../map/camera.ts";
import { isOnMap } from "../map/gestures.ts";
import { titleOfPlace } from "../naming/words.ts";
import { Lines } from "./lines.ts";
import { Card } from "./river-card.ts";
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
}

/** The distance in CSS pixels at which a river is hit; larger for a finger. */
export const REACH_PX = { mouse: 9, touch: 22 };

type How = "pointer" | "key";

/** A place of the map, in shares of its sides. */
type Spot = Pick<PointedRiver, "x" | "y">;

export class RiverPointer {
  readonly #card = new Card();
  readonly #lines = new Lines();
  readonly #announcement = el("p", { class: "unseen", role: "status" });
  #isFinished = false;
  /** The link of the map that it follows. */
  #link = "";
  #wanted: { place: RiverPlace; how: How } | undefined;
  #frameHandle: number | undefined;
  #isAsking = false;
  #shown: { at: Spot; how: How | "pin" } | undefined;
  /** Counts what was pinned: a late answer about a former one is dropped. */
  #pins = 0;
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
    document.addEventListener("keydown", (event) => void this.#onKey(event));
    // The card follows its place, however that is moved.
    new MutationObserver(() => this.#placeCard()).observe(mapPlace, { attributeFilter: ["style"] });
  }

  /**
   * Follows the map's state. A river is shown only on a finished map, and stays when that is only painted again, with
   * its names or in another size.
   */
  follow(state: string, link: string): void {
    const wasThere = this.#isFinished && this.#link === link;
    this.#link = link;
    this.#isFinished = state === "finished";
    if (this.#isFinished && wasThere) return;
    this.#walkedTo = -1;
    this.hide();
  }

  get isFinished(): boolean {
    return this.#isFinished;
  }

  /** True while something stays on show until `hide`. */
  get isPinned(): boolean {
    return this.#shown?.how === "pin";
  }

  /** The mark of the river that was reached with keys, if it is on show. */
  get walkedTo(): string | undefined {
    return this.#shown?.how === "key" ? this.elements.frame.dataset["river"] : undefined;
  }

  /** The card, where more can be asked about what is pinned. */
  get card(): Card {
    return this.#card;
  }

  /**
   * Keeps something on show, whatever is pointed at. Returns whether it is, and not something else meanwhile. `asked`
   * goes into the card below its description.
   */
  async pin(thing: Nameable, { size }: Nameables, asked: readonly HTMLElement[] = []): Promise<boolean> {
    const pin = ++this.#pins;
    const river = thing.kind === "river" ? await this.#riverOf(thing) : undefined;
    if (pin !== this.#pins) return false;
    this.#wanted = undefined;
    const [x = 0.5, y = 0.5] = middleOf(thing.line);
    this.#shown = { at: river ?? { x, y }, how: "pin" };
    if (river) this.#lay(river);
    else {
      delete this.elements.frame.dataset["river"];
      this.#lines.mark(thing, size);
      this.#card.describe(...titleOfPlace(thing));
    }
    this.#card.hold(asked);
    this.#placeCard();
    return true;
  }

  /** Has screen readers say something about what was shown. */
  say(text: string): void {
    this.#announcement.textContent = text;
  }

  /** Places the card again, after it has become larger or smaller. */
  refit(): void {
    this.#placeCard();
  }

  /** Returns a river from where it was clicked, or from its source. */
  async #riverOf({ mark, line }: Nameable): Promise<PointedRiver | undefined> {
    const [x = 0, y = 0] = Array.from(line);
    try {
      const there = await this.events.river({ x, y, reach: HERE });
      return there?.mark === mark ? there : await this.events.river({ mark });
    } catch {
      // The viewport tells of a renderer that fails.
      return undefined;
    }
  }

  /** Hides what is shown. */
  escape(): boolean {
    const wasShown = this.#shown !== undefined;
    this.hide();
    return wasShown;
  }

  hide(): void {
    this.#wanted = undefined;
    this.#pins++;
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

  #placeOf({ clientX, clientY }: PointerEvent, reachPx: number): RiverPlace {
    return placeOn(this.elements.mapPlace, clientX, clientY, reachPx);
  }

  // ---- keys

  /** Walks through the greatest rivers with N, and back with Shift+N. The map has the focus then, so that Enter names one. */
  async #onKey(event: KeyboardEvent): Promise<void> {
    const { frame } = this.elements;
    const isForMap = event.target === frame || !isTaken(event);
    if (event.key.toLowerCase() !== "n" || isCombined(event) || !isForMap) return;
    event.preventDefault();
    if (!this.#isFinished) return;
    frame.focus({ preventScroll: true });
    const marks = await this.events.greatest();
    if (marks.length === 0) return;
    const step = event.shiftKey ? -1 : 1;
    const from = this.#walkedTo < 0 && step < 0 ? 0 : this.#walkedTo;
    this.#walkedTo = (from + step + marks.length) % marks.length;
    const mark = marks[this.#walkedTo];
    if (mark !== undefined) this.#ask({ mark }, "key");
  }

  // ---- questions, at most one per frame, for the last place only

  #ask(place: RiverPlace, how: How): void {
    if (!this.#isFinished || this.isPinned || this.elements.stage.hasAttribute("data-drawing")) return;
    this.#wanted = { place, how };
    this.#frameHandle ??= requestAnimationFrame(() => {
      this.#frameHandle = undefined;
      void this.#answer();
    });
  }

  async #answer(): Promise<void> {
    const wanted = this.#wanted;
    if (this.#isAsking || !wanted || this.isPinned) return;
    this.#isAsking = true;
    const river = await this.events.river(wanted.place).catch(() => undefined);
    this.#isAsking = false;
    if (this.#wanted === wanted) this.#show(river, wanted.how);
    else if (this.#wanted) this.#ask(this.#wanted.place, this.#wanted.how);
  }

  #show(river: PointedRiver | undefined, how: How): void {
    if (!river) {
      this.hide();
      return;
    }
    this.#shown = { at: river, how };
    this.#lay(river);
    this.#card.hold([]);
    this.#placeCard();
    // Rivers under a moving mouse are not read aloud.
    if (how === "key") this.#announcement.textContent = this.#card.text;
  }

  #lay(river: PointedRiver): void {
    this.elements.frame.dataset["river"] = river.mark;
    this.#lines.show(river);
    this.#card.describe(titleOf(river), measuresOf(river), courseOf(river));
  }

  #placeCard(): void {
    if (!this.#shown) return;
    const { frame, mapPlace } = this.elements;
    const { x, y } = this.#shown.at;
    const map = mapPlace.getBoundingClientRect();
    const place = frame.getBoundingClientRect();
    const { left, top, right, bottom } = this.events.covered();
    const free = { left, top, right: place.width - right, bottom: Math.min(place.height - bottom, seenBelow()) };
    const spot = { x: map.left - place.left + x * map.width, y: map.top - place.top + y * map.height };
    this.#card.place(spot, this.#lines.extent(!this.isPinned), free);
  }
}

/** Less than rivers are apart, as a share of the map's width. */
const HERE = 1e-4;

/** Returns a place of the map under a point of the page. */
export function placeOn(
  mapPlace: HTMLElement,
  clientX: number,
  clientY: number,
  reachPx: number,
): { x: number; y: number; reach: number } {
  const { left, top, width, height } = mapPlace.getBoundingClientRect();
  return { x: (clientX - left) / width, y: (clientY - top) / height, reach: reachPx / width };
}

/** Returns how far down the window is seen: a phone's keyboard may cover the rest. */
function seenBelow(): number {
  const { offsetTop = 0, height = innerHeight } = window.visualViewport ?? {};
  return offsetTop + height;
}

/** Returns the point in the middle of a line; nothing of an empty one. */
function middleOf(line: ArrayLike<number>): (number | undefined)[] {
  const i = 2 * Math.floor(line.length / 4);
  return [line[i], line[i + 1]];
}

/** Returns whether a mark is a river's. Marks of seas, lakes, islands, meanders and the map begin with a letter. */
export function isRiver(mark: string): boolean {
  return /^\d/.test(mark);
}
