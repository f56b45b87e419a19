// The tables of the package's README, from the manifest.

/** Fills the places that a text leaves for tables: `{{attributes}}` and the like, by the names of an element's parts. */
export function fill(text, { attributes, members, events, cssParts, cssProperties }) {
  const tables = {
    attributes: table(["attribute", "values", "default", "what it does"], attributes, (one) => [
      `\`${one.name}\``,
      one.type.text.replaceAll('"', "").replaceAll(" | ", ", "),
      one.default?.replaceAll('"', "") ?? "",
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
  return text.replace(/\{\{(\w+)\}\}/g, (_, name) => tables[name]);
}

const isMethod = ({ kind }) => kind === "method";

function signature({ name, parameters = [] }) {
  return `${name}(${parameters.map((one) => (one.optional ? `${one.name}?` : one.name)).join(", ")})`;
}

function table(head, rows, cells) {
  const line = (words) => `| ${words.join(" | ")} |`;
  return [line(head), line(head.map(() => "---")), ...rows.map((row) => line(cells(row)))].join("\n");
}
