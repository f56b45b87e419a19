// The built page (npm run build), served on a free port, and a browser for it: what figures are taken of.

import { chromium } from "@playwright/test";
import { preview } from "vite";

/** Without what would take processor time beside the page. */
const QUIET = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking"];

/** CHROME names the browser. */
export const launchBrowser = () =>
  chromium.launch({ executablePath: process.env.CHROME ?? "/usr/bin/chromium", args: QUIET });

/** Calls a function with the page's address and a browser, and prints what comes of it as JSON on one line. */
export async function printFigures(measure) {
  const server = await preview({ preview: { host: "127.0.0.1", port: 0 }, logLevel: "silent" });
  const browser = await launchBrowser();
  try {
    console.log(JSON.stringify(await measure(browser, server.resolvedUrls.local[0])));
  } finally {
    await browser.close();
    await new Promise((done) => server.httpServer.close(done));
  }
}
