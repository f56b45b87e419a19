import { existsSync, readdirSync, readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { overrides } from "../../biome.folders.json";

/** What each folder may use, as ARCHITECTURE.md has it, in its order; a remark after a semicolon is for readers. */
const SAID = [
  ...readFileSync("../ARCHITECTURE.md", "utf8").matchAll(/^\| `www\/src\/(\w+)\/` \|.*\| ([^|]*) \|$/gm),
].map(([, folder = "", uses = ""]) => ({ folder, uses: uses.replace(/;.*/, "").split(", ").filter(isFolder) }));

function isFolder(name: string): boolean {
  return existsSync(`src/${name}`);
}

/** What of other folders each lint for files of this one lets through. */
function allowedIn(folder: string): string[][] {
  const groups = overrides
    .filter(({ includes }) => includes[0] === `src/${folder}/**`)
    .map(({ linter }) => linter.rules.style.noRestrictedImports?.options.patterns[0]?.group ?? []);
  return groups.map((group) => group.filter((pattern) => /^!\.\.\/(?!\.\.)/.test(pattern)));
}

test("every folder of sources has a line of its own, and no source lies beside them", () => {
  expect(SAID.map(({ folder }) => folder).sort()).toEqual(readdirSync("src").sort());
});

test("a folder uses only those above it, so that no two use each other", () => {
  const above: string[] = [];
  for (const { folder, uses } of SAID) {
    expect(above, folder).toEqual(expect.arrayContaining(uses));
    above.push(folder);
  }
});

// Style sheets import each other only, which the lint does not read.
test.each(SAID.filter(({ folder }) => folder !== "style"))(
  "the lint holds $folder to what is said",
  ({ folder, uses }) => {
    const allowed = allowedIn(folder);
    expect(allowed).not.toEqual([]);
    for (const one of allowed) expect(one).toEqual(uses.map((name) => `!../${name}/*`));
  },
);

test.each(SAID)("$folder uses all that is said", ({ folder, uses }) => {
  const sources = readdirSync(`src/${folder}`).map((name) => readFileSync(`src/${folder}/${name}`, "utf8"));
  for (const name of uses) expect(sources.join("\n"), name).toContain(`"../${name}/`);
});
