import { expect, test, vi } from "vitest";
import { PageError } from "../../../src/engine/errors.ts";
import type { River } from "../../../src/engine/types.ts";
import type { Opening, Report } from "../../../src/host/protocol.ts";
import { type Makers, Scene } from "../../../src/host/scene.ts";
import type { Frames } from "../../../src/player/frame-loop.ts";
import type { Canvas } from "../../../src/player/river-player.ts";
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

const MAKER = { engine, memory };

/** A scene with the river of a seed, and what it reports. */
function opened(
  seed: string,
  how: Opening["how"],
  makers: Makers<River> = { makerFor: () => MAKER },
): { scene: Scene; display: Display; reports: Report<never>[] } {
  vi.stubGlobal("ImageData", Image);
  const display = new Display();
  const reports: Report<never>[] = [];
  const opening: Opening = { id: 1, do: "open", canvas: canvas(), link: link(seed), how, size: SIZE };
  const scene = new Scene(makers, display, opening, (told) => reports.push(told));
  return { scene, display, reports };
}

const SIZE = { width: 20, height: 20, ratio: 1 };
const link = (seed: string) => ({ text: `seed=${seed}&attractors=300` });
const show = (seed: string, text = link(seed).text) =>
  ({ id: 1, do: "show", link: { text }, how: "watch", size: SIZE }) as const;

test("what is told of a river is told of that river, though another waits to take its place", () => {
  const { scene, display, reports } = opened("one", "watch");
  scene.open();
  for (let i = 0; i < 3; i++) display.frame();
  scene.take(show("two"));
  for (let i = 0; i < 3; i++) display.frame();
  scene.take(show("three"));
  // So long that the river is told of, before it gives way in the same frame.
  display.frame(300);
  expect(reports.at(-1)).toMatchObject({ is: "shown", reading: { seed: "two", links: 1 } });
  for (let i = 0; i < 3; i++) display.frame(300);
  expect(reports.at(-1)).toMatchObject({ is: "shown", reading: { seed: "three", links: 2 } });
});

test("a link of the same picture is told of, too: whoever asked for it waits for word", () => {
  const { scene, display, reports } = opened("one", "still");
  scene.open();
  for (let i = 0; i < 100; i++) display.frame();
  expect(reports.at(-1)).toMatchObject({ state: "finished", reading: { links: 0 } });
  scene.take(show("one"));
  display.frame();
  expect(reports.at(-1)).toMatchObject({ state: "finished", reading: { links: 1 } });
});

test("a link that fails is told of by its number, and the river that was there stays", () => {
  const { scene, display, reports } = opened("one", "still");
  scene.open();
  for (let i = 0; i < 100; i++) display.frame();
  const river = scene.player?.river;
  if (!river) throw new Error("there is no river");
  const change = river.change.bind(river);
  river.change = () => {
    throw Object.assign(new Error("needs 3 GB"), { code: "too-large" });
  };
  scene.take(show("two"));
  display.frame();
  expect(reports.at(-1)).toEqual({ id: 1, is: "failed", code: "too-large", message: "needs 3 GB", links: 1 });
  river.change = change;
  scene.take(show("three"));
  for (let i = 0; i < 3; i++) display.frame();
  expect(reports.at(-1)).toMatchObject({ is: "shown", reading: { seed: "three", links: 2 } });
});

test("a link for another engine waits until that is there, with all that follows it, and the river is then of that", async () => {
  let arrive = (_: typeof MAKER): void => {};
  const coming = new Promise<typeof MAKER>((done) => {
    arrive = done;
  });
  const other = { ...MAKER };
  const makerFor: Makers<River>["makerFor"] = ({ text }, now) => (text.includes("two") ? coming : (now ?? MAKER));
  const { scene, display, reports } = opened("one", "still", { makerFor });
  scene.open();
  for (let i = 0; i < 100; i++) display.frame();
  const before = scene.player?.river;
  scene.take(show("two"));
  scene.take({ id: 1, do: "pause" });
  scene.take(show("three"));
  for (let i = 0; i < 3; i++) display.frame();
  expect(reports.at(-1)).toMatchObject({ is: "shown", reading: { seed: "one", links: 0 } });
  arrive(other);
  await coming;
  await Promise.resolve();
  for (let i = 0; i < 3; i++) display.frame(300);
  expect(reports.at(-1)).toMatchObject({ is: "shown", reading: { seed: "three", links: 2 } });
  expect(() => before?.phase).toThrow();
});

