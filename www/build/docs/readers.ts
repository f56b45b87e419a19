/** The readers who have a first page of their own, in docs/for. */

import { SOME_SITE } from "../social.ts";

export interface Reader {
  /** The name of the page, and of the reader in addresses. */
  readonly name: string;
  readonly who: string;
  /** A line to paste that works by itself, for the first page of all. */
  readonly line: string;
  readonly lang: "html" | "text" | "sh" | "js";
  /** The map that the reader's page begins with: one of the gallery, or its own. Readers who write programs have none. */
  readonly map?: string | OwnMap;
}

/** A map that is drawn for a page alone. */
export interface OwnMap {
  readonly link: string;
  /** Width over height, as a link writes it. */
  readonly aspect: string;
  /** A description of the picture in plain English. */
  readonly sentence: string;
}

export const READERS: readonly Reader[] = [
  {
    name: "bloggers",
    who: "Bloggers",
    line: `<script type="module" src="${SOME_SITE}widget/river-seed.js"></script><river-seed seed="skye" country="usual"></river-seed>`,
    lang: "html",
    map: "skye",
  },
  {
    name: "novelists",
    who: "Novelists",
    line: `${SOME_SITE}?seed=rimu&country=usual&style=parchment`,
    lang: "text",
    map: "rimu",
  },
  {
    name: "game-makers",
    who: "Game makers",
    line: 'riverseed render "seed=juan&country=usual&land=archipelago" -o juan.unity.zip',
    lang: "sh",
    map: "juan",
  },
  {
    name: "teachers",
    who: "Teachers",
    line: `${SOME_SITE}?seed=pencil&country=usual&land=rectangle&mouths=1&attractors=900&trim=40`,
    lang: "text",
    map: {
      link: "seed=pencil&country=usual&aspect=1.4&land=rectangle&mouths=1&attractors=900&channel-area=6&trim=40&width=24&meander-rounds=40&style=ink&labels=none",
      aspect: "1.4",
      sentence: "One river in ink, and all that joins it: 22 springs, few enough to number by hand.",
    },
  },
  {
    name: "scientists",
    who: "Scientists",
    line: 'riverseed measure "seed=loire&country=usual&land=rectangle&mouths=1"',
    lang: "sh",
    map: "loire",
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
