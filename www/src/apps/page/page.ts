/** Puts the parts of the page together. The recipe decides what is shown, and everything else follows it. */

import "../../style/page.css";
import { AddressBar, addressOf, linkOf } from "../../browser/address.ts";
import { copy } from "../../browser/clipboard.ts";
import { el } from "../../browser/dom.ts";
import { answerEscape } from "../../browser/keys.ts";
import { turn } from "../../browser/turn.ts";
import { Disclosures } from "../../controls/disclosure.ts";
import { isRecoverable, named, type PageError } from "../../engine/errors.ts";
import { linkText } from "../../engine/link-text.ts";
import { Recipe } from "../../engine/recipe.ts";
import type { SteerCore } from "../../engine/steer.ts";
import { loadTable, type Preset, type Table } from "../../engine/table.ts";
import type { Phase, Summary } from "../../engine/types.ts";
import type { State } from "../../player/frame-loop.ts";
import type { ShowMode } from "../../player/river-player.ts";
import { numbersOf } from "../../player/summary-text.ts";
import { type Engines, openEngines, type PageRenderHost } from "./backend.ts";
import { CountryName } from "./country-name.ts";
import { elements } from "./elements.ts";
import { CharacterSwitch } from "./help/character-switch.ts";
import { HelpSheet } from "./help/help.ts";
import { shortcuts } from "./help/shortcuts.ts";
import { OwnLand } from "./land/own-land.ts";
import { LookInside } from "./look-inside/look-inside.ts";
import { RiverPointer } from "./look-inside/river-pointer.ts";
import type { Insets, Point } from "./map/camera.ts";
import { covered } from "./map/covered.ts";
import { MapAlone } from "./map/map-alone.ts";
import { MapWords } from "./map/map-words.ts";
import { type MapLink, RiverViewport } from "./map/viewport.ts";
import { Naming } from "./naming/naming.ts";
import { withoutForeignNames } from "./naming/own-names.ts";
import { hideWhatIsAway, keepForOffline } from "./offline.ts";
import { Choices } from "./panel/choices.ts";
import { MapNames } from "./panel/map-names.ts";
import { MeasuresView } from "./panel/measures.ts";
import { Panel } from "./panel/panel.ts";
import { PresetNote } from "./panel/preset-note.ts";
import { firstLink, prefersDark, shapeOfWindow } from "./preferences.ts";
import { Downloads } from "./save/downloads.ts";
import { SaveDialog } from "./save/save-dialog.ts";
import { SendDialog } from "./share/send-dialog.ts";
import { ShareDialog } from "./share/share-dialog.ts";
import { SixWays } from "./six/six-ways.ts";
import { showFailure, showNotices } from "./status.ts";
import { Track } from "./timeline/track.ts";
import { Transport } from "./timeline/transport.ts";
import { typeAtOnce } from "./type-at-once.ts";
import { Undo } from "./undo.ts";
import { Variations } from "./variations/variations.ts";
import { Welcome } from "./welcome.ts";

