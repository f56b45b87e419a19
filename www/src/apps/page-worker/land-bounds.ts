/** The part of a map that its land takes up. */

import type { WholeRiver } from "../../engine/whole.ts";
import type { LandBounds } from "./protocol.ts";

/** Islets that are smaller than this, in widths of the map, do not count. */
const SMALLEST = 0.05;

/** Returns the bounds of a river's land without its islets, in shares of the map's sides; none if all is land. */
export function landBoundsOf(river: WholeRiver): LandBounds | undefined {
  const { width, height } = river.lengths();
  const large = river
    .coasts()
    .map(boundsOf)
    .filter(({ left, top, right, bottom }) => Math.max(right - left, bottom - top) >= SMALLEST * width);
  if (large.length === 0) return;
  return {
    left: Math.min(...large.map(({ left }) => left)) / width,
    top: Math.min(...large.map(({ top }) => top)) / height,
    right: Math.max(...large.map(({ right }) => right)) / width,
    bottom: Math.max(...large.map(({ bottom }) => bottom)) / height,
  };
}

/** Returns the bounds of a ring, whose coordinates are x and y in turn. */
function boundsOf(ring: ArrayLike<number>): LandBounds {
  const bounds = { left: Infinity, top: Infinity, right: -Infinity, bottom: -Infinity };
  for (let i = 0; i + 1 < ring.length; i += 2) {
    const [x = 0, y = 0] = [ring[i], ring[i + 1]];
    bounds.left = Math.min(bounds.left, x);
    bounds.right = Math.max(bounds.right, x);
    bounds.top = Math.min(bounds.top, y);
    bounds.bottom = Math.max(bounds.bottom, y);
  }
  return bounds;
}
