import { existsSync, readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { parse } from "smol-toml";
import { expect, test } from "vitest";

interface Late {
  from: string;
  why: string;
  late: string[];
}

const { www: USES, www_late: LATE } = parse(readFileSync("../docs/layers.toml", "utf8")) as unknown as {
  www: Record<string, string[]>;
  www_late: Late[];
};

/** Every script and style sheet of src by its path there, with its text. */
const SOURCES = new Map(
  readdirSync("src", { recursive: true, encoding: "utf8" })
    .filter((path) => /\.(ts|css)$/.test(path))
    .map((path) => [path, readFileSync(join("src", path), "utf8")]),
);

/** The folder that a path belongs to: the first of its path, and in `apps` the second as well. */
function folderOf(path: string): string {
  return /^(apps\/)?[^/]+/.exec(path)?.[0] ?? path;
}

/** All that a source imports, at whatever time, as paths in src or as `npm:`, `pkg` or `tests`. */
function importsOf(path: string): string[] {
  return placesIn(path, /(?:^(?:import|export)\b[^;"=]*? from |^@?import |\bimport\(|new URL\()"([^"]+)"/gm);
}

/** What a script needs before it runs: neither types, nor what it imports when it is asked to. */
function needsOf(path: string): string[] {
  return placesIn(path, /^(?:import|export) (?!type\b)(?:[^;"=]*? from )?"([^"]+)"/gm);
}

function placesIn(path: string, imports: RegExp): string[] {
  const named = [...(SOURCES.get(path) ?? "").matchAll(imports)];
  return named.map(([, name = ""]) => placeOf(name, path)).filter((place) => place !== undefined);
}

function placeOf(name: string, from: string): string | undefined {
  if (!name.startsWith(".")) return name.startsWith("node:") ? name : `npm:${name}`;
  const path = join(dirname(from), name.replace(/\?.*/, ""));
  if (path.startsWith("../pkg")) return "pkg";
  if (path.startsWith("../../tests/")) return "tests";
  // Addresses of what is built lie beside no source.
  return existsSync(join("src", path)) ? path : undefined;
}

function isOurs(use: string): boolean {
  return use in USES;
}

test("every folder of sources has a line of its own, and no source lies beside them", () => {
  const folders = new Set([...SOURCES.keys()].map(folderOf));
  expect(Object.keys(USES).sort()).toEqual([...folders].sort());
});

test("a folder uses only those above it, so that no two use each other", () => {
  const above: string[] = [];
  for (const [folder, uses] of Object.entries(USES)) {
    expect(above, folder).toEqual(expect.arrayContaining(uses.filter(isOurs)));
    above.push(folder);
  }
});

test.each(Object.entries(USES))("%s uses what its line says, all of it and nothing else", (folder, uses) => {
  const used = new Set<string>();
  for (const path of SOURCES.keys()) {
    if (folderOf(path) !== folder) continue;
    for (const place of importsOf(path)) {
      const use = place.includes(":") || !place.includes("/") ? place : folderOf(place);
      if (use === folder) continue;
      expect(uses, `${path} imports ${place}`).toContain(use);
      used.add(use);
    }
  }
  expect([...used].sort()).toEqual([...uses].sort());
});

test("no sources import each other in a circle, not even in one folder", () => {
  const imports = new Map([...SOURCES.keys()].map((path) => [path, importsOf(path)]));
  const circles = [...SOURCES.keys()].filter((start) => {
    const reached = new Set(imports.get(start));
    // A set goes on with what is added while it is walked.
    for (const path of reached) for (const next of imports.get(path) ?? []) reached.add(next);
    return reached.has(start);
  });
  expect(circles).toEqual([]);
});

test.each(LATE)("$from does not load what comes late: $why", ({ from, late }) => {
  for (const name of late) expect(existsSync(join("src", name)), name).toBe(true);
  const reached = new Map([[from, from]]);
  // A map goes on with what is added while it is walked.
  for (const [path, way] of reached) {
    expect(
      late.find((name) => path === name || (name.endsWith("/") && path.startsWith(name))),
      way,
    ).toBeUndefined();
    for (const need of needsOf(path)) if (!reached.has(need)) reached.set(need, `${way} → ${need}`);
  }
  expect(reached.size).toBeGreaterThan(10);
});
