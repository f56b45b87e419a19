import { expect, test } from "vitest";
import { readQuery } from "../../src/apps/embed/query.ts";
import { linkOf } from "../../src/browser/address.ts";
import { withoutTrackers } from "../../src/browser/trackers.ts";
import { engine } from "../core.ts";
import { table } from "../table.ts";

const TRACKERS = "utm_source=news&utm_campaign=a%20b&fbclid=IwAR0&gclid=x&mc_cid=1&ref=blog&msclkid=&igshid";

test("what others hang on to an address is no part of the link, wherever it stands", () => {
  const place = (search: string, hash = ""): { search: string; hash: string } => ({ search, hash });
  expect(linkOf(place(`?${TRACKERS}`))).toBe("");
  expect(linkOf(place(`?fbclid=1&seed=a%20b&${TRACKERS}&curl=.5`))).toBe("seed=a%20b&curl=.5");
  expect(linkOf(place("", `#seed=rimu&${TRACKERS}`))).toBe("seed=rimu");
});

test("a fragment of trackers alone is no link: the query is", () => {
  expect(linkOf({ search: "?seed=kauri", hash: "#utm_source=news" })).toBe("seed=kauri");
  expect(linkOf({ search: "?seed=kauri&fbclid=1", hash: "#top" })).toBe("seed=kauri");
});

test("without trackers nothing is changed, however it is spelt", () => {
  for (const text of ["", "seed=kauri", "seed=a+b%20c&&=&%", "seed=utm_source&outline=fbclid", "sead=x&UTM_source=1"])
    expect(withoutTrackers(text)).toBe(text);
});

test("unknown keys are told of, trackers are not", () => {
  const { notices } = engine.readLink(linkOf({ search: `?${TRACKERS}&sead=kauri`, hash: "" }));
  expect(notices.map(({ key }) => key)).toEqual(["sead"]);
});

test("no key of ours is taken for a tracker", () => {
  const ours = [...table.parameters.map(({ key }) => key), "preset", "controls", "still", "theme"];
  for (const key of ours) expect(withoutTrackers(`${key}=1`)).toBe(`${key}=1`);
});

test("the frame passes them over too", () => {
  const { recipe, attributes } = readQuery(linkOf({ search: `?theme=dark&${TRACKERS}&seed=rimu`, hash: "" }));
  expect(recipe).toBe("seed=rimu");
  expect([...attributes]).toEqual([["theme", "dark"]]);
});
