import { expect, test } from "vitest";
import {
  FRAME_BUDGET_MS,
  GROWTH_SECONDS,
  MEANDER_SECONDS,
  PAINT_BUDGET_MS,
  RISE_SECONDS,
  ROUNDS_PER_SECOND,
} from "../../src/player/frame-loop.ts";
import { Stage } from "../stage.ts";

/** How many seconds of frames at a rate pass before it has grown up. */
function secondsToGrow(stage: Stage, rate: number): number {
  let frames = 0;
  for (; stage.phase === "growing"; frames++) stage.frames(1, 1000 / rate);
  // The first frame shows how it begins.
  return (frames - 1) / rate;
}

test("at 1x a tree grows up in the stated time, however many ticks it takes and at any display rate", () => {
  for (const [rate, ticks] of [24, 60, 144].flatMap((rate) =>
    [150, 600, 6_000].map((ticks) => [rate, ticks] as const),
  )) {
    const stage = new Stage(ticks);
    stage.loop.play();
    const seconds = secondsToGrow(stage, rate);
    expect(seconds).toBeLessThanOrEqual(GROWTH_SECONDS + 3 / rate);
    // The last of few ticks is due a little earlier.
    expect(seconds).toBeGreaterThan(0.8 * GROWTH_SECONDS);
  }
});

test("speed divides the time", () => {
  for (const speed of [0.25, 4, 8]) {
    const stage = new Stage();
    stage.loop.speed = speed;
    stage.loop.play();
    const seconds = speed * secondsToGrow(stage, 60);
    expect(seconds).toBeLessThanOrEqual(GROWTH_SECONDS + (3 * speed) / 60);
    expect(seconds).toBeGreaterThan(0.8 * GROWTH_SECONDS);
  }
});

test("growth is fast at first: four fifths after a second, and every frame has its share", () => {
  const stage = new Stage(6_000);
  stage.loop.play();
  stage.frames(61);
  expect(stage.progress).toBeCloseTo(0.82, 1);
  const steps = stage.drawn.slice(1).map((ticks, i) => ticks - (stage.drawn[i] ?? 0));
  for (const [i, step] of steps.entries()) expect(step).toBeLessThanOrEqual(steps[i - 1] ?? step);
});

test("another speed on the way changes the pace, and jumps nowhere", () => {
  const stage = new Stage();
  stage.loop.speed = Number.POSITIVE_INFINITY;
  stage.cost = 1;
  stage.loop.play();
  stage.frames(20);
  const before = stage.ticks;
  stage.cost = 0;
  stage.loop.speed = 1;
  stage.frames(2);
  expect(stage.ticks - before).toBeLessThanOrEqual(2 * mostInAFrame(stage));
});

/** What is due in one frame at 1x, at first, when that is most. */
function mostInAFrame(stage: Stage): number {
  return Math.ceil((2.5 * stage.lastTick) / GROWTH_SECONDS / 60) + 1;
}

test("instant speed uses each frame's budget and is still drawn as it grows", () => {
  const stage = new Stage(300);
  stage.cost = 0.1;
  stage.loop.speed = Number.POSITIVE_INFINITY;
  stage.loop.play();
  stage.frames(4);
  expect(stage.ticks).toBeGreaterThanOrEqual(4 * (FRAME_BUDGET_MS / stage.cost) - 4);
  expect(stage.drawn.length).toBe(4);
  stage.frames(20);
  expect(stage.states).toEqual(["growing", "finished"]);
});

test("no frame grows longer than its budget and one tick", () => {
  const stage = new Stage();
  stage.cost = 4;
  stage.loop.speed = 8;
  stage.loop.play();
  for (let i = 0; i < 100; i++) {
    const before = stage.ticks;
    stage.frames(1);
    expect((stage.ticks - before) * stage.cost).toBeLessThan(FRAME_BUDGET_MS + stage.cost);
  }
});

test("work that does not fit makes growth slower, never a burst later", () => {
  const stage = new Stage(6_000);
  stage.cost = 6;
  stage.loop.speed = 8;
  stage.loop.play();
  stage.frames(200);
  stage.cost = 0;
  const before = stage.ticks;
  stage.frames(1);
  expect(stage.ticks - before).toBeLessThanOrEqual(8 * mostInAFrame(stage));
});

test("a tab that was away for a minute goes on from where it was", () => {
  const stage = new Stage();
  stage.loop.play();
  stage.frames(10);
  stage.time += 60_000;
  const before = stage.ticks;
  stage.frames(1);
  expect(stage.ticks - before).toBeLessThanOrEqual(6 * mostInAFrame(stage));
});

