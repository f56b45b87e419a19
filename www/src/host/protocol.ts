/**
 * The messages between the renderer and its clients: plain data, since the renderer may be in a worker. Commands go to
 * the renderer and reports come back; both carry the number of the client they belong to.
 */

import type { CanvasSize } from "../browser/canvas.ts";
import type { Code } from "../engine/errors.ts";
import type { Canvas, LinkToRead, Reading, ShowMode, Status } from "../player/river-player.ts";

export type { Reading, Status } from "../player/river-player.ts";

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

/** A command to a river on its canvas. */
export type SceneCommand = { id: number } & (
  | { do: "show"; link: LinkToRead; how: ShowMode; size: CanvasSize }
  | { do: "resize"; size: CanvasSize }
  | { do: "speed"; speed: number }
  | { do: "seek"; share: number }
  | { do: "play" | "pause" | "toggle" | "replay" | "finish" | "rest" | "finishUnseen" | "wake" | "close" }
);

/** A message to the renderer. A question has a number that no other message has, and gets one answer. */
export type Command<Question> = Opening | SceneCommand | { id: number; do: "ask"; question: Question };

/** The place that the renderer runs in: a worker, or the page itself. */
export interface Backend<Question> {
  take(command: Command<Question>): void;
  /** Closes the renderer and all rivers in it. */
  close(): void;
  /** True if another can be opened in place of one whose engine has stopped. */
  readonly isReplaceable: boolean;
}

/**
 * The worker's answers to its first message, which says where the engine is: `coming` while the engine loads, then
 * `open` or `shut`. Commands that come earlier wait, and no canvas is handed over before.
 */
export type InitReply = { is: "coming" } | { is: "open" } | { is: "shut"; code: string; message: string };

/** Asks a worker for a sign of life. Its number is the count of commands sent before it. */
export interface Ping {
  id: number;
  do: "ping";
}

/**
 * The answer to a ping. A worker without work then stays silent until the next command. Before a long step it sends one
 * unasked, with the longest silence to expect.
 */
export interface Pong {
  id: number;
  is: "alive";
  isAtWork: boolean;
  silenceMs?: number;
}

/**
 * A message from the renderer. A failure of a scene carries the number of links it had been asked to show, which tells
 * whose failure it is.
 */
export type Report<Answer> = { id: number } & (
  | ({ is: "shown"; reading: Reading } & Status)
  | { is: "failed"; code: Code; message: string; links?: number }
  | { is: "answer"; answer: Answer }
);
