import { expect, test } from "vitest";
import type { Phase } from "../../pkg-make/riverseed.js";
import {
  DRAFT_BUDGET_MS,
  FRAME_BUDGET_MS,
  LONG_STEPS_MS,
  REST_MS,
  SETTLE_BUDGET_MS,
  SETTLE_QUIET_MS,
} from "../../src/player/frame-loop.ts";
import { Stage } from "../stage.ts";

test("settling shows nothing but the finished river, if that is soon", () => {
  const stage = new Stage(200);
  stage.cost = 0.2;
  stage.loop.settle(false);
  stage.frames(20);
  expect(stage.loop.state).toBe("finished");
  expect(stage.drawn).toEqual([200]);
});

test("settling takes turns with the page, and shows what there is now and then once it takes long", () => {
  const stage = new Stage(10_000);
  stage.cost = 1;
  stage.loop.settle(false);
  stage.frames(1);
  expect(stage.ticks).toBe(SETTLE_BUDGET_MS);
  stage.frames(Math.ceil((4 * SETTLE_QUIET_MS) / (1000 / 60)));
  expect(stage.drawn.length).toBeGreaterThanOrEqual(3);
  expect(stage.drawn.length).toBeLessThanOrEqual(4);
  expect(stage.loop.state).toBe("settling");
});

test("a settling river that was grown shows its tree on the way, if it is asked to, and then gives way to another", () => {
  const stage = new Stage(20, 30);
  stage.cost = 1;
  stage.loop.settle(true);
  while (stage.phase === "growing") {
    expect(stage.loop.isBusy).toBe(true);
    stage.frames(1);
  }
  expect(stage.drawn).toEqual([20]);
  expect([stage.loop.isBusy, stage.ready]).toEqual([false, 1]);
  stage.frames(10);
  expect(stage.drawn).toEqual([20, 51]);
  expect(stage.loop.state).toBe("finished");
});

test("a settling river that is not asked to shows nothing but its end", () => {
  const stage = new Stage(20, 30);
  stage.cost = 0.5;
  stage.loop.settle(false);
  stage.frames(2);
  expect(stage.loop.isBusy).toBe(true);
  stage.frames(10);
  expect(stage.drawn).toEqual([51]);
  expect([stage.loop.isBusy, stage.ready]).toEqual([false, 1]);
});

test("a new map is shown before it bends, if that is long in coming, and not again until some time has passed", () => {
  const stage = new Stage(60, 100);
  stage.cost = 1;
  stage.loop.settle(false);
  while (stage.drawn.length === 0) stage.frames(1);
  expect([stage.phases, stage.drawn, stage.loop.state]).toEqual([["meandering"], [61], "settling"]);
  stage.frames(Math.floor(SETTLE_QUIET_MS / 20));
  expect(stage.drawn).toEqual([61, 161]);
  const bent = new Stage(60, 100);
  bent.cost = 0.1;
  bent.loop.settle(false);
  bent.frames(20);
  expect(bent.phases, "the map is there soon").toEqual(["finished"]);
});

test("a thread of its own works longer for a river that somebody waits for, and as ever for an animated one", () => {
  const stage = new Stage(10_000, 10, 0, 15);
  stage.cost = 1;
  stage.loop.settle(false);
  stage.frames(1);
  expect(stage.ticks).toBe(15);
  const watched = new Stage(10_000, 10, 0, 15);
  [watched.cost, watched.loop.speed] = [1, Number.POSITIVE_INFINITY];
  watched.loop.watch();
  watched.frames(2);
  expect(watched.ticks).toBeLessThanOrEqual(2 * FRAME_BUDGET_MS);
});

test("a river that settles for long gives way once anything grown was shown", () => {
  const stage = new Stage(0, 10_000);
  stage.cost = 1;
  stage.loop.settle(false);
  while (stage.drawn.length === 0) stage.frames(1);
  expect(stage.phases).toEqual(["meandering"]);
  expect(stage.loop.isBusy).toBe(false);
});

test("long steps and painting take turns", () => {
  const stage = new Stage(3, 5);
  stage.cost = LONG_STEPS_MS + 1;
  stage.loop.speed = Number.POSITIVE_INFINITY;
  stage.loop.watch();
  for (let i = 0; i < 40; i++) {
    const before = [stage.ticks, stage.drawn.length] as const;
    stage.frames(1);
    const worked = stage.ticks - before[0];
    const drew = stage.drawn.length - before[1];
    expect(worked + drew).toBeLessThanOrEqual(1);
  }
  expect(stage.drawn).toEqual([1, 2, 3, 4, 5, 6, 7, 8, 9]);
  expect(stage.loop.state).toBe("finished");
});

