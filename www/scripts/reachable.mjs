// Follows the references between files of a package.

import { posix } from "node:path";

// `from "./a.js"`, `import "./a.js"`, `import("./a.js")` and `new URL("a.wasm", import.meta.url)`, in any quotes.
const IMPORTED = /\b(?:from|import|import\()\s*["'`](\.[^"'`]+)["'`]/g;
const BESIDE = /new URL\(\s*["'`]([^"'`]+)["'`],\s*import\.meta\.url/g;

/**
 * Returns some files and all files that they reach by importing or naming others. `read` returns the text of a file.
 */
export function reachable(paths, read) {
  const found = new Set(paths);
  // The loop also visits elements that are added to the set meanwhile.
  for (const path of found) {
    if (!/\.(js|d\.ts)$/.test(path)) continue;
    for (const name of referencesIn(read(path))) found.add(resolve(path, name));
  }
  return found;
}

function referencesIn(code) {
  return [...code.matchAll(IMPORTED), ...code.matchAll(BESIDE)].map(([, name]) => name);
}

/** Resolves a name. In declarations `a.js` means its declarations. */
function resolve(from, name) {
  const path = posix.join(posix.dirname(from), name);
  return from.endsWith(".d.ts") ? path.replace(/\.js$/, ".d.ts") : path;
}
