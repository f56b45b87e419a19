/** Puts the parts of the page together. The recipe decides what is shown, and everything else follows it. */

import { AddressBar, addressOf, asQuery, linkOf } from "../../browser/address.ts";
import { copy } from "../../browser/clipboard.ts";
import { el } from "../../browser/dom.ts";
import { answerEscape } from "../../browser/keys.ts";
import { COUNTRY } from "../../controls/countries.ts";
import { Disclosures } from "../../controls/disclosure.ts";
import { isRecoverable, named } from "../../engine/errors.ts";
import { changed } from "../../engine/link-text.ts";
import type { Recipe } from "../../engine/recipe.ts";
import type { Preset, Table } from "../../engine/table.ts";
import type { Phase, Summary } from "../../engine/types.ts";
import type { WholeCore } from "../../engine/whole.ts";
import type { State } from "../../player/frame-loop.ts";
import type { ShowMode } from "../../player/river-player.ts";
import { numbersOf } from "../../player/summary-text.ts";
import type { PageRenderHost } from "./backend.ts";
import { CountryName } from "./country-name.ts";
import { OfTheDay } from "./day/of-the-day.ts";
import { elements } from "./elements.ts";
import { fail, warn } from "./failure.ts";
import { CharacterSwitch } from "./help/character-switch.ts";
import { HelpSheet } from "./help/help.ts";
import { shortcuts } from "./help/shortcuts.ts";
import { OwnLand } from "./land/own-land.ts";
import { MapAlone } from "./map/map-alone.ts";
import { MapWords } from "./map/map-words.ts";
import type { MapLink, RiverViewport } from "./map/viewport.ts";
import { withoutForeignNames } from "./naming/own-names.ts";
import { Notices } from "./notices.ts";
import { hideWhatIsAway, keepForOffline } from "./offline.ts";
import { makeDialogs } from "./outgoing.ts";
import { OverMap } from "./over-map.ts";
import { Choices } from "./panel/choices.ts";
import { MapNames } from "./panel/map-names.ts";
import { MeasuresView } from "./panel/measures.ts";
import { Panel } from "./panel/panel.ts";
import { PresetNote } from "./panel/preset-note.ts";
import { firstLink, prefersDark } from "./preferences.ts";
import { Reset } from "./reset.ts";
import { SixWays } from "./six/six-ways.ts";
import { Transport } from "./timeline/transport.ts";
import { Undo } from "./undo.ts";
import { Variations } from "./variations/variations.ts";
import { Welcome } from "./welcome.ts";

