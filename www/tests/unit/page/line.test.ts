import { expect, test, vi } from "vitest";
import type { PageRenderHost } from "../../../src/apps/page/backend.ts";
import { Line } from "../../../src/apps/page/map/line.ts";
import { PageError } from "../../../src/engine/errors.ts";

function lineTo(enter: (client: { moved(): void }) => Promise<number>) {
  const host = { enter: vi.fn(enter), send: vi.fn(), leave: vi.fn() };
  const events = { opened: vi.fn(), hear: vi.fn(), moved: vi.fn(), failed: vi.fn() };
  return { host, events, line: new Line(host as unknown as PageRenderHost, events) };
}

test("commands go to the renderer that was entered last, and to none before", async () => {
  let entered = 0;
  const { host, events, line } = lineTo(async () => ++entered);
  line.send({ do: "toggle" });
  expect(host.send).not.toHaveBeenCalled();
  await line.enter();
  host.enter.mock.lastCall?.[0].moved();
  expect(line.id).toBeUndefined();
  line.send({ do: "toggle" });
  expect(host.send).not.toHaveBeenCalled();
  await vi.waitFor(() => expect(events.opened).toHaveBeenCalledTimes(2));
  expect(events.moved).toHaveBeenCalledTimes(1);
  line.send({ do: "toggle" });
  expect(host.send.mock.calls).toEqual([[2, { do: "toggle" }]]);
});

test("a renderer that cannot be entered is told of by its name, unless nobody waits for it any more", async () => {
  const { events, line } = lineTo(() => Promise.reject(new PageError("wasm-fetch", "no")));
  await line.enter();
  expect(events.failed.mock.calls).toMatchObject([[{ code: "wasm-fetch" }]]);
  line.close();
  await line.enter();
  expect(events.failed).toHaveBeenCalledTimes(1);
});

test("a renderer that opens too late is left, and no other is entered", async () => {
  const { host, events, line } = lineTo(async () => 1);
  const entering = line.enter();
  line.close();
  await entering;
  expect(host.leave).toHaveBeenCalledWith(1);
  host.enter.mock.lastCall?.[0].moved();
  expect([events.opened, events.moved].map(({ mock }) => mock.calls.length)).toEqual([0, 0]);
  expect(host.enter).toHaveBeenCalledTimes(1);
});
