import { expect, test } from "@playwright/test";
import { complaints, finished } from "./riverpage.ts";

test("the engine is fetched once, and before its script has come", async ({ page }) => {
  const said = complaints(page);
  const asked: string[] = [];
  page.on("request", (request) => asked.push(new URL(request.url()).pathname));
  let release = (): void => {};
  const held = new Promise<void>((done) => {
    release = done;
  });
  await page.route("**/*.js", async (route) => {
    await held;
    await route.continue();
  });
  const early = page.waitForResponse("**/riverseed_page_bg*.wasm");
  await page.goto("./?attractors=300", { waitUntil: "commit" });
  await early;
  release();
  await finished(page);
  expect(asked.filter((path) => path.endsWith(".wasm"))).toHaveLength(1);
  expect(said).toEqual([]);
});

test("an embedded river fetches the engine once: its worker could not use what the document fetched early", async ({
  page,
}) => {
  const said = complaints(page);
  const asked: string[] = [];
  page.on("request", (request) => asked.push(new URL(request.url()).pathname));
  await page.goto("./embed.html?attractors=300");
  await expect(page.locator("html")).toHaveAttribute("data-state", "ready");
  expect(asked.filter((path) => path.endsWith(".wasm"))).toHaveLength(1);
  expect(said).toEqual([]);
});
