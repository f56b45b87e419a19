import { expect, test } from "vitest";
import { Inspections } from "../../../src/apps/page-worker/inspections.ts";
import { turn } from "../../../src/browser/turn.ts";
import type { Charts } from "../../../src/engine/charts.ts";
import type { RiverPlayer } from "../../../src/player/river-player.ts";
import { charts } from "../../charts.ts";
import { full } from "../../full.ts";

/** What is laid over a finished map, and not over one that grows. */
const ORDERS = "orders";

/** A player of a finished map. */
function player(seed: string): RiverPlayer<full.River> & { river: full.River } {
  const river = new full.River(`seed=${seed}&attractors=200&meander-rounds=2`);
  while (river.advance(1000));
  return { river, link: river.link, state: "finished" } as RiverPlayer<full.River> & { river: full.River };
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
  const inspections = new Inspections(() => Promise.resolve(charts as Charts));
  const [failing, other] = [player("kauri"), player("rimu")];
  failing.river.inspector = () => {
    throw new Error("no room");
  };
  const first = inspections.overlay(failing, ORDERS).catch((error: Error) => error.message);
  const second = inspections.overlay(other, ORDERS);
  expect(await first).toBe("no room");
  expect((await second)?.link).toBe(other.link);
  await turn();
  stop();
  expect(said).toEqual([]);
});

/** Counts the inspectors of a player's river. */
function counted({ river }: { river: full.River }): { made: number; freed: number } {
  const count = { made: 0, freed: 0 };
  const inspector = river.inspector.bind(river);
  river.inspector = () => {
    const one = inspector();
    if (!one) return;
    count.made++;
    const free = one.free.bind(one);
    one.free = () => {
      count.freed++;
      free();
    };
    return one;
  };
  return count;
}

test("if the names cannot be had, no inspector is left over", async () => {
  const one = player("kauri");
  const count = counted(one);
  const failing = {
    Chart: class {
      constructor() {
        throw new Error("no room");
      }
    },
  } as unknown as Charts;
  const inspections = new Inspections(() => Promise.resolve(failing));
  await expect(inspections.overlay(one, ORDERS)).rejects.toThrow("no room");
  expect(count.freed).toBe(count.made);
});

test("whoever asks of the map before gets no answer, and that map's inspector is freed", async () => {
  const inspections = new Inspections(() => Promise.resolve(charts as Charts));
  const [one, other] = [player("kauri"), player("rimu")];
  const count = counted(one);
  const [first, second] = await Promise.all([inspections.overlay(one, ORDERS), inspections.overlay(other, ORDERS)]);
  expect(first).toBe(undefined);
  expect(second?.link).toBe(other.link);
  await turn();
  expect(count).toEqual({ made: 1, freed: 1 });
});
