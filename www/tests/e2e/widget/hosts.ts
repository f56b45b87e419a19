/** Two small web servers of different origins: the blog that a widget stands in, and the host its script comes from. */

import { readFile } from "node:fs/promises";
import { createServer, type OutgoingHttpHeaders, type Server } from "node:http";
import type { AddressInfo } from "node:net";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { test as base } from "@playwright/test";

/** The built widget. */
export const BUILT = fileURLToPath(new URL("../../../dist-widget", import.meta.url));

const TYPES: Record<string, string> = {
  ".css": "text/css",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".json": "application/json",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
};

export interface Answer {
  status?: number;
  headers?: OutgoingHttpHeaders;
  body?: string | Buffer;
  /** It is begun and never ended: what there is of the body comes, and nothing more. */
  hangs?: boolean;
  /** What comes later than the body. */
  rest?: Promise<string>;
}

export class Host {
  /** With every answer: a policy, CORS. An answer's own headers come before them. */
  headers: OutgoingHttpHeaders = {};
  /** The paths that were asked for, in order. */
  readonly asked: string[] = [];
  /** True while nobody gets an answer: every connection breaks. */
  isCut = false;
  readonly #answers = new Map<string, Answer>();
  readonly #folders = new Map<string, string>();

  private constructor(private readonly server: Server) {
    server.on("request", async ({ url }, response) => {
      if (this.isCut) {
        response.destroy();
        return;
      }
      const path = decodeURIComponent(new URL(url ?? "/", "http://host").pathname);
      this.asked.push(path);
      const { status = 200, headers, body, hangs, rest } = this.#answers.get(path) ?? (await this.#file(path));
      response.writeHead(status, {
        "content-type": this.types[extname(path)] ?? TYPES[".html"],
        ...this.headers,
        ...headers,
      });
      if (body !== undefined) response.write(body);
      if (!hangs) response.end(await rest);
    });
  }

  /** On a free port, so that tests side by side have their own. */
  static open(): Promise<Host> {
    const server = createServer();
    const host = new Host(server);
    return new Promise((done) => server.listen(0, "127.0.0.1", () => done(host)));
  }

  get origin(): string {
    return `http://127.0.0.1:${(this.server.address() as AddressInfo).port}`;
  }

  /** By the ending of a file. */
  readonly types = { ...TYPES };

  /** What is answered for a path, in place of any file. */
  answer(path: string, answer: Answer): void {
    this.#answers.set(path, answer);
  }

  /** From now on the path is a file again. */
  forget(path: string): void {
    this.#answers.delete(path);
  }

  /** Serves a folder's files under a path, which ends in a slash. */
  folder(path: string, folder: string): void {
    this.#folders.set(path, folder);
  }

  close(): Promise<void> {
    this.server.closeAllConnections();
    return new Promise((done) => this.server.close(() => done()));
  }

  async #file(path: string): Promise<Answer> {
    for (const [prefix, folder] of this.#folders) {
      if (!path.startsWith(prefix)) continue;
      try {
        return { body: await readFile(join(folder, normalize(`/${path.slice(prefix.length)}`))) };
      } catch {
        break;
      }
    }
    return { status: 404, headers: { "content-type": "text/plain" }, body: "not here" };
  }
}

/**
 * blog: a host with nothing but what a test puts there, and the built widget under /widget/; cdn: the built widget at its root,
 * for any origin.
 */
export const test = base.extend<{ blog: Host; cdn: Host }>({
  // biome-ignore lint/correctness/noEmptyPattern: the form that Playwright wants
  blog: async ({}, use) => {
    const host = await Host.open();
    host.folder("/widget/", BUILT);
    await use(host);
    await host.close();
  },
  // biome-ignore lint/correctness/noEmptyPattern: the form that Playwright wants
  cdn: async ({}, use) => {
    const host = await Host.open();
    host.folder("/", BUILT);
    host.headers = { "access-control-allow-origin": "*" };
    await use(host);
    await host.close();
  },
});

export { expect } from "@playwright/test";
