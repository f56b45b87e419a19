import { readFileSync } from "node:fs";
import { expect, test } from "@playwright/test";
import { linesOf, PARTS, partOf } from "../../src/apps/digest/lines.ts";
import { core } from "./tiers.ts";

const committed = ["digest", "digest-annotated"].flatMap((name) =>
  linesOf(readFileSync(new URL(`../../../tests/${name}.txt`, import.meta.url), "utf8")),
);

// What ships has the committed bits: there is no other test of the wasm.
for (let part = 0; part < PARTS; part++)
  test(`a third of the committed recipes grow to the committed bits, from number ${part} on${core(part === 0)}`, async ({
    page,
  }) => {
    // Forty maps and more, one after the other: minutes on a machine that has other work besides.
    test.setTimeout(600_000);
    const lines = partOf(committed, `${part}`);
    expect(lines.length).toBeGreaterThanOrEqual(40);
    await page.goto(`./digest.html?part=${part}`);
    const body = page.locator("body");
    await expect(body).toHaveAttribute("data-digests", /.*/, { timeout: 580_000 });
    expect(JSON.parse((await body.getAttribute("data-digests")) ?? "")).toEqual(lines);
    await expect(page.locator("#verdict")).toHaveText(`All ${lines.length} rivers are exact.`);
  });
