import { expect, test } from "vitest";
import type { Line } from "../../../src/apps/page/map/line.ts";
import { MapQuestions } from "../../../src/apps/page/map/questions.ts";

/** Questions on a page that has asked for one map and shows another, or the same; every answer is about `told`. */
function questions(told: string | undefined, wanted = "seed=one", shown = wanted) {
  const asked: object[] = [];
  const ask = async (question: object): Promise<object | undefined> => {
    asked.push(question);
    return told === undefined ? undefined : { link: told, names: [{ mark: "t", name: "Kauri", isOwn: false }] };
  };
  return { ask: new MapQuestions({ id: 7, ask } as unknown as Line, () => ({ wanted, shown })), asked };
}

const EACH = {
  names: (ask: MapQuestions) => ask.names(12).then(([name]) => name),
  river: (ask: MapQuestions) => ask.river({ mark: "1" }),
  nameables: (ask: MapQuestions) => ask.nameables({ mark: "1" }),
  overlay: (ask: MapQuestions) => ask.overlay("basins"),
  making: (ask: MapQuestions) => ask.making({ part: "map", step: 0 }),
};

for (const [about, answered] of Object.entries(EACH))
  test(`an answer about ${about} counts if it is of the map that was asked for last`, async () => {
    const { ask, asked } = questions("seed=one");
    expect(await answered(ask)).toBeDefined();
    expect(asked).toMatchObject([{ about, of: 7 }]);
    for (const other of ["seed=two", undefined]) expect(await answered(questions(other).ask)).toBeUndefined();
  });

test("what has a name is told only of the map on show, the rest of one that is on its way as well", async () => {
  const { ask } = questions("seed=two", "seed=two", "seed=one");
  expect(await ask.nameables({ mark: "1" })).toBeUndefined();
  expect(await ask.river({ mark: "1" })).toBeDefined();
});

test("where nothing is told there are no thumbnails, and nothing is measured", async () => {
  const { ask } = questions(undefined);
  expect(await ask.measures()).toBeUndefined();
  expect(await ask.thumbnails(["ink"], { width: 1, height: 1 })).toEqual([]);
});
