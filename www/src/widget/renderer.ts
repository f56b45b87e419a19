/** Where the rivers of all widgets are grown and drawn, each on its canvas: in a worker, or on the page itself. */

import { named } from "../engine/errors.ts";
import type { Core } from "../engine/wasm.ts";
import type { LoadCharts } from "../player/chart-maker.ts";
import { pngOf, svgOf } from "../player/files.ts";
import type { LinkToRead } from "../player/river-player.ts";
import { displayFrames, SharedScheduler } from "../player/scheduler.ts";
import { loadCharts, loadFull } from "./late.ts";
import type { Command, FileRequest, Report, RiverRequest } from "./protocol.ts";
import { linkToRead, Scene } from "./scene.ts";

export class Renderer {
  readonly #scenes = new Map<number, Scene>();
  readonly #scheduler = new SharedScheduler(displayFrames);
  readonly #loadCharts: LoadCharts;
  #filesInTheMaking = 0;

  constructor(
    private readonly core: Core,
    /** Where the engine is, if not beside the script. */
    wasmUrl: string | undefined,
    private readonly tell: (report: Report) => void,
    /** A picture for a file is about to be painted, in one step. */
    private readonly painting: () => void = () => {},
  ) {
    this.#loadCharts = () => loadCharts(wasmUrl);
  }

  /** Whether there will be a report without another command. */
  get isAtWork(): boolean {
    return this.#scheduler.isAwaited || this.#filesInTheMaking > 0;
  }

  take(command: Command): void {
    const { id } = command;
    if (command.do === "file") void this.#file(id, command.request, command);
    else if (command.do === "open")
      this.#scenes.set(id, new Scene(this.core, this.#loadCharts, this.#scheduler, command, this.tell));
    else this.#scenes.get(id)?.take(command);
    if (command.do === "close") this.#scenes.delete(id);
  }

  async #file(id: number, request: RiverRequest, { format, longSide, wasmUrl }: FileRequest): Promise<void> {
    this.#filesInTheMaking++;
    try {
      const link = linkToRead(request);
      const blob = await (format === "svg" ? svgOfLink(link, wasmUrl, this.#loadCharts) : this.#png(link, longSide));
      this.tell({ id, is: "file", blob });
    } catch (thrown) {
      const { code, message } = named(thrown);
      this.tell({ id, is: "failed", code, message });
    } finally {
      this.#filesInTheMaking--;
    }
  }

  #png({ text, options }: LinkToRead, longSide: number): Promise<Blob> {
    const { engine, memory } = this.core;
    return pngOf(new engine.River(text, options), { memory, loadCharts: this.#loadCharts }, longSide, this.painting);
  }
}

/** The lean engine writes no files. */
async function svgOfLink(
  { text, options }: LinkToRead,
  wasmUrl: string | undefined,
  loadCharts: LoadCharts,
): Promise<Blob> {
  const { engine } = await loadFull(wasmUrl);
  return svgOf(new engine.River(text, options), loadCharts);
}
