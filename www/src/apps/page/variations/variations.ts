/**
 * The dialog of variations: the map in the middle and its neighbours around it, as finished pictures that come one after
 * another. A neighbour that is pressed becomes the map.
 */

import { backingSize, type Size } from "../../../browser/canvas.ts";
import { el, setText } from "../../../browser/dom.ts";
import { changed } from "../../../engine/link-text.ts";
import type { Parameter } from "../../../engine/table.ts";
import type { Picture } from "../../../player/thumbnails.ts";
import type { Values, Varied } from "./dials.ts";
import { AROUND, type Neighbour, neighboursOf } from "./neighbours.ts";

export interface VariationsElements {
  dialog: HTMLDialogElement;
  /** Opens the dialog. */
  open: HTMLButtonElement;
  /** Asks for other neighbours. */
  others: HTMLButtonElement;
  close: HTMLButtonElement;
  status: HTMLElement;
  /** The place of the pictures. */
  pictures: HTMLElement;
}

export interface VariationsEvents {
  /** Returns the map on show. */
  map(): Varied;
  /** Draws the finished map of a link, with `size` in device pixels; nothing if it is no longer wanted. */
  picture(link: string, size: Size): Promise<Picture | undefined>;
  /** Called when a neighbour was chosen. */
  take(values: Values): void;
}

const NOTHING_TO_VARY = "All that could vary is locked, or has no effect on this map.";

/** A place for a picture, and the link of the map that it shows. */
interface Place {
  button: HTMLButtonElement;
  canvas: HTMLCanvasElement;
  link: string;
}

export class Variations {
  readonly #table: ReadonlyMap<string, Parameter>;
  #map: Varied | undefined;
  /** The number of times that others were asked for. */
  #round = 0;
  #middle: Place | undefined;
  /** Counts what was asked to be drawn: only the pictures that were asked for last are drawn. */
  #drawing = 0;

  constructor(
    private readonly elements: VariationsElements,
    table: readonly Parameter[],
    private readonly events: VariationsEvents,
  ) {
    this.#table = new Map(table.map((parameter) => [parameter.key, parameter]));
    const { dialog, open, others, close } = elements;
    open.addEventListener("click", () => this.#open());
    others.addEventListener("click", () => this.#show(this.#round + 1));
    close.addEventListener("click", () => dialog.close());
    dialog.addEventListener("close", () => this.#leave());
  }

  #open(): void {
    const map = this.events.map();
    this.#map = map;
    this.#middle = placeOf("This map", map.link, () => this.elements.dialog.close());
    this.#middle.button.setAttribute("aria-current", "true");
    this.elements.dialog.style.setProperty("--aspect", map.values.get("aspect") ?? "1");
    this.elements.dialog.showModal();
    this.#show(0);
  }

  /** Shows the neighbours of a round around the map. */
  #show(round: number): void {
    const [map, middle] = [this.#map, this.#middle];
    if (!map || !middle) return;
    this.#round = round;
    const neighbours = neighboursOf(map, this.#table, round);
    const places = neighbours.map((one) => placeOf(one.words, changed(map.link, one.values), () => this.#take(one)));
    const [before, after] = [places.slice(0, AROUND / 2), places.slice(AROUND / 2)];
    const { pictures, status, others } = this.elements;
    pictures.replaceChildren(...[...before, middle, ...after].map(({ button }) => button));
    others.disabled = neighbours.length === 0;
    setText(status, neighbours.length === 0 ? NOTHING_TO_VARY : "");
    // All are as large as this one, and drawn in one size, so that equal maps are equal pictures.
    const size = backingSize(middle.canvas.getBoundingClientRect(), window.devicePixelRatio);
    const isDrawn = middle.button.dataset["state"] === "drawn";
    void this.#draw(isDrawn ? places : [middle, ...places], size);
  }

  /** Draws pictures one after another, until others are asked for or the dialog is closed. */
  async #draw(places: readonly Place[], size: Size): Promise<void> {
    const drawing = ++this.#drawing;
    let isComplete = true;
    for (const { button, canvas, link } of places) {
      const picture = await this.events.picture(link, size).catch(() => undefined);
      if (drawing !== this.#drawing) return;
      button.dataset["state"] = picture ? "drawn" : "failed";
      isComplete &&= picture !== undefined;
      if (picture) put(picture, canvas);
    }
    if (places.length > 1) setText(this.elements.status, isComplete ? "All are drawn." : "Not all could be drawn.");
  }

  #take({ values }: Neighbour): void {
    this.elements.dialog.close();
    this.events.take(values);
  }

  #leave(): void {
    this.#drawing++;
    this.#middle = undefined;
    this.elements.pictures.replaceChildren();
  }
}

function placeOf(words: string, link: string, press: () => void): Place {
  // Hidden from screen readers, since the words say what is different.
  const canvas = el("canvas", { "aria-hidden": "true" });
  const button = el("button", { type: "button", class: "neighbour" }, canvas, el("span", {}, words));
  button.addEventListener("click", press);
  return { button, canvas, link };
}

function put({ width, height, pixels }: Picture, canvas: HTMLCanvasElement): void {
  Object.assign(canvas, { width, height });
  canvas.getContext("2d")?.putImageData(new ImageData(pixels, width, height), 0, 0);
}
