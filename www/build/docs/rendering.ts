/** Writes a document as HTML. */

import { Marked, type RendererObject, type Token, type Tokens } from "marked";
import { escaped } from "../../src/apps/page/share/snippets.ts";
import type { Article, Block } from "./article.ts";
import { codeOf } from "./code.ts";
import { addressOf, wayUp } from "./contents.ts";
import { figureOf } from "./figures.ts";
import { targetOf } from "./links.ts";
import { wordsOf } from "./plain.ts";
import { explainsStandIn } from "./stand-in.ts";
import { tableOf } from "./tables.ts";

/** A document as HTML. */
export interface Body {
  readonly html: string;
  /** The pictures that it shows, by their paths in the repository. */
  readonly figures: readonly string[];
}

/** HTML that is nothing but comments. */
const COMMENTS = /^(?:\s*<!--(?:(?!-->)[\s\S])*-->)*\s*$/;
/** The most characters of a lead. */
const LONGEST_LEAD = 190;

/** Writes a document as HTML. Throws one error with all that is wrong with it, each with its line. */
export function bodyOf(article: Article, all: ReadonlyMap<string, Article>, site: string | undefined): Body {
  const faults: string[] = [];
  const figures: string[] = [];
  const parts = article.blocks.map((block) => {
    const fault = (text: string, near: string) => {
      faults.push(`${article.source}:${lineOf(block, near)}: ${text}`);
      return "";
    };
    const renderer = rendererOf({ article, all, site, block, fault, figures });
    return new Marked({ renderer }).parser([block.token]);
  });
  if (faults.length > 0) throw new Error(faults.join("\n"));
  return { html: parts.join(""), figures };
}

interface Context {
  readonly article: Article;
  readonly all: ReadonlyMap<string, Article>;
  readonly site: string | undefined;
  readonly block: Block;
  readonly fault: (text: string, near: string) => string;
  readonly figures: string[];
}

/** Returns the line of a block on which a text stands, or on which the block begins. */
function lineOf({ token, line }: Block, near: string): number {
  const before = token.raw.indexOf(near);
  return line + (before < 0 ? 0 : token.raw.slice(0, before).split("\n").length - 1);
}

function rendererOf(context: Context): RendererObject {
  const { article, all, site, block, fault, figures } = context;
  const lead = leadOf(article);
  return {
    heading({ tokens, depth }: Tokens.Heading) {
      const inner = this.parser.parseInline(tokens);
      const { id = "", text = "" } = block.heading ?? {};
      if (depth === 1) return `<h1 id="${escaped(id)}">${inner}</h1>\n`;
      const mark = `<a class="mark" href="#${escaped(id)}" aria-label="Link to “${escaped(text)}”">#</a>`;
      return `<h${depth} id="${escaped(id)}">${inner} ${mark}</h${depth}>\n`;
    },
    paragraph({ tokens }: Tokens.Paragraph) {
      const inner = this.parser.parseInline(tokens);
      if (block.token === lead) return `<p class="lead">${inner}</p>\n`;
      if (!explainsStandIn(wordsOf(tokens))) return `<p>${inner}</p>\n`;
      return site === undefined ? `<noscript><p>${inner}</p></noscript>\n` : "";
    },
    link({ href, tokens }: Tokens.Link) {
      const inner = this.parser.parseInline(tokens);
      const target = targetOf(href, article, all);
      if ("fault" in target) return fault(target.fault, `](${href}`);
      return target.href === undefined ? inner : `<a href="${escaped(target.href)}">${inner}</a>`;
    },
    image(image: Tokens.Image) {
      const figure = figureOf(image, article);
      if ("fault" in figure) return fault(figure.fault, `](${image.href}`);
      figures.push(figure.source);
      return figure.html;
    },
    code({ text, lang = "" }: Tokens.Code) {
      return `${codeOf(text, lang, `${wayUp(addressOf(article.source))}../`, site)}\n`;
    },
    table(table: Tokens.Table) {
      return tableOf(table, block.rows ?? [], (tokens) => this.parser.parseInline(tokens));
    },
    html({ text }: Tokens.HTML | Tokens.Tag) {
      return COMMENTS.test(text) ? "" : fault(`this is HTML, which pages do not take: ${text.trim()}`, text);
    },
  };
}

/** Returns the paragraph after the title, if it is short enough to be set as a lead. */
function leadOf({ blocks, lead }: Article): Token | undefined {
  const token = blocks.find(({ token }) => token.type !== "heading" && token.type !== "space")?.token;
  return lead.length <= LONGEST_LEAD && token?.type === "paragraph" ? token : undefined;
}
