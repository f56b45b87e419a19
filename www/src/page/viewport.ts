/**
 * The viewport: the picture's place on the page, which has the river's shape and follows the window. The river itself is in the
 * renderer: commands go there, and reports of it come back.
 */

import { backingSize, type CanvasSize, observeSize, RESIZE_PAUSE_MS } from "../browser/canvas.ts";
import { isRecoverable, named, PageError } from "../engine/errors.ts";
import type { Phase, Summary } from "../engine/types.ts";
import type { Format } from "../player/format-names.ts";
import type { State } from "../player/frame-loop.ts";
import type { ShowMode } from "../player/river-player.ts";
import type { Report } from "../renderer/protocol.ts";
import type { PageRenderHost } from "./backend.ts";
import type { About, Answer, Answers, Question, QuestionAbout } from "./protocol.ts";

export interface ViewportElements {
  /** Holds the picture and what stands under it; takes on the river's shape. */
  sheet: HTMLElement;
  /** Has the river's shape. */
  frame: HTMLElement;
  /** Another one, after the renderer had to be replaced: a canvas that is handed over does not come back. */
  canvas: HTMLCanvasElement;
}

export interface ViewportEvents {
  /** Something on the viewport changed: the state, or in it the river. It is of the link that was shown last. */
  changed(state: State, phase: Phase, summary: Summary): void;
  failed(error: PageError): void;
}

/** How another renderer takes a river over that was in a state, or was to be: not at the same step, but to the same end. */
const HOW: Record<State, ShowMode> = { growing: "watch", paused: "watch", settling: "settle", finished: "still" };

type SceneReport = Exclude<Report<Answer>, { is: "answer" }>;

export class RiverViewport {
  /** Its number at the render host, while it has a river there. */
  #id: number | undefined;
  /** What is to be shown, and of the river that is: its link and how it stands. */
  #wanted: { link: string; how: ShowMode };
  #link = "";
  #state: State = "paused";
  #speed = 1;
  /** What was asked for, until there is word of it: it may be asked before there is a river, or of a worker that no longer answers. */
  #asked: State | undefined;
  #events: ViewportEvents | undefined;
  /** What there was to be told before anybody listened. */
  readonly #untold: ((events: ViewportEvents) => void)[] = [];
  /** How many links were shown since the renderer has the canvas, and which of them is to be heard of. */
  #links = 0;
  #heard = 0;
  /** The canvas that is not seen before there is something on it. */
  #next: HTMLCanvasElement | undefined;
  #isOver = false;
  #resizing: ReturnType<typeof setTimeout> | undefined;
  readonly #observer = new ResizeObserver(() => this.#resizeSoon());
  readonly #client = { hear: (report: Report<Answer>) => this.#hear(report), moved: () => this.#move() };

