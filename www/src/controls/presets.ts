/** The presets: named sets of values, from the core. Pressing one sets what it names and nothing else; all name the same keys. */

import { el } from "../browser/dom.ts";
import type { Parameter, Preset } from "../engine/full.ts";
import { inWords } from "./values.ts";

/** Whether the values on show are this preset's. */
export function isShown({ values }: Preset, shown: ReadonlyMap<string, string>): boolean {
  return values.every(([key, value]) => shown.get(key) === value);
}

/**
 * What pressing a preset changes although all presets have it in common, in words: people press one for what tells the presets
 * from each other, and would miss the rest. Nothing if there is no such change.
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

/** In CSS pixels. Fetched when they are about to be seen. */
const PICTURE = { width: "108", height: "68", loading: "lazy", decoding: "async" };

/** A button for each of some presets, of which one is pressed, if any is shown. */
export class PresetButtons {
  readonly element: HTMLElement;
  readonly #made: { preset: Preset; button: HTMLButtonElement }[];
  #last: HTMLButtonElement | undefined;

  /** With the address of a picture, if there is one of each. */
  constructor(
    name: string,
    all: readonly Preset[],
    choose: (preset: Preset) => void,
    pictureOf?: (preset: Preset) => string,
  ) {
    this.#made = all.map((preset) => {
      const attributes = { type: "button", class: "preset", "aria-pressed": "false", title: preset.help };
      const picture = pictureOf ? [el("img", { src: pictureOf(preset), alt: "", ...PICTURE })] : [];
      const button = el("button", attributes, ...picture, preset.label);
      button.addEventListener("click", () => {
        this.#last = button;
        choose(preset);
      });
      return { preset, button };
    });
    const buttons = el("div", { class: "preset-buttons" }, ...this.#made.map(({ button }) => button));
    this.element = el("div", { class: "presets", role: "group", "aria-label": name }, buttons);
  }

  /** Shows which of them the values on show are. */
  show(shown: ReadonlyMap<string, string>): Preset | undefined {
    const current = this.#made.find(({ preset }) => isShown(preset, shown));
    for (const one of this.#made) one.button.setAttribute("aria-pressed", String(one === current));
    return current?.preset;
  }

  /** Puts the focus on the one that was pressed last. */
  focus(): void {
    this.#last?.focus({ preventScroll: true });
  }
}

/** The presets of links, with what the one on show is for. */
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
