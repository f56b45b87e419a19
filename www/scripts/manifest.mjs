// Writes the descriptions of <river-seed> for tools: the custom-elements manifest, and the types of its markup.
// Parameters come from the parameter table; everything else about the element from package/element.json.

import { readFileSync } from "node:fs";

/** Parameters whose names mean something else on every HTML element. As attributes they have a prefix. */
const PREFIXED = JSON.parse(readFileSync(new URL("../src/engine/prefixed.json", import.meta.url), "utf8"));

/** What stands for a value that the word decides. */
const AUTO = JSON.stringify("auto");

const attributeOf = (key) => (PREFIXED.includes(key) ? `river-${key}` : key);
const propertyOf = (attribute) => attribute.replace(/-(.)/g, (_, letter) => letter.toUpperCase());

/** Lists all attributes of the element: the table's rows, then its own. */
export function attributes(own, table) {
  const ofTable = table.map((row) => ({
    name: attributeOf(row.key),
    type: { text: row.decided ? `${typeOf(row)} | ${AUTO}` : typeOf(row) },
    default: row.decided ? AUTO : JSON.stringify(isNumber(row) ? Number(row.default) : row.default),
    description: isNumber(row) ? `${row.help} ${row.min} to ${row.max}${row.unit ? ` ${row.unit}` : ""}.` : row.help,
  }));
  return [...ofTable, ...own.attributes].map((one) => ({ ...one, fieldName: propertyOf(one.name) }));
}

const isNumber = ({ kind }) => kind === "number" || kind === "integer";

function typeOf(row) {
  if (isNumber(row)) return "number";
  return row.choices && row.kind === "choice"
    ? row.choices.map(({ value }) => JSON.stringify(value)).join(" | ")
    : "string";
}

/** Describes the element as the manifest declares a class. */
export function elementOf(own, table) {
  const all = attributes(own, table);
  return {
    kind: "class",
    customElement: true,
    tagName: "river-seed",
    name: "RiverSeed",
    superclass: { name: "HTMLElement" },
    ...own,
    attributes: all,
    members: [...all.map(fieldOf), ...own.members],
  };
}

function fieldOf({ name, fieldName, ...rest }) {
  return { kind: "field", name: fieldName, ...rest, attribute: name, reflects: true };
}

/** Returns the manifest: https://github.com/webcomponents/custom-elements-manifest */
export function manifest(own, table) {
  const reference = { name: "RiverSeed", module: "element.js" };
  return {
    schemaVersion: "2.1.0",
    readme: "README.md",
    modules: [
      {
        kind: "javascript-module",
        path: "element.js",
        declarations: [elementOf(own, table)],
        exports: [{ kind: "js", name: "RiverSeed", declaration: reference }],
      },
      {
        kind: "javascript-module",
        path: "define.js",
        exports: [{ kind: "custom-element-definition", name: "river-seed", declaration: reference }],
      },
    ],
  };
}

/** Writes the types of the attributes as frameworks' JSX and templates spell them. */
export function markupTypes(own, table) {
  const lines = attributes(own, table).flatMap((one) => [
    comment(one),
    // In markup a number may also be written as text.
    `  ${JSON.stringify(one.name)}?: ${one.type.text}${/^number/.test(one.type.text) ? " | string" : ""} | undefined;`,
  ]);
  return `export interface RiverSeedMarkup {\n${lines.join("\n")}\n}\n`;
}

function comment({ description, default: value }) {
  return `  /** ${description}${value === undefined ? "" : ` Default: ${value}.`} */`;
}
