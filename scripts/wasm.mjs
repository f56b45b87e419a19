#!/usr/bin/env node
// Builds the wasm packages that wasm-pack.toml describes, and weighs each against its budget.
//
//   node scripts/wasm.mjs           the packages of the page and the widget
//   node scripts/wasm.mjs figures   target/figures-wasm, the module that `make bench` times
//
// scripts/setup.sh wasm node must have run.

import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { existsSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { homedir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { brotliCompressSync, gzipSync } from "node:zlib";

process.chdir(join(dirname(fileURLToPath(import.meta.url)), ".."));
const { parse } = createRequire(join(process.cwd(), "www/package.json"))("smol-toml");
const settings = parse(readFileSync("wasm-pack.toml", "utf8"));
const optimiser = parse(readFileSync("Cargo.toml", "utf8")).package.metadata["wasm-pack"].profile.release["wasm-opt"];

if (process.argv[2] === "figures") {
  buildFigures();
} else {
  const now = fingerprint();
  for (const one of Object.values(settings.packages)) {
    buildPackage({ ...settings.build, ...one }, now);
    weigh(`${one["out-dir"]}/${one["out-name"]}_bg.wasm`, one.budget, one.aim);
  }
}

/** Runs a command with the Rust that knows wasm32; its failure is ours. */
function run(...command) {
  try {
    execFileSync("scripts/env.sh", ["--wasm", ...command], { stdio: "inherit" });
  } catch {
    process.exit(1);
  }
}

function buildPackage({ target, "out-dir": dir, "out-name": name, profile, cargo, features }, now) {
  // cargo would see by itself that nothing changed, but the optimiser would still take its ten seconds.
  const stamp = `${dir}/.inputs`;
  if (existsSync(stamp) && readFileSync(stamp, "utf8") === now) return;

  console.log(`Building the wasm package ${dir} (2 minutes the first time, then half a minute)`);
  rmSync(stamp, { force: true });
  // Builds with other features have the same file name, and cargo would take one for another. What we depend on stays.
  hideFolders();
  run("cargo", "clean", "--quiet", "--package", "riverseed", `--${profile}`, "--target", "wasm32-unknown-unknown");
  // no-install: wasm-pack would fetch tools, ours are there and have the right versions.
  run(
    ...["wasm-pack", "--quiet", "build", "--mode", "no-install", `--${profile}`, "--target", target],
    ...["--out-dir", dir, "--out-name", name, "--", ...cargo, "--features", features.join(",")],
  );
  writeFileSync(stamp, now);
}

/** Messages of panics name the files of dependencies: not by the folders of this machine, so that all machines build the same bytes. */
function hideFolders() {
  run("cargo", "fetch", "--quiet", "--locked");
  const sources = join(process.env.CARGO_HOME ?? join(homedir(), ".cargo"), "registry/src");
  const remaps = readdirSync(sources).map((registry) => `--remap-path-prefix=${join(sources, registry)}=crates`);
  // Added to the flags of .cargo/config.toml.
  process.env.CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS = remaps.join(" ");
}

/** A digest of every file that can change a package. */
function fingerprint() {
  const files = readdirSync("src", { recursive: true })
    .map((file) => join("src", file))
    .filter((file) => !file.startsWith(join("src", "bin")) && statSync(file).isFile())
    .sort();
  const others = ["Cargo.toml", "Cargo.lock", ".cargo/config.toml", "wasm-pack.toml"];
  others.push("www/package-lock.json", "scripts/wasm.mjs");
  const digest = createHash("sha256");
  for (const file of [...files, ...others]) digest.update(`${file}\n`).update(readFileSync(file));
  return digest.digest("hex");
}

/** Prints what a file weighs, bare and packed, beside what it may; too much is a failure. */
function weigh(file, budget, aim) {
  const bytes = readFileSync(file);
  const packed = { gzip: gzipSync(bytes, { level: 9 }).length, brotli: brotliCompressSync(bytes).length };
  const words = [`${bytes.length} bytes`];
  let isTooLarge = false;
  for (const [form, limit] of Object.entries(budget)) {
    const hoped = form in aim ? `, aim ${aim[form]}` : "";
    words.push(`${form} ${packed[form]} of ${limit}${hoped}`);
    isTooLarge ||= packed[form] > limit;
  }
  console.log(`${file}: ${words.join("; ")}${isTooLarge ? " — TOO LARGE" : ""}`);
  if (isTooLarge) process.exitCode = 1;
}

function buildFigures() {
  const folder = "target/figures-wasm";
  const built = `${folder}/wasm32-unknown-unknown/release/examples/figures_wasm.wasm`;
  const out = `${folder}/figures_wasm_bg.wasm`;
  console.log("Building the module that is timed (2 minutes the first time)");
  const crate = ["--example", "figures_wasm", "--no-default-features"];
  run("cargo", "build", "--quiet", "--release", "--target", "wasm32-unknown-unknown", "--target-dir", folder, ...crate);
  run("wasm-bindgen", "--target", "nodejs", "--out-dir", folder, built);
  run("wasm-opt", ...optimiser, out, "-o", out);
}
