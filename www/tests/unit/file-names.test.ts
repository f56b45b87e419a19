import { expect, test } from "vitest";
import { fileName } from "../../src/apps/page/save/file-names.ts";
import { table } from "../table.ts";

test("a file is called after its seed, its style and its size", () => {
  expect(fileName("skye", "png", "atlas", 4961)).toBe("skye-atlas-4961.png");
  expect(fileName("skye", "svg", "past-courses")).toBe("skye-past-courses.svg");
  expect(fileName("skye", "geojson")).toBe("skye.geojson");
});

test.each([
  ["Isle of Skye", "Isle-of-Skye"],
  ["te wai māori", "te-wai-māori"],
  ["नदी", "नदी"],
  ["河流", "河流"],
  ["", "riverseed"],
  ["🌊", "riverseed"],
  ["../../etc/passwd", "etc-passwd"],
  ["C:\\Windows\\system32", "C-Windows-system32"],
  [".hidden", "hidden"],
  ["-rf", "rf"],
  ["a\0b\nc", "a-b-c"],
  ["a\u202egnp.exe", "a-gnp-exe"],
  ["%2e%2e%2f", "2e-2e-2f"],
  ["<script>", "script"],
  ["\u0301", "riverseed"],
  ["con", "riverseed-con"],
  ["Com1", "riverseed-Com1"],
  ["console", "console"],
])("the seed %j is no path and no trick: %s", (seed, word) => {
  expect(fileName(seed, "json")).toBe(`${word}.json`);
});

test("of a long seed there is a beginning, whatever its script", () => {
  for (const letter of ["w", "河", "𐎀", "é"]) {
    const name = fileName(letter.repeat(64), "webm", "past-courses", 8192);
    expect(new TextEncoder().encode(name).length).toBeLessThan(255);
    expect(name).toBe(`${letter.repeat(40)}-past-courses-8192.webm`);
  }
  expect(fileName(`${"w".repeat(39)} and more`, "json")).toBe(`${"w".repeat(39)}.json`);
});

test("every style is a word that a name can have", () => {
  const styles = table.parameters.find(({ key }) => key === "style")?.choices ?? [];
  expect(styles.length).toBeGreaterThan(10);
  for (const { value } of styles) expect(value).toMatch(/^[a-z-]+$/);
});
