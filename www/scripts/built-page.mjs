// Serves the built page (npm run build) on a free port and opens a browser for it, for measurements.

import { chromium } from "@playwright/test";
import { preview } from "vite";

/** Options that turn off things that would take processor time beside the page. */
const QUIET = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking"];

/** Launches the browser that CHROME names. */
export const launchBrowser = () =>
  chromium.launch({ executablePath: process.env.CHROME ?? "/usr/bin/chromium", args: QUIET });

/** Calls a function with a browser and the page's address, and prints its result as JSON on one line. */
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
