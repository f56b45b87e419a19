/** Tells the reader of the river on the canvas: by the picture's name, the button, and the link to its maker. */

import type { State } from "../../player/frame-loop.ts";
import { makerOf } from "./attributes.ts";
import type { Seen } from "./protocol.ts";
import { countIn, type Strings, type Told } from "./strings.ts";
import { isDark } from "./theme.ts";
import type { Does, View } from "./view.ts";

/** The action of the button in each state. */
export const DOES: Record<State, Does> = { growing: "pause", settling: "pause", paused: "play", finished: "replay" };

/** Updates the texts of an element. `isShown` is true once the river can be seen. */
export function describeRiver(element: Element, view: View, strings: Strings, seen: Seen, isShown: boolean): void {
  const { state, reading } = seen;
  const name = element.getAttribute("aria-label") ?? element.getAttribute("alt");
  view.name(name ?? strings.alternative(toldOf(element, seen)));
  view.maker(isShown ? makerOf(element, reading.link) : "", strings.maker);
  const isAsked = element.hasAttribute("controls");
  const isMoving = state === "growing" || state === "paused";
  const isThere = isShown || state === "paused";
  const does = isThere && (isAsked || isMoving || !element.hasAttribute("still")) ? DOES[state] : undefined;
  const isQuiet = !isAsked && !isMoving;
  view.button(does, does ? strings[does] : "", { isQuiet, isDark: isDark(element) });
}

/** Announces the finished river, unless its picture is decorative. */
export function announceEnd(element: Element, view: View, strings: Strings, seen: Seen): void {
  if (element.getAttribute("alt") !== "") view.say(strings.finished(toldOf(element, seen)));
}

function toldOf(element: Element, seen: Seen): Told {
  return { ...seen, seed: seen.reading.seed, count: countIn(element) };
}
