// The plugin for Eleventy: the shortcode `riverSeed`.

import { baseOf, copyElement, embed, html, needs, refuseNested } from "./river-seed.mjs";

export default function riverSeed(config, { base } = {}) {
  needs("Eleventy", "3.0", process.env.ELEVENTY_VERSION);
  const folder = () => `${config.directories.output}riverseed/`;
  const address = () => baseOf(base ?? config.getFilter("url")("/"));
  config.on("eleventy.before", () => copyElement(folder()));
  config.addShortcode("riverSeed", async (map, alt) =>
    html(await embed(map, { folder: folder(), base: address(), alt })),
  );
  config.addTransform("river-seed", function (page) {
    refuseNested(String(page), this.page.outputPath);
    return page;
  });
}
