/** The tarball holds what it says, whole, and nothing else. */

import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { publint } from "publint";
import { formatMessage } from "publint/utils";
import { parse } from "smol-toml";
import { expect, test } from "vitest";
import { reachable } from "../../scripts/reachable.mjs";
import { bytes, type Description, files, INSTALLED, json, targets } from "./installed.ts";

const description = json<Description>("package.json");
const crate = parse(readFileSync(new URL("../../../Cargo.toml", import.meta.url), "utf8"))["package"] as {
  version: string;
  license: string;
};

/** What people and registries read, and no program asks for. */
const DOCUMENTS = ["CHANGELOG.md", "LICENSE-APACHE", "LICENSE-MIT", "README.md", "THIRD-PARTY.txt"];

test("every file that an entry names is there, its types before its script", () => {
  for (const [entry, target] of Object.entries(description.exports)) {
    const named = targets(target);
    for (const [, path] of named) expect(files(), entry).toContain(path);
    const types = named.findIndex(([condition]) => condition === "types");
    expect(types, entry).toBeLessThanOrEqual(0);
  }
});

test("the entries are the class, its registration, the engine, the bundle, the wasm files and the manifest", () => {
  expect(Object.keys(description.exports)).toEqual(
    expect.arrayContaining([
      ...[".", "./define", "./core", "./node", "./river-seed.js"],
      ...["./riverseed_bg.wasm", "./riverseed_label_bg.wasm", "./riverseed_engine_bg.wasm", "./custom-elements.json"],
    ]),
  );
  expect(files()).toContain(description.customElements);
});

test("no file is missing, and none is there that nobody asks for", () => {
  const entries = Object.values(description.exports).flatMap((target) => targets(target).map(([, path]) => path));
  const wanted = reachable(entries, (path) => bytes(path).toString());
  expect([...wanted, ...DOCUMENTS].sort()).toEqual(files());
});

test("its changelog, licences and third-party notices are the project's, and its README is the element's page", () => {
  for (const name of DOCUMENTS) {
    const path = name === "README.md" ? "docs/element.md" : name;
    const ours = readFileSync(new URL(`../../../${path}`, import.meta.url), "utf8");
    expect(bytes(name).toString(), name).toBe(ours);
  }
});

test("only what registers the element has effects on being imported", () => {
  expect(description.sideEffects).toEqual(["./define.js", "./river-seed.js"]);
});

test("its version and licence are the crate's", () => {
  expect(description).toMatchObject({ name: "riverseed", version: crate.version, license: crate.license });
});

test("an integrity hash is listed for every script and module, and is right", () => {
  const served = files().filter((path) => /\.(js|wasm)$/.test(path));
  const hashes = served.map((path) => [path, `sha384-${createHash("sha384").update(bytes(path)).digest("base64")}`]);
  expect(json("integrity.json")).toEqual(Object.fromEntries(hashes));
});

test("the registry's linter finds nothing to say", async () => {
  const { messages } = await publint({ pkgDir: INSTALLED, strict: true });
  expect(messages.map((message) => formatMessage(message, { ...description }))).toEqual([]);
});
