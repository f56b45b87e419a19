import { expect, test } from "vitest";
import { DoubleTap, type Touch } from "../../../src/apps/page/map/taps.ts";

function touch(timeStamp: number, more: Partial<Touch> = {}): Touch {
  return { pointerType: "touch", isPrimary: true, clientX: 100, clientY: 100, timeStamp, ...more };
}

/** Taps, each told by its beginning, its end and where that is; whether each was the second of two. */
function after(...taps: readonly (readonly [down: Touch, up: Touch])[]): boolean[] {
  const taken = new DoubleTap();
  return taps.map(([down, up]) => {
    taken.down(down);
    return taken.up(up);
  });
}

function tap(at: number, more: Partial<Touch> = {}): [Touch, Touch] {
  return [touch(at, more), touch(at + 60, more)];
}

test("the second of two taps on one spot ends a double tap, and a third begins another", () => {
  expect(after(tap(0), tap(200))).toEqual([false, true]);
  expect(after(tap(0), tap(200), tap(400), tap(600))).toEqual([false, true, false, true]);
});

test("two taps too far apart, in time or on the screen, are two taps", () => {
  expect(after(tap(0), tap(1000))).toEqual([false, false]);
  expect(after(tap(0), tap(200, { clientX: 200 }))).toEqual([false, false]);
  // The second may be the first of two.
  expect(after(tap(0), tap(1000), tap(1200))).toEqual([false, false, true]);
});

test("a drag, a finger that stays, a mouse and a pinch are no taps", () => {
  const drag: [Touch, Touch] = [touch(0), touch(60, { clientX: 160 })];
  const long: [Touch, Touch] = [touch(0), touch(900)];
  for (const no of [drag, long]) expect(after(no, tap(1000))).toEqual([false, false]);
  expect(after(tap(0, { pointerType: "mouse" }), tap(200, { pointerType: "mouse" }))).toEqual([false, false]);
  const pinch = new DoubleTap();
  pinch.down(touch(0));
  pinch.up(touch(50));
  pinch.down(touch(100));
  pinch.down(touch(110, { isPrimary: false }));
  expect([pinch.up(touch(150)), pinch.up(touch(160, { isPrimary: false }))]).toEqual([false, false]);
});

test("a tap that the browser has taken is none", () => {
  const taken = new DoubleTap();
  taken.down(touch(0));
  expect(taken.up(touch(50))).toBe(false);
  taken.down(touch(100));
  taken.cancel();
  expect(taken.up(touch(150))).toBe(false);
});
