// The block in the editor: two fields, and the map itself as a preview.

(({ blocks, blockEditor, components, element: { createElement: el } }) => {
  const script = new URL("../element/river-seed.js", document.currentScript.src).href;

  /** Loads the element where the preview is: the editor's canvas may be a document of its own. */
  function load(node) {
    const { head } = node?.ownerDocument ?? {};
    if (!head || head.querySelector("script[data-river-seed]")) return;
    const tag = Object.assign(node.ownerDocument.createElement("script"), { type: "module", src: script });
    tag.dataset.riverSeed = "";
    head.append(tag);
  }

  function edit({ attributes: { map, alt }, setAttributes }) {
    const field = (label, key, value, help) =>
      el(components.TextControl, { label, value, help, key, onChange: (text) => setAttributes({ [key]: text }) });
    const fields = el(
      components.PanelBody,
      { title: "Map" },
      field("Word or link", "map", map, "Such as kauri, or the address that the page's Share button gives."),
      field("Text alternative", "alt", alt, "What the map shows, for readers who do not see it."),
    );
    const name = map.includes("=") ? "recipe" : "seed";
    return el(
      "div",
      blockEditor.useBlockProps(),
      el(blockEditor.InspectorControls, null, fields),
      el("river-seed", { [name]: map, still: "", ref: load, key: name }),
    );
  }

  blocks.registerBlockType("river-seed/map", { edit, save: () => null });
})(window.wp);
