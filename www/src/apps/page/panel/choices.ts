/** The controls by which a visitor chooses a map: seed, country, land, style, presets, and the panel's controls. */

import { el } from "../../../browser/dom.ts";
import { automaticValue, type Controls, controls } from "../../../controls/controls.ts";
import { COUNTRY, Countries, goingTo } from "../../../controls/countries.ts";
import type { Disclosures } from "../../../controls/disclosure.ts";
import { LandChoice } from "../../../controls/land-choice.ts";
import { Padlocks } from "../../../controls/padlocks.ts";
import { type Presets, presets } from "../../../controls/presets.ts";
import { SeedBox } from "../../../controls/seed.ts";
import { AUTO } from "../../../engine/link-text.ts";
import type { Recipe } from "../../../engine/recipe.ts";
import type { Country, Parameter, Preset, Table } from "../../../engine/table.ts";
import type { WholeCore } from "../../../engine/whole.ts";
import type { ShowMode } from "../../../player/river-player.ts";
import { elements } from "../elements.ts";
import { freshAspect } from "../preferences.ts";
import { StyleStrip } from "./style-strip.ts";

type Values = readonly (readonly [key: string, value: string])[];

export interface ChoicesEvents {
  /**
   * Sets some values. A gradual change may continue the last undoable step; by default changes with "settle" are
   * gradual.
   */
  set(values: Values, how: ShowMode, isGradual?: boolean): void;
  /** Takes what was typed or pasted as a word. */
  type(word: string): void;
  /** Called when a preset is pressed. */
  press(preset: Preset): void;
  /** Opens the tool for drawing a land. */
  draw(): void;
  failed(error: unknown): void;
}

export class Choices {
  readonly strip: StyleStrip;
  // What is kept is said by any change.
  readonly #padlocks = new Padlocks(
    () => localStorage,
    () => this.events.set([], "settle"),
  );
  readonly #controls: Controls;
  readonly #presets: Presets;
  readonly #countries: Countries;
  readonly #seedBox: SeedBox;
  readonly #land: LandChoice;
  /** The shape of the map on show, and the default. */
  #aspects = { now: "", usual: "" };

  constructor(
    private readonly engine: WholeCore["engine"],
    private readonly table: Table,
    disclosures: Disclosures,
    /** The list of names. */
    names: HTMLElement,
    private readonly events: ChoicesEvents,
  ) {
    const { parameters } = table;
    const parameter = (wanted: string): Parameter | undefined => parameters.find(({ key }) => key === wanted);
    const choose = (values: Values): void => this.#choose(values);
    this.#controls = controls(parameters, choose, disclosures, this.#padlocks, elements.speedSetting);
    this.#presets = presets(table.presets, (preset) => events.press(preset));
    const padlock = this.#padlocks.padlock("Country", [COUNTRY]);
    this.#countries = new Countries(table.countries, padlock, (country) => this.#goToCountry(country));
    this.#seedBox = new SeedBox(elements.seedForm, elements.seed, (word) => events.type(word));
    describeSeed(parameter("seed"));
    this.#land = new LandChoice(elements.land, parameter("land"), (kind) => choose([["land", kind]]));
    this.strip = new StyleStrip(elements.styles, parameter("style"), table.countries, {
      style: (style) => choose([["style", style]]),
      country: (country) => this.#goToCountry(country),
    });
    elements.dice.addEventListener("click", () => this.#throwDice());
    const { front, settings } = this.#controls;
    elements.front.replaceChildren(front);
    elements.controls.replaceChildren(foldedNames(names, disclosures), settings);
    elements.countries.replaceChildren(this.#countries.element);
  }

  /** The preset buttons, for their place in the panel. */
  get presets(): HTMLElement {
    return this.#presets.element;
  }

  /** The keys that presets may not change. */
  get kept(): ReadonlySet<string> {
    return this.#padlocks.kept;
  }

  /** Returns the values of a preset without those that are kept. */
  unkept({ values }: Preset): Preset["values"] {
    return values.filter(([key]) => !this.kept.has(key));
  }

  /**
   * Returns what a change has to say besides, so that what is kept stays as it is: nothing of what somebody has said
   * already.
   */
  pins({ values, asked, idle }: Recipe): Values {
    const isLeft = (key: string): boolean => asked.get(key) === AUTO && !idle.has(key);
    return [...this.kept].filter(isLeft).map((key) => [key, values.get(key) ?? AUTO]);
  }

  show(recipe: Recipe): void {
    const { values, asked, defaults, seed } = recipe;
    this.strip.show(values.get("style") ?? "", (country) => this.#changesNothing(country, recipe));
    this.#controls.show(recipe);
    this.#presets.show(values);
    this.#countries.show(values, asked);
    this.#seedBox.show(seed);
    this.#land.show(asked.get("land") ?? "", automaticValue("land", recipe));
    this.#aspects = { now: values.get("aspect") ?? "", usual: defaults.get("aspect") ?? "" };
  }

  /** Replaces the seed in its box, whatever is typed there. */
  replaceSeed(seed: string): void {
    this.#seedBox.replace(seed);
  }

  /** Puts the focus on the preset that was pressed last. */
  focusPreset(): void {
    this.#presets.focus();
  }

  /** Takes other values from a control. For a drawn land it also opens the drawing tool. */
  #choose(values: Values): void {
    this.events.set(values, "settle");
    if (values.some(([key, text]) => key === "land" && text === "drawn")) this.events.draw();
  }

  /** Goes to a country, but for what is kept. */
  #goToCountry(country: Country): void {
    this.events.set(goingTo(country, this.table.parameters, this.kept), "still");
  }

  /** Returns whether a country is on show already, as far as nothing is kept. */
  #changesNothing(country: Country, { values, asked }: Recipe): boolean {
    const [, ...left] = goingTo(country, this.table.parameters, this.kept);
    return values.get(COUNTRY) === country.name && left.every(([key, text]) => asked.get(key) === text);
  }

  #throwDice(): void {
    try {
      const { now, usual } = this.#aspects;
      const aspect = this.kept.has("aspect") ? now : freshAspect(now, usual);
      const seed = this.engine.freshSeed();
      this.replaceSeed(seed);
      this.events.set(
        [["seed", seed], ["aspect", aspect], ...(this.kept.has(COUNTRY) ? [] : [[COUNTRY, AUTO] as const])],
        "still",
      );
    } catch (error) {
      this.events.failed(error);
    }
  }
}

/** Folds the list of names away. */
function foldedNames(names: HTMLElement, disclosures: Disclosures): HTMLElement {
  const summary = el("summary", {}, el("h2", {}, "Names on the map"));
  return disclosures.details(
    "Names on the map",
    false,
    { class: "group" },
    summary,
    el("div", { class: "members" }, names),
  );
}

/** Gives the seed box of index.html the length and help text from the table. */
function describeSeed(seed: Parameter | undefined): void {
  if (!seed) return;
  // Its box takes more than a seed: an address may be pasted. The core cuts what is too long, and says so.
  elements.seedHelp.textContent = seed.help;
}
