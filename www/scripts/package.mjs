#!/usr/bin/env node
// Packs the npm package: target/package/riverseed-<version>.tgz.
//
// The widget must have been built (npm run build:widget). The sources of the files in the tarball: scripts and .wasm
// files are
// from dist-widget; README is docs/element.md; package.json and framework types are from package/, with the version and
// the
// description of Cargo.toml; declarations come from the sources; custom-elements.json and the types of markup from the
// parameter table; integrity.json from all files that a page loads.

import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { cpSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { parse } from "smol-toml";
import { manifest, markupTypes } from "./manifest.mjs";
import { reachable } from "./reachable.mjs";

process.chdir(join(dirname(fileURLToPath(import.meta.url)), ".."));
const TARBALLS = "../target/package";
const STAGE = "../target/npm";

const table = readJson("src/engine/parameters.json").parameters;
const own = readJson("package/element.json");

rmSync(STAGE, { recursive: true, force: true });
mkdirSync(join(STAGE, "types"), { recursive: true });
mkdirSync(TARBALLS, { recursive: true });
scripts();
declarations();
writeJson("custom-elements.json", manifest(own, table));
writeJson("integrity.json", integrity());
writeJson("package.json", description());
documents();
weigh();
pack();

function readJson(file) {
  return JSON.parse(readFileSync(file, "utf8"));
}

function writeJson(name, value) {
  writeFileSync(join(STAGE, name), `${JSON.stringify(value, null, 2)}\n`);
}

function scripts() {
  cpSync("dist-widget", STAGE, { recursive: true });
}

/** Writes the declarations of the sources, of the engine, and of the element in frameworks' markup. */
function declarations() {
  const types = join(STAGE, "types");
  run("tsc", "--project", "package/tsconfig.json", "--outDir", types);
  for (const name of readdirSync("package").filter((name) => name.endsWith(".d.ts"))) {
    cpSync(join("package", name), join(types, name));
  }
  for (const declared of ["pkg-make/riverseed.d.ts", "pkg-engine/riverseed_engine.d.ts"]) {
    mkdirSync(dirname(join(types, declared)));
    cpSync(declared, join(types, declared));
  }
  writeFileSync(join(types, "markup.d.ts"), markupTypes(own, table));
  const all = readdirSync(types, { recursive: true }).filter((name) => name.endsWith(".d.ts"));
  for (const file of all) nameScripts(join(types, file));
  const entries = Object.values(readJson("package/package.json").exports).flatMap(({ types }) => types?.slice(2) ?? []);
  const wanted = reachable(entries, (path) => readFileSync(join(STAGE, path), "utf8"));
  for (const file of all.filter((file) => !wanted.has(`types/${file}`))) rmSync(join(types, file));
}

/** Replaces .ts in imports by .js. Our sources import each other as .ts, which the compiler keeps in declarations. */
function nameScripts(file) {
  writeFileSync(file, readFileSync(file, "utf8").replace(/((?:from |import\()"\.[^"]*)\.ts"/g, '$1.js"'));
}

/** Returns the files that a page may load. */
function served() {
  const isServed = (name) => /\.(js|wasm)$/.test(name);
  return readdirSync(STAGE).filter(isServed).sort();
}

/** Returns the hashes of these files, for `integrity="…"` and for checking copies. */
function integrity() {
  const hash = (name) =>
    createHash("sha384")
      .update(readFileSync(join(STAGE, name)))
      .digest("base64");
  return Object.fromEntries(served().map((name) => [name, `sha384-${hash(name)}`]));
}

function description() {
  const { version, description, license, keywords } = parse(readFileSync("../Cargo.toml", "utf8")).package;
  const { name, ...rest } = readJson("package/package.json");
  return { name, version, description, license, keywords: [...keywords, "web-component"], ...rest };
}

function documents() {
  cpSync("../docs/element.md", join(STAGE, "README.md"));
  for (const name of ["CHANGELOG.md", "LICENSE-APACHE", "LICENSE-MIT", "THIRD-PARTY.txt"])
    cpSync(`../${name}`, join(STAGE, name));
}

/** Prints the compressed size of each file. */
function weigh() {
  for (const name of served()) {
    const bytes = gzipSync(readFileSync(join(STAGE, name)), { level: 9 }).length;
    console.log(`${name.padEnd(28)} ${String(bytes).padStart(7)} bytes of gzip`);
  }
}

function pack() {
  for (const older of readdirSync(TARBALLS).filter((name) => name.endsWith(".tgz"))) rmSync(join(TARBALLS, older));
  const said = run("npm", "pack", STAGE, "--json", "--pack-destination", TARBALLS);
  const [{ filename, size, unpackedSize, entryCount }] = JSON.parse(said);
  console.log(`target/package/${filename}: ${size} bytes, ${unpackedSize} unpacked, ${entryCount} files`);
}

/** Runs a program and returns its output. Its errors are shown. */
function run(...[program, ...words]) {
  return execFileSync(program, words, { encoding: "utf8", stdio: ["ignore", "pipe", "inherit"] });
}
