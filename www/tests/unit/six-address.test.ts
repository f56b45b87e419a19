import { expect, test } from "vitest";
import { addressOf, asksForSix, linkOf, withSix } from "../../src/browser/address.ts";

const place = (search: string, hash = "") => ({ search, hash });

test("the wish for the six variants is the page's, and no part of the link", () => {
  for (const search of ["?view=six&seed=kea&curl=0.5", "?seed=kea&view=six&curl=0.5", "?seed=kea&curl=0.5&view=six"]) {
    expect(asksForSix(place(search))).toBe(true);
    expect(linkOf(place(search))).toBe("seed=kea&curl=0.5");
    expect(asksForSix(place("", search.replace("?", "#")))).toBe(true);
    expect(linkOf(place("", search.replace("?", "#")))).toBe("seed=kea&curl=0.5");
  }
  expect(linkOf(place("?view=six"))).toBe("");
});

test("any other view is left to whoever reads the link to complain of", () => {
  expect(asksForSix(place("?seed=kea&view=seven"))).toBe(false);
  expect(linkOf(place("?seed=kea&view=seven"))).toBe("seed=kea&view=seven");
  expect(asksForSix(place("?seed=view%3Dsix"))).toBe(false);
  expect(asksForSix(place("?seed=kea"))).toBe(false);
});

test("an address that asks for them leads back to the same link", () => {
  for (const link of ["", "seed=kea&land=island"]) {
    const { search, hash } = new URL(addressOf(withSix(link), "https://example.org/?seed=other#more"));
    expect(linkOf({ search, hash })).toBe(link);
    expect(asksForSix({ search, hash })).toBe(true);
  }
});
