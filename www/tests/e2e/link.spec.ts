import { expect, test } from "@playwright/test";
import { WRITE_EVERY_MS } from "../../src/browser/address.ts";
import { engine, pictureOf } from "../core.ts";
import { table } from "../table.ts";
import {
  address,
  countCalls,
  expectAddress,
  expectPictureOfAddress,
  finished,
  fixChance,
  openFinished,
  openUnfolded,
  ownClock,
  STOPPED_AT_MS,
  shown,
  stopClock,
} from "./riverpage.ts";
import { core } from "./tiers.ts";

for (const link of [
  "seed=kauri",
  "seed=wai%20%26%20roto&preset=trimmed-curl&sides=nw&mouths=5&attractors=900",
  "seed=kea&style=skeleton&preset=momentum&attractors=900&aspect=0.7",
  "land=archipelago&attractors=900&sea=0.6",
]) {
  test(`opening ?${link} shows the picture that the River class draws${core(link === "seed=kauri")}`, async ({
    page,
  }) => {
    await openFinished(page, link);
    const { width, height, framing } = await shown(page);
    const expected = pictureOf(link, width, height, framing);
    await expect.poll(async () => (await shown(page)).sha256).toBe(expected.sha256);
    await expect(page.getByRole("img", { name: `${expected.summary.sources} sources` })).toBeVisible();
    expect(new URL(page.url()).search.slice(1)).toBe(engine.readLink(link).link);
    await expect(page.locator("#notices")).toBeHidden();
  });
}

test("a slider that is dragged makes one entry of the history, and writes at a bounded rate @core", async ({
  page,
}) => {
  await page.addInitScript(() => {
    const writes: number[] = [];
    Object.assign(globalThis, { writes });
    for (const name of ["replaceState", "pushState"] as const) {
      const write = history[name].bind(history);
      history[name] = (...given) => {
        writes.push(performance.now());
        write(...given);
      };
    }
  });
  await ownClock(page);
  await openUnfolded(page, "seed=kauri&country=usual&growth=colonize&attractors=200&style=ink&labels=none");
  await stopClock(page);
  const before = await page.evaluate(() => history.length);
  await page.getByRole("slider", { name: "How much sea" }).focus();
  for (let i = 0; i < 40; i++) {
    await page.keyboard.press("ArrowLeft");
    await page.clock.runFor(WRITE_EVERY_MS / 10);
  }
  await page.clock.runFor(WRITE_EVERY_MS);
  // From the island's own sea, which it has automatically.
  await expectAddress(page, "sea", "0.32");
  expect(await page.evaluate(() => history.length)).toBe(before + 1);
  const writes = await page.evaluate(() => (globalThis as unknown as { writes: number[] }).writes);
  const pauses = writes.slice(1).map((time, i) => time - (writes[i] ?? 0));
  expect(Math.min(...pauses)).toBeGreaterThanOrEqual(WRITE_EVERY_MS);
  expect(writes.filter((time) => time >= STOPPED_AT_MS).length).toBeGreaterThan(3);
});

test("loading the address bar's link again shows the same picture", async ({ page }) => {
  await fixChance(page);
  await openUnfolded(page, "attractors=300");
  await page.getByRole("button", { name: "A new seed by chance" }).click();
  await page.getByRole("button", { name: "Trimmed curl" }).click();
  await expectAddress(page, "trim", "29");
  await expectPictureOfAddress(page);
  const before = await shown(page);
  await page.reload();
  await expectPictureOfAddress(page);
  expect(await shown(page)).toEqual(before);
});

test("what had to be corrected in a link is shown, can be dismissed, and a river is there @core", async ({ page }) => {
  await openFinished(page, "curl=99&mouths=junk&depth=3&seed=rimu&attractors=300");
  const notes = page.locator("#notices");
  await expect(notes.getByRole("listitem")).toHaveCount(3);
  await expect(notes).toContainText("curl: 99 is not between 0 and 2: 2 is used");
  await expect(notes).toContainText("depth");
  const { width, height, sha256, framing } = await shown(page);
  expect(sha256).toBe(pictureOf("seed=rimu&curl=2&attractors=300", width, height, framing).sha256);
  await notes.getByRole("button", { name: "Dismiss" }).click();
  await expect(notes).toBeHidden();
});

test("what a social network hangs on to a link is not reported, and not kept", async ({ page }) => {
  await openFinished(page, "fbclid=IwAR0xyz&seed=rimu&attractors=300&utm_source=facebook&utm_medium=social");
  await expect(page.locator("#notices")).toBeHidden();
  await expectAddress(page, "fbclid", null);
  expect(address(page).get("seed")).toBe("rimu");
  await page.goto("./embed.html?seed=rimu&attractors=300&fbclid=IwAR0xyz&gclid=1#utm_source=facebook");
  await expect(page.locator("html")).toHaveAttribute("data-state", "ready");
  await expect(page.locator(".corrected")).toHaveCount(0);
});

