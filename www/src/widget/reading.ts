/** Reads what a widget's author asks for. */

import { linkText } from "../link.ts";
import type { Engine } from "../wasm.ts";
import type { Reading, Wish } from "./orders.ts";

/**
 * A widget shares its page with text that somebody reads. Within these bounds no step of a river, above all the one that makes
 * rivers of a tree, holds up the page for longer than a blink, even where its policy refuses workers. They hold in workers too:
 * the same tag is the same river everywhere. Whoever wants more makes a picture of it.
 */
export const CAPS: readonly Cap[] = [
  { growth: "colonize", key: "attractors", bound: 12_000, isLeast: false },
  { growth: "brownian", key: "sensitivity", bound: 32, isLeast: true },
];

interface Cap {
  /** What it holds for. */
  growth: string;
  key: string;
  bound: number;
  /** Whether it is the least value or the greatest. */
  isLeast: boolean;
}

/** The style for dark pages, if the core has it. */
const DARK = "dark";

export function read(engine: Engine, { text, isDark }: Wish): Reading {
  const asked = engine.readLink(text);
  const values = new Map(asked.values);
  const notices = [...asked.notices];
  for (const { growth, key, bound, isLeast } of CAPS) {
    const value = Number(values.get(key));
    if (values.get("growth") !== growth || (isLeast ? value >= bound : value <= bound)) continue;
    values.set(key, String(bound));
    const beyond = isLeast ? "less" : "more";
    notices.push({ key, message: `${key}: ${value} is ${beyond} than a widget grows: ${bound} is used` });
  }
  if (isDark && !new URLSearchParams(text).has("style") && hasDark(engine)) values.set("style", DARK);
  return {
    link: engine.readLink(linkText(values)).link,
    seed: values.get("seed") ?? "",
    aspect: Number(values.get("aspect")),
    notices,
  };
}

function hasDark(engine: Engine): boolean {
  const style = engine.parameters().find(({ key }) => key === "style");
  return style?.choices?.some(({ value }) => value === DARK) ?? false;
}
