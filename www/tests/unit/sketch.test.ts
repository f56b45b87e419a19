import { expect, test } from "vitest";
import { type LineKind, pointsOf, Sketch, tally } from "../../src/apps/page/land/sketch.ts";
import { engine } from "../core.ts";

function draw(sketch: Sketch, kind: LineKind, ...places: [x: number, y: number][]): void {
  const [first = [0, 0], ...rest] = places;
  sketch.begin(kind, ...first);
  for (const place of rest) sketch.extend(...place);
  sketch.end();
}

const SQUARE: [number, number][] = [
  [0.2, 0.2],
  [0.8, 0.2],
  [0.8, 0.8],
  [0.2, 0.8],
];

test("a line counts while it is drawn, and a mere touch never, but for the mouth of a river", () => {
  const sketch = new Sketch();
  sketch.begin("coast", 0.1, 0.1);
  expect([sketch.lines.length, sketch.isLive]).toEqual([1, true]);
  sketch.end();
  expect([sketch.lines.length, sketch.isLive, sketch.canUndo]).toEqual([0, false, false]);
  draw(sketch, "river", [0.1, 0.1]);
  expect([sketch.counts.rivers, sketch.isLive, sketch.canUndo]).toEqual([1, false, true]);
});

test("a pen that leaves the map draws along its border, one that rests adds nothing", () => {
  const sketch = new Sketch();
  sketch.begin("coast", 0.5, 0.5);
  expect(sketch.extend(0.5, 0.5001)).toBe(false);
  expect(sketch.extend(-3, 0.5)).toBe(true);
  expect(sketch.extend(-4, 2)).toBe(true);
  expect(sketch.lines[0]?.points).toEqual([0.5, 0.5, 0, 0.5, 0, 1]);
});

test("undo takes back lines, clearing, and an import, one after another", () => {
  const sketch = new Sketch();
  const counts: number[] = [];
  draw(sketch, "coast", ...SQUARE);
  draw(sketch, "ridge", [0.3, 0.3], [0.6, 0.6]);
  sketch.replace({ coasts: [new Float32Array(6), new Float32Array(6), new Float32Array(6)], ridges: [], rivers: [] });
  sketch.clear();
  for (;;) {
    counts.push(sketch.lines.length);
    if (!sketch.canUndo) break;
    sketch.undo();
  }
  expect(counts).toEqual([0, 3, 2, 1, 0]);
});

test("lines of a link are taken back one by one", () => {
  const sketch = new Sketch();
  sketch.open({ coasts: [new Float32Array(6)], ridges: [new Float32Array(4)], rivers: [new Float32Array(2)] });
  expect(sketch.lines.map(({ kind }) => kind)).toEqual(["coast", "ridge", "river"]);
  sketch.undo();
  expect(sketch.lines.map(({ kind }) => kind)).toEqual(["coast", "ridge"]);
  sketch.undo();
  expect(sketch.lines.map(({ kind }) => kind)).toEqual(["coast"]);
  sketch.undo();
  expect([sketch.lines.length, sketch.canUndo]).toEqual([0, false]);
});

test("the core keeps what is drawn and gives it back", () => {
  const sketch = new Sketch();
  draw(sketch, "coast", ...SQUARE);
  draw(sketch, "ridge", [0.3, 0.3], [0.6, 0.6]);
  const outline = outlineOf(sketch);
  const lines = engine.outlineLines(outline);
  expect(tally(lines, { coasts: 1, ridges: 1 })).toBe("1 coast and 1 ridge, 6 points");
  expect(tally(lines, { coasts: 4, ridges: 2 })).toBe("1 of 4 coasts and 1 of 2 ridges, 6 points");
  lines.coasts[0]?.forEach((x, i) => {
    expect(x).toBeCloseTo(SQUARE.flat()[i] ?? Number.NaN, 3);
  });
  const reading = engine.readLink(`land=drawn&outline=${outline}`);
  expect(reading.notices).toEqual([]);
  expect(reading.link).toBe(`seed=kauri&edition=1&land=drawn&outline=${outline}`);
});

function outlineOf({ lines }: Sketch): string {
  return engine.outlineOf(pointsOf(lines, "coast"), pointsOf(lines, "ridge"), pointsOf(lines, "river"));
}

test("the core keeps mouths and courses of rivers, on a land or alone", () => {
  for (const coasts of [[SQUARE], []]) {
    const sketch = new Sketch();
    for (const coast of coasts) draw(sketch, "coast", ...coast);
    draw(sketch, "river", [0.2, 0.5]);
    draw(sketch, "river", [0.8, 0.4], [0.6, 0.5], [0.5, 0.4]);
    const lines = engine.outlineLines(outlineOf(sketch));
    expect(lines.rivers.map(({ length }) => length / 2)).toEqual([1, 3]);
    expect(lines.rivers[0]?.[1]).toBeCloseTo(0.5, 3);
    const land = coasts.length > 0 ? "1 coast and " : "";
    expect(tally(lines, sketch.counts)).toBe(`${land}2 rivers, ${coasts.length * 4 + 4} points`);
  }
});

test("what is no land is an error with a name", () => {
  expect(() => engine.outlineOf([], [], [])).toThrow(expect.objectContaining({ code: "no-land" }));
  expect(() => engine.outlineLines(".AAA")).toThrow(/coast that begins at character 1/);
  expect(() => engine.traceImage(new Uint8Array(4), 40, 40)).toThrow(/4 bytes/);
});
