/** What the page says: the caption, the picture's text alternative, the announcement, notes and failures. */

import type { Phase, Summary } from "../pkg/riverseed.js";
import { el } from "./dom.ts";
import { advice, type PageError } from "./errors.ts";
import type { State } from "./growth.ts";
import { count } from "./values.ts";

function counted(value: number, one: string, many: string): string {
  return `${count(value)} ${value === 1 ? one : many}`;
}

function oxbowsOf(summary: Summary): string {
  return counted(summary.oxbows, "oxbow lake", "oxbow lakes");
}

/** The network's size in words. */
export function sizeOf(summary: Summary): string {
  const rivers = counted(summary.mouths, "river", "rivers");
  const sources = counted(summary.sources, "source", "sources");
  const oxbows = summary.oxbows === 0 ? "" : `, ${oxbowsOf(summary)}`;
  return `${rivers}, ${sources}, Strahler order ${count(summary.order)}${oxbows}`;
}

/** What the search left: how many nodes grew, how many attractors nothing reached, and why it ended early, if it did. */
export function remainderOf(summary: Summary): string {
  const nodes = counted(summary.nodes, "node", "nodes");
  // A Brownian tree has no attractors.
  const unreached =
    summary.attractors === 0
      ? ""
      : `; ${count(summary.unreached)} of ${counted(summary.attractors, "attractor", "attractors")} unreached`;
  const stopped = summary.stopped ? ` ${summary.stopped}` : "";
  return `${nodes}${unreached}.${stopped}`;
}

/** The sentence of the finished state. */
export function sentence(summary: Summary): string {
  return `${sizeOf(summary)}. ${remainderOf(summary)}`;
}

/** The text alternative of the picture; it has a size once it is finished. */
export function alternative(seed: string, phase: Phase, summary: Summary): string {
  return `River network grown from the seed “${seed}”: ${phase === "finished" ? sizeOf(summary) : `still ${doing(phase)}`}.`;
}

/** The step between growing and meandering is too short to be spoken of. */
function doing(phase: Phase): string {
  return phase === "meandering" ? "meandering" : "growing";
}

/** The two lines under the picture, in every state two, so that nothing jumps when growth ends. */
export function caption(state: State, phase: Phase, summary: Summary): [string, string] {
  if (state === "finished") return [sizeOf(summary), remainderOf(summary)];
  return [state === "paused" ? `Paused while ${doing(phase)}` : headed(doing(phase)), progressOf(phase, summary)];
}

function headed(word: string): string {
  return word.charAt(0).toUpperCase() + word.slice(1);
}

function progressOf(phase: Phase, summary: Summary): string {
  if (phase !== "meandering") return `${counted(summary.nodes, "node", "nodes")} so far`;
  const oxbows = summary.oxbows === 0 ? "" : `, ${oxbowsOf(summary)}`;
  return `${counted(summary.rounds, "round", "rounds")} so far${oxbows}`;
}

/** Dragging a slider finishes many rivers; only the one that is left standing is announced. */
const ANNOUNCE_AFTER_MS = 1000;

export class Announcer {
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly region: HTMLElement) {}

  say(text: string): void {
    this.hush();
    this.#timer = setTimeout(() => {
      this.region.textContent = text;
    }, ANNOUNCE_AFTER_MS);
  }

  /** Whatever was about to be said is out of date. */
  hush(): void {
    clearTimeout(this.#timer);
  }
}

/** Shows notes in a box, until they are dismissed. */
export function showNotices(box: HTMLElement, notices: readonly string[], dismiss: () => void): void {
  box.hidden = notices.length === 0;
  const list = el("ul", {}, ...notices.map((notice) => el("li", {}, notice)));
  const close = el("button", { type: "button", class: "dismiss" }, "Dismiss");
  close.addEventListener("click", dismiss);
  box.replaceChildren(...(notices.length > 0 ? [list, close] : []));
}

/** Shows a failure in the picture's place. The way out never carries the link along: it may be the cause. */
export function showFailure(box: HTMLElement, error: PageError): void {
  const { title, text, reload } = advice(error);
  const again = el("button", { type: "button" }, "Load again");
  again.addEventListener("click", () => location.reload());
  const fresh = el("a", { href: location.pathname }, "Start from a fresh river");
  const detail = el("p", { class: "detail" }, `${error.code}: ${error.message}`);
  box.replaceChildren(
    el("h2", {}, title),
    el("p", {}, text),
    el("p", { class: "actions" }, ...(reload ? [again] : []), fresh),
    detail,
  );
  box.hidden = false;
}
