// What of a script is newer than the browser floor, after MDN's compatibility data.

import bcd from "@mdn/browser-compat-data/forLegacyNode";
import { parseAst } from "vite";
import { floor } from "./browsers.mjs";

/** MDN's names of the floor's browsers. */
const { ios, ...desks } = floor();
const FLOOR = Object.entries({ ...desks, safari_ios: ios });

const { builtins } = bcd.javascript;
const OBJECTS = { ...builtins.Intl, ...bcd.webassembly.api, ...builtins, ...bcd.api };
const MEMBERS = membersByName();

/** The names that a script or a declaration file gives members of classes, interfaces and objects. */
export function membersOf(code, lang) {
  return nodesOf(code, lang).flatMap(memberNamed);
}

/**
 * What some browser of the floor lacks, as `{ line, name }`: globals, static methods, and methods or properties of a name that
 * there nothing has. `ours` are names that our own objects have. What is asked for with `?.` may be lacking.
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

/** The name of what a node gives a class, an interface or an object. */
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

/** Whether all that has a member of this name is too new. Without types instances cannot be told apart, nor from ours. */
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

/** Whether some browser of the floor lacks it. What is not known is not new. */
function isNew(feature) {
  const support = feature?.__compat?.support;
  return support !== undefined && !FLOOR.every(([name, version]) => has(support[name], version));
}

function has(support, version) {
  const { version_added: added, version_removed: removed, flags, prefix } = [support ?? {}].flat()[0];
  const since = typeof added === "string" && !removed && !flags && !prefix ? added.replace("≤", "") : undefined;
  return since !== undefined && since.localeCompare(version, "en", { numeric: true }) <= 0;
}
