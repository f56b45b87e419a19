/**
 * The strip of styles: a thumbnail of the map on show in each style. Choosing a style never changes the map: a style
 * that needs a country of its own has a button after it, which goes there.
 */

import { el } from "../../../browser/dom.ts";
import type { Parameter, Preset } from "../../../engine/table.ts";
import type { Thumbnail } from "../../../player/thumbnails.ts";

/** The size of a thumbnail in CSS pixels. */
const SIZE = { width: 112, height: 64 };

/** The first styles in their order on the strip; the others follow. */
const FIRST = ["atlas", "night", "survey", "parchment", "basins", "past-courses", "ink-wash", "orbit", "blueprint"];

/** Makes thumbnails of the map on show, with `size` in device pixels; none if another map is shown by then. */
export type MakeThumbnails = (
  styles: readonly string[],
  size: { width: number; height: number },
) => Promise<readonly Thumbnail[]>;

interface Choose {
  style(style: string): void;
  country(country: Preset): void;
}

export class StyleStrip {
  readonly #buttons = new Map<string, { button: HTMLButtonElement; canvas: HTMLCanvasElement }>();
  /** The buttons of countries, each after the button of the style that is best there. */
  readonly #best: { country: Preset; button: HTMLButtonElement }[];
  /** The link, without a style, of the map in the thumbnails. */
  #map: string | undefined;
  readonly #ratio = Math.min(2, Math.max(1, Math.ceil(window.devicePixelRatio)));

  constructor(
    private readonly place: HTMLElement,
    style: Parameter | undefined,
    countries: readonly Preset[],
    private readonly choose: Choose,
  ) {
    const choices = style?.choices ?? [];
    const rank = (value: string): number => (FIRST.indexOf(value) + FIRST.length + 1) % (FIRST.length + 1);
    for (const { value } of [...choices].sort((a, b) => rank(a.value) - rank(b.value))) {
      const { width, height } = this.#size;
      const canvas = el("canvas", { width, height, "aria-hidden": "true" });
      const button = el(
        "button",
        { type: "button", class: "style", "aria-pressed": "false" },
        canvas,
        el("span", {}, nameOf(value)),
      );
      button.addEventListener("click", () => this.#choose(value));
      // Browsers do not scroll to an element that is partly visible.
      button.addEventListener("focus", () => button.scrollIntoView({ block: "nearest", inline: "nearest" }));
      this.#buttons.set(value, { button, canvas });
      place.append(button);
    }
    this.#best = countries.filter(({ style }) => style !== undefined).map((country) => this.#makeBest(country));
  }

  /** Makes thumbnails of a finished map, unless only its style has changed since the last ones. */
  async refresh(link: () => string, make: MakeThumbnails): Promise<void> {
    const map = unstyled(link());
    if (map === this.#map || this.place.getClientRects().length === 0) return;
    const made = await make([...this.#buttons.keys()], this.#size).catch((thrown: unknown) => {
      // Not tried again for this map, since it would fail again.
      this.#map = map;
      throw thrown;
    });
    if (made.length === 0 || unstyled(link()) !== map) return;
    this.#map = map;
    for (const thumbnail of made) this.#draw(thumbnail);
  }

  /** The size of a thumbnail in device pixels. */
  get #size(): { width: number; height: number } {
    return { width: SIZE.width * this.#ratio, height: SIZE.height * this.#ratio };
  }

  /** Shows which style is chosen, and offers the country that it is best on unless that would change nothing. */
  show(style: string, changesNothing: (country: Preset) => boolean): void {
    for (const [value, { button }] of this.#buttons) button.setAttribute("aria-pressed", String(value === style));
    for (const { country, button } of this.#best) button.hidden = country.style !== style || changesNothing(country);
  }

  #choose(style: string): void {
    this.choose.style(style);
    // Where the strip is short, the country that has come up after its style may be out of sight.
    for (const { button } of this.#best) button.scrollIntoView({ block: "nearest", inline: "nearest" });
  }

  #makeBest(country: Preset): { country: Preset; button: HTMLButtonElement } {
    const attributes = { type: "button", class: "quiet", title: country.help, hidden: true };
    const button = el("button", attributes, `Best on: ${country.label}`);
    const style = this.#buttons.get(country.style ?? "")?.button;
    style?.after(button);
    button.addEventListener("click", () => {
      this.choose.country(country);
      // The button is gone now: the focus goes back to the style.
      style?.focus();
    });
    return { country, button };
  }

  #draw({ style, width, height, pixels }: Thumbnail): void {
    const image = new ImageData(pixels, width, height);
    this.#buttons.get(style)?.canvas.getContext("2d")?.putImageData(image, 0, 0);
  }
}

/** Returns a link without its style. */
function unstyled(link: string): string {
  const values = new URLSearchParams(link);
  values.delete("style");
  return values.toString();
}

/** Returns the name of a style as people write it. */
function nameOf(value: string): string {
  const words = value.replaceAll("-", " ");
  return words.charAt(0).toUpperCase() + words.slice(1);
}
