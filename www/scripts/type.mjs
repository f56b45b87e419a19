// Writes the tables of type, src/annotate/glyph/italic.bin and roman.bin: the letters of EB Garamond as outlines and numbers.
// src/annotate/glyph/table.rs, which reads them, describes their bytes.
//
//   node scripts/type.mjs    writes them again; a unit test fails if they differ from the font's package

import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import * as fontkit from "fontkit";

const FILES = new URL("../node_modules/@fontsource/eb-garamond/files/", import.meta.url);
const TABLES = new URL("../../src/annotate/glyph/", import.meta.url);

/** The faces, and the styles of the font that they are taken from. */
export const FACES = [
  { name: "italic", style: "italic" },
  { name: "roman", style: "normal" },
];

/** Units per em. At 40 pixels per em a letter is never off by more than a tenth of a pixel. */
const EM = 256;

/** The least kerning that is kept, as a share of the em. */
const LEAST_KERNING = 0.03;

/** The characters: ASCII, the letters of Latin-1 and Latin Extended-A, and the other characters in names. */
const CODES = [
  range(0x20, 0x7e),
  range(0xc0, 0xff),
  range(0x100, 0x17f),
  [0x2013, 0x2014, 0x2018, 0x2019, 0x201c, 0x201d, 0x2026],
]
  .flat()
  .filter((code) => code !== 0xd7 && code !== 0xf7);

const LETTERS = CODES.filter((code) => code < 0x7f && /[A-Za-z]/.test(String.fromCharCode(code)));

/** Returns the bytes of a face's table. */
export function table({ style }) {
  const fonts = ["latin", "latin-ext"].map((subset) => open(`eb-garamond-${subset}-400-${style}.woff2`));
  const glyphs = CODES.flatMap((code) => {
    const font = fonts.find((font) => font.hasGlyphForCodePoint(code));
    return font ? [{ code, ...glyphOf(font, font.glyphForCodePoint(code)) }] : [];
  });
  const shapes = new Map();
  const numberOf = (contours) => {
    const key = JSON.stringify(contours);
    if (!shapes.has(key)) shapes.set(key, shapes.size);
    return shapes.get(key);
  };
  const letters = glyphs.map((glyph) => ({
    ...glyph,
    parts: glyph.parts.map((part) => ({ ...part, shape: numberOf(part.contours) })),
  }));
  const out = [];
  list(
    out,
    [...shapes.keys()].map((key) => JSON.parse(key)),
    writeShape,
  );
  let last = 0;
  list(out, letters, (out, { code, advance, parts }) => {
    whole(out, code - last);
    last = code;
    whole(out, baseOf(code));
    whole(out, advance);
    list(out, parts, (out, { shape, dx, dy }) => {
      whole(out, shape);
      signed(out, dx);
      signed(out, dy);
    });
  });
  list(out, kerning(fonts[0]), writeRow);
  return Uint8Array.from(out);
}

function open(name) {
  return fontkit.create(readFileSync(new URL(name, FILES)));
}

function range(first, last) {
  return Array.from({ length: last - first + 1 }, (_, i) => first + i);
}

/** Returns a letter without its accent, as kerning uses it. */
function baseOf(code) {
  return String.fromCodePoint(code).normalize("NFD").codePointAt(0);
}

const scaled = (font, length) => Math.round((length * EM) / font.unitsPerEm);

/** Returns a glyph's advance, and the shapes of which it consists. */
function glyphOf(font, glyph) {
  return {
    advance: Math.max(0, scaled(font, glyph.advanceWidth)),
    parts: partsOf(font, glyph, 0, 0).filter(({ contours }) => contours.length),
  };
}

function partsOf(font, glyph, dx, dy) {
  const { components } = glyph._decode() ?? {};
  if (!components) return [{ dx: scaled(font, dx), dy: scaled(font, dy), contours: contoursOf(font, glyph) }];
  return components.flatMap((part) => {
    if (part.scaleX !== 1 || part.scaleY !== 1 || part.scale01 !== 0 || part.scale10 !== 0)
      throw new Error("a part is scaled");
    return partsOf(font, font.getGlyph(part.glyphID), dx + part.dx, dy + part.dy);
  });
}

