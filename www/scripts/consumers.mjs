#!/usr/bin/env node
// Does with the packed tarball what its users do: unpacks it where they import it from, and builds their programs
// (tests/consumers) into target/consumers. The package must have been packed (scripts/package.mjs).

import { execFileSync } from "node:child_process";
import { mkdirSync, readdirSync, rmSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "vite";

process.chdir(join(dirname(fileURLToPath(import.meta.url)), ".."));
const TARBALLS = "../target/package";
const INSTALLED = "tests/consumers/node_modules/riverseed";

const tarball = readdirSync(TARBALLS).find((name) => name.endsWith(".tgz"));
rmSync(INSTALLED, { recursive: true, force: true });
mkdirSync(INSTALLED, { recursive: true });
execFileSync("tar", ["-xzf", join(TARBALLS, tarball), "-C", INSTALLED, "--strip-components", "1"]);

await build({ configFile: "tests/consumers/vite.config.ts", logLevel: "warn" });
