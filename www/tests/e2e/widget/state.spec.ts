import type { Page } from "@playwright/test";
import type { RiverSeed } from "../../../src/apps/widget/element.ts";
import { engine } from "../../core.ts";
import { expect, type Host, test } from "./hosts.ts";
import { canonical, expectPicture, type Heard, heard, listen, post } from "./post.ts";

const RIMU = '<river-seed seed="rimu" attractors="300" still></river-seed>';
const BELOW = '<p style="height: 5000px">A long text.</p>';
const ENGINE = "/widget/riverseed_label_bg.wasm";

async function open(page: Page, blog: Host, body: string): Promise<() => Promise<Heard[]>> {
  const events = await listen(page);
  blog.answer("/", { body: post(body) });
  await page.goto(blog.origin);
  await page.waitForFunction(() => customElements.get("river-seed"));
  return events;
}

/** What an element says of itself. */
function stateOf(page: Page): Promise<{ link: string; phase: string; sources: number | undefined }> {
  return page
    .locator("river-seed")
    .evaluate(({ link, phase, summary }: RiverSeed) => ({ link, phase, sources: summary?.sources }));
}

/** How the promise ends that an element gives once some work is done. */
function outcome(page: Page, work: string): Promise<string> {
  return page.evaluate(async (work) => {
    const river = document.querySelector("river-seed") as RiverSeed;
    const promise: Promise<{ link: string }> = Reflect.construct(Function, ["river", work])(river);
    return promise.then(
      ({ link }) => link,
      (error: Error & { code?: string }) => (error instanceof DOMException ? error.name : String(error.code)),
    );
  }, work);
}

function sourcesOf(link: string): number {
  const river = new engine.River(link);
  while (river.advance(1000));
  const { sources } = river.summary();
  river.free();
  return sources;
}

test("its state goes with the rivers from idle to finished, and the promise resolves with their link and numbers", async ({
  page,
  blog,
}) => {
  const events = await open(
    page,
    blog,
    `${BELOW}<river-seed recipe="?curl=0.70&seed=rimu&attractors=300" still></river-seed>`,
  );
  const link = canonical("seed=rimu&attractors=300");
  expect(await stateOf(page)).toEqual({
    link: "curl=0.70&seed=rimu&attractors=300",
    phase: "idle",
    sources: undefined,
  });
  const finished = outcome(page, "return river.finished");
  await page.locator("river-seed").scrollIntoViewIfNeeded();
  expect(await finished).toBe(link);
  const sources = sourcesOf(link);
  expect(await stateOf(page)).toEqual({ link, phase: "finished", sources });
  const { detail } = await heard(events, "complete");
  expect(detail).toMatchObject({ link, summary: { sources } });
});

test("it is loading while the engine comes, and growing when that is at work", async ({ page, blog }) => {
  let go: (text: string) => void = () => {};
  blog.answer("/widget/worker.js", {
    headers: { "content-type": "text/javascript" },
    body: "/**/",
    rest: new Promise((done) => {
      go = done;
    }),
  });
  await open(page, blog, '<river-seed seed="rimu" meander-rounds="400"></river-seed>');
  await expect.poll(async () => (await stateOf(page)).phase).toBe("loading");
  const seen = page.locator("river-seed").evaluate(async (river: RiverSeed) => {
    const phases = new Set<string>();
    river.addEventListener("progress", ({ detail }) => detail.phase === river.phase && phases.add(river.phase));
    await new Promise((done) => river.addEventListener("ready", done, { once: true }));
    return [...phases];
  });
  blog.forget("/widget/worker.js");
  go(`import "./worker.js?again"`);
  expect(await seen).not.toContain("loading");
  await expect.poll(async () => (await stateOf(page)).phase).toBe("growing");
});

test("it says that it is paused, by a script, by the reader or at a share, and no more when it goes on", async ({
  page,
  blog,
}) => {
  const events = await open(page, blog, '<river-seed seed="rimu" meander-rounds="400"></river-seed>');
  const isPaused = (): Promise<boolean> => page.locator("river-seed").evaluate((river: RiverSeed) => river.paused);
  const change = (work: (river: RiverSeed) => void): Promise<void> => page.locator("river-seed").evaluate(work);
  const button = page.getByRole("button");
  await heard(events, "ready");
  expect(await isPaused()).toBe(false);
  await change((river) => river.pause());
  await expect.poll(isPaused).toBe(true);
  await button.click();
  await expect.poll(isPaused).toBe(false);
  await button.click();
  await expect.poll(isPaused).toBe(true);
  await change((river) => river.play());
  await expect.poll(isPaused).toBe(false);
  await change((river) => river.seek(0.2));
  await expect.poll(isPaused).toBe(true);
  await change((river) => river.restart());
  await expect.poll(isPaused).toBe(false);
  await change((river) => river.pause());
  await expect.poll(isPaused).toBe(true);
  expect(
    await page.locator("river-seed").evaluate((river: RiverSeed) => {
      river.seed = "kauri";
      return river.paused;
    }),
  ).toBe(false);
});

