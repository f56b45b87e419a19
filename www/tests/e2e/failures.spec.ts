import { expect, type Page, test } from "@playwright/test";
import { BLOCKED, beforehand, everywhere, finished, openBegun, openStopped, unfold } from "./riverpage.ts";
import { download } from "./saving.ts";

async function expectFailure(page: Page, code: string, advice: RegExp): Promise<void> {
  const failure = page.getByRole("alert");
  await expect(failure).toBeVisible();
  await expect(failure).toContainText(code);
  await expect(failure).toContainText(advice);
  await expect(failure.getByRole("link", { name: "Start from a fresh river" })).toBeVisible();
  await expect(page.locator("#facade")).toBeHidden();
  await expect(page.getByRole("heading", { name: "Riverseed" })).toBeVisible();
}

/** What a half-uploaded site answers for a file of the other build. */
async function missing(page: Page, files: string | RegExp): Promise<void> {
  await page.route(files, (route) => route.fulfill({ status: 404, contentType: "text/html", body: "not here" }));
}

test("the engine's file is missing: the site has changed, and a new load finds it @core", async ({ page }) => {
  await missing(page, "**/*.wasm");
  await page.goto("./");
  await expectFailure(page, "file-missing", /Load the page again/);
  await expect(page.getByRole("heading", { name: "This site has just changed" })).toBeVisible();
  await page.unroute("**/*.wasm");
  await page.getByRole("button", { name: "Load again" }).click();
  await finished(page);
});

test("the worker's script and what stands in for it are missing: the site has changed", async ({ page }) => {
  await missing(page, /\/page-(worker|backend)-[^/]*\.js$/);
  await page.goto("./?attractors=300&style=ink&labels=none");
  await expectFailure(page, "file-missing", /Load the page again/);
  await expect(page.getByRole("alert")).toHaveCount(1);
});

for (const [what, files] of [
  ["all its scripts and styles", /\/assets\/.*\.(js|css|wasm)$/],
  ["its script", /\/assets\/index-[^/]*\.js$/],
  ["a module that its script imports", /\/assets\/(?!index-|page-worker-)[^/]*\.js$/],
  ["its style sheet", /\/assets\/index-[^/]*\.css$/],
] as const) {
  test(`a page of one build whose files are another's says so: without ${what}`, async ({ page }) => {
    let loads = 0;
    page.on("request", (request) => {
      if (request.isNavigationRequest()) loads++;
    });
    await missing(page, files);
    await page.goto("./?attractors=300&style=ink&labels=none#here");
    await expect(page.getByRole("alert")).toContainText("This site has just changed");
    await expect(page.getByText("Preparing the rivers")).toBeHidden();
    await expect(page.getByText("may have been blocked")).toBeHidden();
    // It never loads itself again: a site that stays so would be asked for ever.
    expect(loads).toBe(1);
    await page.getByRole("button", { name: "Load again" }).click();
    await expect.poll(() => loads).toBe(2);
    await expect(page.getByRole("alert")).toContainText("This site has just changed");
    expect(loads).toBe(2);
    await page.unroute(files);
    await page.getByRole("button", { name: "Load again" }).click();
    await finished(page);
    await expect(page.getByRole("alert")).toBeHidden();
  });
}

test("the connection breaks", async ({ page }) => {
  await page.route("**/*.wasm", (route) => route.abort());
  await page.goto("./?attractors=300");
  await expectFailure(page, "wasm-fetch", /reload the page/);
  await page.unroute("**/*.wasm");
  await page.getByRole("button", { name: "Load again" }).click();
  await finished(page);
});

test("the engine's file is cut short", async ({ page }) => {
  await page.route("**/*.wasm", async (route) => {
    const response = await route.fetch();
    const body = (await response.body()).subarray(0, 20_000);
    await route.fulfill({ contentType: "application/wasm", body });
  });
  await page.goto("./");
  await expectFailure(page, "wasm-fetch", /downloaded completely/);
});

test("a server that answers with a page of its own", async ({ page }) => {
  await page.route("**/*.wasm", (route) => route.fulfill({ contentType: "text/html", body: "<h1>Hello</h1>" }));
  await page.goto("./");
  await expectFailure(page, "wasm-mime", /application\/wasm/);
});

test("the right bytes under the wrong type still grow", async ({ page }) => {
  await page.route("**/*.wasm", async (route) => {
    const response = await route.fetch();
    await route.fulfill({ contentType: "application/octet-stream", body: await response.body() });
  });
  await page.goto("./?attractors=300&style=ink&labels=none");
  await finished(page);
});

/** Lets the page's faked clock run, second by second, until something is seen. */
async function runUntil(page: Page, isSeen: () => Promise<boolean>): Promise<void> {
  await expect
    .poll(async () => {
      await page.clock.runFor(1000);
      return isSeen();
    })
    .toBe(true);
}

