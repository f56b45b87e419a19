import { afterEach, expect, test, vi } from "vitest";
import { countIn } from "../../../src/apps/widget/strings.ts";

/** As much of an element as is asked for its language. */
function element(lang: string | null): Element {
  return { closest: () => lang && { getAttribute: () => lang } } as unknown as Element;
}

afterEach(() => {
  vi.restoreAllMocks();
});

test.each(["en", "EN-gb", "de", "de-CH", "es-419", "fr", "it", "ja", "nl", "pt-BR", "ru", "zh-Hant"])(
  "in %s small numbers are as the browser writes them, which is not asked for them, since it takes long",
  (lang) => {
    const numbers = Array.from({ length: 1000 }, (_, i) => i);
    const expected = numbers.map((number) => number.toLocaleString(lang));
    const asked = vi.spyOn(Number.prototype, "toLocaleString");
    expect(numbers.map(countIn(element(lang)))).toEqual(expected);
    expect(asked).not.toHaveBeenCalled();
  },
);

test.each([
  ["de", 1234, "1.234"],
  ["de", 0.5, "0,5"],
  ["en", 12345, "12,345"],
  ["en", -5, "-5"],
  ["ar-EG", 87, "٨٧"],
  ["fa", 87, "۸۷"],
  ["en-u-nu-deva", 87, "८७"],
  ["no language", 1234, "1234"],
])("in %s %d is %s", (lang, number, text) => {
  expect(countIn(element(lang))(number)).toBe(text);
});

test("where no language is named it is the browser's", () => {
  expect(countIn(element(null))(1234)).toBe((1234).toLocaleString());
});
