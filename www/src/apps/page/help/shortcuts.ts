/** The keys that press a button of the page. */

import { elements } from "../elements.ts";
import type { Shortcut } from "./help.ts";

export function shortcuts(): Shortcut[] {
  const { dice, trail, panel, sharing, copy } = elements;
  return [
    { key: "r", says: "a new seed by chance", button: dice },
    { key: "[", says: "the seed before", button: trail.previous },
    { key: "]", says: "the seed after", button: trail.next },
    { key: "p", says: "the panel of shapes", button: panel.open },
    { key: "s", says: "share", button: sharing.open },
    { key: "l", says: "copy the link", button: copy },
  ];
}
