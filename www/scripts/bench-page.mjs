#!/usr/bin/env node
// Measures frames of the built page on a canvas of 1024 by 1024, while 100,000 attractors grow and while the rivers of
// 6,000 meander. Prints JSON on one line:
//   {"growing", "meandering": {"p50","p95","max" frame gap in ms, "longest" callback in ms, "frames", "seconds"}}
//
// The page must have been built (npm run build). CHROME names the browser. REPEAT is the number of rivers (default 3;
// the median of each figure is printed).

import { printFigures } from "./built-page.mjs";

/** The values with which figures have always been taken, whatever the defaults are. */
const PLAIN = "seed=kauri&aspect=1&land=rectangle&mouths=3&curl=0&width=14&great-rivers=1&style=ink";
/** The links. The step that makes rivers from a tree counts as meandering. */
const LINKS = {
  growing: `${PLAIN}&attractors=100000&trim=5&meander=none`,
  meandering: `${PLAIN}&attractors=6000&trim=20&meander-rounds=24`,
};
const SIDE_PX = 1024;
const repeat = Number(process.env.REPEAT ?? 3);

await printFigures(async (browser, address) => {
  const found = {};
  for (const phase of Object.keys(LINKS)) {
    const runs = [];
    for (let i = 0; i < repeat; i++) runs.push(await measure(phase, browser, address));
    found[phase] = medians(runs);
  }
  return found;
});

async function measure(phase, browser, address) {
  // bypassCSP allows the style below; nothing else depends on the policy.
  const page = await browser.newPage({ viewport: { width: 1600, height: 1200 }, bypassCSP: true });
  await page.addInitScript(drawOnPage);
  await page.addInitScript(watchFrames);
  await page.addInitScript(fixFrame, SIDE_PX);
  await page.goto(`${address}?${LINKS[phase]}`);
  await page.waitForSelector('#frame[data-state="finished"]', { timeout: 300_000 });
  const size = await page.evaluate(() => {
    const { width, height } = document.querySelector("canvas");
    return [width, height];
  });
  if (size.some((side) => side !== SIDE_PX)) throw new Error(`the canvas is ${size.join(" by ")}`);
  const frames = await page.evaluate(() => globalThis.frames_);
  await page.close();
  if (process.env.DETAIL) {
    console.error(
      frames
        .map(({ worked, phase }, i) => ({ i, worked: Math.round(worked * 10) / 10, phase }))
        .sort((a, b) => b.worked - a.worked)
        .slice(0, 12),
    );
  }
  return figures(frames.filter((frame) => (frame.phase === "growing") === (phase === "growing")));
}

/**
 * Makes the page grow rivers on its own thread, as if workers had no canvas: only there the cost of a frame can be
 * seen.
 */
function drawOnPage() {
  Reflect.deleteProperty(HTMLCanvasElement.prototype, "transferControlToOffscreen");
}

/**
 * Runs in the page: records when each frame of an animation began, the time of its callbacks, and the river's phase.
 */
function watchFrames() {
  const frames = [];
  globalThis.frames_ = frames;
  const shown = () => document.querySelector("#frame")?.dataset ?? {};
  const request = globalThis.requestAnimationFrame.bind(globalThis);
  globalThis.requestAnimationFrame = (callback) =>
    request((now) => {
      const { state, phase } = shown();
      const began = performance.now();
      callback(now);
      const worked = performance.now() - began;
      // The last frame, which finishes the river, counts as well.
      if (state === "growing" || shown().state === "growing") frames.push({ now, worked, phase: phase ?? "growing" });
    });
}

function fixFrame(side) {
  document.addEventListener("DOMContentLoaded", () => {
    const style = document.createElement("style");
    style.textContent = `.frame { width: ${side}px !important; height: ${side}px !important; }`;
    document.head.append(style);
  });
}

function figures(frames) {
  const gaps = frames.slice(1).map(({ now }, i) => now - frames[i].now);
  gaps.sort((a, b) => a - b);
  const at = (share) => gaps[Math.min(gaps.length - 1, Math.floor(share * gaps.length))];
  return {
    p50: at(0.5),
    p95: at(0.95),
    max: gaps.at(-1),
    longest: Math.max(...frames.map(({ worked }) => worked)),
    frames: frames.length,
    seconds: (frames.at(-1).now - frames[0].now) / 1000,
  };
}

function medians(runs) {
  const middle = (key) => runs.map((run) => run[key]).sort((a, b) => a - b)[Math.floor(runs.length / 2)];
  return Object.fromEntries(Object.keys(runs[0]).map((key) => [key, Number(middle(key).toFixed(2))]));
}
