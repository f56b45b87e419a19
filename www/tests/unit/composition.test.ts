import { expect, test } from "vitest";
import { composed, type Edges, shownOf } from "../../src/files/composition.ts";
import { CARDS } from "../../src/files/order.ts";

/** Boxes around land, in widths of the map: wide, square, tall, flat, small in a corner. */
const LANDS: readonly Edges[] = [
  [0.05, 0.05, 0.95, 0.6],
  [0, 0, 1, 1],
  [0.1, 0, 0.9, 1.5],
  [0, 0.1, 1, 0.3],
  [0.7, 0.4, 0.95, 0.6],
];

for (const [kind, picture] of Object.entries(CARDS)) {
  for (const land of LANDS) {
    const { framing, title } = composed(picture, land);
    const [left = 0, top = 0, across = 1, ...covered] = framing;
    const scale = picture.width / across;
    const onPicture = [
      (land[0] - left) * scale,
      (land[1] - top) * scale,
      (land[2] - left) * scale,
      (land[3] - top) * scale,
    ];
    const [west = 0, north = 0, east = 0, south = 0] = onPicture;

    test(`a ${kind} shows all of the land at ${land}, and its title off it`, () => {
      for (const [start, end, length] of [
        [west, east, picture.width],
        [north, south, picture.height],
        [title[0], title[2], picture.width],
        [title[1], title[3], picture.height],
      ] as const) {
        expect(start).toBeGreaterThan(0.02 * length);
        expect(end).toBeLessThan(0.98 * length);
      }
      expect(title[3] < north || title[2] < west).toBe(true);
    });

    test(`a ${kind} of the land at ${land} has room for letters that can be read at 300 pixels`, () => {
      // Nine letters of half an em, and a line under them.
      const em = Math.min((title[2] - title[0]) / 9 / 0.6, (title[3] - title[1]) / 1.4);
      expect((em * 0.66 * 300) / picture.width).toBeGreaterThan(9);
    });

    test(`no other name stands where the title of a ${kind} does, with the land at ${land}`, () => {
      const [fromLeft = 0, fromTop = 0] = covered;
      expect(fromLeft * scale >= title[2] - 1e-6 || fromTop * scale >= title[3] - 1e-6).toBe(true);
      expect(covered).toHaveLength(4);
    });
  }
}

test("the land is as large as it can be: a tall one stands beside its title on a card, a wide one below it", () => {
  expect(composed(CARDS.card, [0, 0, 1, 1.5]).title[2]).toBeLessThan(CARDS.card.width / 2);
  expect(composed(CARDS.card, [0, 0, 1, 0.5]).title[3]).toBeLessThan(CARDS.card.height / 3);
  expect(composed(CARDS.portrait, [0, 0, 1, 1.5]).title[3]).toBeLessThan(CARDS.portrait.height / 3);
});

test("of a map whose land ends at its border all is shown, of any other the land", () => {
  const [island, coast]: Edges[] = [
    [0.1, 0.05, 0.9, 0.6],
    [0, 0, 1, 0.5],
  ];
  expect(shownOf(island as Edges, 1.5)).toEqual(island);
  expect(shownOf(coast as Edges, 1.5)).toEqual([0, 0, 1, 1 / 1.5]);
  expect(shownOf([0.1, 0.1, 0.9, 1 / 1.5], 1.5)).toEqual([0, 0, 1, 1 / 1.5]);
});
