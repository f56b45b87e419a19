/** Writes code to paste, under the name of its language. */

import { escaped } from "../../src/apps/page/share/snippets.ts";
import { SOME_SITE } from "../social.ts";
import { codeWithSite } from "./stand-in.ts";

const LANGUAGES: Readonly<Record<string, string>> = {
  css: "CSS",
  "go-html-template": "Hugo",
  html: "HTML",
  js: "JavaScript",
  json: "JSON",
  jsx: "JSX",
  liquid: "Liquid",
  mdx: "MDX",
  php: "PHP",
  python: "Python",
  rust: "Rust",
  sh: "Command line",
  text: "Text",
  toml: "TOML",
  ts: "TypeScript",
};

/** Writes code. `root` leads from the page to the site: an address of the site can be opened, too. */
export function codeOf(text: string, lang: string, root: string, site: string | undefined): string {
  const line = text.trim();
  const isAddress = line.startsWith(SOME_SITE) && !line.includes("\n");
  const name = isAddress ? "Address" : (LANGUAGES[lang] ?? "Code");
  const open = isAddress ? `<a href="${escaped(root + line.slice(SOME_SITE.length))}">Open it</a>` : "";
  return `<figure class="code"><figcaption><span>${name}</span>${open}</figcaption><pre tabindex="0" aria-label="${name}"><code>${codeWithSite(text, site)}</code></pre></figure>`;
}
