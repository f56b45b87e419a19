/** Where the rivers of all widgets are grown and drawn, each on its canvas: in a worker, or on the page itself. */

import { named } from "../engine/errors.ts";
import { read, type Wish } from "../engine/reading.ts";
import type { Core } from "../engine/wasm.ts";
import { pngOf, svgOf } from "../player/files.ts";
import { displayFrames, Turns } from "../player/frames.ts";
import type { FileOrder, News, Order } from "./orders.ts";
import { Scene } from "./scene.ts";

/** The tools' wasm module, as the package has it. */
const TOOLS = "riverseed_tools_bg.wasm";

export class Renderer {
  readonly #scenes = new Map<number, Scene>();
  readonly #turns = new Turns(displayFrames);
  #filesInTheMaking = 0;

  constructor(
    private readonly core: Core,
    private readonly tell: (news: News) => void,
    /** A picture for a file is about to be painted, in one step. */
    private readonly painting: () => void = () => {},
  ) {}

  /** Whether there will be news without another order. */
  get isAtWork(): boolean {
    return this.#turns.areAwaited || this.#filesInTheMaking > 0;
  }

  take(order: Order): void {
    const { id } = order;
    if (order.do === "file") void this.#file(id, order.wish, order);
    else if (order.do === "open") this.#scenes.set(id, new Scene(this.core, this.#turns, order, this.tell));
    else this.#scenes.get(id)?.take(order);
    if (order.do === "close") this.#scenes.delete(id);
  }

  async #file(id: number, wish: Wish, { format, longSide, wasmUrl }: FileOrder): Promise<void> {
    this.#filesInTheMaking++;
    try {
      const { link } = read(this.core.engine, wish);
      const blob = await (format === "svg"
        ? svgOf(link, wasmUrl && new URL(TOOLS, wasmUrl).href)
        : pngOf(this.core, link, longSide, this.painting));
      this.tell({ id, is: "file", blob });
    } catch (thrown) {
      const { code, message } = named(thrown);
      this.tell({ id, is: "failed", code, message });
    } finally {
      this.#filesInTheMaking--;
    }
  }
}
