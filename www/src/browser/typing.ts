/**
 * Tells letters that stand for an action from letters of a sentence that somebody types where nothing takes text. A
 * letter acts once nothing else has been typed for half a second, so that of a sentence not even the first one acts.
 * Other characters act at once, unless a letter came just before them. A letter that has acted acts at once the next
 * time, as long as no other came between: somebody who throws the dice again and again does not wait.
 */

/** Most people type a sentence faster than this from key to key. */
export const TYPING_MS = 500;

/** The part that a key plays: it acts now, is held back, or belongs to a sentence. */
export type Verdict = "acts" | "held" | "typed";

export class Typing<Press> {
  #held: { letter: string; presses: Press[] } | undefined;
  #isTyping = false;
  /** The letter that acted last, if nothing else came after it. */
  #known: string | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly act: (press: Press) => void) {}

  /** True if a letter came a moment ago. */
  get isGoingOn(): boolean {
    return this.#timer !== undefined;
  }

  /** Judges a character. One that is held back acts later, by `act`, unless another follows it. */
  judge(character: string, press: Press): Verdict {
    const letter = character.toLowerCase();
    const isLetter = /^\p{L}$/u.test(letter);
    if (this.#timer === undefined) {
      if (!isLetter || letter === this.#known) return "acts";
      this.#held = { letter, presses: [press] };
      this.#known = undefined;
    } else if (this.#held?.letter === letter) this.#held.presses.push(press);
    else this.#isTyping = true;
    this.#waitAgain();
    return this.#isTyping ? "typed" : "held";
  }

  #waitAgain(): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#rest(), TYPING_MS);
  }

  /** Ends the typing of a word, when no letter has come for a while, and acts on the presses held back. */
  #rest(): void {
    const held = this.#isTyping ? undefined : this.#held;
    this.#timer = this.#held = undefined;
    this.#isTyping = false;
    this.#known = held?.letter;
    for (const press of held?.presses ?? []) this.act(press);
  }
}
