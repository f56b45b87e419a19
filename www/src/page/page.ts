/** The page: puts the parts together. The recipe says what is shown; everything else follows it. */

import "../style/page.css";
import { AddressBar, addressOf, asksForSix, linkOf, withSix } from "../browser/address.ts";
import { count } from "../browser/count.ts";
import { DARK_PAGES } from "../browser/dark-pages.ts";
import { el, setText } from "../browser/dom.ts";
import { turn } from "../browser/turn.ts";
import { type Controls, controls } from "../controls/controls.ts";
import { Disclosures } from "../controls/disclosure.ts";
import { LandChoice } from "../controls/land-choice.ts";
import { Padlocks } from "../controls/padlocks.ts";
import { PresetButtons, type Presets, presets, unaskedChanges } from "../controls/presets.ts";
import { SeedBox } from "../controls/seed.ts";
import { isRecoverable, named } from "../engine/errors.ts";
import type { FullCore, Parameter, Preset } from "../engine/full.ts";
import { Recipe } from "../engine/recipe.ts";
import { loadTracing } from "../engine/tracing.ts";
import type { Phase, Summary } from "../engine/types.ts";
import { Drawing } from "../land/drawing.ts";
import { listenForImages } from "../land/image-drop.ts";
import { pixelsOf } from "../land/image-file.ts";
import type { State } from "../player/frame-loop.ts";
import type { ShowMode } from "../player/river-player.ts";
import { alternative, caption, remainderOf, sentence } from "../player/summary-text.ts";
import { Downloads } from "../share/downloads.ts";
import { SaveDialog } from "../share/save-dialog.ts";
import { copy } from "../share/share.ts";
import { ShareDialog } from "../share/share-dialog.ts";
import { type Engines, openEngines, type PageRenderHost } from "./backend.ts";
import type { Insets, Point } from "./camera.ts";
import { covered } from "./covered.ts";
import { elements } from "./elements.ts";
import { HelpSheet, type Shortcut } from "./help.ts";
import { LookInside } from "./look-inside.ts";
import { MapAlone } from "./map-alone.ts";
import { MeasuresView } from "./measures.ts";
import { type Named, NameList, namedOf } from "./name-list.ts";
import { keepForOffline } from "./offline.ts";
import { Panel } from "./panel.ts";
import { isRiver, RiversUnderHand } from "./rivers-under-hand.ts";
import { SeedTrail } from "./seed-trail.ts";
import { SideBySide } from "./side-by-side.ts";
import { Announcer, showFailure, showNotices, undoable } from "./status.ts";
import { StyleStrip } from "./style-strip.ts";
import { Track } from "./track.ts";
import { Transport } from "./transport.ts";
import { Undo } from "./undo.ts";
import { RiverViewport } from "./viewport.ts";

const prefersStill = window.matchMedia("(prefers-reduced-motion: reduce)");
const prefersDark = window.matchMedia(DARK_PAGES);

/** What a visit without a link begins with: the map at its best, by day and by night, in the window's shape. */
function firstLink(): string {
  const style = prefersDark.matches ? "night" : "atlas";
  const shape = innerWidth < innerHeight ? "&aspect=0.75" : "";
  return `style=${style}&labels=some${shape}`;
}

/** What build/countries.ts draws, beside the page. */
const COUNTRY_PICTURES = "./countries";

/** How many rivers have their names in the panel. */
const NAMED_RIVERS = 12;

