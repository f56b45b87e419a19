/** Writes tables, each in a box in which it scrolls if it is wider than the window. */

import type { Token, Tokens } from "marked";
import { escaped } from "../../src/apps/page/share/snippets.ts";
import { wordsOf } from "./plain.ts";

/** Writes a table. `names` are the names of its rows in addresses, `inline` writes what stands in a cell. */
export function tableOf(
  { header, rows }: Tokens.Table,
  names: readonly (string | undefined)[],
  inline: (tokens: Token[]) => string,
): string {
  const cell = ({ tokens }: Tokens.TableCell, tag: "th" | "td") => {
    const inner = inline(tokens);
    return inner === "" ? "<td></td>" : `<${tag}>${inner}</${tag}>`;
  };
  const row = (cells: readonly Tokens.TableCell[], tag: "th" | "td", name?: string) =>
    `<tr${name === undefined ? "" : ` id="${escaped(name)}"`}>${cells.map((one) => cell(one, tag)).join("")}</tr>`;
  const titles = header.map(({ tokens }) => wordsOf(tokens)).filter((title) => title !== "");
  const head = titles.length > 0 ? `<thead>${row(header, "th")}</thead>\n` : "";
  const label = titles.length > 0 ? `Table: ${titles.join(", ")}` : "Table";
  return `<div class="table" tabindex="0" role="group" aria-label="${escaped(label)}"><table>
${head}<tbody>
${rows.map((cells, i) => row(cells, "td", names[i])).join("\n")}
</tbody></table></div>\n`;
}
