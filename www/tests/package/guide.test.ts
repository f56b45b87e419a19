/** The program for Node of the guide to JavaScript, saved as the guide says. */

import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { expect, test } from "vitest";
import { CONSUMERS } from "./installed.ts";

const GUIDE = readFileSync(new URL("../../../docs/for/javascript.md", import.meta.url), "utf8");

test("the guide's program for Node writes a map where it is run", () => {
  const [, name = "", program = ""] = /Save this as `([\w.]+)`[\s\S]*?```js\n([\s\S]*?)```/.exec(GUIDE) ?? [];
  const folder = join(CONSUMERS, "guide");
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder);
  writeFileSync(join(folder, name), program);
  execFileSync(process.execPath, [name], { cwd: folder });
  expect(readFileSync(join(folder, "kauri.svg"), "utf8")).toMatch(/^<svg[\s\S]*<\/svg>\n?$/);
});
