import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { WORKER_SILENCE_MS } from "../../../src/engine/time-limits.ts";

/** The engine, which comes when a test says so. */
let arrive: { module: (module: object) => void; core: (core: object) => void; fail: (error: Error) => void };
let loading: Promise<object> | undefined;
vi.mock("../../../src/engine/whole.ts", () => {
  const loadWhole = (_url?: string, compiled?: (module: object) => void): Promise<object> => {
    loading ??= new Promise((core, fail) => {
      arrive = { module: (module) => compiled?.(module), core, fail };
    });
    return loading;
  };
  return { loadWhole };
});

const opened: object[] = [];
vi.mock("../../../src/apps/page-worker/page-backend.ts", () => ({
  open: (core: object) => {
    opened.push(core);
    return { isReplaceable: false, take: () => {}, close: () => {} };
  },
}));

class StandIn extends EventTarget {
  static readonly all: StandIn[] = [];
  onmessage: (message: { data: unknown }) => void = () => {};
  onerror: (error: { message: string }) => void = () => {};
  readonly heard: object[] = [];
  isOver = false;

  constructor() {
    super();
    StandIn.all.push(this);
  }

  postMessage(message: object): void {
    this.heard.push(message);
  }

  terminate(): void {
    this.isOver = true;
  }

  says(data: object): void {
    this.dispatchEvent(Object.assign(new Event("message"), { data }));
    this.onmessage({ data });
  }
}

beforeEach(() => {
  vi.stubGlobal("Worker", StandIn);
  vi.stubGlobal(
    "HTMLCanvasElement",
    class {
      transferControlToOffscreen(): void {}
    },
  );
  forget();
});

function forget(): void {
  StandIn.all.length = opened.length = 0;
  loading = undefined;
  vi.resetModules();
}

afterEach(() => vi.unstubAllGlobals());

async function open() {
  const { openEngines } = await import("../../../src/apps/page/backend.ts");
  return openEngines();
}

const turns = (): Promise<void> => new Promise((done) => setImmediate(done));
const client = () => ({ hear: vi.fn(), moved: vi.fn() });

test("the worker is asked for before the engine has come, and is handed what the page has compiled", async () => {
  const { renderHost } = await open();
  const [worker] = StandIn.all;
  expect(worker?.heard).toEqual([]);
  const module = { compiled: true };
  arrive.module(module);
  await turns();
  expect(worker?.heard).toEqual([{ engine: module }]);
  // It is not waited for: what comes before it is open waits there.
  const id = await renderHost.enter(client());
  renderHost.send(id, { do: "toggle" });
  await turns();
  expect(worker?.heard.at(-1)).toEqual({ id, do: "toggle" });
  expect(StandIn.all.length).toBe(1);
  expect(opened).toEqual([]);
});

test("where a worker is refused before the engine has come, the page's own engine is used", async () => {
  const { renderHost } = await open();
  const [worker] = StandIn.all;
  worker?.onerror({ message: "" });
  await turns();
  arrive.module({});
  const core = { engine: "the page's own" };
  arrive.core(core);
  await renderHost.enter(client());
  expect(opened).toEqual([core]);
  expect(worker?.isOver).toBe(true);
});

for (const [how, refuse] of [
  ["by an error", (worker?: StandIn) => worker?.onerror({ message: "" })],
  ["because it cannot start the engine", (worker?: StandIn) => worker?.says({ is: "shut" })],
] as const) {
  test(`a worker that is refused later, ${how}, gives its rivers to the page, and no other is tried`, async () => {
    const { renderHost } = await open();
    const [worker] = StandIn.all;
    arrive.module({});
    const core = { engine: "the page's own" };
    arrive.core(core);
    const river = client();
    await renderHost.enter(river);
    refuse(worker);
    await turns();
    expect([worker?.isOver, river.moved.mock.calls.length, river.hear.mock.calls.length]).toEqual([true, 1, 0]);
    await renderHost.enter(river);
    expect(opened).toEqual([core]);
    expect(StandIn.all.length).toBe(1);
  });
}

test("an open worker that stops with an error stops its rivers", async () => {
  const { renderHost } = await open();
  const [worker] = StandIn.all;
  arrive.module({});
  const river = client();
  await renderHost.enter(river);
  worker?.says({ is: "open" });
  worker?.onerror({ message: "stopped" });
  expect(river.hear).toHaveBeenCalledWith(expect.objectContaining({ is: "failed", code: "panic" }));
});

test("a worker that does not answer is replaced once, and then the page takes over", async () => {
  const { renderHost } = await open();
  arrive.module({});
  arrive.core({});
  vi.useFakeTimers({ toFake: ["setInterval", "clearInterval"] });
  for (const workers of [1, 2]) {
    const river = client();
    renderHost.send(await renderHost.enter(river), { do: "toggle" });
    await turns();
    expect(StandIn.all.length).toBe(workers);
    vi.advanceTimersByTime(WORKER_SILENCE_MS);
    expect(river.moved).toHaveBeenCalledTimes(1);
  }
  vi.useRealTimers();
  await renderHost.enter(client());
  expect(StandIn.all.length).toBe(2);
  expect(opened.length).toBe(1);
});

test("an engine that does not come leaves no worker behind, and whoever shows a river is told", async () => {
  const { core, renderHost } = await open();
  arrive.fail(new Error("offline"));
  await expect(core).rejects.toThrow("offline");
  await expect(renderHost.enter(client())).rejects.toThrow("offline");
  expect(StandIn.all.every(({ isOver }) => isOver)).toBe(true);
});
