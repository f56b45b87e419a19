// The folder in which examples are built: target/integrations, with the generators' packages and the packed element in it.

import { execFile } from "node:child_process";
import { createHash } from "node:crypto";
import { cpSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";

export const SOURCES = fileURLToPath(new URL("../..", import.meta.url));
export const WORKSHOP = fileURLToPath(new URL("../../../target/integrations", import.meta.url));
export const PACKAGE = join(WORKSHOP, "node_modules/riverseed");

/** The modules of the page's own tests. */
export const ours = createRequire(fileURLToPath(new URL("../../../www/package.json", import.meta.url)));

/** The modules that generators come with. */
export const theirs = createRequire(join(WORKSHOP, "package.json"));
const sharp = theirs("sharp");
const { readLink } = await import(join(PACKAGE, "node.js"));

/** The command line, as `riverseed` on the path of a generator. */
const PROGRAM =
  process.env["RIVERSEED_PROGRAM"] ?? fileURLToPath(new URL("../../../target/debug/riverseed", import.meta.url));

/** The folder for screenshots of the examples. */
export const LOOKS = join(WORKSHOP, "looks");

/** Copies files of `integrations/` to where an example is built, and returns that folder; `changes` replaces texts in them. */
export function copied(name, files, changes = []) {
  const folder = join(WORKSHOP, "sites", name);
  rmSync(folder, { recursive: true, force: true });
  for (const [from, to] of Object.entries(files)) cpSync(join(SOURCES, from), join(folder, to), { recursive: true });
  for (const [file, before, after] of changes) replace(join(folder, file), before, after);
  return folder;
}

function replace(file, before, after) {
  const text = readFileSync(file, "utf8");
  if (!text.includes(before)) throw new Error(`${file} has no ${before}`);
  writeFileSync(file, text.replaceAll(before, after));
}

/** Copies the element's files, as an author does whose generator knows no npm. */
export function copyElement(folder) {
  mkdirSync(folder, { recursive: true });
  for (const name of Object.keys(JSON.parse(readFileSync(join(PACKAGE, "integrity.json"), "utf8"))))
    cpSync(join(PACKAGE, name), join(folder, name));
}

/** Returns the file name of the picture that the npm package draws of a map. */
export function webpOf(map) {
  return `river-seed-${hashOf("sha256", `${readLink(map).link} 1200 webp 80`)}.webp`;
}

/** Returns a function that gives the file name of the picture that the command draws of a map. */
export function pngOf(algorithm) {
  return (map) => `river-seed-${hashOf(algorithm, `${readLink(map).link}, 960 at 1.5`)}.png`;
}

function hashOf(algorithm, text) {
  return createHash(algorithm).update(text).digest("hex").slice(0, 16);
}

/** Puts pictures under these names where they would be drawn, so that a build with many maps draws none. */
export async function placePictures(folder, names) {
  mkdirSync(folder, { recursive: true });
  const picture = sharp({ create: { width: 16, height: 10, channels: 3, background: "#8fb4c8" } });
  for (const name of names)
    writeFileSync(join(folder, name), await picture.clone().toFormat(name.split(".")[1]).toBuffer());
}

/** Writes a file of an example. */
export function write(folder, file, text) {
  mkdirSync(dirname(join(folder, file)), { recursive: true });
  writeFileSync(join(folder, file), text);
}

/** Runs a program in a folder; what it printed, or how it failed. */
export async function run(folder, program, words, environment = {}) {
  const PATH = `${join(WORKSHOP, "node_modules/.bin")}:${environment.PATH ?? dirname(PROGRAM)}:${process.env["PATH"]}`;
  const env = { ...process.env, NO_COLOR: "1", ...environment, PATH };
  try {
    const { stdout, stderr } = await promisify(execFile)(program, words, { cwd: folder, env });
    return { code: 0, said: stdout + stderr };
  } catch (error) {
    if (error.code === "ENOENT") throw error;
    return { code: error.code, said: `${error.stdout}${error.stderr}` };
  }
}

/** Runs a program that has to succeed. */
export async function build(folder, program, words, environment) {
  const { code, said } = await run(folder, program, words, environment);
  if (code !== 0) throw new Error(`${program} ${words.join(" ")} failed: ${said}`);
}

/** Returns the reason for which tests of a program are skipped, if it is not there. */
export async function without(program, word = "--version") {
  try {
    await promisify(execFile)(program, [word]);
    return false;
  } catch {
    return `${program} is not on this machine`;
  }
}

/** The files of a built site that are neither pages and their styles, nor the element, nor a picture whose name is a hash. */
export function strangersIn(folder) {
  const known =
    /^(example\.css|(.+\/)?index\.html|riverseed\/[\w.-]+\.(js|wasm)|riverseed\/river-seed-[0-9a-f]{16}\.(webp|png))$/;
  return filesOf(folder).filter((file) => !known.test(file));
}

/** All files of a folder, by their paths in it. */
export function filesOf(folder) {
  return readdirSync(folder, { recursive: true })
    .filter((file) => statSync(join(folder, file)).isFile())
    .sort();
}
