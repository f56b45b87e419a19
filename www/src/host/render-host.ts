/**
 * One renderer for all rivers of a page: opened with the first of them, replaced when its engine stops or answers no more, left
 * with the last.
 */

import { PageError } from "../engine/errors.ts";
import type { Backend, Command, Report } from "./protocol.ts";
import type { Listener } from "./worker-backend.ts";

/** A client of the render host: it shows a river, or asks a question. */
export interface Client<Answer = unknown> {
  hear(report: Report<Answer>): void;
  /** The renderer had to be replaced: everything has to be handed over again. */
  moved(): void;
}

/** An empty renderer is kept so long: pages that show one thing after another take rivers away and bring others. */
export const EMPTY_MS = 5000;

type Asked<Every> = Every extends unknown ? Omit<Every, "id"> : never;

export class RenderHost<Question, Answer> {
  readonly #clients = new Map<number, Client<Answer>>();
  #backend: Promise<Backend<Question>> | undefined;
  #last = 0;
  #leaving: ReturnType<typeof setTimeout> | undefined;

  /** `open` opens a renderer, wherever; the address is that of the engine, if it is not beside the script. */
  constructor(
    private readonly open: (listener: Listener<Answer>, wasmUrl: string | undefined) => Promise<Backend<Question>>,
  ) {}

  /** Takes somebody in, once there is a renderer; their number. The address counts for the first. */
  async enter(client: Client<Answer>, wasmUrl?: string): Promise<number> {
    clearTimeout(this.#leaving);
    const backend = this.#opened(wasmUrl);
    await backend;
    // It may have been replaced by now.
    if (backend !== this.#backend) return this.enter(client, wasmUrl);
    this.#clients.set(++this.#last, client);
    return this.#last;
  }

  send(id: number, command: Asked<Command<Question>>): void {
    void this.#backend?.then((backend) => backend.take({ ...command, id }));
  }

  /** Has a question answered, which is put anew to another renderer if the first is gone before that. */
  ask(question: Question, wasmUrl?: string): Promise<Answer> {
    return new Promise((done, failed) => {
      let asked = 0;
      const ask = (): void => {
        // A file may be what a worker dies of: of a third there is no hope, and the rivers need theirs.
        if (++asked > 2) failed(new PageError("wasm-timeout", "the worker stopped twice at this"));
        else void this.enter(client, wasmUrl).then((id) => this.send(id, { do: "ask", question }), failed);
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

  #opened(wasmUrl: string | undefined): Promise<Backend<Question>> {
    if (this.#backend) return this.#backend;
    const backend = this.open(
      {
        tell: (report) => this.#tell(report),
        collapsed: (message) => this.#collapse(message),
        lost: () => this.#moveAll(),
      },
      wasmUrl,
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
   * After a trap nobody knows in what state the engine is, so the others get a new one. On the page itself there is only the
   * one that its script holds: there they go on in it, since a trap touches no memory but its own river's.
   */
  async #replace(): Promise<void> {
    const backend = this.#backend;
    if ((await backend)?.isReplaceable && backend === this.#backend) this.#moveAll();
  }

  /** Everybody goes to another backend. */
  #moveAll(): void {
    this.#close();
    const clients = [...this.#clients.values()];
    this.#clients.clear();
    for (const client of clients) client.moved();
  }

  /** Nobody knows whose fault it was: asked to go on, all might do the same again. */
  #collapse(message: string): void {
    for (const id of [...this.#clients.keys()]) this.#tell({ id, is: "failed", code: "panic", message });
  }

  #close(): void {
    void this.#backend?.then((backend) => backend.close());
    this.#backend = undefined;
  }
}
