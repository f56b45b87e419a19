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

export function svg<Tag extends keyof SVGElementTagNameMap>(
  tag: Tag,
  attributes: Record<string, string | number> = {},
  ...children: Node[]
): SVGElementTagNameMap[Tag] {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}

/** A drawing of 16 by 16 in the colour of the text, beside or in place of words that say the same. */
export function icon(path: string): SVGElement {
  const attributes = { class: "icon icon-stroke", viewBox: "0 0 16 16", "aria-hidden": "true" };
  return svg("svg", attributes, svg("path", { d: path }));
}

/** An empty drawing over the map, in units of the map; not seen before it is shown. */
export function mapLayer(name: string): SVGSVGElement {
  const attributes = { class: `map-layer ${name}`, "aria-hidden": "true", preserveAspectRatio: "none", hidden: "" };
  return svg("svg", attributes);
}

/** An element that the page's HTML has. */
export function find<Type extends Element>(selector: string, type: new () => Type): Type {
  const element = document.querySelector(selector);
  if (element instanceof type) return element;
  throw new Error(`the page has no ${selector}`);
}

/** Sets what differs: a value that is set again moves the caret of the person typing. */
export function setValue(field: HTMLInputElement | HTMLSelectElement, value: string): void {
  if (field.value !== value) field.value = value;
}

/** Sets text that differs, once a frame at most: the browser need not lay out again what says the same. */
export function setText(element: Element | undefined, text: string): void {
  if (element && element.textContent !== text) element.textContent = text;
}
