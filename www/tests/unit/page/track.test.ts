import { expect, test } from "vitest";
import { inWords, momentAt, shareOf, stepped } from "../../../src/apps/page/timeline/track.ts";
import type { Moment } from "../../../src/apps/page-worker/protocol.ts";

const MAPS = [
  { ticks: 40, rounds: 12 },
  { ticks: 900, rounds: 0 },
  { ticks: 1, rounds: 0 },
  { ticks: 0, rounds: 400 },
];

test.each(MAPS)("steps lead through all moments, from the land to the finished map and back: %o", (lengths) => {
  const there: Moment[] = [{ part: "growth", step: 0 }];
  for (let at = there[0]; at && at.part !== "map"; there.push(at)) at = stepped(at, 1, lengths);
  expect(there.length).toBe(Math.max(1, lengths.ticks) + lengths.rounds + 1 + 1);
  const shares = there.map((at) => shareOf(at, lengths));
  for (const [i, share] of shares.entries()) expect(share).toBeGreaterThanOrEqual(shares[i - 1] ?? 0);
  expect([shares[0], shares.at(-1)]).toEqual([0, 1]);
  for (const at of there.toReversed()) {
    const before = stepped(at, -1, lengths);
    if (shareOf(at, lengths) > 0) expect(stepped(before, 1, lengths)).toEqual(at);
    else expect(before).toEqual(at);
  }
});

test.each(MAPS)("each place on the track is a moment, and later ones are farther along: %o", (lengths) => {
  let last = 0;
  for (let i = 0; i <= 1000; i++) {
    const share = shareOf(momentAt(i / 1000, lengths), lengths);
    expect(share).toBeGreaterThanOrEqual(last);
    last = share;
  }
  expect(last).toBe(1);
});

test("moments are told in plain words", () => {
  const said = (part: "growth" | "bends" | "map", step: number) => inWords({ part, step }, { ticks: 40, rounds: 12 });
  expect([said("growth", 0), said("growth", 16), said("bends", 3), said("map", 0)]).toEqual([
    "land",
    "growth, 40 %",
    "bends, round 3 of 12",
    "finished map",
  ]);
  expect(inWords({ part: "bends", step: 0 }, { ticks: 40, rounds: 0 })).toBe("rivers");
});
