/** Controls under a heading that fold away. The heading shows how many of those in sight differ from their default. */

import { el, setText } from "../browser/dom.ts";
import type { Parameter } from "../engine/table.ts";
import type { Control } from "./control.ts";
import type { Disclosures } from "./disclosure.ts";

/** Parameters that are seldom wanted: they are under “More” at the end of their group. */
const RARE = new Set(["flat-share", "neck", "oxbows", "clearance", "taper"]);

export interface Group {
  readonly element: HTMLElement;
  /** Takes what the link says of all values, before `hide` is called. */
  show(asked: ReadonlyMap<string, string>, defaults: ReadonlyMap<string, string>): void;
  /** Hides the controls of some parameters, and headings with nothing under them. The rest is counted. */
  hide(hidden: ReadonlySet<string>): void;
}

export function group(
  heading: string,
  parameters: readonly Parameter[],
  made: ReadonlyMap<string, Control>,
  disclosures: Disclosures,
): Group {
  const changed = el("span", { class: "changed" });
  const summary = el("summary", {}, el("h2", {}, heading), " ", changed);
  const [rare = [], usual = []] = [true, false].map((is) => parameters.filter(({ key }) => RARE.has(key) === is));
  const elementsOf = (some: readonly Parameter[]): HTMLElement[] =>
    some.flatMap(({ key }) => made.get(key)?.element ?? []);
  const members = el("div", { class: "members" }, ...elementsOf(usual));
  const fold = rare.length > 0 ? more(heading, elementsOf(rare), disclosures) : undefined;
  if (fold) members.append(fold);
  const element = disclosures.details(heading, false, { class: "group" }, summary, members);
  let differing: readonly string[] = [];
  return {
    element,
    show(asked, defaults) {
      differing = parameters.map(({ key }) => key).filter((key) => asked.get(key) !== defaults.get(key));
    },
    hide(hidden) {
      const count = differing.filter((key) => !hidden.has(key)).length;
      setText(changed, count === 0 ? "" : `${count} changed`);
      const areHidden = (some: readonly Parameter[]): boolean => some.every(({ key }) => hidden.has(key));
      for (const { key } of parameters) {
        const control = made.get(key)?.element;
        if (control) control.hidden = hidden.has(key);
      }
      element.hidden = areHidden(parameters);
      if (fold) fold.hidden = areHidden(rare);
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
