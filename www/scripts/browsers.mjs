// The browser floor: the oldest browsers in which everything here runs. It is defined in package.json, as
// `browserslist`, and
// nowhere else; tests/unit/floor.test.ts checks the texts that quote it.

import browserslist from "browserslist";

/** Returns the oldest versions: `{ chrome: "120", …, safari: "17.2", ios: "17.2" }`. */
export function floor() {
  const versions = { chrome: [], edge: [], firefox: [], safari: [], ios_saf: [] };
  for (const [name, version] of browserslist(undefined, { path: import.meta.dirname }).map((one) => one.split(" ")))
    versions[name]?.push(version.split("-")[0]);
  const { ios_saf: ios, ...rest } = versions;
  return Object.fromEntries(Object.entries({ ...rest, ios }).map(([name, all]) => [name, all.sort(byAge)[0]]));
}

function byAge(a, b) {
  return a.localeCompare(b, "en", { numeric: true });
}

/** Returns the floor in the form of Vite's `build.target`. */
export function targets() {
  return Object.entries(floor()).map(([name, version]) => name + version);
}
