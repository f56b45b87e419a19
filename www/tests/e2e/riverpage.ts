/** What every browser test does with the page. */

import { expect, type Page } from "@playwright/test";
import type { Framing } from "../../src/browser/canvas.ts";
import { pictureOf } from "../core.ts";
import { type Pixels, pixelsOf } from "./pixels.ts";

/** Gives the page a clock that can be stopped. A worker has one of its own, so the page draws itself. Call before `goto`. */
export async function ownClock(page: Page): Promise<void> {
  await drawOnPage(page);
  await page.clock.install({ time: 0 });
}

/** Has the page grow and paint its rivers itself, as in browsers that give workers no canvas. Call before `goto`. */
export async function drawOnPage(page: Page): Promise<void> {
  await page.addInitScript(() => Reflect.deleteProperty(HTMLCanvasElement.prototype, "transferControlToOffscreen"));
}

/** Scripts that run in the page's worker before its own. */
const early = new WeakMap<Page, string[]>();

/** Runs a function in the page, and in its worker, before their own scripts. Call before `goto`. */
export async function beforehand<Given>(page: Page, work: (given: Given) => void, given: Given): Promise<void> {
  // biome-ignore lint/suspicious/noExplicitAny: Playwright's own type is of what it can send
  await page.addInitScript(work as any, given);
  const scripts = early.get(page) ?? [];
  scripts.push(`(${work})(${JSON.stringify(given)});`);
  if (early.has(page)) return;
  early.set(page, scripts);
  await page.route(WORKER, async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, body: `${scripts.join("\n")}\n${await response.text()}` });
  });
}

/** The script of the page's worker. */
export const WORKER = /\/assets\/page-worker-[^/]*\.js$/;

/** Asks the page and its workers the same. */
export function everywhere<Given, Said>(page: Page, ask: (given: Given) => Said, given: Given): Promise<Said[]> {
  const places = [page, ...page.workers()] as { evaluate(ask: (given: Given) => Said, given: Given): Promise<Said> }[];
  return Promise.all(places.map((place) => place.evaluate(ask, given)));
}

/** Stops the page's own clock: from now on frames and timers come when a test asks for them, by `page.clock.runFor`. */
export async function stopClock(page: Page): Promise<void> {
  await page.clock.pauseAt(STOPPED_AT_MS);
}

/** Later than any page is open while its clock runs. */
export const STOPPED_AT_MS = 3_600_000;

/** The day on which tests visit the page, unless they say another: the one that has a poster. */
const USUAL_DAY = "2026-01-01T12:00";

/** Makes it a day, at any time of which a date is asked for. Call before `goto`. */
export async function onDay(page: Page, day = USUAL_DAY): Promise<void> {
  await page.addInitScript((now) => {
    const Real = Date;
    globalThis.Date = class extends Real {
      constructor(...given: [] | [number]) {
        super(...(given.length === 0 ? ([now] as unknown as [number]) : given));
      }
    } as DateConstructor;
  }, day);
}

/** Opens a link whose first map is not there yet: the page's clock is stopped. */
export async function openBegun(page: Page, link = ""): Promise<void> {
  await ownClock(page);
  await stopClock(page);
  await page.goto(link === "" ? "./" : `./?${link}`);
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "settling");
}

/** Opens a link and has its finished map grow again, which then stands at its start: the page's clock is stopped. */
export async function openStopped(page: Page, link = ""): Promise<void> {
  await ownClock(page);
  if (link === "") await onDay(page);
  await page.goto(link === "" ? "./" : `./?${link}`);
  await finished(page);
  await stopClock(page);
  await page.getByRole("button", { name: "Replay" }).click();
  await expect(page.locator("#frame")).toHaveAttribute("data-state", "growing");
}

/** Lets the stopped clock run until the river is in a phase. */
export async function runUntil(page: Page, phase: string): Promise<void> {
  while ((await page.locator("#frame").getAttribute("data-phase")) !== phase) await page.clock.runFor(100);
}

