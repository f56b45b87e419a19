/** Measures how much of the picture's place other things cover. The map is in the rest. */

import { elements } from "../elements.ts";
import type { Insets } from "./camera.ts";

/** The margin around the map, in CSS pixels. */
const MARGIN_PX = 16;

/** Measures the parts that the page's name, the map's title, the bar, the styles and the panel cover. */
export function covered(): Insets {
  const { bar, styles, panel, masthead, titling } = elements;
  const edge = (element: HTMLElement): DOMRect | undefined =>
    element.hidden || element.getClientRects().length === 0 ? undefined : element.getBoundingClientRect();
  const insets = {
    left: MARGIN_PX,
    top: Math.max(masthead.offsetTop + masthead.offsetHeight, edge(titling)?.bottom ?? 0),
    right: MARGIN_PX,
    bottom: MARGIN_PX,
  };
  const below = (box: DOMRect): void => {
    insets.bottom = Math.max(insets.bottom, innerHeight - box.top + MARGIN_PX);
  };
  // An element wider than half the window is below the map, as the bar is; others are beside it, on either side.
  const beside = (box: DOMRect): void => {
    if (box.width > innerWidth / 2) below(box);
    else if (box.left > innerWidth / 2) insets.right = Math.max(insets.right, innerWidth - box.left + MARGIN_PX);
    else insets.left = Math.max(insets.left, box.right + MARGIN_PX);
  };
  const barBox = edge(bar);
  if (barBox) below(barBox);
  for (const box of [edge(styles), edge(panel.panel)]) if (box) beside(box);
  return insets;
}
