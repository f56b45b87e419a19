// Links, and what the text alternative of a picture says where its author gives none.

import assert from "node:assert/strict";

/** Each a link and the seed that it names. */
export const LINKS = [
  ["?seed=caf%C3%A9+noir&sea=0.5", "café noir"],
  ["sea=0.5", "kauri"],
];

/** Expects the text alternatives of these links in a page, in their order. */
export function expectAlternatives(page) {
  const alts = [...page.matchAll(/<img[^>]* alt="([^"]*)"/g)].map(([, alt]) => alt);
  assert.deepEqual(
    alts,
    LINKS.map(([, seed]) => `Rivers grown from “${seed}”`),
  );
}
