/** What TypeScript knows of the package, in the strictest mode: a line is an error if a promise of the types is broken. */

import type { RiverSeed } from "riverseed";
import { RiverSeed as Class } from "riverseed";
import "riverseed/define";
import "riverseed/river-seed.js";
import type {} from "riverseed/svelte";
import type {} from "riverseed/vue";
import type { SvelteHTMLElements } from "svelte/elements";
import type { GlobalComponents } from "vue";

// The tag names the class.
const made: RiverSeed = document.createElement("river-seed");
const found: RiverSeed | null = document.querySelector("river-seed");
const isOurs: boolean = made instanceof Class;

// Properties.
made.seed = "kauri";
made.attractors = 300;
made.meanderRounds = 24;
made.riverStyle = "ink";
made.riverWidth = null;
made.controls = true;
// @ts-expect-error: a number.
made.attractors = "many";
// @ts-expect-error: no such property.
made.colour = "red";

// Methods.
made.play();
made.pause();
made.restart();
const png: Promise<Blob> = made.toBlob();
const svg: Promise<string> = made.toSVG();

// State.
const link: string = made.link;
const sources: number | undefined = made.summary?.sources;
const isOver: boolean = made.phase === "finished" || made.phase === "failed";
made.finished.then(({ link, summary }) => [link.toUpperCase(), summary.sources.toFixed()]);
// @ts-expect-error: only read.
made.link = "seed=kauri";
// @ts-expect-error: no such phase.
made.phase === "asleep";

// Events, typed by name.
made.addEventListener("ready", ({ detail }) => detail.link.toUpperCase());
made.addEventListener("complete", ({ detail, currentTarget }) => [detail.summary.sources.toFixed(), currentTarget]);
made.addEventListener("error", ({ detail }) => detail.code.toUpperCase());
const listener = ({ detail }: CustomEvent<{ link: string }>): string => detail.link;
made.removeEventListener("ready", listener);
made.addEventListener("click", ({ clientX }) => clientX);
// @ts-expect-error: no such detail.
made.addEventListener("complete", ({ detail }) => detail.colour);

// Markup of frameworks.
export const svelte: SvelteHTMLElements["river-seed"] = {
  seed: "kauri",
  "river-width": 14,
  class: "wide",
  oncomplete: ({ detail }) => detail.summary.sources,
};
export const vue: InstanceType<GlobalComponents["river-seed"]>["$props"] = {
  seed: "kauri",
  "river-width": 14,
  class: "wide",
  onComplete: ({ detail }) => detail.summary.sources,
};
// @ts-expect-error: not one of the lands.
export const moon: SvelteHTMLElements["river-seed"] = { land: "moon" };

export { found, isOurs, isOver, link, png, sources, svg };
