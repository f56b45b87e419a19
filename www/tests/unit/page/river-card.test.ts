import { expect, test } from "vitest";
import { placeClear } from "../../../src/apps/page/look-inside/river-card.ts";

const FREE = { left: 10, top: 10, right: 1000, bottom: 700 };
const CARD = { width: 300, height: 150 };

/** Returns whether a card there covers something of what is named. */
function covers({ x, y }: { x: number; y: number }, lit: typeof FREE): boolean {
  return x < lit.right && x + CARD.width > lit.left && y < lit.bottom && y + CARD.height > lit.top;
}

test.each([
  [{ left: 400, top: 300, right: 500, bottom: 400 }],
  [{ left: 20, top: 20, right: 600, bottom: 600 }],
  [{ left: 20, top: 300, right: 990, bottom: 400 }],
  [{ left: 690, top: 20, right: 1000, bottom: 690 }],
])("a card covers nothing of what is named, %o", (lit) => {
  const spot = { x: lit.left, y: lit.top };
  const place = placeClear(CARD, spot, lit, FREE);
  if (!place) throw new Error("no place");
  expect(covers(place, lit)).toBe(false);
  expect(place.x).toBeGreaterThanOrEqual(FREE.left);
  expect(place.x + CARD.width).toBeLessThanOrEqual(FREE.right);
  expect(place.y).toBeGreaterThanOrEqual(FREE.top);
  expect(place.y + CARD.height).toBeLessThanOrEqual(FREE.bottom);
});

test("where there is no room beside it, there is no such place", () => {
  expect(placeClear(CARD, { x: 500, y: 350 }, { left: 100, top: 100, right: 900, bottom: 600 }, FREE)).toBe(undefined);
});
