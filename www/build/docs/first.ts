/** Writes the first page of the documentation, which asks readers what they want to do. */

import { escaped } from "../../src/apps/page/share/snippets.ts";
import { filesOf } from "../gallery/pages.ts";
import type { Entry } from "../gallery/recipes.ts";
import { overviewShot } from "../gallery/shots.ts";
import { codeOf } from "./code.ts";
import { addressOf, type Group } from "./contents.ts";
import { documentOf, type Place } from "./frame.ts";
import type { Maps } from "./page.ts";
import { READERS, type Reader, sourceOf } from "./readers.ts";

const DESCRIPTION = "How to use Riverseed: on a page, in a book, in a game, in a lesson, in a study, in a program.";

export function firstPage(groups: readonly Group[], maps: Maps, place: Place): string {
  const titles = new Map(groups.flatMap(({ articles }) => articles).map(({ source, title }) => [source, title]));
  const card = (reader: Reader) =>
    cardOf(reader, titles.get(sourceOf(reader)) ?? "", maps.get(reader.picture ?? ""), place);
  const [pictured, programs] = [READERS.filter(({ picture }) => picture), READERS.filter(({ picture }) => !picture)];
  return documentOf(place, {
    title: "Documentation · Riverseed",
    description: DESCRIPTION,
    address: "",
    kind: "first",
    groups,
    body: `<main>
      <h1>Documentation</h1>
      <p class="lead">What do you want to do? Each of these pages begins with something to paste.</p>
      <ul class="cards">
        ${pictured.map(card).join("\n        ")}
      </ul>
      <h2>Or write a program</h2>
      <ul class="cards programs">
        ${programs.map(card).join("\n        ")}
      </ul>
    </main>`,
  });
}

function cardOf(reader: Reader, title: string, map: Entry | undefined, { site }: Place): string {
  const top = map ? `${pictureOf(map)}<p class="who">${escaped(reader.who)}</p>` : "";
  return `<li>${top}<h3><a href="${addressOf(sourceOf(reader))}">${escaped(title)}</a></h3>${codeOf(reader.line, reader.lang, "../", site)}</li>`;
}

/** Returns the picture of a card, which only decorates it. */
function pictureOf({ slug, aspect }: Entry): string {
  const { width, height } = overviewShot(Number(aspect));
  return `<img src="../gallery/${filesOf(slug).overview}" width="${width}" height="${height}" alt="" />`;
}
