/** The readers who have a first page of their own, in docs/for. */

import { SOME_SITE } from "../social.ts";

export interface Reader {
  /** The name of the page, and of the reader in addresses. */
  readonly name: string;
  readonly who: string;
  /** A line to paste that works by itself, for the first page of all. */
  readonly line: string;
  readonly lang: "html" | "text" | "sh" | "js";
  /** The map of the gallery that the reader's page begins with; readers who write programs have none. */
  readonly picture?: string;
}

export const READERS: readonly Reader[] = [
  {
    name: "bloggers",
    who: "Bloggers",
    line: `<script type="module" src="${SOME_SITE}widget/river-seed.js"></script><river-seed seed="skye"></river-seed>`,
    lang: "html",
    picture: "skye",
  },
  {
    name: "novelists",
    who: "Novelists",
    line: `${SOME_SITE}?seed=rimu&style=parchment`,
    lang: "text",
    picture: "rimu",
  },
  {
    name: "game-makers",
    who: "Game makers",
    line: 'riverseed render "seed=juan&land=archipelago" -o juan.zip',
    lang: "sh",
    picture: "juan",
  },
  {
    name: "teachers",
    who: "Teachers",
    line: `${SOME_SITE}?seed=few&attractors=2500&trim=40`,
    lang: "text",
    picture: "few",
  },
  {
    name: "scientists",
    who: "Scientists",
    line: 'riverseed measure "seed=loire&land=rectangle&mouths=1"',
    lang: "sh",
    picture: "loire",
  },
  { name: "rust", who: "Rust", line: "cargo add riverseed --path ../riverseed", lang: "sh" },
  { name: "python", who: "Python", line: "pip install ./python", lang: "sh" },
  {
    name: "javascript",
    who: "JavaScript",
    line: "npm install ../riverseed/target/package/riverseed-0.1.0.tgz",
    lang: "sh",
  },
];

/** Returns the path of a reader's page in the repository. */
export function sourceOf({ name }: Reader): string {
  return `docs/for/${name}.md`;
}
