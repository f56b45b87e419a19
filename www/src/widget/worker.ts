/** The renderer in a worker: where it is, growing rivers never keeps the page from answering. */

import { named } from "../engine/errors.ts";
import { PAINTING_SILENCE_MS } from "../engine/time-limits.ts";
import { load } from "../engine/wasm.ts";
import type { Command, Init, InitReply, Ping, Pong, Report } from "./protocol.ts";
import { Renderer } from "./renderer.ts";

const post = (message: Report | InitReply | Pong): void => self.postMessage(message);

self.addEventListener("message", ({ data }: MessageEvent<Init>) => void open(data), { once: true });

async function open({ wasmUrl }: Init): Promise<void> {
  try {
    const coming = (): void => post({ is: "coming" });
    coming();
    const painting = (): void => post({ id: 0, is: "alive", isAtWork: true, silenceMs: PAINTING_SILENCE_MS });
    const renderer = new Renderer(await load(wasmUrl, coming), wasmUrl, post, painting);
    self.addEventListener("message", ({ data }: MessageEvent<Command | Ping>) => {
      if (data.do === "ping") post({ id: data.id, is: "alive", isAtWork: renderer.isAtWork });
      else renderer.take(data);
    });
    post({ is: "open" });
  } catch (thrown) {
    const { code, message } = named(thrown);
    post({ is: "shut", code, message });
  }
}
