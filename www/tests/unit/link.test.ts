import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { AddressBar, addressOf, asQuery, linkOf, WRITE_EVERY_MS } from "../../src/browser/address.ts";
import { linkText } from "../../src/engine/link-text.ts";
import { engine } from "../core.ts";
import { MANGLED } from "../mangled.ts";

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

function recorded(): { bar: AddressBar; written: string[] } {
  const written: string[] = [];
  return { bar: new AddressBar((link) => written.push(link)), written };
}

test("the first link is written at once", () => {
  const { bar, written } = recorded();
  bar.show("a");
  expect(written).toEqual(["a"]);
});

test("of many links in a hurry the latest is written, once, when the time is up", () => {
  const { bar, written } = recorded();
  for (const link of ["a", "b", "c", "d"]) bar.show(link);
  vi.advanceTimersByTime(WRITE_EVERY_MS - 1);
  expect(written).toEqual(["a"]);
  vi.advanceTimersByTime(1);
  expect(written).toEqual(["a", "d"]);
  vi.advanceTimersByTime(10 * WRITE_EVERY_MS);
  expect(written).toEqual(["a", "d"]);
});

test("a steady stream is written at the bounded rate", () => {
  const { bar, written } = recorded();
  for (let time = 0; time < 5000; time += 10) {
    bar.show(String(time));
    vi.advanceTimersByTime(10);
  }
  expect(written.length).toBeLessThanOrEqual(5000 / WRITE_EVERY_MS + 1);
  expect(written.length).toBeGreaterThan(5);
});

test("after a rest a link is written at once again", () => {
  const { bar, written } = recorded();
  bar.show("a");
  vi.advanceTimersByTime(WRITE_EVERY_MS);
  bar.show("b");
  expect(written).toEqual(["a", "b"]);
});

test("flushing writes what waits now, and not again later", () => {
  const { bar, written } = recorded();
  bar.show("a");
  bar.show("b");
  bar.flush();
  bar.flush();
  vi.advanceTimersByTime(WRITE_EVERY_MS);
  expect(written).toEqual(["a", "b"]);
});

test("a link is read from the query, or from a fragment that holds one", () => {
  expect(linkOf({ search: "?seed=kauri", hash: "" })).toBe("seed=kauri");
  expect(linkOf({ search: "?seed=kauri", hash: "#top" })).toBe("seed=kauri");
  expect(linkOf({ search: "?seed=kauri", hash: "#seed=rimu" })).toBe("seed=rimu");
  expect(linkOf({ search: "", hash: "" })).toBe("");
});

test("the page's engine reads the core's damaged links as the map that they are of, and tells", () => {
  const { link } = engine.readLink("seed=rimu&land=valley");
  expect(MANGLED.filter(([, isDamaged]) => isDamaged).length).toBeGreaterThanOrEqual(40);
  for (const [text, isDamaged] of MANGLED) {
    const read = engine.readLink(text);
    expect(read.link, text).toBe(link);
    expect(
      read.notices.some(({ key }) => key === "link"),
      text,
    ).toBe(isDamaged);
  }
});

test("an address that was damaged on its way opens its map, and says so", () => {
  const { link } = engine.readLink("seed=kauri&land=valley");
  for (const address of [
    "?seed=kauri&amp;land=valley&amp;fbclid=1",
    "?land=valley&seed=kauri)",
    "?seed%3Dkauri%26land%3Dvalley",
    "#seed%3Dkauri%26land%3Dvalley",
    "#land=valley&seed=kauri,",
    "?seed=kauri&land=valley%20",
  ]) {
    const read = engine.readLink(asQuery(linkOf(new URL(address, "https://rivers.example/"))));
    expect(read.link, address).toBe(link);
    expect(
      read.notices.map(({ key }) => key),
      address,
    ).toEqual(["link"]);
  }
  expect(engine.readLink(asQuery(linkOf({ search: "?Why!", hash: "" }))).values[0]).toEqual(["seed", "Why!"]);
});

test("a typed word is an address only if it is one of a map", () => {
  for (const address of ["https://rivers.example/?seed=rimu&land=valley", "?seed=rimu", "<https://a.example/#seed=a>"])
    expect(engine.isAddress(address), address).toBe(true);
  for (const word of ["kauri", "Why? a=b", "C#", "100%", "seed=rimu&land=valley", "https://rivers.example/", "a & b"])
    expect(engine.isAddress(word), word).toBe(false);
});

test("an address keeps its page and takes the link as its query", () => {
  expect(addressOf("seed=kauri", "https://example.org/maps/?seed=x#seed=y")).toBe(
    "https://example.org/maps/?seed=kauri",
  );
});

test("hostile values become link text that reads back", () => {
  const values = [
    ["seed", 'a&b=c <script>"+"</script> ü 🌊 %'],
    ["curl", "0.6"],
  ] as const;
  const text = linkText(values);
  expect([...new URLSearchParams(text)]).toEqual(values);
  expect(text).not.toMatch(/[<>" +]/);
});

test("half a character does not stop the page", () => {
  expect(linkText([["seed", "a\ud800"]])).toBe("seed=a%EF%BF%BD");
});
