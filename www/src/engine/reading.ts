/** Reads what a widget's author asks for. */

import { linkText } from "./link-text.ts";
import { DARK_STYLE, namesStyle } from "./scheme.ts";
import type { Notice } from "./types.ts";
import type { Engine } from "./wasm.ts";

/** What a widget asks for. */
export interface RiverRequest {
  /** Link text as its author gave it: anything. */
  text: string;
  /** Whether it stands on a dark page: then rivers are light, unless a style is chosen. */
  isDark: boolean;
}

/** A request as the core understood it. */
export interface Reading {
  /** The canonical link: what is drawn. */
  link: string;
  seed: string;
  aspect: number;
  /** What had to be mended. */
  notices: readonly Notice[];
}

/**
 * A widget shares its page with text that somebody reads. Within these bounds no step of a river, above all of those that make
 * rivers of a tree, holds up the page for longer than a blink, even where its policy refuses workers. They hold in workers too:
 * the same tag is the same river everywhere. Whoever wants more makes a picture of it.
 */
export const CAPS: readonly Cap[] = [
  { growth: "colonize", key: "attractors", bound: 20_000, isLeast: false },
  { growth: "brownian", key: "sensitivity", bound: 16, isLeast: true },
];

interface Cap {
  /** What it holds for. */
  growth: string;
  key: string;
  bound: number;
  /** Whether it is the least value or the greatest. */
  isLeast: boolean;
}

/** What of a recipe's values a widget does not go as far with, how far it does, and that in words. */
export function beyondCaps(values: ReadonlyMap<string, string>): { key: string; bound: number; message: string }[] {
  return CAPS.flatMap(({ growth, key, bound, isLeast }) => {
    const value = Number(values.get(key));
    if (values.get("growth") !== growth || (isLeast ? value >= bound : value <= bound)) return [];
    const beyond = isLeast ? "less" : "more";
    return [{ key, bound, message: `${key}: ${value} is ${beyond} than a widget grows: ${bound} is used` }];
  });
}

export function read(engine: Engine, { text, isDark }: RiverRequest): Reading {
  const asked = engine.readLink(text);
  const values = new Map(asked.values);
  const notices = [...asked.notices];
  for (const { key, bound, message } of beyondCaps(values)) {
    values.set(key, String(bound));
    notices.push({ key, message });
  }
  if (isDark && !namesStyle(text)) values.set("style", DARK_STYLE);
  return {
    link: engine.readLink(linkText(values)).link,
    seed: values.get("seed") ?? "",
    aspect: Number(values.get("aspect")),
    notices,
  };
}
