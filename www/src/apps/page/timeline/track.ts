/**
 * The making of a map on one track: land, growth, bends, map. The thumb shows the present moment, and can be moved back
 * and forth by dragging or with keys.
 */

import { el } from "../../../browser/dom.ts";
import { isCombined, isTaken } from "../../../browser/keys.ts";
import type { Making, Moment } from "../../page-worker/protocol.ts";

export interface TrackEvents {
  /** Returns the progress of the map. If a moment is given, goes there first. */
  making(to?: Moment): Promise<Making | undefined>;
}

type Lengths = NonNullable<Making["lengths"]>;
type Part = "land" | "growth" | "bends" | "map";

/** The relative length of each part on the track. */
const WEIGHTS: readonly (readonly [part: Part, weight: number])[] = [
  ["land", 1],
  ["growth", 12],
  ["bends", 6],
  ["map", 2],
];
const WHOLE = WEIGHTS.reduce((sum, [, weight]) => sum + weight, 0);
/** The steps of keys, in shares of the track. */
const KEY_STEPS: Record<string, number> = {
  ArrowRight: 0.01,
  ArrowUp: 0.01,
  ArrowLeft: -0.01,
  ArrowDown: -0.01,
  PageUp: 0.1,
  PageDown: -0.1,
};

export class Track {
  readonly #shown = el("span", { class: "track-shown", "aria-hidden": "true" });
  readonly #thumb = el("span", { class: "track-thumb" }, this.#shown);
  readonly element = el("div", {
    class: "track",
    role: "slider",
    tabindex: "0",
    "aria-label": "The making of the map",
    "aria-valuemin": "0",
    "aria-valuemax": "100",
  });
  #making: Making | undefined;
  /** The last requested moment, until it is reached. */
  #wanted: Moment | undefined;
  #isAsking = false;
  #asked = 0;

  constructor(
    place: HTMLElement,
    private readonly events: TrackEvents,
  ) {
    const parts = WEIGHTS.map(([part, weight]) => {
      const element = el("span", { class: "track-part", "data-part": part });
      element.style.flexGrow = String(weight);
      return element;
    });
    this.element.append(...parts, this.#thumb);
    place.prepend(this.element);
    this.element.addEventListener("keydown", (event) => this.#onKey(event));
    this.element.addEventListener("pointerdown", (event) => this.#down(event));
    this.element.addEventListener("pointermove", (event) => {
      if (this.element.hasPointerCapture(event.pointerId)) this.#drag(event);
    });
    document.addEventListener("keydown", (event) => this.#onPageKey(event));
    this.#show();
  }

  /** Follows a change of the map. */
  async follow(): Promise<void> {
    if (this.#isAsking) return;
    this.#isAsking = true;
    const asked = this.#asked;
    const making = await this.events.making().catch(() => undefined);
    this.#isAsking = false;
    // While the thumb is dragged, the answers to that count.
    if (asked !== this.#asked || this.#wanted) return;
    this.#making = making ?? this.#making;
    this.#show();
  }

  // ---- moving

  #down(event: PointerEvent): void {
    if (event.button !== 0 || !this.#making?.lengths) return;
    this.element.setPointerCapture(event.pointerId);
    event.preventDefault();
    this.element.focus({ preventScroll: true });
    this.#drag(event);
  }

  #drag({ clientX }: PointerEvent): void {
    const { left, width } = this.element.getBoundingClientRect();
    this.#goTo((clientX - left) / width);
  }

  #goTo(share: number): void {
    const lengths = this.#making?.lengths;
    if (lengths) this.#go(momentAt(Math.min(1, Math.max(0, share)), lengths));
  }

  #go(to: Moment): void {
    const now = this.#wanted ?? this.#making?.at;
    if (now && isSame(now, to)) return;
    this.#wanted = to;
    this.#show();
    void this.#send(to);
  }

  async #send(to: Moment): Promise<void> {
    const asked = ++this.#asked;
    const making = await this.events.making(to).catch(() => undefined);
    if (asked !== this.#asked) return;
    this.#wanted = undefined;
    this.#making = making ?? this.#making;
    this.#show();
  }

  #onKey(event: KeyboardEvent): void {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const step = KEY_STEPS[event.key];
    if (step !== undefined) this.#moveBy(step);
    else if (event.key === "Home") this.#goTo(0);
    else if (event.key === "End") this.#goTo(1);
    else return;
    event.preventDefault();
  }

  /** Moves by a share of the track, and by at least one step. */
  #moveBy(step: number): void {
    const lengths = this.#making?.lengths;
    const from = this.#wanted ?? this.#making?.at;
    if (!lengths || !from) return;
    const to = momentAt(Math.min(1, Math.max(0, shareOf(from, lengths) + step)), lengths);
    this.#go(isSame(from, to) ? stepped(from, Math.sign(step), lengths) : to);
  }

  /** Moves back by a tick or round with a comma, and forward with a full stop. */
  #onPageKey(event: KeyboardEvent): void {
    if (isTaken(event) || isCombined(event)) return;
    const step = { ",": -1, ".": 1 }[event.key];
    const from = this.#wanted ?? this.#making?.at;
    const lengths = this.#making?.lengths;
    if (!step || !from || !lengths) return;
    event.preventDefault();
    this.#go(stepped(from, step, lengths));
  }

