import { expect, test } from "vitest";
import { SHARE_MS, SharedScheduler } from "../../src/player/scheduler.ts";

/** A display whose frames come when a test says so, and a clock that only work moves. */
function stage(): { scheduler: SharedScheduler; frame: () => void; asked: () => number; work: (ms: number) => void } {
  let time = 0;
  let callbacks: ((now: number) => void)[] = [];
  const scheduler = new SharedScheduler({
    now: () => time,
    request: (callback) => callbacks.push(callback),
    cancel: () => {},
  });
  const frame = (): void => {
    const due = callbacks;
    callbacks = [];
    for (const callback of due) callback(time);
  };
  const work = (ms: number): void => {
    time += ms;
  };
  return { scheduler, frame, asked: () => callbacks.length, work };
}

test("rivers that ask in one frame share the next", () => {
  const { scheduler, frame, asked } = stage();
  const done: string[] = [];
  for (const name of ["a", "b", "c"]) scheduler.request(() => done.push(name));
  expect(asked()).toBe(1);
  frame();
  expect(done).toEqual(["a", "b", "c"]);
  expect(asked()).toBe(0);
});

test("those that do not fit come first in the frame after, so that nobody starves", () => {
  const { scheduler, frame, work } = stage();
  const done: string[] = [];
  const grow = (name: string): void => {
    scheduler.request(() => {
      done.push(name);
      work(SHARE_MS / 2);
      grow(name);
    });
  };
  for (const name of ["a", "b", "c"]) grow(name);
  for (let i = 0; i < 3; i++) frame();
  expect(done).toEqual(["a", "b", "c", "a", "b", "c"]);
});

test("who asks in a frame gets the next, however much time there is", () => {
  const { scheduler, frame } = stage();
  let times = 0;
  const again = (): void => {
    times++;
    scheduler.request(again);
  };
  scheduler.request(again);
  frame();
  expect(times).toBe(1);
  frame();
  expect(times).toBe(2);
});

test("what is cancelled does not come", () => {
  const { scheduler, frame } = stage();
  let times = 0;
  scheduler.cancel(scheduler.request(() => times++));
  frame();
  expect(times).toBe(0);
});

test("rivers out of sight come after those in sight, and have one turn in a full frame", () => {
  const { scheduler, frame, work } = stage();
  const done: string[] = [];
  const grow = (name: string, isUnseen: boolean): void => {
    scheduler.request(() => {
      done.push(name);
      work(SHARE_MS / 2);
      grow(name, isUnseen);
    }, isUnseen);
  };
  for (const name of ["past", "past later"]) grow(name, true);
  for (const name of ["a", "b"]) grow(name, false);
  frame();
  frame();
  expect(done).toEqual(["a", "b", "past later", "a", "b", "past later"]);
});

test("of rivers out of sight one is finished after the other, the last first", () => {
  const { scheduler, frame, work } = stage();
  const done: string[] = [];
  const grow = (name: string, turns: number): void => {
    scheduler.request(() => {
      done.push(name);
      work(SHARE_MS);
      if (turns > 1) grow(name, turns - 1);
    }, true);
  };
  for (const name of ["first", "last"]) grow(name, 2);
  for (let i = 0; i < 4; i++) frame();
  expect(done).toEqual(["last", "last", "first", "first"]);
  expect(scheduler.isAwaited).toBe(false);
});

test("what is cancelled by one before it in the same frame does not come", () => {
  const { scheduler, frame } = stage();
  let times = 0;
  scheduler.request(() => scheduler.cancel(handle));
  const handle = scheduler.request(() => times++);
  frame();
  expect(times).toBe(0);
});
