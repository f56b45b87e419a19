/** The maps of the gallery: www/gallery/recipes.json, with details from the engine. */

import { readFileSync } from "node:fs";
import RECIPES from "../../gallery/recipes.json" with { type: "json" };
import { initSync, readLink } from "../../pkg-engine/riverseed_engine.js";
import { table } from "../table.ts";

/** A map of the gallery. The first six in the list are on the first screen. */
export interface Recipe {
  /** The map's name in addresses. */
  readonly slug: string;
  readonly title: string;
  /** A description of the picture in plain English. */
  readonly sentence: string;
  /** The canonical link, including the style, so that it is the same on dark pages. */
  readonly link: string;
}

/** A map of the gallery with the details for its page. */
export interface Entry extends Recipe {
  readonly seed: string;
  /** Width over height, as a link writes it. */
  readonly aspect: string;
  readonly land: string;
  /** The name of its style. */
  readonly style: string;
  /** The settings of the link in words. */
  readonly settings: readonly (readonly [label: string, value: string])[];
  /** True if `<river-seed>` grows the whole map on other pages. */
  readonly suitsElement: boolean;
}

export const recipes: readonly Recipe[] = RECIPES;

export function entries(): Entry[] {
  initSync({ module: readFileSync(new URL("../../pkg-engine/riverseed_engine_bg.wasm", import.meta.url)) });
  const rows = new Map(table.parameters.map((parameter) => [parameter.key, parameter]));
  const worded = (key: string, text: string): string => {
    const { choices, unit } = rows.get(key) ?? {};
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
        rows.get(key)?.label ?? key,
        worded(key, text),
      ]),
      suitsElement: readLink(recipe.link, { widget: true }).notices.length === 0,
    };
  });
}
