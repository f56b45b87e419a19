import { expect, test } from "vitest";
import { meansOf } from "../../../src/apps/page-worker/means.ts";
import type { Answer, Question } from "../../../src/apps/page-worker/protocol.ts";
import type { RiverPlayer } from "../../../src/player/river-player.ts";
import { engine, memory } from "../../whole.ts";

const LINK = "seed=kauri&attractors=300&meander-rounds=5&style=ink&labels=none";

/** As much of a player as is asked: its river, and how that stands. */
function player(river: engine.River): RiverPlayer<engine.River> {
  const state = river.phase === "finished" ? "finished" : "growing";
  return { river, link: river.link, state } as RiverPlayer<engine.River>;
}

function river(steps: number): engine.River {
  const one = new engine.River(LINK);
  one.advance(steps);
  return one;
}

function ask(question: Question, on?: engine.River): Promise<Answer> {
  return meansOf({ engine, memory }).answer(question, (id) => (id === 1 && on ? player(on) : undefined));
}

const json = async (question: Partial<Question>, on?: engine.River): Promise<object> => {
  const answer = await ask({ about: "file", of: 1, link: LINK, format: "json", ...question } as Question, on);
  return JSON.parse(await (answer as Blob).text());
};

test("a file is made from the river on show as far as it has come, which stays as it is", async () => {
  const fresh = await json({});
  for (const steps of [1, 10, 100_000]) {
    const one = river(steps);
    const before = one.summary();
    expect(await json({}, one)).toEqual(fresh);
    expect(one.summary()).toEqual(before);
  }
});

test("a file is of its own link, whatever is on show", async () => {
  const other = "seed=rimu&attractors=100";
  expect(await json({ link: other }, river(10))).toEqual(await json({ link: other }));
});

test("names are those of a finished map, and there are none before", async () => {
  const one = river(100_000);
  const names = one.greatest(5);
  expect(await ask({ about: "names", of: 1, count: 5 }, one)).toEqual({ link: one.link, names });
  expect(await ask({ about: "names", of: 1, count: 5 }, river(3))).toBe(undefined);
  expect(await ask({ about: "names", of: undefined, count: 5 }, one)).toBe(undefined);
});

test("measures and promises are those of a finished map, and there are none before", async () => {
  const one = river(100_000);
  expect(await ask({ about: "measures", of: 1 }, one)).toEqual({
    measures: one.measures(),
    promises: one.promises(),
  });
  expect(await ask({ about: "measures", of: 1 }, river(3))).toBe(undefined);
});

test("a name of one's own is added to those there are", async () => {
  const names = await ask({ about: "renamed", names: "", mark: "12", name: "Home" });
  expect(names).toBe(engine.renamed("", "12", "Home"));
  expect(await ask({ about: "renamed", names: names as string, mark: "12", name: undefined })).toBe("");
});

test("of pictures that are asked for at once only the last is made", async () => {
  const size = { width: 60, height: 40 };
  const { answer } = meansOf({ engine, memory });
  const asked = ["kauri", "rimu", "tay"].map((seed) =>
    answer({ about: "picture", of: undefined, link: `seed=${seed}&attractors=2000&style=ink`, size }, () => undefined),
  );
  expect(await Promise.all(asked)).toEqual([undefined, undefined, expect.objectContaining(size)]);
});

test("a picture of another map leaves the one on show as it is, finished or not, and needs none", async () => {
  const size = { width: 60, height: 40 };
  const link = "seed=kauri&attractors=200&style=ink&labels=none";
  const alone = await ask({ about: "picture", of: undefined, link, size });
  expect(alone).toMatchObject(size);
  for (const steps of [3, 100_000]) {
    const one = river(steps);
    const before = one.summary();
    expect(await ask({ about: "picture", of: 1, link, size }, one)).toEqual(alone);
    expect([one.link, one.summary()]).toEqual([river(steps).link, before]);
  }
});
