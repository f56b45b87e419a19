/**
 * The map alone: all that lies over it is put away, and the window fills the screen where the browser lets it, which that of an iPhone
 * does not. Two taps of a finger on the map do it, or a key, and undo it.
 */

import { isCombined, isTaken } from "../../../browser/keys.ts";
import { isOnMap } from "./gestures.ts";
import { DoubleTap } from "./taps.ts";

export interface MapAloneElements {
  /** Has the mark that style sheets go by. */
  root: HTMLElement;
  /** Seen while the map is alone. */
  leave: HTMLButtonElement;
  /** The map's place. */
  frame: HTMLElement;
}

export class MapAlone {
  readonly #taps = new DoubleTap();

  constructor(
    private readonly elements: MapAloneElements,
    /** Other things cover the map, or none do any more. */
    private readonly changed: () => void,
  ) {
    const { frame, leave } = elements;
    leave.addEventListener("click", () => this.#leave());
    document.addEventListener("keydown", (event) => this.#onKey(event));
    frame.addEventListener("pointerdown", (event) => {
      if (isOnMap(event)) this.#taps.down(event);
    });
    frame.addEventListener("pointerup", (event) => {
      if (this.#taps.up(event)) this.#toggle();
    });
    frame.addEventListener("pointercancel", () => this.#taps.cancel());
    // The browser has a way out of its own.
    document.addEventListener("fullscreenchange", () => {
      if (!document.fullscreenElement) this.#show(false);
    });
  }

  #toggle(): void {
    if (this.#isOn) this.#leave();
    else this.#enter();
  }

  /** W, for the whole window. */
  #onKey(event: KeyboardEvent): void {
    if (isTaken(event) || isCombined(event) || event.repeat) return;
    if (event.key.toLowerCase() === "w") this.#toggle();
  }

  /** Back, if the map is alone. */
  escape(): boolean {
    const wasOn = this.#isOn;
    if (wasOn) this.#leave();
    return wasOn;
  }

  get #isOn(): boolean {
    return this.elements.root.hasAttribute("data-map-alone");
  }

  #enter(): void {
    this.#show(true);
    // Some browsers have no such thing, and some refuse it: the map is alone all the same.
    this.elements.root.requestFullscreen?.({ navigationUI: "hide" }).catch(() => {});
  }

  #leave(): void {
    this.#show(false);
    if (document.fullscreenElement) document.exitFullscreen().catch(() => {});
  }

  #show(isOn: boolean): void {
    if (isOn === this.#isOn) return;
    const { root, leave, frame } = this.elements;
    root.toggleAttribute("data-map-alone", isOn);
    leave.hidden = !isOn;
    // What had the focus may be gone.
    frame.focus({ preventScroll: true });
    this.changed();
  }
}
