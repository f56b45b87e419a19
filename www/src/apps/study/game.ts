/** A game: some pieces, one after the other, and what is said of them. */

import { chance, oneOf } from "../../browser/chance.ts";
import type { WholeCore } from "../../engine/whole.ts";
import { type Dealt, dealOf, type Is, keepSaid, saidOn } from "./daily.ts";
import { type Grown, grownPiece } from "./grown.ts";
import { lengthOf } from "./piece.ts";
import type { Real } from "./real.ts";
import { RECIPE_NAMES } from "./recipes.ts";
import type { Origin } from "./tally.ts";

export type Shown = ({ is: "real" } & Real) | ({ is: "grown" } & Grown);

/** The number of pieces of a game that is not of a day. */
const TEN = 10;

export class Game {
  readonly #drawn: Promise<Shown>[] = [];

  constructor(
    /** The date, of a game of a day. */
    readonly date: string | undefined,
    private readonly deal: readonly Dealt[],
    private readonly draw: (dealt: Dealt) => Promise<Shown>,
    private readonly answers: Is[],
    private readonly keep: (said: readonly Is[]) => void,
  ) {}

  get rounds(): number {
    return this.deal.length;
  }

  /** What has been said so far. */
  get said(): readonly Is[] {
    return this.answers;
  }

  get isOver(): boolean {
    return this.said.length === this.rounds;
  }

  /** Whether what was said is right, round by round. */
  get isRight(): boolean[] {
    return this.said.map((said, i) => this.deal[i]?.is === said);
  }

  say(said: Is): void {
    this.answers.push(said);
    this.keep(this.said);
  }

  /** Returns the piece of a round, which is made on the first call. */
  piece(round: number): Promise<Shown> {
    const dealt = this.deal[round];
    if (!dealt) throw new Error(`a game has no round ${round}`);
    this.#drawn[round] ??= this.draw(dealt);
    return this.#drawn[round];
  }
}

/** Makes games of the real pieces and of what the engine grows. */
export class Games {
  readonly #lengths: readonly number[];
  /** The places of real pieces that have not been shown yet. */
  #left: number[] = [];
  #ofDay: Game | undefined;

  constructor(
    private readonly core: WholeCore,
    private readonly real: readonly Real[],
    private readonly storage: () => Storage,
  ) {
    this.#lengths = real.map(({ piece }) => lengthOf(piece));
  }

  /** Returns the game of a date, as far as it has been played. */
  ofDay(date: string): Game {
    if (this.#ofDay?.date !== date) this.#ofDay = this.#begun(date);
    return this.#ofDay;
  }

  #begun(date: string): Game {
    const keep = (said: readonly Is[]): void => keepSaid(date, said, this.storage);
    const said = saidOn(date, this.storage);
    return new Game(date, dealOf(date, this.#lengths), (dealt) => this.#draw(dealt), said, keep);
  }

  /** Returns a game by chance: each piece is real or grown with equal chances, so that counting does not help. */
  byChance(): Game {
    const deal = Array.from({ length: TEN }, (): Dealt => {
      if (chance(2) === 1) return { is: "real", place: this.#take() };
      const length = this.#lengths[chance(this.#lengths.length)] ?? 0;
      return {
        is: "grown",
        order: { by: oneOf(RECIPE_NAMES, chance), length, seedOf: this.core.engine.freshSeed, chance },
      };
    });
    return new Game(
      undefined,
      deal,
      (dealt) => this.#draw(dealt),
      [],
      () => {},
    );
  }

  /** Takes a real piece that has not been shown while there are any. */
  #take(): number {
    if (this.#left.length === 0) this.#left = [...this.real.keys()];
    return this.#left.splice(chance(this.#left.length), 1)[0] ?? 0;
  }

  async #draw(dealt: Dealt): Promise<Shown> {
    if (dealt.is === "grown") return { is: "grown", ...(await grownPiece(this.core, dealt.order)) };
    const real = this.real[dealt.place];
    if (!real) throw new Error(`there is no real piece ${dealt.place}`);
    return { is: "real", ...real };
  }
}

export function originOf(shown: Shown): Origin {
  return shown.is === "real" ? "real" : shown.by;
}
