/** The panel: opened and closed by a button, and remembered. It lies beside the map, not over it. */

export interface PanelElements {
  panel: HTMLElement;
  open: HTMLButtonElement;
  close: HTMLButtonElement;
}

const KEPT = "riverseed panel";

export class Panel {
  constructor(
    private readonly elements: PanelElements,
    private readonly storage: () => Storage,
    /** It covers more or less of the page. */
    private readonly changed: () => void,
  ) {
    elements.open.addEventListener("click", () => this.#become(Boolean(elements.panel.hidden)));
    elements.close.addEventListener("click", () => this.#leave());
    document.addEventListener("keydown", (event) => {
      if (event.key === "Escape" && !event.defaultPrevented && elements.panel.contains(document.activeElement))
        this.#leave();
    });
    this.#show(this.#wasOpen());
  }

  #leave(): void {
    this.#become(false);
    this.elements.open.focus({ preventScroll: true });
  }

  #become(isOpen: boolean): void {
    this.#show(isOpen);
    try {
      this.storage().setItem(KEPT, isOpen ? "open" : "closed");
    } catch {
      // Where nothing may be kept it begins closed the next time.
    }
    this.changed();
  }

  #show(isOpen: boolean): void {
    this.elements.panel.hidden = !isOpen;
    this.elements.open.setAttribute("aria-expanded", String(isOpen));
  }

  #wasOpen(): boolean {
    try {
      return this.storage().getItem(KEPT) === "open";
    } catch {
      return false;
    }
  }
}
