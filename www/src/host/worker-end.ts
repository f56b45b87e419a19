/** The worker's side of a renderer. Rivers grow here, so that the page always answers. */

import { named } from "../engine/errors.ts";
import { PAINTING_SILENCE_MS } from "../engine/time-limits.ts";
import type { River } from "../engine/types.ts";
import type { Command, InitReply, Ping, Pong, Report } from "./protocol.ts";
import type { Renderer } from "./renderer.ts";

/** The time for work in a frame of a worker, in ms: nearly all of one, since no page waits here. */
export const WORK_MS = 15;

/** The messages that a renderer sends to the page. */
export interface Line<Answer> {
  tell(report: Report<Answer>): void;
  /** Says that the engine is still loading. */
  coming(): void;
  /** Announces a long step. */
  holdOn(): void;
}

/**
 * Opens a renderer when the first message says where the engine is, and hands it all later messages, even those that
 * come before it is open.
 */
export function serve<Init, R extends River, Question, Answer>(
  open: (init: Init, line: Line<Answer>) => Promise<Renderer<R, Question, Answer>>,
): void {
  const post = (message: Report<Answer> | InitReply | Pong): void => self.postMessage(message);
  const line: Line<Answer> = {
    tell: post,
    coming: () => post({ is: "coming" }),
    holdOn: () => post({ id: 0, is: "alive", isAtWork: true, silenceMs: PAINTING_SILENCE_MS }),
  };
  const early: (Command<Question> | Ping)[] = [];
  let take = (message: Command<Question> | Ping): unknown => early.push(message);
  const begin = async (init: Init): Promise<void> => {
    try {
      line.coming();
      const renderer = await open(init, line);
      take = (message) => {
        if (message.do === "ping") post({ id: message.id, is: "alive", isAtWork: renderer.isAtWork });
        else renderer.take(message);
      };
      post({ is: "open" });
      early.forEach(take);
    } catch (thrown) {
      const { code, message } = named(thrown);
      post({ is: "shut", code, message });
    }
  };
  const first = ({ data }: MessageEvent<Init>): void => {
    void begin(data);
    self.addEventListener("message", ({ data }: MessageEvent<Command<Question> | Ping>) => take(data));
  };
  self.addEventListener("message", first, { once: true });
}
