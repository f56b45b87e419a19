/** Grows and draws rivers, each on its canvas, and answers questions about them: in a worker, or on the page itself. */

import { named } from "../engine/errors.ts";
import type { River } from "../engine/types.ts";
import type { RiverPlayer } from "../player/river-player.ts";
import { displayFrames, SharedScheduler } from "../player/scheduler.ts";
import type { SharedClock } from "../player/shared-clock.ts";
import type { Command, Opening, Report } from "./protocol.ts";
import { type Makers, Scene } from "./scene.ts";

/** A renderer's means of making rivers and of answering questions about them. */
export interface Means<R extends River, Question, Answer> extends Makers<R> {
  /** The time of a frame that all rivers share, if not the usual. If it is given, a new river opens at once. */
  readonly shareMs?: number;
  /** The clock of rivers that grow in step. */
  readonly clock?: SharedClock;
  answer(question: Question, playerOf: (id: number) => RiverPlayer<R> | undefined): Promise<Answer>;
}

export class Renderer<R extends River, Question, Answer> {
  readonly #scenes = new Map<number, Scene<R>>();
  readonly #scheduler: SharedScheduler;
  #unanswered = 0;

  /** `workMs` is the time of a frame for work that somebody waits for, if not the usual. */
  constructor(
    private readonly means: Means<R, Question, Answer>,
    private readonly tell: (report: Report<Answer>) => void,
    workMs?: number,
  ) {
    this.#scheduler = new SharedScheduler(displayFrames, means.shareMs ?? workMs, workMs);
  }

  /** True while a report is due without another command. */
  get isAtWork(): boolean {
    return this.#scheduler.isAwaited || this.#unanswered > 0;
  }

  take(command: Command<Question>): void {
    const { id } = command;
    if (command.do === "ask") void this.#answer(id, command.question);
    else if (command.do === "open") this.#open(command);
    else this.#scenes.get(id)?.take(command);
    if (command.do === "close") this.#scenes.delete(id);
  }

  #open(command: Opening): void {
    const { means } = this;
    const { shareMs, clock } = means;
    const scene = new Scene(means, this.#scheduler, command, this.tell, command.inStep ? clock : undefined);
    this.#scenes.set(command.id, scene);
    if (shareMs) scene.open();
    // In turn, since planting twenty rivers at once would hold up the page.
    else this.#scheduler.request(() => scene.open());
  }

  async #answer(id: number, question: Question): Promise<void> {
    this.#unanswered++;
    try {
      const answer = await this.means.answer(question, (id) => this.#scenes.get(id)?.player);
      this.tell({ id, is: "answer", answer });
    } catch (thrown) {
      const { code, message } = named(thrown);
      this.tell({ id, is: "failed", code, message });
    } finally {
      this.#unanswered--;
    }
  }
}
