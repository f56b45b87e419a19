/** A blog post with widgets in it, and what tests ask of them. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "@playwright/test";
import { embeddedPictureOf, engine } from "../../core.ts";
import { type Pixels, pixelsOf } from "../pixels.ts";
import { BUILT, expect } from "./hosts.ts";

/** A policy as a careful host sets it: nothing inline, nothing evaluated. */
export const STRICT = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; connect-src 'self'";

/** An ordinary post; the script's address may be of another host. */
export function post(body: string, script = "/widget/river-seed.js"): string {
  return `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>A post</title><link rel="icon" href="data:,">
    <meta name="viewport" content="width=device-width">
    <script type="module" src="${script}"></script></head>
    <body><main><h1>A post</h1><p>Before.</p>${body}<p>After.</p></main></body></html>`;
}

export interface Heard {
  type: string;
  /** The element's id. */
  id: string;
  detail: Record<string, unknown>;
}

/** Notes every event of every widget. Call before `goto`. */
export async function listen(page: Page): Promise<() => Promise<Heard[]>> {
  await page.addInitScript(() => {
    const heard: Heard[] = [];
    Object.assign(globalThis, { heard_: heard });
    for (const type of ["ready", "corrected", "progress", "complete", "error"]) {
      const note = (event: Event): void => {
        if (!(event instanceof CustomEvent && event.target instanceof Element)) return;
        heard.push({ type, id: event.target.id, detail: event.detail });
      };
      document.addEventListener(type, note, true);
    }
  });
  return () => page.evaluate(() => (globalThis as unknown as { heard_: Heard[] }).heard_);
}

/** Waits until a number of events of a type were heard; the last of them. */
export async function heard(events: () => Promise<Heard[]>, type: string, count = 1): Promise<Heard> {
  const those = async (): Promise<Heard[]> => (await events()).filter((event) => event.type === type);
  await expect.poll(async () => (await those()).length).toBeGreaterThanOrEqual(count);
  const last = (await those()).at(-1);
  if (!last) throw new Error(`no ${type}`);
  return last;
}

/** The bytes on the canvas that is seen of a widget. */
export function pixels(page: Page, selector = "river-seed"): Promise<Pixels> {
  return pixelsOf(page.locator(`${selector} canvas:not(.waits)`));
}

/** The widget shows what the core draws of a link, byte for byte. */
export async function expectPicture(page: Page, link: string, selector = "river-seed"): Promise<void> {
  await expect
    .poll(async () => {
      const { width, height, sha256 } = await pixels(page, selector);
      return width > 100 && sha256 === embeddedPictureOf(link, width, height).sha256;
    })
    .toBe(true);
}

/** The canonical spelling of a link. */
export function canonical(link: string): string {
  return engine.readLink(link).link;
}

/** Counts, in a page or in a worker, what the engine holds and does; and fails by name when a river is replayed, once asked to. */
export const PROBE = `{
  const count = { rivers: 0, steps: 0, pictures: 0, frames: 0, bytes: 0 };
  let memory, failure;
  const instantiate = WebAssembly.instantiate;
  WebAssembly.instantiate = async (...given) => {
    const instance = await Reflect.apply(instantiate, WebAssembly, given);
    const { river_new, river_advance, river_restart, __wbg_river_free, ...others } = instance.exports;
    memory = others.memory;
    return { exports: {
      ...others,
      river_new: (...args) => { count.rivers++; return river_new(...args); },
      __wbg_river_free: (...args) => { count.rivers--; return __wbg_river_free(...args); },
      river_advance: (...args) => { count.steps++; return river_advance(...args); },
      river_restart: (...args) => {
        if (failure === "panic") throw new WebAssembly.RuntimeError("unreachable");
        if (failure) throw Object.assign(new Error("no room"), { code: failure });
        return river_restart(...args);
      },
    } };
  };
  // What the glue asks of an instance.
  Object.defineProperty(WebAssembly.Instance, Symbol.hasInstance, { value: (one) => "exports" in Object(one) });
  const put = globalThis.OffscreenCanvasRenderingContext2D?.prototype.putImageData;
  if (put) OffscreenCanvasRenderingContext2D.prototype.putImageData = function (...given) {
    count.pictures++;
    return Reflect.apply(put, this, given);
  };
  const request = globalThis.requestAnimationFrame.bind(globalThis);
  globalThis.requestAnimationFrame = (callback) => {
    count.frames++;
    return request((now) => { count.frames--; callback(now); });
  };
  const channel = new BroadcastChannel("probe");
  channel.onmessage = ({ data }) => {
    if (data.failure) {
      failure = data.failure;
      channel.postMessage("heard");
    }
    if (data === "count") channel.postMessage({ ...count, bytes: memory?.buffer.byteLength ?? 0 });
  };
}
`;

export const PROBED_WORKER = PROBE + readFileSync(join(BUILT, "worker.js"), "utf8");

export interface Count {
  rivers: number;
  steps: number;
  /** That were put on a canvas. */
  pictures: number;
  /** That are waited for. */
  frames: number;
  bytes: number;
}

/** What the probed worker counts. */
export function probe(page: Page): Promise<Count> {
  return page.evaluate(
    () =>
      new Promise<Count>((done) => {
        const channel = new BroadcastChannel("probe");
        channel.onmessage = ({ data }) => {
          channel.close();
          done(data);
        };
        channel.postMessage("count");
      }),
  );
}

/** From now on the probed engine fails when a river is replayed: by a trap, as a panic does, or with an error of another code. */
export async function failOnReplay(page: Page, failure: "panic" | "no-memory"): Promise<void> {
  // What the page says next may reach a worker before this does, unless this is waited for.
  await page.evaluate(
    (failure) =>
      new Promise<void>((done) => {
        const channel = new BroadcastChannel("probe");
        channel.onmessage = ({ data }) => {
          if (data !== "heard") return;
          channel.close();
          done();
        };
        channel.postMessage({ failure });
      }),
    failure,
  );
}

/** Lets some frames pass. */
export async function frames(page: Page, count = 20): Promise<void> {
  await page.evaluate(async (count) => {
    for (let i = 0; i < count; i++) await new Promise(requestAnimationFrame);
  }, count);
}
