import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { Heights, REST_MS } from "../../src/apps/embed/heights.ts";
import { hostOrigin } from "../../src/apps/embed/host-page.ts";
import { themeIn } from "../../src/apps/embed/messages.ts";
import { readQuery } from "../../src/apps/embed/query.ts";

describe("the query", () => {
  test("is a link with the element's attributes among it", () => {
    const { recipe, attributes } = readQuery("seed=kauri&theme=dark&curl=0.6&controls&still&speed=2");
    expect(recipe).toBe("seed=kauri&curl=0.6");
    expect([...attributes]).toEqual([
      ["theme", "dark"],
      ["controls", ""],
      ["still", ""],
      ["speed", "2"],
    ]);
  });

  test("takes the first of two", () => {
    expect(readQuery("theme=dark&seed=a&theme=light").attributes.get("theme")).toBe("dark");
  });

  test("leaves a link as it was written", () => {
    const link = "seed=a%26theme%3Ddark+%F0&&=&curl=%&junk";
    expect(readQuery(link)).toEqual({ recipe: link, attributes: new Map() });
  });

  test("knows no other attributes", () => {
    expect(readQuery("onload=x&wasm-url=//evil&style=atlas&__proto__=1").attributes.size).toBe(0);
  });
});

describe("a theme", () => {
  test("is asked for under our name", () => {
    expect(themeIn({ riverseed: { theme: "dark" } })).toBe("dark");
  });

  for (const message of [
    undefined,
    null,
    "dark",
    ["riverseed"],
    { theme: "dark" },
    { riverseed: "dark" },
    { riverseed: null },
    { riverseed: { theme: "<script>" } },
    { riverseed: { theme: ["dark"] } },
    Object.create({ riverseed: { theme: "dark" } }),
  ]) {
    test(`is not in ${JSON.stringify(message)}`, () => {
      expect(themeIn(message)).toBeUndefined();
    });
  }
});

describe("the page around", () => {
  const around = {};
  const self = {};
  const place = (ancestorOrigins: string[] | undefined, referrer = "", parent = around) => ({
    self,
    parent,
    location: ancestorOrigins ? { ancestorOrigins } : {},
    document: { referrer },
  });

  test("is the nearest, as the browser tells", () => {
    expect(hostOrigin(place(["https://near.example", "https://far.example"], "https://other.example/"))).toBe(
      "https://near.example",
    );
  });

  test("is the one that asked for this page, where the browser does not tell", () => {
    expect(hostOrigin(place(undefined, "https://blog.example/post?x"))).toBe("https://blog.example");
  });

  test("is nobody without an origin, without a name, or without a frame", () => {
    expect(hostOrigin(place(["null"], "https://blog.example/"))).toBeUndefined();
    expect(hostOrigin(place(undefined, ""))).toBeUndefined();
    expect(hostOrigin(place([], "https://blog.example/", self))).toBeUndefined();
  });
});

describe("heights", () => {
  beforeEach(() => {
    vi.useFakeTimers();
  });
  afterEach(() => {
    vi.useRealTimers();
  });

  function recorded() {
    const told: number[] = [];
    return { heights: new Heights((height) => told.push(height)), told };
  }

  test("are told once they rest, rounded up", () => {
    const { heights, told } = recorded();
    for (const height of [100, 200, 300.2]) heights.changed(height);
    vi.advanceTimersByTime(REST_MS - 1);
    expect(told).toEqual([]);
    vi.advanceTimersByTime(1);
    expect(told).toEqual([301]);
  });

  test("are not told twice", () => {
    const { heights, told } = recorded();
    for (const height of [300, 300.0, 299.5, 400]) {
      heights.changed(height);
      vi.advanceTimersByTime(REST_MS);
    }
    expect(told).toEqual([300, 400]);
  });

  test("of nothing are not told", () => {
    const { heights, told } = recorded();
    for (const height of [0, Number.NaN, Number.POSITIVE_INFINITY]) {
      heights.changed(height);
      vi.advanceTimersByTime(REST_MS);
    }
    expect(told).toEqual([]);
  });
});