test("in the turn in which attributes change, state and promise are of the new rivers", async ({ page, blog }) => {
  await open(page, blog, RIMU);
  await outcome(page, "return river.finished");
  const said = await page.locator("river-seed").evaluate((river: RiverSeed) => {
    river.seed = "kauri";
    const { link, phase, summary } = river;
    return { link, phase, summary };
  });
  expect(said).toEqual({ link: "attractors=300&seed=kauri", phase: "loading", summary: null });
  expect(await outcome(page, "return river.finished")).toBe(canonical("attractors=300&seed=kauri"));
  await expectPicture(page, canonical("attractors=300&seed=kauri"));
});

test("of many changes the promise of the last one resolves, and those before it are aborted", async ({
  page,
  blog,
}) => {
  await open(page, blog, RIMU);
  const ends = await page.locator("river-seed").evaluate(async (river: RiverSeed) => {
    const seeds = ["kauri", "totara", "miro", "rimu"];
    const promises = seeds.map((seed) => {
      river.seed = seed;
      return river.finished;
    });
    const settled = await Promise.allSettled([river.finished, ...promises]);
    return settled.map((one) => (one.status === "fulfilled" ? one.value.link : one.reason.name));
  });
  const last = canonical("seed=rimu&attractors=300");
  expect(ends).toEqual([last, "AbortError", "AbortError", "AbortError", last]);
});

test("what no other rivers are asked for by leaves the promise as it is", async ({ page, blog }) => {
  await open(page, blog, RIMU);
  const isSame = await page.locator("river-seed").evaluate(async (river: RiverSeed) => {
    const before = river.finished;
    river.controls = true;
    river.alt = "Rivers";
    await Promise.resolve();
    document.body.append(river);
    await Promise.resolve();
    return before === river.finished;
  });
  expect(isSame).toBe(true);
  await outcome(page, "return river.finished");
});

test("finished rivers that grow again have a promise of their own", async ({ page, blog }) => {
  await open(page, blog, RIMU);
  const ends = await page.locator("river-seed").evaluate(async (river: RiverSeed) => {
    const first = river.finished;
    await first;
    river.restart();
    const second = river.finished;
    const isOther = first !== second;
    return [isOther, (await first).link === (await second).link, river.phase];
  });
  expect(ends).toEqual([true, true, "finished"]);
});

test("a failure rejects the promise by name, and a new try has a new one", async ({ page, blog }) => {
  const unhandled: string[] = [];
  page.on("pageerror", ({ message }) => unhandled.push(message));
  blog.answer(ENGINE, { status: 404 });
  await open(page, blog, RIMU);
  await expect.poll(async () => (await stateOf(page)).phase).toBe("failed");
  expect(await outcome(page, "return river.finished")).toBe("file-missing");
  expect((await stateOf(page)).link).toBe("attractors=300&seed=rimu");
  blog.forget(ENGINE);
  expect(await outcome(page, "river.restart(); return river.finished")).toBe(canonical("seed=rimu&attractors=300"));
  expect((await stateOf(page)).phase).toBe("finished");
  expect(unhandled).toEqual([]);
});

test("a removed element is idle: who waits is told, and a file of it is an error", async ({ page, blog }) => {
  blog.answer(ENGINE, { hangs: true });
  await open(page, blog, RIMU);
  await expect.poll(async () => (await stateOf(page)).phase).toBe("loading");
  expect(
    await outcome(page, "const { finished } = river; globalThis.river = river; river.remove(); return finished"),
  ).toBe("AbortError");
  const removed = await page.evaluate(async () => {
    const { river } = globalThis as unknown as { river: RiverSeed };
    const said = async (file: Promise<unknown>) =>
      file.then(
        () => "a file",
        (error: Error) => `${error.name}: ${error.message}`,
      );
    return [river.phase, river.summary, river.link, await said(river.toBlob()), await said(river.toSVG())];
  });
  const refusal = "InvalidStateError: this river-seed is in no document";
  expect(removed).toEqual(["idle", null, "attractors=300&seed=rimu", refusal, refusal]);
});

test("the promise of an element in no document is of the rivers that it shows when it is in one", async ({
  page,
  blog,
}) => {
  await open(page, blog, RIMU);
  await outcome(page, "return river.finished");
  const end = outcome(
    page,
    `river.remove();
    return Promise.resolve().then(() => {
      const { finished } = river;
      river.seed = "kauri";
      document.body.append(river);
      return finished;
    });`,
  );
  expect(await end).toBe(canonical("seed=kauri&attractors=300"));
});