test("paused means no growth and no frames", () => {
  const stage = new Stage();
  stage.loop.play();
  stage.frames(30);
  stage.loop.pause();
  stage.frames(1);
  const { ticks } = stage;
  stage.frames(30);
  expect(stage.ticks).toBe(ticks);
  expect(stage.waiting).toBe(0);
  stage.loop.play();
  stage.frames(30);
  expect(stage.ticks).toBeGreaterThan(ticks);
  expect(stage.restarts).toBe(0);
});

test("a finished river asks for no more frames, and playing it starts again", () => {
  const stage = new Stage(50);
  stage.loop.play();
  stage.frames(600);
  expect(stage.loop.state).toBe("finished");
  expect(stage.waiting).toBe(0);
  expect(stage.drawn.at(-1)).toBe(stage.lastTick);
  stage.loop.toggle();
  expect(stage.restarts).toBe(1);
  expect(stage.loop.state).toBe("growing");
});

/** The steps of the sea's rise that were shown, each once, in order. */
function risesShown(stage: Stage): number[] {
  const shown = stage.drawn.filter((_, i) => stage.phases[i] === "drowning").map((ticks) => ticks - stage.lastTick);
  return shown.filter((step, i) => step !== shown[i - 1]);
}

for (const rate of [30, 60, 144])
  test(`the sea is seen rising step by step in the stated time, between growth and rivers, at ${rate} frames a second`, () => {
    const stage = new Stage(100, 12, 15);
    stage.loop.watch();
    secondsToGrow(stage, rate);
    let frames = 0;
    for (; stage.phase === "drowning"; frames++) stage.frames(1, 1000 / rate);
    expect(frames / rate).toBeGreaterThan(0.9 * RISE_SECONDS);
    expect(frames / rate).toBeLessThanOrEqual(RISE_SECONDS + 3 / rate);
    // The last step leaves the land of the rivers.
    expect(risesShown(stage)).toEqual([...Array(15).keys()]);
    expect(stage.phases.at(-1)).toBe("shaping");
  });

test("the sea rises at the reader's pace, stands still while paused, and goes on from there", () => {
  const stage = new Stage(100, 12, 15);
  stage.loop.speed = 4;
  stage.loop.watch();
  secondsToGrow(stage, 60);
  stage.frames(8);
  stage.loop.pause();
  const { ticks } = stage;
  stage.frames(60);
  expect([stage.phase, stage.ticks]).toEqual(["drowning", ticks]);
  stage.loop.play();
  stage.frames(2);
  expect(stage.ticks).toBeLessThanOrEqual(ticks + 2);
  stage.frames((60 * RISE_SECONDS) / 4);
  expect(stage.phase).not.toBe("drowning");
});

test("nobody who does not watch sees the sea rise, or waits for it", () => {
  const stage = new Stage(100, 12, 15);
  stage.loop.settle(false);
  // One for each phase.
  stage.frames(4);
  expect([stage.loop.state, risesShown(stage)]).toEqual(["finished", []]);
});

test("a redraw is drawn once, and grows nothing", () => {
  const stage = new Stage(10);
  stage.loop.settle(false);
  stage.frames(2);
  stage.loop.redraw();
  stage.loop.redraw();
  stage.frames(5);
  expect(stage.drawn).toEqual([10, 10]);
  expect(stage.loop.state).toBe("finished");
});

test("a picture that takes long is painted over several frames, in which nothing grows, and then gives way to another", () => {
  const stage = new Stage(10);
  [stage.partsOfPicture, stage.partCost] = [7, PAINT_BUDGET_MS / 2];
  stage.loop.settle(false);
  // Two parts fit into the budget.
  for (const parts of [2, 4, 6]) {
    stage.frames(1);
    expect([stage.parts, stage.drawn.length, stage.ready, stage.loop.isBusy]).toEqual([parts, 0, 0, true]);
    expect(stage.loop.state).toBe("settling");
  }
  stage.frames(1);
  expect([stage.drawn, stage.ready, stage.loop.isBusy, stage.loop.state]).toEqual([[10], 1, false, "finished"]);
  stage.loop.redraw();
  stage.frames(3);
  expect([stage.loop.isBusy, stage.drawn.length]).toEqual([true, 1]);
  stage.frames(1);
  expect([stage.loop.isBusy, stage.drawn.length, stage.ready, stage.waiting]).toEqual([false, 2, 2, 0]);
});

test("a river that is watched grows in turns with a picture that takes long", () => {
  const stage = new Stage(40);
  [stage.partsOfPicture, stage.partCost] = [4, PAINT_BUDGET_MS / 2];
  stage.loop.watch();
  for (let i = 0; i < 300 && stage.loop.state === "growing"; i++) {
    const { ticks, parts } = stage;
    stage.frames(1);
    expect(parts === 0 || stage.ticks === ticks).toBe(true);
  }
  expect([stage.loop.state, stage.drawn.at(-1)]).toEqual(["finished", 40]);
});

