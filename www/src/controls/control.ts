/** A control for one row of the parameter table: its label, the value, the help text and a reset button. */

import { el, setText, setValue } from "../browser/dom.ts";
import { AUTO } from "../engine/link-text.ts";
import type { Parameter } from "../engine/table.ts";
import { Choice } from "./choice.ts";
import { type Change, type Field, fieldId, helpId, type Shown } from "./field.ts";
import { numberControl } from "./number.ts";
import { rangeOf, sidesOf, sidesText } from "./values.ts";

export interface Control {
  readonly element: HTMLElement;
  /**
   * Shows what a link says and what it says by default. With `idle`, the reason why it has no effect, the control is
   * disabled. `automatic` is the value that the text stands for, if it is decided elsewhere.
   */
  show(text: string, fallback: string, idle: string | undefined, automatic?: string): void;
}

/**
 * Makes a control that stands in front, under a label in everyday words. A number has another under *All settings*, with
 * a field for the exact value.
 */
export function frontControl(parameter: Parameter, label: string, change: Change): Control {
  const isNumber = rangeOf(parameter) !== undefined;
  return control({ ...parameter, label, ...(isNumber ? { idSuffix: `front-${parameter.key}` } : {}) }, change);
}

export function control(parameter: Shown, change: Change): Control {
  const field = fieldFor(parameter, change);
  const reset = new ResetButton(parameter, (fallback) => {
    change(parameter.key, fallback);
    field.focus();
  });
  const help = el("p", { class: "help", id: helpId(parameter) }, parameter.help);
  const head = el("div", { class: "control-head" }, field.label, reset.element, ...(field.aside ? [field.aside] : []));
  // A fieldset can be disabled with all its contents; its role keeps it from being a group to a screen reader.
  const element = el("fieldset", {
    role: "none",
    class: `control control-${parameter.kind}`,
    ...(parameter.idSuffix === undefined ? { "data-key": parameter.key } : { "data-front": parameter.key }),
    title: parameter.help,
  });
  field.element.classList.add("field");
  const remark = field.remark === undefined ? [] : [el("p", { class: "remark" }, field.remark)];
  element.append(head, field.element, ...remark, help);
  return {
    element,
    show(text, fallback, idle, automatic) {
      element.disabled = idle !== undefined;
      setText(help, idle === undefined ? parameter.help : `No effect: ${idle}.`);
      reset.show(fallback, text !== fallback && idle === undefined);
      field.show(text, automatic);
    },
  };
}

function fieldFor(parameter: Shown, change: Change): Field {
  const range = rangeOf(parameter);
  if (range) return numberControl(parameter, range, change);
  if (parameter.kind === "choice") return choiceControl(parameter, change);
  if (parameter.kind === "sides") return sidesControl(parameter, change);
  return textControl(parameter, change);
}

/** The button that resets a value to its default, which may differ on dark pages. */
class ResetButton {
  readonly element: HTMLButtonElement;
  #fallback = "";

  constructor(
    private readonly parameter: Parameter,
    reset: (fallback: string) => void,
  ) {
    this.element = el("button", { type: "button", class: "reset", "data-reset": parameter.key }, "reset");
    this.element.addEventListener("click", () => reset(this.#fallback));
  }

  show(fallback: string, isNeeded: boolean): void {
    this.#fallback = fallback;
    this.element.hidden = !isNeeded;
    this.element.title = `Reset ${this.parameter.label} to ${fallback}`;
    this.element.setAttribute("aria-label", this.element.title);
  }
}

function choiceControl(parameter: Parameter, change: Change): Field {
  const element = el("select", { id: fieldId(parameter), "aria-describedby": helpId(parameter) });
  const choice = new Choice(element, parameter, (value) => change(parameter.key, value));
  return {
    element,
    label: el("label", { for: fieldId(parameter) }, parameter.label),
    show: (text, automatic) => choice.show(text, automatic),
    focus: () => element.focus(),
  };
}

function textControl(parameter: Parameter, change: Change): Field {
  const attributes = { type: "text", id: fieldId(parameter), "aria-describedby": helpId(parameter) };
  const element = el("input", attributes);
  if (parameter.maxLength !== undefined) element.maxLength = parameter.maxLength;
  element.addEventListener("change", () => change(parameter.key, element.value));
  return {
    element,
    label: el("label", { for: fieldId(parameter) }, parameter.label),
    show: (text) => setValue(element, text),
    focus: () => element.focus(),
  };
}

function sidesControl(parameter: Parameter, change: Change): Field {
  const boxes = (parameter.choices ?? []).map(({ value, label }) => side(value, label));
  const auto = side(AUTO, AUTO);
  const label = el("span", { id: fieldId(parameter) }, parameter.label);
  const attributes = {
    class: "sides",
    role: "group",
    "aria-labelledby": label.id,
    "aria-describedby": helpId(parameter),
  };
  const all = [...boxes, ...(parameter.decided ? [auto] : [])];
  const element = el("div", attributes, ...all.map((one) => one.element));
  element.addEventListener("change", ({ target }) => {
    const chosen = new Set(boxes.filter(({ box }) => box.checked).map(({ box }) => box.value));
    if (target === auto.box && auto.box.checked) change(parameter.key, AUTO);
    // The rivers must end somewhere, so the last side cannot be unchecked.
    else if (chosen.size === 0 && target instanceof HTMLInputElement) target.checked = true;
    else change(parameter.key, sidesText(chosen, parameter));
  });
  return {
    element,
    label,
    show(text, automatic) {
      const sides = sidesOf(automatic ?? text);
      for (const { box } of boxes) box.checked = sides.includes(box.value);
      auto.box.checked = automatic !== undefined;
    },
    focus: () => boxes[0]?.box.focus(),
  };
}

function side(value: string, label: string): { box: HTMLInputElement; element: HTMLElement } {
  const box = el("input", { type: "checkbox", value });
  return { box, element: el("label", { class: "side" }, box, label) };
}
