#!/usr/bin/env node
// Measures the cost of a widget for the page around it, in ms. Prints JSON on one line:
//   {"worker" | "page": {recipe: {"frame": from the engine's last byte to the first picture,
//                                 "longest": the longest task on the page's main thread, in processor time}}}
// worker: as usual; page: in a browser whose workers cannot draw.
//
// The widget must have been built (npm run build:widget). CHROME names the browser. REPEAT is the number of rivers
// (default
// 3; the median of each figure is printed).

import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname } from "node:path";
import { launchBrowser } from "./built-page.mjs";

/**
 * The recipes. The finest ask for more than a widget grows, and so get the most that it grows; others make the most
 * work of that.
 */
const RECIPES = {
  default: 'seed="kauri"',
  finest:
    'seed="kauri" aspect="1.5" land="rectangle" mouths="3" curl="0" attractors="1000000" kill="0.5" step="0.2" trim="0" simplify="0"',
  "finest Brownian tree":
    'seed="kauri" aspect="1.5" land="rectangle" growth="brownian" sensitivity="8" trim="0" simplify="0"',
};
const TYPES = { ".js": "text/javascript", ".wasm": "application/wasm" };
const repeat = Number(process.env.REPEAT ?? 3);

/** The time at which the last byte of the engine was sent. */
let sent = 0;
const server = createServer(async ({ url }, response) => {
  const { pathname, searchParams } = new URL(url, "http://bench");
  if (pathname === "/") {
    response.writeHead(200, { "content-type": "text/html" }).end(post(searchParams.get("recipe")));
    return;
  }
  if (pathname.endsWith("_bg.wasm")) response.on("finish", () => (sent = Date.now()));
  const file = await readFile(new URL(`../dist-widget${pathname}`, import.meta.url)).catch(() => undefined);
  response.writeHead(file ? 200 : 404, { "content-type": TYPES[extname(pathname)] ?? "text/plain" }).end(file);
});
await new Promise((done) => server.listen(0, "127.0.0.1", done));
const address = `http://127.0.0.1:${server.address().port}/`;
const browser = await launchBrowser();
try {
  const found = {};
  for (const place of ["worker", "page"]) {
    found[place] = {};
    for (const recipe of Object.keys(RECIPES)) {
      const runs = [];
      for (let i = 0; i < repeat; i++) runs.push(await measure(place, recipe));
      found[place][recipe] = medians(runs);
    }
  }
  console.log(JSON.stringify(found));
} finally {
  await browser.close();
  server.close();
}

function post(recipe) {
  return `<!doctype html><html lang="en"><meta charset="utf-8"><title>A post</title>
    <link rel="icon" href="data:,">
    <body style="max-width: 720px; margin: 2em auto"><p>A river:</p><river-seed ${RECIPES[recipe]}></river-seed>`;
}

async function measure(place, recipe) {
  const page = await browser.newPage({ viewport: { width: 1000, height: 800 } });
  if (place === "page")
    await page.addInitScript(() => Reflect.deleteProperty(HTMLCanvasElement.prototype, "transferControlToOffscreen"));
  await page.addInitScript(() => {
    globalThis.at_ = {};
    for (const type of ["ready", "complete"]) {
      document.addEventListener(type, () => Object.assign(globalThis.at_, { [type]: Date.now() }), true);
    }
  });
  await page.goto(`${address}?recipe=${recipe}`);
  await browser.startTracing(page, {
    categories: ["toplevel", "devtools.timeline", "disabled-by-default-devtools.timeline", "__metadata"],
  });
  await page.addScriptTag({ type: "module", url: "river-seed.js" });
  await page.waitForFunction(() => globalThis.at_.complete, null, { timeout: 300_000 });
  const { ready } = await page.evaluate(() => globalThis.at_);
  const trace = JSON.parse(await browser.stopTracing());
  await page.close();
  return { frame: ready - sent, longest: longestTask(trace.traceEvents) };
}

/** Returns the longest task of all main threads, in processor time. */
function longestTask(events) {
  const isMain = ({ name, args }) => name === "thread_name" && args.name === "CrRendererMain";
  const mains = events.filter(isMain).map(({ pid, tid }) => `${pid} ${tid}`);
  const tasks = events.filter(({ name, pid, tid }) => /RunTask$/.test(name) && mains.includes(`${pid} ${tid}`));
  const taken = ({ tdur, dur }) => (tdur ?? dur) / 1000;
  tasks.sort((a, b) => taken(b) - taken(a));
  if (process.env.DETAIL) for (const task of tasks.slice(0, 8)) detail(task, events);
  return taken(tasks[0]);
}

/** Prints the details of a task. */
function detail({ pid, tid, ts, dur, tdur }, events) {
  const within = events.filter(
    (e) => e.pid === pid && e.tid === tid && e.ts >= ts && e.ts + (e.dur ?? 0) <= ts + dur && e.dur > 3000,
  );
  console.error(
    dur / 1000,
    tdur / 1000,
    within
      .map((e) => `${e.name} ${e.dur / 1000} ${e.args?.data?.functionName ?? ""}`)
      .join(" | ")
      .slice(0, 300),
  );
}

function medians(runs) {
  const middle = (key) => runs.map((run) => run[key]).sort((a, b) => a - b)[Math.floor(runs.length / 2)];
  return Object.fromEntries(Object.keys(runs[0]).map((key) => [key, Number(middle(key).toFixed(1))]));
}
