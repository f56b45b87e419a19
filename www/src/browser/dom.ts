/** Making elements. Text always becomes text nodes: seeds and links are hostile, nothing here can read HTML. */

type Attributes = Record<string, string | number | boolean>;

export function el<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== false) element.setAttribute(name, value === true ? "" : String(value));
  }
  element.append(...children);
  return element;
}

const SVG = "http://www.w3.org/2000/svg";

/** A drawing of 16 by 16 in the colour of the text, beside or in place of words that say the same. */
export function icon(path: string): SVGElement {
  const element = document.createElementNS(SVG, "svg");
  element.setAttribute("class", "icon icon-stroke");
  element.setAttribute("viewBox", "0 0 16 16");
  element.setAttribute("aria-hidden", "true");
  const line = document.createElementNS(SVG, "path");
  line.setAttribute("d", path);
  element.append(line);
  return element;
}

/** An element that index.html promises. */
export function find<Type extends Element>(selector: string, type: new () => Type): Type {
  const element = document.querySelector(selector);
  if (element instanceof type) return element;
  throw new Error(`index.html has no ${selector}`);
}

/** Sets what differs: a value that is set again moves the caret of the person typing. */
export function setValue(field: HTMLInputElement | HTMLSelectElement, value: string): void {
  if (field.value !== value) field.value = value;
}

/** Sets text that differs, once a frame at most: the browser need not lay out again what says the same. */
export function setText(element: Element | undefined, text: string): void {
  if (element && element.textContent !== text) element.textContent = text;
}
