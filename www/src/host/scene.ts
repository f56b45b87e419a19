/** One river on its canvas, in a worker or on the page. */

import type { CanvasSize } from "../browser/canvas.ts";
import { isRecoverable, named } from "../engine/errors.ts";
import type { River } from "../engine/types.ts";
import { isEngineUnsure } from "../engine/unsure.ts";
import type { Frames } from "../player/frame-loop.ts";
import {
  type LinkToRead,
  type PlayerEvents,
  type RiverMaker,
  RiverPlayer,
  type ShowMode,
} from "../player/river-player.ts";
import type { SharedClock } from "../player/shared-clock.ts";
import type { Opening, Report, SceneCommand } from "./protocol.ts";

/** A command to an open river. */
type Request = Exclude<SceneCommand, { do: "close" }>;

/** The engines that rivers are made by. */
export interface Makers<R extends River> {
  /**
   * Returns an engine for the river of a link: that of the river now on its canvas, if there is one and it will do. A
   * promise if it has to be loaded.
   */
  makerFor(link: LinkToRead, now?: RiverMaker<R>): Coming<R>;
}

/** An engine, or one that is being loaded. */
type Coming<R extends River> = RiverMaker<R> | Promise<RiverMaker<R>>;

export class Scene<R extends River = River> {
  #size: CanvasSize;
  #player: RiverPlayer<R> | undefined;
  #maker: RiverMaker<R> | undefined;
  /** The link that was asked for last. */
  #link: LinkToRead;
  /** The number of links that earlier players of other engines were asked to show. */
  #linksBefore = 0;
  /** Commands that wait until the river is created, or until another engine has been loaded for it. */
  #early: Request[] | undefined = [];
  #isOver = false;
  /** False after a failure that leaves the engine in an unknown state: then the river may not even be freed. */
  #mayFree = true;

  constructor(
    private readonly makers: Makers<R>,
    private readonly frames: Frames,
    private readonly opening: Opening,
    private readonly tell: (report: Report<never>) => void,
    /** The clock that it shares with other rivers, if any. */
    private readonly clock?: SharedClock,
  ) {
    this.#size = opening.size;
    this.#link = opening.link;
  }

  /** Plants the river and shows it. */
  open(): void {
    const { link, how } = this.opening;
    this.#attempt(() => void this.#plant(this.makers.makerFor(link), link, how));
  }

  /** The player of its river; none before the river is created. */
  get player(): RiverPlayer<R> | undefined {
    return this.#player;
  }

  take(command: SceneCommand): void {
    if (command.do === "close") this.#close();
    else if (this.#early) this.#early.push(command);
    else this.#attempt(() => this.#follow(command));
  }

  /**
   * Plants the river of a link, once there is an engine for it. Commands wait until then. `asked` is 0 if nobody has asked for
   * another link.
   */
  async #plant(maker: Coming<R>, link: LinkToRead, how: ShowMode, asked = 1): Promise<void> {
    try {
      this.#begin(maker instanceof Promise ? await maker : maker, link, how, asked);
    } catch (thrown) {
      if (this.#player) this.#linksBefore += asked;
      this.#fail(thrown);
    }
    if (this.#player) this.#takeEarly();
  }

  #begin(maker: RiverMaker<R>, link: LinkToRead, how: ShowMode, asked: number): void {
    if (this.#isOver) return;
    const { opening, clock } = this;
    const player = new RiverPlayer(maker, opening.canvas, link, this.frames, this.#events, clock);
    if (this.#player) this.#linksBefore += this.#player.links + asked;
    this.#freePlayer();
    [this.#player, this.#maker] = [player, maker];
    player.start(how);
  }

  #takeEarly(): void {
    const early = this.#early ?? [];
    this.#early = undefined;
    for (const command of early) this.take(command);
  }

  get #events(): PlayerEvents {
    return {
      sizeFor: () => this.#size,
      changed: (reading, status) => {
        const links = reading.links + this.#linksBefore;
        this.tell({ id: this.opening.id, is: "shown", reading: { ...reading, links }, ...status });
      },
      failed: (thrown) => this.#fail(thrown),
      unlettered: (how) => queueMicrotask(() => this.#attempt(() => this.#plantWithNames(how))),
    };
  }

  /**
   * Plants the same river in an engine that places letters and trees, since the letters that it carries are for other maps or pictures, or
   * its word has drawn a country with woods.
   */
  #plantWithNames(how: ShowMode): void {
    if (this.#isOver) return;
    this.#early = [];
    this.#link = { ...this.#link, letters: "", isAnnotated: true };
    void this.#plant(this.makers.makerFor(this.#link, this.#maker), this.#link, how, 0);
  }

  #follow(command: Request): void {
    const player = this.#player;
    if (!player) return;
    switch (command.do) {
      case "show":
        this.#size = command.size;
        this.#show(command, player);
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

  /** Shows another link, by another engine if the one that is there will not do. */
  #show({ link, how }: { link: LinkToRead; how: ShowMode }, player: RiverPlayer<R>): void {
    this.#link = link;
    const maker = this.makers.makerFor(link, this.#maker);
    if (maker === this.#maker) player.show(link, how);
    else {
      this.#early = [];
      void this.#plant(maker, link, how);
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
      links: this.#linksBefore + (this.#player?.links ?? 0),
    });
  }

  #close(): void {
    this.#isOver = true;
    this.#freePlayer();
  }

  #freePlayer(): void {
    if (this.#mayFree) this.#player?.free();
    this.#player = undefined;
  }
}
