/** The drawing tool: a coast drawn over the picture becomes the land, and the rivers follow the pen. */

import { setText } from "../../../browser/dom.ts";
import { isTaken } from "../../../browser/keys.ts";
import { named } from "../../../engine/errors.ts";
import type { Lines, Traced } from "../../../engine/whole.ts";
import { showLines } from "./overlay.ts";
import { LINE_KINDS, type LineKind, pointsOf, Sketch, tally } from "./sketch.ts";

/** The part of the engine that reads outlines and makes them. */
export interface Outlines {
  outlineLines(text: string): Lines;
  /** Makes an outline from lines of any length. Throws an error with the code "no-land" if they enclose no land. */
  outlineOf(coasts: Float32Array[], ridges: Float32Array[], rivers: Float32Array[]): string;
}

export interface DrawingElements {
  draw: HTMLButtonElement;
  stage: HTMLElement;
  sketch: SVGSVGElement;
  tools: HTMLElement;
  status: HTMLElement;
  coast: HTMLButtonElement;
  ridge: HTMLButtonElement;
  river: HTMLButtonElement;
  undo: HTMLButtonElement;
  clear: HTMLButtonElement;
  done: HTMLButtonElement;
}

export interface DrawingEvents {
  /** Called when another outline is drawn. */
  drawn(outline: string): void;
  failed(error: unknown): void;
}

const NOTHING: Lines = { coasts: [], ridges: [], rivers: [] };
const HINTS: Record<LineKind, string> = {
  coast: "Draw a coast: it closes when you lift the pen. Within land it makes a lake.",
  ridge: "Draw a ridge across the land: no river will cross it.",
  river: "Draw a river from its mouth inland, or touch the coast where one should begin.",
};

const LONGER = " It is longer than a map can be: land and water at its long sides continue beyond them.";
const HEIGHTS =
  " It looks like a heightmap, but light is land here and dark is water: choose a picture that is white where its land is, and black elsewhere.";

export class Drawing {
  readonly #sketch = new Sketch();
  #kind: LineKind = "coast";
  #isOpen = false;
  /** The outline on show. */
  #outline = "";
  #kept = NOTHING;
  #pointer: number | undefined;
  #frame = 0;

