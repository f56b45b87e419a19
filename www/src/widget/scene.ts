/** One widget's river on its canvas, wherever that is drawn. */

import type { CanvasSize } from "../browser/canvas.ts";
import { isRecoverable, named } from "../engine/errors.ts";
import type { Core } from "../engine/wasm.ts";
import type { LoadCharts } from "../player/chart-maker.ts";
import type { Frames } from "../player/frame-loop.ts";
import { type LinkToRead, RiverPlayer } from "../player/river-player.ts";
import type { Command, Reading, Report, RiverRequest } from "./protocol.ts";

type Opening = Extract<Command, { do: "open" }>;

export class Scene {
  #size: CanvasSize;
  #player: RiverPlayer | undefined;
  /** Of the river on the canvas. */
  #reading: Reading | undefined;
  /** What came before the river was planted. */
  #early: Command[] = [];
  #isOver = false;

  constructor(
    private readonly core: Core,
    private readonly loadCharts: LoadCharts,
    private readonly frames: Frames,
    private readonly opening: Opening,
    private readonly tell: (report: Report) => void,
  ) {
    this.#size = opening.size;
    // In its turn: planting twenty rivers at once would hold up the page.
    frames.request(() => this.#attempt(() => this.#open()));
  }

  take(command: Command): void {
    const player = this.#player;
    if (command.do === "close") this.#close();
    else if (player) this.#attempt(() => this.#follow(command, player));
    else this.#early.push(command);
  }

  #open(): void {
    if (this.#isOver) return;
    const { canvas, request, how } = this.opening;
    const planter = { ...this.core, loadCharts: this.loadCharts };
    const player = new RiverPlayer(planter, canvas, linkToRead(request), this.frames, {
      sizeFor: () => this.#size,
      planted: ({ link, seed, aspect, notices }) => {
        this.#reading = { link, seed, aspect, notices };
      },
      changed: (state, phase, summary) => {
        if (this.#reading)
          this.tell({ id: this.opening.id, is: "shown", reading: this.#reading, state, phase, summary });
      },
      failed: (thrown) => this.#fail(thrown),
    });
    this.#player = player;
    player.start(how);
    for (const command of this.#early) this.#follow(command, player);
    this.#early = [];
  }

  #follow(command: Command, player: RiverPlayer): void {
    switch (command.do) {
      case "show":
        this.#size = command.size;
        player.show(linkToRead(command.request), command.how);
        break;
      case "resize":
        this.#size = command.size;
        player.resize();
        break;
      case "play":
      case "pause":
      case "replay":
      case "finish":
      case "rest":
      case "wake":
        player[command.do]();
    }
  }

  #attempt(work: () => void): void {
    try {
      work();
    } catch (thrown) {
      this.#fail(thrown);
    }
  }

  #fail(thrown: unknown): void {
    const error = named(thrown);
    // After a trap nothing more is asked of the river, not even to go.
    if (!isRecoverable(error)) this.#player?.close();
    this.tell({ id: this.opening.id, is: "failed", code: error.code, message: error.message });
  }

  #close(): void {
    this.#isOver = true;
    this.#player?.free();
  }
}

/** What a widget asks for, as the core is to read it. */
export function linkToRead({ text, isDark }: RiverRequest): LinkToRead {
  return { text, options: { widget: true, dark: isDark } };
}
