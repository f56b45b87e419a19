/** Reads what a widget's author asks for. */

import { linkText } from "../link.ts";
import type { Engine } from "../wasm.ts";
import type { Reading, Wish } from "./orders.ts";

/**
 * A widget shares its page with text that somebody reads. Up to here no step of a river takes longer than a blink, even on a
 * page whose policy refuses workers; whoever wants more makes a picture of it.
 */
export const CAPS: ReadonlyMap<string, number> = new Map([["attractors", 20_000]]);

/** The style for dark pages, if the core has it. */
const DARK = "dark";

export function read(engine: Engine, { text, isDark }: Wish): Reading {
  const asked = engine.readLink(text);
  const values = new Map(asked.values);
  const notices = [...asked.notices];
  for (const [key, most] of CAPS) {
    const value = values.get(key);
    if (value === undefined || Number(value) <= most) continue;
    values.set(key, String(most));
    notices.push({ key, message: `${key}: ${value} is more than a widget grows: ${most} is used` });
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
