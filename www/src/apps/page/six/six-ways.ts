/**
 * The page's access to the six variants: a button that opens them, and the part of the address that says whether they
 * are shown.
 */

import { asksForSix, withSix } from "../../../browser/address.ts";
import { el } from "../../../browser/dom.ts";
import type { Preset } from "../../../engine/table.ts";
import type { PageRenderHost } from "../backend.ts";
import { elements } from "../elements.ts";
import { howToGrow } from "../preferences.ts";
import { type SharedValues, SideBySide } from "./side-by-side.ts";

export interface SixWaysEvents {
  /** Returns the values of the map from which they are made. */
  shared(): SharedValues;
  /** Called when they are opened or closed: while open, they cover the map. */
  changed(isOpen: boolean): void;
  /** Called when one was chosen. */
  take(preset: Preset, all: readonly Preset[]): void;
  /** Copies the address, and returns a message about it. */
  copy(): Promise<string>;
  /** Called when they could not be opened. */
  failed(error: unknown): void;
}

export class SixWays {
  readonly button = el("button", { type: "button", "aria-haspopup": "dialog" }, "Compare all six");
  readonly #sheet: SideBySide;

  constructor(
    renderHost: PageRenderHost,
    presets: readonly Preset[],
    private readonly events: SixWaysEvents,
  ) {
    const { changed, take, copy } = events;
    this.#sheet = new SideBySide(elements.six, renderHost, presets, {
      changed,
      take,
      copy,
      how: howToGrow,
    });
    this.button.addEventListener("click", () => this.open());
  }

  /** True if the page's address asks for them. */
  get areAskedFor(): boolean {
    return asksForSix(location);
  }

  open(): void {
    try {
      this.#sheet.open(this.events.shared());
    } catch (error) {
      this.events.failed(error);
    }
  }

  close(): void {
    this.#sheet.close();
  }

  /** Returns a link as the address contains it. */
  inAddress(link: string): string {
    return this.#sheet.isOpen ? withSix(link) : link;
  }
}