test("an engine that does not come is a failure of the link that asked for it", async () => {
  const makerFor: Makers<River>["makerFor"] = ({ text }) =>
    text.includes("two") ? Promise.reject(new PageError("file-missing", "gone")) : MAKER;
  const { scene, display, reports } = opened("one", "still", { makerFor });
  scene.open();
  for (let i = 0; i < 100; i++) display.frame();
  scene.take(show("two"));
  await Promise.resolve();
  await Promise.resolve();
  expect(reports.at(-1)).toEqual({ id: 1, is: "failed", code: "file-missing", message: "gone", links: 1 });
});

test("a river whose letters do not hold goes on in an engine that has names, as the same link", async () => {
  const letters = "none of this map";
  const other = { ...MAKER };
  const asked: (string | undefined)[] = [];
  const makerFor: Makers<River>["makerFor"] = (link, now) => {
    asked.push(link.letters);
    return link.letters ? (now ?? MAKER) : other;
  };
  const { scene, display, reports } = opened("one", "still", { makerFor });
  scene.open();
  for (let i = 0; i < 100; i++) display.frame();
  const river = scene.player?.river;
  if (!river) throw new Error("there is no river");
  // As in an engine without names.
  river.takeLetters = () => false;
  scene.take({ ...show("two"), link: { text: "seed=two&attractors=100&labels=none", letters } });
  for (let i = 0; i < 3; i++) display.frame();
  await Promise.resolve();
  await Promise.resolve();
  for (let i = 0; i < 100; i++) display.frame(300);
  expect(asked.slice(-2)).toEqual([letters, ""]);
  expect(reports.at(-1)).toMatchObject({ is: "shown", state: "finished", reading: { seed: "two", links: 1 } });
  expect(() => river.phase).toThrow();
});

test("what comes before the river is created is done afterwards, in its order", () => {
  const { scene, display, reports } = opened("one", "watch");
  scene.take({ id: 1, do: "speed", speed: 2 });
  scene.take({ id: 1, do: "toggle" });
  scene.open();
  display.frame();
  expect(reports.at(-1)).toMatchObject({ state: "paused", phase: "growing" });
  scene.take({ id: 1, do: "toggle" });
  expect(reports.at(-1)).toMatchObject({ state: "growing" });
});

for (const [code, freed] of [
  ["no-memory", 1],
  ["too-large", 1],
  ["panic", 0],
] as const) {
  test(`a closed scene gives the river's memory back after ${code}: ${freed === 1}`, () => {
    const { scene, display, reports } = opened("one", "watch");
    scene.open();
    display.frame();
    const river = scene.player?.river;
    if (!river) throw new Error("there is no river");
    const free = vi.spyOn(river, "free");
    const advance = vi.spyOn(river, "advance").mockImplementation(() => {
      if (code === "panic") throw new WebAssembly.RuntimeError("unreachable");
      throw Object.assign(new Error("no room"), { code });
    });
    for (let i = 0; i < 3; i++) display.frame();
    expect(reports.at(-1)).toMatchObject({ is: "failed", code });
    expect(free.mock.calls.length).toBe(0);
    const calls = advance.mock.calls.length;
    expect(scene.player?.river === undefined).toBe(code !== "too-large");
    scene.take({ id: 1, do: "close" });
    scene.take({ id: 1, do: "close" });
    for (let i = 0; i < 3; i++) display.frame();
    expect([free.mock.calls.length, advance.mock.calls.length]).toEqual([freed, calls]);
  });
}

test("after a failure in a frame that follows a link, no frame asks anything more of the river", () => {
  const { scene, display, reports } = opened("one", "settle");
  scene.open();
  const river = scene.player?.river;
  if (!river) throw new Error("there is no river");
  vi.spyOn(river, "change").mockImplementation(() => {
    throw new WebAssembly.RuntimeError("unreachable");
  });
  const advance = vi.spyOn(river, "advance");
  scene.take({ ...show("two"), how: "settle" });
  for (let i = 0; i < 100 && reports.at(-1)?.is !== "failed"; i++) display.frame();
  expect(reports.at(-1)).toMatchObject({ is: "failed", code: "panic" });
  const calls = advance.mock.calls.length;
  for (let i = 0; i < 50; i++) display.frame();
  expect(advance.mock.calls.length).toBe(calls);
  expect(reports.filter(({ is }) => is === "failed").length).toBe(1);
});
