/** The button for play, pause and replay in the bar, and the speed slider in the panel. */

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
    const { play, speed } = this.elements;
    for (const element of [play, speed]) element.disabled = false;
  }

  #setSpeed(): void {
    const { speed: slider, speedShown } = this.elements;
    const speed = SPEEDS[slider.valueAsNumber] ?? 1;
    speedShown.textContent = speedName(speed);
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
