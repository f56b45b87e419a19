import { expect, test } from "vitest";
import { engine, memory, pixelsOf } from "../core.ts";

/** A finished river of a link, of which nothing is painted yet. */
function finished(link: string): engine.River {
  const river = new engine.River(link);
  river.resize(400, 360);
  while (river.advance(1000));
  return river;
}

test("a picture painted in parts is the one painted at once, and is seen with its last part", () => {
  for (const style of ["atlas", "parchment", "basins", "past-courses", "ink"]) {
    const link = `seed=kea&land=island&attractors=900&style=${style}`;
    const river = finished(link);
    const seen = new Uint8Array(memory.buffer, river.pixelsPointer(), river.pixelsLength()).slice();
    let parts = 1;
    for (; river.paint(); parts++) {
      expect([...river.dirty()]).toEqual([0, 0, 0, 0]);
      const now = new Uint8Array(memory.buffer, river.pixelsPointer(), river.pixelsLength());
      expect(Buffer.compare(seen, now)).toBe(0);
    }
    expect(parts, style).toBeGreaterThan(2);
    expect([...river.dirty()], style).toEqual([0, 0, 400, 360]);
    expect(Buffer.compare(pixelsOf(river), pixelsOf(finished(link))), style).toBe(0);
  }
});
