/** A land of the visitor's own: drawn, or traced from a picture that is chosen, dropped or pasted. */

import { isRecoverable, named } from "../../../engine/errors.ts";
import { loadTracing } from "../../../engine/tracing.ts";
import { elements } from "../elements.ts";
import { Drawing, type Outliner } from "./drawing.ts";
import { listenForImages } from "./image-drop.ts";
import { pixelsOf } from "./image-file.ts";

export interface OwnLandEvents {
  /** The values of the map on show. */
  values(): ReadonlyMap<string, string>;
  /** It changes some of them. */
  changed(values: readonly (readonly [key: string, value: string])[]): void;
  /** A picture cannot be a land, as a sentence says. */
  refused(message: string): void;
  failed(error: unknown): void;
}

export class OwnLand {
  readonly #drawing: Drawing;

  constructor(
    engine: Outliner,
    private readonly events: OwnLandEvents,
  ) {
    this.#drawing = new Drawing(elements.drawing, engine, {
      drawn: (outline) => events.changed(drawn(outline)),
      failed: (error) => events.failed(error),
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

  /** A drawn land was chosen: whoever has drawn none has to draw one. */
  ask(): void {
    if (this.events.values().get("outline") === "") this.#drawing.open();
  }

  /** A land that was drawn before is there again when the tool is opened. */
  #showDrawn(): void {
    const values = this.events.values();
    const outline = values.get("outline") ?? "";
    if (outline !== "" && values.get("land") !== "drawn") this.events.changed(drawn(outline));
  }

  /** Turns a picture of a land into the land. */
  async #trace(file: Blob): Promise<void> {
    try {
      const tracing = await loadTracing();
      const { rgba, width, height } = await pixelsOf(file, tracing.longestTracedSide());
      const traced = tracing.traceImage(rgba, width, height);
      this.#drawing.take(traced);
      this.events.changed([["aspect", traced.aspect.toFixed(2)]]);
    } catch (thrown) {
      const error = named(thrown);
      if (isRecoverable(error)) this.events.refused(error.message);
      else this.events.failed(error);
    }
  }
}

/** The values of a drawn land. */
function drawn(outline: string): [key: string, value: string][] {
  return [
    ["land", "drawn"],
    ["outline", outline],
  ];
}
