import { expect, test } from "vitest";
import type { Phase } from "../../pkg-make/riverseed.js";
import {
  DRAFT_BUDGET_MS,
  FRAME_BUDGET_MS,
  FrameLoop,
  GROWTH_SECONDS,
  type Growing,
  LONG_STEPS_MS,
  MEANDER_SECONDS,
  PAINT_BUDGET_MS,
  REST_MS,
  RISE_SECONDS,
  ROUNDS_PER_SECOND,
  SETTLE_BUDGET_MS,
  SETTLE_QUIET_MS,
  type State,
} from "../../src/player/frame-loop.ts";

/** A display and a clock that only move when told; a step takes as long as a test says. */
class Stage implements Growing {
  time = 1000;
  /** Steps of any kind. */
  ticks = 0;
  drawn: number[] = [];
  phases: Phase[] = [];
  /** Which of the pictures could be drafts. */
  drafts: boolean[] = [];
  ready = 0;
  states: State[] = [];
  failures: unknown[] = [];
  restarts = 0;
  cost = 0;
  /** A picture is painted in so many parts, of so many milliseconds each. */
  partsOfPicture = 1;
  partCost = 0;
  parts = 0;
  #callbacks = new Map<number, (now: number) => void>();
  #handles = 0;
  readonly loop: FrameLoop;

  /**
   * Grows until its last tick; with rounds, it is then made into rivers, which meander for that many. Before that the sea
   * rises in some steps.
   */
  constructor(
    readonly lastTick = 600,
    readonly meanders?: number,
    readonly rises = 0,
    waitMs?: number,
  ) {
    const frames = {
      waitMs,
      now: () => this.time,
      request: (callback: (now: number) => void) => {
        this.#callbacks.set(++this.#handles, callback);
        return this.#handles;
      },
      cancel: (handle: number) => void this.#callbacks.delete(handle),
    };
    this.loop = new FrameLoop(this, frames, {
      draw: (asDraft) => {
        this.time += this.partCost;
        if (++this.parts < this.partsOfPicture) return true;
        this.parts = 0;
        this.drawn.push(this.ticks);
        this.phases.push(this.phase);
        this.drafts.push(asDraft);
        return false;
      },
      ready: () => void this.ready++,
      changed: (state) => void this.states.push(state),
      failed: (error) => void this.failures.push(error),
    });
  }

  get phase(): Phase {
    const risen = this.lastTick + this.rises;
    if (this.ticks < this.lastTick) return "growing";
    if (this.ticks < risen) return "drowning";
    if (this.meanders === undefined || this.ticks > risen + this.meanders) return "finished";
    return this.ticks === risen ? "shaping" : "meandering";
  }

  get progress(): number {
    if (this.phase === "growing") return this.ticks / this.lastTick;
    if (this.phase === "drowning") return (this.ticks - this.lastTick) / this.rises;
    return this.phase === "meandering" ? (this.ticks - this.lastTick - this.rises - 1) / this.rounds : 0;
  }

  get rounds(): number {
    return this.meanders ?? 0;
  }

  advance(ticks: number): boolean {
    expect(this.phase).not.toBe("finished");
    this.ticks += ticks;
    this.time += this.cost;
    return this.phase !== "finished";
  }

  restart(): void {
    this.ticks = 0;
    this.restarts++;
  }

  get waiting(): number {
    return this.#callbacks.size;
  }

  /** Frames at a steady rate; a frame that works longer than its time makes the next one late. */
  frames(count: number, everyMs = 1000 / 60): void {
    for (let i = 0; i < count; i++) {
      const due = this.time + everyMs;
      const callbacks = [...this.#callbacks.values()];
      this.#callbacks.clear();
      for (const callback of callbacks) callback(this.time);
      this.time = Math.max(this.time, due);
    }
  }
}

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
