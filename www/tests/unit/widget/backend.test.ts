import { afterEach, beforeEach, expect, type Mock, test, vi } from "vitest";
import type { Question } from "../../../src/apps/widget/protocol.ts";
import { PAINTING_SILENCE_MS, WORKER_SILENCE_MS } from "../../../src/engine/time-limits.ts";
import type { Backend as AnyBackend, Command } from "../../../src/host/protocol.ts";
import type { Listener as AnyListener } from "../../../src/host/worker-backend.ts";

type Backend = AnyBackend<Question>;
type Listener = AnyListener<Blob>;

const HERE: Backend = { isReplaceable: false, take: () => {}, close: () => {} };
vi.mock("../../../src/apps/widget/page-backend.ts", () => ({ open: async () => HERE }));

/** A worker that does what a test says. */
class StandIn {
  static readonly all: StandIn[] = [];
  onmessage: (message: { data: unknown }) => void = () => {};
  onerror: () => void = () => {};
  readonly heard: { do?: string; id?: number }[] = [];
  isOver = false;

  constructor() {
    StandIn.all.push(this);
  }

  postMessage(message: object): void {
    this.heard.push(message);
  }

  terminate(): void {
    this.isOver = true;
  }

  says(data: object): void {
    this.onmessage({ data });
  }

  get pings(): number {
    return this.heard.filter((message) => message.do === "ping").length;
  }
}

class Canvas {
  transferControlToOffscreen(): void {}
}

beforeEach(() => {
  vi.useFakeTimers({ toFake: ["setInterval", "clearInterval"] });
  vi.stubGlobal("Worker", StandIn);
  vi.stubGlobal("HTMLCanvasElement", Canvas);
  StandIn.all.length = 0;
  // It remembers how many workers were lost.
  vi.resetModules();
});

afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

const INIT = { wasmUrl: undefined, link: { text: "" } };
const PAUSE: Command<Question> = { id: 1, do: "pause" };

function listener(): Record<keyof Listener, Mock<() => void>> {
  return { tell: vi.fn(), collapsed: vi.fn(), lost: vi.fn() };
}

/** Begins to open a backend; its worker says nothing yet. */
async function begin(to: Listener = listener()): Promise<{ backend: Promise<Backend>; worker: StandIn }> {
  const { openBackend } = await import("../../../src/apps/widget/backend.ts");
  const backend = openBackend(to, INIT);
  const worker = StandIn.all.at(-1);
  if (!worker) throw new Error("no worker was tried");
  return { backend, worker };
}

async function open(to?: Listener): Promise<{ backend: Backend; worker: StandIn }> {
  const { backend, worker } = await begin(to);
  worker.says({ is: "open" });
  return { backend: await backend, worker };
}

test("a worker that says nothing is ended, and the page itself takes its place", async () => {
  const { backend, worker } = await begin();
  vi.advanceTimersByTime(WORKER_SILENCE_MS - 1);
  expect(worker.isOver).toBe(false);
  vi.advanceTimersByTime(1);
  expect(await backend).toBe(HERE);
  expect(worker.isOver).toBe(true);
});

test("a worker whose engine is coming slowly is waited for", async () => {
  const { backend, worker } = await begin();
  for (let i = 0; i < 20; i++) {
    vi.advanceTimersByTime(WORKER_SILENCE_MS - 1000);
    worker.says({ is: "coming" });
  }
  worker.says({ is: "open" });
  expect(await backend).not.toBe(HERE);
  expect(vi.getTimerCount()).toBe(0);
});

test("a worker that has its engine and then works without a word is asked, and kept while it answers", async () => {
  const to = listener();
  const { backend, worker } = await open(to);
  backend.take(PAUSE);
  for (let i = 0; i < 20; i++) {
    vi.advanceTimersByTime(WORKER_SILENCE_MS - 1000);
    worker.says({ is: "alive", isAtWork: true, id: 1 });
  }
  expect(to.lost).not.toHaveBeenCalled();
  expect(to.tell).not.toHaveBeenCalled();
  expect(worker.pings).toBeGreaterThan(20);
});

/** What a worker says before it paints a picture for a file. */
const PAINTING = { id: 0, is: "alive", isAtWork: true, silenceMs: PAINTING_SILENCE_MS };

test("a worker that paints a picture for a file is given longer, once", async () => {
  const to = listener();
  const { backend, worker } = await open(to);
  backend.take(PAUSE);
  worker.says(PAINTING);
  vi.advanceTimersByTime(PAINTING_SILENCE_MS - 1000);
  expect(to.lost).not.toHaveBeenCalled();
  expect(to.tell).not.toHaveBeenCalled();
  worker.says({ is: "alive", isAtWork: true, id: 1 });
  vi.advanceTimersByTime(WORKER_SILENCE_MS - 1000);
  expect(to.lost).not.toHaveBeenCalled();
  vi.advanceTimersByTime(1000);
  expect(to.lost).toHaveBeenCalledTimes(1);
});

test("a worker that never comes back from painting is told of", async () => {
  const to = listener();
  const { backend, worker } = await open(to);
  backend.take(PAUSE);
  worker.says(PAINTING);
  vi.advanceTimersByTime(PAINTING_SILENCE_MS);
  expect(to.lost).toHaveBeenCalledTimes(1);
});

test("a worker that answers no more is told of once", async () => {
  const to = listener();
  const { backend, worker } = await open(to);
  backend.take(PAUSE);
  vi.advanceTimersByTime(WORKER_SILENCE_MS - 1);
  expect(to.lost).not.toHaveBeenCalled();
  vi.advanceTimersByTime(10 * WORKER_SILENCE_MS);
  expect(to.lost).toHaveBeenCalledTimes(1);
  expect(worker.pings).toBe(9);
});

test("a worker with nothing to do is left alone, until there is another command", async () => {
  const to = listener();
  const { backend, worker } = await open(to);
  vi.advanceTimersByTime(60_000);
  expect(worker.pings).toBe(0);
  backend.take(PAUSE);
  vi.advanceTimersByTime(1000);
  worker.says({ is: "alive", isAtWork: false, id: 1 });
  vi.advanceTimersByTime(60_000);
  expect(worker.pings).toBe(1);
  expect(to.lost).not.toHaveBeenCalled();
  backend.take(PAUSE);
  vi.advanceTimersByTime(WORKER_SILENCE_MS);
  expect(to.lost).toHaveBeenCalledTimes(1);
});

test("an answer from before the last command does not count as one to it", async () => {
  const to = listener();
  const { backend, worker } = await open(to);
  backend.take(PAUSE);
  vi.advanceTimersByTime(1000);
  backend.take(PAUSE);
  worker.says({ is: "alive", isAtWork: false, id: 1 });
  vi.advanceTimersByTime(WORKER_SILENCE_MS);
  expect(to.lost).toHaveBeenCalledTimes(1);
});

test("a backend that was closed is not missed", async () => {
  const to = listener();
  const { backend, worker } = await open(to);
  backend.take(PAUSE);
  backend.close();
  vi.advanceTimersByTime(60_000);
  expect(to.lost).not.toHaveBeenCalled();
  expect(worker.isOver).toBe(true);
});

test("after two workers that did not answer no third is tried", async () => {
  for (let i = 0; i < 2; i++) {
    const { backend } = await open();
    backend.take(PAUSE);
    vi.advanceTimersByTime(WORKER_SILENCE_MS);
  }
  const { openBackend } = await import("../../../src/apps/widget/backend.ts");
  expect(await openBackend(listener(), INIT)).toBe(HERE);
  expect(StandIn.all).toHaveLength(2);
});