  // ---- showing

  #show(): void {
    const at = this.#wanted ?? this.#making?.at ?? { part: "growth", step: 0 };
    const { lengths, progress = 0 } = this.#making ?? {};
    const share = lengths ? shareOf(at, lengths) : onTheWay(at, progress);
    const text = lengths ? inWords(at, lengths) : `${partOf(at)}, not finished yet`;
    this.element.style.setProperty("--share", String(share));
    this.element.setAttribute("aria-valuenow", String(Math.round(share * 100)));
    this.element.setAttribute("aria-valuetext", text);
    this.element.setAttribute("aria-disabled", String(!lengths));
    this.element.title = lengths ? "" : "Once the map is finished, its making can be seen back and forth";
    if (this.#shown.textContent !== text) this.#shown.textContent = text;
  }
}

/** Returns the beginning and end of a part, in shares of the track. */
function span(part: Part): [from: number, to: number] {
  let from = 0;
  for (const [name, weight] of WEIGHTS) {
    if (name === part) return [from / WHOLE, (from + weight) / WHOLE];
    from += weight;
  }
  return [0, 1];
}

function partOf({ part, step }: Moment): Part {
  return part === "growth" && step === 0 ? "land" : part;
}

function within(part: Part, share: number): number {
  const [from, to] = span(part);
  return from + (to - from) * Math.min(1, Math.max(0, share));
}

export function shareOf(at: Moment, { ticks, rounds }: Lengths): number {
  const part = partOf(at);
  if (part === "land") return 0;
  if (part === "growth") return within(part, at.step / ticks);
  return part === "bends" ? within(part, at.step / (rounds + 1)) : 1;
}

/** Returns the place on the track of a map that has not been finished yet. */
function onTheWay(at: Moment, progress: number): number {
  return at.part === "map" ? 1 : within(partOf(at), progress);
}

export function momentAt(share: number, { ticks, rounds }: Lengths): Moment {
  const [grows, bends] = span("growth");
  const [, map] = span("bends");
  if (share >= bends) return later(share, bends, map, rounds);
  if (share < grows || ticks < 2) return { part: "growth", step: 0 };
  const step = Math.round(((share - grows) / (bends - grows)) * ticks);
  return { part: "growth", step: Math.min(ticks - 1, Math.max(1, step)) };
}

function later(share: number, from: number, to: number, rounds: number): Moment {
  if (share >= to) return { part: "map", step: 0 };
  return { part: "bends", step: Math.min(rounds, Math.round(((share - from) / (to - from)) * (rounds + 1))) };
}

/** Returns the moment after or before another. At the first and the last it stays. */
export function stepped({ part, step }: Moment, by: number, { ticks, rounds }: Lengths): Moment {
  const next = step + by;
  if (part === "map") return by < 0 ? { part: "bends", step: rounds } : { part, step };
  if (next < 0) return part === "growth" ? { part, step } : { part: "growth", step: Math.max(0, ticks - 1) };
  if (part === "growth") return next < ticks ? { part, step: next } : { part: "bends", step: 0 };
  return next <= rounds ? { part, step: next } : { part: "map", step: 0 };
}

export function inWords(at: Moment, { ticks, rounds }: Lengths): string {
  const part = partOf(at);
  if (part === "growth") return `growth, ${Math.round((at.step / ticks) * 100)} %`;
  if (part === "bends") return rounds === 0 ? "rivers" : `bends, round ${at.step} of ${rounds}`;
  return part === "map" ? "finished map" : "land";
}

function isSame(one: Moment, other: Moment): boolean {
  return one.part === other.part && one.step === other.step;
}
