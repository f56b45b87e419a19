/**
 * Thins lines to one pixel, as for the world's maps: Zhang and Suen 1984, "A fast parallel algorithm for thinning
 * digital patterns".
 */

/** Thins lines in place. Pixels are given row by row, 1 where there is a line; those on the border stay. */
export function thin(pixels: Uint8Array, width: number): void {
  const around = [-width, 1 - width, 1, width + 1, width, width - 1, -1, -width - 1];
  // Stairs first, since otherwise they would be eroded from their ends.
  straighten(pixels, width);
  let changed = true;
  while (changed) {
    changed = false;
    for (const pass of [0, 1]) {
      const gone = removable(pixels, width, around, pass);
      for (const at of gone) pixels[at] = 0;
      changed ||= gone.length > 0;
    }
  }
  straighten(pixels, width);
}

/** Removes the corners of stairs, whose neighbours touch each other. */
function straighten(pixels: Uint8Array, width: number): void {
  const sides = [-width, 1, width, -1];
  for (let at = width + 1; at < pixels.length - width - 1; at++) {
    const x = at % width;
    if (!pixels[at] || x === 0 || x === width - 1) continue;
    const isCorner = sides.some((side, i) => {
      const next = sides[(i + 1) % 4] ?? 0;
      const [back, left, behind] = [pixels[at - side], pixels[at - next], pixels[at - side - next]];
      return pixels[at + side] && pixels[at + next] && !back && !left && !behind;
    });
    if (isCorner) pixels[at] = 0;
  }
}

function removable(pixels: Uint8Array, width: number, around: readonly number[], pass: number): number[] {
  const gone: number[] = [];
  for (let at = width + 1; at < pixels.length - width - 1; at++) {
    const x = at % width;
    if (!pixels[at] || x === 0 || x === width - 1) continue;
    if (
      isRemovable(
        around.map((step) => pixels[at + step] ?? 0),
        pass,
      )
    )
      gone.push(at);
  }
  return gone;
}

/** Returns whether a pixel may be removed, by its eight neighbours clockwise from north. */
function isRemovable(neighbours: readonly number[], pass: number): boolean {
  const [north = 0, , east = 0, , south = 0, , west = 0] = neighbours;
  const count = neighbours.reduce((sum, one) => sum + one, 0);
  const rises = neighbours.filter((one, i) => one === 0 && neighbours[(i + 1) % 8] === 1).length;
  if (count < 2 || count > 6 || rises !== 1) return false;
  return pass === 0
    ? north * east * south === 0 && east * south * west === 0
    : north * east * west === 0 && north * south * west === 0;
}
