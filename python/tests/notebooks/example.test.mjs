/** The example notebook runs from its first cell to its last with the packages that people have, and without a warning. */

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { environment, folder } from "./host.mjs";

const EXAMPLE = fileURLToPath(new URL("../../examples/fifty-rivers.ipynb", import.meta.url));

const cellsOf = (path) => JSON.parse(readFileSync(path, "utf8")).cells.filter(({ cell_type }) => cell_type === "code");

test("fifty rivers are grown, measured and plotted", () => {
  const home = folder();
  const done = join(home, "done.ipynb");
  const words = [EXAMPLE, `--output=${done}`, "--timeout=300"];
  const program = join(process.env.NOTEBOOKS, "bin", "jupyter-execute");
  execFileSync(program, words, { env: environment(home), cwd: home, stdio: "pipe" });
  const outputs = cellsOf(done).flatMap(({ outputs }) => outputs);
  assert.deepEqual(
    outputs.filter(({ output_type }) => output_type === "stream" || output_type === "error"),
    [],
  );
  const data = outputs.map(({ data }) => data);
  const table = data.map((forms) => [forms["text/html"] ?? ""].flat().join("")).join("");
  assert.equal(table.match(/<th>river-\d+<\/th>/g)?.length, 50);
  assert.ok(data.some((forms) => "application/vnd.jupyter.widget-view+json" in forms));
  assert.equal(data.filter((forms) => "image/png" in forms).length, 5, "the map and four figures");
});

test("it is committed without outputs", () => {
  for (const { outputs, execution_count } of cellsOf(EXAMPLE)) {
    assert.deepEqual(outputs, []);
    assert.equal(execution_count, null);
  }
});