/** Returns the contours of a shape, each a list of [x, y, whether the point is on the line]. */
function contoursOf(font, glyph) {
  const contours = [];
  let contour = [];
  for (const { onCurve, endContour, x, y } of glyph._decode()?.points ?? []) {
    contour.push([scaled(font, x), scaled(font, y), onCurve ? 1 : 0]);
    if (!endContour) continue;
    const kept = thinned(contour);
    if (kept.length > 2) contours.push(kept);
    contour = [];
  }
  return contours;
}

/** Removes points that repeat the one before, and those midway between two controls. The result begins on the line. */
function thinned(contour) {
  const points = contour.filter(([x, y], i) => {
    const [beforeX, beforeY] = contour.at(i - 1);
    return x !== beforeX || y !== beforeY;
  });
  const first = points.findIndex(([, , on]) => on);
  if (first < 0) throw new Error("a contour has no point on its line");
  const turned = [...points.slice(first), ...points.slice(0, first)];
  return turned.filter(([x, y, on], i) => {
    const [before, after] = [turned.at(i - 1), turned[(i + 1) % turned.length]];
    const isMiddle = Math.abs(before[0] + after[0] - 2 * x) <= 1 && Math.abs(before[1] + after[1] - 2 * y) <= 1;
    return i === 0 || !on || before[2] || after[2] || !isMiddle;
  });
}

function writeShape(out, contours) {
  let [x, y] = [0, 0];
  list(out, contours, (out, points) => {
    whole(out, points.length);
    for (let i = 0; i < points.length; i += 8) {
      out.push(points.slice(i, i + 8).reduce((bits, [, , on], bit) => bits | (on << bit), 0));
    }
    for (const [toX, toY] of points) {
      signed(out, toX - x);
      signed(out, toY - y);
      [x, y] = [toX, toY];
    }
  });
}

/** Returns the rows of kerning: each letter that has any, with the letters after it and their distances. */
function kerning(font) {
  const rows = new Map();
  for (const first of LETTERS) {
    const pairs = LETTERS.flatMap((second) => {
      const closer = scaled(font, kerned(font, first, second));
      return Math.abs(closer) >= LEAST_KERNING * EM ? [[second, closer]] : [];
    });
    if (pairs.length === 0) continue;
    const key = JSON.stringify(pairs);
    rows.set(key, [...(rows.get(key) ?? []), first]);
  }
  return [...rows].map(([key, firsts]) => ({ firsts, pairs: JSON.parse(key) }));
}

function kerned(font, first, second) {
  const none = { liga: false, clig: false, calt: false, dlig: false };
  const { glyphs, positions } = font.layout(String.fromCharCode(first, second), { ...none, kern: true });
  if (glyphs.length !== 2) throw new Error("two letters have become one");
  return positions[0].xAdvance - glyphs[0].advanceWidth;
}

function writeRow(out, { firsts, pairs }) {
  list(out, firsts, whole);
  list(out, pairs, (out, [second, closer]) => {
    whole(out, second);
    signed(out, closer);
  });
}

/** Writes the number of items, then each of them. */
function list(out, items, write) {
  whole(out, items.length);
  for (const item of items) write(out, item);
}

/** Writes a number in seven bits per byte, the lowest first; the eighth bit says that more follow. */
function whole(out, number) {
  for (let rest = number; ; rest >>= 7) {
    if (rest < 128) return void out.push(rest);
    out.push((rest & 127) | 128);
  }
}

/** Writes 0, −1, 1, −2, 2 … as 0, 1, 2, 3, 4. */
function signed(out, number) {
  whole(out, number < 0 ? -2 * number - 1 : 2 * number);
}

if (process.argv[1] === fileURLToPath(import.meta.url))
  for (const face of FACES) writeFileSync(new URL(`${face.name}.bin`, TABLES), table(face));
