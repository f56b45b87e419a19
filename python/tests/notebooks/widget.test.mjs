/** The widget's script by itself, with stand-ins for the notebook and for the element: what is hard to bring about in a real notebook. */

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { browse } from "./host.mjs";

const SCRIPT = readFileSync(new URL("../../riverseed/static/widget.js", import.meta.url), "utf8");

let browser;
let page;
let complaints;

before(async () => {
  ({ browser, page, complaints } = await browse("about:blank"));
  await page.evaluate(standIns, SCRIPT);
});

after(() => browser?.close());

/** Defines the stand-ins in the page, and `show`, which renders a widget with the given state. */
function standIns(script) {
  customElements.define(
    "river-seed",
    class extends HTMLElement {
      phase = "idle";
      progress = 0;
      paused = false;
      summary = null;
      link = "seed=kauri";
      asked = [];
      play = () => this.asked.push("play");
      pause = () => this.asked.push("pause");
      tell(type, detail = {}) {
        this.dispatchEvent(new CustomEvent(type, { detail }));
      }
    },
  );
  const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
  globalThis.show = async (state, fails = false) => {
    const { default: widget } = await import(address);
    const listeners = [];
    const model = {
      sent: [],
      listeners,
      get: (name) => state[name],
      set: (name, value) => {
        if (state[name] === value) return;
        state[name] = value;
        for (const [event, listener] of [...listeners]) if (event === `change:${name}`) listener();
      },
      save_changes: () => {
        if (fails) throw new Error("there is no kernel");
      },
      send: async (content) => {
        if (fails) throw new Error("there is no kernel");
        model.sent.push(content);
      },
      on: (event, listener) => listeners.push([event, listener]),
      off: (event, listener) =>
        listeners.splice(
          listeners.findIndex((one) => one[0] === event && one[1] === listener),
          1,
        ),
    };
    const el = document.createElement("div");
    document.body.replaceChildren(el);
    const clean = widget.render({ model, el });
    return { model, el, clean, state, river: el.querySelector("river-seed") };
  };
}

test("a view that goes leaves nothing behind, and tells nothing more", async () => {
  const found = await page.evaluate(async () => {
    const { model, el, clean, state, river } = await show({ link: "seed=kauri", paused: false });
    const listened = model.listeners.length;
    clean();
    Object.assign(river, { phase: "finished", progress: 1, summary: {} });
    river.tell("progress");
    river.tell("complete");
    return { listened, left: model.listeners.length, children: el.childNodes.length, phase: state.phase };
  });
  assert.ok(found.listened > 5);
  assert.deepEqual({ ...found, listened: 0 }, { listened: 0, left: 0, children: 0, phase: undefined });
});

test("an error is told, and forgotten when there is a map again", async () => {
  const error = { code: "wasm-refused", message: "<b>no</b>", advice: "…" };
  const told = await page.evaluate(async (error) => {
    const { state, river } = await show({ link: "seed=kauri", paused: false });
    river.phase = "failed";
    river.tell("error", error);
    const failed = { ...state };
    Object.assign(river, { phase: "growing", progress: 0.2, summary: {} });
    river.tell("progress");
    return [failed.phase, failed.error, state.phase, state.error, state.shown];
  }, error);
  assert.deepEqual(told, ["failed", error, "growing", null, "seed=kauri"]);
});

test("a finished map does not pause, and Python is told so a moment later", async () => {
  const told = await page.evaluate(async () => {
    const { model, state, river } = await show({ link: "seed=kauri", paused: false });
    Object.assign(river, { phase: "finished", progress: 1, summary: {} });
    river.tell("complete");
    model.set("paused", true);
    const before = state.paused;
    while (state.paused) await new Promise((resolve) => setTimeout(resolve, 50));
    return [before, river.asked];
  });
  assert.deepEqual(told, [true, ["pause"]]);
});

test("what Python asks for is not taken back by a report that was on its way", async () => {
  const told = await page.evaluate(async () => {
    const { model, state, river } = await show({ link: "seed=kauri", paused: false });
    model.set("paused", true);
    Object.assign(river, { phase: "growing", progress: 0.5, summary: {} });
    river.tell("progress");
    const before = state.paused;
    river.paused = true;
    river.tell("progress");
    return [before, state.paused, model.sent];
  });
  assert.deepEqual(told, [true, true, []]);
});

test("small steps are not worth a message", async () => {
  const steps = await page.evaluate(async () => {
    const { model, state, river } = await show({ link: "seed=kauri", paused: false });
    const told = [];
    model.save_changes = () => told.push(state.progress);
    Object.assign(river, { phase: "growing", summary: {} });
    for (let step = 0; step <= 100; step++) {
      river.progress = step / 100;
      river.tell("progress");
    }
    return told;
  });
  assert.ok(steps.length >= 15 && steps.length <= 21, String(steps));
});

test("a message that cannot be sent is said below the map, and nothing is thrown", async () => {
  const note = await page.evaluate(async () => {
    const { el, river } = await show({ link: "seed=kauri", paused: false }, true);
    Object.assign(river, { phase: "growing", progress: 0.5, summary: {}, paused: true });
    river.tell("progress");
    await new Promise((resolve) => setTimeout(resolve));
    return el.querySelector("[role=status]").textContent;
  });
  assert.match(note, /^kernel-silent: /);
  assert.deepEqual(complaints, []);
});
