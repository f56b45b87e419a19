// The plugin for MDX: `<RiverSeed map="kauri" />` becomes a picture, drawn while the page is compiled, in the element. It works wherever
// MDX does, with React or another library, and no component is imported.

import { baseOf, copyElement, embed, RiverSeedError } from "./river-seed.mjs";

export default function remarkRiverSeed({ folder = "public/riverseed", base = "/" } = {}) {
  return async (tree, file) => {
    for (const [parent, node] of maps(tree)) {
      await copyElement(folder).catch((error) => file.fail(error));
      const embedded = await embed(text(node, "map"), { folder, base: baseOf(base), alt: text(node, "alt") }).catch(
        (error) => file.fail(error, node),
      );
      parent.children.splice(parent.children.indexOf(node), 1, ...elements(embedded));
    }

    function text(node, name) {
      const value = node.attributes.find((one) => one.name === name)?.value;
      const literal = typeof value === "object" ? value?.data?.estree?.body[0]?.expression : { value };
      if (literal && "value" in literal) return literal.value ?? undefined;
      return file.fail(
        new RiverSeedError(
          `"${name}" is a literal text, since the picture is drawn before the page runs; got {${value.value}}`,
        ),
        node,
      );
    }

    function* maps(parent, isInMap = false) {
      for (const node of [...(parent.children ?? [])]) {
        const isMap = node.name === "RiverSeed";
        if (isMap && isInMap) file.fail(new RiverSeedError("a river-seed stands inside another"), node);
        yield* maps(node, isInMap || isMap || node.name === "river-seed");
        if (isMap) yield [parent, node];
      }
    }
  };
}

/** Returns an embed as nodes of Markdown that become these elements; MDX gives them the form that its library wants. */
function elements({ script, element, picture }) {
  const node = (hName, hProperties, hChildren = []) => ({ type: hName, data: { hName, hProperties, hChildren } });
  if (!element) return [node("img", picture)];
  const img = { type: "element", tagName: "img", properties: picture, children: [] };
  return [node("script", { type: "module", async: true, src: script }), node("river-seed", element, [img])];
}
