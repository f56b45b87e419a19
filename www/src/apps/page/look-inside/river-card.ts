/** The card that describes what is pointed at in words, and holds what is asked about it. */

import { el, setText } from "../../../browser/dom.ts";
import type { Point } from "../map/camera.ts";
import type { Edges } from "./lines.ts";

/** The gap between the card and its place; below, the width under which the card avoids the whole highlighted part. */
const CARD_GAP_PX = 16;
const NARROW_PX = 600;

export class Card {
  readonly #title = el("p", { class: "river-name", dir: "auto", id: "river-name" });
  readonly #measures = el("p");
  readonly #course = el("p");
  readonly #asked = el("div", { class: "asked" });
  readonly element = el(
    "div",
    { class: "river-card", hidden: true },
    this.#title,
    this.#measures,
    this.#course,
    this.#asked,
  );

  get text(): string {
    const lines = [this.#title, this.#measures, this.#course].map(({ textContent }) => textContent);
    return lines.flatMap((line) => (line ? [`${line}.`] : [])).join(" ");
  }

  describe(title: string, measures = "", course = ""): void {
    setText(this.#title, title);
    setText(this.#measures, measures);
    setText(this.#course, course);
    this.element.toggleAttribute("data-place", course === "");
    this.element.hidden = false;
  }

  /** Shows what is asked, and takes the pointer only while something is. */
  hold(asked: readonly HTMLElement[]): void {
    this.#asked.replaceChildren(...asked);
    const { element } = this;
    if (asked.length === 0) for (const name of ["role", "aria-labelledby"]) element.removeAttribute(name);
    else for (const [name, value] of DIALOG) element.setAttribute(name, value);
  }

  hide(): void {
    this.element.hidden = true;
    this.hold([]);
  }

  /**
   * Puts the card beside a spot if there is room. While something is asked, and on narrow screens, where it would cover
   * half the map, it goes beside, below or above the highlighted part.
   */
  place(spot: Point, lit: Edges | undefined, free: Edges): void {
    const { offsetWidth: width, offsetHeight: height } = this.element;
    const isNarrow = free.right - free.left < NARROW_PX;
    const isAsking = this.element.hasAttribute("role");
    const beside = (before: number, after: number, length: number, from: number, to: number): number => {
      const wanted = after + CARD_GAP_PX + length <= to ? after + CARD_GAP_PX : before - CARD_GAP_PX - length;
      return Math.max(from, Math.min(wanted, to - length));
    };
    const down = (isNarrow && lit) || { top: spot.y, bottom: spot.y };
    const usual = {
      x: beside(spot.x, spot.x, width, free.left, free.right),
      y: beside(down.top, down.bottom, height, free.top, free.bottom),
    };
    const { x, y } = (isAsking && lit && placeClear({ width, height }, spot, lit, free)) || usual;
    this.element.style.left = `${x}px`;
    this.element.style.top = `${y}px`;
  }
}

const DIALOG = [
  ["role", "dialog"],
  ["aria-labelledby", "river-name"],
] as const;

/** Returns the place for a card nearest to a spot that covers nothing of a highlighted part; nothing if there is none. */
export function placeClear(
  { width, height }: { width: number; height: number },
  spot: Point,
  lit: Edges,
  free: Edges,
): Point | undefined {
  const within = (at: number, from: number, to: number): number => Math.max(from, Math.min(at, to));
  const x = within(spot.x - width / 2, free.left, free.right - width);
  const y = within(spot.y - height / 2, free.top, free.bottom - height);
  const places = [
    { x: lit.right + CARD_GAP_PX, y },
    { x: lit.left - CARD_GAP_PX - width, y },
    { x, y: lit.bottom + CARD_GAP_PX },
    { x, y: lit.top - CARD_GAP_PX - height },
  ];
  const away = (place: Point): number => Math.hypot(place.x + width / 2 - spot.x, place.y + height / 2 - spot.y);
  return places
    .filter(({ x, y }) => x >= free.left && x + width <= free.right && y >= free.top && y + height <= free.bottom)
    .sort((one, other) => away(one) - away(other))[0];
}
