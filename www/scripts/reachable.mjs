// What belongs to what, among the files of a package.

import { posix } from "node:path";

// `from "./a.js"`, `import "./a.js"`, `import("./a.js")` and `new URL("a.wasm", import.meta.url)`, in any quotes.
const IMPORTED = /\b(?:from|import|import\()\s*["'`](\.[^"'`]+)["'`]/g;
const BESIDE = /new URL\(\s*["'`]([^"'`]+)["'`],\s*import\.meta\.url/g;

/** All files that some lead to, themselves among them: by importing or naming others. `read` gives the text of one. */
export function reachable(paths, read) {
  const found = new Set(paths);
  // A set that grows is walked to its end.
  for (const path of found) {
    if (!/\.(js|d\.ts)$/.test(path)) continue;
    for (const name of referencesIn(read(path))) found.add(resolve(path, name));
  }
  return found;
}

function referencesIn(code) {
  return [...code.matchAll(IMPORTED), ...code.matchAll(BESIDE)].map(([, name]) => name);
}

/** In declarations `a.js` means the declarations of it. */
function resolve(from, name) {
  const path = posix.join(posix.dirname(from), name);
  return from.endsWith(".d.ts") ? path.replace(/\.js$/, ".d.ts") : path;
}
