/** The viewport's line to the renderer: commands and questions go there, and reports come back. It may move to another renderer. */

import { named, type PageError } from "../../../engine/errors.ts";
import type { Report } from "../../../host/protocol.ts";
import type { About, Answer, Answers, Question, QuestionAbout } from "../../page-worker/protocol.ts";
import type { PageRenderHost } from "../backend.ts";

export interface LineEvents {
  /** Called when there is a renderer, which has no river yet. */
  opened(): void;
  hear(report: Report<Answer>): void;
  /** Called when the renderer no longer answers, before another is entered. */
  moved(): void;
  failed(error: PageError): void;
}

export class Line {
  /** Its client number at the render host, while it has a river there. */
  #id: number | undefined;
  #isOver = false;
  readonly #client = { hear: (report: Report<Answer>) => this.events.hear(report), moved: () => this.#move() };

  constructor(
    private readonly host: PageRenderHost,
    private readonly events: LineEvents,
  ) {}

  get id(): number | undefined {
    return this.#id;
  }

  /** True once it was closed, for good. */
  get isOver(): boolean {
    return this.#isOver;
  }

  /** Enters a renderer, and waits for it. */
  async enter(): Promise<void> {
    try {
      const id = await this.host.enter(this.#client);
      if (this.#isOver) {
        this.host.leave(id);
        return;
      }
      this.#id = id;
      this.events.opened();
    } catch (thrown) {
      if (!this.#isOver) this.events.failed(named(thrown));
    }
  }

  /** Sends a command to the river, if there is one. */
  send(command: Parameters<PageRenderHost["send"]>[1]): void {
    if (this.#id !== undefined) this.host.send(this.#id, command);
  }

  async ask<Key extends About>(question: QuestionAbout<Key>): Promise<Answers[Key]> {
    // An answer has the type that belongs to its question.
    return (await this.host.ask(question as Question)) as Answers[Key];
  }

  close(): void {
    this.#isOver = true;
    if (this.#id !== undefined) this.host.leave(this.#id);
    this.#id = undefined;
  }

  #move(): void {
    this.#id = undefined;
    if (this.#isOver) return;
    this.events.moved();
    void this.enter();
  }
}
