/** The maps of the gallery: www/gallery/recipes.json, and what the engine says of them. */

import { readFileSync } from "node:fs";
import RECIPES from "../../gallery/recipes.json" with { type: "json" };
import { initSync, parameters, readLink } from "../../pkg-full/riverseed_full.js";

/** A map of the gallery. The first six of the list are seen first. */
export interface Recipe {
  /** Its name in addresses. */
  readonly slug: string;
  readonly title: string;
  /** What is to be seen, in plain English. */
  readonly sentence: string;
  /** Its canonical link, style included: it is the same on dark pages. */
  readonly link: string;
}

/** The same with what pages say of it. */
export interface Entry extends Recipe {
  readonly seed: string;
  /** Width over height, as links have it. */
  readonly aspect: string;
  readonly land: string;
  /** The name of its style. */
  readonly style: string;
  /** What it sets, in words. */
  readonly settings: readonly (readonly [label: string, value: string])[];
  /** Whether `<river-seed>` grows all of it on other people's pages. */
  readonly suitsElement: boolean;
}

export const recipes: readonly Recipe[] = RECIPES;

export function entries(): Entry[] {
  initSync({ module: readFileSync(new URL("../../pkg-full/riverseed_full_bg.wasm", import.meta.url)) });
  const table = new Map(parameters().map((parameter) => [parameter.key, parameter]));
  const worded = (key: string, text: string): string => {
    const { choices, unit } = table.get(key) ?? {};
    return choices?.find(({ value }) => value === text)?.label ?? [text, unit].filter(Boolean).join(" ");
  };
  return recipes.map((recipe) => {
    const values = new Map(readLink(recipe.link).values);
    const value = (key: string): string => values.get(key) ?? "";
    return {
      ...recipe,
      seed: value("seed"),
      aspect: value("aspect"),
      land: value("land"),
      style: worded("style", value("style")),
      settings: [...new URLSearchParams(recipe.link)].map(([key, text]) => [
        table.get(key)?.label ?? key,
        worded(key, text),
      ]),
      suitsElement: readLink(recipe.link, { widget: true }).notices.length === 0,
    };
  });
}
