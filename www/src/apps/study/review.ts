/** How a game went: its score, its line to paste, and its pieces once more with what they were. */

import { copy } from "../../browser/clipboard.ts";
import { el, setText, svg } from "../../browser/dom.ts";
import { resultLine } from "./daily.ts";
import { show } from "./drawing.ts";
import type { Game, Shown } from "./game.ts";
import { type Measured, measure } from "./piece.ts";
import { tellTale } from "./tell-tale.ts";
import { toldOf } from "./told.ts";

/** Returns the review of a game that is over. Its pieces are added as they come. */
export function reviewOf(game: Game, nature: readonly Measured[], fail: (thrown: unknown) => void): HTMLElement[] {
  const { isRight, rounds, date } = game;
  const right = isRight.filter(Boolean).length;
  const heading = el("h2", { tabindex: -1 }, `${inWords(right)} of ${inWords(rounds).toLowerCase()} right`);
  const pieces = el("ol", { class: "pieces" });
  addPieces(game, pieces, nature).catch(fail);
  return [
    heading,
    el("p", {}, scoreOf(right / rounds)),
    ...(date === undefined ? [] : pasteable(date, isRight)),
    pieces,
  ];
}

/** Writes a number up to ten: the page's serif has no digits. */
function inWords(number: number): string {
  return NUMBERS[number] ?? String(number);
}

const NUMBERS = "None One Two Three Four Five Six Seven Eight Nine Ten".split(" ");

function scoreOf(share: number): string {
  if (share >= 0.8) return "You know rivers: hardly anybody tells them apart so well.";
  return share >= 0.6 ? "Better than a coin." : "A coin would have done as well: take it as praise for the rivers.";
}

/** Returns the line of a day's result, with a button to copy it. */
function pasteable(date: string, isRight: readonly boolean[]): HTMLElement[] {
  const { origin, pathname } = location;
  const line = resultLine(date, isRight, origin + pathname);
  const text = el("p", { id: "line", class: "line" }, line);
  const button = el("button", { type: "button", "aria-describedby": "line" }, "Copy this line");
  const status = el("span", { role: "status" });
  button.addEventListener("click", async () => {
    const isCopied = await copy(line);
    if (!isCopied) getSelection()?.selectAllChildren(text);
    setText(
      status,
      isCopied ? "Copied." : "Your browser does not allow that. The line is selected, so you can copy it yourself.",
    );
  });
  const next = el("p", { class: "help" }, "The line gives no answers away. The next five come at midnight UTC.");
  return [text, el("div", { class: "copying" }, button, status), next];
}

async function addPieces(game: Game, list: HTMLElement, nature: readonly Measured[]): Promise<void> {
  for (const [round, said] of game.said.entries()) {
    const shown = await game.piece(round);
    const picture = svg("svg", { class: "piece", "aria-hidden": "true" });
    show(shown.piece, picture);
    const mark = el("strong", {}, shown.is === said ? "Right" : "No");
    list.append(el("li", {}, picture, el("p", {}, mark, ": ", ...toldOf(shown), ".", reasonOf(shown, said, nature))));
  }
}

/** Says what gave a grown piece away, if it did. */
function reasonOf(shown: Shown, said: Shown["is"], nature: readonly Measured[]): string {
  if (shown.is === "real" || said === "real") return "";
  const reason = tellTale(measure(shown.piece), nature) ?? "nothing that we measure; your eye knows more";
  return ` What gave it away: ${reason}.`;
}
