import { expect, test } from "vitest";
import { type Arrival, isMet } from "../../src/apps/page/welcome.ts";
import type { Keeper } from "../../src/controls/disclosure.ts";

const HERE = "https://rivers.example/maps/";

/** A visit of an address from another one. */
function visit(query: string, referrer = "", isElsewhere = false): Arrival {
  return { address: new URL(query, HERE), referrer, isElsewhere };
}

const LINKED = visit("?seed=Ardenmoor");

function keeper(kept?: string): () => Keeper {
  return () => ({ getItem: () => kept ?? null, setItem: () => {} });
}

test("who comes by a link is met, and nobody else", () => {
  expect(isMet(LINKED, keeper())).toBe(true);
  expect(isMet(visit("#seed=Ardenmoor"), keeper())).toBe(true);
  expect(isMet(visit("?seed=Ardenmoor", "https://chat.example/"), keeper())).toBe(true);
  for (const bare of ["", "?utm_source=chat", "#top"]) expect(isMet(visit(bare), keeper()), bare).toBe(false);
  expect(isMet(visit("?seed=skye", `${HERE}gallery/skye.html`), keeper())).toBe(false);
  expect(isMet(visit("?seed=Ardenmoor&view=six", "", true), keeper())).toBe(false);
});

test("a page that loads itself again is no other page", () => {
  expect(isMet(visit("?seed=Ardenmoor", `${HERE}?seed=Ardenmoor`), keeper())).toBe(true);
});

test("who was met in this tab or made a country there is not met again", () => {
  expect(isMet(LINKED, keeper("yes"))).toBe(false);
});

test("where nothing can be stored the line still comes", () => {
  const refuse = (): Keeper => {
    throw new DOMException("no", "SecurityError");
  };
  expect(isMet(LINKED, refuse)).toBe(true);
});
