import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { withTables } from "../../scripts/element-page.mjs";
import { table } from "../table.ts";

const page = readFileSync(new URL("../../../docs/element.md", import.meta.url), "utf8");

test("the tables of the element's page are current: `make docs` writes them", () => {
  expect(page).toBe(withTables(page, table.parameters));
});

test("the element's page has every table once", () => {
  const places = [...page.matchAll(/<!-- table: (\w+) -->\n\n\|/g)].map(([, name]) => name);
  expect(places).toEqual(["attributes", "state", "methods", "events", "parts", "properties"]);
});

test("the element's page links to no file, since npm shows it too", () => {
  expect(page.match(/\]\((?!https?:|#)[^)]*\)/g)).toBeNull();
});