class Page {
  readonly #recipe: Recipe;
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
  readonly #riverPointer = new RiverPointer(
    { ...elements, stage: elements.drawing.stage },
    {
      river: (place) => this.#viewport.ask.river(place),
      greatest: () => this.#names.greatest(),
      covered,
      failed: (error) => this.#miss(error),
    },
  );
  readonly #naming = new Naming({ ...elements, stage: elements.drawing.stage }, this.#riverPointer, {
    nameables: (place) => this.#viewport.ask.nameables(place),
    hasLabels: () => hasLetters(this.#recipe.values),
    isOwn: (mark) => this.#names.isOwn(mark),
    rename: (mark, name) => this.#names.rename(mark, name),
    failed: (error) => this.#miss(error),
  });
  readonly #inside = new LookInside(elements, {
    overlay: (name) => this.#viewport.ask.overlay(name),
    middle: () => middleOf(covered()),
    failed: (error) => {
      if (named(error).code === "no-files") this.#failBeside(error);
    },
  });
  readonly #track = new Track(elements.bar, {
    making: async (to) => {
      const making = await this.#viewport.ask.making(to);
      if (to) this.#inside.refresh();
      return making;
    },
  });
  #hasMissed = false;
  readonly #six: SixWays;
  readonly #presetNote: PresetNote;
  readonly #welcome: Welcome;

  constructor(
    core: SteerCore,
    private readonly table: Table,
    recipe: Recipe,
    viewport: RiverViewport,
    renderHost: PageRenderHost,
  ) {
    const { engine } = core;
    this.#recipe = recipe;
    this.#country = new CountryName(recipe);
    this.#viewport = viewport;
    this.#names = new MapNames(viewport, recipe, {
      changed: (names) => this.#set([["names", names]], "settle"),
      refused: (message) => this.#note(message),
    });
    this.#presetNote = new PresetNote(table.parameters, (link) => this.#undoPresets(link));
    const disclosures = new Disclosures(() => localStorage);
    this.#choices = new Choices(engine, table, disclosures, this.#names.list.element, {
      set: (values, how, isGradual) => this.#set(values, how, isGradual),
      press: (preset) => this.#press(preset),
      draw: () => this.#ownLand.ask(),
      failed: (error) => this.#failBeside(error),
    });
    this.#transport = this.#makeTransport();
    this.#ownLand = new OwnLand(engine, {
      values: () => this.#recipe.values,
      changed: (values) => this.#set(values, "settle"),
      refused: (message) => this.#note(message),
      failed: (error) => this.#failBeside(error),
    });
    const paper = disclosures.details(
      "For the curious",
      false,
      { class: "group" },
      forTheCurious(),
      this.#choices.presets,
      elements.inside,
    );
    this.#measures = new MeasuresView(disclosures, {
      measures: () => this.#viewport.ask.measures(),
      copy: (text) => this.#copy(text, "Measures copied.", text),
    });
    elements.presets.replaceChildren(paper, this.#measures.element);
    this.#six = new SixWays(renderHost, table.presets, {
      shared: () => ({ values: this.#recipe.values, kept: this.#choices.kept }),
      changed: (isOpen) => this.#cover(isOpen),
      take: (preset, all) => this.#press(preset, all),
      copy: () => this.#copiedAddress(),
      failed: (error) => this.#failBeside(error),
    });
    this.#choices.presets.append(this.#six.button);
    new Variations(elements.variations, table.parameters, {
      map: () => ({ values: this.#recipe.values, idle: this.#recipe.idle, kept: this.#choices.kept }),
      picture: (link, size) => this.#viewport.ask.picture(link, size),
      take: (values) => this.#set(values, "still"),
    });
    this.#welcome = new Welcome(
      elements.welcome,
      { address: location, referrer: document.referrer, isElsewhere: this.#six.areAskedFor },
      () => sessionStorage,
      (word) => this.#grow(word),
    );
    const keys = shortcuts(() => void this.#copyLink());
    new HelpSheet(elements.help, keys, new CharacterSwitch(() => localStorage), () => this.#six.open());
    const alone = new MapAlone(elements.mapAlone, () => this.#viewport.refit());
    const panel = new Panel(elements.panel, disclosures, () => this.#viewport.refit());
    answerEscape([this.#naming, this.#riverPointer, this.#ownLand, panel, this.#inside, alone]);
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

  #makeTransport(): Transport {
    return new Transport(elements.transport, {
      toggle: () => this.#viewport.toggle(),
      speed: (speed) => {
        this.#viewport.speed = speed;
      },
    });
  }

  #listen(): void {
    elements.reset.addEventListener("click", () => this.#reset());
    const downloads = new Downloads(this.#recipe, this.#country, {
      make: (link, format, rasters) => this.#viewport.ask.file(link, format, rasters),
      failed: (error) => this.#failBeside(error),
    });
    new SaveDialog(elements.saving, this.#recipe, downloads, () => localStorage);
    const sending = new SendDialog(elements.sending, this.#recipe, this.#country, downloads);
    new ShareDialog(elements.sharing, this.#recipe, downloads, sending);
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

  #press(preset: Preset, all: readonly Preset[] = this.table.presets): void {
    const values = this.#choices.unkept(preset);
    this.#presetNote.press({ ...preset, values }, all, this.#recipe, () => this.#set(values, "still"));
    this.#showNotices();
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
      this.#recipe.set(withoutForeignNames(changes, this.#recipe.values));
      if (changes.some(([key]) => key === "seed")) this.#welcome.leave();
      this.#show(how, this.#undo.isStep(isGradual ? changes.map(([key]) => key).join() : undefined));
    });
  }

  /** Grows a country from a word that was not typed into the seed's own box. */
  #grow(word: string): void {
    this.#choices.replaceSeed(word);
    this.#set([["seed", word]], "still");
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
    if (link !== this.#recipe.link) this.#open(link, false);
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
    this.#offerReset();
    this.#ownLand.show(values);
    this.#showName();
    this.#showNotices();
  }

  /** Opens the map of all defaults for this word, in the window's shape. */
  #reset(): void {
    this.#open(
      linkText([
        ["seed", this.#recipe.seed],
        ["aspect", this.#usualAspect],
      ]),
    );
  }

  get #usualAspect(): string {
    return shapeOfWindow(this.#recipe.defaults.get("aspect") ?? "");
  }

  /** Offers to reset all while there is something to reset. */
  #offerReset(): void {
    const { values, defaults } = this.#recipe;
    const usual = new Map([...defaults, ["aspect", this.#usualAspect], ["seed", this.#recipe.seed]]);
    const isUsual = [...usual].every(([key, text]) => values.get(key) === text);
    const { reset, panel } = elements;
    if (isUsual && document.activeElement === reset) panel.close.focus();
    reset.hidden = isUsual;
  }

  /** Shows the name of the country. */
  #showName(): void {
    const { text } = this.#country;
    elements.title.textContent = text;
    document.title = text === "" ? "Riverseed" : `${text} · Riverseed`;
    this.#welcome.show(text, this.#recipe.seed);
  }

  #showNotices(): void {
    showNotices(elements.notices, [...this.#recipe.notices.values(), ...this.#presetNote.notes], () => {
      this.#recipe.dismissNotices();
      this.#presetNote.forget();
      this.#showNotices();
    });
  }

  /** Follows a change of the viewport with the controls, the caption, the text alternative and the announcement. */
  #follow(state: State, phase: Phase, summary: Summary): void {
    elements.facade.hidden = true;
    this.#transport.show(state);
    elements.frame.dataset["state"] = state;
    this.#riverPointer.follow(state, this.#viewport.link);
    this.#naming.follow();
    this.#inside.follow(state, summary.growth);
    void this.#track.follow();
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
    this.#welcome.meet();
    this.#words.tell(names, seed, phase, summary);
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
    if (error.code === "no-labels") this.#note(error.message);
    else if (isRecoverable(error) && this.#viewport.link !== "") {
      // The core kept its river, so the page goes back to the values of that one.
      this.#recipe.restore(this.#viewport.link);
      this.#showRecipe();
      this.#note(error.message);
    } else {
      this.#viewport.close();
      fail(error);
    }
  }

  /** Shows a failure of something other than the river on show, which goes on unless the engine has stopped. */
  #failBeside(thrown: unknown): void {
    const error = named(thrown);
    if (error.code === "panic") this.#fail(error);
    else this.#note(error.message);
  }

  /** Notes once that the part that tells about rivers did not arrive: a moving pointer asks for it again and again. */
  #miss(thrown: unknown): void {
    const { code, message } = named(thrown);
    if (code !== "no-files" || this.#hasMissed) return;
    this.#hasMissed = true;
    this.#note(message);
  }

  #note(message: string): void {
    showNotices(elements.notices, [message], () => this.#showNotices());
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

/** Returns the middle of the part of the window that nothing covers. */
function middleOf({ left, top, right, bottom }: Insets): Point {
  return { x: (left + innerWidth - right) / 2, y: (top + innerHeight - bottom) / 2 };
}

/** Returns the map that a recipe shows. */
function mapOf({ shown, aspect }: Recipe): MapLink {
  return { link: shown, aspect };
}

/** Returns whether names or a title are shown. An automatic title comes with names. */
function hasLetters(values: ReadonlyMap<string, string>): boolean {
  return values.get("labels") !== "none" || !/^(none|auto)$/.test(values.get("cartouche") ?? "none");
}

function forTheCurious(): HTMLElement {
  return el("summary", {}, el("h2", {}, "For the curious"));
}

/** Shows a failure that leaves no picture, in the picture's place and on the console. */
function fail(thrown: unknown): void {
  const error = warn(thrown);
  elements.facade.hidden = true;
  showFailure(elements.failure, error);
}

/** Logs a failure on the console, for the owner of the site. */
function warn(thrown: unknown): PageError {
  const error = named(thrown);
  console.warn(`riverseed: ${error.code}: ${error.message}`);
  return error;
}

/**
 * Waits until the poster, if there is one, has been painted. The engine is fetched after that, so that the visitor sees
 * the poster sooner.
 */
async function posterIsSeen(): Promise<void> {
  const isLinked = "linked" in document.documentElement.dataset;
  if (isLinked || document.hidden || !PerformanceObserver.supportedEntryTypes.includes("paint")) return;
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
    linked || firstLink(),
    () => prefersDark.matches,
  );
  const viewport = new RiverViewport(renderHost, elements, mapOf(recipe), covered);
  viewport.start("still", linked !== "");
  const shut = (error: unknown): never => {
    viewport.close();
    throw error;
  };
  await turn();
  const page = new Page(own, await table.catch(shut), recipe, viewport, renderHost);
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
