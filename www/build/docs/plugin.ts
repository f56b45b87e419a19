/** Adds the documentation to the site: during the build, or in the dev server when a page is requested. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Plugin, Rolldown } from "vite";
import { indexOf } from "../../src/apps/docs/index.ts";
import { madeOnRequest, type Source } from "../made-on-request.ts";
import { addressOf, contents, REPOSITORY } from "./contents.ts";
import { firstPage } from "./first.ts";
import { FOLDER, INDEX, type Place } from "./frame.ts";
import { pageOf } from "./page.ts";
import { drawn, pictures } from "./pictures.ts";
import { sectionsOf } from "./sections.ts";

const SHEET = "src/style/docs.css";
const SCRIPT = "src/apps/docs/docs.ts";
const SITE_SCRIPT = "src/apps/docs/docs-site.ts";
/** The pages' style sheet and scripts, which are inputs of the build. */
export const DOCS_INPUTS = [SHEET, SCRIPT, SITE_SCRIPT];

export function docs(site: string | undefined): Plugin {
  return {
    name: "docs",
    configureServer: madeOnRequest(FOLDER, TYPES, (file) =>
      made(file, { site, sheet: SHEET, script: SCRIPT, siteScript: SITE_SCRIPT, hasPolicy: false }),
    ),
    async generateBundle(_options, bundle) {
      const place: Place = { site, ...builtFilesOf(bundle), hasPolicy: true };
      for (const [file, source] of writtenFor(place))
        this.emitFile({ type: "asset", fileName: `${FOLDER}/${file}`, source });
      for (const [fileName, source] of await drawn()) this.emitFile({ type: "asset", fileName, source });
    },
  };
}

const TYPES: Readonly<Record<string, string>> = {
  json: "application/json",
  png: "image/png",
  svg: "image/svg+xml",
  webp: "image/webp",
};

/** Makes a file of the documentation, if there is one of this name. */
async function made(file: string, place: Place): Promise<Source | undefined> {
  return writtenFor(place).get(file) ?? (file.endsWith(".webp") ? (await drawn()).get(`${FOLDER}/${file}`) : undefined);
}

/** Finds the style sheet and the scripts of the pages among what was built. */
function builtFilesOf(bundle: Rolldown.OutputBundle): Pick<Place, "sheet" | "script" | "siteScript"> {
  const files = Object.values(bundle);
  const sheet = files.find(({ type, fileName }) => type === "asset" && /docs-[\w-]+\.css$/.test(fileName));
  const [script, siteScript] = [SCRIPT, SITE_SCRIPT].map((source) =>
    files.find((file) => file.type === "chunk" && file.facadeModuleId?.endsWith(source)),
  );
  if (!sheet || !script || !siteScript) throw new Error("the build lacks a style sheet or script of the documentation");
  return { sheet: sheet.fileName, script: script.fileName, siteScript: siteScript.fileName };
}

/** Writes all files of the documentation, by their names in its folder. */
export function writtenFor(place: Place): Map<string, Source> {
  const groups = contents();
  const shown = pictures();
  const articles = groups.flatMap((group) => group.articles);
  const files = new Map<string, Source>([["index.html", firstPage(groups, shown, place)]]);
  for (const article of articles) {
    const { html, figures } = pageOf(article, groups, shown, place);
    files.set(addressOf(article.source), html);
    for (const figure of figures) files.set(figure.slice(`${FOLDER}/`.length), readFileSync(join(REPOSITORY, figure)));
  }
  files.set(INDEX, indexOf(articles.flatMap(sectionsOf)));
  return files;
}
