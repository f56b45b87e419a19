/** Countries to begin with: named sets of values, from the core. */

import { el } from "../browser/dom.ts";
import type { Preset } from "../engine/full.ts";
import { isShown } from "./presets.ts";

export interface Countries {
  readonly element: HTMLElement;
  show(values: ReadonlyMap<string, string>): void;
}

export function countries(all: readonly Preset[], choose: (country: Preset) => void): Countries {
  const made = all.map((country) => {
    const attributes = { type: "button", class: "preset", "aria-pressed": "false", title: country.help };
    const button = el("button", attributes, country.label);
    button.addEventListener("click", () => choose(country));
    return { country, button };
  });
  const element = el("div", { class: "presets", role: "group", "aria-label": "Countries" });
  element.append(el("div", { class: "preset-buttons" }, ...made.map(({ button }) => button)));
  return {
    element,
    show(shown) {
      for (const { country, button } of made) button.setAttribute("aria-pressed", String(isShown(country, shown)));
    },
  };
}
