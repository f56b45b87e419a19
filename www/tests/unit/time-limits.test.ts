import { readFileSync } from "node:fs";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { DOWNLOAD_SILENCE_MS, limited, watch } from "../../src/engine/time-limits.ts";
import { start } from "../../src/engine/wasm-module.ts";

// Only what the watch counts with: streams and promises go on by themselves.
beforeEach(() => void vi.useFakeTimers({ toFake: ["setInterval", "clearInterval"] }));
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

/** Lets streams and promises do what they can do without more time. */
async function settle(): Promise<void> {
  for (let i = 0; i < 20; i++) await new Promise((resume) => setImmediate(resume));
}

test("silence is told of once, after its time and not before", () => {
  const silent = vi.fn();
  watch(10_000, silent);
  vi.advanceTimersByTime(9_999);
  expect(silent).not.toHaveBeenCalled();
  vi.advanceTimersByTime(60_000);
  expect(silent).toHaveBeenCalledTimes(1);
});

test("whatever is heard puts the end off, and an ended watch tells nothing", () => {
  const silent = vi.fn();
  const { heard, end } = watch(10_000, silent);
  for (let i = 0; i < 20; i++) {
    vi.advanceTimersByTime(9_000);
    heard();
  }
  expect(silent).not.toHaveBeenCalled();
  end();
  vi.advanceTimersByTime(60_000);
  expect(silent).not.toHaveBeenCalled();
});

test("it asks every second until it is over", () => {
  const asks = vi.fn();
  watch(10_000, () => {}, asks);
  vi.advanceTimersByTime(60_000);
  expect(asks).toHaveBeenCalledTimes(9);
});

test("work that ends leaves no watch behind, whatever its end", async () => {
  await expect(limited(10_000, "it", async () => 7)).resolves.toBe(7);
  await expect(limited(10_000, "it", () => Promise.reject(new Error("no")))).rejects.toThrow("no");
  expect(vi.getTimerCount()).toBe(0);
});

test("work that never answers fails by name", async () => {
  const outcome = expect(limited(10_000, "the thing", () => new Promise(() => {}))).rejects.toMatchObject({
    code: "wasm-timeout",
    message: "nothing came from the thing for 10 seconds",
  });
  vi.advanceTimersByTime(10_000);
  await outcome;
});

/** The page's module, from a server that a test holds in its hand. */
function serve() {
  const wasm = readFileSync(new URL("../../pkg-make/riverseed_bg.wasm", import.meta.url));
  const asked: AbortSignal[] = [];
  let sender: ReadableStreamDefaultController<Uint8Array> | undefined;
  const body = new ReadableStream<Uint8Array>({
    start: (controller) => {
      sender = controller;
    },
  });
  let answer = (_: Response): void => {};
  vi.stubGlobal("fetch", (_: string, { signal }: { signal: AbortSignal }) => {
    asked.push(signal);
    return new Promise<Response>((done) => {
      answer = done;
    });
  });
  return {
    wasm,
    asked,
    begin: () => answer(new Response(body, { headers: { "content-type": "application/wasm" } })),
    send: (from: number, to: number) => sender?.enqueue(new Uint8Array(wasm.subarray(from, to))),
    end: () => sender?.close(),
  };
}

const link = async (compiled: WebAssembly.Module): Promise<WebAssembly.Module> => compiled;

test("a server that never answers is given up, and let go of", async () => {
  const { asked } = serve();
  const outcome = expect(start("engine.wasm", link)).rejects.toMatchObject({ code: "wasm-timeout" });
  await settle();
  vi.advanceTimersByTime(DOWNLOAD_SILENCE_MS);
  await outcome;
  expect(asked.map(({ aborted }) => aborted)).toEqual([true]);
});

test("a download that stops half-way is given up", async () => {
  const { begin, send } = serve();
  const outcome = expect(start("engine.wasm", link)).rejects.toMatchObject({ code: "wasm-timeout" });
  begin();
  send(0, 1000);
  await settle();
  vi.advanceTimersByTime(DOWNLOAD_SILENCE_MS - 1000);
  send(1000, 2000);
  await settle();
  vi.advanceTimersByTime(DOWNLOAD_SILENCE_MS);
  await outcome;
});

test("a slow download that goes on is waited for, and tells how it goes", async () => {
  const { wasm, asked, begin, send, end } = serve();
  const progress = vi.fn();
  const compiled = start("engine.wasm", link, progress);
  begin();
  const part = Math.ceil(wasm.length / 30);
  for (let from = 0; from < wasm.length; from += part) {
    vi.advanceTimersByTime(DOWNLOAD_SILENCE_MS - 1000);
    send(from, from + part);
    await settle();
  }
  end();
  expect(await compiled).toBeInstanceOf(WebAssembly.Module);
  expect(progress).toHaveBeenCalledTimes(30);
  expect(asked.map(({ aborted }) => aborted)).toEqual([false]);
  expect(vi.getTimerCount()).toBe(0);
});
