import { expect, test } from "vitest";
import { TURNS_MS, Turns } from "../../src/player/frames.ts";

/** A display whose frames come when a test says so, and a clock that only work moves. */
function stage(): { turns: Turns; frame: () => void; asked: () => number; work: (ms: number) => void } {
  let time = 0;
  let callbacks: ((now: number) => void)[] = [];
  const turns = new Turns({
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
  return { turns, frame, asked: () => callbacks.length, work };
}

test("rivers that ask in one frame share the next", () => {
  const { turns, frame, asked } = stage();
  const done: string[] = [];
  for (const name of ["a", "b", "c"]) turns.request(() => done.push(name));
  expect(asked()).toBe(1);
  frame();
  expect(done).toEqual(["a", "b", "c"]);
  expect(asked()).toBe(0);
});

test("those that do not fit come first in the frame after, so that nobody starves", () => {
  const { turns, frame, work } = stage();
  const done: string[] = [];
  const grow = (name: string): void => {
    turns.request(() => {
      done.push(name);
      work(TURNS_MS / 2);
      grow(name);
    });
  };
  for (const name of ["a", "b", "c"]) grow(name);
  for (let i = 0; i < 3; i++) frame();
  expect(done).toEqual(["a", "b", "c", "a", "b", "c"]);
});

test("who asks in a frame gets the next, however much time there is", () => {
  const { turns, frame } = stage();
  let times = 0;
  const again = (): void => {
    times++;
    turns.request(again);
  };
  turns.request(again);
  frame();
  expect(times).toBe(1);
  frame();
  expect(times).toBe(2);
});

test("what is cancelled does not come", () => {
  const { turns, frame } = stage();
  let times = 0;
  turns.cancel(turns.request(() => times++));
  frame();
  expect(times).toBe(0);
});
