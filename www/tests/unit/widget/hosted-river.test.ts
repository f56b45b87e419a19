import { beforeEach, expect, test, vi } from "vitest";
import { HostedRiver, type Opening } from "../../../src/apps/widget/hosted-river.ts";
import type { State } from "../../../src/player/frame-loop.ts";
import type { ShowMode } from "../../../src/player/river-player.ts";

/** A render host that notes what it is sent. */
const host = vi.hoisted(() => ({
  sent: [] as { id: number; do: string; how?: string }[],
  left: [] as number[],
  last: 0,
  enter: async () => ++host.last,
  send: (id: number, command: { do: string }) => void host.sent.push({ id, ...command }),
  leave: (id: number) => void host.left.push(id),
}));
vi.mock("../../../src/apps/widget/backend.ts", () => ({ renderHost: host }));

beforeEach(() => Object.assign(host, { sent: [], left: [], last: 0 }));

const CLIENT = { hear: () => {}, moved: () => {} };
const SIZE = { width: 160, height: 100, ratio: 1 };

function opening(how: ShowMode): Opening {
  return { canvas: {} as HTMLCanvasElement, link: { text: "seed=a" }, how, size: SIZE };
}

async function enter(
  river: HostedRiver,
  how: ShowMode = "watch",
  signal = new AbortController().signal,
): Promise<void> {
  await river.enter(CLIENT, { wasmUrl: undefined, link: { text: "" } }, signal, () => opening(how));
}

/** The orders that the host was given, and the way in which it shows a river. */
function told(): string[] {
  return host.sent.map((command) => [command.do, command.how].filter(Boolean).join(" "));
}

test("nothing is sent before it is there", async () => {
  const river = new HostedRiver();
  river.send({ do: "rest" });
  expect([river.isThere, told()]).toEqual([false, []]);
  await enter(river);
  river.send({ do: "rest" });
  expect([river.isThere, told()]).toEqual([true, ["open watch", "rest"]]);
});

test("of what was asked before, the last counts", async () => {
  const river = new HostedRiver();
  river.ask({ do: "pause" });
  river.ask({ do: "seek", share: 0.5 });
  expect(river.isAskedToPlay).toBe(false);
  river.ask({ do: "play" });
  expect(river.isAskedToPlay).toBe(true);
  await enter(river, "still");
  expect(told()).toEqual(["open watch", "play"]);
});

test("one that was paused or sought before opens there", async () => {
  const [paused, sought] = [new HostedRiver(), new HostedRiver()];
  paused.ask({ do: "pause" });
  sought.ask({ do: "seek", share: 0.5 });
  await enter(paused);
  await enter(sought, "still");
  expect(told()).toEqual(["open watch", "pause", "open watch", "seek"]);
});

test.each<[State | undefined, string[]]>([
  ["finished", ["open still", "finish"]],
  ["paused", ["open watch", "pause"]],
  ["growing", ["open watch"]],
  ["settling", ["open watch"]],
  [undefined, ["open watch"]],
])("in another engine one that was %s goes on as it was", async (state, expected) => {
  const river = new HostedRiver();
  await enter(river);
  river.move(state);
  expect(river.isThere).toBe(false);
  host.sent = [];
  await enter(river);
  expect(told()).toEqual(expected);
});

test("what is asked goes over to another engine until the river has followed it", async () => {
  const river = new HostedRiver();
  await enter(river);
  river.ask({ do: "pause" });
  river.move("growing");
  await enter(river);
  river.answered();
  river.move("growing");
  await enter(river);
  expect(told()).toEqual(["open watch", "pause", "open watch", "pause", "open watch"]);
});

test("a replay that failed is not tried again where the river is opened anew", async () => {
  const river = new HostedRiver();
  await enter(river);
  river.ask({ do: "play" }, { do: "replay" });
  river.leave();
  await enter(river, "still");
  expect(told()).toEqual(["open watch", "replay", "open watch", "play"]);
});

test("it counts the links that it shows after the first, in each engine anew", async () => {
  const river = new HostedRiver();
  await enter(river);
  for (const how of ["watch", "still"] as const) river.show({ link: { text: "seed=b" }, how, size: SIZE });
  expect([river.links, told()]).toEqual([2, ["open watch", "show watch", "show still"]]);
  river.move("growing");
  await enter(river);
  expect(river.links).toBe(0);
});

test("one whose element has left by then is not opened", async () => {
  const river = new HostedRiver();
  await enter(river, "watch", AbortSignal.abort());
  expect([river.isThere, told(), host.left]).toEqual([false, [], [1]]);
});

test("it leaves once", async () => {
  const river = new HostedRiver();
  await enter(river);
  river.leave();
  river.leave();
  river.send({ do: "rest" });
  expect([told(), host.left]).toEqual([["open watch"], [1]]);
});
