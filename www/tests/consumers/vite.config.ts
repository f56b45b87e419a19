/** One site of all programs that use the package: what their authors would write, and nothing else. */

import { cpSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { svelte } from "@sveltejs/vite-plugin-svelte";
import vue from "@vitejs/plugin-vue";
import { marked } from "marked";
import { defineConfig, type Plugin } from "vite";

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));
const out = here("../../../target/consumers");

/** What a blog does: it turns Markdown into a page and copies the package's files beside it. No bundler sees them. */
function blog(): Plugin {
  return {
    name: "blog",
    apply: "build",
    closeBundle() {
      const post = marked.parse(readFileSync(here("blog/post.md"), "utf8"), { async: false });
      cpSync(here("node_modules/riverseed"), `${out}/blog/riverseed`, { recursive: true });
      writeFileSync(`${out}/blog/index.html`, readFileSync(here("blog/layout.html"), "utf8").replace("{{post}}", post));
    },
  };
}

export default defineConfig({
  root: here("."),
  base: "./",
  plugins: [
    vue({ template: { compilerOptions: { isCustomElement: (tag) => tag === "river-seed" } } }),
    svelte(),
    blog(),
  ],
  build: {
    outDir: out,
    emptyOutDir: true,
    rolldownOptions: { input: ["vite", "react", "vue", "svelte"].map((name) => here(`${name}/index.html`)) },
  },
});