test("an engine that never comes is given up by name, and a new load finds it @core", async ({ page }) => {
  await page.clock.install();
  await page.route("**/*.wasm", () => {});
  await page.goto("./?attractors=300&style=ink&labels=none");
  await expect(page.getByText("Preparing the rivers")).toBeVisible();
  await runUntil(page, () => page.getByRole("alert").isVisible());
  await expectFailure(page, "wasm-timeout", /Check the connection/);
  await page.unroute("**/*.wasm");
  await page.getByRole("button", { name: "Load again" }).click();
  await finished(page);
});

test("the page of digests gives up as well", async ({ page }) => {
  await page.clock.install();
  await page.route("**/*.wasm", () => {});
  await page.goto("./digest.html");
  await runUntil(page, async () => (await page.locator("body").getAttribute("data-failed")) === "wasm-timeout");
  await expect(page.locator("#verdict")).toContainText("nothing came from");
});

test("a browser without WebAssembly, which asks for nothing again @core", async ({ page }) => {
  let downloads = 0;
  await page.route("**/*.wasm", (route) => {
    downloads++;
    return route.continue();
  });
  await page.addInitScript(() => Reflect.deleteProperty(globalThis, "WebAssembly"));
  await page.goto("./?attractors=300&style=ink&labels=none");
  await expectFailure(page, "wasm-unsupported", /Update the browser/);
  // With a link the page has asked for the engine before it could look.
  expect(downloads).toBe(1);
});

test("a browser without SIMD", async ({ page }) => {
  await page.addInitScript(() => {
    WebAssembly.validate = () => false;
  });
  await page.goto("./");
  await expectFailure(page, "wasm-unsupported", /Safari 17\.2/);
});

test("a policy that forbids WebAssembly", async ({ page }) => {
  await page.route("**/", async (route) => {
    const response = await route.fetch();
    const headers = { ...response.headers(), "content-security-policy": "script-src 'self'" };
    await route.fulfill({ response, headers });
  });
  await page.goto("./");
  await expectFailure(page, "wasm-csp", /wasm-unsafe-eval/);
});

/** Makes a function of the engine fail once `globalThis.trap` is set: trap, as a panic does, or throw an error with a code. */
async function trapOn(page: Page, name: string, code?: string): Promise<void> {
  await beforehand(
    page,
    ([trapped = "", code]: readonly (string | undefined)[]) => {
      const instantiate = WebAssembly.instantiate;
      const trapping = async (...given: Parameters<typeof instantiate>) => {
        const instance = (await Reflect.apply(instantiate, WebAssembly, given)) as unknown as WebAssembly.Instance;
        const exports: Record<string, unknown> = { ...instance.exports };
        const original = exports[trapped] as (...args: unknown[]) => unknown;
        exports[trapped] = (...args: unknown[]) => {
          if ("trap" in globalThis && code) throw Object.assign(new Error("no room"), { code });
          if ("trap" in globalThis) throw new WebAssembly.RuntimeError("unreachable");
          return original(...args);
        };
        return Object.create(WebAssembly.Instance.prototype, { exports: { value: exports } });
      };
      WebAssembly.instantiate = trapping as unknown as typeof instantiate;
    },
    [name, ...(code === undefined ? [] : [code])],
  );
}

/** From now on it does, in the page and in its worker. */
async function trap(page: Page): Promise<void> {
  await everywhere(page, () => Object.assign(globalThis, { trap: true }) && undefined, undefined);
}

test("a panic while growing stops the river and says so, once @core", async ({ page }) => {
  const warnings: string[] = [];
  page.on("console", (message) => {
    if (message.type() === "warning" && message.text() !== BLOCKED) warnings.push(message.text());
  });
  await trapOn(page, "river_advance");
  await openStopped(page, "attractors=1000");
  await page.clock.runFor(100);
  await expect(page.locator("#caption")).toContainText("Growing");
  await trap(page);
  await page.clock.resume();
  await expectFailure(page, "panic", /report the link/);
  expect(warnings).toHaveLength(1);
  await page.getByRole("link", { name: "Start from a fresh river" }).click();
  await finished(page);
});

test("memory that runs out before the rivers are there is said, and no tree stands in their place @core", async ({
  page,
}) => {
  await trapOn(page, "river_advance", "no-memory");
  await openBegun(page, "attractors=1000");
  await trap(page);
  await page.clock.resume();
  await expectFailure(page, "no-memory", /fewer attractors/);
});

