import { expect, test, vi } from "vitest";
import type { Frames } from "../../../src/player/frame-loop.ts";
import type { Canvas } from "../../../src/player/river-player.ts";
import type { Report } from "../../../src/widget/protocol.ts";
import { Scene } from "../../../src/widget/scene.ts";
import { charts } from "../../charts.ts";
import { engine, memory } from "../../core.ts";
import { Image } from "../../display.ts";

/** A display whose frames come when a test asks for them. */
class Display implements Frames {
  #time = 0;
  #last = 0;
  #waiting = new Map<number, (now: number) => void>();

  now(): number {
    return this.#time;
  }

  request(callback: (now: number) => void): number {
    this.#waiting.set(++this.#last, callback);
    return this.#last;
  }

  cancel(handle: number): void {
    this.#waiting.delete(handle);
  }

  frame(ms = 16): void {
    this.#time += ms;
    const due = [...this.#waiting.values()];
    this.#waiting.clear();
    for (const callback of due) callback(this.#time);
  }
}

/** A canvas without pixels: these tests are about words. */
function canvas(): Canvas {
  return { width: 0, height: 0, getContext: () => ({ putImageData: () => {} }) } as unknown as Canvas;
}

test("what is told of a river is told of that river, though another waits to take its place", () => {
  vi.stubGlobal("ImageData", Image);
  const display = new Display();
  const reports: Report[] = [];
  const request = (seed: string) => ({ text: `seed=${seed}&attractors=300`, isDark: false });
  const [how, size] = ["watch", { width: 20, height: 20, ratio: 1 }] as const;
  const opening = { id: 1, do: "open", canvas: canvas(), request: request("one"), how, size } as const;
  const scene = new Scene(
    { engine, memory },
    () => Promise.resolve(charts),
    display,
    opening,
    (told) => reports.push(told),
  );
  for (let i = 0; i < 3; i++) display.frame();
  scene.take({ id: 1, do: "show", request: request("two"), how, size });
  for (let i = 0; i < 3; i++) display.frame();
  scene.take({ id: 1, do: "show", request: request("three"), how, size });
  // So long that the river is told of, before it gives way in the same frame.
  display.frame(300);
  expect(reports.at(-1)).toMatchObject({ is: "shown", reading: { seed: "two" } });
  for (let i = 0; i < 3; i++) display.frame(300);
  expect(reports.at(-1)).toMatchObject({ is: "shown", reading: { seed: "three" } });
});
