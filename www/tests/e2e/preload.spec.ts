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
  const early = page.waitForResponse("**/riverseed_bg*.wasm");
  await page.goto("./?attractors=300", { waitUntil: "commit" });
  await early;
  release();
  await finished(page);
  expect(asked.filter((path) => path.endsWith(".wasm"))).toHaveLength(1);
  expect(said).toEqual([]);
});
