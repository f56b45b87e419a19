/**
 * The strip of styles: a thumbnail of the map on show in each of the first styles, and of the others once somebody asks
 * for more. Choosing a style never changes the map: a style that needs a country of its own has a button after it, which
 * goes there.
 */

import { el } from "../../../browser/dom.ts";
import type { Country, Parameter } from "../../../engine/table.ts";
import type { Thumbnail } from "../../../player/thumbnails.ts";

/** The size of a thumbnail in CSS pixels. */
const SIZE = { width: 112, height: 64 };

/** The folder of the pictures that build/button-pictures.ts draws, beside the page. */
const STYLE_PICTURES = "./styles";

/** The number of styles, in the table's order, that are in sight from the beginning. */
const FIRST = 6;

/** Makes thumbnails of the map on show, with `size` in device pixels; none if another map is shown by then. */
export type MakeThumbnails = (
  styles: readonly string[],
  size: { width: number; height: number },
) => Promise<readonly Thumbnail[]>;

interface Choose {
  style(style: string): void;
  country(country: Country): void;
}

export class StyleStrip {
  readonly #buttons = new Map<string, { button: HTMLButtonElement; canvas: HTMLCanvasElement }>();
  /** The buttons of countries, each after the button of the style that is best there. */
  readonly #best: { country: Country; button: HTMLButtonElement }[];
  readonly #more = el(
    "button",
    { type: "button", class: "quiet more-styles", "aria-expanded": "false" },
    "More styles",
  );
  /** The link, without a style, of the map in the thumbnails, and the styles whose thumbnails show it. */
  #map: string | undefined;
  readonly #made = new Set<string>();
  /** Makes the thumbnails that are missing, once there is a map. */
  #makeMissing = async (): Promise<void> => {};
  readonly #ratio = Math.min(2, Math.max(1, Math.ceil(window.devicePixelRatio)));

  constructor(
    private readonly place: HTMLElement,
    style: Parameter | undefined,
    countries: readonly Country[],
    private readonly choose: Choose,
  ) {
    for (const [rank, { value }] of (style?.choices ?? []).entries()) {
      const { width, height } = this.#size;
      const canvas = el("canvas", { width, height, "aria-hidden": "true" });
      // It is fetched once the button is seen.
      canvas.style.backgroundImage = `url("${STYLE_PICTURES}/${value}.webp")`;
      const button = el(
        "button",
        { type: "button", class: "style", "aria-pressed": "false", hidden: rank >= FIRST },
        canvas,
        el("span", {}, nameOf(value)),
      );
      button.addEventListener("click", () => this.#choose(value));
      scrollsOnFocus(button);
      this.#buttons.set(value, { button, canvas });
      place.append(button);
    }
    this.#best = countries.filter(({ style }) => style !== undefined).map((country) => this.#makeBest(country));
    this.#more.addEventListener("click", () => this.#showMore());
    scrollsOnFocus(this.#more);
    place.append(this.#more);
  }

  /** Makes thumbnails of a finished map in the styles in sight, but for those that show it already. */
  async refresh(link: () => string, make: MakeThumbnails): Promise<void> {
    this.#makeMissing = () => this.#refresh(link, make);
    await this.#makeMissing();
  }

  async #refresh(link: () => string, make: MakeThumbnails): Promise<void> {
    const map = unstyled(link());
    if (map !== this.#map) this.#made.clear();
    this.#map = map;
    const missing = [...this.#buttons].filter(([style, { button }]) => !button.hidden && !this.#made.has(style));
    if (missing.length === 0 || this.place.getClientRects().length === 0) return;
    const styles = missing.map(([style]) => style);
    // Whatever comes of it: what fails would fail again.
    for (const style of styles) this.#made.add(style);
    const made = await make(styles, this.#size);
    if (unstyled(link()) !== map) return;
    if (made.length === 0) for (const style of styles) this.#made.delete(style);
    for (const thumbnail of made) this.#draw(thumbnail);
  }

  /** The size of a thumbnail in device pixels. */
  get #size(): { width: number; height: number } {
    return { width: SIZE.width * this.#ratio, height: SIZE.height * this.#ratio };
  }

  /** Shows which style is chosen, and offers the country that it is best on unless that would change nothing. */
  show(style: string, changesNothing: (country: Country) => boolean): void {
    for (const [value, { button }] of this.#buttons) {
      button.setAttribute("aria-pressed", String(value === style));
      if (value === style) button.hidden = false;
    }
    for (const { country, button } of this.#best) button.hidden = country.style !== style || changesNothing(country);
  }

  /** Shows all styles, for good: whoever looks for one may look for another. */
  #showMore(): void {
    const hidden = [...this.#buttons.values()].filter(({ button }) => button.hidden);
    for (const { button } of hidden) button.hidden = false;
    this.#more.remove();
    hidden[0]?.button.focus();
    this.#makeMissing().catch(() => {});
  }

  #choose(style: string): void {
    this.choose.style(style);
    // Where the strip is short, the country that has come up after its style may be out of sight.
    for (const { button } of this.#best) button.scrollIntoView({ block: "nearest", inline: "nearest" });
  }

  #makeBest(country: Country): { country: Country; button: HTMLButtonElement } {
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

/** Brings a button into sight when it gets the focus: browsers do not scroll to an element that is partly visible. */
function scrollsOnFocus(button: HTMLElement): void {
  button.addEventListener("focus", () => button.scrollIntoView({ block: "nearest", inline: "nearest" }));
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
