/**
 * The class of `<river-seed>`, a river in a page about something else; `define.ts` registers it. Importing it has no
 * effect, even on a server.
 */

import { RESIZE_PAUSE_MS } from "../../browser/canvas.ts";
import { DARK_PAGES } from "../../browser/dark-pages.ts";
import { isRecoverable, PageError } from "../../engine/page-error.ts";
import type { Summary } from "../../engine/types.ts";
import type { Reading, Status } from "../../host/protocol.ts";
import type { Client } from "../../host/render-host.ts";
import type { State } from "../../player/frame-loop.ts";
import type { ShowMode } from "../../player/river-player.ts";
import { ASPECT, aspectOf, linkOf, makerOf, OBSERVED, type Properties, reflect, upgrade } from "./attributes.ts";
import { importPageBackend, renderHost } from "./backend.ts";
import type { CompleteDetail, RiverSeedEventMap } from "./events.ts";
import { type FileRequest, linkToRead, type Report } from "./protocol.ts";
import { Outcome, type Present, type RiverSeedPhase } from "./state.ts";
import { countIn, ENGLISH, type Strings, type Told } from "./strings.ts";
import { type Does, View } from "./view.ts";
import { watch } from "./visibility.ts";

/** The browser's class, or a stand-in where there is none. */
const Base = globalThis.HTMLElement ?? (class {} as typeof HTMLElement);

const STILL = "(prefers-reduced-motion: reduce)";

/** The action of the button in each state. */
const DOES: Record<State, Does> = { growing: "pause", settling: "pause", paused: "play", finished: "replay" };

export interface BlobOptions {
  /** Pixels on the picture's long side; by default as many as are shown. */
  longSide?: number;
}

// The interface of the same name below declares the properties that `reflect` adds.
// biome-ignore lint/suspicious/noUnsafeDeclarationMerging: every one of them is there
export class RiverSeed extends Base {
  static readonly observedAttributes: readonly string[] = OBSERVED;

