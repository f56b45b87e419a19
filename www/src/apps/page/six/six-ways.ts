/** The six variants as the page offers them: a button that opens their sheet, and an address that says whether they are seen. */

import { asksForSix, withSix } from "../../../browser/address.ts";
import { el } from "../../../browser/dom.ts";
import type { Preset } from "../../../engine/full.ts";
import type { PageRenderHost } from "../backend.ts";
import { elements } from "../elements.ts";
import { howFor } from "../preferences.ts";
import { type SharedValues, SideBySide } from "./side-by-side.ts";

export interface SixWaysEvents {
  /** The map that they are made from. */
  shared(): SharedValues;
  /** They cover the map from now on, or do not any more. */
  changed(isOpen: boolean): void;
  /** One was chosen. */
  take(preset: Preset, all: readonly Preset[]): void;
  /** Copies the address, and says so. */
  copy(): Promise<string>;
  /** They could not be opened. */
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
      how: () => howFor("watch"),
    });
    this.button.addEventListener("click", () => this.open());
  }

  /** Whether the page's address asks for them. */
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

  /** A link as the address has it. */
  inAddress(link: string): string {
    return this.#sheet.isOpen ? withSix(link) : link;
  }
}
