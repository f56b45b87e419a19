import { expect, type Page, test } from "@playwright/test";
import { dealOf, type Is, resultLine } from "../../src/apps/study/daily.ts";
import { violations } from "./axe.ts";
import { complaints, fixChance } from "./riverpage.ts";
import { core } from "./tiers.ts";

const DATE = "2026-11-25";

/** Opens the page at noon of a day. */
async function open(page: Page, date = DATE): Promise<void> {
  await page.clock.setFixedTime(`${date}T12:00:00Z`);
  await page.goto("./real-or-grown.html");
}

async function answer(page: Page, said: Is, round: number, rounds: number): Promise<void> {
  await expect(page.locator("#count")).toHaveText(`${round} of ${rounds}`);
  await page.getByRole("button", { name: said === "real" ? "Real" : "Grown", exact: true }).click();
  await expect(page.locator("#verdict")).toHaveText(/^(Right|No): (grown from \w+ by .*|real, .*km across)\.$/);
  const next = page.getByRole("button", { name: round === rounds ? "How it went" : "Next" });
  await expect(next).toBeFocused();
  await page.keyboard.press("Enter");
}

async function play(page: Page, said: readonly Is[], rounds = said.length): Promise<void> {
  for (const [i, one] of said.entries()) await answer(page, one, i + 1, rounds);
}

/** What the page says of its pieces, once all have come. */
async function told(page: Page, rounds: number): Promise<string[]> {
  await expect(page.locator("#end li")).toHaveCount(rounds);
  return page.locator("#end li").allTextContents();
}

test("the five of a day end in a line to paste, are the same for everybody and are played once @core", async ({
  page,
  context,
  browser,
}) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  const complained = complaints(page);
  await open(page);
  const said: Is[] = ["real", "grown", "real", "grown", "real"];
  await play(page, said);
  await expect(page.locator("#end h2")).toBeFocused();
  // How long real pieces are does not decide which pieces are real; how many there are does.
  const isRight = dealOf(DATE, Array(REAL).fill(500)).map(({ is }, i) => is === said[i]);
  const line = resultLine(DATE, isRight, new URL("./real-or-grown.html", page.url()).href);
  await expect(page.locator("#line")).toHaveText(line);
  await page.getByRole("button", { name: "Copy this line" }).click();
  await expect(page.getByText("Copied.")).toBeVisible();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(line);
  const pieces = await told(page, 5);
  expect(pieces.map((one) => one.startsWith("Right"))).toEqual(isRight);

  await page.reload();
  await expect(page.locator("#line")).toHaveText(line);
  expect(await told(page, 5)).toEqual(pieces);

  const other = await browser.newPage();
  await open(other);
  await play(other, Array(5).fill("real"));
  const whatItWas = (one: string): string => one.replace(/^(Right|No): /, "").replace(/\. What gave .*/, ".");
  expect((await told(other, 5)).map(whatItWas)).toEqual(pieces.map(whatItWas));
  await other.close();

  await open(page, "2026-11-26");
  await expect(page.locator("#count")).toHaveText("1 of 5");
  expect(complained).toEqual([]);
});

/** The number of real pieces that are as grown ones could be. */
const REAL = 32;

test("a day's game goes on after a reload, and after another game", async ({ page }) => {
  await open(page);
  await play(page, ["real", "grown"], 5);
  await expect(page.locator("#count")).toHaveText("3 of 5");
  await page.reload();
  await expect(page.locator("#count")).toHaveText("3 of 5");
  await page.getByRole("button", { name: "Ten at random" }).click();
  await answer(page, "real", 1, 10);
  await page.getByRole("button", { name: "Today’s five" }).click();
  await answer(page, "real", 3, 5);
  await expect(page.locator("#count")).toHaveText("4 of 5");
});

for (const colorScheme of ["light", "dark"] as const)
  test(`a reader tells ten pieces of river apart, and sees what passed for real: ${colorScheme}${core(colorScheme === "dark")}`, async ({
    page,
  }) => {
    await page.emulateMedia({ colorScheme });
    await page.setViewportSize({ width: 320, height: 640 });
    const complained = complaints(page);
    await fixChance(page);
    await open(page);
    await page.getByRole("button", { name: "Ten at random" }).click();
    await expect(page.getByRole("button", { name: "Grown", exact: true })).toBeEnabled();
    expect(await violations(page)).toEqual([]);
    const asked: string[] = [];
    page.on("request", (request) => asked.push(request.url()));
    await play(page, Array(10).fill("grown"));
    const right = (await told(page, 10)).filter((one) => one.startsWith("Right"));
    for (const one of right) expect(one).toContain("What gave it away: ");
    await expect(page.locator("#line")).toHaveCount(0);
    await expect(page.locator("caption")).toContainText(`${right.length} of 10 right`);
    const row = page.getByRole("row", { name: "Real rivers" });
    await expect(row).toContainText(`0 of ${10 - right.length}, ${10 - right.length} doubted`);
    await expect(page.getByRole("row")).toHaveCount(9);
    expect(await violations(page)).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(320);

    await page.getByRole("button", { name: "Reset these counts" }).click();
    await expect(page.locator("#passed")).toBeHidden();
    await page.getByRole("button", { name: "Ten more" }).click();
    await expect(page.locator("#count")).toHaveText("1 of 10");
    await expect(page.getByRole("button", { name: "Real", exact: true })).toBeFocused();
    expect(asked).toEqual([]);
    expect(complained).toEqual([]);
  });

test("a line that cannot be copied is selected", async ({ page }) => {
  await page.addInitScript(() => Reflect.deleteProperty(Navigator.prototype, "clipboard"));
  await open(page);
  await play(page, Array(5).fill("grown"));
  await page.getByRole("button", { name: "Copy this line" }).click();
  await expect(page.locator("#end [role=status]")).toContainText("selected");
  expect(await page.evaluate(() => getSelection()?.toString())).toBe(await page.locator("#line").textContent());
});

test("junk in the storage, or none at all, leaves the game as it is", async ({ page }) => {
  const complained = complaints(page);
  await page.addInitScript(() => {
    localStorage.setItem("riverseed study", '{"real":{"shown":1e300,"passed":-1},"curl":[]}');
    localStorage.setItem("riverseed daily five", "2026-11-25 <script>");
  });
  await open(page);
  await answer(page, "real", 1, 5);
  await page.addInitScript(() => {
    Object.defineProperty(globalThis, "localStorage", {
      get: () => {
        throw new DOMException("denied", "SecurityError");
      },
    });
  });
  await open(page);
  await play(page, Array(5).fill("real"));
  await expect(page.locator("#line")).toBeVisible();
  await expect(page.locator("#passed")).toBeHidden();
  expect(complained).toEqual([]);
});

test("without the engine the page says that nothing can be grown", async ({ page }) => {
  await page.route("**/*.wasm", (route) => route.abort());
  await open(page);
  await expect(page.locator("#count")).toHaveText("No rivers could be grown here. Please load the page again.");
  await expect(page.getByRole("button", { name: "Real", exact: true })).toBeDisabled();
});
