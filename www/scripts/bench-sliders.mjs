#!/usr/bin/env node
// Measures the sliders of the built page's panel while a hand moves them, in a window of 1440 by 900: the time in ms
// from the input event
// to changed pixels on the canvas, and the longest task on the page's own thread. Prints JSON on one line:
//   {NAME: {"sliders": {KEY: {"p50", "p95"}}, "longest"}}
//
// The page must have been built (npm run build). CHROME names the browser. MOVES is the number of moves of each slider
// (default 12). ONLY
// lists some of the names of LINKS, and SLIDERS some of the keys, separated by commas.

import { printFigures } from "./built-page.mjs";

const ATLAS = "style=atlas&labels=some";
const LINKS = {
  default: ATLAS,
  colonize: `${ATLAS}&growth=colonize&attractors=20000&mouths=8`,
  many: `${ATLAS}&attractors=300000`,
};
/**
 * The sliders for many attractors, each of which begins with another stage. Only the longest task is measured there.
 */
const SOME = ["width", "simplify", "channel-area", "concavity", "sea"];
/** The longest time that is waited for a picture. */
const PATIENCE_MS = 3000;
/** The time between two moves, shorter than a rest of the hand. */
const BETWEEN_MS = 60;
const moves = Number(process.env.MOVES ?? 12);

await printFigures(async (browser, address) => {
  const found = {};
  const wanted = process.env.ONLY?.split(",") ?? Object.keys(LINKS);
  for (const name of wanted) found[name] = await measure(name, browser, address);
  return found;
});

async function measure(name, browser, address) {
  const page = await browser.newPage({ viewport: { width: 1440, height: 900 }, serviceWorkers: "block" });
  await page.route(/\/assets\/page-worker-[^/]*\.js$/, async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, body: `(${tellOfPictures})();\n${await response.text()}` });
  });
  await page.addInitScript(watch);
  await page.goto(`${address}?${LINKS[name]}`);
  await finished(page);
  await page.click("#shape");
  for (const details of await page.$$("details.group, details.more"))
    await details.evaluate((one) => {
      one.open = true;
    });
  await finished(page);
  const keys = process.env.SLIDERS?.split(",") ?? (name === "many" ? SOME : await page.evaluate(slidersOf));
  const sliders = {};
  let longest = 0;
  for (const key of keys) {
    const { times, task } = await page.evaluate(drag, { key, moves, PATIENCE_MS, BETWEEN_MS });
    await finished(page);
    // None of its positions gives another map.
    if (times.length === 0) continue;
    times.sort((a, b) => a - b);
    const at = (share) => Number(times[Math.min(times.length - 1, Math.floor(share * times.length))].toFixed(1));
    sliders[key] = { p50: at(0.5), p95: at(0.95) };
    longest = Math.max(longest, task);
    if (process.env.DETAIL) console.error(name, key, sliders[key], `longest task ${task}`);
  }
  await page.close();
  return { sliders, longest };
}

/** Waits until the map is finished, and everything that follows from that. */
async function finished(page) {
  await page.waitForSelector('#frame[data-state="finished"]:not([data-pending])', { timeout: 300_000 });
  await page.waitForTimeout(800);
}

/** Runs in the worker: reports when pixels were put on a canvas. */
function tellOfPictures() {
  const line = new BroadcastChannel("pictures");
  const own = OffscreenCanvasRenderingContext2D.prototype;
  const put = own.putImageData;
  own.putImageData = function (...given) {
    put.apply(this, given);
    line.postMessage(performance.timeOrigin + performance.now());
  };
}

/** Runs in the page: records those times, and tasks of more than 50 ms. */
function watch() {
  const seen = { pictures: [], tasks: [] };
  globalThis.seen_ = seen;
  new BroadcastChannel("pictures").onmessage = ({ data }) => seen.pictures.push(data);
  new PerformanceObserver((list) => {
    for (const { startTime, duration } of list.getEntries()) seen.tasks.push({ startTime, duration });
  }).observe({ entryTypes: ["longtask"] });
}

/** Returns the sliders that have an effect. */
function slidersOf() {
  // Those in front with a name of their own have another behind the door.
  const all = document.querySelectorAll(
    ":is(#front, #controls) fieldset:not(:disabled) input[type=range]:not([id^=field-front-])",
  );
  return [...all].map(({ id }) => id.replace(/^field-/, ""));
}

/** Moves a slider to and fro around its position, as a hand does that continues when it has seen something. */
async function drag({ key, moves, PATIENCE_MS, BETWEEN_MS }) {
  const { pictures, tasks } = globalThis.seen_;
  const values = () => [...document.querySelectorAll(".exact")].map(({ value }) => value).join();
  const slider = document.getElementById(key.startsWith("macro-") ? key : `field-${key}`);
  const [first, min, max] = [slider.value, slider.min, slider.max].map(Number);
  const finest = Number(slider.step) || 1;
  const step = finest * Math.max(1, Math.ceil((max - min) / 40 / finest));
  const pause = (ms) => new Promise((done) => setTimeout(done, ms));
  const from = first + 4 * step <= max ? first : max - 4 * step;
  const began = performance.now();
  const times = [];
  for (let i = 0; i < moves; i++) {
    const to = from + step * ((i % 4) + 1);
    slider.value = String(to);
    const [before, count] = [values(), pictures.length];
    const moved = performance.timeOrigin + performance.now();
    slider.dispatchEvent(new Event("input", { bubbles: true }));
    // Two positions of a slider may give the same values, for which there is only one picture.
    if (values() === before) continue;
    const isAnswered = () => pictures.length > count && pictures.at(-1) >= moved;
    while (!isAnswered() && performance.timeOrigin + performance.now() - moved < PATIENCE_MS) await pause(1);
    times.push(isAnswered() ? pictures.slice(count).find((at) => at >= moved) - moved : PATIENCE_MS);
    await pause(BETWEEN_MS);
  }
  slider.value = String(first);
  slider.dispatchEvent(new Event("input", { bubbles: true }));
  await pause(300);
  const during = tasks.filter(({ startTime }) => startTime >= began).map(({ duration }) => Math.round(duration));
  return { times, task: Math.max(0, ...during) };
}
