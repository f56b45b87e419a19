/** What of the picture's place other things cover: the map lies in what is left. */

import type { Insets } from "./camera.ts";
import { elements } from "./elements.ts";

/** What stays free around the map, in CSS pixels. */
const MARGIN_PX = 16;

/** What of the picture's place the name of the page, the bar, the styles and the panel cover. */
export function covered(): Insets {
  const { bar, styles, panel, masthead } = elements;
  const edge = (element: HTMLElement): DOMRect | undefined =>
    element.hidden || element.getClientRects().length === 0 ? undefined : element.getBoundingClientRect();
  const insets = {
    left: MARGIN_PX,
    top: masthead.offsetTop + masthead.offsetHeight,
    right: MARGIN_PX,
    bottom: MARGIN_PX,
  };
  for (const box of [edge(bar), edge(styles), edge(panel.panel)]) {
    if (!box) continue;
    // What begins in the left half lies below the map; the rest beside it.
    if (box.left < innerWidth / 2) insets.bottom = Math.max(insets.bottom, innerHeight - box.top + MARGIN_PX);
    else insets.right = Math.max(insets.right, innerWidth - box.left + MARGIN_PX);
  }
  return insets;
}
