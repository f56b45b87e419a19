/** The buttons for play, pause and replay, and the speed slider. */

import { setText, setValue } from "../../../browser/dom.ts";
import { isCombined, isTaken } from "../../../browser/keys.ts";
import type { State } from "../../../player/frame-loop.ts";

/** The stops of the speed slider, as multiples of the ordinary speed. */
const SPEEDS = [0.25, 0.5, 1, 2, 4, 8, Number.POSITIVE_INFINITY];
const ORDINARY = SPEEDS.indexOf(1);

const NAMES = new Map([
  [0.25, "¼×"],
  [0.5, "½×"],
  [Number.POSITIVE_INFINITY, "instant"],
]);

export function speedName(speed: number): string {
  return NAMES.get(speed) ?? `${speed}×`;
}

const LABELS: Record<State, string> = { growing: "Pause", settling: "Pause", paused: "Play", finished: "Replay" };

export interface TransportElements {
  play: HTMLButtonElement;
  speed: HTMLInputElement;
  speedShown: HTMLElement;
  /**
   * The button that replaces the slider where there is no room for it. Each press goes to the next stop, and from the
   * last to the first.
   */
  pace: HTMLButtonElement;
}

export interface TransportEvents {
  toggle(): void;
  speed(speed: number): void;
}

export class Transport {
  constructor(
    private readonly elements: TransportElements,
    private readonly events: TransportEvents,
  ) {
    elements.speed.max = String(SPEEDS.length - 1);
    setValue(elements.speed, String(ORDINARY));
    elements.play.addEventListener("click", () => events.toggle());
    elements.speed.addEventListener("input", () => this.#setSpeed());
    elements.pace.addEventListener("click", () => {
      const { speed } = elements;
      setValue(speed, String((speed.valueAsNumber + 1) % SPEEDS.length));
      this.#setSpeed();
    });
    document.addEventListener("keydown", (event) => this.#onKey(event));
    this.#setSpeed();
  }

  show(state: State): void {
    const { play } = this.elements;
    const runs = state === "growing" || state === "settling";
    play.dataset["icon"] = runs ? "pause" : "play";
    setText(play.querySelector("span") ?? undefined, LABELS[state]);
  }

  enable(): void {
    const { play, speed, pace } = this.elements;
    for (const element of [play, speed, pace]) element.disabled = false;
  }

  #setSpeed(): void {
    const { speed: slider, speedShown, pace } = this.elements;
    const speed = SPEEDS[slider.valueAsNumber] ?? 1;
    speedShown.textContent = speedName(speed);
    setText(pace.firstElementChild ?? undefined, speedName(speed));
    pace.setAttribute("aria-label", `Speed: ${speedName(speed)}`);
    slider.setAttribute("aria-valuetext", speedName(speed));
    slider.style.setProperty("--share", String(slider.valueAsNumber / (SPEEDS.length - 1)));
    this.events.speed(speed);
  }

  /** Plays and pauses with the space bar. Holding it has no further effect, and it does not scroll. */
  #onKey(event: KeyboardEvent): void {
    if (event.key !== " " || isTaken(event) || isCombined(event)) return;
    event.preventDefault();
    if (!event.repeat) this.events.toggle();
  }
}
