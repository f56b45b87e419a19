/** Controls under a heading that fold away. The heading always shows how many of them differ from their default. */

import { el, setText } from "../browser/dom.ts";
import type { Parameter } from "../engine/table.ts";
import type { Control } from "./control.ts";
import type { Disclosures } from "./disclosure.ts";

/** Parameters that are seldom wanted: they are under “More” at the end of their group. */
const RARE = new Set(["flat-share", "neck", "oxbows", "clearance", "taper"]);

export interface Group {
  readonly element: HTMLElement;
  show(values: ReadonlyMap<string, string>, defaults: ReadonlyMap<string, string>): void;
}

export function group(
  heading: string,
  parameters: readonly Parameter[],
  made: ReadonlyMap<string, Control>,
  disclosures: Disclosures,
  padlock: HTMLElement,
): Group {
  const changed = el("span", { class: "changed" });
  const summary = el("summary", {}, el("h2", {}, heading), " ", changed);
  const controlsOf = (some: readonly Parameter[]): HTMLElement[] =>
    some.flatMap(({ key }) => made.get(key)?.element ?? []);
  const [rare, usual] = [true, false].map((is) => controlsOf(parameters.filter(({ key }) => RARE.has(key) === is)));
  const members = el("div", { class: "members" }, ...(usual ?? []));
  if (rare && rare.length > 0) members.append(more(heading, rare, disclosures));
  const details = disclosures.details(heading, false, { class: "group" }, summary, members);
  return {
    // Beside the heading, not in it, since the heading itself works as a button.
    element: el("div", { class: "group-place" }, padlock, details),
    show(values, defaults) {
      const count = parameters.filter(({ key }) => values.get(key) !== defaults.get(key)).length;
      setText(changed, count === 0 ? "" : `${count} changed`);
    },
  };
}

function more(heading: string, rare: HTMLElement[], disclosures: Disclosures): HTMLElement {
  const summary = el("summary", {}, "More", el("span", { class: "unseen" }, ` of ${heading}`));
  return disclosures.details(
    `${heading}, more`,
    false,
    { class: "more" },
    summary,
    el("div", { class: "members" }, ...rare),
  );
}
