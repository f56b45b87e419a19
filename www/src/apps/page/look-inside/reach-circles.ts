/**
 * Shows the reach and kill distances as circles around a place: the one that is pointed at, or the middle of the
 * visible part.
 */

import { svg } from "../../../browser/dom.ts";
import type { Overlay } from "../../page-worker/protocol.ts";
import type { Point } from "../map/camera.ts";

export interface ReachElements {
  /** The element in the map's place. */
  mapPlace: HTMLElement;
  /** The picture's place. */
  frame: HTMLElement;
}

export class ReachCircles {
  readonly #reach = svg("circle", { class: "reach" });
  readonly #kill = svg("circle", { class: "kill" });
  readonly #spot = svg("path", { class: "reach-spot" });
  readonly element = svg("g", { class: "reaches" }, this.#reach, this.#kill, this.#spot);
  /** The map's size in units; undefined while no circles are shown. */
  #size: Overlay["size"] | undefined;
  /** The place of the pointer on the page, if it was over the map last. */
  #pointed: Point | undefined;

  constructor(
    private readonly elements: ReachElements,
    /** Returns the middle of the visible part of the map, on the page. */
    private readonly middle: () => Point,
  ) {
    const { frame, mapPlace } = elements;
    for (const event of ["pointermove", "pointerdown"] as const)
      frame.addEventListener(event, ({ clientX: x, clientY: y }) => this.#follow({ x, y }));
    frame.addEventListener("pointerleave", ({ pointerType }) => {
      // A finger also leaves when it is lifted; the circles stay there.
      if (pointerType !== "touch") this.#follow(undefined);
    });
    frame.addEventListener("keydown", () => this.#follow(undefined));
    // The map may move under the circles.
    new MutationObserver(() => this.#place()).observe(mapPlace, { attributeFilter: ["style"] });
  }

  show({ size, reaches }: Overlay): void {
    const { reach, kill } = reaches ?? { reach: 0, kill: 0 };
    this.#size = size;
    this.#reach.setAttribute("r", String(reach));
    this.#kill.setAttribute("r", String(kill));
    this.#place();
  }

  hide(): void {
    this.#size = undefined;
  }

  #follow(pointed: Point | undefined): void {
    this.#pointed = pointed;
    this.#place();
  }

  #place(): void {
    if (!this.#size) return;
    const { left, top, width, height } = this.elements.mapPlace.getBoundingClientRect();
    const { x, y } = this.#pointed ?? this.middle();
    const at = { cx: ((x - left) / width) * this.#size[0], cy: ((y - top) / height) * this.#size[1] };
    for (const circle of [this.#reach, this.#kill])
      for (const [name, value] of Object.entries(at)) circle.setAttribute(name, String(value));
    this.#spot.setAttribute("d", `M${at.cx} ${at.cy}h0`);
  }
}
