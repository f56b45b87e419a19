import { expect, test } from "vitest";
import type { Phase } from "../../pkg-make/riverseed.js";
import { FrameLoop, type Growing } from "../../src/player/frame-loop.ts";
import { SharedClock } from "../../src/player/shared-clock.ts";

/** Grows for so many ticks, then is made into rivers in so many steps. */
class Stand implements Growing {
  ticks = 0;
  steps = 0;
  readonly rounds = 0;

  constructor(
    readonly last: number,
    readonly shaping = 2,
  ) {}

  get phase(): Phase {
    return this.ticks < this.last ? "growing" : this.steps < this.shaping ? "shaping" : "finished";
  }

  get progress(): number {
    return this.phase === "growing" ? this.ticks / this.last : 0;
  }

  advance(steps: number): boolean {
    for (let i = 0; i < steps; i++) {
      if (this.phase === "growing") this.ticks++;
      else this.steps++;
    }
    return this.phase !== "finished";
  }

  restart(): void {
    this.ticks = this.steps = 0;
  }
}

/** What frame loops of rivers on one clock draw, frame by frame; a step takes as long as is said. */
class Display {
  #time = 0;
  #waiting = new Map<number, (now: number) => void>();
  #last = 0;
  readonly drawn = new Map<Stand, number>();

  constructor(readonly cost = 0) {}

  loop(river: Stand, clock: SharedClock): FrameLoop {
    const advance = river.advance.bind(river);
    river.advance = (steps) => {
      this.#time += this.cost;
      return advance(steps);
    };
    const frames = {
      now: () => this.#time,
      request: (callback: (now: number) => void) => {
        this.#waiting.set(++this.#last, callback);
        return this.#last;
      },
      cancel: (handle: number) => void this.#waiting.delete(handle),
    };
    const draw = (): boolean => {
      this.drawn.set(river, river.ticks);
      return false;
    };
    const failed = (error: unknown): void => {
      throw error;
    };
    return new FrameLoop(clock.join(river), frames, { draw, ready: () => {}, changed: () => {}, failed });
  }

  frame(): void {
    this.#time += 16;
    const due = [...this.#waiting.values()];
    this.#waiting.clear();
    for (const callback of due) callback(this.#time);
  }
}

function sixOn(display: Display): { rivers: Stand[]; loops: FrameLoop[] } {
  const clock = new SharedClock();
  const rivers = [90, 40, 200, 90, 40, 200].map((last) => new Stand(last));
  return { rivers, loops: rivers.map((river) => display.loop(river, clock)) };
}

/** The ticks that were drawn of the rivers that still grow. */
function growing(display: Display, rivers: readonly Stand[]): Set<number | undefined> {
  return new Set(rivers.filter(({ phase }) => phase === "growing").map((river) => display.drawn.get(river)));
}

/** After long steps a loop paints in the next frame, and where one is done with growing, the next moves the clock in the same. */
for (const [cost, apart] of [
  [0, 0],
  [3, 0],
  [40, 2],
] as const) {
  test(`each frame shows all rivers at the same tick, until each ends at its own: steps of ${cost} ms`, () => {
    const display = new Display(cost);
    const { rivers, loops } = sixOn(display);
    for (const loop of loops) loop.watch();
    let frames = 0;
    for (; loops.some(({ state }) => state !== "finished") && frames < 5000; frames++) {
      display.frame();
      const ticks = [...growing(display, rivers)].map((tick) => tick ?? 0);
      expect(Math.max(0, ...ticks) - Math.min(1e9, ...ticks)).toBeLessThanOrEqual(apart);
    }
    expect(rivers.map(({ ticks, last }) => ticks - last)).toEqual([0, 0, 0, 0, 0, 0]);
    expect(loops.map(({ state }) => state)).toEqual(Array(6).fill("finished"));
    expect(frames).toBeGreaterThan(50);
  });
}

test("a pause holds all at one tick, however the commands come, and they go on together", () => {
  const display = new Display();
  const { rivers, loops } = sixOn(display);
  for (const loop of loops) loop.watch();
  for (let i = 0; i < 5; i++) display.frame();
  for (const loop of loops) {
    loop.pause();
    display.frame();
  }
  expect(growing(display, rivers).size).toBe(1);
  const [held] = growing(display, rivers);
  for (let i = 0; i < 5; i++) display.frame();
  expect(growing(display, rivers)).toEqual(new Set([held]));
  for (const loop of loops) {
    loop.play();
    display.frame();
  }
  expect(growing(display, rivers).size).toBe(1);
  expect([...growing(display, rivers)][0]).toBeGreaterThan(held ?? 0);
});

test("one that comes late, or begins again, catches up", () => {
  const display = new Display();
  const clock = new SharedClock();
  const [first, second] = [new Stand(500), new Stand(500)];
  display.loop(first, clock).watch();
  for (let i = 0; i < 10; i++) display.frame();
  expect(first.ticks).toBeGreaterThan(10);
  const late = display.loop(second, clock);
  late.watch();
  for (let i = 0; i < 10; i++) display.frame();
  expect(second.ticks).toBe(first.ticks);
  late.replay();
  expect(second.ticks).toBe(0);
  for (let i = 0; i < 60; i++) display.frame();
  expect(second.ticks).toBe(first.ticks);
});

test("those that stay go on when the first leaves", () => {
  const clock = new SharedClock();
  const [first, second] = [new Stand(10), new Stand(10)];
  const [member, other] = [clock.join(first), clock.join(second)];
  expect(other.advance(1)).toBe(false);
  clock.leave(member);
  expect(other.advance(1)).toBe(true);
  expect([first.ticks, second.ticks]).toEqual([0, 1]);
});

test("a river that fails leaves the clock: its own loop is told, and the others go on", () => {
  const clock = new SharedClock();
  const [first, failing, third] = [new Stand(10), new Stand(10), new Stand(10)];
  const failure = new Error("no room");
  failing.advance = () => {
    if (failing.ticks++ === 2) throw failure;
    return true;
  };
  const [one, two, three] = [first, failing, third].map((river) => clock.join(river));
  if (!one || !two || !three) throw new Error("no members");
  for (let i = 0; i < 5; i++) expect(one.advance(1)).toBe(true);
  expect([first.ticks, third.ticks]).toEqual([5, 5]);
  // It is due whatever its progress: its loop is to hear of it soon.
  expect(two.progress).toBe(0);
  expect(() => two.advance(1)).toThrow(failure);
  expect(three.advance(1)).toBe(false);
  clock.leave(one);
  expect(three.advance(1)).toBe(true);
  expect(third.ticks).toBe(6);
});

test("the river that moves the clock fails in its own step, and the next moves the clock", () => {
  const clock = new SharedClock();
  const [failing, second] = [new Stand(10), new Stand(10)];
  failing.advance = () => {
    throw new Error("no room");
  };
  const [one, two] = [clock.join(failing), clock.join(second)];
  expect(() => one.advance(1)).toThrow("no room");
  expect(second.ticks).toBe(1);
  expect(two.advance(1)).toBe(true);
  expect(second.ticks).toBe(2);
});
