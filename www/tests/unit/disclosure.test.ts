import { expect, test } from "vitest";
import { Disclosures, type Keeper } from "../../src/controls/disclosure.ts";

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
  new Disclosures(() => kept).set("Land", false);
  const disclosures = new Disclosures(() => kept);
  expect(disclosures.isOpen("Land", true)).toBe(false);
  expect(disclosures.isOpen("Growth", true)).toBe(true);
  expect(disclosures.isOpen("Growth", false)).toBe(false);
});

test("junk that is kept is nothing", () => {
  for (const junk of ["", "null", "[1]", "{", '{"Land":"no"}', '{"__proto__":true}']) {
    expect(new Disclosures(() => keeper(junk)).isOpen("Land", true)).toBe(true);
  }
});

test("a browser that keeps nothing opens and closes groups all the same", () => {
  const disclosures = new Disclosures(() => {
    throw new Error("SecurityError");
  });
  disclosures.set("Land", false);
  expect(disclosures.isOpen("Land", true)).toBe(false);
});
