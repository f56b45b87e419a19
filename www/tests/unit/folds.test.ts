import { expect, test } from "vitest";
import { Folds, type Keeper } from "../../src/controls/folds.ts";

function keeper(kept: string | null = null): Keeper & { kept: string | null } {
  return {
    kept,
    getItem() {
      return this.kept;
    },
    setItem(_key: string, value: string) {
      this.kept = value;
    },
  };
}

test("a group is as it was left, or else as it is at first", () => {
  const kept = keeper();
  new Folds(() => kept).set("Land", false);
  const folds = new Folds(() => kept);
  expect(folds.isOpen("Land", true)).toBe(false);
  expect(folds.isOpen("Growth", true)).toBe(true);
  expect(folds.isOpen("Growth", false)).toBe(false);
});

test("junk that is kept is nothing", () => {
  for (const junk of ["", "null", "[1]", "{", '{"Land":"no"}', '{"__proto__":true}']) {
    expect(new Folds(() => keeper(junk)).isOpen("Land", true)).toBe(true);
  }
});

test("a browser that keeps nothing folds all the same", () => {
  const folds = new Folds(() => {
    throw new Error("SecurityError");
  });
  folds.set("Land", false);
  expect(folds.isOpen("Land", true)).toBe(false);
});
