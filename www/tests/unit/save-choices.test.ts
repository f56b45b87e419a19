import { expect, test } from "vitest";
import { longerSideOf, ownSizeOf, paperOf, SaveChoices } from "../../src/apps/page/save/save-choices.ts";
import { SHEETS, SIZES } from "../../src/files/order.ts";

function keeper(first?: string) {
  const kept = new Map<string, string>(first === undefined ? [] : [["riverseed-save", first]]);
  return {
    kept,
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, value: string) => void kept.set(key, value),
  };
}

const FIRST = {
  kind: "png",
  size: "screen",
  ownSize: 3000,
  isTransparent: false,
  hasNames: true,
  rasterSize: 1025,
  isSquare: false,
};

test("what was chosen is there the next time", () => {
  const browser = keeper();
  new SaveChoices(() => browser).set({ kind: "svg", size: "own", ownSize: 512 });
  new SaveChoices(() => browser).set({ isTransparent: true });
  expect(new SaveChoices(() => browser).now).toEqual({
    ...FIRST,
    kind: "svg",
    size: "own",
    ownSize: 512,
    isTransparent: true,
  });
});

test("where nothing is remembered, choices hold for the visit", () => {
  const denied = (): never => {
    throw new DOMException("denied", "SecurityError");
  };
  const choices = new SaveChoices(denied);
  expect(choices.now).toEqual(FIRST);
  choices.set({ kind: "zip" });
  expect(choices.now.kind).toBe("zip");
  expect(new SaveChoices(() => ({ getItem: denied, setItem: denied })).now).toEqual(FIRST);
});

test.each([
  "",
  "{",
  "null",
  "7",
  "[]",
  '{"kind":"exe","size":"huge","ownSize":9999,"isTransparent":"yes","hasNames":1}',
  '{"ownSize":null,"kind":{"a":1}}',
  '{"ownSize":"300"}',
  '{"rasterSize":1024,"isSquare":"square"}',
])("what others wrote there is no choice: %s", (kept) => {
  expect(new SaveChoices(() => keeper(kept)).now).toEqual(FIRST);
});

test("sizes are those of uses, or one's own from 256 to 8192", () => {
  expect(SIZES).toEqual({ screen: 2000, a4: 3508, a3: 4961, poster: 8192 });
  expect(longerSideOf({ ...new SaveChoices(() => keeper()).now, size: "a3" })).toBe(4961);
  expect(longerSideOf({ ...new SaveChoices(() => keeper()).now, size: "own", ownSize: 777 })).toBe(777);
  expect(["256", "8192", " 300 "].map(ownSizeOf)).toEqual([256, 8192, 300]);
  for (const text of ["", "255", "8193", "-300", "300.5", "3e3", "0x200", "abc", "1e999", "٣٠٠"])
    expect(ownSizeOf(text), text).toBeUndefined();
});

test("sheets are as wide and as high as paper at their dots per inch, and screens have none", () => {
  const millimetres = { a4: [297, 210], a3: [420, 297], poster: [841, 594] } as const;
  const choices = new SaveChoices(() => keeper()).now;
  for (const [size, [longer, shorter]] of Object.entries(millimetres) as [
    keyof typeof millimetres,
    [number, number],
  ][]) {
    const { shorterSide = 0, dpi = 0 } = paperOf({ ...choices, size });
    expect(Math.abs((SIZES[size] / dpi) * 25.4 - longer), size).toBeLessThan(0.1);
    expect(Math.abs((shorterSide / dpi) * 25.4 - shorter), size).toBeLessThan(0.1);
  }
  expect([SHEETS.a4?.dpi, SHEETS.a3?.dpi]).toEqual([300, 300]);
  expect(paperOf({ ...choices, size: "own" })).toEqual({ dpi: 300 });
  expect(paperOf({ ...choices, size: "screen" })).toEqual({});
});
