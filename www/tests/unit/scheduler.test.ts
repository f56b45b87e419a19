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
