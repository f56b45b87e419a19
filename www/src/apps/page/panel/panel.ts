/** The panel, beside the map and not over it. Buttons open and close it, and its state is remembered. */

import type { Disclosures } from "../../../controls/disclosure.ts";

export interface PanelElements {
  panel: HTMLElement;
  open: HTMLButtonElement;
  close: HTMLButtonElement;
}

const NAME = "Panel";

export class Panel {
  constructor(
    private readonly elements: PanelElements,
    private readonly disclosures: Disclosures,
    /** Called when it covers more or less of the page. */
    private readonly changed: () => void,
  ) {
    elements.open.addEventListener("click", () => this.#become(Boolean(elements.panel.hidden)));
    elements.close.addEventListener("click", () => this.#leave());
    this.#show(disclosures.isOpen(NAME, false));
  }

  /** Closes the panel, if the focus is in it. */
  escape(): boolean {
    const hasFocus = this.elements.panel.contains(document.activeElement);
    if (hasFocus) this.#leave();
    return hasFocus;
  }

  #leave(): void {
    this.#become(false);
    this.elements.open.focus({ preventScroll: true });
  }

  #become(isOpen: boolean): void {
    this.#show(isOpen);
    this.disclosures.set(NAME, isOpen);
    this.changed();
  }

  #show(isOpen: boolean): void {
    this.elements.panel.hidden = !isOpen;
    this.elements.open.setAttribute("aria-expanded", String(isOpen));
  }
}
