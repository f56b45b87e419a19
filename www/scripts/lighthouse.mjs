#!/usr/bin/env node
// Checks the built site with Lighthouse, on a phone and on a desktop: all checks of accessibility, best practices and
// search engines must pass, and almost nothing may shift.
//
//   node scripts/lighthouse.mjs            fails if a check fails
//   node scripts/lighthouse.mjs figures    prints the page's performance instead, the median of five, as JSON on one line:
//                                          {"mobile", "desktop"}
//
// The site must have been built (npm run build). CHROME names the browser.

import puppeteer from "puppeteer-core";
import { preview } from "vite";

const PAGES = ["", "gallery/", "gallery/skye.html", "docs/for/novelists.html"];
const GATES = ["accessibility", "best-practices", "seo"];
/** The most layout shift. Lighthouse calls a tenth good. */
const MOST_SHIFT = 0.02;
const RUNS = 5;

const { lighthouse, desktop } = await loaded();
if (lighthouse) await withSite(process.argv[2] === "figures" ? figures : gates);

/** Loads Lighthouse, or nothing if it is not installed. */
async function loaded() {
  try {
    const { default: lighthouse, desktopConfig: desktop } = await import("lighthouse");
    return { lighthouse, desktop };
  } catch (error) {
    console.log(`Lighthouse is left out: it is not installed here (${error.code ?? error.message}).`);
    return {};
  }
}

async function withSite(measure) {
  const server = await preview({ preview: { host: "127.0.0.1", port: 0 }, logLevel: "silent" });
  const browser = await puppeteer.launch({
    executablePath: process.env.CHROME || "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking"],
  });
  try {
    const { port } = new URL(browser.wsEndpoint());
    await measure(server.resolvedUrls.local[0], Number(port));
  } finally {
    await browser.close();
    await new Promise((done) => server.httpServer.close(done));
  }
}

async function gates(address, port) {
  for (const path of PAGES)
    for (const [form, config] of forms()) {
      const report = await reportOf(address + path, port, [...GATES, "performance"], config);
      for (const category of GATES) judge(report, category, `${path || "the page"}, ${form}`);
      const shift = report.audits["cumulative-layout-shift"].numericValue;
      if (!(shift <= MOST_SHIFT)) fault(`${path || "the page"}, ${form}: layout shift ${shift}, at most ${MOST_SHIFT}`);
      console.log(`  ${path || "the page"}, ${form}: layout shift ${shift.toFixed(3)}`);
    }
}

function judge(report, category, where) {
  const { score, auditRefs } = report.categories[category];
  if (score === 1) return;
  const wrong = auditRefs.map(({ id }) => report.audits[id]).filter(({ score }) => score !== null && score < 1);
  fault(
    `${where}: ${category} ${score}: ${wrong.map(({ id, displayValue = "" }) => `${id} ${displayValue}`).join(", ")}`,
  );
}

function fault(text) {
  console.error(text);
  process.exitCode = 1;
}

async function figures(address, port) {
  const found = {};
  for (const [form, config] of forms()) {
    const scores = [];
    for (let run = 0; run < RUNS; run++)
      scores.push((await reportOf(address, port, ["performance"], config)).categories.performance.score * 100);
    found[form] = scores.sort((a, b) => a - b)[Math.floor(RUNS / 2)];
  }
  console.log(JSON.stringify(found));
}

function forms() {
  return [
    ["mobile", undefined],
    ["desktop", desktop],
  ];
}

async function reportOf(url, port, onlyCategories, config) {
  const result = await lighthouse(url, { port, onlyCategories, logLevel: "error" }, config);
  if (!result || result.lhr.runtimeError)
    throw new Error(`${url}: ${result?.lhr.runtimeError?.message ?? "no report"}`);
  return result.lhr;
}
