/**
 * Presets: named sets of values from the core. Pressing one sets its values and nothing else; all have the same keys.
 */

import { el } from "../browser/dom.ts";
import type { Parameter, Preset } from "../engine/table.ts";
import { inWords } from "./values.ts";

/** Returns whether the values on show are those of a preset. */
export function isShown({ values }: Preset, shown: ReadonlyMap<string, string>): boolean {
  return values.every(([key, value]) => shown.get(key) === value);
}

/**
 * Describes the values that a preset has changed and that are equal in all presets; returns nothing if there are none.
 * People press a preset for the differences between presets, and would not notice these changes.
 */
export function unaskedChanges(
  preset: Preset,
  all: readonly Preset[],
  table: readonly Parameter[],
  before: ReadonlyMap<string, string>,
): string | undefined {
  const [first, ...others] = all.map(({ values }) => new Map(values));
  const isCommon = (key: string) => others.every((values) => values.get(key) === first?.get(key));
  const after = new Map(preset.values);
  const changes = table.flatMap((parameter) => {
    const [was, is] = [before.get(parameter.key), after.get(parameter.key)];
    if (was === undefined || is === undefined || was === is || !isCommon(parameter.key)) return [];
    return `${parameter.label} from ${inWords(parameter, was)} to ${inWords(parameter, is)}`;
  });
  return changes.length === 0 ? undefined : `“${preset.label}” also changed ${changes.join(", ")}.`;
}

export interface Presets {
  readonly element: HTMLElement;
  show(values: ReadonlyMap<string, string>): void;
  /** Puts the focus on the preset that was pressed last. */
  focus(): void;
}

/** Attributes of the pictures: the size is in CSS pixels, and they are fetched when they are about to be seen. */
const PICTURE = { width: "108", height: "68", loading: "lazy", decoding: "async" };

/** A button for each of some presets. The one whose values are on show is pressed. */
export class PresetButtons {
  readonly element: HTMLElement;
  readonly #made: { preset: Preset; button: HTMLButtonElement }[];
  #last: HTMLButtonElement | undefined;

  /**
   * Makes the buttons. `pictureOf` returns the address of a preset's picture, if they have any. `first` is the number of
   * presets in sight before somebody asks for more.
   */
  constructor(
    name: string,
    all: readonly Preset[],
    choose: (preset: Preset) => void,
    pictureOf?: (preset: Preset) => string,
    first = all.length,
  ) {
    this.#made = all.map((preset, rank) => {
      const attributes = {
        type: "button",
        class: "preset",
        "aria-pressed": "false",
        title: preset.help,
        hidden: rank >= first,
      };
      const picture = pictureOf ? [el("img", { src: pictureOf(preset), alt: "", ...PICTURE })] : [];
      const button = el("button", attributes, ...picture, preset.label);
      button.addEventListener("click", () => {
        this.#last = button;
        choose(preset);
      });
      return { preset, button };
    });
    const buttons = el("div", { class: "preset-buttons" }, ...this.#made.map(({ button }) => button));
    if (first < all.length) buttons.append(this.#moreButton(name));
    this.element = el("div", { class: "presets", role: "group", "aria-label": name }, buttons);
  }

  /** Presses the button of the preset whose values are on show, and returns that preset. */
  show(shown: ReadonlyMap<string, string>): Preset | undefined {
    const current = this.#made.find(({ preset }) => isShown(preset, shown));
    for (const one of this.#made) one.button.setAttribute("aria-pressed", String(one === current));
    if (current) current.button.hidden = false;
    return current?.preset;
  }

  /** Makes the button that shows all presets, for good: whoever looks for one may look for another. */
  #moreButton(name: string): HTMLButtonElement {
    const more = el("button", { type: "button", class: "preset more-presets" }, `More ${name.toLowerCase()}`);
    more.addEventListener("click", () => {
      const hidden = this.#made.filter(({ button }) => button.hidden);
      for (const { button } of hidden) button.hidden = false;
      more.remove();
      hidden[0]?.button.focus();
    });
    return more;
  }

  /** Puts the focus on the button that was pressed last. */
  focus(): void {
    this.#last?.focus({ preventScroll: true });
  }
}

/** Makes the preset buttons of the panel, with the help text of the preset on show. */
export function presets(all: readonly Preset[], choose: (preset: Preset) => void): Presets {
  const buttons = new PresetButtons("Presets", all, choose);
  const help = el("p", { class: "help" });
  buttons.element.append(help);
  return {
    element: buttons.element,
    show(shown) {
      help.textContent =
        buttons.show(shown)?.help ??
        "Patterns of the river paper (space colonization): choose one, then change what you like.";
    },
    focus: () => buttons.focus(),
  };
}
