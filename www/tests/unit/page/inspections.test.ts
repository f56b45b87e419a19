import { expect, test, vi } from "vitest";
import { Inspections, PATIENCE_MS } from "../../../src/apps/page-worker/inspections.ts";
import { turn } from "../../../src/browser/turn.ts";
import type { Teller } from "../../../src/engine/tell.ts";
import type { Inspector } from "../../../src/engine/types.ts";
import type { RiverPlayer } from "../../../src/player/river-player.ts";
import { engine } from "../../steer.ts";
import { teller } from "../../tell.ts";

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

/** A teller whose maps make this of being asked for an inspector. */
function tellerWith(inspector: (own: () => Inspector | undefined) => Inspector | undefined): Teller {
  class OwnMap extends teller.FinishedMap {
    override inspector(): Inspector | undefined {
      return inspector(() => super.inspector());
    }
  }
  return { ...teller, FinishedMap: OwnMap };
}

test("a map that cannot be looked into is no complaint once another is asked about", async () => {
  const { said, stop } = unheard();
  const inspections = new Inspections(() => Promise.resolve(teller));
  const [one, other] = [player("kauri"), player("rimu")];
  one.river.mapData = () => {
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

/** A teller that counts its inspectors. */
function counting(): { counting: Teller; count: { made: number; freed: number } } {
  const count = { made: 0, freed: 0 };
  const counting = tellerWith((own) => {
    const one = own();
    if (!one) return;
    count.made++;
    const free = one.free.bind(one);
    one.free = () => {
      count.freed++;
      free();
    };
    return one;
  });
  return { counting, count };
}

test("a teller that does not arrive is an error, and after a while it is asked for again", async () => {
  vi.useFakeTimers({ toFake: ["performance"] });
  const load = vi.fn(() => Promise.reject<Teller>(new TypeError("offline")));
  const inspections = new Inspections(() => load());
  const one = player("kauri");
  for (let i = 0; i < 3; i++)
    await expect(inspections.overlay(one, ORDERS)).rejects.toMatchObject({ code: "no-files" });
  expect(load).toHaveBeenCalledTimes(1);
  load.mockImplementation(() => Promise.resolve(teller));
  vi.advanceTimersByTime(PATIENCE_MS);
  expect((await inspections.overlay(one, ORDERS))?.link).toBe(one.link);
  vi.useRealTimers();
});

test("whoever asks of the map before gets no answer, and that map's inspector is freed", async () => {
  const { counting: own, count } = counting();
  const inspections = new Inspections(() => Promise.resolve(own));
  const [one, other] = [player("kauri"), player("rimu")];
  const [first, second] = await Promise.all([inspections.overlay(one, ORDERS), inspections.overlay(other, ORDERS)]);
  expect(first).toBe(undefined);
  expect(second?.link).toBe(other.link);
  await turn();
  expect(count).toEqual({ made: 2, freed: 1 });
});
