/**
 * One renderer for all rivers of a page: opened for the first river, replaced when its engine stops or no longer
 * answers, and closed after the last.
 */

import { PageError } from "../engine/page-error.ts";
import type { Backend, Command, Report } from "./protocol.ts";
import type { Listener } from "./worker-backend.ts";

/** A client of the render host: it shows a river, or asks a question. */
export interface Client<Answer = unknown> {
  hear(report: Report<Answer>): void;
  /** Called when the renderer was replaced: everything has to be handed over again. */
  moved(): void;
}

/** An empty renderer is kept for this time, since pages often remove one river and then add another. */
export const EMPTY_MS = 5000;

type Asked<Every> = Every extends unknown ? Omit<Every, "id"> : never;

export class RenderHost<Question, Answer, First extends readonly unknown[] = []> {
  readonly #clients = new Map<number, Client<Answer>>();
  #backend: Promise<Backend<Question>> | undefined;
  #last = 0;
  #leaving: ReturnType<typeof setTimeout> | undefined;

  /** `open` opens a renderer, in a worker or on the page. `first` is what its first client says of the engine. */
  constructor(private readonly open: (listener: Listener<Answer>, ...first: First) => Promise<Backend<Question>>) {}

  /** Adds a client once there is a renderer, and returns the client's number. */
  async enter(client: Client<Answer>, ...first: First): Promise<number> {
    clearTimeout(this.#leaving);
    const backend = this.#opened(first);
    await backend;
    // It may have been replaced by now.
    if (backend !== this.#backend) return this.enter(client, ...first);
    this.#clients.set(++this.#last, client);
    return this.#last;
  }

  send(id: number, command: Asked<Command<Question>>): void {
    void this.#backend?.then((backend) => backend.take({ ...command, id }));
  }

  /** Asks the renderer a question. If the renderer is lost before it answers, the next one is asked. */
  ask(question: Question, ...first: First): Promise<Answer> {
    return new Promise((done, failed) => {
      let asked = 0;
      const ask = (): void => {
        // The question itself may have killed both workers, and the rivers need the third.
        if (++asked > 2) failed(new PageError("wasm-timeout", "the worker stopped twice at this"));
        else void this.enter(client, ...first).then((id) => this.send(id, { do: "ask", question }), failed);
      };
      const client: Client<Answer> = {
        hear: (report) => {
          this.leave(report.id);
          if (report.is === "answer") done(report.answer);
          if (report.is === "failed") failed(new PageError(report.code, report.message));
        },
        moved: ask,
      };
      ask();
    });
  }

  leave(id: number): void {
    if (!this.#clients.delete(id)) return;
    this.send(id, { do: "close" });
    if (this.#clients.size === 0) this.#leaving = setTimeout(() => this.#close(), EMPTY_MS);
  }

  #opened(first: First): Promise<Backend<Question>> {
    if (this.#backend) return this.#backend;
    const backend = this.open(
      {
        tell: (report) => this.#tell(report),
        collapsed: (message) => this.#collapse(message),
        lost: () => this.#moveAll(),
      },
      ...first,
    );
    this.#backend = backend;
    // A failed load can be tried again.
    backend.catch(() => {
      if (this.#backend === backend) this.#backend = undefined;
    });
    return backend;
  }

  #tell(report: Report<Answer>): void {
    const client = this.#clients.get(report.id);
    const isEnd = report.is === "failed" && report.code === "panic";
    if (isEnd) this.#clients.delete(report.id);
    client?.hear(report);
    if (isEnd) void this.#replace();
  }

  /**
   * Moves the other clients to a new engine after a trap, since the state of the old one is unknown. On the page itself
   * there is only one engine: there they go on in it, since a trap touches no memory but its own river's.
   */
  async #replace(): Promise<void> {
    const backend = this.#backend;
    if ((await backend)?.isReplaceable && backend === this.#backend) this.#moveAll();
  }

  /** Moves all clients to another backend. */
  #moveAll(): void {
    this.#close();
    const clients = [...this.#clients.values()];
    this.#clients.clear();
    for (const client of clients) client.moved();
  }

  /** Reports a failure to all clients: nobody knows which of them caused it, so none may try again. */
  #collapse(message: string): void {
    for (const id of [...this.#clients.keys()]) this.#tell({ id, is: "failed", code: "panic", message });
  }

  #close(): void {
    void this.#backend?.then((backend) => backend.close());
    this.#backend = undefined;
  }
}