test("hostile text stays text @core", async ({ page }) => {
  const evil = `<img src=x onerror="globalThis.harmed=1"><script>globalThis.harmed=1</script>`;
  const query = new URLSearchParams({
    seed: evil.slice(0, 60),
    [evil]: "1",
    style: evil,
    labels: "none",
    attractors: "300",
  });
  await openFinished(page, query.toString());
  await expect(page.locator("#title")).toHaveText(evil.slice(0, 60));
  await expect(page.locator("#notices")).toContainText("<img src=x");
  await expect(page.locator("img[src=x], body script")).toHaveCount(0);
  expect(await page.evaluate(() => "harmed" in globalThis)).toBe(false);
});

for (const [name, query] of [
  ["an endless link", `attractors=300&seed=${"x".repeat(6000)}`],
  ["broken escapes", "seed=%FF%FE&%=%&&&==&attractors=300&curl=%"],
  ["half a surrogate", "attractors=300&seed=%ED%A0%80"],
  ["everything at its smallest", smallest()],
] as const) {
  test(`${name} leaves no blank page${core(name === "broken escapes")}`, async ({ page }) => {
    await openFinished(page, query);
    await expect(page.locator("#failure")).toBeHidden();
    await expect(page.getByRole("img", { name: "Strahler order" })).toBeVisible();
  });
}

function smallest(): string {
  const values = table.parameters.flatMap(({ key, min }) => (min === undefined ? [] : [[key, String(min)]]));
  return new URLSearchParams(values).toString();
}

test("a link in the fragment, and going back, change the picture without a reload @core", async ({ page }) => {
  await openFinished(page, "seed=first&attractors=300&style=ink&labels=none");
  const first = await shown(page);
  await page.evaluate(() => {
    location.hash = "seed=second&attractors=300&style=ink&labels=none";
  });
  await expect(page.locator("#title")).toHaveText("second");
  await finished(page);
  await expect(page.getByLabel("Seed", { exact: true })).toHaveValue("second");
  await expect.poll(() => new URL(page.url()).hash).toBe("");
  await page.goBack();
  await expect(page.locator("#title")).toHaveText("first");
  // The title changes at once, the viewport with the next frame: until then it is still "finished" with the other river.
  await expect.poll(() => shown(page)).toEqual(first);
});

for (const link of ["land=archipelago&growth=brownian", "seed=kea&land=island&attractors=300"]) {
  test(`a link in the fragment, #${link}, shows what the same link as a query does`, async ({ page }) => {
    await page.emulateMedia({ reducedMotion: "reduce" });
    await page.goto(`./#${link}`);
    await finished(page);
    const { width, height, sha256, framing } = await shown(page);
    const expected = pictureOf(link, width, height, framing);
    expect(sha256).toBe(expected.sha256);
    await expect(page.getByRole("img", { name: `${expected.summary.mouths} rivers` })).toBeVisible();
    expect(new URL(page.url()).hash).toBe("");
    expect(new URL(page.url()).search.slice(1)).toBe(engine.readLink(link).link);
  });
}

test("a link in the fragment is opened once, however soon after another change", async ({ page }) => {
  const readings = await countCalls(page, "readLink");
  await openFinished(page, "attractors=300");
  await page.evaluate(() => {
    window.addEventListener("hashchange", () => {
      document.body.dataset["followed"] = "yes";
    });
  });
  for (const seed of ["first", "second", "third"]) {
    const { onPage: before } = await readings();
    // A canonical link would not be read again.
    const hash = `attractors=300&seed=${seed}&curl=0.50`;
    await page.evaluate((hash) => {
      location.hash = hash;
    }, hash);
    await expect(page.locator("body")).toHaveAttribute("data-followed", "yes");
    // The country's name, once the map is finished.
    await expect(page.locator("#title")).toHaveText(seed, { ignoreCase: true });
    expect((await readings()).onPage - before).toBe(1);
    await page.locator("body").evaluate((body) => body.removeAttribute("data-followed"));
  }
});

test("a key copies the whole address of what is shown, at once", async ({ page, context }) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await openUnfolded(page, "seed=kowhai&attractors=300&style=ink&labels=none");
  await page.getByRole("button", { name: "Momentum", exact: true }).click();
  await page.keyboard.press("l");
  await expect(page.locator("#shared")).toHaveText("Link copied.");
  const copied = new URL(await page.evaluate(() => navigator.clipboard.readText()));
  expect(copied.searchParams.get("momentum")).not.toBeNull();
  expect(copied.search).toBe(`?${address(page)}`);
});

test("where copying is refused the link is shown instead", async ({ page }) => {
  await page.addInitScript(() => {
    Object.defineProperty(navigator, "clipboard", { value: undefined });
  });
  await openFinished(page, "seed=kowhai&attractors=300&style=ink&labels=none");
  await page.keyboard.press("l");
  await expect(page.locator("#shared")).toContainText("seed=kowhai");
});