test("at rest nothing is drawn; waking goes on", () => {
  const stage = new Stage();
  stage.loop.play();
  stage.frames(5);
  stage.loop.rest();
  expect(stage.waiting).toBe(0);
  const { ticks } = stage;
  stage.time += 5000;
  stage.loop.wake();
  stage.frames(60);
  expect(stage.ticks - ticks).toBeLessThanOrEqual(0.9 * stage.lastTick);
  expect(stage.ticks).toBeGreaterThan(ticks);
});

test("at rest what is due to be drawn is drawn, and nothing grows", () => {
  const stage = new Stage();
  stage.loop.watch();
  stage.loop.rest();
  stage.frames(5);
  expect(stage.drawn).toEqual([0]);
  stage.loop.redraw();
  stage.frames(5);
  expect(stage.drawn).toEqual([0, 0]);
  expect(stage.waiting).toBe(0);
  stage.loop.wake();
  stage.frames(30);
  expect(stage.ticks).toBeGreaterThan(0);
});

test("a river that the reader is past is finished without pictures, and then painted once", () => {
  const stage = new Stage(600, 200);
  stage.cost = 1;
  stage.loop.watch();
  stage.frames(5);
  const seen = stage.drawn.length;
  stage.loop.finishUnseen();
  stage.frames(200);
  expect(stage.loop.state).toBe("finished");
  expect(stage.phases.slice(seen)).toEqual(["finished"]);
  expect(stage.waiting).toBe(0);
});

test("who comes back before that sees it go on from as far as it is, at the usual pace", () => {
  const stage = new Stage(600);
  stage.cost = 1;
  stage.loop.watch();
  stage.frames(5);
  stage.loop.finishUnseen();
  stage.frames(20);
  expect(stage.loop.state).toBe("growing");
  const [ticks, seen] = [stage.ticks, stage.drawn.length];
  stage.loop.wake();
  stage.frames(2);
  expect(stage.drawn.length).toBeGreaterThan(seen);
  expect(stage.ticks).toBeGreaterThanOrEqual(ticks);
  expect(stage.ticks - ticks).toBeLessThan(0.1 * stage.lastTick);
});

test("one that is paused stays so when the reader is past it", () => {
  const stage = new Stage();
  stage.loop.watch();
  stage.frames(5);
  stage.loop.pause();
  stage.frames(1);
  const { ticks } = stage;
  stage.loop.finishUnseen();
  stage.frames(20);
  expect(stage.ticks).toBe(ticks);
  expect(stage.loop.state).toBe("paused");
});

test("a hidden page stops those as well that nobody sees", () => {
  const stage = new Stage();
  stage.loop.watch();
  stage.frames(1);
  stage.loop.finishUnseen();
  stage.loop.rest();
  stage.frames(5);
  const { ticks } = stage;
  stage.frames(20);
  expect(stage.ticks).toBe(ticks);
  expect(stage.waiting).toBe(0);
});

test("a failure is told once and stops the loop", () => {
  const stage = new Stage();
  stage.advance = () => {
    throw new Error("unreachable");
  };
  stage.loop.settle(false);
  stage.frames(5);
  expect(stage.failures).toHaveLength(1);
  expect(stage.waiting).toBe(0);
});

test("growth is followed by meandering, animated at its own pace", () => {
  const stage = new Stage(10, ROUNDS_PER_SECOND);
  stage.loop.watch();
  while (stage.phase !== "meandering") stage.frames(1);
  stage.frames(30);
  const rounds = stage.ticks - stage.lastTick - 1;
  expect(Math.abs(rounds - ROUNDS_PER_SECOND / 2)).toBeLessThanOrEqual(2);
  stage.frames(60);
  expect(stage.states).toEqual(["growing", "finished"]);
  expect(new Set(stage.phases)).toEqual(new Set(["growing", "shaping", "meandering", "finished"]));
});

test("speed multiplies rounds, too", () => {
  const stage = new Stage(1, ROUNDS_PER_SECOND);
  stage.loop.speed = 4;
  stage.loop.watch();
  while (stage.phase !== "meandering") stage.frames(1);
  const before = stage.ticks;
  stage.frames(9);
  expect(Math.abs(stage.ticks - before - (4 * 9 * ROUNDS_PER_SECOND) / 60)).toBeLessThanOrEqual(5);
});

test("many rounds share the time that there is for meandering", () => {
  const stage = new Stage(1, 400);
  stage.loop.watch();
  while (stage.phase !== "meandering") stage.frames(1);
  stage.frames(60 * MEANDER_SECONDS + 3);
  expect(stage.loop.state).toBe("finished");
});
