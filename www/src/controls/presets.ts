/**
 * Presets: named sets of values from the core. Pressing one sets its values and nothing else; all have the same keys.
 */

import { el } from "../browser/dom.ts";
import type { Parameter, Preset } from "../engine/table.ts";
import { Buttons } from "./buttons.ts";
import { inWords } from "./values.ts";

/** Returns presets that leave the country as it is, for a map that is there; in a link of its own a preset is of the usual country. */
export function onAnyCountry(all: readonly Preset[]): readonly Preset[] {
  return all.map((preset) => ({ ...preset, values: preset.values.filter(([key]) => key !== "country") }));
}

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

/** Makes the preset buttons of the panel, with the help text of the preset on show. */
export function presets(all: readonly Preset[], choose: (preset: Preset) => void): Presets {
  const buttons = new Buttons("Presets", all, choose);
  const help = el("p", { class: "help" });
  buttons.element.append(help);
  return {
    element: buttons.element,
    show(shown) {
      const current = all.find((preset) => isShown(preset, shown));
      buttons.press(current);
      help.textContent =
        current?.help ?? "Patterns of the river paper (space colonization): choose one, then change what you like.";
    },
    focus: () => buttons.focus(),
  };
}
