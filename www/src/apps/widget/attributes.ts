/** The element's attributes and the properties that mirror them. */

import { addressOf } from "../../browser/address.ts";
import { attributeOf, NUMBERS, TEXTS } from "../../engine/attribute-names.ts";
import { linkText } from "../../engine/link-text.ts";
import { type Init, linkToRead } from "./protocol.ts";
import { isDark } from "./theme.ts";

/** Attributes about the element's behaviour, which are not part of the recipe. */
const BEHAVIOUR = ["recipe", "letters", "loading", "theme", "alt", "maker", "wasm-url"] as const;

/** Boolean attributes. */
const FLAGS = ["still", "controls"] as const;

/** The range and the default of the aspect. The box has its shape before the engine is loaded. */
export const ASPECT = { min: 0.25, max: 4, default: 1.6 };

/** The range and the default of the speed: those of the page's slider, without its last stop, which `still` stands for. */
export const SPEED = { min: 0.25, max: 8, default: 1 };

export const OBSERVED = [
  ...[...NUMBERS, ...TEXTS].map(attributeOf),
  ...BEHAVIOUR,
  ...FLAGS,
  "speed",
  "aria-label",
  "lang",
];

/** Returns the link that an element asks for, as far as it can be told before the core has read it. */
export function linkOf(element: Element): string {
  const link = new URLSearchParams(recipeOf(element));
  for (const [key, text] of valuesOf(element)) link.set(key, text);
  return linkText(link);
}

/** Returns what an author gave as a whole recipe: the core makes a link of it. */
function recipeOf(element: Element): string {
  return element.getAttribute("recipe") ?? "";
}

/** Returns the values that attributes give. They take precedence over the recipe. */
function valuesOf(element: Element): [key: string, text: string][] {
  return [...NUMBERS, ...TEXTS].flatMap((key): [string, string][] => {
    const text = element.getAttribute(attributeOf(key));
    return text === null ? [] : [[key, text]];
  });
}

/** A part of what is link text for certain, as the core writes it: values of few signs, and those of words encoded. */
const LINK_PART = /^(?:(?:seed|names)=[\w.*+%-]*|[a-z-]+=[\w.*-]*)$/;

/**
 * Returns whether a recipe may be an address, a word or a damaged link, or a seed an address: then only the larger engines
 * understand it.
 */
function needsReader(recipe: string, seed: string | null): boolean {
  const isLink = recipe === "" || recipe.split("&").every((part) => LINK_PART.test(part));
  // A full stop, or emphasis of Markdown, may have come from the text around.
  return !isLink || /[._*]$/.test(recipe) || /[?#]/.test(seed ?? "");
}

/** Returns the link that an element asks for on a page of these colours. */
export function linkToReadOf(element: Element) {
  const letters = element.getAttribute("letters") ?? "";
  const recipe = recipeOf(element);
  if (!needsReader(recipe, element.getAttribute("seed"))) return linkToRead(linkOf(element), isDark(element), letters);
  return linkToRead(recipe, isDark(element), letters, linkText(valuesOf(element)));
}

/** Returns the aspect that a link asks for, for use until the core has read it. */
export function aspectOf(link: string): number {
  return numberWithin(ASPECT, new URLSearchParams(link).get("aspect"));
}

/** Returns the speed that an element asks for, as a multiple of the ordinary one. */
export function speedOf(element: Element): number {
  return numberWithin(SPEED, element.getAttribute("speed"));
}

/** Returns the number of a text, brought into the range, or the default if it is none. */
function numberWithin(range: typeof SPEED, text: string | null): number {
  const value = Number(text?.trim() || Number.NaN);
  return Number.isFinite(value) ? Math.min(range.max, Math.max(range.min, value)) : range.default;
}

/** Returns the address of a map on the page that the attribute `maker` names; empty without one that a link may lead to. */
export function makerOf(element: Element, link: string): string {
  const page = element.getAttribute("maker");
  const address =
    page && URL.canParse(page, document.baseURI) ? addressOf(link, new URL(page, document.baseURI).href) : "";
  return address.startsWith("http") ? address : "";
}

/** Returns what an element says of the engine that it needs. */
export function initOf(element: Element): Init {
  const url = element.getAttribute("wasm-url");
  return { wasmUrl: url ? new URL(url, document.baseURI).href : undefined, link: linkToReadOf(element) };
}

/** Gives a class the properties: texts and numbers (null without the attribute), and Booleans. */
export function reflect(prototype: HTMLElement): void {
  for (const name of [...NUMBERS.map(attributeOf), "speed"]) define(prototype, name, numberIn);
  for (const name of [...TEXTS.map(attributeOf), ...BEHAVIOUR]) define(prototype, name, textIn);
  for (const name of FLAGS) define(prototype, name, flagIn);
}

/** Sets the properties again that a script set before the class was defined: they would hide the class's own. */
export function upgrade(element: HTMLElement): void {
  for (const name of [...OBSERVED.map(camelCase), "i18n"]) {
    if (!Object.hasOwn(element, name)) continue;
    const value = Reflect.get(element, name);
    Reflect.deleteProperty(element, name);
    Reflect.set(element, name, value);
  }
}

type Reader = (element: HTMLElement, name: string) => unknown;

function define(prototype: HTMLElement, attribute: string, read: Reader): void {
  const name = camelCase(attribute);
  Object.defineProperty(prototype, name, {
    configurable: true,
    enumerable: true,
    get(this: HTMLElement) {
      return read(this, attribute);
    },
    set(this: HTMLElement, value: unknown) {
      if (value === null || value === undefined || value === false) this.removeAttribute(attribute);
      else this.setAttribute(attribute, value === true ? "" : String(value));
    },
  });
}

function flagIn(element: HTMLElement, name: string): boolean {
  return element.hasAttribute(name);
}

function textIn(element: HTMLElement, name: string): string | null {
  return element.getAttribute(name);
}

function numberIn(element: HTMLElement, name: string): number | "auto" | null {
  const text = element.getAttribute(name);
  return text === null || text === "auto" ? text : Number(text);
}

function camelCase(attribute: string): string {
  return attribute.replace(/-(\w)/g, (_, letter: string) => letter.toUpperCase());
}

type CamelCase<Name> = Name extends `${infer First}-${infer Rest}` ? `${First}${Capitalize<CamelCase<Rest>>}` : Name;
type Property<Key extends string> = CamelCase<Key extends "style" | "width" ? `river-${Key}` : Key> & string;

/** The properties by type. Without the attribute they are null, or false if Boolean. */
export type Properties = { speed: number | null } & {
  [Key in (typeof NUMBERS)[number] as Property<Key>]: number | "auto" | null;
} & {
  [Key in (typeof TEXTS | typeof BEHAVIOUR)[number] as Property<Key>]: string | null;
} & { [Key in (typeof FLAGS)[number]]: boolean };
