#!/usr/bin/env node
// Decides what of the slow tests a landing proves: what its commits touch, and of all else a share in turn (docs/ci.toml). Everything is
// read from the clone, so the same commit always proves the same.
//
//   node scripts/plan.mjs parts               the targets of make that this landing runs, a line each, with the minutes it takes at most; why, on
//                                             standard error
//   node scripts/plan.mjs tests SUITE <LIST   those of a suite's tests that it runs; LIST has one on each line
//
// SHARE=2/5 takes that share instead of the one whose turn it is, and SHARE=all everything.

import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { argv, env, exit, stdout } from "node:process";
import { fileURLToPath } from "node:url";
import { isMissed, partsOf, shareOf, testsOf, touchedRows } from "./lib/decisions.mjs";

const root = env.RIVERSEED_ROOT ?? join(dirname(fileURLToPath(import.meta.url)), "..");
const { parse } = createRequire(join(root, "www/package.json"))("smol-toml");
const rules = parse(readFileSync(join(root, "docs/ci.toml"), "utf8"));

switch (argv[2]) {
  case "parts":
    printParts();
    break;
  case "tests":
    printTests(argv[3]);
    break;
  default:
    console.error("usage: plan.mjs parts | plan.mjs tests SUITE");
    exit(2);
}

function printParts() {
  const { commits, touched } = landing();
  sayNightly(commits);
  for (const { make, minutes, why } of partsOf(rules, touchedRows(rules, touched), commits)) {
    console.error(`  make ${make}: ${why}`);
    console.log(make, minutes);
  }
}

/** Prints tests of a suite, and on standard error which share they are and how the others are run. */
function printTests(suite) {
  const all = readFileSync(0, "utf8").split("\n").filter(Boolean);
  const { commits, touched } = landing();
  const shares = rules.shares[suite];
  const share = shareOf(env.SHARE, shares, commits);
  const { chosen, close } = testsOf({ suite, all, share, shares, seconds: seconds(), rows: touchedRows(rules, touched) });
  const which = share === "all" ? "all" : `share ${share + 1} of ${shares}, and ${close} tests of what was touched`;
  console.error(`${suite}: ${chosen.length} of ${all.length} tests: ${which}; SHARE=1/${shares} to ${shares}/${shares} are the shares`);
  stdout.write(chosen.map((test) => `${test}\n`).join(""));
}

/** How many commits there are, and the paths that those of the landing touch; no paths if a shallow clone hides some. */
function landing() {
  const tip = Number(git("log", "-1", "--format=%ct"));
  const since = new Date((tip - rules.hours * 3600) * 1000).toISOString();
  const isWhole = git("rev-parse", "--is-shallow-repository") === "false";
  const names = git("log", "-m", "--name-only", "--format=", `--since=${since}`).split("\n").filter(Boolean);
  return { commits: Number(git("rev-list", "--count", "HEAD")), touched: isWhole ? [...new Set(names)] : undefined };
}

function sayNightly(commits) {
  const file = join(root, "docs/nightly.txt");
  const last = existsSync(file) ? readFileSync(file, "utf8").trim().split("\n").at(-1) : "";
  const proven = /^[0-9a-f]{7,40}/.exec(last)?.[0];
  const since = proven === undefined ? commits : Number(git("rev-list", "--count", `${proven}..HEAD`));
  if (isMissed(since, rules.nightly)) console.error(`NIGHTLY MISSED: ${since} commits since the last line of docs/nightly.txt. Run make nightly.`);
}

/** What each test took when it was last recorded, in seconds. */
function seconds() {
  const lines = readFileSync(join(root, "tests/seconds.txt"), "utf8").split("\n").filter(Boolean);
  return new Map(lines.map((line) => [line.slice(line.indexOf(" ") + 1), Number(line.split(" ", 1)[0])]));
}

function git(...words) {
  return execFileSync("git", ["-C", root, ...words], { encoding: "utf8", maxBuffer: 2 ** 28 }).trim();
}
