/** The widget and a map in marimo: what Python sets is seen, and what the reader does is heard, in cells that run again by themselves. */

import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { browse, coloursOf, folder, freePort, part, serve, until } from "./host.mjs";

const SEED = '"><img src=x onerror=alert(1)>';
const NOTEBOOK = `import marimo

app = marimo.App()


@app.cell
def _():
    import marimo as mo
    import riverseed
    return mo, riverseed


@app.cell
def _(riverseed):
    riverseed.grow("seed=kauri", attractors=300)
    return


@app.cell
def _(mo, riverseed):
    river = mo.ui.anywidget(riverseed.Widget(seed=${JSON.stringify(SEED)}, attractors=300, paused=True))
    river
    return (river,)


@app.cell
def _(mo):
    rimu = mo.ui.run_button(label="Rimu")
    rimu
    return (rimu,)


@app.cell
def _(rimu, river):
    if rimu.value:
        river.widget.seed = "rimu"
    return


@app.cell
def _(mo, river):
    mo.plain_text(f"heard: {river.widget.phase} {river.widget.paused} {river.value.get('progress')}")
    return
`;

let server;
let browser;
let page;
let complaints;

before(async () => {
  const home = folder();
  writeFileSync(join(home, "map.py"), NOTEBOOK);
  const port = await freePort();
  server = await serve(home, port, "marimo", ["run", "--headless", `--port=${port}`, "map.py"]);
  ({ browser, page, complaints } = await browse(server.address));
  await page.locator("river-seed").waitFor();
});

after(async () => {
  await browser?.close();
  server?.stop();
});

const river = () => page.locator("river-seed");
const heard = (text) => page.getByText(`heard: ${text}`).waitFor();

test("a map is shown as its picture", async () => {
  const picture = page.locator("img[src^='data:image/png']").first();
  await picture.waitFor();
  assert.deepEqual(await picture.evaluate((image) => [image.naturalWidth, image.naturalHeight]), [1200, 750]);
});

test("a widget that Python has paused waits for the reader, who is heard", async () => {
  await until(() => river().evaluate((element) => element.paused));
  await part(page, "button").click();
  await heard("finished False 1");
  assert.ok((await coloursOf(page)) > 100);
});

test("what Python sets is seen, and a hostile seed is no markup", async () => {
  const seed = async () => new URLSearchParams(await river().getAttribute("recipe")).get("seed");
  assert.equal(await seed(), SEED);
  assert.equal(await page.locator("img[src=x]").count(), 0);
  await page.getByRole("button", { name: "Rimu" }).click();
  await until(async () => (await seed()) === "rimu");
  await until(() => river().evaluate((element) => element.phase === "finished"));
  assert.ok((await coloursOf(page)) > 100);
});

test("nothing was complained of", () => {
  assert.deepEqual(complaints, []);
});

test("a server that stops leaves the map, which goes on without it and says so", async () => {
  await river().evaluate((element) => element.seek(0.5));
  await until(() => river().evaluate((element) => element.paused));
  server.stop();
  await part(page, "button").click();
  await until(() => river().evaluate((element) => element.phase === "finished"));
  await until(async () => /kernel-silent/.test(await page.locator("river-seed + [role=status]").textContent()));
  assert.ok((await coloursOf(page)) > 100);
  // marimo does not catch what its own requests throw.
  assert.deepEqual(
    complaints.filter((complaint) => !/^TypeError: Failed to fetch\n.*assets/.test(complaint)),
    [],
  );
});
