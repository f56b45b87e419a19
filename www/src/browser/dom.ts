/** Makes elements. Text always becomes text nodes and is never parsed as HTML: seeds and links are hostile. */

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

/** Makes an icon of 16 by 16 in the colour of the text, hidden from screen readers: words nearby say the same. */
export function icon(path: string): SVGElement {
  const attributes = { class: "icon icon-stroke", viewBox: "0 0 16 16", "aria-hidden": "true" };
  return svg("svg", attributes, svg("path", { d: path }));
}

/** Makes an empty drawing over the map, in units of the map, which is hidden at first. */
export function mapLayer(name: string): SVGSVGElement {
  const attributes = { class: `map-layer ${name}`, "aria-hidden": "true", preserveAspectRatio: "none", hidden: "" };
  return svg("svg", attributes);
}

/** Finds an element of the page's HTML. Throws if there is none. */
export function find<Type extends Element>(selector: string, type: new () => Type): Type {
  const element = document.querySelector(selector);
  if (element instanceof type) return element;
  throw new Error(`the page has no ${selector}`);
}

/** Sets a field's value if it differs: setting it again would move the caret of the person typing. */
export function setValue(field: HTMLInputElement | HTMLSelectElement, value: string): void {
  if (field.value !== value) field.value = value;
}

/** Sets an element's text if it differs, so that the browser need not lay out the same text again. */
export function setText(element: Element | undefined, text: string): void {
  if (element && element.textContent !== text) element.textContent = text;
}
