/**
 * The line that meets whoever comes by a link: whose country this is, with a box for a word of their own. It goes for
 * good once it is hidden or somebody has made a country in this tab.
 */

import { linkOf } from "../../browser/address.ts";
import { setText } from "../../browser/dom.ts";
import type { Keeper } from "../../controls/disclosure.ts";
import { invitation } from "./share/invitation.ts";

export interface WelcomeElements {
  form: HTMLFormElement;
  line: HTMLElement;
  word: HTMLInputElement;
  hide: HTMLButtonElement;
}

/** How a visit began. */
export interface Arrival {
  address: Pick<Location, "origin" | "pathname" | "search" | "hash">;
  /** The address of the page that the visitor came from; empty if it is not known. */
  referrer: string;
  /** True if the page shows something else first: six maps side by side. */
  isElsewhere: boolean;
}

/** Kept for the tab once its visitor needs no welcome. */
const KEPT_AS = "riverseed-welcomed";

/** Returns whether a visit is met by the line: by a link, and not from the gallery. */
export function isMet(arrival: Arrival, keeper: () => Keeper): boolean {
  return isLinked(arrival) && !isFromHere(arrival) && !arrival.isElsewhere && !isWelcomed(keeper);
}

function isLinked({ address }: Arrival): boolean {
  return linkOf(address) !== "";
}

/** Returns whether the visitor came from another page of this site. A page that loads itself again names itself. */
function isFromHere({ address, referrer }: Arrival): boolean {
  if (referrer === "") return false;
  const { origin, pathname } = new URL(referrer);
  return origin === address.origin && pathname !== address.pathname;
}

export class Welcome {
  #isMet: boolean;
  #invitation = "";

  constructor(
    private readonly elements: WelcomeElements,
    arrival: Arrival,
    private readonly keeper: () => Keeper,
    grow: (word: string) => void,
  ) {
    const { form, word, hide } = elements;
    this.#isMet = isMet(arrival, keeper);
    // A link that this tab has made itself is loaded again.
    if (!isLinked(arrival)) this.#keep();
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      const typed = word.value.trim();
      if (typed === "") word.focus();
      else grow(typed);
    });
    hide.addEventListener("click", () => this.leave());
  }

  /** Takes the name of the country, and says it if the visitor has been met. */
  show(name: string, seed: string): void {
    this.#invitation = invitation(name, seed);
    if (!this.elements.form.hidden) setText(this.elements.line, this.#invitation);
  }

  /**
   * Meets the visitor, who has seen the country by now: before that, nothing should lie over it or move. A country without a
   * sea has no room for the line: it would hide rivers.
   */
  meet(land: string | undefined): void {
    if (!this.#isMet || land === "rectangle") return;
    this.elements.form.hidden = false;
    setText(this.elements.line, this.#invitation);
  }

  /** Goes for good. */
  leave(): void {
    this.#isMet = false;
    this.elements.form.hidden = true;
    this.#keep();
  }

  #keep(): void {
    try {
      this.keeper().setItem(KEPT_AS, "yes");
    } catch {
      // Then it comes back with the next link.
    }
  }
}

/** Says whether a visitor has been welcomed before; false if storage is refused. */
function isWelcomed(keeper: () => Keeper): boolean {
  try {
    return keeper().getItem(KEPT_AS) !== null;
  } catch {
    return false;
  }
}