  #strings: Strings = ENGLISH;
  /** Its client number at the render host, while it has a river there. */
  #id: number | undefined;
  /** Defined while the element is in a document, and aborted when it leaves. */
  #life: AbortController | undefined;
  #isNear = false;
  /** True once the reader has been near. */
  #wasNear = false;
  /** True if attributes have changed in this turn. */
  #isChanging = false;
  /** True once it has begun: it does not begin again by itself. */
  #hasBegun = false;
  #hasFailed = false;
  #isShown = false;
  /** The last request, until the river follows it: there may be no river yet, or a worker that no longer answers. */
  #asked: "play" | "pause" | "still" | { share: number } | undefined;
  #resizing: ReturnType<typeof setTimeout> | undefined;
  #aspect = ASPECT.default;
  #link: ReturnType<typeof linkToRead> | undefined;
  #reading: Reading | undefined;
  /** The status of the river on the canvas. */
  #status: Status | undefined;
  /** The status of the requested rivers; undefined until the engine has read their link. */
  #present: Present | undefined;
  #outcome = new Outcome();
  /** The number of links it has asked the engine to show after the first, as `Reading` counts them. */
  #links = 0;
  readonly #view = new View(
    this.attachShadow({ mode: "open" }),
    () => this.#press(),
    () => this.#followSoon(),
  );
  readonly #client: Client<Blob> = { hear: (report) => this.#hear(report), moved: () => this.#move() };

  connectedCallback(): void {
    // It was only moved.
    if (this.#life) return;
    upgrade(this);
    this.#life = new AbortController();
    this.#listen(this.#life.signal);
    this.#follow(true);
  }

  disconnectedCallback(): void {
    // Moving removes and inserts it in one turn.
    queueMicrotask(() => {
      if (!this.isConnected) this.#leave();
    });
  }

  attributeChangedCallback(_name: string, before: string | null, now: string | null): void {
    if (before !== now) this.#followSoon();
  }

  /** The element's strings. Those that are set replace the English ones. */
  get i18n(): Partial<Strings> {
    return this.#strings;
  }

  set i18n(strings: Partial<Strings>) {
    this.#strings = { ...ENGLISH, ...strings };
    this.#followSoon();
  }

  /** The link of the requested rivers, canonical once the engine has read it. */
  get link(): string {
    return this.#now?.link ?? linkOf(this);
  }

  /** The numbers of the requested rivers as they are now; null before they begin. */
  get summary(): Summary | null {
    return this.#now?.summary ?? null;
  }

  /** The phase of the requested rivers. */
  get phase(): RiverSeedPhase {
    const phase = this.#now?.phase ?? (this.#hasBegun ? "loading" : "idle");
    return this.#present === "failed" ? "failed" : phase;
  }

  /** The share of the way to the finished rivers, from 0 to 1. */
  get progress(): number {
    return this.#now?.progress ?? 0;
  }

  /**
   * A promise that resolves when the requested rivers are finished, and rejects with the error if they fail. There is a
   * new promise when the attributes ask for other rivers, the element leaves the document, or finished rivers grow
   * again; a pending one rejects with an `AbortError`.
   */
  get finished(): Promise<CompleteDetail> {
    this.#catchUp();
    return this.#outcome.promise;
  }

  /** Continues growing. A finished river grows again, and one that waits until it is seen begins. */
  play(): void {
    this.#ask("play");
  }

  pause(): void {
    this.#ask("pause");
  }

  /** Goes to a share of the progress, from 0 to 1, and pauses there. To go back, the rivers grow again. */
  seek(share: number): void {
    this.#ask({ share: Number(share) });
  }

  /** Grows the river again from the mouths. After a failure it tries again. */
  restart(): void {
    if (this.#id === undefined) {
      if (this.#hasFailed) {
        this.#hasBegun = this.#hasFailed = false;
        this.#renew();
      }
      this.#shape(this.#aspect);
      this.play();
    } else {
      this.#asked = "play";
      this.#growAgain();
      renderHost.send(this.#id, { do: "replay" });
    }
  }

  /** Makes a PNG of the finished river. */
  async toBlob({ longSide }: BlobOptions = {}): Promise<Blob> {
    const { width, height } = this.#view.size;
    const side = Number(longSide ?? Math.max(width, height));
    if (longSide === undefined && side === 0 && this.isConnected)
      throw refusal("is not laid out: say how long its longSide is");
    return this.#file({ format: "png", longSide: side });
  }

  /** Returns the finished rivers as the text of an SVG. */
  async toSVG(): Promise<string> {
    return (await this.#file({ format: "svg", longSide: 0 })).text();
  }

  #ask(what: "play" | "pause" | { share: number }): void {
    this.#asked = what;
    if (what !== "pause") this.#growAgain();
    if (this.#id === undefined) this.#beginIfDue();
    else this.#send(this.#id, what);
  }

  #send(id: number, what: "play" | "pause" | { share: number }): void {
    renderHost.send(id, typeof what === "string" ? { do: what } : { do: "seek", ...what });
  }

  // ---- attributes

  get #wasmUrl(): string | undefined {
    const url = this.getAttribute("wasm-url");
    return url ? new URL(url, document.baseURI).href : undefined;
  }

  get #isStill(): boolean {
    return this.hasAttribute("still") || matchMedia(STILL).matches;
  }

  /** True for a dark page: by the `theme`, or else the page's colour scheme, or else the reader's preference. */
  get #isDark(): boolean {
    const theme = this.getAttribute("theme");
    if (theme === "light" || theme === "dark") return theme === "dark";
    const schemes = getComputedStyle(this).colorScheme.split(" ");
    if (schemes.includes("dark") !== schemes.includes("light")) return schemes.includes("dark");
    return matchMedia(DARK_PAGES).matches;
  }

  get #linkNow() {
    return linkToRead(linkOf(this), this.#isDark);
  }

  /**
   * The way to show a river. One whose growth has been seen to the end is not animated again, and a picture in its
   * place gives way to the finished river alone.
   */
  get #how(): ShowMode {
    const isNews = this.#isShown || (this.#status?.state !== "finished" && this.#view.poster !== "picture");
    return isNews && !this.#isStill ? "watch" : "still";
  }

  #file(file: FileRequest): Promise<Blob> {
    if (!this.isConnected) throw refusal("is in no document");
    return renderHost.ask({ ...file, link: this.#linkNow }, this.#wasmUrl);
  }

  // ---- state

  /** The status of the requested rivers, if they have begun and not failed. */
  get #now(): Exclude<Present, "failed"> | undefined {
    this.#catchUp();
    return this.#present === "failed" ? undefined : this.#present;
  }

  /** Follows changed attributes now, so that a script that has just changed them reads the new state. */
  #catchUp(): void {
    if (this.#isChanging && this.#life) this.#follow();
  }

  /** Begins anew with other rivers or the same ones. The pending promise rejects with `why` as its reason. */
  #renew(why = ""): void {
    this.#present = undefined;
    this.#outcome.failed(new DOMException(why, "AbortError"));
    this.#outcome = new Outcome();
  }

  #growAgain(): void {
    if (this.#now?.state === "finished") this.#renew();
  }

  #advance({ link }: Reading, status: Status): void {
    if (status.state !== "finished") this.#growAgain();
    this.#present = { link, ...status };
    if (status.state === "finished") this.#outcome.done({ link, summary: status.summary });
  }

  // ---- lifecycle

  #listen(signal: AbortSignal): void {
    const on = (target: EventTarget, type: string, listener: () => void): void =>
      target.addEventListener(type, listener, { signal });
    on(document, "visibilitychange", () => this.#rest());
    on(matchMedia(DARK_PAGES), "change", () => this.#followSoon());
    on(matchMedia(STILL), "change", () => this.#finishIfStill());
    const near = (isNear: boolean): void => {
      this.#isNear = isNear;
      this.#wasNear ||= isNear;
      this.#rest();
      this.#beginIfDue();
    };
    watch(this, { near, resized: () => this.#resized(signal) }, signal);
  }

  /** Follows the attributes at the end of this turn, so that several changes count as one. */
  #followSoon(): void {
    if (this.#isChanging || !this.#life) return;
    this.#isChanging = true;
    queueMicrotask(() => {
      this.#isChanging = false;
      if (this.#life) this.#follow();
    });
  }

  /** Updates everything by the attributes. */
  #follow(isArriving = false): void {
    const before = this.#link;
    const link = this.#linkNow;
    const isNew = link.text !== before?.text || link.options.dark !== before.options.dark;
    this.#link = link;
    if (isNew && !isArriving) this.#renew("the attributes ask for other rivers");
    // Another recipe may succeed after a failure.
    if (isNew && this.#hasFailed) this.#hasBegun = this.#hasFailed = false;
    if (isNew) this.#shape(aspectOf(link.text));
    this.#describe();
    // The old status belongs to another river.
    if (isNew && this.#id === undefined) this.#status = undefined;
    if (isNew && this.#id !== undefined) {
      this.#links++;
      renderHost.send(this.#id, { do: "show", link, how: this.#how, size: this.#view.fit() });
    }
    this.#finishIfStill();
    this.#beginIfDue();
  }

  #shape(aspect: number): void {
    this.#aspect = aspect;
    this.#view.shape(aspect, this.#hasFailed);
  }

  #beginIfDue(): void {
    const isDue = this.#isNear || this.#asked === "play" || this.getAttribute("loading") === "eager";
    if (!isDue || this.#hasBegun || !this.#life || this.#view.size.width === 0) return;
    this.#hasBegun = true;
    void this.#enter(this.#life.signal);
  }

  async #enter(signal: AbortSignal): Promise<void> {
    try {
      const id = await renderHost.enter(this.#client, this.#wasmUrl);
      if (signal.aborted) renderHost.leave(id);
      else this.#open(id);
    } catch (thrown) {
      if (!signal.aborted) this.#fail(thrown instanceof PageError ? thrown : new PageError("unknown", String(thrown)));
    }
  }

  #open(id: number): void {
    const canvas = this.#view.prepare();
    const size = this.#view.fit();
    const asked = this.#asked;
    const how = asked === "still" ? asked : asked && asked !== "pause" ? "watch" : this.#how;
    renderHost.send(id, { do: "open", canvas, link: this.#linkNow, how, size });
    if (asked && asked !== "still" && asked !== "play") this.#send(id, asked);
    this.#id = id;
    this.#links = 0;
    this.#rest();
  }

  /**
   * Moves to a new engine, since the old one stopped in another river or no longer answers. The same river goes on
   * there. The old canvas is shown until the new one has a picture.
   */
  #move(): void {
    this.#id = undefined;
    const state = this.#status?.state;
    this.#asked ??= state === "finished" ? "still" : state === "paused" ? "pause" : undefined;
    if (this.#life) void this.#enter(this.#life.signal);
  }

  #leave(): void {
    this.#life?.abort();
    this.#life = undefined;
    this.#isNear = this.#wasNear = this.#hasFailed = false;
    this.#close();
    this.#renew("the river-seed was removed");
  }

  /** Closes the river and removes its canvas. */
  #close(): void {
    if (this.#id !== undefined) renderHost.leave(this.#id);
    this.#id = undefined;
    this.#hasBegun = this.#hasFailed;
    this.#isShown = false;
    this.#view.clear();
  }

  /** Rests while the tab is hidden, and until the element is seen. Once the reader is past it, it finishes unseen. */
  #rest(): void {
    if (this.#id === undefined) return;
    const isAway = document.hidden || !this.#wasNear;
    renderHost.send(this.#id, { do: isAway ? "rest" : this.#isNear ? "wake" : "finishUnseen" });
  }

  #finishIfStill(): void {
    if (this.#id !== undefined && this.#isStill && this.#status?.state === "growing") {
      renderHost.send(this.#id, { do: "finish" });
    }
  }

  #resized(signal: AbortSignal): void {
    this.#beginIfDue();
    this.#view.stretch();
    clearTimeout(this.#resizing);
    this.#resizing = setTimeout(() => {
      if (this.#id === undefined || signal.aborted) return;
      renderHost.send(this.#id, { do: "resize", size: this.#view.fit() });
    }, RESIZE_PAUSE_MS);
  }

  // ---- reports

  #hear(report: Report): void {
    if (report.is === "failed") this.#fail(new PageError(report.code, report.message), report.links);
    if (report.is === "shown") this.#show(report.reading, report);
  }

  #show(reading: Reading, status: Status): void {
    // A picture that has its names, perhaps, is not exchanged for a map without them.
    if (status.isUnnamed && !this.#isShown && this.#view.poster === "picture") return;
    const { state, phase, progress, summary } = status;
    const before = this.#status?.state;
    this.#status = status;
    this.#reading = reading;
    if (reading.links === this.#links) this.#advance(reading, status);
    this.#asked = undefined;
    if (reading.aspect !== this.#aspect) this.#shape(reading.aspect);
    if (this.#isWorthShowing(status)) this.#reveal(reading);
    this.#describe();
    if (state !== "finished") this.#emit("progress", { phase, progress, summary });
    else if (before !== "finished") {
      if (this.getAttribute("alt") !== "") this.#view.say(this.#strings.finished(this.#told(reading, status)));
      this.#emit("complete", { link: reading.link, summary });
    }
  }

  /** True if a picture is better than what is there: a river without animation only when finished, land only than nothing. */
  #isWorthShowing({ state, phase, progress }: Status): boolean {
    if (state === "settling") return phase === "finished";
    return progress > 0 || this.#isShown || !this.#view.poster;
  }

  #reveal({ link, notices }: Reading): void {
    this.#view.reveal();
    if (this.#isShown) return;
    this.#isShown = true;
    if (notices.length > 0) console.warn(`river-seed: ${notices.map(({ message }) => message).join("; ")}`);
    this.#emit("ready", { link, notices });
  }

  /** Handles a failure. `links` is the number of links that had been requested by then. */
  #fail(error: PageError, links = this.#links): void {
    // A map without names is still shown, though this failure may be reported before it.
    const isMap = error.code === "no-labels";
    if (!isMap && (!isRecoverable(error) || !this.#isShown)) {
      this.#hasFailed = true;
      this.#status = undefined;
      this.#close();
      this.#shape(this.#aspect);
      this.#view.note(this.#strings.failed);
    }
    // If an earlier link failed, the requested rivers are still to come.
    if (!isMap && (this.#hasFailed || links === this.#links)) {
      this.#present = "failed";
      this.#outcome.failed(error);
    }
    void this.#report(error);
  }

  /** Reports a failure: as an event, and on the console unless a listener prevents that. */
  async #report(error: PageError): Promise<void> {
    const { code, message } = error;
    // The advice is fetched when it is needed. If that fails too, the code has to suffice.
    const advice = await importPageBackend().then(
      ({ advice }) => advice(error).text,
      () => "",
    );
    if (this.#emit("error", { code, message, advice })) console.warn(`river-seed: ${code}: ${message}. ${advice}`);
  }

  // ---- texts and events

  /** Updates the picture's name and the button. */
  #describe(): void {
    const status = this.#status;
    const reading = this.#reading;
    if (!status || !reading) return;
    const name = this.getAttribute("aria-label") ?? this.getAttribute("alt");
    this.#view.name(name ?? this.#strings.alternative(this.#told(reading, status)));
    const isAsked = this.hasAttribute("controls");
    const isMoving = status.state === "growing" || status.state === "paused";
    this.#view.maker(this.#isShown ? makerOf(this, reading.link) : "", this.#strings.maker);
    const isThere = this.#isShown || status.state === "paused";
    const does = isThere && (isAsked || isMoving || !this.hasAttribute("still")) ? DOES[status.state] : undefined;
    const isQuiet = !isAsked && !isMoving;
    this.#view.button(does, does ? this.#strings[does] : "", { isQuiet, isDark: this.#isDark });
  }

  #told({ seed }: Reading, status: Status): Told {
    return { ...status, seed, count: countIn(this) };
  }

  #press(): void {
    const does = this.#status && DOES[this.#status.state];
    if (does === "replay") this.restart();
    else if (does) this[does]();
  }

  #emit<Type extends keyof RiverSeedEventMap>(type: Type, detail: RiverSeedEventMap[Type]["detail"]): boolean {
    return this.dispatchEvent(new CustomEvent(type, { detail, cancelable: type === "error" }));
  }
}

function refusal(why: string): DOMException {
  return new DOMException(`this river-seed ${why}`, "InvalidStateError");
}

reflect(RiverSeed.prototype);

export type * from "./events.ts";
export type { RiverSeedPhase } from "./state.ts";
export type { Strings } from "./strings.ts";

/** The events of every element, and those of this one. */
type Events = Omit<HTMLElementEventMap, keyof RiverSeedEventMap> & RiverSeedEventMap;

export interface RiverSeed extends Properties {
  addEventListener<Type extends keyof Events>(
    type: Type,
    listener: (this: RiverSeed, event: Events[Type]) => void,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  removeEventListener<Type extends keyof Events>(
    type: Type,
    listener: (this: RiverSeed, event: Events[Type]) => void,
    options?: boolean | EventListenerOptions,
  ): void;
  removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void;
}

declare global {
  interface HTMLElementTagNameMap {
    "river-seed": RiverSeed;
  }
}
