#!/usr/bin/env node
// Tests the built page in a second browser engine: a river grows to its end without warnings, and every recipe of
// tests/digest.txt and tests/digest-annotated.txt gives the committed bits.
//
// The page must have been built (npm run build). FIREFOX names the browser.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import puppeteer from "puppeteer-core";
import { preview } from "vite";

const PATIENCE_MS = 300_000;

const server = await preview({ preview: { host: "127.0.0.1", port: 0 }, logLevel: "silent" });
const address = server.resolvedUrls.local[0];
const browser = await puppeteer.launch({
  browser: "firefox",
  executablePath: process.env.FIREFOX ?? "/usr/bin/firefox-esr",
  headless: true,
});
console.log(await browser.version());
try {
  await growsToTheEnd();
  await changesAndKeepsItsAddress();
  await followsAFragment();
  await isExact();
} finally {
  await browser.close();
  await new Promise((done) => server.httpServer.close(done));
}

async function open(path) {
  const page = await browser.newPage();
  page.setDefaultTimeout(PATIENCE_MS);
  const complaints = [];
  page.on("pageerror", (error) => complaints.push(String(error)));
  page.on("console", (message) => {
    if (["error", "warn"].includes(message.type())) complaints.push(message.text());
  });
  await page.goto(address + path);
  return { page, complaints };
}

async function growsToTheEnd() {
  const { page, complaints } = await open("?seed=kauri&growth=colonize&attractors=1000");
  await page.waitForSelector('#frame[data-state="finished"]');
  await page.click("#play");
  await page.waitForSelector('#frame[data-state="growing"]');
  await page.waitForSelector('#frame[data-state="finished"]');
  const colours = await page.$eval("canvas", (canvas) => {
    // A copy is read, since a canvas that was handed to a worker gives no context.
    const { width, height } = canvas;
    const context = Object.assign(document.createElement("canvas"), { width, height }).getContext("2d");
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, width, height);
    return new Set(new Uint32Array(data.buffer)).size;
  });
  assert.ok(colours > 10, `the canvas has ${colours} colours`);
  assert.match(await page.$eval("#canvas", (canvas) => canvas.ariaLabel), /8 rivers, \d+ sources/);
  assert.deepEqual(complaints, []);
  await page.close();
  console.log("  a river grows to its end");
}

async function changesAndKeepsItsAddress() {
  const { page, complaints } = await open("?seed=kauri&growth=colonize&attractors=300&curl=0");
  await page.waitForSelector("#shape:not([disabled])");
  await page.click("#shape");
  await page.click(".settings > summary");
  await page.click(".settings .group:has(#field-curl) > summary");
  await page.focus("#field-curl");
  for (let i = 0; i < 5; i++) await page.keyboard.press("ArrowRight");
  await page.waitForFunction(() => new URLSearchParams(location.search).get("curl") === "0.5");
  await page.waitForSelector('#frame[data-state="finished"]');
  assert.deepEqual(complaints, []);
  await page.close();
  console.log("  a slider changes it and the address follows");
}

async function followsAFragment() {
  const { page, complaints } = await open("?seed=kauri&attractors=300&labels=none");
  await page.waitForSelector('#frame[data-state="finished"]');
  await page.evaluate(() => {
    location.hash = "seed=rimu&attractors=300&labels=none";
  });
  await page.waitForFunction(() => document.querySelector("#title").textContent === "rimu");
  await page.waitForFunction(() => location.hash === "" && location.search.includes("rimu"));
  assert.deepEqual(complaints, []);
  await page.close();
  console.log("  a link in the fragment is opened");
}

async function isExact() {
  const { page, complaints } = await open("digest.html");
  await page.waitForSelector("body[data-digests]");
  const grown = JSON.parse(await page.$eval("body", (body) => body.dataset.digests));
  const committed = ["digest", "digest-annotated"].flatMap((name) =>
    readFileSync(new URL(`../../tests/${name}.txt`, import.meta.url), "utf8")
      .split("\n")
      .filter((line) => line !== "" && !line.startsWith("#")),
  );
  assert.ok(committed.length >= 50, `the files of digests hold only ${committed.length} recipes`);
  assert.deepEqual(
    grown.map(({ digest, link }) => `${digest} ${link}`),
    committed,
  );
  assert.deepEqual(complaints, []);
  await page.close();
  console.log(`  ${committed.length} digests are exact`);
}
