/**
 * The page “Real or grown?”: the user study of the river paper as a short game, in which one guesses for pieces of
 * rivers.
 */

import "./study.css";
import { count } from "../../browser/count.ts";
import { el, find, setText } from "../../browser/dom.ts";
import { named } from "../../engine/errors.ts";
import { loadSteer, type SteerCore } from "../../engine/steer.ts";
import { type Grown, grownPiece } from "./grown.ts";
import { type Measured, measure, type Piece, SIDE } from "./piece.ts";
import { type Real, realPieces } from "./real.ts";
import { keepTally, tallyIn } from "./tally.ts";
import { tellTale } from "./tell-tale.ts";

const ROUNDS = 10;

const elements = {
  piece: find("#piece", HTMLCanvasElement),
  count: find("#count", HTMLElement),
  real: find("#real", HTMLButtonElement),
  grown: find("#grown", HTMLButtonElement),
  verdict: find("#verdict", HTMLElement),
  end: find("#end", HTMLElement),
};

type Shown = ({ is: "real" } & Real) | ({ is: "grown" } & Grown);

/** An answer for a piece. */
interface Answered {
  shown: Shown;
  isRight: boolean;
}

class Study {
  #answered: Answered[] = [];
  #shown: Shown | undefined;
  /** Real pieces that have not been shown yet. */
  readonly #left: Real[];
  readonly #nature: readonly Measured[];

  constructor(
    private readonly core: SteerCore,
    real: readonly Real[],
  ) {
    this.#left = [...real];
    this.#nature = real.map(({ piece }) => measure(piece));
    elements.real.addEventListener("click", () => this.#answer("real"));
    elements.grown.addEventListener("click", () => this.#answer("grown"));
  }

  async next(): Promise<void> {
    this.#enable(false);
    this.#shown = await this.#draw();
    show(this.#shown.piece);
    setText(elements.count, `${this.#answered.length + 1} of ${ROUNDS}`);
    this.#enable(true);
  }

  /** Draws a real or a grown piece with equal chances, whatever came before, so that counting does not help. */
  async #draw(): Promise<Shown> {
    if (chance(2) === 1) return { is: "grown", ...(await grownPiece(this.core, chance)) };
    const [one] = this.#left.splice(chance(this.#left.length), 1);
    return one ? { is: "real", ...one } : { is: "grown", ...(await grownPiece(this.core, chance)) };
  }

  #answer(said: Shown["is"]): void {
    const shown = this.#shown;
    if (!shown) return;
    this.#shown = undefined;
    this.#answered.push({ shown, isRight: said === shown.is });
    elements.verdict.replaceChildren(said === shown.is ? "Right: " : "No: ", ...toldOf(shown));
    if (this.#answered.length === ROUNDS) this.#finish();
    else this.next().catch(fail);
  }

  #enable(is: boolean): void {
    for (const button of [elements.real, elements.grown]) button.disabled = !is;
  }

  #finish(): void {
    this.#enable(false);
    const right = this.#answered.filter(({ isRight }) => isRight).length;
    const before = tallyIn(() => localStorage);
    const tally = { asked: before.asked + ROUNDS, right: before.right + right };
    keepTally(tally, () => localStorage);
    const again = el("button", { type: "button" }, "Ten more");
    again.addEventListener("click", () => this.#again());
    elements.end.replaceChildren(
      el("h2", {}, `${right} of ${ROUNDS} right`),
      el("p", {}, scoreOf(right)),
      ...this.#givenAway(),
      el("p", {}, `On this device, in all: ${count(tally.right)} of ${count(tally.asked)}. Guessing gives half.`),
      again,
    );
    elements.end.hidden = false;
    again.focus();
  }

  /** Lists the reasons by which grown pieces could be recognized. */
  #givenAway(): HTMLElement[] {
    const known = this.#answered.flatMap(({ shown, isRight }) => (shown.is === "grown" && isRight ? [shown] : []));
    if (known.length === 0) return [el("p", {}, "None of ours gave itself away.")];
    const line = ({ seed, piece }: Grown): HTMLElement => {
      const why = tellTale(measure(piece), this.#nature) ?? "nothing that we measure; your eye knows more";
      return el("li", {}, linkTo(seed), `: ${why}.`);
    };
    return [el("p", {}, "What gave ours away:"), el("ul", {}, ...known.map(line))];
  }

  #again(): void {
    this.#answered = [];
    elements.end.hidden = true;
    setText(elements.verdict, "");
    this.next().then(() => elements.real.focus(), fail);
  }
}

/** Returns a random whole number below `below`. All are equally likely, apart from a negligible bias. */
function chance(below: number): number {
  return Math.floor(((crypto.getRandomValues(new Uint32Array(1))[0] ?? 0) / 2 ** 32) * below);
}

function scoreOf(right: number): string {
  if (right >= 8) return "You know rivers: hardly anybody tells them apart so well.";
  return right >= 6 ? "Better than a coin." : "A coin would have done as well: take it as praise for the rivers.";
}

function toldOf(shown: Shown): (Node | string)[] {
  if (shown.is === "grown") return ["grown from ", linkTo(shown.seed), "."];
  const place = shown.river === "" ? "" : `, near the ${shown.river}`;
  return [`real${place}, ${count(shown.kilometresPerPixel * SIDE)} km across.`];
}

function linkTo(seed: string): HTMLElement {
  return el("a", { href: `./?seed=${encodeURIComponent(seed)}&style=atlas&labels=some` }, seed);
}

const RIVER = [238, 244, 240, 255];
const GROUND = [16, 28, 34, 255];

function show(piece: Piece): void {
  const context = elements.piece.getContext("2d");
  if (!context) return;
  const image = context.createImageData(SIDE, SIDE);
  for (const [at, is] of piece.entries()) image.data.set(is ? RIVER : GROUND, 4 * at);
  context.putImageData(image, 0, 0);
}

function fail(thrown: unknown): void {
  const { code, message } = named(thrown);
  console.warn(`riverseed: ${code}: ${message}`);
  setText(elements.count, "No rivers could be grown here. Please load the page again.");
}

async function begin(): Promise<void> {
  const [core, real] = await Promise.all([loadSteer(), realPieces()]);
  await new Study(core, real).next();
}

begin().catch(fail);
