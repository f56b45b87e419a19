/**
 * The search field and its list. The index is fetched when the field first gets the focus. Slash leads to the field from anywhere, arrows
 * from result to result, Enter to the first one or the one with the focus, Escape out.
 */

import { Index } from "./index.ts";
import { countOf, showResults } from "./results.ts";

const FAILED = "The search could not be loaded. The list of contents has all pages.";

export class Search {
  readonly #box: HTMLElement;
  readonly #field: HTMLInputElement;
  readonly #list: HTMLElement;
  readonly #status: HTMLElement;
  #index: Promise<Index> | undefined;
  /** Counts questions, so that a late answer to an earlier one is not shown. */
  #questions = 0;

  constructor(box: HTMLElement) {
    this.#box = box;
    this.#field = one(box, "input");
    this.#list = one(box, "ul");
    this.#status = one(box, "[role=status]");
    this.#field.addEventListener("focus", () => void this.#load().catch(() => {}));
    this.#field.addEventListener("input", () => void this.#ask());
    box.addEventListener("keydown", (event) => this.#onKey(event));
    box.addEventListener("focusout", ({ relatedTarget }) => {
      if (relatedTarget instanceof Node && !box.contains(relatedTarget)) this.#close();
    });
    document.addEventListener("pointerdown", ({ target }) => {
      if (target instanceof Node && !box.contains(target)) this.#close();
    });
    document.addEventListener("keydown", (event) => this.#onSlash(event));
    // Whoever was faster than this script has been typing.
    if (document.activeElement === this.#field) void this.#ask();
  }

  /** Fetches the index, once; after a failure, again. */
  #load(): Promise<Index> {
    this.#index ??= fetched(this.#box.dataset["index"] ?? "").catch((error: unknown) => {
      this.#index = undefined;
      throw error;
    });
    return this.#index;
  }

  async #ask(): Promise<void> {
    const number = ++this.#questions;
    const question = this.#field.value.trim();
    if (question === "") return this.#close();
    try {
      const results = (await this.#load()).find(question);
      if (number !== this.#questions) return;
      showResults(this.#list, results, this.#box.dataset["way"] ?? "");
      this.#list.hidden = results.length === 0;
      this.#status.textContent = countOf(results, question);
    } catch {
      if (number === this.#questions) this.#status.textContent = FAILED;
    }
  }

  #close(): void {
    this.#questions++;
    this.#list.hidden = true;
    this.#list.replaceChildren();
    this.#status.textContent = "";
  }

  #onKey(event: KeyboardEvent): void {
    const links = [...this.#list.querySelectorAll("a")];
    const at = links.indexOf(document.activeElement as HTMLAnchorElement);
    const stops: readonly HTMLElement[] = [this.#field, ...links];
    const goTo = (target: HTMLElement | undefined): void => {
      event.preventDefault();
      target?.focus();
    };
    if (event.key === "ArrowDown") goTo(stops[Math.min(at + 2, links.length)]);
    else if (event.key === "ArrowUp") goTo(stops[Math.max(at, 0)]);
    else if (event.key === "Enter" && at < 0 && !event.isComposing) links[0]?.click();
    else if (event.key === "Escape") {
      goTo(this.#field);
      this.#field.value = "";
      this.#close();
    }
  }

  #onSlash(event: KeyboardEvent): void {
    const isTyping = event.target instanceof HTMLElement && event.target.matches("input, textarea, [contenteditable]");
    if (event.key !== "/" || isTyping || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    this.#field.focus();
  }
}

async function fetched(address: string): Promise<Index> {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address}: ${answer.status}`);
  return new Index(await answer.text());
}

function one<Kind extends HTMLElement>(box: HTMLElement, selector: string): Kind {
  const found = box.querySelector<Kind>(selector);
  if (!found) throw new Error(`the search has no ${selector}`);
  return found;
}
