/**
 * What widgets and the renderer say to each other: plain data, since the renderer may be in a worker. Commands go there, reports come
 * back; every widget has a number.
 */

import type { CanvasSize } from "../browser/canvas.ts";
import type { Code } from "../engine/errors.ts";
import type { Notice, Phase, Summary } from "../engine/types.ts";
import type { State } from "../player/frame-loop.ts";
import type { Canvas, ShowMode } from "../player/river-player.ts";

/** What a widget asks for. */
export interface RiverRequest {
  /** Link text as its author gave it: anything. */
  text: string;
  /** Whether it stands on a dark page. */
  isDark: boolean;
}

/** A request as the core understood it. */
export interface Reading {
  /** The canonical link: what is drawn. */
  link: string;
  seed: string;
  aspect: number;
  /** What had to be corrected. */
  notices: readonly Notice[];
}

/** What is made of a river besides a picture on the page. */
export interface FileRequest {
  format: "png" | "svg";
  /** Pixels on the long side of a PNG. */
  longSide: number;
  /** Where the lean engine is, if not beside the script; the full one lies beside it. */
  wasmUrl: string | undefined;
}

export type Command = { id: number } & (
  | { do: "open"; canvas: Canvas; request: RiverRequest; how: ShowMode; size: CanvasSize }
  | { do: "show"; request: RiverRequest; how: ShowMode; size: CanvasSize }
  | { do: "resize"; size: CanvasSize }
  | { do: "play" | "pause" | "replay" | "finish" | "rest" | "wake" | "close" }
  | ({ do: "file"; request: RiverRequest } & FileRequest)
);

/** The place that the renderer runs in: a worker, or the page itself. */
export interface Backend {
  take(command: Command): void;
  /** Ends it, with all rivers in it. */
  close(): void;
  /** Whether another can be opened in place of one whose engine has stopped. */
  readonly isReplaceable: boolean;
}

/** The first message to a worker says where the engine is; what comes before it has arrived waits. */
export interface Init {
  wasmUrl: string | undefined;
}

/** The worker's answers to it: while the engine is coming, and one at the end. No canvas is handed over before. */
export type InitReply = { is: "coming" } | { is: "open" } | { is: "shut"; code: string; message: string };

/** Asks a worker for a sign of life; its number is that of the commands before it. */
export interface Ping {
  id: number;
  do: "ping";
}

/**
 * The answer to it. Without work the worker says no more, until there is another command. Before a step that takes long it says
 * unasked how long at most nothing will be heard of it.
 */
export interface Pong {
  id: number;
  is: "alive";
  isAtWork: boolean;
  silenceMs?: number;
}

/** How a river that is shown stands. */
export interface Status {
  state: State;
  phase: Phase;
  summary: Summary;
}

export type Report = { id: number } & (
  | ({ is: "shown"; reading: Reading } & Status)
  | { is: "failed"; code: Code; message: string }
  | { is: "file"; blob: Blob }
);
