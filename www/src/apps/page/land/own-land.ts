/** The visitor's own land: drawn, or traced from a picture that is chosen, dropped or pasted. */

import { isRecoverable, named } from "../../../engine/errors.ts";
import type { Traced } from "../../../engine/whole.ts";
import { elements } from "../elements.ts";
import { Drawing, type Outlines } from "./drawing.ts";
import { listenForImages } from "./image-drop.ts";
import { pixelsOf } from "./image-file.ts";

/** The part of the engine that traces pictures, too. */
export interface Tracing extends Outlines {
  longestTracedSide(): number;
  traceImage(rgba: Uint8Array, width: number, height: number): Traced;
}

export interface OwnLandEvents {
  /** Returns the values of the map on show. */
  values(): ReadonlyMap<string, string>;
  /** Called to change some of them. */
  changed(values: readonly (readonly [key: string, value: string])[]): void;
  /** Called when a picture cannot be a land, with a sentence that says why. */
  refused(message: string): void;
  failed(error: unknown): void;
}

export class OwnLand {
  readonly #drawing: Drawing;

  constructor(
    private readonly engine: Tracing,
    private readonly events: OwnLandEvents,
  ) {
    this.#drawing = new Drawing(elements.drawing, engine, {
      drawn: (outline) => events.changed(drawn(outline)),
      failed: (error) => this.#fail(error),
    });
    elements.drawing.draw.addEventListener("click", () => this.#showDrawn());
    listenForImages(elements.drawing, (file) => void this.#trace(file));
  }

  get isOpen(): boolean {
    return this.#drawing.isOpen;
  }

  /** Ends drawing. */
  escape(): boolean {
    const wasOpen = this.isOpen;
    this.#drawing.close();
    return wasOpen;
  }

  /** Follows the recipe. */
  show(values: ReadonlyMap<string, string>): void {
    this.#drawing.show(values.get("outline") ?? "");
  }

  /** Opens the tool when a drawn land was chosen and none has been drawn. */
  ask(): void {
    if (this.events.values().get("outline") === "") this.#drawing.open();
  }

  /** Shows a land that was drawn before again, when the tool is opened. */
  #showDrawn(): void {
    const values = this.events.values();
    const outline = values.get("outline") ?? "";
    if (outline !== "" && values.get("land") !== "drawn") this.events.changed(drawn(outline));
  }

  /** Turns a picture of a land into the land. */
  async #trace(file: Blob): Promise<void> {
    try {
      const { rgba, width, height } = await pixelsOf(file, this.engine.longestTracedSide());
      const traced = this.engine.traceImage(rgba, width, height);
      this.#drawing.take(traced);
      this.events.changed([["aspect", traced.aspect.toFixed(2)]]);
    } catch (error) {
      this.#fail(error);
    }
  }

  #fail(thrown: unknown): void {
    const error = named(thrown);
    if (isRecoverable(error)) this.events.refused(error.message);
    else this.events.failed(error);
  }
}

/** Makes the values of a link that shows a drawn land. */
function drawn(outline: string): [key: string, value: string][] {
  return [
    ["land", "drawn"],
    ["outline", outline],
  ];
}
