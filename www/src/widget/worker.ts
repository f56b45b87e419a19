/** The studio in a worker: where it is, growing rivers never keeps the page from answering. */

import { named } from "../errors.ts";
import { load } from "../wasm.ts";
import type { News, Order } from "./orders.ts";
import { Studio } from "./studio.ts";

/** The first message says where the engine is; what comes before it has arrived waits. */
export interface Hello {
  wasmUrl: string | undefined;
}

/** The worker's only answer to it. No canvas is handed over before. */
export type Answer = { is: "open" } | { is: "shut"; code: string; message: string };

const post = (message: News | Answer): void => self.postMessage(message);

self.addEventListener("message", ({ data }: MessageEvent<Hello>) => void open(data), { once: true });

async function open({ wasmUrl }: Hello): Promise<void> {
  try {
    const studio = new Studio(await load(wasmUrl), post);
    self.addEventListener("message", ({ data }: MessageEvent<Order>) => studio.take(data));
    post({ is: "open" });
  } catch (thrown) {
    const { code, message } = named(thrown);
    post({ is: "shut", code, message });
  }
}