/** How many frames there are in a time. */
const FRAMES_OF = (ms: number): number => Math.ceil(ms / (1000 / 60));

test("what follows a hand is seen in the next frame, as far as there is time for, and finished when the hand rests", () => {
  const stage = new Stage(0, 1000);
  stage.cost = 1;
  stage.loop.follow();
  stage.frames(1);
  expect([stage.drawn, stage.drafts]).toEqual([[DRAFT_BUDGET_MS], [true]]);
  expect([stage.loop.isBusy, stage.ready]).toEqual([false, 1]);
  // Nothing more is done while it may move on.
  stage.frames(FRAMES_OF(REST_MS) - 3);
  expect(stage.ticks).toBe(DRAFT_BUDGET_MS);
  stage.frames(200);
  expect([stage.drawn, stage.drafts]).toEqual([
    [DRAFT_BUDGET_MS, 1001],
    [true, false],
  ]);
  expect(stage.loop.state).toBe("finished");
});

test("what is finished by then is shown as it is, and not as a draft", () => {
  const stage = new Stage(0, 4);
  stage.loop.follow();
  stage.frames(1);
  // That was all there is to do.
  expect([stage.drawn, stage.drafts, stage.loop.state]).toEqual([[5], [false], "finished"]);
});

test("a hand that moves on is followed, however often, and each time something is seen", () => {
  const stage = new Stage(50, 1000);
  stage.cost = 1;
  for (let moves = 1; moves <= 20; moves++) {
    stage.restart();
    stage.loop.follow();
    while (stage.loop.isBusy) stage.frames(1);
    expect(stage.drawn).toHaveLength(moves);
    expect(stage.phases.at(-1)).toBe("shaping");
  }
});

test("what has been shown otherwise is finished at once, and shown no more before", () => {
  const stage = new Stage(0, 1000);
  stage.cost = 1;
  stage.loop.follow(true);
  expect(stage.loop.isBusy).toBe(false);
  stage.frames(2);
  expect([stage.ticks, stage.drawn]).toEqual([1 + SETTLE_BUDGET_MS, []]);
  stage.frames(200);
  expect(stage.drawn).toEqual([1001]);
});

test("rivers, or a relief, that are made again are not thrown away before anything new of them was seen", () => {
  for (const phase of ["shaping", "relief"] as const) {
    class Slow extends Stage {
      override get phase(): Phase {
        return this.ticks < 3 ? phase : "finished";
      }
    }
    const stage = new Slow();
    // Each step takes longer than anybody waits in silence.
    stage.cost = SETTLE_QUIET_MS + 50;
    stage.loop.settle(false);
    for (let i = 0; i < 2; i++) {
      stage.frames(2);
      expect([stage.loop.isBusy, stage.ready]).toEqual([true, 0]);
    }
    stage.frames(4);
    expect([stage.loop.isBusy, stage.loop.state]).toEqual([false, "finished"]);
  }
});

test("seeking goes to its share without pictures on the way, and pauses there", () => {
  const stage = new Stage(600, 200);
  stage.cost = 1;
  stage.loop.seek(0.25);
  stage.frames(100);
  expect(stage.loop.state).toBe("paused");
  expect(stage.drawn).toEqual([300]);
  expect(stage.waiting).toBe(0);
});

test("seeking back grows again from the mouths; forward it goes on", () => {
  const stage = new Stage(600, 200);
  stage.loop.seek(0.8);
  stage.frames(5);
  expect(stage.phase).toBe("meandering");
  stage.loop.seek(0.25);
  stage.frames(5);
  expect([stage.ticks, stage.restarts]).toEqual([300, 1]);
  stage.loop.seek(0.4);
  stage.frames(5);
  expect([stage.ticks, stage.restarts]).toEqual([480, 1]);
});

test("seeking to the end finishes, and playing goes on from where it was sought", () => {
  const stage = new Stage(600);
  stage.loop.seek(0.25);
  stage.frames(5);
  stage.loop.play();
  stage.frames(3);
  expect(stage.loop.state).toBe("growing");
  expect(stage.restarts).toBe(0);
  stage.loop.seek(1);
  stage.frames(5);
  expect(stage.loop.state).toBe("finished");
});

test.each([Number.NaN, -1, Number.POSITIVE_INFINITY])("seeking to %s stops somewhere", (share) => {
  const stage = new Stage(600);
  stage.loop.seek(share);
  stage.frames(5);
  expect(stage.loop.state).toBe(share > 1 ? "finished" : "paused");
});
