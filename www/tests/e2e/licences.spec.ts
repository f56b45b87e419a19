/** The site carries the notices of those whose work it hands out. */

import { readFileSync } from "node:fs";
import { expect, test } from "@playwright/test";

test("the notices of the crates in the wasm modules are served with the page @core", async ({ request }) => {
  const response = await request.get("./THIRD-PARTY.txt");
  expect(response.ok()).toBe(true);
  const text = await response.text();
  expect(text).toBe(readFileSync(new URL("../../../THIRD-PARTY.txt", import.meta.url), "utf8"));
  for (const crate of ["tiny-skia", "tiny-skia-path", "arrayref", "fastnoise-lite", "libm", "strict-num"])
    expect(text).toMatch(new RegExp(`^  ${crate} \\d`, "m"));
});

test("the licence of what writes videos is served with the page, and says where its source is", async ({ request }) => {
  const response = await request.get("./LICENSE-mediabunny.txt");
  expect(response.ok()).toBe(true);
  const text = await response.text();
  expect(text).toContain("https://github.com/Vanilagy/mediabunny");
  expect(text).toContain("Mozilla Public License Version 2.0");
});