class Page {
  readonly #table: readonly Parameter[];
  readonly #recipe: Recipe;
  readonly #controls: Controls;
  readonly #padlocks = new Padlocks(() => localStorage);
  readonly #presets: Presets;
  readonly #countries: PresetButtons;
  readonly #seedBox: SeedBox;
  readonly #land: LandChoice;
  readonly #viewport: RiverViewport;
  readonly #transport: Transport;
  readonly #drawing: Drawing;
  readonly #undo = new Undo(
    elements.undo,
    () => this.#address.flush(),
    () => this.#drawing.isOpen,
  );
  readonly #address = new AddressBar((link, isStep) => this.#undo.write(this.#inAddress(link), isStep));
  readonly #trail = new SeedTrail(elements.trail, (seed) => this.#goToSeed(seed));
  readonly #strip: StyleStrip;
  /** The map that the small pictures are of. */
  #thumbnailsOf: string | undefined;
  readonly #nameList = new NameList({
    names: () => this.#names(),
    rename: (mark, name) => void this.#rename(mark, name),
  });
  readonly #measures: MeasuresView;
  /** What the caption says of the greatest river, once its name is known. */
  #greatest = "";
  readonly #underHand = new RiversUnderHand(
    { ...elements, stage: elements.drawing.stage },
    {
      river: (place) => this.#viewport.river(place),
      greatest: async () => (await this.#names()).map(({ mark }) => mark).filter(isRiver),
      covered,
    },
  );
  readonly #inside = new LookInside(elements, {
    overlay: (name) => this.#viewport.overlay(name),
    middle: () => middleOf(covered()),
  });
  readonly #track = new Track(elements.bar, {
    making: async (to) => {
      const making = await this.#viewport.making(to);
      if (to) this.#inside.refresh();
      return making;
    },
  });
  readonly #six: SideBySide;
  readonly #announcer = new Announcer(elements.announcement);
  /** What the last presets changed unasked, and the recipe from before them, to which Undo leads back. */
  #presetUndo: { message: string; link: string; values: ReadonlyMap<string, string> } | undefined;

  constructor(
    private readonly core: FullCore,
    recipe: Recipe,
    viewport: RiverViewport,
    renderHost: PageRenderHost,
  ) {
    const { engine } = core;
    this.#table = engine.parameters();
    this.#recipe = recipe;
    this.#viewport = viewport;
    const disclosures = new Disclosures(() => localStorage);
    this.#controls = controls(
      this.#table,
      (values) => this.#choose(values),
      disclosures,
      this.#padlocks,
      new Map([["names", this.#nameList]]),
    );
    this.#presets = presets(engine.presets(), (preset) => this.#press(preset));
    this.#countries = new PresetButtons(
      "Countries",
      engine.countries(),
      (country) => this.#set(this.#unkept(country), "watch"),
      ({ name }) => `${COUNTRY_PICTURES}/${name}.webp`,
    );
    this.#seedBox = new SeedBox(elements.seedForm, elements.seed, (seed) => this.#set([["seed", seed]], "watch"));
    describeSeed(this.#table);
    const land = this.#table.find(({ key }) => key === "land");
    this.#land = new LandChoice(elements.land, land, (kind) => this.#choose([["land", kind]]));
    this.#strip = new StyleStrip(
      elements.styles,
      this.#table.find(({ key }) => key === "style"),
      (style) => this.#choose([["style", style]]),
    );
    this.#transport = this.#makeTransport();
    this.#drawing = new Drawing(elements.drawing, engine, {
      drawn: (outline) => this.#set(drawn(outline), "settle"),
      failed: (error) => this.#fail(error),
    });
    elements.countries.replaceChildren(this.#countries.element);
    const paper = disclosures.details(
      "For the curious",
      false,
      { class: "group" },
      forTheCurious(),
      this.#presets.element,
    );
    this.#measures = new MeasuresView(disclosures, {
      measures: () => this.#viewport.measures(),
      copy: (text) => this.#copy(text, "Measures copied.", text),
    });
    elements.presets.replaceChildren(paper, this.#measures.element);
    elements.controls.replaceChildren(this.#controls.element);
    this.#six = new SideBySide(elements.six, renderHost, engine.presets(), {
      changed: (isOpen) => this.#cover(isOpen),
      take: (preset, all) => this.#press(preset, all),
      copy: () => this.#copiedAddress(),
      how: () => howFor("watch"),
    });
    this.#presets.element.append(this.#compareButton());
    new HelpSheet(elements.help, shortcuts());
    new MapAlone(elements.mapAlone, () => this.#viewport.refit());
    new Panel(elements.panel, disclosures, () => this.#viewport.refit());
    this.#listen();
  }

  /** Goes with the first river. */
  start(): void {
    this.#transport.enable();
    const { dice, land, download, copy, reset, sharing, drawing, panel, zoom } = elements;
    for (const button of [dice, land, download, sharing.open, copy, reset, drawing.draw, panel.open, zoom.closer])
      button.disabled = false;
    // First, so that the address goes on saying so.
    if (asksForSix(location)) this.#openSix();
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
    elements.dice.addEventListener("click", () => this.#throwDice());
    elements.reset.addEventListener("click", () => this.#open(`seed=${encodeURIComponent(this.#recipe.seed)}`));
    const downloads = new Downloads(this.#recipe, {
      make: (link, format) => this.#viewport.file(link, format),
      failed: (error) => this.#fail(error),
    });
    new SaveDialog(elements.saving, this.#recipe, downloads, () => localStorage);
    new ShareDialog(elements.sharing, this.#recipe, downloads);
    elements.copy.addEventListener("click", () => void this.#copyLink());
    // What stands over the bar begins where it ends.
    new ResizeObserver(() => {
      document.documentElement.style.setProperty("--bar-height", `${elements.bar.offsetHeight}px`);
      this.#viewport.refit();
    }).observe(elements.bar);
    elements.drawing.draw.addEventListener("click", () => this.#showDrawing());
    listenForImages(elements.drawing, (file) => void this.#trace(file));
    // Not hashchange as well: it follows the popstate of another fragment, whose link would be opened twice.
    window.addEventListener("popstate", () => this.#followAddress());
    prefersDark.addEventListener("change", () => this.#followScheme());
    window.addEventListener("pagehide", () => this.#address.flush());
  }

  /** Turns a picture of a land into the land. */
  async #trace(file: Blob): Promise<void> {
    try {
      const tracing = await loadTracing();
      const { rgba, width, height } = await pixelsOf(file, tracing.longestTracedSide());
      const traced = tracing.traceImage(rgba, width, height);
      this.#drawing.take(traced);
      this.#set([["aspect", traced.aspect.toFixed(2)]], "settle");
    } catch (thrown) {
      const error = named(thrown);
      if (isRecoverable(error)) this.#note(error.message);
      else this.#fail(error);
    }
  }

  /** The names of the finished map, those of great rivers first; none if they cannot be had, as the viewport then says. */
  async #names(): Promise<Named[]> {
    try {
      return namedOf(await this.#viewport.names(NAMED_RIVERS));
    } catch {
      return [];
    }
  }

  /** A name of the visitor's own for something on the map, or its usual one. */
  async #rename(mark: string, name: string | undefined): Promise<void> {
    try {
      const names = await this.#viewport.renamed(() => this.#recipe.values.get("names") ?? "", mark, name);
      this.#set([["names", names]], "settle");
    } catch (thrown) {
      this.#note(named(thrown).message);
      this.#nameList.restore();
    }
  }

  /** A land that was drawn before is there again when the tool is opened. */
  #showDrawing(): void {
    const outline = this.#recipe.values.get("outline") ?? "";
    if (outline !== "" && this.#recipe.values.get("land") !== "drawn") this.#set(drawn(outline), "settle");
  }

  /** A control has other values. Whoever chooses a drawn land has to draw one. */
  #choose(values: readonly (readonly [key: string, text: string])[]): void {
    this.#set(values, "settle");
    const asksForLine = values.some(([key, text]) => key === "land" && text === "drawn");
    if (asksForLine && this.#recipe.values.get("outline") === "") this.#drawing.open();
  }

  /** A preset is pressed. A note says what it changes unasked, with the way back to before it, or to before the first of several. */
  #press(preset: Preset, all: readonly Preset[] = this.core.engine.presets()): void {
    const before = this.#presetUndo ?? { link: this.#recipe.link, values: this.#recipe.values };
    const values = this.#unkept(preset);
    const message = unaskedChanges({ ...preset, values }, all, this.#table, before.values);
    this.#set(values, "watch");
    this.#presetUndo = message === undefined ? undefined : { ...before, message };
    this.#showNotices();
  }

  /** What a preset sets, but for what is kept as it is. */
  #unkept({ values }: Preset): Preset["values"] {
    return values.filter(([key]) => !this.#padlocks.kept.has(key));
  }

  #compareButton(): HTMLElement {
    const button = el("button", { type: "button", "aria-haspopup": "dialog" }, "Compare all six");
    button.addEventListener("click", () => this.#openSix());
    return button;
  }

  #openSix(): void {
    this.#attempt(() => this.#six.open({ values: this.#recipe.values, kept: this.#padlocks.kept }));
  }

  /** The map rests while six others lie over it, and the address says which are seen. */
  #cover(isCovered: boolean): void {
    this.#viewport.isCovered = isCovered;
    this.#address.show(this.#recipe.link);
  }

  #inAddress(link: string): string {
    return this.#six.isOpen ? withSix(link) : link;
  }

  /** Back to the recipe from before the presets. */
  #undoPresets(link: string): void {
    this.#open(link);
    this.#presets.focus();
  }

  #throwDice(): void {
    this.#attempt(() => {
      const seed = this.core.engine.freshSeed();
      this.#seedBox.replace(seed);
      this.#set([["seed", seed]], "watch");
    });
  }

  #goToSeed(seed: string): void {
    this.#seedBox.replace(seed);
    this.#set([["seed", seed]], "watch");
  }

  /** Changes some values of what is shown: a step that can be undone, or a part of one. */
  #set(values: Iterable<readonly [key: string, value: string]>, how: ShowMode): void {
    this.#attempt(() => {
      const changes = [...values];
      this.#presetUndo = undefined;
      this.#recipe.set(changes);
      this.#show(how, this.#undo.isStep(changes.map(([key]) => key).join()));
    });
  }

  /** Shows another link in place of everything; as a step that can be undone, unless it is where one led. */
  #open(link: string, isStep = true): void {
    this.#attempt(() => {
      this.#presetUndo = undefined;
      this.#recipe.open(link);
      this.#seedBox.replace(this.#recipe.seed);
      this.#show("watch", isStep);
    });
  }

  /** Runs what asks the engine for something in answer to a person, and shows its failure. */
  #attempt(work: () => void): void {
    try {
      work();
    } catch (error) {
      this.#fail(error);
    }
  }

  /** The address changed under the page: somebody pasted a link over it, or went back to one. */
  #followAddress(): void {
    const link = linkOf(location);
    const asks = asksForSix(location);
    this.#undo.arrived();
    if (!asks) this.#six.close();
    if (link !== this.#recipe.link) this.#open(link, false);
    if (asks) this.#openSix();
  }

  /** The reader's pages have become dark, or light. */
  #followScheme(): void {
    this.#attempt(() => {
      this.#recipe.refresh();
      this.#show("settle");
    });
  }

  #show(how: ShowMode, isStep = false): void {
    this.#showRecipe(isStep);
    this.#viewport.show(this.#recipe.shown, howFor(how));
  }

  #showRecipe(isStep = false): void {
    const { link, values, idle, defaults, seed } = this.#recipe;
    this.#address.show(link, isStep);
    this.#trail.show(seed);
    this.#strip.show(values.get("style") ?? "");
    document.documentElement.dataset["style"] = values.get("style") ?? "";
    this.#controls.show({ values, idle, defaults });
    this.#presets.show(values);
    this.#countries.show(values);
    this.#seedBox.show(seed);
    this.#land.show(values.get("land") ?? "");
    this.#drawing.show(values.get("outline") ?? "");
    elements.title.textContent = seed;
    document.title = seed === "" ? "Riverseed" : `${seed} · Riverseed`;
    this.#showNotices();
  }

  #showNotices(): void {
    const { message, link } = this.#presetUndo ?? { message: undefined, link: "" };
    const undo = message === undefined ? [] : [undoable(message, "Undo", () => this.#undoPresets(link))];
    showNotices(elements.notices, [...this.#recipe.notices.values(), ...undo], () => {
      this.#recipe.dismissNotices();
      this.#presetUndo = undefined;
      this.#showNotices();
    });
  }

  /** The viewport changed: the caption, the text alternative and the announcement follow. */
  #follow(state: State, phase: Phase, summary: Summary): void {
    elements.facade.hidden = true;
    this.#transport.show(state);
    elements.frame.dataset["state"] = state;
    this.#underHand.follow(state);
    this.#inside.follow(state, summary.growth);
    void this.#track.follow();
    elements.frame.dataset["phase"] = phase;
    if (state !== "finished") this.#greatest = "";
    caption(state, phase, summary).forEach((line, i) => {
      setText(elements.caption.children[i], line === "" ? this.#greatest : line);
    });
    elements.canvas.setAttribute("aria-label", alternative(this.#recipe.seed, phase, summary, count));
    if (state === "finished") void this.#finished(phase, summary);
    else {
      this.#announcer.hush();
      this.#nameList.hold();
    }
  }

  async #finished(phase: Phase, summary: Summary): Promise<void> {
    this.#announcer.say(`Finished: ${sentence(summary)}`);
    this.#drawThumbnails().catch((error) => this.#fail(error));
    void this.#measures.refresh(remainderOf(summary));
    void keepForOffline();
    const isLabelled = this.#recipe.values.get("labels") !== "none";
    if (!isLabelled && !this.#nameList.isShown) return;
    const { link, seed } = this.#recipe;
    const names = await this.#names();
    if (link !== this.#recipe.link || this.#viewport.state !== "finished") return;
    this.#nameList.refresh(names);
    // Whoever does not see the labels is told the greatest.
    const rivers = names.filter(({ mark, name }) => isRiver(mark) && name !== "").slice(0, 3);
    if (!isLabelled || rivers.length === 0) return;
    this.#greatest = `Greatest: ${rivers[0]?.name}`;
    if (!summary.stopped) setText(elements.caption.children[1], this.#greatest);
    const greatest = rivers.map(({ name }) => name).join(", ");
    const told = `${alternative(seed, phase, summary, count)} Its greatest rivers: ${greatest}.`;
    elements.canvas.setAttribute("aria-label", told);
  }

  /** Unless they are of these very rivers: the style alone may have changed. */
  async #drawThumbnails(): Promise<void> {
    const map = unstyled(this.#recipe.link);
    if (map === this.#thumbnailsOf || elements.styles.getClientRects().length === 0) return;
    const made = await this.#viewport.thumbnails(this.#strip.styles, this.#strip.size);
    if (made.length === 0 || unstyled(this.#recipe.link) !== map) return;
    this.#thumbnailsOf = map;
    for (const thumbnail of made) this.#strip.draw(thumbnail);
  }

  #fail(thrown: unknown): void {
    const error = named(thrown);
    if (error.code === "no-chart") this.#note(error.message);
    else if (isRecoverable(error) && this.#viewport.link !== "") {
      // The core kept the river it had, so the page goes back to that one's values.
      this.#recipe.restore(this.#viewport.link);
      this.#showRecipe();
      this.#note(error.message);
    } else {
      this.#viewport.close();
      fail(error);
    }
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

  /** Copies the address of what is seen; what is said of that. */
  async #copiedAddress(): Promise<string> {
    this.#address.flush();
    const address = addressOf(this.#inAddress(this.#recipe.link), location.href);
    return (await copy(address)) ? "Link copied." : `Copy this link: ${address}`;
  }
}

/** The middle of what nothing covers of the window, which the map fills. */
function middleOf({ left, top, right, bottom }: Insets): Point {
  return { x: (left + innerWidth - right) / 2, y: (top + innerHeight - bottom) / 2 };
}

/** A link but for its style. */
function unstyled(link: string): string {
  const values = new URLSearchParams(link);
  values.delete("style");
  return values.toString();
}

function howFor(how: ShowMode): ShowMode {
  return prefersStill.matches ? "still" : how;
}

/** The values of a drawn land. */
function drawn(outline: string): [key: string, value: string][] {
  return [
    ["land", "drawn"],
    ["outline", outline],
  ];
}

function shortcuts(): Shortcut[] {
  const { dice, trail, panel, sharing, copy } = elements;
  return [
    { key: "r", says: "a new seed by chance", button: dice },
    { key: "[", says: "the seed before", button: trail.previous },
    { key: "]", says: "the seed after", button: trail.next },
    { key: "p", says: "the panel of shapes", button: panel.open },
    { key: "s", says: "share", button: sharing.open },
    { key: "l", says: "copy the link", button: copy },
  ];
}

function forTheCurious(): HTMLElement {
  return el("summary", {}, el("h2", {}, "For the curious"));
}

/** What the table says of the seed, for the box that index.html has. */
function describeSeed(table: readonly Parameter[]): void {
  const seed = table.find(({ key }) => key === "seed");
  if (!seed) return;
  if (seed.maxLength !== undefined) elements.seed.maxLength = seed.maxLength;
  elements.seedHelp.textContent = seed.help;
}

/** A failure that leaves no picture: shown in its place, and once on the console for the owner of the site. */
function fail(thrown: unknown): void {
  const error = named(thrown);
  console.warn(`riverseed: ${error.code}: ${error.message}`);
  elements.facade.hidden = true;
  showFailure(elements.failure, error);
}

/** The first river is on its way before the page is made, which takes as long as its first picture does. */
async function begin({ core, renderHost }: Engines): Promise<void> {
  const own = await core;
  const recipe = new Recipe(
    (text, options) => own.engine.readLink(text, options),
    () => prefersDark.matches,
  );
  recipe.open(linkOf(location) || firstLink());
  const viewport = new RiverViewport(renderHost, elements, recipe.shown, recipe.defaults.get("aspect") ?? "", covered);
  viewport.start(howFor("watch"));
  await turn();
  new Page(own, recipe, viewport, renderHost).start();
}

begin(openEngines()).catch(fail);
