import { expect, test } from "vitest";
import { Inspections } from "../../../src/apps/page-worker/inspections.ts";
import { turn } from "../../../src/browser/turn.ts";
import type { RiverPlayer } from "../../../src/player/river-player.ts";
import { engine } from "../../whole.ts";

/** What is laid over a finished map, and not over one that grows. */
const ORDERS = "orders";

/** A player of a finished map. */
function player(seed: string): RiverPlayer<engine.River> & { river: engine.River } {
  const river = new engine.River(`seed=${seed}&attractors=200&meander-rounds=2`);
  while (river.advance(1000));
  return { river, link: river.link, state: "finished" } as RiverPlayer<engine.River> & { river: engine.River };
}

/** What rejections nobody heard of. */
function unheard(): { said: unknown[]; stop(): void } {
  const said: unknown[] = [];
  const others = process.listeners("unhandledRejection");
  process.removeAllListeners("unhandledRejection");
  process.on("unhandledRejection", (thrown) => said.push(thrown));
  const stop = (): void => {
    process.removeAllListeners("unhandledRejection");
    for (const listener of others) process.on("unhandledRejection", listener);
  };
  return { said, stop };
}

test("a map that cannot be looked into is no complaint once another is asked about", async () => {
  const { said, stop } = unheard();
  const inspections = new Inspections();
  const [one, other] = [player("kauri"), player("rimu")];
  one.river.inspector = () => {
    throw new Error("no room");
  };
  const first = inspections.overlay(one, ORDERS).catch((error: Error) => error.message);
  const second = inspections.overlay(other, ORDERS);
  expect(await first).toBe("no room");
  expect((await second)?.link).toBe(other.link);
  await turn();
  stop();
  expect(said).toEqual([]);
});

test("whoever asks of the map before gets no answer, and that map's inspector is freed", async () => {
  const count = { made: 0, freed: 0 };
  const inspections = new Inspections();
  const [one, other] = [player("kauri"), player("rimu")];
  for (const { river } of [one, other]) {
    const inspector = river.inspector();
    if (!inspector) throw new Error("there is no memory");
    const free = inspector.free.bind(inspector);
    inspector.free = () => {
      count.freed++;
      free();
    };
    river.inspector = () => {
      count.made++;
      return inspector;
    };
  }
  const [first, second] = await Promise.all([inspections.overlay(one, ORDERS), inspections.overlay(other, ORDERS)]);
  expect(first).toBe(undefined);
  expect(second?.link).toBe(other.link);
  await turn();
  expect(count).toEqual({ made: 2, freed: 1 });
});

test("the basin of a river is drawn, but for a brook's, of which one would see the cells", async () => {
  const river = new engine.River("seed=kauri&country=usual&land=island&attractors=6000");
  while (river.advance(1000));
  const inspections = new Inspections();
  const shown = { river, link: river.link, state: "finished" } as RiverPlayer<engine.River> & { river: engine.River };
  while (river.raiseRelief());
  const inspector = river.inspector();
  const drawn = { brooks: 0, rivers: 0 };
  // 200 square units of a million that are 200 km by 125 km.
  const small = 5;
  for (const [mark = ""] of inspector?.names() ?? []) {
    if (!/^\d+$/.test(mark)) continue;
    const found = await inspections.river(shown, { mark });
    if (!found) throw new Error(`there is no river ${mark}`);
    drawn[found.area < small ? "brooks" : "rivers"]++;
    expect(found.basin === "").toBe(found.area < small);
  }
  expect(Math.min(drawn.brooks, drawn.rivers)).toBeGreaterThan(2);
});
