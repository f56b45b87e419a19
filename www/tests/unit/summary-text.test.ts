import { expect, test } from "vitest";
import { linesOf } from "../../src/apps/digest/lines.ts";
import { speedName } from "../../src/apps/page/timeline/transport.ts";
import { backingSize } from "../../src/browser/canvas.ts";
import { count } from "../../src/browser/count.ts";
import { alternative, caption, numbersOf, sentence } from "../../src/player/summary-text.ts";
import { engine } from "../core.ts";

const summary = {
  growth: "colonize",
  ticks: 400,
  nodes: 12_345,
  mouths: 1,
  sources: 210,
  order: 5,
  attractors: 4000,
  unreached: 18,
  rounds: 40,
  oxbows: 0,
  finished: true,
  stopped: null,
};

test("the finished state is a sentence with its counts", () => {
  expect(sentence(summary)).toBe("1 river, 210 sources, Strahler order 5.");
});

test("what growth left is counted", () => {
  expect(numbersOf(summary)).toBe(
    "1 river, 210 sources, Strahler order 5, 12,345 nodes; 18 of 4,000 attractors unreached.",
  );
});

test("drainage has parcels, not attractors", () => {
  expect(numbersOf({ ...summary, growth: "drainage" })).toMatch(/; 18 of 4,000 parcels unreached\.$/);
  expect(numbersOf({ ...summary, growth: "drainage", attractors: 1 })).toMatch(/ of 1 parcel unreached\.$/);
});

test("a river of the engine says whether it has attractors or parcels", () => {
  const summaryOf = (growth: string) => {
    const river = new engine.River(`growth=${growth}&attractors=100`);
    while (river.advance(100));
    return numbersOf(river.summary());
  };
  expect(summaryOf("colonize")).toMatch(/ attractors unreached/);
  expect(summaryOf("drainage")).toMatch(/ parcels unreached/);
  expect(summaryOf("brownian")).not.toMatch(/unreached/);
});

test("where there are no attractors none are counted", () => {
  const brownian = { ...summary, growth: "brownian", attractors: 0, unreached: 0 };
  expect(numbersOf(brownian)).toBe("1 river, 210 sources, Strahler order 5, 12,345 nodes.");
});

test("oxbow lakes are counted where there are any", () => {
  expect(sentence({ ...summary, oxbows: 1 })).toMatch(/^1 river, 210 sources, Strahler order 5, 1 oxbow lake\./);
  expect(sentence({ ...summary, oxbows: 12 })).toMatch(/, 12 oxbow lakes\./);
});

test("an early end says why", () => {
  expect(sentence({ ...summary, stopped: "Growth died out early." })).toMatch(/5\. Growth died out early\.$/);
});

test("the picture's alternative names the seed, whatever it holds", () => {
  expect(alternative("<b>kauri</b>", "finished", summary, count)).toBe(
    "River network grown from the seed “<b>kauri</b>”: 1 river, 210 sources, Strahler order 5.",
  );
});

test("a picture that grows or meanders says so", () => {
  const start = "River network grown from the seed “kauri”: still";
  expect(alternative("kauri", "growing", summary, count)).toBe(`${start} growing.`);
  expect(alternative("kauri", "shaping", summary, count)).toBe(`${start} growing.`);
  expect(alternative("kauri", "meandering", summary, count)).toBe(`${start} meandering.`);
});

test("the caption says what is going on in words, and counts nothing", () => {
  expect(caption("growing", "growing", { ...summary, nodes: 0 })).toBe("Growing");
  expect(caption("growing", "shaping", summary)).toBe("Growing");
  expect(caption("settling", "meandering", { ...summary, oxbows: 2 })).toBe("Meandering");
  expect(caption("paused", "growing", summary)).toBe("Paused while growing");
  expect(caption("paused", "meandering", summary)).toBe("Paused while meandering");
  expect(caption("finished", "finished", summary)).toBe("");
  expect(caption("finished", "finished", { ...summary, stopped: "Too wide." })).toBe("Too wide.");
});

test("a canvas has the screen's pixels, up to two a CSS pixel and four million in all", () => {
  const place = { x: 0, y: 0, width: 300, height: 200 };
  expect(backingSize(place, 1)).toEqual({ width: 300, height: 200 });
  expect(backingSize(place, 3)).toEqual({ width: 600, height: 400 });
  const { width, height } = backingSize({ ...place, width: 4000, height: 2000 }, 2);
  expect(width * height).toBeLessThanOrEqual(4_200_000);
  expect(width / height).toBeCloseTo(2, 2);
  expect(backingSize({ ...place, width: 0, height: 0 }, 2)).toEqual({ width: 0, height: 0 });
});

test("a canvas between two pixels of the screen ends where the browser rounds its edges to", () => {
  expect(backingSize({ x: 38.6, y: 83.3, width: 978.8, height: 652.9 }, 1)).toEqual({ width: 978, height: 653 });
  expect(backingSize({ x: 38.3, y: 83.3, width: 978.3, height: 652.1 }, 1.5)).toEqual({ width: 1468, height: 978 });
});

test("speeds have names", () => {
  expect([0.25, 1, 8, Number.POSITIVE_INFINITY].map(speedName)).toEqual(["¼×", "1×", "8×", "instant"]);
});

test("the digest list is read line by line, comments left out", () => {
  expect(linesOf("# comment\nab12 seed=kauri&edition=1\n\n")).toEqual([
    { digest: "ab12", link: "seed=kauri&edition=1" },
  ]);
});
