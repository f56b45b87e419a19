/** The manifest says what the element has, all of it, and nothing else. */

import { readFileSync } from "node:fs";
import { expect, type Page, test } from "@playwright/test";
import { parameter } from "../core.ts";
import { json } from "./installed.ts";

interface Named {
  readonly name: string;
}

interface Field extends Named {
  readonly kind: "field" | "method";
  readonly attribute?: string;
  readonly type?: { readonly text: string };
}

interface Declaration {
  readonly attributes: readonly (Named & { readonly description: string })[];
  readonly members: readonly Field[];
  readonly events: readonly Named[];
  readonly cssParts: readonly Named[];
  readonly cssProperties: readonly Named[];
}

const manifest = json<{ modules: readonly { declarations: readonly Declaration[] }[] }>("custom-elements.json");
const element = manifest.modules[0]?.declarations[0];
if (!element) throw new Error("the manifest declares nothing");

const names = (all: readonly Named[]): string[] => all.map(({ name }) => name).sort();
const members = (kind: Field["kind"]): Field[] => element.members.filter((member) => member.kind === kind);

/** Attributes that every element has, and this one listens to. */
const EVERYBODYS = ["aria-label", "lang"];

test.use({ reducedMotion: "reduce" });

test("attributes are those that the class observes", async ({ page }) => {
  await page.goto("./blog/");
  const observed = await classOf(page, (own) => [...own.observedAttributes]);
  expect(observed.filter((name) => !EVERYBODYS.includes(name)).sort()).toEqual(names(element.attributes));
  const { help, min, max } = parameter("mouths");
  const mouths = element.attributes.find(({ name }) => name === "mouths");
  expect(mouths?.description).toBe(`${help} ${min} to ${max}.`);
});

test("properties and methods are those of the class", async ({ page }) => {
  await page.goto("./blog/");
  const found = await classOf(page, (own) => {
    const described = Object.entries(Object.getOwnPropertyDescriptors(own.prototype));
    const isPublic = ([name]: [string, unknown]): boolean => name !== "constructor" && !name.endsWith("Callback");
    return described
      .filter(isPublic)
      .map(([name, { value }]) => [typeof value === "function" ? "method" : "field", name]);
  });
  for (const kind of ["field", "method"] as const) {
    const ours = found.flatMap(([is, name]) => (is === kind ? [name ?? ""] : []));
    expect(ours.sort(), kind).toEqual(names(members(kind)));
  }
});

test("a property sets its attribute, and reads what that says", async ({ page }) => {
  await page.goto("./blog/");
  const samples = members("field").flatMap(({ name, attribute, type }) => {
    const [is = "", ...others] = type?.text.split(" | ") ?? [];
    const values = is === "number" ? [2.5, ...others.map((other) => JSON.parse(other))] : [is === "boolean" || "some"];
    return attribute ? values.map((value) => ({ name, attribute, value })) : [];
  });
  const read = await page.evaluate((samples) => {
    const river = document.createElement("river-seed");
    return samples.map(({ name, attribute, value }) => {
      Reflect.set(river, name, value);
      return { name, attribute: river.hasAttribute(attribute) ? attribute : "none", value: Reflect.get(river, name) };
    });
  }, samples);
  expect(read).toEqual(samples);
});

test("events are those that are heard", async ({ page }) => {
  const heard = new Set<string>();
  await page.exposeFunction("hear", (type: string) => heard.add(type));
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await page.goto("./blog/");
  await listen(
    page,
    element.events.map(({ name }) => name),
  );
  await expect.poll(() => [...heard].sort()).toEqual(["complete", "progress", "ready"]);
  await page
    .locator("river-seed")
    .last()
    .evaluate((river) => river.setAttribute("aspect", "none"));
  await expect.poll(() => [...heard].sort()).toEqual(["complete", "corrected", "progress", "ready"]);
  await page.route("**/*.wasm", (route) => route.abort());
  await page.reload();
  await listen(page, ["error"]);
  await expect.poll(() => [...heard].sort()).toEqual(names(element.events));
});

test("parts are those of the shadow tree, and custom properties those of its style sheet", async ({ page }) => {
  await page.goto("./blog/");
  const river = page.locator("river-seed");
  await expect(river.locator("canvas")).toBeVisible();
  // There is no link unless an author names a page for it.
  await river.evaluate((own) => own.setAttribute("maker", "https://rivers.example/"));
  await expect(river.locator('[part="maker"]')).toHaveCount(1);
  const parts = await river.evaluate((own) =>
    Array.from(own.shadowRoot?.querySelectorAll("[part]") ?? [], (one) => one.getAttribute("part") ?? ""),
  );
  expect(parts.sort()).toEqual(names(element.cssParts));
  const sheet = readFileSync(new URL("../../src/apps/widget/sheet.css", import.meta.url), "utf8");
  expect([...new Set(sheet.match(/--river-seed-[\w-]+/g))].sort()).toEqual(names(element.cssProperties));
});

type Class = CustomElementConstructor & { readonly observedAttributes: readonly string[] };

/** What the page's class of the element says. */
async function classOf<T>(page: Page, ask: (own: Class) => T): Promise<T> {
  await page.evaluate(() => customElements.whenDefined("river-seed"));
  const own = await page.evaluateHandle(() => customElements.get("river-seed") as Class);
  return own.evaluate(ask as (own: unknown) => T);
}

/** Hears events of a fresh element, which is there from before its first. */
function listen(page: Page, types: readonly string[]): Promise<void> {
  return page.evaluate((types) => {
    const river = document.createElement("river-seed");
    const { hear } = globalThis as unknown as { hear: (type: string) => void };
    for (const type of types) river.addEventListener(type, () => hear(type));
    for (const [name, value] of Object.entries({ seed: "kauri", attractors: "300", loading: "eager" }))
      river.setAttribute(name, value);
    document.body.append(river);
  }, types);
}
