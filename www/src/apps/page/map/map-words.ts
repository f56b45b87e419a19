/**
 * Describes the map on show in words: the caption below it, the picture's text alternative, and the announcement when
 * it is finished.
 */

import { count } from "../../../browser/count.ts";
import { setText } from "../../../browser/dom.ts";
import type { NameFacts, Phase, Summary } from "../../../engine/types.ts";
import type { State } from "../../../player/frame-loop.ts";
import { alternative, caption, sentence } from "../../../player/summary-text.ts";
import { isRiver } from "../look-inside/river-pointer.ts";
import { Announcer } from "../status.ts";

export interface MapWordsElements {
  caption: HTMLElement;
  canvas: HTMLElement;
  announcement: HTMLElement;
}

/** The number of the greatest rivers that the text alternative names. */
const TOLD_RIVERS = 3;

export class MapWords {
  readonly #announcer: Announcer;
  /** The caption's words about the country and its greatest river, once their names are known. */
  #greatest = "";

  /** Takes the elements; `elements.canvas` may be replaced later. */
  constructor(private readonly elements: MapWordsElements) {
    this.#announcer = new Announcer(elements.announcement);
  }

  /** Follows a change of the map or its state. */
  follow(seed: string, state: State, phase: Phase, summary: Summary): void {
    if (state !== "finished") this.#greatest = "";
    setText(this.elements.caption, caption(state, phase, summary) || this.#greatest);
    this.elements.caption.toggleAttribute("data-warns", Boolean(summary.stopped));
    this.elements.canvas.setAttribute("aria-label", alternative(seed, phase, summary, count));
    if (state === "finished") this.#announcer.say(`Finished: ${sentence(summary)}`);
    else this.#announcer.hush();
  }

  /**
   * Adds what there is to say of the country, and the greatest rivers, to the caption and the text alternative, once the
   * names on the finished map are known.
   */
  tell(country: readonly string[], names: readonly NameFacts[], seed: string, phase: Phase, summary: Summary): void {
    const rivers = names.filter(({ mark, name }) => isRiver(mark) && name !== "").slice(0, TOLD_RIVERS);
    if (rivers.length === 0) return;
    const sort = country.map((words) => words && `${words}. `).join("");
    this.#greatest = `${sort}Greatest river: ${rivers[0]?.name}`;
    if (!summary.stopped) setText(this.elements.caption, this.#greatest);
    const greatest = rivers.map(({ name }) => name).join(", ");
    const told = `${alternative(seed, phase, summary, count)} ${sort}Its greatest rivers: ${greatest}.`;
    this.elements.canvas.setAttribute("aria-label", told);
  }
}
