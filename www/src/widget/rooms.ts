/** The two places where the studio can be. */

import type { News, Order } from "./orders.ts";
import type { Answer, Hello } from "./worker.ts";

/** Where the studio is. */
export interface Room {
  take(order: Order): void;
  /** Leaves the room; whoever is in it is gone. */
  close(): void;
  /** Whether another can be opened in place of one whose engine has stopped. */
  readonly isReplaceable: boolean;
}

export interface Listener {
  tell(news: News): void;
  /** The room as a whole has failed. */
  collapsed(message: string): void;
}

/** A worker if the browser and the page's policy allow one with a canvas, otherwise the page itself. */
export async function openRoom(listener: Listener, wasmUrl: string | undefined): Promise<Room> {
  return (await openWorker(listener, wasmUrl)) ?? openHere(listener, wasmUrl);
}

async function openHere({ tell }: Listener, wasmUrl: string | undefined): Promise<Room> {
  const { openHere } = await import("./here.ts");
  return openHere(tell, wasmUrl);
}

/** Nothing if there is none to be had: whatever the reason, the page itself is tried next and says what is wrong. */
async function openWorker(listener: Listener, wasmUrl: string | undefined): Promise<Room | undefined> {
  if (!("transferControlToOffscreen" in HTMLCanvasElement.prototype)) return;
  let worker: Worker | undefined;
  try {
    worker = begin();
    await handshake(worker, { wasmUrl });
    return roomOf(worker, listener);
  } catch {
    worker?.terminate();
    return;
  }
}

function begin(): Worker {
  try {
    return new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
  } catch {
    return beginFromElsewhere();
  }
}

/** A worker has to come from the page's own origin, so one of two lines does, and imports the real one. */
function beginFromElsewhere(): Worker {
  const address = new URL(/* @vite-ignore */ "./worker.js", import.meta.url).href;
  const lines = new Blob([`import ${JSON.stringify(address)}`], { type: "text/javascript" });
  const url = URL.createObjectURL(lines);
  const worker = new Worker(url, { type: "module" });
  worker.addEventListener("message", () => URL.revokeObjectURL(url), { once: true });
  return worker;
}

/** Waits until the worker has the engine. A refused worker says so by an error, an engine that does not arrive by an answer. */
function handshake(worker: Worker, hello: Hello): Promise<void> {
  return new Promise((done, failed) => {
    worker.onmessage = ({ data }: MessageEvent<Answer>) => (data.is === "open" ? done() : failed(data));
    worker.onerror = failed;
    worker.postMessage(hello);
  });
}

function roomOf(worker: Worker, listener: Listener): Room {
  worker.onmessage = ({ data }: MessageEvent<News>) => listener.tell(data);
  worker.onerror = ({ message }) => listener.collapsed(message);
  return {
    isReplaceable: true,
    take(order) {
      if (order.do === "open") {
        const canvas = (order.canvas as HTMLCanvasElement).transferControlToOffscreen();
        worker.postMessage({ ...order, canvas }, [canvas]);
      } else worker.postMessage(order);
    },
    close: () => worker.terminate(),
  };
}
