/** Begins the page: the engine after the poster, then the first river, then all else. */

import "../../style/page.css";
import { asQuery, linkOf } from "../../browser/address.ts";
import { turn } from "../../browser/turn.ts";
import { onAnyCountry } from "../../controls/presets.ts";
import { Recipe } from "../../engine/recipe.ts";
import { loadTable } from "../../engine/table.ts";
import { type Engines, openEngines } from "./backend.ts";
import { elements } from "./elements.ts";
import { fail } from "./failure.ts";
import { covered } from "./map/covered.ts";
import { RiverViewport } from "./map/viewport.ts";
import { mapOf, Page } from "./page.ts";
import { firstLink, prefersDark } from "./preferences.ts";
import { typeAtOnce } from "./type-at-once.ts";

/**
 * Waits until the poster, if there is one, has been painted. The engine is fetched after that, so that the visitor sees
 * the poster sooner.
 */
async function posterIsSeen(): Promise<void> {
  const isWithout = "withoutPoster" in document.documentElement.dataset;
  if (isWithout || document.hidden || !PerformanceObserver.supportedEntryTypes.includes("paint")) return;
  await new Promise<void>((done) => {
    new PerformanceObserver(() => done()).observe({ type: "paint", buffered: true });
  });
}

/** Starts the first river, then makes the page, which takes as long as the river's first picture. */
async function begin({ core, renderHost }: Engines): Promise<void> {
  const table = loadTable();
  // Its failure is met below, once the river has begun.
  table.catch(() => {});
  const own = await core;
  const linked = linkOf(location);
  const recipe = new Recipe(
    (text, options) => own.engine.readLink(text, options),
    asQuery(linked) || firstLink(),
    () => prefersDark.matches,
  );
  const viewport = new RiverViewport(renderHost, elements, mapOf(recipe), covered);
  viewport.start("still", linked !== "");
  const shut = (error: unknown): never => {
    viewport.close();
    throw error;
  };
  await turn();
  const day = linked === "" ? recipe.seed : undefined;
  const rows = await table.catch(shut);
  const ofPage = { ...rows, presets: onAnyCountry(rows.presets) };
  const page = new Page(own, ofPage, recipe, viewport, renderHost, day);
  await turn();
  page.start();
  if (linked === "") typeAtOnce(elements.seed);
}

/**
 * The globals that this script takes over from the scripts in the built page's HTML: build/preload.ts and
 * build/changed.ts.
 */
const early = globalThis as { engineTimer?: number; hasPageBegun?: boolean };
clearTimeout(early.engineTimer);
early.hasPageBegun = true;
posterIsSeen().then(() => begin(openEngines()).catch(fail));
