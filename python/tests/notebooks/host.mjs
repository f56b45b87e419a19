/** Servers of notebooks from a Python environment of their own, and a browser, for the tests in notebooks. */

import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { setTimeout as pause } from "node:timers/promises";

const require = createRequire(new URL("../../../www/package.json", import.meta.url));
const { chromium } = require("playwright-core");
const { decode } = require("fast-png");

const PATIENCE_MS = Number(process.env.PATIENCE ?? 90_000);

/** Makes a folder that is removed when the tests end. */
export function folder() {
  const path = mkdtempSync(join(tmpdir(), "riverseed-notebooks-"));
  process.on("exit", () => rmSync(path, { recursive: true, force: true }));
  return path;
}

/** Returns what runs a program of the environment, without anybody's settings, in a home of its own. */
export function environment(home) {
  return {
    PATH: `${process.env.NOTEBOOKS}/bin:${process.env.PATH}`,
    HOME: home,
    XDG_CONFIG_HOME: home,
    XDG_CACHE_HOME: home,
    XDG_STATE_HOME: home,
    JUPYTER_CONFIG_DIR: join(home, "config"),
    JUPYTER_DATA_DIR: join(home, "data"),
    JUPYTER_RUNTIME_DIR: join(home, "runtime"),
    IPYTHONDIR: join(home, "ipython"),
    MPLCONFIGDIR: join(home, "matplotlib"),
    LANG: "C.UTF-8",
  };
}

export async function freePort() {
  const server = createServer();
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  const { port } = server.address();
  await new Promise((resolve) => server.close(resolve));
  return port;
}

/** Starts a server and waits until it answers. */
export async function serve(home, port, program, words) {
  const path = join(process.env.NOTEBOOKS, "bin", program);
  const server = spawn(path, words, { cwd: home, env: environment(home), detached: true });
  let said = "";
  for (const stream of [server.stdout, server.stderr]) stream.on("data", (text) => (said += text));
  let runs = true;
  server.on("exit", () => (runs = false));
  // With its kernels.
  const stop = () => runs && process.kill(-server.pid, "SIGKILL");
  process.on("exit", stop);
  const address = `http://127.0.0.1:${port}`;
  await until(async () => {
    if (!runs) throw new Error(`${program} has ended:\n${said}`);
    return fetch(address).then(
      ({ status }) => status < 500,
      () => false,
    );
  });
  return { address, stop };
}

/** Opens a page, and notes what it complains of. */
export async function browse(address) {
  const browser = await chromium.launch({ executablePath: process.env.HEADLESS_SHELL });
  const page = await browser.newPage({ viewport: { width: 1280, height: 1600 } });
  page.setDefaultTimeout(PATIENCE_MS);
  const complaints = [];
  page.on("pageerror", (error) => complaints.push(String(error.stack)));
  page.on("dialog", (dialog) => {
    complaints.push(dialog.message());
    dialog.dismiss();
  });
  page.on("console", (message) => {
    if (message.type() === "error" && /river|blob:/.test(message.text() + message.location().url))
      complaints.push(message.text());
  });
  await page.goto(address);
  return { browser, page, complaints };
}

/** Returns a part of the element's shadow. */
export const part = (page, name) => page.locator(`river-seed [part~=${name}]`);

/** Counts the colours of the map as it is seen. */
export async function coloursOf(page) {
  const { data, channels } = decode(await page.locator("river-seed").screenshot());
  const colours = new Set();
  for (let at = 0; at < data.length; at += channels) colours.add((data[at] << 16) | (data[at + 1] << 8) | data[at + 2]);
  return colours.size;
}

/** Waits until something is true. */
export async function until(isTrue) {
  const end = Date.now() + PATIENCE_MS;
  while (!(await isTrue())) {
    if (Date.now() > end) throw new Error(`still not true: ${isTrue}`);
    await pause(100);
  }
}
