import { readFileSync } from "node:fs";
import { expect, test } from "@playwright/test";
import { linesOf } from "../../src/apps/digest/lines.ts";

const committed = ["digest", "digest-annotated"].flatMap((name) =>
  linesOf(readFileSync(new URL(`../../../tests/${name}.txt`, import.meta.url), "utf8")),
);

test("this browser grows every committed recipe to the committed bits", async ({ page }) => {
  expect(committed.length).toBeGreaterThanOrEqual(50);
  await page.goto("./digest.html");
  const body = page.locator("body");
  await expect(body).toHaveAttribute("data-digests", /.*/, { timeout: 110_000 });
  expect(JSON.parse((await body.getAttribute("data-digests")) ?? "")).toEqual(committed);
  await expect(page.locator("#verdict")).toHaveText(`All ${committed.length} rivers are exact.`);
});
