import riverSeed from "../eleventy.mjs";

export default function (config) {
  config.addPlugin(riverSeed);
  config.addPassthroughCopy("example.css");
}
