/** Writes the first page of the documentation, which asks readers what they want to do. */

import { escaped } from "../../src/apps/page/share/snippets.ts";
import { codeOf } from "./code.ts";
import { addressOf, type Group } from "./contents.ts";
import { documentOf, type Place } from "./frame.ts";
import type { Picture, Pictures } from "./pictures.ts";
import { READERS, type Reader, sourceOf } from "./readers.ts";

const DESCRIPTION = "How to use Riverseed: on a page, in a book, in a game, in a lesson, in a study, in a program.";

export function firstPage(groups: readonly Group[], pictures: Pictures, place: Place): string {
  const titles = new Map(groups.flatMap(({ articles }) => articles).map(({ source, title }) => [source, title]));
  const card = (reader: Reader) => cardOf(reader, titles.get(sourceOf(reader)) ?? "", pictures.get(reader.name), place);
  const [pictured, programs] = [READERS.filter(({ map }) => map), READERS.filter(({ map }) => !map)];
  return documentOf(place, {
    title: "Documentation · Riverseed",
    description: DESCRIPTION,
    address: "",
    kind: "first",
    groups,
    body: `<main>
      <h1>Documentation</h1>
      <p class="lead">Each page begins with something to paste.</p>
      <h2>What do you want to do?</h2>
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

function cardOf(reader: Reader, title: string, shown: Picture | undefined, { site }: Place): string {
  const top = shown ? `${pictureOf(shown)}<p class="who">${escaped(reader.who)}</p>` : "";
  return `<li>${top}<h3><a href="${addressOf(sourceOf(reader))}">${escaped(title)}</a></h3>${codeOf(reader.line, reader.lang, "../", site)}</li>`;
}

/** Returns the picture of a card, which only decorates it. */
function pictureOf({ card: { address, width, height } }: Picture): string {
  return `<img src="../${address}" width="${width}" height="${height}" alt="" />`;
}
