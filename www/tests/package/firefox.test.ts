/** A second browser engine draws what the core draws in Node, to the pixel. FIREFOX names the browser. */

import puppeteer, { type Browser } from "puppeteer-core";
import { type PreviewServer, preview } from "vite";
import { afterAll, beforeAll, expect, test } from "vitest";
import { embeddedPictureOf } from "../core.ts";
import { pixels } from "./pixels.ts";

/** This only ends a wait for what does not come. */
const PATIENCE_MS = 60_000;

let server: PreviewServer;
let browser: Browser;

beforeAll(async () => {
  const configFile = new URL("../consumers/vite.config.ts", import.meta.url).pathname;
  server = await preview({ configFile, preview: { host: "127.0.0.1", port: 0 }, logLevel: "silent" });
  const executablePath = process.env["FIREFOX"] ?? "/usr/bin/firefox-esr";
  // Rivers at once, as a reader has them who prefers reduced motion.
  const extraPrefsFirefox = { "ui.prefersReducedMotion": 1 };
  browser = await puppeteer.launch({ browser: "firefox", executablePath, headless: true, extraPrefsFirefox });
});

afterAll(async () => {
  await browser?.close();
  await server?.close();
});

for (const program of ["vite", "blog"]) {
  test(`Firefox draws the river of ${program}`, async () => {
    const page = await browser.newPage();
    await page.goto(`${server.resolvedUrls?.local[0]}${program}/`);
    // Where nothing can hover, the button that replays stands in the picture.
    await page.addStyleTag({ content: "river-seed::part(button) { display: none !important }" });
    const river = await page.waitForSelector("river-seed");
    await expect
      .poll(
        async () => {
          const png = await river?.screenshot({ encoding: "base64" });
          const { width, height, sha256 } = await page.evaluate(pixels, png ?? "");
          return sha256 === embeddedPictureOf("seed=kauri&attractors=300&width=20", width, height).sha256;
        },
        { timeout: PATIENCE_MS },
      )
      .toBe(true);
    await page.close();
  });
}