  constructor(
    private readonly elements: DrawingElements,
    private readonly core: Outlines,
    private readonly events: DrawingEvents,
  ) {
    elements.draw.addEventListener("click", () => this.open());
    elements.done.addEventListener("click", () => this.close());
    for (const kind of LINE_KINDS) elements[kind].addEventListener("click", () => this.#choose(kind));
    elements.undo.addEventListener("click", () => this.#edit(() => this.#sketch.undo()));
    elements.clear.addEventListener("click", () => this.#edit(() => this.#sketch.clear()));
    document.addEventListener("keydown", (event) => this.#onKey(event));
    this.#listenToPen();
  }

  get isOpen(): boolean {
    return this.#isOpen;
  }

  /** Opens the tool with the outline on show. */
  open(): void {
    if (this.#isOpen) return;
    this.#switch(true);
    this.#choose(this.#kind);
    this.elements.coast.focus({ preventScroll: true });
  }

  close(): void {
    if (!this.#isOpen) return;
    this.#sketch.cancel();
    this.#switch(false);
    this.elements.draw.focus({ preventScroll: true });
  }

  /** Follows the recipe: its outline may have come from a link, or gone with a reset. */
  show(outline: string): void {
    if (outline === this.#outline) return;
    this.#outline = outline;
    this.#kept = this.core.outlineLines(outline);
    this.#sketch.open(this.#kept);
    this.#tell();
  }

  /** Replaces the drawing by a traced outline, and shows what the tracing kept. */
  take(traced: Traced): void {
    const lines = this.core.outlineLines(traced.outline);
    this.open();
    this.#sketch.replace(lines);
    this.#become(traced.outline, lines);
    const notes = [traced.isLonger ? LONGER : "", traced.looksLikeHeights ? HEIGHTS : ""];
    this.#say(`Kept of the picture: ${tally(lines, traced)}.${notes.join("")}`);
  }

  #switch(isOpen: boolean): void {
    this.#isOpen = isOpen;
    const { stage, sketch, tools, draw } = this.elements;
    stage.toggleAttribute("data-drawing", isOpen);
    sketch.toggleAttribute("hidden", !isOpen);
    tools.hidden = !isOpen;
    draw.setAttribute("aria-expanded", String(isOpen));
    this.#tell();
  }

  #choose(kind: LineKind): void {
    this.#kind = kind;
    for (const each of LINE_KINDS) this.elements[each].setAttribute("aria-pressed", String(each === kind));
    this.#say(HINTS[kind]);
  }

  #onKey(event: KeyboardEvent): void {
    if (!this.#isOpen || isTaken(event) || event.altKey || event.shiftKey) return;
    if (event.key.toLowerCase() !== "z" || !(event.ctrlKey || event.metaKey)) return;
    event.preventDefault();
    this.#edit(() => this.#sketch.undo());
  }

  #listenToPen(): void {
    const { sketch } = this.elements;
    sketch.addEventListener("pointerdown", (event) => this.#penDown(event));
    sketch.addEventListener("pointermove", (event) => this.#penMoves(event));
    sketch.addEventListener("pointerup", (event) => this.#penUp(event, () => this.#sketch.end()));
    sketch.addEventListener("pointercancel", (event) => this.#penUp(event, () => this.#sketch.cancel()));
  }

  #penDown(event: PointerEvent): void {
    if (this.#pointer !== undefined || event.button !== 0) return;
    event.preventDefault();
    this.#pointer = event.pointerId;
    this.elements.sketch.setPointerCapture(event.pointerId);
    this.#sketch.begin(this.#kind, ...this.#place(event));
    this.#soon();
  }

  #penMoves(event: PointerEvent): void {
    if (event.pointerId !== this.#pointer) return;
    // A pen reports many places between two frames; some browsers give only the last.
    const events = event.getCoalescedEvents?.() ?? [];
    let isFarther = false;
    for (const one of events.length > 0 ? events : [event]) {
      isFarther = this.#sketch.extend(...this.#place(one)) || isFarther;
    }
    if (isFarther) this.#soon();
  }

  #penUp(event: PointerEvent, finish: () => void): void {
    if (event.pointerId !== this.#pointer) return;
    this.#pointer = undefined;
    this.#edit(finish);
  }

  #place({ clientX, clientY }: PointerEvent): [x: number, y: number] {
    const { left, top, width, height } = this.elements.sketch.getBoundingClientRect();
    return [(clientX - left) / width, (clientY - top) / height];
  }

  /** Updates the land in the next frame, while the pen moves. */
  #soon(): void {
    this.#frame ||= requestAnimationFrame(() => this.#follow());
  }

  #edit(change: () => void): void {
    change();
    this.#follow();
  }

  #follow(): void {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    try {
      this.#outlineSketch();
    } catch (error) {
      this.events.failed(error);
    }
  }

  #outlineSketch(): void {
    const { lines, isLive } = this.#sketch;
    if (lines.length === 0) {
      this.#becomeNothing(HINTS[this.#kind]);
      return;
    }
    try {
      const of = (kind: LineKind) => pointsOf(lines, kind);
      const outline = this.core.outlineOf(of("coast"), of("ridge"), of("river"));
      this.#become(outline, this.core.outlineLines(outline));
      if (!isLive) this.#say(`${tally(this.#kept, this.#sketch.counts)}.`);
    } catch (thrown) {
      const error = named(thrown);
      if (error.code !== "no-land") throw thrown;
      // A line that has just begun makes no land yet: until it does, everything stays as it was.
      if (isLive) this.#tell();
      else this.#becomeNothing(`Not shown yet: ${error.message}.`);
    }
  }

  #becomeNothing(hint: string): void {
    this.#become("", NOTHING);
    this.#say(hint);
  }

  #become(outline: string, kept: Lines): void {
    const isNew = outline !== this.#outline;
    this.#outline = outline;
    this.#kept = kept;
    this.#tell();
    if (isNew) this.events.drawn(outline);
  }

  /** Moves the focus from a button that has become disabled to the tool in use, so that it is not lost. */
  #keepFocus(focused: Element | null): void {
    const { undo, clear } = this.elements;
    const isLost = [undo, clear].some((button) => button.disabled && button === focused);
    if (isLost) this.elements[this.#kind].focus({ preventScroll: true });
  }

  #say(text: string): void {
    setText(this.elements.status, text);
  }

  /** Shows the lines, and enables the buttons that have something to do. */
  #tell(): void {
    const { sketch, undo, clear } = this.elements;
    const { lines, isLive, canUndo } = this.#sketch;
    // Some browsers take the focus away at once from what becomes disabled.
    const focused = document.activeElement;
    undo.disabled = !canUndo;
    clear.disabled = lines.length === 0;
    if (!this.#isOpen) return;
    this.#keepFocus(focused);
    const raw = this.#kept === NOTHING ? lines : lines.slice(isLive ? -1 : lines.length);
    showLines(sketch, this.#kept, raw);
  }
}
