/** The types of the package, as strict programs see them: tests/consumers/types, and typed JSX in tests/consumers/react. */

import { spawnSync } from "node:child_process";
import { expect, test } from "vitest";
import { CONSUMERS } from "./installed.ts";

for (const [resolution, project] of [
  ["a bundler", "tsconfig.json"],
  ["Node", "tsconfig.nodenext.json"],
] as const) {
  test(`types compile as ${resolution} finds them`, () => {
    const { stdout } = spawnSync("tsc", ["--project", project], { cwd: CONSUMERS, encoding: "utf8" });
    expect(stdout).toBe("");
  });
}