/** In place of the system's chance, for seeds that are the same in every run. Call before `goto`. */
export async function fixChance(page: Page): Promise<void> {
  await page.addInitScript(() => {
    let state = 1;
    crypto.getRandomValues = <T extends ArrayBufferView>(array: T): T => {
      const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
      // The usual linear congruential generator; its upper bits are the better ones.
      for (const i of bytes.keys()) {
        state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
        bytes[i] = state >>> 24;
      }
      return array;
    };
  });
}

/** Opens a link and waits for its finished river, without animation. */
export async function openFinished(page: Page, link = ""): Promise<void> {
  await page.emulateMedia({ reducedMotion: "reduce" });
  if (link === "") await onDay(page);
  await page.goto(link === "" ? "./" : `./?${link}`);
  await finished(page);
}

/** Shows all of the map: a phone shows the land of a wide one first. */
export async function showAll(page: Page): Promise<void> {
  const all = page.getByRole("button", { name: "Show all of the map" });
  if (await all.isVisible()) await all.click();
}

/** Opens a link with its finished river and the panel. */
export async function openWithPanel(page: Page, link = ""): Promise<void> {
  await openFinished(page, link);
  await openPanel(page);
}

export async function openPanel(page: Page): Promise<void> {
  const button = page.getByRole("button", { name: "Shape…" });
  if ((await button.getAttribute("aria-expanded")) === "false") await button.click();
}

/** Opens the panel, and in it one of its doors or headings, unless it is open. */
export async function openFold(page: Page, name: string): Promise<void> {
  await openPanel(page);
  const fold = page.locator("details.group").filter({ has: page.locator(`:scope > summary :text-is("${name}")`) });
  if ((await fold.getAttribute("open")) === null) await fold.locator(":scope > summary").click();
}

/** Opens the panel and All settings in it. */
export async function openSettings(page: Page): Promise<void> {
  await openFold(page, "All settings");
}

/** Shows all kinds of country. */
export async function showCountries(page: Page): Promise<void> {
  await openPanel(page);
  await page.getByRole("button", { name: "More countries" }).click();
}

/** The same with every group of controls unfolded and those without effect shown, once the map is painted beside the panel. */
export async function openUnfolded(page: Page, link = ""): Promise<void> {
  await openFinished(page, link);
  await unfold(page);
  await painted(page);
}

/** At once: click by click it would be longer than what most tests do then. Clicks are the subject of `folds.spec.ts`. */
export async function unfold(page: Page): Promise<void> {
  await openPanel(page);
  await page.locator("details:not([open]):is(.group, .more)").evaluateAll(async (folded) => {
    const opened = (details: Element): Promise<Event> =>
      new Promise((done) => {
        details.addEventListener("toggle", done, { once: true });
        details.setAttribute("open", "");
      });
    await Promise.all(folded.map(opened));
  });
  await page.locator("#show-idle").evaluate((box: HTMLInputElement) => {
    if (!box.checked) box.click();
  });
}

/** Waits until the rivers that were asked for last are finished. */
export async function finished(page: Page): Promise<void> {
  await expect(page.locator("#frame:not([data-pending])")).toHaveAttribute("data-state", "finished");
}

export interface Shown extends Pixels {
  /** What part of the map that is. */
  framing: Framing;
}

/** The canvas's bytes as they are. */
export async function shown(page: Page): Promise<Shown> {
  const pixels = await pixelsOf(page.locator("#canvas"));
  return { ...pixels, framing: await framing(page) };
}

/** What part of the map is shown. */
export async function framing(page: Page): Promise<Framing> {
  const numbers = (await page.locator("#frame").getAttribute("data-framing"))?.split(" ").map(Number);
  return numbers as unknown as Framing;
}

/** The link in the address bar, as it is now. */
export function address(page: Page): URLSearchParams {
  return new URL(page.url()).searchParams;
}

/** Waits until the address bar has a value (or has left it out). It is written with a delay. */
export async function expectAddress(page: Page, key: string, value: string | null): Promise<void> {
  await expect.poll(() => address(page).get(key), { intervals: [50] }).toBe(value);
}

/** Keeps the page out of full screen, in which a window could not be made another size. Call before `goto`. */
export async function neverFullScreen(page: Page): Promise<void> {
  await page.addInitScript(() => Reflect.deleteProperty(Element.prototype, "requestFullscreen"));
}

