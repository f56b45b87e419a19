/**
 * The map alone: everything over it is hidden, and the window fills the screen if the browser allows it (an iPhone's
 * does not). A double tap on the map or a key turns it on and off.
 */

import { isCombined, isTaken } from "../../../browser/keys.ts";
import { isOnMap } from "./gestures.ts";
import { DoubleTap } from "./taps.ts";

export interface MapAloneElements {
  /** The element with the attribute that style sheets use. */
  root: HTMLElement;
  /** The button that is shown while the map is alone. */
  leave: HTMLButtonElement;
  /** The map's place. */
  frame: HTMLElement;
}

export class MapAlone {
  readonly #taps = new DoubleTap();

  constructor(
    private readonly elements: MapAloneElements,
    /** Called when other things cover the map, or no longer do. */
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
    // The browser may leave full screen by itself.
    document.addEventListener("fullscreenchange", () => {
      if (!document.fullscreenElement) this.#show(false);
    });
  }

  #toggle(): void {
    if (this.#isOn) this.#leave();
    else this.#enter();
  }

  /** Toggles by the key W, for the whole window. */
  #onKey(event: KeyboardEvent): void {
    if (isTaken(event) || isCombined(event) || event.repeat) return;
    if (event.key.toLowerCase() === "w") this.#toggle();
  }

  /** Leaves, if the map is alone. */
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
    // Some browsers have no full screen, and some refuse it: the map is alone all the same.
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
    // The element that had the focus may be hidden now.
    frame.focus({ preventScroll: true });
    this.changed();
  }
}
