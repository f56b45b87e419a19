/**
 * The page “Real or grown?”: the user study of the river paper as a short game, in which one guesses for pieces of
 * rivers.
 */

import "./study.css";
import { el, find, setText } from "../../browser/dom.ts";
import { named } from "../../engine/errors.ts";
import { loadWhole } from "../../engine/whole.ts";
import { today } from "./daily.ts";
import { show } from "./drawing.ts";
import { type Game, Games, originOf, type Shown } from "./game.ts";
import { Passed } from "./passed.ts";
import { type Measured, measure } from "./piece.ts";
import { realPieces } from "./real.ts";
import { reviewOf } from "./review.ts";
import { count } from "./tally.ts";
import { toldOf } from "./told.ts";

const elements = {
  daily: find("#daily", HTMLButtonElement),
  ten: find("#ten", HTMLButtonElement),
  game: find("#game", HTMLElement),
  piece: find("#piece", SVGSVGElement),
  count: find("#count", HTMLElement),
  answers: find("#answers", HTMLElement),
  real: find("#real", HTMLButtonElement),
  grown: find("#grown", HTMLButtonElement),
  next: find("#next", HTMLButtonElement),
  verdict: find("#verdict", HTMLElement),
  end: find("#end", HTMLElement),
  passed: find("#passed", HTMLElement),
};

const storage = (): Storage => localStorage;

class Study {
  #game: Game;
  #shown: Shown | undefined;
  readonly #passed = new Passed(elements.passed, storage);

  constructor(
    private readonly games: Games,
    /** The measures of all real pieces. */
    private readonly nature: readonly Measured[],
  ) {
    this.#game = games.ofDay(today());
    elements.real.addEventListener("click", () => this.#answer("real"));
    elements.grown.addEventListener("click", () => this.#answer("grown"));
    elements.next.addEventListener("click", () => this.#goOn());
    elements.daily.addEventListener("click", () => void this.#begin(games.ofDay(today())));
    elements.ten.addEventListener("click", () => void this.#begin(games.byChance()));
    for (const button of [elements.daily, elements.ten]) button.disabled = false;
    void this.#begin(this.#game);
  }

  async #begin(game: Game): Promise<void> {
    this.#game = game;
    elements.daily.setAttribute("aria-pressed", String(game.date !== undefined));
    elements.ten.setAttribute("aria-pressed", String(game.date === undefined));
    setText(elements.verdict, "");
    if (this.#game.isOver) this.#finish();
    else await this.#ask();
  }

  /** Shows the piece of the next round, once it is made. */
  async #ask(): Promise<void> {
    const game = this.#game;
    const round = game.said.length;
    this.#shown = undefined;
    this.#show("waiting");
    setText(elements.count, `${round + 1} of ${game.rounds}`);
    try {
      const shown = await game.piece(round);
      // Another game may have begun meanwhile.
      if (this.#game !== game || game.said.length !== round) return;
      this.#shown = shown;
      show(shown.piece, elements.piece);
      this.#show("asking");
    } catch (thrown) {
      fail(thrown);
    }
  }

  #answer(said: Shown["is"]): void {
    const [game, shown] = [this.#game, this.#shown];
    if (!shown) return;
    game.say(said);
    count(originOf(shown), said === "real", storage);
    elements.verdict.replaceChildren(said === shown.is ? "Right: " : "No: ", ...toldOf(shown), ".");
    setText(elements.next, game.isOver ? "How it went" : "Next");
    this.#show("told");
    elements.next.focus();
    // While the reader looks, the next piece grows. If it cannot, that is said when it should be shown.
    if (!game.isOver) game.piece(game.said.length).catch(() => {});
  }

  #goOn(): void {
    setText(elements.verdict, "");
    if (this.#game.isOver) {
      this.#finish();
      elements.end.querySelector("h2")?.focus();
    } else void this.#ask().then(() => elements.real.focus());
  }

  #finish(): void {
    const more = el("button", { type: "button" }, this.#game.date === undefined ? "Ten more" : "Ten at random");
    more.addEventListener("click", () => void this.#begin(this.games.byChance()).then(() => elements.real.focus()));
    elements.end.replaceChildren(...reviewOf(this.#game, this.nature, fail), more);
    this.#passed.show();
    this.#show("over");
  }

  #show(state: "waiting" | "asking" | "told" | "over"): void {
    if (state !== "over") this.#passed.hide();
    elements.game.hidden = state === "over";
    elements.end.hidden = state !== "over";
    elements.answers.hidden = state === "told";
    elements.next.hidden = state !== "told";
    elements.piece.classList.toggle("waiting", state === "waiting");
    for (const button of [elements.real, elements.grown]) button.disabled = state !== "asking";
  }
}

function fail(thrown: unknown): void {
  const { code, message } = named(thrown);
  console.warn(`riverseed: ${code}: ${message}`);
  elements.game.hidden = false;
  setText(elements.count, "No rivers could be grown here. Please load the page again.");
}

async function begin(): Promise<void> {
  const [core, real] = await Promise.all([loadWhole(), realPieces()]);
  const nature = real.map(({ piece }) => measure(piece));
  new Study(new Games(core, real, storage), nature);
}

begin().catch(fail);
