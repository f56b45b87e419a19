/** One river on its canvas, wherever that is drawn. */

import type { CanvasSize } from "../browser/canvas.ts";
import { isRecoverable, named } from "../engine/errors.ts";
import type { River } from "../engine/types.ts";
import { isEngineUnsure } from "../engine/unsure.ts";
import type { Frames } from "../player/frame-loop.ts";
import { type PlayerEvents, type RiverMaker, RiverPlayer } from "../player/river-player.ts";
import type { SharedClock } from "../player/shared-clock.ts";
import type { Opening, Reading, Report, SceneCommand } from "./protocol.ts";

/** What is asked of a river while there is one. */
type Request = Exclude<SceneCommand, { do: "close" }>;

export class Scene<R extends River = River> {
  #size: CanvasSize;
  #player: RiverPlayer<R> | undefined;
  /** Of the river on the canvas. */
  #reading: Reading | undefined;
  /** How many links it has been asked to show after the first. */
  #links = 0;
  /** What came before the river was created. */
  #early: Request[] = [];
  #isOver = false;
  /** Whether the river can be asked to go. */
  #mayFree = true;

  constructor(
    private readonly maker: RiverMaker<R>,
    private readonly frames: Frames,
    private readonly opening: Opening,
    private readonly tell: (report: Report<never>) => void,
    /** What it grows by if others grow by it, too. */
    private readonly clock?: SharedClock,
  ) {
    this.#size = opening.size;
  }

  /** Plants the river and shows it. */
  open(): void {
    this.#attempt(() => this.#open());
  }

  /** What shows its river; nothing before the river is created. */
  get player(): RiverPlayer<R> | undefined {
    return this.#player;
  }

  take(command: SceneCommand): void {
    const player = this.#player;
    if (command.do === "close") this.#close();
    else if (player) this.#attempt(() => this.#follow(command, player));
    else this.#early.push(command);
  }

  #open(): void {
    if (this.#isOver) return;
    const { id, canvas, link, how } = this.opening;
    const events: PlayerEvents = {
      sizeFor: () => this.#size,
      created: ({ link, seed, aspect, notices }) => {
        this.#reading = { link, seed, aspect, notices, links: this.#links };
      },
      changed: (state, phase, summary) => {
        const reading = this.#reading;
        if (reading) this.tell({ id, is: "shown", reading, state, phase, summary });
      },
      failed: (thrown) => this.#fail(thrown),
    };
    const player = new RiverPlayer(this.maker, canvas, link, this.frames, events, this.clock);
    this.#player = player;
    player.start(how);
    for (const command of this.#early) this.#follow(command, player);
    this.#early = [];
  }

  #follow(command: Request, player: RiverPlayer<R>): void {
    switch (command.do) {
      case "show":
        this.#links++;
        this.#size = command.size;
        player.show(command.link, command.how);
        break;
      case "resize":
        this.#size = command.size;
        player.resize();
        break;
      case "speed":
        player.speed = command.speed;
        break;
      default:
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
    this.#mayFree &&= !isEngineUnsure(error);
    if (!isRecoverable(error)) this.#player?.close();
    this.tell({ id: this.opening.id, is: "failed", code: error.code, message: error.message, links: this.#links });
  }

  #close(): void {
    this.#isOver = true;
    if (this.#mayFree) this.#player?.free();
    this.#player = undefined;
  }
}
