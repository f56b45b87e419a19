/**
 * The templates of a map's page, which are those of `riverseed page` (crates/cli/src/page/templates). Handlebars escapes
 * what is put into them.
 */

import { readFileSync } from "node:fs";
import Handlebars from "handlebars";

/** The contents of a page's head. */
export interface Head {
  readonly policy: string | undefined;
  readonly title: string;
  readonly description: string;
  readonly icon: string;
  /** Addresses of style sheets. */
  readonly sheets: readonly string[];
  /** The page's absolute address, if the site's is known. */
  readonly address: string | undefined;
  readonly card:
    | { readonly address: string; readonly width: number; readonly height: number; readonly alt: string }
    | undefined;
  /** The address of the oEmbed response. */
  readonly oembed: string | undefined;
}

/** The contents of a map's page. */
export interface MapPage extends Head {
  readonly name: string;
  /** The way back. */
  readonly trail: readonly Link[];
  /** A class for the map's shape, since pages may not contain styles. */
  readonly shape: string;
  readonly picture: { readonly file: string; readonly width: number; readonly height: number; readonly alt: string };
  /** The address of the page where the map can be changed. */
  readonly maker: string;
  readonly acts: readonly Link[];
  readonly settings: readonly { readonly label: string; readonly value: string }[];
  readonly link: string;
  readonly snippet: { readonly lead: string; readonly code: string; readonly placeholder: string | undefined };
  readonly others: readonly Link[];
}

export interface Link {
  readonly address: string;
  readonly label: string;
  readonly rel?: string;
}

const FOLDER = new URL("../../../crates/cli/src/page/templates/", import.meta.url);

const templates = Handlebars.create();
templates.registerPartial("head", textOf("head"));
const page = templates.compile<MapPage>(textOf("page"));
const other = templates.compile<Head & { body: string }>(`<!doctype html>
<html lang="en">
  <head>
    {{#if policy}}
    <meta http-equiv="Content-Security-Policy" content="{{{policy}}}" />
    {{/if}}
    {{> head}}
  </head>
  <body>
    {{{body}}}
  </body>
</html>
`);

export function mapPage(content: MapPage): string {
  return page(content);
}

/** Writes a page with a body of its own, which is HTML. */
export function pageWith(head: Head, body: string): string {
  return other({ ...head, body });
}

/** Returns the icon of all pages. */
export function icon(): string {
  return readFileSync(new URL("icon.txt", FOLDER), "utf8").trim();
}

function textOf(name: string): string {
  return readFileSync(new URL(`${name}.hbs`, FOLDER), "utf8");
}