async function panicOnASlider(page: Page): Promise<void> {
  await trapOn(page, "river_adoptDraft");
  await page.goto("./?growth=colonize&attractors=300&style=ink&labels=none");
  await finished(page);
  await unfold(page);
  await trap(page);
  await page.getByRole("slider", { name: "Curl" }).press("ArrowRight");
  await expectFailure(page, "panic", /report the link/);
}

test("a panic on a slider's change leaves advice, not a frozen page", async ({ page }) => {
  await panicOnASlider(page);
  await page.getByRole("slider", { name: "Trim", exact: true }).press("ArrowRight");
  await page.getByRole("button", { name: "Replay" }).click();
  await expectFailure(page, "panic", /report the link/);
});

test("after a panic the rivers can still be had as a file", async ({ page }) => {
  await panicOnASlider(page);
  for (const kind of ["Drawing", "Picture"]) await download(page, kind);
});

test("a panic while a link is read leaves advice, not a dead page", async ({ page }) => {
  await trapOn(page, "readLink");
  await page.goto("./?attractors=300&style=ink&labels=none");
  await finished(page);
  await trap(page);
  await page.getByRole("button", { name: "A new seed by chance" }).click();
  await expectFailure(page, "panic", /report the link/);
});

test("a river too large for this device is refused and the last one stays", async ({ page }) => {
  await trapOn(page, "river_adoptDraft", "too-large");
  await page.goto("./?growth=colonize&attractors=300&style=ink&labels=none");
  await finished(page);
  await unfold(page);
  await trap(page);
  await page.getByRole("slider", { name: "Curl" }).press("ArrowRight");
  await expect(page.locator("#notices")).toContainText("no room");
  await expect(page.getByLabel("Curl, exact value")).toHaveValue("0.7");
  await expect.poll(() => new URL(page.url()).searchParams.has("curl")).toBe(false);
  await expect(page.locator("#failure")).toBeHidden();
});

for (const code of ["no-memory", "too-large", undefined]) {
  test(`small pictures that fail leave the map as it is: ${code ?? "a panic"}`, async ({ page }) => {
    const warnings: string[] = [];
    page.on("console", (message) => {
      if (message.text().startsWith("riverseed:")) warnings.push(message.text());
    });
    await trapOn(page, "river_copy", code);
    await page.goto("./?seed=rimu&growth=colonize&attractors=300&style=ink&labels=none");
    await finished(page);
    await trap(page);
    await page.getByLabel("Seed", { exact: true }).fill("como");
    await page.getByLabel("Seed", { exact: true }).press("Enter");
    await expect.poll(() => warnings).toEqual([expect.stringContaining(code ?? "panic")]);
    await finished(page);
    await expect(page.locator("#title")).toHaveText("como");
    await expect(page.locator("#failure")).toBeHidden();
    await expect(page.locator("#notices")).toBeHidden();
    // Nothing is tried again and again.
    await page.getByRole("button", { name: "Replay" }).click();
    // The press may meet the engine that has just taken another's place, and is on its way: that it pauses.
    await expect(async () => {
      const play = page.getByRole("button", { name: "Play", exact: true });
      if (await play.isVisible()) await play.click();
      await expect(page.locator("#frame")).toHaveAttribute("data-state", "finished", { timeout: 3000 });
    }).toPass();
    expect(warnings.length).toBe(1);
  });
}

test("dice that cannot be thrown say so, and the map stays", async ({ page }) => {
  await trapOn(page, "freshSeed", "no-randomness");
  await page.goto("./?seed=rimu&growth=colonize&attractors=300&style=ink&labels=none");
  await finished(page);
  await trap(page);
  await page.getByRole("button", { name: "A new seed by chance" }).click();
  await expect(page.locator("#notices")).toContainText("no room");
  await expect(page.locator("#failure")).toBeHidden();
  await page.getByLabel("Seed", { exact: true }).fill("como");
  await page.getByLabel("Seed", { exact: true }).press("Enter");
  await expect(page.locator("#title")).toHaveText("como");
  await finished(page);
});

test.describe("without JavaScript", () => {
  test.use({ javaScriptEnabled: false });
  test("the page says what it needs @core", async ({ page }) => {
    await page.goto("./");
    // By element: looking for text, Playwright passes <noscript> over.
    await expect(page.locator("noscript p")).toBeVisible();
    await expect(page.locator("noscript p")).toContainText("Please allow JavaScript for this site");
  });
});

test("a page whose script never comes says so after a while", async ({ page }) => {
  await page.route("**/*.js", (route) => route.abort());
  await page.goto("./");
  await expect(page.getByText("Preparing the rivers")).toBeVisible();
  await expect(page.getByText("it needs a web server")).toBeVisible();
  // Nobody knows that the site has changed: its server was not reached.
  await expect(page.getByText("has just changed")).toBeHidden();
});
