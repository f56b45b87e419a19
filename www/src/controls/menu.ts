/** A button that opens a menu: the pattern that screen readers and keyboards know, and nothing more. */

/** The menu stands where it can be seen; what is behind it does not scroll. */
const IN_PLACE = { preventScroll: true };

export class Menu {
  readonly #items: HTMLElement[];

  constructor(
    private readonly button: HTMLButtonElement,
    private readonly list: HTMLElement,
    choose: (item: HTMLElement) => void,
  ) {
    this.#items = [...list.querySelectorAll<HTMLElement>('[role="menuitem"]')];
    button.addEventListener("click", () => (list.hidden ? this.#open(0) : this.#close()));
    button.addEventListener("keydown", (event) => this.#onButtonKey(event));
    list.addEventListener("keydown", (event) => this.#onListKey(event));
    for (const item of this.#items) {
      item.addEventListener("click", () => {
        this.#close();
        button.focus(IN_PLACE);
        choose(item);
      });
    }
    document.addEventListener("pointerdown", (event) => this.#closeUnlessAt(event.target));
    document.addEventListener("focusin", (event) => this.#closeUnlessAt(event.target));
  }

  /** Opens with the focus on an item; -1 is the last. */
  #open(item: number): void {
    this.list.hidden = false;
    this.button.setAttribute("aria-expanded", "true");
    this.#items.at(item)?.focus(IN_PLACE);
  }

  #close(): void {
    this.list.hidden = true;
    this.button.setAttribute("aria-expanded", "false");
  }

  #closeUnlessAt(target: EventTarget | null): void {
    if (target instanceof Node && (this.list.contains(target) || this.button.contains(target))) return;
    this.#close();
  }

  #onButtonKey(event: KeyboardEvent): void {
    if (event.key !== "ArrowDown" && event.key !== "ArrowUp") return;
    event.preventDefault();
    this.#open(event.key === "ArrowDown" ? 0 : -1);
  }

  #onListKey(event: KeyboardEvent): void {
    const count = this.#items.length;
    const at = event.target instanceof HTMLElement ? this.#items.indexOf(event.target) : -1;
    const places: Record<string, number> = {
      ArrowDown: (at + 1) % count,
      ArrowUp: (at - 1 + count) % count,
      Home: 0,
      End: count - 1,
    };
    const place = places[event.key];
    if (event.key === "Escape") {
      this.#close();
      this.button.focus(IN_PLACE);
    } else if (place !== undefined) {
      event.preventDefault();
      this.#items[place]?.focus(IN_PLACE);
    }
  }
}
