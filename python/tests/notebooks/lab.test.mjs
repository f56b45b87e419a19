/** The widget and a map in JupyterLab: what Python sets is seen, what the reader does is heard, and a kernel that dies takes nothing along. */

import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { browse, coloursOf, folder, freePort, part, serve, until } from "./host.mjs";

const SEED = '"><img src=x onerror=alert(1)>';
const CELLS = [
  `import riverseed\nkauri = riverseed.grow("seed=kauri", attractors=300)\nkauri`,
  `river = riverseed.Widget(seed=${JSON.stringify(SEED)}, attractors=300, paused=True)\nriver`,
];

let lab;
let browser;
let page;
let complaints;

before(async () => {
  const home = folder();
  writeFileSync(join(home, "map.ipynb"), JSON.stringify(notebook(CELLS)));
  const port = await freePort();
  lab = await serve(home, port, "jupyter-lab", [
    "--no-browser",
    "--allow-root",
    `--port=${port}`,
    `--ServerApp.root_dir=${home}`,
    "--IdentityProvider.token=",
    "--LabApp.expose_app_in_browser=True",
    "--LabApp.news_url=None",
    "--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate",
    "--LabApp.extension_manager=readonly",
  ]);
  ({ browser, page, complaints } = await browse(`${lab.address}/lab/tree/map.ipynb`));
  await page.waitForFunction(() => globalThis.jupyterapp?.shell.currentWidget?.sessionContext?.session?.kernel);
  await page.evaluate(() => globalThis.jupyterapp.shell.currentWidget.sessionContext.ready);
  await page.evaluate(() => globalThis.jupyterapp.commands.execute("notebook:run-all-cells"));
  await page.locator("river-seed").waitFor();
});

after(async () => {
  await browser?.close();
  lab?.stop();
});

/** Runs a program in the notebook's kernel and returns what it prints. */
function python(program) {
  return page.evaluate(async (code) => {
    const future = globalThis.jupyterapp.shell.currentWidget.sessionContext.session.kernel.requestExecute({ code });
    let said = "";
    future.onIOPub = ({ content }) => {
      said += content.text ?? content.evalue ?? "";
    };
    await future.done;
    return said.trim();
  }, program);
}

const told = (expression) => python(`import json; print(json.dumps(${expression}))`).then(JSON.parse);
const attribute = (name) => page.locator("river-seed").getAttribute(name);
const state = (name) => page.locator("river-seed").evaluate((river, name) => river[name], name);

test("a map is shown as its picture, sharp and as large as text", async () => {
  const picture = page.locator(".jp-OutputArea-output img").first();
  await picture.waitFor();
  const size = await picture.evaluate((image) => [
    image.naturalWidth,
    image.naturalHeight,
    image.getAttribute("width"),
  ]);
  assert.deepEqual(size, [1200, 750, "800"]);
});

test("a widget that Python has paused waits for the reader, who is heard", async () => {
  await until(() => state("paused"));
  assert.equal(await told("river.paused"), true);
  await part(page, "button").click();
  await until(async () => (await told("river.paused")) === false);
  await until(async () => (await told("river.phase")) === "finished");
  assert.deepEqual(await told("[river.progress, river.error, river.shown == river.link]"), [1, null, true]);
  assert.deepEqual(await told("river.summary['sources']"), await told("river.grow().summary.sources"));
});

test("the map is painted", async () => {
  assert.ok((await coloursOf(page)) > 100);
});

test("a hostile seed is text in the link, and no markup", async () => {
  assert.equal(new URLSearchParams(await attribute("recipe")).get("seed"), SEED);
  assert.equal(await page.locator("img[src=x]").count(), 0);
});

test("what Python sets is seen", async () => {
  const before = await page.locator("river-seed").screenshot();
  await python(`river.seed = "rimu"; river.still = True`);
  await until(async () => new URLSearchParams(await attribute("recipe")).get("seed") === "rimu");
  await until(async () => (await told("river.phase")) === "finished" && (await state("phase")) === "finished");
  assert.equal(await attribute("still"), "");
  assert.ok((await coloursOf(page)) > 100);
  assert.notDeepEqual(await page.locator("river-seed").screenshot(), before);
});

test("values that are no good are refused in Python, and change nothing", async () => {
  const link = await attribute("recipe");
  assert.match(await python("river.curl = 3"), /curl: 3 is not between 0 and 2/);
  assert.equal(await attribute("recipe"), link);
});

test("a map beyond the element's limits is shown smaller, and Python is told", async () => {
  await python("river.attractors = 30_000");
  // As many as the land of this word may have in an element.
  const shown = async () => Number(new URLSearchParams(await told("river.shown")).get("attractors"));
  await until(async () => (await shown()) > 0 && (await shown()) < 30_000);
  await python("river.attractors = 300");
  await until(async () => (await told("river.shown == river.link and river.phase")) === "finished");
});

test("a kernel that stands still is said to be silent until it answers", async () => {
  await python("river.still = False; river.seek(0.5)");
  await until(async () => (await told("[river.paused, river.progress >= 0.5]")).every(Boolean));
  const pid = await told("__import__('os').getpid()");
  const note = page.locator("river-seed + [role=status]");
  process.kill(pid, "SIGSTOP");
  try {
    await part(page, "button").click();
    await until(async () => /^kernel-silent: Python does not answer/.test(await note.textContent()));
  } finally {
    process.kill(pid, "SIGCONT");
  }
  await until(async () => (await note.textContent()) === "");
  await until(async () => (await told("river.paused")) === false);
});

test("a kernel that dies leaves the map, which goes on without it and says so", async () => {
  await python("river.seek(0.5)");
  await until(async () => (await told("river.paused")) && (await state("paused")));
  process.kill(await told("__import__('os').getpid()"), "SIGKILL");
  // JupyterLab says that it starts another, which knows nothing of the widget.
  await page.getByRole("dialog").getByText("Kernel Restarting").waitFor();
  await page.getByRole("dialog").getByRole("button").click();
  assert.ok((await coloursOf(page)) > 100);
  await part(page, "button").click();
  await until(async () => (await state("phase")) === "finished");
  await until(async () => /kernel-silent/.test(await page.locator("river-seed + [role=status]").textContent()));
});

test("nothing was complained of", () => {
  assert.deepEqual(complaints, []);
});

function notebook(sources) {
  const cells = sources.map((source, number) => ({
    cell_type: "code",
    execution_count: null,
    id: `cell-${number}`,
    metadata: {},
    outputs: [],
    source,
  }));
  const kernelspec = { display_name: "Python 3", language: "python", name: "python3" };
  return { cells, metadata: { kernelspec }, nbformat: 4, nbformat_minor: 5 };
}