  constructor(
    private readonly renderHost: PageRenderHost,
    private readonly elements: ViewportElements,
    /** The first link. */
    link: string,
    /** The aspect of links that say none. */
    private readonly ordinaryAspect: string,
  ) {
    this.#wanted = { link, how: "watch" };
    observeSize(this.#observer, elements.frame);
    document.addEventListener("visibilitychange", () => this.#rest());
  }

  /** Tells somebody how it goes from now on, and how it went until now. */
  listen(events: ViewportEvents): void {
    this.#events = events;
    for (const tell of this.#untold.splice(0)) tell(events);
  }

  /** The link of the river that is on the viewport; empty while there is none. */
  get link(): string {
    return this.#link;
  }

  get state(): State {
    return this.#state;
  }

  set speed(speed: number) {
    this.#speed = speed;
    this.#send({ do: "speed", speed });
  }

  toggle(): void {
    const state = this.#asked ?? this.#state;
    this.#asked = state === "growing" || state === "settling" ? "paused" : "growing";
    this.#send({ do: "toggle" });
  }

  replay(): void {
    this.#asked = "growing";
    this.#send({ do: "replay" });
  }

  /** Shows the first river. */
  start(how: ShowMode): void {
    this.#wanted.how = how;
    void this.#enter();
  }

  show(link: string, how: ShowMode): void {
    this.#wanted = { link, how };
    this.#asked = undefined;
    if (this.#id === undefined) return;
    this.#heard = ++this.#links;
    this.elements.frame.dataset["pending"] = "";
    this.#send({ do: "show", link: { text: link }, how, size: this.#sizeFor(link) });
  }

  /** A link's finished rivers as a file, made from the river on show as far as that has come. */
  file(link: string, format: Format): Promise<Blob> {
    return this.#ask({ about: "file", of: this.#id, link, format });
  }

  /** The greatest names on the map, three texts each; none while it is not finished, or not the one that was shown last. */
  async names(count: number): Promise<readonly string[]> {
    const names = await this.#ask({ about: "names", of: this.#id, count });
    return names?.link === this.#wanted.link ? names.texts : [];
  }

  /** The parameter `names`, as it is now, with another name for something, or its usual one. */
  async renamed(now: () => string, mark: string, name: string | undefined): Promise<string> {
    const names = now();
    const renamed = await this.#ask({ about: "renamed", names, mark, name });
    // Something else may have been given a name meanwhile.
    return names === now() ? renamed : this.renamed(now, mark, name);
  }

  /** After a failure that leaves the engine in an unknown state, nothing of it is called again. */
  close(): void {
    this.#isOver = true;
    if (this.#id !== undefined) this.renderHost.leave(this.#id);
    this.#id = undefined;
    this.#observer.disconnect();
    clearTimeout(this.#resizing);
  }

  // ---- what it says

  #send(command: Parameters<PageRenderHost["send"]>[1]): void {
    if (this.#id !== undefined) this.renderHost.send(this.#id, command);
  }

  async #ask<Key extends About>(question: QuestionAbout<Key>): Promise<Answers[Key]> {
    // An answer is of the kind of its question.
    return (await this.renderHost.ask(question as Question)) as Answers[Key];
  }

  async #enter(): Promise<void> {
    try {
      const id = await this.renderHost.enter(this.#client);
      if (this.#isOver) this.renderHost.leave(id);
      else this.#open(id);
    } catch (thrown) {
      if (!this.#isOver) this.#tell((events) => events.failed(named(thrown)));
    }
  }

  #open(id: number): void {
    const { link, how } = this.#wanted;
    const state = this.#asked ?? (this.#link === link ? this.#state : undefined);
    const canvas = this.#next ?? this.elements.canvas;
    this.#id = id;
    this.#links = this.#heard = 0;
    this.#send({ do: "open", canvas, link: { text: link }, how: state ? HOW[state] : how, size: this.#sizeFor(link) });
    this.#send({ do: "speed", speed: this.#speed });
    if (state === "paused") this.#send({ do: "pause" });
    if (document.hidden) this.#rest();
  }

  /** The renderer answers no more, and there is a new one: there it goes on with the same river. The old picture stays until then. */
  #move(): void {
    this.#id = undefined;
    if (this.#isOver) return;
    this.#next = this.elements.canvas.cloneNode() as HTMLCanvasElement;
    void this.#enter();
  }

  // ---- what it hears

  #hear(report: Report<Answer>): void {
    if (report.is === "shown") this.#show(report);
    if (report.is === "failed") this.#fail(report);
  }

  #show({ reading, state, phase, summary }: Extract<SceneReport, { is: "shown" }>): void {
    this.#reveal();
    this.#link = reading.link;
    this.#state = state;
    this.#asked = undefined;
    // Of a river that another is to follow nothing is said any more.
    if (reading.links < this.#heard) return;
    delete this.elements.frame.dataset["pending"];
    this.#tell((events) => events.changed(state, phase, summary));
  }

  #fail({ code, message, links = 0 }: Extract<SceneReport, { is: "failed" }>): void {
    const error = new PageError(code, message);
    if (isRecoverable(error) && code !== "no-chart") {
      // Another link is on its way, which may do; but without a first river nothing follows.
      if (links < this.#links && this.#link !== "") return;
      // The river that was there stays, in its own shape.
      this.#heard = 0;
      this.#wanted.link = this.#link;
      this.#resize();
      delete this.elements.frame.dataset["pending"];
    }
    this.#tell((events) => events.failed(error));
  }

  #tell(what: (events: ViewportEvents) => void): void {
    if (this.#events) what(this.#events);
    else this.#untold.push(what);
  }

  #reveal(): void {
    const next = this.#next;
    if (!next) return;
    this.#next = undefined;
    this.elements.canvas.replaceWith(next);
    this.elements.canvas = next;
  }

  // ---- its place

  /** Makes the frame a link's shape, and the picture the frame's size. */
  #sizeFor(link: string): CanvasSize {
    const aspect = new URLSearchParams(link).get("aspect") ?? this.ordinaryAspect;
    this.elements.sheet.style.setProperty("--aspect", aspect);
    const box = this.elements.frame.getBoundingClientRect();
    const size = backingSize(box, window.devicePixelRatio);
    return { ...size, ratio: box.width > 0 ? size.width / box.width : 1 };
  }

  #resizeSoon(): void {
    clearTimeout(this.#resizing);
    this.#resizing = setTimeout(() => this.#resize(), RESIZE_PAUSE_MS);
  }

  #resize(): void {
    this.#send({ do: "resize", size: this.#sizeFor(this.#wanted.link) });
  }

  #rest(): void {
    this.#send({ do: document.hidden ? "rest" : "wake" });
  }
}
