#!/usr/bin/env node
// Builds the wasm packages that wasm-pack.toml describes, and weighs each against its limits.
//
//   node scripts/wasm.mjs           the packages of the page and the widget; too much weight is only reported
//   node scripts/wasm.mjs demo      the same for a page on this machine: in a third of the time, larger and not weighed
//   node scripts/wasm.mjs weigh     weighs what is built; too much weight is a failure
//   node scripts/wasm.mjs figures   target/figures-wasm, the module that `make bench` times
//
// scripts/setup.sh wasm node must have run, for `demo` bindgen node. Two of these at a time would build into the same folders: see scripts/lib/lock.sh.

import { execFileSync, spawn } from "node:child_process";
import { createHash } from "node:crypto";
import { once } from "node:events";
import { existsSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { availableParallelism } from "node:os";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { brotliCompressSync, gzipSync } from "node:zlib";

process.chdir(join(dirname(fileURLToPath(import.meta.url)), ".."));
const { parse } = createRequire(join(process.cwd(), "www/package.json"))("smol-toml");
const folder = "crates/wasm";
const crate = "riverseed-wasm";
const settings = parse(readFileSync("wasm-pack.toml", "utf8"));
const manifest = parse(readFileSync(`${folder}/Cargo.toml`, "utf8"));
const optimiser = manifest.package.metadata["wasm-pack"].profile.release["wasm-opt"];
const packages = Object.entries(settings.packages).map(([key, one]) => ({ key, ...settings.build, ...one }));

switch (process.argv[2]) {
  case "figures":
    buildFigures();
    break;
  case "demo":
    buildDemo();
    break;
  case "weigh":
    if (packages.map(weigh).includes(false)) process.exitCode = 1;
    break;
  default:
    await buildPackages();
}

/** Runs a command with the Rust that knows wasm32; its failure is ours. */
function run(...command) {
  try {
    execFileSync("scripts/env.sh", ["--wasm", ...command], { stdio: "inherit" });
  } catch {
    process.exit(1);
  }
}

/** Runs a command of the same environment while others run. */
async function runBeside(...command) {
  const [code] = await once(spawn("scripts/env.sh", ["--wasm", ...command], { stdio: "inherit" }), "exit");
  if (code !== 0) throw new Error(`${command[0]} failed`);
}

/** What a command prints, in the same environment. */
function ask(...command) {
  try {
    const stdio = ["ignore", "pipe", "inherit"];
    return execFileSync("scripts/env.sh", ["--wasm", ...command], { stdio, encoding: "utf8", maxBuffer: 2 ** 28 });
  } catch {
    process.exit(1);
  }
}

/**
 * Builds what is not fresh. Link-time optimisation keeps one processor busy for minutes, so as many packages are built at a time as there
 * are processors; the last of the list, which is the largest, first.
 */
async function buildPackages() {
  const made = madeOf();
  const stale = packages.filter((one) => !isFresh(one, made)).reverse();
  const work = async () => {
    for (let one = stale.shift(); one; one = stale.shift()) await buildPackage(one, made);
  };
  const outcomes = await Promise.allSettled(Array.from({ length: availableParallelism() }, work));
  const failed = outcomes.find(({ status }) => status === "rejected");
  if (failed) {
    console.error(failed.reason.message);
    process.exit(1);
  }
  packages.forEach(weigh);
}

/**
 * Compiles one module that holds all that any package has, under the name of each. Nothing is optimised across crates and
 * nothing is made small: what it draws is the same to the bit. Packages that `make wasm` has built are taken as they are.
 */
function buildDemo() {
  const made = madeOf();
  const quickly = { ...made, demo: true };
  if (packages.every((one) => isFresh(one, made) || isFresh(one, quickly))) return;
  console.log(`Building ${packages.map((one) => one["out-dir"]).join(", ")} (a minute the first time)`);
  const features = [...new Set(packages.flatMap((one) => one.features))].join(",");
  const built = targetOf("demo");
  run(
    ...["cargo", "build", "--quiet", "--package", crate, "--release", "--target", "wasm32-unknown-unknown"],
    ...["--target-dir", built, "--features", features],
    ...["--config", 'profile.release.lto="off"', "--config", "profile.release.codegen-units=16"],
  );
  const module = `${built}/wasm32-unknown-unknown/release/${crate.replace("-", "_")}.wasm`;
  for (const { target, "out-dir": dir, "out-name": name } of packages) {
    rmSync(dir, { recursive: true, force: true });
    run("wasm-bindgen", "--target", target, "--out-dir", dir, "--out-name", name, module);
    writeFileSync(stampOf(dir), JSON.stringify({ ...quickly, outputs: outputs(dir) }));
  }
}

/** Of what, by what and how packages are made. */
function madeOf() {
  const files = ["Cargo.toml", `${folder}/Cargo.toml`, "Cargo.lock", ".cargo/config.toml", "wasm-pack.toml"];
  const tools = ask("sh", "-c", "rustc -vV && wasm-bindgen --version && wasm-opt --version");
  return { inputs: digestOf([...sources(), ...files]), script: digestOf(["scripts/wasm.mjs"]), tools };
}

/** Where cargo compiles a package: builds with other features have the same file names, so each has a folder of its own. */
function targetOf(key) {
  return resolve(process.env.CARGO_TARGET_DIR ?? "target", "wasm", key);
}

/** Whether a package is what would be built: of these inputs, by these tools, and as it was then. */
function isFresh({ "out-dir": dir }, made) {
  const stamp = stampOf(dir);
  return existsSync(stamp) && readFileSync(stamp, "utf8") === JSON.stringify({ ...made, outputs: outputs(dir) });
}

async function buildPackage({ key, target, "out-dir": dir, "out-name": name, profile, cargo, features }, made) {
  // cargo would see by itself that nothing changed, but the optimiser would still take its ten seconds.
  console.log(`Building the wasm package ${dir} (2 minutes the first time, then half a minute)`);
  rmSync(dir, { recursive: true, force: true });
  // no-install: wasm-pack would fetch tools, ours are there and have the right versions.
  await runBeside(
    ...["wasm-pack", "--quiet", "build", folder, "--mode", "no-install", `--${profile}`, "--target", target],
    ...["--out-dir", resolve(dir), "--out-name", name, "--", ...cargo, "--features", features.join(",")],
    ...["--target-dir", targetOf(key), "--config", compilerFlags()],
  );
  writeFileSync(stampOf(dir), JSON.stringify({ ...made, outputs: outputs(dir) }));
}

function stampOf(dir) {
  return join(dir, ".made-of");
}

/**
 * Takes the names of this machine's folders out of messages of panics, so that all machines build the same bytes. A setting of cargo's,
 * added to the flags of .cargo/config.toml: in RUSTFLAGS no folder could have a space.
 */
function compilerFlags() {
  const known = ["--locked", "--format-version", "1", "--filter-platform", "wasm32-unknown-unknown"];
  const crates = JSON.parse(ask("cargo", "metadata", "--quiet", ...known)).packages.filter(
    (one) => one.source !== null,
  );
  // Where they are depends on the registry, which may be replaced, or be a folder of the checkout.
  const folders = new Set(crates.map((one) => dirname(dirname(one.manifest_path))));
  const remaps = [...folders].sort().map((folder) => `--remap-path-prefix=${folder}=crates`);
  return `target.wasm32-unknown-unknown.rustflags=${JSON.stringify(remaps)}`;
}

/** All that is compiled. */
function sources() {
  return ["src", join(folder, "src")].flatMap(filesIn);
}

function outputs(dir) {
  return existsSync(dir) ? digestOf(filesIn(dir).filter((file) => file !== stampOf(dir))) : "none";
}

function filesIn(dir) {
  const files = readdirSync(dir, { recursive: true }).map((file) => join(dir, file));
  return files.filter((file) => statSync(file).isFile()).sort();
}

function digestOf(files) {
  const digest = createHash("sha256");
  for (const file of files) {
    const bytes = readFileSync(file);
    digest.update(`${file} ${bytes.length}\n`).update(bytes);
  }
  return digest.digest("hex");
}

/** Prints what a package's module weighs, bare and packed, beside what it may. False if that is too much. */
function weigh({ "out-dir": dir, "out-name": name, budget }) {
  const file = `${dir}/${name}_bg.wasm`;
  const bytes = readFileSync(file);
  const packed = { gzip: gzipSync(bytes, { level: 9 }).length, brotli: brotliCompressSync(bytes).length };
  const words = Object.entries(budget).map(([form, limit]) => `${form} ${packed[form]} of ${limit}`);
  const isLight = Object.entries(budget).every(([form, limit]) => packed[form] <= limit);
  console.log(`${file}: ${[`${bytes.length} bytes`, ...words].join("; ")}`);
  if (!isLight) console.log(tooLarge());
  return isLight;
}

/** Other tools make other bytes: with them, the message says whose the limits are. */
function tooLarge() {
  const { rustc, "wasm-opt": optimiser } = settings["weighed-with"];
  const [ours] = ask("rustc", "--version").split("\n");
  const [theirs] = ask("wasm-opt", "--version").split("\n");
  return `  TOO LARGE for \`make check\`. The limits hold for rustc ${rustc} and wasm-opt ${optimiser}; here are ${ours} and ${theirs}.`;
}

/** Builds what `make bench` times as the page's engine is built: with the same features of the library, flags and optimiser. */
function buildFigures() {
  const folder = "target/figures-wasm";
  const built = `${folder}/wasm32-unknown-unknown/release/examples/figures_wasm.wasm`;
  const out = `${folder}/figures_wasm_bg.wasm`;
  console.log("Building the module that is timed (2 minutes the first time)");
  const features = libraryFeatures(settings.packages.engine);
  const what = ["--example", "figures_wasm", "--no-default-features", "--features", features];
  const how = ["--release", "--target", "wasm32-unknown-unknown", "--target-dir", folder, "--config", compilerFlags()];
  run("cargo", "build", "--quiet", ...how, ...what);
  run("wasm-bindgen", "--target", "nodejs", "--out-dir", folder, built);
  run("wasm-opt", ...optimiser, out, "-o", out);
}

/** The library's features that a package has: those that its own features turn on. */
function libraryFeatures({ features }) {
  const turnedOn = (feature) => [feature, ...(manifest.features[feature] ?? []).flatMap(turnedOn)];
  const library = "riverseed/";
  const all = features.flatMap(turnedOn).filter((feature) => feature.startsWith(library));
  return all.map((feature) => feature.slice(library.length)).join(",");
}