/** Makes the window another size, and waits until the map is painted for it. */
export async function resize(page: Page, width: number, height: number): Promise<void> {
  await page.setViewportSize({ width, height });
  // The page hears of it with the next frame.
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  if (await page.locator("#map-place").isVisible()) await painted(page);
}

/** Waits until the map is painted for where it lies: what moves it, as a panel that opens, moves the old picture at first. */
async function painted(page: Page): Promise<void> {
  await expect.poll(() => page.locator("#canvas").evaluate((canvas) => canvas.style.transform)).toBe("");
}

/** The picture on the page is the one its address promises, drawn by the core alone. */
export async function expectPictureOfAddress(page: Page): Promise<void> {
  await finished(page);
  await painted(page);
  await expect
    .poll(async () => {
      const { width, height, sha256, framing } = await shown(page);
      return sha256 === pictureOf(address(page).toString(), width, height, framing).sha256;
    })
    .toBe(true);
}

/** Notes every state the viewport goes through, from the first. Call before `goto`. */
export function recordStates(page: Page): Promise<() => Promise<string[]>> {
  return record(page, "state");
}

/** Notes every phase of a river that the viewport shows, from the first. Call before `goto`. */
export function recordPhases(page: Page): Promise<() => Promise<string[]>> {
  return record(page, "phase");
}

async function record(page: Page, what: "state" | "phase"): Promise<() => Promise<string[]>> {
  await page.addInitScript((what) => {
    const seen: string[] = [];
    Object.assign(globalThis, { [`${what}s`]: seen });
    const note = (): void => {
      const now = document.querySelector<HTMLElement>("#frame")?.dataset[what];
      if (now !== undefined && now !== seen.at(-1)) seen.push(now);
    };
    new MutationObserver(note).observe(document, { subtree: true, attributeFilter: [`data-${what}`] });
  }, what);
  return () => page.evaluate((what) => (globalThis as unknown as Record<string, string[]>)[`${what}s`] ?? [], what);
}

/** What Playwright itself says on a page that would be kept for offline. */
export const BLOCKED = "Service Worker registration blocked by Playwright";

/** Collects what the page complains about. */
export function complaints(page: Page): string[] {
  const said: string[] = [];
  page.on("pageerror", (error) => said.push(error.message));
  page.on("console", (message) => {
    const isComplaint = message.type() === "error" || message.type() === "warning";
    if (isComplaint && message.text() !== BLOCKED) said.push(message.text());
  });
  return said;
}

/** Counts the calls of a function of the engine, in the page and in its worker; of `river_paint with 0` those whose last argument is 0. Call before `goto`. */
export async function countCalls(page: Page, name: string): Promise<() => Promise<Calls>> {
  const count = (counted: string): void => {
    const [exported = "", last] = counted.split(" with ");
    const count = { calls: 0 };
    Object.assign(globalThis, { [`calls of ${counted}`]: count });
    const instantiate = WebAssembly.instantiate;
    const counting = async (...given: Parameters<typeof instantiate>) => {
      const instance = (await Reflect.apply(instantiate, WebAssembly, given)) as unknown as WebAssembly.Instance;
      const original = instance.exports[exported] as (...args: unknown[]) => unknown;
      const calling = (...args: unknown[]): unknown => {
        if (last === undefined || String(args.at(-1)) === last) count.calls += 1;
        return original(...args);
      };
      const exports = { ...instance.exports, [exported]: calling };
      return Object.create(WebAssembly.Instance.prototype, { exports: { value: exports } });
    };
    WebAssembly.instantiate = counting as unknown as typeof instantiate;
  };
  await beforehand(page, count, name);
  return async () => {
    const ask = (counted: string): number => Reflect.get(globalThis, `calls of ${counted}`).calls;
    const [onPage = 0, ...inWorkers] = await everywhere(page, ask, name);
    return { onPage, inWorker: inWorkers.reduce((sum, one) => sum + one, 0) };
  };
}

export interface Calls {
  onPage: number;
  inWorker: number;
}
