/** One of several rivers that grow side by side: a button that chooses it, with its canvas and its size in words. */

import { backingSize, type CanvasSize, observeSize } from "../../../browser/canvas.ts";
import { count } from "../../../browser/count.ts";
import { el, setText, svg } from "../../../browser/dom.ts";
import type { Phase, Summary } from "../../../engine/types.ts";
import type { Report } from "../../../host/protocol.ts";
import type { State } from "../../../player/frame-loop.ts";
import type { ShowMode } from "../../../player/river-player.ts";
import type { Answer, Overlay } from "../../page-worker/protocol.ts";
import type { PageRenderHost } from "../backend.ts";

/** The map of a variant, and the texts about it. */
export interface VariantOf {
  link: string;
  label: string;
  help: string;
  /** True if the map behind has the same values. */
  isCurrent: boolean;
}

export interface VariantEvents {
  chosen(): void;
  changed(): void;
}

/** The speed, slower than that of a single map, since there are six to look at. */
const SPEED = 0.5;

export class Variant {
  readonly element: HTMLButtonElement;
  readonly #words = el("span", { class: "variant-size" });
  /** Lies over the canvas, with what trimming has cut. */
  readonly #cut = svg("svg", { class: "variant-cut", preserveAspectRatio: "none", "aria-hidden": "true" });
  readonly #client = { hear: (report: Report<Answer>) => this.#hear(report), moved: () => void this.#move() };
  readonly #observer = new ResizeObserver(() => this.#send({ do: "resize", size: this.#size }));
  #canvas = newCanvas();
  #id: number | undefined;
  #isOver = false;
  /** The state; undefined before there is a picture, and after a failure. */
  #state: State | undefined;
  #ticks = 0;

  constructor(
    private readonly renderHost: PageRenderHost,
    private readonly of: VariantOf,
    private readonly events: VariantEvents,
  ) {
    const words = el("span", { class: "variant-words" }, el("b", {}, of.label), this.#words);
    const help = el("span", { class: "help" }, of.help);
    const attributes = { type: "button", class: "variant", ...(of.isCurrent ? { "aria-current": "true" } : {}) };
    const picture = el("span", { class: "variant-picture" }, this.#canvas, this.#cut);
    this.element = el("button", attributes, picture, words, help);
    this.element.addEventListener("click", () => events.chosen());
  }

  get state(): State | undefined {
    return this.#state;
  }

  /** The number of ticks it has grown. */
  get ticks(): number {
    return this.#ticks;
  }

  /** Begins to grow. Its element must be on the page. */
  async open(how: ShowMode): Promise<void> {
    try {
      const id = await this.renderHost.enter(this.#client);
      if (this.#isOver) {
        this.renderHost.leave(id);
        return;
      }
      this.#id = id;
      const link = { text: this.of.link };
      this.#send({ do: "open", canvas: this.#canvas, link, how, size: this.#size, inStep: true });
      this.#send({ do: "speed", speed: SPEED });
      observeSize(this.#observer, this.#canvas);
    } catch (thrown) {
      this.#fail(String(thrown));
    }
  }

  /** Continues if it is paused. */
  play(): void {
    if (this.#state === "paused") this.#send({ do: "play" });
  }

  pause(): void {
    this.#send({ do: "pause" });
  }

  replay(): void {
    this.#send({ do: "replay" });
  }

  close(): void {
    this.#isOver = true;
    this.#observer.disconnect();
    if (this.#id !== undefined) this.renderHost.leave(this.#id);
    this.#id = undefined;
  }

  #send(command: Parameters<PageRenderHost["send"]>[1]): void {
    if (this.#id !== undefined) this.renderHost.send(this.#id, command);
  }

  get #size(): CanvasSize {
    const box = this.#canvas.getBoundingClientRect();
    const size = backingSize(box, window.devicePixelRatio);
    return { ...size, ratio: size.width > 0 ? size.width / box.width : 1 };
  }

  /** Moves to another renderer, with a new canvas: the one that was handed over does not come back. */
  async #move(): Promise<void> {
    this.#id = undefined;
    if (this.#isOver) return;
    this.#observer.disconnect();
    const canvas = newCanvas();
    this.#canvas.replaceWith(canvas);
    this.#canvas = canvas;
    await this.open("settle");
  }

  #hear(report: Report<Answer>): void {
    if (report.is === "failed") this.#fail(report.message);
    if (report.is === "shown") this.#show(report.state, report.phase, report.summary);
  }

  #show(state: State, phase: Phase, summary: Summary): void {
    this.#state = state;
    this.#ticks = summary.ticks;
    this.element.dataset["state"] = state;
    this.element.dataset["ticks"] = String(summary.ticks);
    const { sources, order } = summary;
    // Numbers from different ticks could not be compared, so there are none while it grows.
    setText(this.#words, phase === "growing" ? "growing" : `${count(sources)} sources, order ${order}`);
    if (state === "finished") void this.#showCut();
    else this.#cut.replaceChildren();
    this.events.changed();
  }

  async #showCut(): Promise<void> {
    // Without it the map is complete, too.
    const asked = this.renderHost.ask({ about: "overlay", of: this.#id, name: "cut" }).catch(() => undefined);
    const overlay = (await asked) as Overlay | undefined;
    if (!overlay || this.#isOver || this.#state !== "finished") return;
    const [width, height] = overlay.size;
    this.#cut.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.#cut.replaceChildren(...overlay.kinds.flat().map((d) => svg("path", { d })));
  }

  #fail(message: string): void {
    this.#state = undefined;
    this.element.dataset["state"] = "failed";
    setText(this.#words, message);
    this.events.changed();
  }
}

/** Makes a canvas. It is hidden from screen readers, since its button says the same. */
function newCanvas(): HTMLCanvasElement {
  return el("canvas", { "aria-hidden": "true" });
}
