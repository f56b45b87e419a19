/** The keys that press a button of the page, or do what *Share* does. */

import { elements } from "../elements.ts";
import type { Shortcut } from "./help.ts";

export function shortcuts(copyLink: () => void): Shortcut[] {
  const { dice, panel, sharing, variations } = elements;
  return [
    { key: "r", says: "a new seed by chance", act: () => dice.click() },
    { key: "p", says: "the panel of shapes", act: () => panel.open.click() },
    { key: "v", says: "variations of this map, to choose from", act: () => variations.open.click() },
    { key: "s", says: "share", act: () => sharing.open.click() },
    { key: "l", says: "copy the link", act: copyLink },
  ];
}
