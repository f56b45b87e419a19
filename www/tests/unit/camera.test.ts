import { describe, expect, it } from "vitest";
import { Camera, type Stage, transformBetween } from "../../src/apps/page/map/camera.ts";

const INSETS = { left: 10, top: 20, right: 150, bottom: 80 };
const STAGE: Stage = { width: 1440, height: 900, insets: INSETS, aspect: 1.6 };
const PLACES: Stage[] = [
  STAGE,
  { ...STAGE, aspect: 0.25 },
  { ...STAGE, aspect: 4 },
  { width: 320, height: 568, insets: { left: 16, top: 16, right: 16, bottom: 200 }, aspect: 1.6 },
  // Covered all over.
  { width: 320, height: 300, insets: { left: 16, top: 16, right: 16, bottom: 400 }, aspect: 1.6 },
];

/** Where a point of the map, in shares of its sides, is seen. */
function seen(camera: Camera, stage: Stage, [x, y]: [number, number]): [number, number] {
  const box = camera.boxOn(stage);
  return [box.x + x * box.width, box.y + y * box.height];
}

describe("the camera", () => {
  it("shows all of the map in the middle of what is free", () => {
    for (const stage of PLACES.slice(0, 4)) {
      const { x, y, width, height } = new Camera().boxOn(stage);
      expect(width / height).toBeCloseTo(stage.aspect);
      expect(x).toBeGreaterThanOrEqual(stage.insets.left - 1e-6);
      expect(y).toBeGreaterThanOrEqual(stage.insets.top - 1e-6);
      expect(x + width).toBeLessThanOrEqual(stage.width - stage.insets.right + 1e-6);
      expect(y + height).toBeLessThanOrEqual(stage.height - stage.insets.bottom + 1e-6);
      // It touches two sides of it.
      const across = stage.width - stage.insets.left - stage.insets.right;
      const down = stage.height - stage.insets.top - stage.insets.bottom;
      expect(Math.min(across - width, down - height)).toBeCloseTo(0);
    }
  });

  it("shows a part of the map as large as what is free, in its middle", () => {
    const part = { left: 0.2, top: 0.3, right: 0.7, bottom: 0.6 };
    for (const stage of PLACES.slice(0, 4)) {
      const camera = new Camera();
      camera.show(part, stage);
      const [left, top] = seen(camera, stage, [part.left, part.top]);
      const [right, bottom] = seen(camera, stage, [part.right, part.bottom]);
      const margins = [
        left - stage.insets.left,
        stage.width - stage.insets.right - right,
        top - stage.insets.top,
        stage.height - stage.insets.bottom - bottom,
      ] as const;
      expect(Math.min(...margins)).toBeCloseTo(0);
      expect(margins[0]).toBeCloseTo(margins[1]);
      expect(margins[2]).toBeCloseTo(margins[3]);
    }
  });

  it("keeps the whole map in sight if a part could be shown only a little larger, or nowhere", () => {
    const camera = new Camera();
    camera.show({ left: 0.02, top: 0.4, right: 0.98, bottom: 0.6 }, STAGE);
    for (const stage of PLACES.slice(4)) camera.show({ left: 0.2, top: 0.3, right: 0.7, bottom: 0.6 }, stage);
    expect(camera.showsAll).toBe(true);
  });

  it("frames what the page shows", () => {
    for (const stage of PLACES) {
      const camera = new Camera();
      camera.zoomBy(3, { x: 200, y: 100 }, stage);
      const [left, top, across] = camera.framingOn(stage);
      const { x, y, width } = camera.boxOn(stage);
      expect([-left * width, -top * width, across * width]).toEqual([
        expect.closeTo(x, 6),
        expect.closeTo(y, 6),
        expect.closeTo(stage.width, 6),
      ]);
      // As much as the engine takes.
      expect(across).toBeGreaterThanOrEqual(0.05);
      expect(across).toBeLessThanOrEqual(20);
    }
  });

  it("zooms about a point, which stays where it is", () => {
    const camera = new Camera();
    const place = seen(camera, STAGE, [0.4, 0.6]);
    for (const factor of [2, 1.3, 3, 0.7]) {
      camera.zoomBy(factor, { x: place[0], y: place[1] }, STAGE);
      expect(seen(camera, STAGE, [0.4, 0.6])).toEqual([expect.closeTo(place[0], 6), expect.closeTo(place[1], 6)]);
    }
  });

  it("zooms no farther than all of the map, which has one place, and not without end", () => {
    const camera = new Camera();
    const first = camera.boxOn(STAGE);
    camera.zoomBy(4, { x: 1, y: 1 }, STAGE);
    camera.moveBy(90, -40, STAGE);
    camera.zoomBy(0.01, undefined, STAGE);
    expect(camera.boxOn(STAGE)).toEqual(first);
    expect(camera.showsAll).toBe(true);
    camera.moveBy(90, -40, STAGE);
    expect(camera.boxOn(STAGE)).toEqual(first);
    camera.zoomBy(1e9, undefined, STAGE);
    expect(camera.isClosest).toBe(true);
    expect(camera.framingOn(STAGE)[2]).toBeGreaterThanOrEqual(0.05);
  });

  it("says what covers the western, northern, eastern and southern edge of the picture, in widths of the map", () => {
    const stage = { width: 1000, height: 800, aspect: 1, insets: { left: 10, top: 20, right: 30, bottom: 40 } };
    const camera = new Camera();
    const { width } = camera.boxOn(stage);
    expect(camera.framingOn(stage).slice(3)).toEqual([10, 20, 30, 40].map((inset) => expect.closeTo(inset / width, 9)));
    // Nothing covers more than there is.
    const [west = 0] = camera.framingOn({ ...stage, insets: { ...stage.insets, left: 5000 } }).slice(3);
    expect(west).toBeCloseTo(1000 / camera.boxOn({ ...stage, insets: { ...stage.insets, left: 5000 } }).width, 9);
  });

  it("loses no map, however far it is moved", () => {
    const camera = new Camera();
    camera.zoomBy(2, undefined, STAGE);
    for (const [dx, dy] of [
      [1e5, 0],
      [0, 1e5],
      [-1e6, -1e6],
    ] as const) {
      camera.moveBy(dx, dy, STAGE);
      const { x, y, width, height } = camera.boxOn(STAGE);
      expect(x).toBeLessThan(STAGE.width - INSETS.right);
      expect(y).toBeLessThan(STAGE.height - INSETS.bottom);
      expect(x + width).toBeGreaterThan(INSETS.left);
      expect(y + height).toBeGreaterThan(INSETS.top);
    }
  });
});

describe("a picture that stands for another", () => {
  it("is left alone if it is that", () => {
    expect(transformBetween([0.1, 0.2, 1.5], [0.1, 0.2, 1.5], 1000)).toBe("");
  });

  it("is moved and scaled to where that will be", () => {
    // Twice as close; what lies a quarter of the picture from the west is now at its western edge.
    expect(transformBetween([0, 0, 1], [0.25, 0, 0.5], 1000)).toBe("translate(-500px, 0px) scale(2)");
  });
});
