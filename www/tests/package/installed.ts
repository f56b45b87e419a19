/** The package as its users have it, once installed. */

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

/** Where programs live that import it. */
export const CONSUMERS = fileURLToPath(new URL("../consumers/", import.meta.url));
export const INSTALLED = join(CONSUMERS, "node_modules/riverseed");

/** All its files, by their paths in it. */
export function files(): string[] {
  const entries = readdirSync(INSTALLED, { recursive: true, withFileTypes: true });
  return entries
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name).slice(INSTALLED.length + 1))
    .sort();
}

export function bytes(path: string): Buffer {
  return readFileSync(join(INSTALLED, path));
}

export function json<T>(path: string): T {
  return JSON.parse(bytes(path).toString());
}

type Target = string | { readonly [condition: string]: string };

export interface Description {
  readonly name: string;
  readonly version: string;
  readonly license: string;
  readonly exports: { readonly [entry: string]: Target };
  readonly sideEffects: readonly string[];
  readonly customElements: string;
}

/** The files that an entry of `exports` names, in the order in which tools try them. */
export function targets(target: Target): [condition: string, path: string][] {
  const named: [string, string][] = typeof target === "string" ? [["default", target]] : Object.entries(target);
  return named.map(([condition, path]) => [condition, path.replace("./", "")]);
}
