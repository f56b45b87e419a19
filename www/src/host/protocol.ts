/**
 * What whoever shows a river and the renderer say to each other: plain data, since the renderer may be in a worker. Commands go
 * there, reports come back; each of whom they are about has a number.
 */

import type { CanvasSize } from "../browser/canvas.ts";
import type { Code } from "../engine/errors.ts";
import type { Phase, Summary } from "../engine/types.ts";
import type { State } from "../player/frame-loop.ts";
import type { Canvas, LinkToRead, Reading, ShowMode } from "../player/river-player.ts";

export type { Reading } from "../player/river-player.ts";

/** Puts a river on a canvas. */
export interface Opening {
  id: number;
  do: "open";
  canvas: Canvas;
  link: LinkToRead;
  how: ShowMode;
  size: CanvasSize;
  /** True if it grows tick by tick with all others that do. */
  inStep?: boolean;
}

/** To a river on its canvas. */
export type SceneCommand = { id: number } & (
  | { do: "show"; link: LinkToRead; how: ShowMode; size: CanvasSize }
  | { do: "resize"; size: CanvasSize }
  | { do: "speed"; speed: number }
  | { do: "play" | "pause" | "toggle" | "replay" | "finish" | "rest" | "wake" | "close" }
);

/** A question has one answer, and a number of its own. */
export type Command<Question> = Opening | SceneCommand | { id: number; do: "ask"; question: Question };

/** The place that the renderer runs in: a worker, or the page itself. */
export interface Backend<Question> {
  take(command: Command<Question>): void;
  /** Ends it, with all rivers in it. */
  close(): void;
  /** True if another can be opened in place of one whose engine has stopped. */
  readonly isReplaceable: boolean;
}

/**
 * The worker's answers to its first message, which says where the engine is: while that is coming, and one at the end. What comes
 * before it has arrived waits. No canvas is handed over before.
 */
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

/** The state of a river on its canvas, with its numbers. */
export interface Status {
  state: State;
  phase: Phase;
  summary: Summary;
}

/** A failure of a scene says how many links that had been asked to show by then: of which one it is. */
export type Report<Answer> = { id: number } & (
  | ({ is: "shown"; reading: Reading } & Status)
  | { is: "failed"; code: Code; message: string; links?: number }
  | { is: "answer"; answer: Answer }
);
