// Writes the tables of the element's page, docs/element.md, which is also the npm package's README, from the parameter
// table
// and package/element.json.
//
//   node scripts/element-page.mjs    writes them again; a unit test fails if they are out of date

import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { elementOf } from "./manifest.mjs";

const PAGE = new URL("../../docs/element.md", import.meta.url);
const OWN = new URL("../package/element.json", import.meta.url);
const TABLE = new URL("../src/engine/parameters.json", import.meta.url);

/**
 * Returns the page with its tables, each of which is between `<!-- table: attributes -->`, or another name, and `<!--
 * end -->`.
 */
export function withTables(text, parameters) {
  const tables = tablesOf(elementOf(JSON.parse(readFileSync(OWN, "utf8")), parameters));
  return text.replace(PLACE, (_, begin, name, end) => `${begin}\n${tables[name]}\n\n${end}`);
}

const PLACE = /(<!-- table: (\w+) -->\n)[\s\S]*?(<!-- end -->)/g;

function tablesOf({ attributes, members, events, cssParts, cssProperties }) {
  return {
    attributes: table(["attribute", "values", "default", "what it does"], attributes, (one) => [
      `\`${one.name}\``,
      one.type.text.replaceAll('"', "").replaceAll(" | ", ", "),
      one.default?.replaceAll('"', "") ?? "",
      one.description,
    ]),
    state: table(["property", "type", "what it tells"], members.filter(isState), (one) => [
      `\`${one.name}\``,
      `\`${one.type.text.replaceAll('"', "").replaceAll(" | ", ", ")}\``,
      one.description,
    ]),
    methods: table(["method", "what it does"], members.filter(isMethod), (one) => [
      `\`${signature(one)}\``,
      one.description,
    ]),
    events: table(["event", "when"], events, (one) => [`\`${one.name}\``, one.description]),
    parts: table(["part", "what it is"], cssParts, (one) => [`\`${one.name}\``, one.description]),
    properties: table(["custom property", "default", "what it does"], cssProperties, (one) => [
      `\`${one.name}\``,
      one.default ?? "",
      one.description,
    ]),
  };
}

const isState = ({ readonly }) => readonly;
const isMethod = ({ kind }) => kind === "method";

function signature({ name, parameters = [] }) {
  return `${name}(${parameters.map((one) => (one.optional ? `${one.name}?` : one.name)).join(", ")})`;
}

function table(head, rows, cells) {
  const line = (words) => `| ${words.join(" | ")} |`;
  return [line(head), line(head.map(() => "---")), ...rows.map((row) => line(cells(row)))].join("\n");
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const { parameters } = JSON.parse(readFileSync(TABLE, "utf8"));
  writeFileSync(PAGE, withTables(readFileSync(PAGE, "utf8"), parameters));
}
