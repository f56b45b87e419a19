// Finds features in a script that are newer than the browser floor, by MDN's compatibility data.

import bcd from "@mdn/browser-compat-data/forLegacyNode";
import { parseAst } from "vite";
import { floor } from "./browsers.mjs";

/** The floor by MDN's names of browsers. */
const { ios, ...desks } = floor();
const FLOOR = Object.entries({ ...desks, safari_ios: ios });

const { builtins } = bcd.javascript;
const OBJECTS = { ...builtins.Intl, ...bcd.webassembly.api, ...builtins, ...bcd.api };
const MEMBERS = membersByName();

/** Returns the names of members that a script or a declaration file gives to classes, interfaces and objects. */
export function membersOf(code, lang) {
  return nodesOf(code, lang).flatMap(memberNamed);
}

/**
 * Returns the features that some browser of the floor lacks, as `{ line, name }`: globals, static methods, and methods
 * or properties whose name exists on nothing there. `ours` are names on our own objects. Features that are used with
 * `?.` are allowed.
 */
export function newerThanFloor(code, ours = new Set()) {
  const nodes = nodesOf(code);
  const declared = new Set(nodes.flatMap(({ type, id }) => (/Declarat/.test(type) && id?.name) || []));
  const asked = new Set(nodes.filter(({ optional }) => optional).map(({ callee, object }) => callee ?? object));
  return nodes.flatMap((node) => {
    const name = asked.has(node) ? undefined : nameOfNew(node, declared, ours);
    return name ? [{ line: code.slice(0, node.start).split("\n").length, name }] : [];
  });
}

function nodesOf(code, lang = "ts") {
  return [...nodesIn(parseAst(code, { lang }))];
}

function* nodesIn(node) {
  yield node;
  for (const child of Object.values(node).flat()) if (typeof child?.type === "string") yield* nodesIn(child);
}

/** Returns the name of the member that a node gives to a class, an interface or an object. */
function memberNamed({ type, key, parameter }) {
  const isMember = /^(MethodDefinition|PropertyDefinition|Property|TSPropertySignature|TSMethodSignature)$/.test(type);
  return (isMember ? key.name : type === "TSParameterProperty" && parameter.name) || [];
}

function nameOfNew(node, declared, ours) {
  const known = ({ type, name }) => (type === "Identifier" && !declared.has(name) ? OBJECTS[name] : undefined);
  const { type, callee, object, property } = node;
  if (/^(New|Call)Expression$/.test(type) && isNew(known(callee))) return callee.name;
  if (type !== "MemberExpression" || property.type !== "Identifier" || node.computed) return undefined;
  if (isNew(known(object))) return object.name;
  const member = known(object)?.[`${property.name}_static`] ?? known(object)?.[property.name];
  const is = member ? isNew(member) : isNewEverywhere(property.name, ours);
  return is ? `${object.name ?? "…"}.${property.name}` : undefined;
}

/**
 * Returns whether everything with a member of this name is too new. Without types, instances cannot be distinguished
 * from each other or from ours.
 */
function isNewEverywhere(name, ours) {
  return !ours.has(name) && (MEMBERS.get(name)?.every(isNew) ?? false);
}

function membersByName() {
  const styles = Object.entries(bcd.css.properties).map(([name, style]) => [camel(name), [style]]);
  const members = new Map(styles);
  for (const object of Object.values(OBJECTS))
    for (const [name, member] of Object.entries(object)) {
      if (member.__compat) members.set(name, [...(members.get(name) ?? []), member]);
    }
  return members;
}

function camel(name) {
  return name.replace(/-(.)/g, (_, letter) => letter.toUpperCase());
}

/** Returns whether some browser of the floor lacks a feature. Unknown features do not count as new. */
function isNew(feature) {
  const support = feature?.__compat?.support;
  return support !== undefined && !FLOOR.every(([name, version]) => has(support[name], version));
}

function has(support, version) {
  const { version_added: added, version_removed: removed, flags, prefix } = [support ?? {}].flat()[0];
  const since = typeof added === "string" && !removed && !flags && !prefix ? added.replace("≤", "") : undefined;
  return since !== undefined && since.localeCompare(version, "en", { numeric: true }) <= 0;
}
