/** The control of a number: a slider for trying values, and a field for an exact value or, in front, the value written. */

import { el, setText, setValue } from "../browser/dom.ts";
import { AUTO } from "../engine/link-text.ts";
import { type Change, type Field, fieldId, helpId, type Shown } from "./field.ts";
import { LOG_STEPS, logStep, nearestText, position, type Range, share, spoken, textAt } from "./values.ts";
import { stepByWheel } from "./wheel.ts";

/** The change of a logarithmic slider by each key. */
const KEY_SHARE: Record<string, [direction: 1 | -1, share: number]> = {
  ArrowRight: [1, 0.02],
  ArrowUp: [1, 0.02],
  ArrowLeft: [-1, 0.02],
  ArrowDown: [-1, 0.02],
  PageUp: [1, 0.25],
  PageDown: [-1, 0.25],
};

/**
 * The change by one notch of the wheel: a share of the value on a logarithmic slider, or else a hundredth of the range;
 * at least one step.
 */
const WHEEL_SHARE = 0.02;
const WHEEL_NOTCHES = 100;

/** Parameters of which the least change gives a different tree. Their sliders have only `DETENTS` steps. */
const RESHAPING: ReadonlySet<string> = new Set(["reach", "kill", "step", "momentum", "curl", "stretch", "sensitivity"]);
const DETENTS = 20;

export function numberControl(parameter: Shown, range: Range, change: Change): Field {
  const slider = sliderFor(parameter, range);
  const aside = parameter.idSuffix === undefined ? exactAside(parameter, change) : writtenAside(parameter);
  const commit = (text: string) => change(parameter.key, text);
  let shown = parameter.default;

  slider.addEventListener("input", () => commit(textAt(slider.valueAsNumber, range)));
  if (range.isLog) slider.addEventListener("keydown", (event) => stepByKey(event, Number(shown), range, commit));
  stepByWheel(slider, (direction) => {
    commit(
      range.isLog
        ? logStep(Number(shown), direction, WHEEL_SHARE, range)
        : nearestText(Number(shown) + direction * wheelStep(range), range),
    );
  });

  return {
    element: slider,
    label: el("label", { for: slider.id }, parameter.label),
    aside: aside.element,
    ...(RESHAPING.has(parameter.key) ? { remark: "Each notch is another river." } : {}),
    show(text, automatic) {
      shown = automatic ?? text;
      aside.show(automatic === undefined ? text : AUTO);
      showOnSlider(slider, shown, range, parameter.unit);
      if (automatic !== undefined)
        slider.setAttribute("aria-valuetext", `automatic: ${spoken(automatic, parameter.unit)}`);
    },
    focus: () => slider.focus(),
  };
}

function sliderFor(parameter: Shown, range: Range): HTMLInputElement {
  const [min, max, finest] = range.isLog ? [0, LOG_STEPS, 1] : [range.min, range.max, range.step];
  const step = RESHAPING.has(parameter.key) ? Math.max(finest, (max - min) / DETENTS) : finest;
  return el("input", { type: "range", id: fieldId(parameter), min, max, step, "aria-describedby": helpId(parameter) });
}

/** The value beside a slider. */
interface Aside {
  element: HTMLElement;
  show(text: string): void;
}

/** Makes a field for the exact value. */
function exactAside({ key, label, unit }: Shown, change: Change): Aside {
  const exact = el("input", {
    type: "text",
    class: "exact",
    id: `exact-${key}`,
    inputmode: "decimal",
    autocomplete: "off",
    "aria-label": `${label}, exact value`,
  });
  exact.addEventListener("change", () => change(key, exact.value));
  const units = unit ? [el("span", { class: "unit" }, unit)] : [];
  return { element: el("span", { class: "value" }, exact, ...units), show: (text) => setValue(exact, text) };
}

/** Writes the value, hidden from screen readers, since the slider says it. */
function writtenAside({ unit }: Shown): Aside {
  const element = el("span", { class: "value word", "aria-hidden": "true" });
  return { element, show: (text) => setText(element, text === AUTO ? text : spoken(text, unit)) };
}

function showOnSlider(slider: HTMLInputElement, text: string, range: Range, unit: string | undefined): void {
  const value = Number(text);
  // A slider that already stands for this value stays under the finger, between two rounded values.
  if (textAt(slider.valueAsNumber, range) !== text) setValue(slider, String(position(value, range)));
  slider.style.setProperty("--share", String(share(value, range)));
  slider.setAttribute("aria-valuetext", spoken(text, unit));
}

function wheelStep({ min, max, step }: Range): number {
  return Math.max(step, (max - min) / WHEEL_NOTCHES);
}

/**
 * Moves a logarithmic slider by a key. The browser's step, a thousandth of the way, could round to the same value at
 * the low end.
 */
function stepByKey(event: KeyboardEvent, value: number, range: Range, commit: (text: string) => void): void {
  const step = KEY_SHARE[event.key];
  if (!step || event.altKey || event.ctrlKey || event.metaKey) return;
  event.preventDefault();
  commit(logStep(value, ...step, range));
}
