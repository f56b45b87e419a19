/** One river on its canvas, in a worker or on the page. */

import type { CanvasSize } from "../browser/canvas.ts";
import { isRecoverable, named } from "../engine/errors.ts";
import type { River } from "../engine/types.ts";
import { isEngineUnsure } from "../engine/unsure.ts";
import type { Frames } from "../player/frame-loop.ts";
import { type PlayerEvents, type RiverMaker, RiverPlayer } from "../player/river-player.ts";
import type { SharedClock } from "../player/shared-clock.ts";
import type { Opening, Report, SceneCommand } from "./protocol.ts";

/** A command to an open river. */
type Request = Exclude<SceneCommand, { do: "close" }>;

export class Scene<R extends River = River> {
  #size: CanvasSize;
  #player: RiverPlayer<R> | undefined;
  /** Commands from before the river was created. */
  #early: Request[] = [];
  #isOver = false;
  /** False after a failure that leaves the engine in an unknown state: then the river may not even be freed. */
  #mayFree = true;

  constructor(
    private readonly maker: RiverMaker<R>,
    private readonly frames: Frames,
    private readonly opening: Opening,
    private readonly tell: (report: Report<never>) => void,
    /** The clock that it shares with other rivers, if any. */
    private readonly clock?: SharedClock,
  ) {
    this.#size = opening.size;
  }

  /** Plants the river and shows it. */
  open(): void {
    this.#attempt(() => this.#open());
  }

  /** The player of its river; none before the river is created. */
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
      changed: (reading, status) => this.tell({ id, is: "shown", reading, ...status }),
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
      case "seek":
        player.seek(command.share);
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
    this.tell({
      id: this.opening.id,
      is: "failed",
      code: error.code,
      message: error.message,
      links: this.#player?.links ?? 0,
    });
  }

  #close(): void {
    this.#isOver = true;
    if (this.#mayFree) this.#player?.free();
    this.#player = undefined;
  }
}
