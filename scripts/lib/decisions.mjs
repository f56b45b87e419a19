// The decisions behind scripts/plan.mjs, as functions of plain data.

/** Returns the rows of `rules.paths` in which a touched path lies; `"all"` if one lies in none, or if they are not known. */
export function touchedRows(rules, touched) {
  if (touched === undefined) return "all";
  const rows = Object.entries(rules.paths).map(([at, row]) => ({ at, ...row }));
  const found = touched.map((path) => rows.filter(({ at }) => isWithin(path, at)));
  if (found.some((named) => named.length === 0)) return "all";
  return [...new Set([...found.flat(), ...touched.map(testFile).filter(Boolean)])];
}

/** Returns the parts that a landing runs, in the order of the rules, each with the reason. */
export function partsOf(rules, rows, commits) {
  const inTurn = rules.parts.filter(({ always }) => !always);
  const turn = inTurn[commits % inTurn.length];
  const reason = (part) => {
    if (part.always) return "always";
    if (rows === "all") return "touched: a path without a row, or commits that this clone lacks";
    const row = rows.find(({ parts }) => wordsOf(parts).includes(part.make));
    if (row) return `touched: ${row.at}`;
    return part === turn ? "its turn" : undefined;
  };
  return rules.parts.map((part) => ({ ...part, why: reason(part) })).filter(({ why }) => why !== undefined);
}

/** Returns the share that is meant: `"all"`, or its index from 0. By itself the number of commits says whose turn it is. */
export function shareOf(wanted, shares, commits) {
  if (wanted === undefined || wanted === "" || wanted === "turn") return commits % shares;
  if (wanted === "all") return "all";
  const [, share, of] = /^(\d+)\/(\d+)$/.exec(wanted) ?? [];
  if (Number(of) !== shares || share < 1 || Number(share) > shares) {
    throw new Error(`SHARE=${wanted}: it is turn, all, or one of 1/${shares} to ${shares}/${shares}`);
  }
  return Number(share) - 1;
}

/** Returns the tests of a suite that are run: a share, and all that belong to what was touched, of which `close` says how many. */
export function testsOf({ suite, all, share, shares, seconds, rows }) {
  if (share === "all" || rows === "all") return { chosen: all, close: 0 };
  const divided = dividedBy(shares, all, seconds);
  const subjects = new Set(rows.flatMap((row) => wordsOf(row[suite])));
  const due = new Set(divided[share]);
  const close = new Set(all.filter((test) => subjects.has(subjectOf(suite, test))));
  return { chosen: all.filter((test) => due.has(test) || close.has(test)), close: close.size };
}

/**
 * Divides tests into shares of about the same time: the longest first, each to the share that has least so far. A test whose time is not
 * recorded is taken for an average one, so none is lost.
 */
export function dividedBy(shares, tests, seconds) {
  const known = tests.map((test) => seconds.get(test)).filter((time) => time !== undefined);
  const average = known.length === 0 ? 1 : known.reduce((sum, time) => sum + time, 0) / known.length;
  const timed = [...new Set(tests)].map((test) => ({ test, time: seconds.get(test) ?? average }));
  timed.sort((a, b) => b.time - a.time || (a.test < b.test ? -1 : 1));
  const divided = Array.from({ length: shares }, () => ({ time: 0, tests: [] }));
  for (const { test, time } of timed) {
    const least = divided.reduce((best, one) => (one.time < best.time ? one : best));
    least.time += time;
    least.tests.push(test);
  }
  return divided.map(({ tests }) => tests);
}

/** Returns `true` if so many commits without a nightly run are too many. */
export function isMissed(commits, limit) {
  return commits > limit;
}

/** Returns what a test is about: `relief` for `relief::tests::x`, and `widget/theme` for `widget/theme.spec.ts › …`. */
function subjectOf(suite, test) {
  return suite === "rust" ? test.split("::")[0] : /^(?:\[[^\]]*\] › )?(.*?)\.spec\.ts/.exec(test)?.[1];
}

/** Returns a row for a path that is a file of tests, since these run whenever they are touched. */
function testFile(path) {
  const rust = /^(?:tests|crates\/[a-z]+\/tests)\/([a-z_]+)\.rs$/.exec(path)?.[1];
  const browser = /^www\/tests\/e2e\/(.*)\.spec\.ts$/.exec(path)?.[1];
  if (rust) return { at: path, rust };
  return browser ? { at: path, browser } : undefined;
}

/** `src/tree` holds `src/tree.rs`, too. */
function isWithin(path, at) {
  return [path, path.replace(/\.(rs|ts)$/, "")].includes(at) || path.startsWith(`${at}/`);
}

function wordsOf(text = "") {
  return text.split(" ").filter(Boolean);
}
