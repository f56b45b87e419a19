// The smallest blog of MDX: compiles a post, renders it with React, and writes it as a page.

import { readFileSync, writeFileSync } from "node:fs";
import { evaluate } from "@mdx-js/mdx";
import { createElement as h } from "react";
import { renderToStaticMarkup } from "react-dom/server";
import * as runtime from "react/jsx-runtime";
import { VFile } from "vfile";
import remarkRiverSeed from "../remark-river-seed.mjs";

const [post, page, base = "/blog/"] = process.argv.slice(2);
const options = { ...runtime, remarkPlugins: [[remarkRiverSeed, { folder: "public/riverseed", base }]] };

try {
  const { default: Post } = await evaluate(new VFile({ path: post, value: readFileSync(post) }), options);
  const head = [
    h("meta", { charSet: "utf-8" }),
    h("meta", { name: "viewport", content: "width=device-width" }),
    h("title", null, "Thursday maps"),
  ];
  const links = [h("link", { rel: "stylesheet", href: "example.css" }), h("link", { rel: "icon", href: "data:," })];
  const body = h(
    "body",
    null,
    h("header", null, h("a", { href: base }, "Thursday maps, by MDX")),
    h("main", null, h(Post)),
  );
  writeFileSync(
    page,
    `<!doctype html>${renderToStaticMarkup(h("html", { lang: "en" }, h("head", null, ...head, ...links), body))}\n`,
  );
} catch (error) {
  console.error(String(error));
  process.exitCode = 1;
}
