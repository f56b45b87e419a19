/**
 * Shows six maps side by side: the variants of the river paper, on the same attractors and by one clock. A chosen one
 * becomes the map.
 */

import { count } from "../../../browser/count.ts";
import { el, setText } from "../../../browser/dom.ts";
import { isShown } from "../../../controls/presets.ts";
import { changed } from "../../../engine/link-text.ts";
import type { Preset } from "../../../engine/table.ts";
import type { ShowMode } from "../../../player/river-player.ts";
import type { PageRenderHost } from "../backend.ts";
import { prefersDark } from "../preferences.ts";
import { Variant } from "./variant.ts";

export interface SideBySideElements {
  dialog: HTMLDialogElement;
  about: HTMLElement;
  clock: HTMLElement;
  play: HTMLButtonElement;
  copy: HTMLButtonElement;
  close: HTMLButtonElement;
  status: HTMLElement;
  variants: HTMLElement;
}

export interface SideBySideEvents {
  /** Called when it is opened or closed: while open, it covers the map. */
  changed(isOpen: boolean): void;
  /** Called when one was chosen. */
  take(preset: Preset, all: readonly Preset[]): void;
  /** Copies the address, and returns a message about it. */
  copy(): Promise<string>;
  how(): ShowMode;
}

/** The map from which all six are made. */
export interface SharedValues {
  link: string;
  values: ReadonlyMap<string, string>;
  /** The keys that presets may not change. */
  kept: ReadonlySet<string>;
}

/** The most attractors. More could not be distinguished where six maps share a window. */
export const MOST_ATTRACTORS = 3000;

/**
 * Values with which six small maps are seen apart: rivers alone, and wide. Letters would be too small to read, and mountains
 * would look alike on all of them.
 */
const PLAIN: readonly (readonly [key: string, value: string])[] = [
  ["labels", "none"],
  ["woods", "0"],
  ["hills", "0"],
  ["width", "28"],
];

export class SideBySide {
  #variants: readonly Variant[] = [];
  /** The links on show, one per line. */
  #links = "";

  constructor(
    private readonly elements: SideBySideElements,
    private readonly renderHost: PageRenderHost,
    private readonly presets: readonly Preset[],
    private readonly events: SideBySideEvents,
  ) {
    const { dialog, play, copy, close } = elements;
    close.addEventListener("click", () => dialog.close());
    dialog.addEventListener("close", () => this.#leave());
    play.addEventListener("click", () => this.#toggle());
    copy.addEventListener("click", () => {
      void events.copy().then((said) => setText(elements.status, said));
    });
  }

  get isOpen(): boolean {
    return this.elements.dialog.open;
  }

  /** Shows the six maps with these values, in place of others that are shown. */
  open(shared: SharedValues): void {
    const presets = withSameValues(this.presets, shared);
    const links = presets.map((preset) => linkWith(shared, preset)).join("\n");
    if (this.isOpen && links === this.#links) return;
    this.#clear();
    this.#links = links;
    this.#describe(shared, presets);
    this.#variants = presets.map((preset) => this.#variant(shared, preset, presets));
    this.elements.variants.replaceChildren(...this.#variants.map(({ element }) => element));
    this.#lay();
    for (const variant of this.#variants) void variant.open(this.events.how());
    this.#show();
  }

  close(): void {
    this.elements.dialog.close();
  }

  #describe(shared: SharedValues, presets: readonly Preset[]): void {
    const { dialog, about, status } = this.elements;
    setText(status, "");
    const isHeld = this.presets.some(({ values }) => values.some(([key]) => shared.kept.has(key)));
    about.replaceChildren(...inWords(shared.values, presets, isHeld));
    dialog.style.setProperty("--aspect", shared.values.get("aspect") ?? "1");
  }

  #variant(shared: SharedValues, preset: Preset, presets: readonly Preset[]): Variant {
    const { label, help } = preset;
    const of = { link: linkWith(shared, preset), label, help, isCurrent: isShown(preset, shared.values) };
    return new Variant(this.renderHost, of, {
      chosen: () => this.#take(preset, presets),
      changed: () => this.#show(),
    });
  }

  /** Opens the dialog over the map, unless it is open. */
  #lay(): void {
    const { dialog, play } = this.elements;
    const wasOpen = this.isOpen;
    if (!wasOpen) dialog.showModal();
    play.focus({ preventScroll: true });
    if (!wasOpen) this.events.changed(true);
  }

  #leave(): void {
    // It may have been opened again by now.
    if (this.isOpen) return;
    this.#clear();
    this.events.changed(false);
  }

  #clear(): void {
    for (const variant of this.#variants) variant.close();
    this.#variants = [];
    this.elements.variants.replaceChildren();
  }

  #take(preset: Preset, all: readonly Preset[]): void {
    this.close();
    this.events.take(preset, all);
  }

  get #runs(): boolean {
    return this.#variants.some(({ state }) => state === "growing" || state === "settling");
  }

  get #isFinished(): boolean {
    return this.#variants.every(({ state }) => state === "finished" || state === undefined);
  }

  #toggle(): void {
    const { status } = this.elements;
    setText(status, "");
    const does = this.#isFinished ? "replay" : this.#runs ? "pause" : "play";
    for (const variant of this.#variants) variant[does]();
  }

  #show(): void {
    const { play, clock, status } = this.elements;
    if (this.#variants.length === 0) return;
    const isFinished = this.#isFinished && this.#variants.some(({ state }) => state === "finished");
    play.dataset["icon"] = this.#runs ? "pause" : "play";
    setText(play.querySelector("span") ?? undefined, this.#runs ? "Pause" : isFinished ? "Replay" : "Play");
    setText(clock, `Tick ${count(Math.max(...this.#variants.map(({ ticks }) => ticks)))}`);
    if (isFinished && status.textContent === "") setText(status, "All six are finished.");
  }
}

/** Returns the presets with at most `MOST_ATTRACTORS` attractors, and without the values that are kept. */
function withSameValues(presets: readonly Preset[], { values, kept }: SharedValues): Preset[] {
  const isDense = Number(values.get("attractors")) > MOST_ATTRACTORS;
  const fewer = isDense ? [["attractors", String(MOST_ATTRACTORS)] as [string, string]] : [];
  return presets.map((preset) => ({
    ...preset,
    values: [...preset.values, ...fewer].filter(([key]) => !kept.has(key)),
  }));
}

function linkWith({ link }: SharedValues, preset: Preset): string {
  return changed(link, [...preset.values, ...PLAIN, ["style", prefersDark.matches ? "dark" : "ink"]]);
}

function inWords(values: ReadonlyMap<string, string>, presets: readonly Preset[], isHeld: boolean): (Node | string)[] {
  const { attractors, seed = "" } = Object.fromEntries([...values, ...(presets[0]?.values ?? [])]);
  const same = `The variants of the river paper on the same ${count(Number(attractors))} attractors of “`;
  const held = isHeld ? " Values with a padlock stay as they are." : "";
  const cut = " What trimming cuts is red in the end.";
  return [same, el("bdi", {}, seed), `”, by one clock.${cut} Choose one to take it.${held}`];
}
