/** The table of how often real and grown pieces passed for real, on this device. */

import { count } from "../../browser/count.ts";
import { el } from "../../browser/dom.ts";
import { type Counted, forget, ORIGINS, type Origin, tallyIn, totalOf } from "./tally.ts";
import { nameOf } from "./told.ts";

export class Passed {
  constructor(
    /** The place of the table. */
    private readonly section: HTMLElement,
    private readonly storage: () => Storage,
  ) {}

  hide(): void {
    this.section.hidden = true;
  }

  /** Shows the table if anything has been counted. */
  show(): void {
    const tally = tallyIn(this.storage);
    const { asked, right } = totalOf(tally);
    this.section.hidden = asked === 0;
    const forgetting = el("button", { type: "button", class: "quiet" }, "Reset these counts");
    forgetting.addEventListener("click", () => {
      forget(this.storage);
      this.show();
    });
    this.section.replaceChildren(
      el("h2", {}, "What passed for real"),
      el(
        "table",
        {},
        el("caption", {}, `Your answers so far: ${count(right)} of ${count(asked)} right. Guessing gives half.`),
        el("thead", {}, rowOf(["Pieces", "Taken for real"].map((head) => el("th", { scope: "col" }, head)))),
        el("tbody", {}, ...ORIGINS.map((origin) => counted(origin, tally[origin]))),
      ),
      forgetting,
    );
  }
}

function counted(origin: Origin, { shown, passed }: Counted): HTMLElement {
  const share = shown === 0 ? 0 : passed / shown;
  const bar = el("span", { class: "bar", "aria-hidden": "true" });
  bar.style.setProperty("--share", String(share));
  const doubted = origin === "real" ? `, ${count(shown - passed)} doubted` : "";
  const told = shown === 0 ? ["not shown yet"] : [bar, `${count(passed)} of ${count(shown)}${doubted}`];
  return rowOf([el("th", { scope: "row" }, nameOf(origin)), el("td", {}, ...told)]);
}

function rowOf(cells: readonly Node[]): HTMLElement {
  return el("tr", {}, ...cells);
}
