// The table of figures. A group yields its lines, and run.mjs prints each as soon as it is measured.

/** Says what a measured number has to be, and what it ought to be. */
export const atLeast = (floor, aim = floor) => ({ floor, aim, meets: (value, bar) => value >= bar });
export const atMost = (floor, aim = floor) => ({ floor, aim, meets: (value, bar) => value <= bar });

/** Makes a line of a figure that has a bar: `atLeast` or `atMost`. */
export const row = (what, value, unit, bar) => ({ what, value, unit, bar });

/** Makes a line of a figure that helps to read the one above. */
export const guide = (what, value, unit) => ({ what, value, unit });

/** Makes a line of words, where nothing could be measured. */
export const remark = (what) => ({ what });

export function printHeading(name) {
  print(`\n${name}`, "measured", "floor", "aim");
}

/** Prints a line. Returns whether it misses its floor. */
export function printLine({ what, value, unit, bar }) {
  if (value === undefined) print(`  ${what}`);
  else if (bar === undefined) print(`      ${what}`, `${written(value)} ${unit}`);
  else {
    const { floor, aim, meets } = bar;
    const verdict = meets(value, aim) ? "" : meets(value, floor) ? "floor met" : "MISSED";
    print(`  ${what}`, `${written(value)} ${unit}`, `${written(floor)} ${unit}`, `${written(aim)} ${unit}`, verdict);
    return verdict === "MISSED";
  }
  return false;
}

/** Writes three digits, without an exponent. */
function written(value) {
  return Number(value.toPrecision(3)).toString();
}

function print(what, ...cells) {
  const [measured = "", floor = "", aim = "", verdict = ""] = cells;
  const columns = [what.padEnd(78), ...[measured, floor, aim].map((cell) => cell.trim().padStart(11)), ` ${verdict}`];
  console.log(columns.join("").trimEnd());
}
