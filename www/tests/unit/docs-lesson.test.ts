/** The answers of the lesson, docs/for/teachers.md, are those that the page shows. */

import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { Inspections } from "../../src/apps/page-worker/inspections.ts";
import type { RiverPlayer } from "../../src/player/river-player.ts";
import { engine } from "../whole.ts";

const lesson = readFileSync(new URL("../../../docs/for/teachers.md", import.meta.url), "utf8");

/** The part of the lesson that begins with a text, up to the next heading or point. */
function part(begin: string): string {
  const [, rest = ""] = lesson.split(begin);
  return rest.split(/\n(?:- |#)/)[0] ?? "";
}

/** The link of the first map after a text. */
function linkAfter(text: string): string {
  return /https:\/\/example\.org\/riverseed\/\?([^)\s]+)/.exec(lesson.slice(lesson.indexOf(text)))?.[1] ?? "";
}

function grown(link: string): engine.River {
  const river = new engine.River(link);
  while (river.advance(1000));
  return river;
}

/** The numbers of streams of each order, as the legend on the page has them. */
async function legendOf(river: engine.River): Promise<number[]> {
  const player = { river, link: river.link, state: "finished" } as RiverPlayer<engine.River> & { river: engine.River };
  const overlay = await new Inspections().overlay(player, "orders");
  return overlay?.kinds.map((streams) => streams.length) ?? [];
}

test("the map to number by hand has as many streams as the answers say", async () => {
  const said = [...part("- **2.** ").matchAll(/(\d+)(?: streams)? of order \d/g)].map(([, number]) => Number(number));
  expect(said).toHaveLength(4);
  expect(await legendOf(grown(linkAfter("# A lesson")))).toEqual(said);
});

test("Horton's law holds on the great basin as the answers say", async () => {
  const answer = part("- **3.** ");
  const [first = "", rest = ""] = /(\d+) streams of order 1, then ([\d, and]+)/.exec(answer)?.slice(1) ?? [];
  const said = [first, ...(rest.match(/\d+/g) ?? [])].map(Number);
  const river = grown(linkAfter("## 3."));
  expect(await legendOf(river)).toEqual(said);
  const quotients = said.slice(1).map((number, i) => (said[i] ?? 0) / number);
  const [told3] = /quotients are ([\d., and]+);/.exec(answer)?.slice(1) ?? [];
  expect((told3?.match(/[\d.]*\d/g) ?? []).map(Number)).toEqual(
    quotients.map((quotient) => Number(quotient.toFixed(1))),
  );
  const ratio = river.measures().find(({ name }) => name === "bifurcation-ratio")?.value ?? 0;
  expect(answer).toContain(`R = ${ratio.toFixed(2)}`);
  expect(ratio * (said[0] ?? 0)).toBeGreaterThan(3000);
});

test.each(["A", "B", "C", "D"])("country %s has the pattern that the answers name", (country) => {
  const [, pattern] = new RegExp(`${country} is \\*(\\w+)\\*`).exec(part("- **5.** ")) ?? [];
  const measures = grown(linkAfter(`[Country ${country}]`)).measures();
  const { distances = {} } = measures.find(({ name }) => name === "pattern") ?? {};
  const [nearest] = Object.entries(distances).sort(([, a], [, b]) => a - b);
  expect(nearest?.[0]).toBe(pattern);
});
