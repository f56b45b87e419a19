/**
 * An element's river at the render host. It may not be there yet, or its worker may no longer answer: so the last
 * request is kept until the river follows it.
 */

import type { Opening as HostOpening, SceneCommand } from "../../host/protocol.ts";
import type { Client } from "../../host/render-host.ts";
import type { State } from "../../player/frame-loop.ts";
import type { ShowMode } from "../../player/river-player.ts";
import { renderHost } from "./backend.ts";
import type { Init } from "./protocol.ts";

type Unaddressed<Every> = Every extends unknown ? Omit<Every, "id"> : never;
export type Order = Unaddressed<SceneCommand>;

/** A request of a script, or of the reader, that may come before the river is there. */
export type Request = { do: "play" | "pause" | "finish" } | { do: "seek"; share: number };

/** The canvas of a river, and the way to show it there. */
export type Opening = Pick<HostOpening, "canvas" | "link" | "how" | "size">;

export class HostedRiver {
  /** Its client number at the render host. */
  #id: number | undefined;
  #asked: Request | undefined;
  #links = 0;

  get isThere(): boolean {
    return this.#id !== undefined;
  }

  /** True if it has been asked to play, and so need not be seen to begin. */
  get isAskedToPlay(): boolean {
    return this.#asked?.do === "play";
  }

  /** The number of links it has been asked to show after the first, as `Reading` counts them. */
  get links(): number {
    return this.#links;
  }

  /** Enters the render host and opens the river, unless the signal is aborted by then. */
  async enter(client: Client<Blob>, init: Init, signal: AbortSignal, opening: () => Opening): Promise<void> {
    const id = await renderHost.enter(client, init);
    if (signal.aborted) renderHost.leave(id);
    else this.#open(id, opening());
  }

  #open(id: number, opening: Opening): void {
    const asked = this.#asked;
    renderHost.send(id, { ...opening, do: "open", how: howFor(asked, opening.how) });
    this.#id = id;
    this.#links = 0;
    if (asked) this.send(asked);
  }

  show(what: Omit<Opening, "canvas">): void {
    this.#links++;
    this.send({ ...what, do: "show" });
  }

  /** Keeps a request until the river follows it. One that is there is sent `order` at once. */
  ask(request: Request, order: Order = request): void {
    this.#asked = request;
    this.send(order);
  }

  /** Called when it has told of itself, and so has followed what was asked. */
  answered(): void {
    this.#asked = undefined;
  }

  /** Sends an order, or nothing before the river is there. */
  send(order: Order): void {
    if (this.#id !== undefined) renderHost.send(this.#id, order);
  }

  /** Its engine is gone, and another takes its place. It is to go on there from the state that it was in. */
  move(state: State | undefined): void {
    this.#id = undefined;
    if (state === "finished" || state === "paused") this.#asked ??= { do: state === "paused" ? "pause" : "finish" };
  }

  leave(): void {
    if (this.#id !== undefined) renderHost.leave(this.#id);
    this.#id = undefined;
  }
}

/** Returns the way to show a river of which something has been asked. */
function howFor(asked: Request | undefined, how: ShowMode): ShowMode {
  if (!asked || asked.do === "pause") return how;
  return asked.do === "finish" ? "still" : "watch";
}