export class Page {
  readonly #recipe: Recipe;
  readonly #isAddress: (word: string) => boolean;
  readonly #choices: Choices;
  readonly #viewport: RiverViewport;
  readonly #transport: Transport;
  readonly #ownLand: OwnLand;
  readonly #undo = new Undo(
    elements.undo,
    () => this.#address.flush(),
    () => this.#ownLand.isOpen,
  );
  readonly #address = new AddressBar((link, isStep) => this.#undo.write(this.#six.inAddress(link), isStep));
  readonly #names: MapNames;
  readonly #country: CountryName;
  readonly #measures: MeasuresView;
  readonly #words = new MapWords(elements);
  readonly #overMap: OverMap;
  readonly #notices: Notices;
  readonly #reset: Reset;
  readonly #six: SixWays;
  readonly #presetNote: PresetNote;
  readonly #welcome: Welcome;
  readonly #day: OfTheDay;

  /** Makes the parts in an order in which each finds there what it is made of. What they call later may be any other. */
  constructor(
    { engine }: WholeCore,
    private readonly table: Table,
    recipe: Recipe,
    viewport: RiverViewport,
    renderHost: PageRenderHost,
    /** The word of the day, if the visitor has come for its country. */
    day: string | undefined,
  ) {
    this.#recipe = recipe;
    this.#day = new OfTheDay(elements.ofTheDay, day);
    this.#isAddress = (word) => engine.isAddress(word);
    this.#viewport = viewport;
    this.#country = new CountryName(recipe);
    this.#presetNote = new PresetNote(table.parameters, (link) => this.#undoPresets(link));
    this.#notices = new Notices(recipe, this.#presetNote);
    this.#names = this.#makeNames();
    this.#overMap = new OverMap(viewport.ask, recipe, this.#names);
    const disclosures = new Disclosures(() => localStorage);
    this.#choices = this.#makeChoices(engine, disclosures);
    this.#transport = this.#makeTransport();
    this.#ownLand = this.#makeOwnLand(engine);
    this.#measures = this.#makeMeasures(disclosures);
    this.#fillPanel(disclosures);
    this.#six = this.#makeSix(renderHost);
    this.#choices.presets.append(this.#six.button);
    this.#makeVariations();
    this.#welcome = this.#makeWelcome();
    this.#makeHelp();
    const alone = new MapAlone(elements.mapAlone, () => viewport.refit());
    const panel = new Panel(elements.panel, disclosures, () => viewport.refit());
    const { cards, inside } = this.#overMap;
    answerEscape([...cards, this.#ownLand, panel, inside, alone]);
    this.#reset = new Reset(recipe, (link) => this.#open(link));
    makeDialogs(recipe, this.#country, {
      make: (link, format, rasters) => viewport.ask.file(link, format, rasters),
      letters: (link) => viewport.ask.letters(link),
      failed: (error) => this.#failBeside(error),
    });
    this.#listen();
  }

  /** Enables the controls and shows the first river. */
  start(): void {
    this.#transport.enable();
    const { dice, land, download, reset, sending, sharing, drawing, panel, zoom } = elements;
    const { draw } = drawing;
    for (const button of [dice, land, sending.open, download, sharing.open, reset, draw, panel.open, zoom.closer])
      button.disabled = false;
    // First, so that the address keeps asking for them.
    if (this.#six.areAskedFor) this.#six.open();
    this.#showRecipe();
    this.#viewport.listen({
      changed: (state, phase, summary) => this.#follow(state, phase, summary),
      failed: (error) => this.#fail(error),
    });
  }

  // ---- the parts

  #makeNames(): MapNames {
    return new MapNames(this.#viewport, this.#recipe, {
      changed: (names) => this.#set([["names", names]], "settle"),
      refused: (message) => this.#notices.say(message),
    });
  }

  #makeChoices(engine: WholeCore["engine"], disclosures: Disclosures): Choices {
    return new Choices(engine, this.table, disclosures, this.#names.list.element, {
      set: (values, how, isGradual) => this.#set(values, how, isGradual),
      type: (word) => this.#type(word, true),
      press: (preset) => this.#press(preset),
      draw: () => this.#ownLand.ask(),
      failed: (error) => this.#failBeside(error),
    });
  }

  #makeTransport(): Transport {
    return new Transport(elements.transport, {
      toggle: () => this.#viewport.toggle(),
      speed: (speed) => {
        this.#viewport.speed = speed;
      },
    });
  }

  #makeOwnLand(engine: WholeCore["engine"]): OwnLand {
    return new OwnLand(engine, {
      values: () => this.#recipe.values,
      changed: (values) => this.#set(values, "settle"),
      refused: (message) => this.#notices.say(message),
      failed: (error) => this.#failBeside(error),
    });
  }

  #makeMeasures(disclosures: Disclosures): MeasuresView {
    return new MeasuresView(disclosures, {
      measures: () => this.#viewport.ask.measures(),
      copy: (text) => this.#copy(text, "Measures copied.", text),
    });
  }

  /** Puts what is of the paper, and the measures, below the choices. */
  #fillPanel(disclosures: Disclosures): void {
    const title = el("summary", {}, el("h2", {}, "For the curious"));
    const { presets } = this.#choices;
    const paper = disclosures.details("For the curious", false, { class: "group" }, title, presets, elements.inside);
    elements.presets.replaceChildren(paper, this.#measures.element);
  }

  #makeSix(renderHost: PageRenderHost): SixWays {
    return new SixWays(renderHost, this.table.presets, {
      shared: () => {
        const { shown, values } = this.#recipe;
        return { link: changed(shown, this.#choices.pins(this.#recipe)), values, kept: this.#choices.kept };
      },
      changed: (isOpen) => this.#cover(isOpen),
      take: (preset, all) => this.#press(preset, all),
      copy: () => this.#copiedAddress(),
      failed: (error) => this.#failBeside(error),
    });
  }

  #makeVariations(): void {
    new Variations(elements.variations, this.table.parameters, {
      map: () => {
        const { shown: link, values, idle } = this.#recipe;
        return { link, values, idle, kept: this.#choices.kept };
      },
      picture: (link, size) => this.#viewport.ask.picture(link, size),
      take: (values) => this.#set(values, "still"),
    });
  }

  #makeWelcome(): Welcome {
    return new Welcome(
      elements.welcome,
      { address: location, referrer: document.referrer, isElsewhere: this.#six.areAskedFor },
      () => sessionStorage,
      (word) => this.#grow(word),
    );
  }

  #makeHelp(): void {
    const keys = shortcuts(() => void this.#copyLink());
    new HelpSheet(elements.help, keys, new CharacterSwitch(() => localStorage), () => this.#six.open());
  }

  #listen(): void {
    // Elements above the bar are placed by its height.
    new ResizeObserver(() => {
      document.documentElement.style.setProperty("--bar-height", `${elements.bar.offsetHeight}px`);
      this.#viewport.refit();
    }).observe(elements.bar);
    // Without hashchange, which follows the popstate of another fragment: the link would be opened twice.
    window.addEventListener("popstate", () => this.#followAddress());
    prefersDark.addEventListener("change", () => this.#followScheme());
    hideWhatIsAway(document.querySelectorAll<HTMLAnchorElement>(".gallery-link, .docs-link"));
    window.addEventListener("pagehide", () => this.#address.flush());
  }

  // ---- the recipe

  #press(preset: Preset, all: readonly Preset[] = this.table.presets): void {
    const values = this.#choices.unkept(preset);
    this.#presetNote.press({ ...preset, values }, all, this.#recipe, () => this.#set(values, "still"));
    this.#notices.show();
  }

  /** Rests the map while six others cover it, and updates the address, which tells which are shown. */
  #cover(isCovered: boolean): void {
    this.#viewport.isCovered = isCovered;
    this.#address.show(this.#recipe.link);
  }

  /** Goes back to the recipe from before the presets. */
  #undoPresets(link: string): void {
    this.#open(link);
    this.#choices.focusPreset();
  }

  /**
   * Changes some values of the recipe on show. That is a step that can be undone, or part of one if it is a gradual
   * change.
   */
  #set(values: Iterable<readonly [key: string, value: string]>, how: ShowMode, isGradual = how === "settle"): void {
    this.#attempt(() => {
      const changes = [...values];
      this.#presetNote.forget();
      this.#recipe.set(withoutForeignNames([...this.#choices.pins(this.#recipe), ...changes], this.#recipe));
      if (changes.some(([key]) => key === "seed")) this.#welcome.leave();
      this.#show(how, this.#undo.isStep(isGradual ? changes.map(([key]) => key).join() : undefined));
    });
  }

  /** Grows the country of a typed word, or opens the map whose address was pasted in place of one. */
  #type(word: string, isGradual: boolean): void {
    if (this.#isAddress(word)) {
      this.#welcome.leave();
      this.#open(word);
    } else this.#set([["seed", word]], "still", isGradual);
  }

  /** Grows a country from a word that was not typed into the seed's own box. */
  #grow(word: string): void {
    this.#choices.replaceSeed(word);
    this.#type(word, false);
  }

  /**
   * Opens another link instead of the recipe on show. `isStep` is false if the link comes from undoing or redoing a
   * step.
   */
  #open(link: string, isStep = true): void {
    this.#attempt(() => {
      this.#presetNote.forget();
      this.#recipe.open(link);
      this.#choices.replaceSeed(this.#recipe.seed);
      this.#show("still", isStep && this.#undo.isStep());
    });
  }

  /** Runs some work that uses the engine, and shows its failure. */
  #attempt(work: () => void): void {
    try {
      work();
    } catch (error) {
      this.#fail(error);
    }
  }

  /** Follows a change of the address: a link was pasted into it, or the visitor went back to one. */
  #followAddress(): void {
    const link = linkOf(location);
    const areAskedFor = this.#six.areAskedFor;
    this.#undo.arrived();
    this.#address.drop();
    if (!areAskedFor) this.#six.close();
    if (link !== this.#recipe.link) this.#open(asQuery(link) || firstLink(), false);
    if (areAskedFor) this.#six.open();
    this.#address.show(this.#recipe.link);
  }

  /** Follows the visitor's colour scheme, which has become dark or light. */
  #followScheme(): void {
    this.#attempt(() => {
      this.#recipe.refresh();
      this.#show("settle");
    });
  }

  #show(how: ShowMode, isStep = false): void {
    this.#showRecipe(isStep);
    this.#viewport.show(mapOf(this.#recipe), how);
  }

  #showRecipe(isStep = false): void {
    const { link, values } = this.#recipe;
    this.#address.show(link, isStep);
    document.documentElement.dataset["style"] = values.get("style") ?? "";
    this.#choices.show(this.#recipe);
    this.#reset.offer();
    this.#ownLand.show(values);
    this.#day.show(this.#recipe.seed);
    this.#showName();
    this.#notices.show();
  }

  /** Shows the name of the country. */
  #showName(): void {
    const { text } = this.#country;
    elements.title.textContent = text;
    document.title = text === "" ? "Riverseed" : `${text} · Riverseed`;
    this.#welcome.show(text, this.#recipe.seed);
  }

  /** Follows a change of the viewport with the controls, the caption, the text alternative and the announcement. */
  #follow(state: State, phase: Phase, summary: Summary): void {
    elements.facade.hidden = true;
    this.#transport.show(state);
    elements.frame.dataset["state"] = state;
    this.#overMap.follow(state, this.#viewport.link, summary.growth);
    elements.frame.dataset["phase"] = phase;
    this.#words.follow(this.#recipe.seed, state, phase, summary);
    if (state === "finished") void this.#finished(phase, summary);
    else this.#names.list.hold();
  }

  async #finished(phase: Phase, summary: Summary): Promise<void> {
    // Their failure is only logged: nobody asked for them, and the map is complete without them.
    this.#refreshThumbnails().catch(warn);
    void this.#measures.refresh(numbersOf(summary));
    void keepForOffline();
    const { seed } = this.#recipe;
    const names = await this.#names.refresh();
    if (this.#country.learn(names)) this.#showName();
    this.#welcome.meet(this.#recipe.values.get("land"));
    const kind = this.table.countries.find(({ name }) => name === this.#recipe.values.get(COUNTRY))?.label ?? "";
    this.#words.tell([this.#day.words(seed), kind], names, seed, phase, summary);
  }

  #refreshThumbnails(): Promise<void> {
    return this.#choices.strip.refresh(
      () => this.#recipe.link,
      (styles, size) => this.#viewport.ask.thumbnails(styles, size),
    );
  }

  /** Shows why a river cannot be shown. */
  #fail(thrown: unknown): void {
    const error = named(thrown);
    if (isRecoverable(error) && this.#viewport.link !== "") {
      // The core kept its river, so the page goes back to the values of that one.
      this.#recipe.restore(this.#viewport.link);
      this.#showRecipe();
      this.#notices.say(error.message);
    } else {
      this.#viewport.close();
      fail(error);
    }
  }

  /** Shows a failure of something other than the river on show, which goes on unless the engine has stopped. */
  #failBeside(thrown: unknown): void {
    const error = named(thrown);
    if (error.code === "panic") this.#fail(error);
    else this.#notices.say(error.message);
  }

  async #copy(text: string, done: string, instead: string): Promise<void> {
    elements.shared.textContent = (await copy(text)) ? done : instead;
  }

  async #copyLink(): Promise<void> {
    elements.shared.textContent = await this.#copiedAddress();
  }

  /** Copies the address of what is on show, and returns a message about it. */
  async #copiedAddress(): Promise<string> {
    this.#address.flush();
    const address = addressOf(this.#six.inAddress(this.#recipe.link), location.href);
    return (await copy(address)) ? "Link copied." : `Copy this link: ${address}`;
  }
}

/** Returns the map that a recipe shows. */
export function mapOf({ shown, aspect }: Recipe): MapLink {
  return { link: shown, aspect };
}
