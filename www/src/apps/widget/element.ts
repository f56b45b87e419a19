/**
 * The class of `<river-seed>`, a river in a page about something else; `define.ts` registers it. Importing it has no
 * effect, even on a server.
 */

import { RESIZE_PAUSE_MS } from "../../browser/canvas.ts";
import { DARK_PAGES } from "../../browser/dark-pages.ts";
import { isRecoverable, PageError } from "../../engine/page-error.ts";
import type { Summary } from "../../engine/types.ts";
import type { Client } from "../../host/render-host.ts";
import type { ShowMode } from "../../player/river-player.ts";
import {
  ASPECT,
  aspectOf,
  initOf,
  linkOf,
  linkToReadOf,
  OBSERVED,
  type Properties,
  reflect,
  speedOf,
  upgrade,
} from "./attributes.ts";
import { announceEnd, DOES, describeRiver } from "./description.ts";
import type { Audible, CompleteDetail, RiverSeedEventMap } from "./events.ts";
import { reportFailure } from "./failure.ts";
import { askForPng, askForSvg, type BlobOptions } from "./files.ts";
import { HostedRiver, type Opening, type Order, type Request } from "./hosted-river.ts";
import { isStill, reducedMotion } from "./motion.ts";
import type { Report, Seen } from "./protocol.ts";
import { Requested, type RiverSeedPhase } from "./state.ts";
import { ENGLISH, type Strings } from "./strings.ts";
import { View } from "./view.ts";
import { watch } from "./visibility.ts";

/** The browser's class, or a stand-in where there is none; with the properties that `reflect` adds. */
const Base = (globalThis.HTMLElement ?? class {}) as unknown as new () => Audible & Properties & HTMLElement;

/** The time after which an element without a width says so: style sheets have come by then. */
const SQUEEZED_MS = 2000;

export class RiverSeed extends Base {
  static readonly observedAttributes: readonly string[] = OBSERVED;

  #strings: Strings = ENGLISH;
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
  #resizing: ReturnType<typeof setTimeout> | undefined;
  #aspect = ASPECT.default;
  #link: ReturnType<typeof linkToReadOf> | undefined;
  /** What has been told of corrections. */
  #corrections = "";
  /** The river on the canvas. */
  #seen: Seen | undefined;
  readonly #river = new HostedRiver();
  readonly #requested = new Requested();
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
    this.#catchUp();
    return this.#requested.phase ?? (this.#hasBegun ? "loading" : "idle");
  }

  /** The share of the way to the finished rivers, from 0 to 1. */
  get progress(): number {
    return this.#now?.progress ?? 0;
  }

  /** True while their growth is paused: by a script, by the reader, or at a share that was sought. */
  get paused(): boolean {
    return this.#now?.state === "paused";
  }

  /**
   * A promise that resolves when the requested rivers are finished, and rejects with the error if they fail. There is a
   * new promise when the attributes ask for other rivers, the element leaves the document, or finished rivers grow
   * again; a pending one rejects with an `AbortError`.
   */
  get finished(): Promise<CompleteDetail> {
    this.#catchUp();
    return this.#requested.finished;
  }

  /** Continues growing. A finished river grows again, and one that waits until it is seen begins. */
  play(): void {
    this.#ask({ do: "play" });
  }

  pause(): void {
    this.#ask({ do: "pause" });
  }

  /** Goes to a share of the progress, from 0 to 1, and pauses there. To go back, the rivers grow again. */
  seek(share: number): void {
    this.#ask({ do: "seek", share: Number(share) });
  }

  /** Grows the river again from the mouths. After a failure it tries again. */
  restart(): void {
    if (this.#hasFailed) {
      this.#hasBegun = this.#hasFailed = false;
      this.#requested.renew();
      this.#shape(this.#aspect);
    }
    this.#ask({ do: "play" }, { do: "replay" });
  }

  /** Makes a PNG of the finished river. */
  async toBlob(options: BlobOptions = {}): Promise<Blob> {
    return askForPng(this, this.#view.size, options);
  }

  /** Returns the finished rivers as the text of an SVG. */
  async toSVG(): Promise<string> {
    return askForSvg(this);
  }

  #ask(request: Request, order: Order = request): void {
    this.#catchUp();
    this.#river.ask(request, order);
    if (request.do !== "pause") this.#requested.growAgain();
    this.#beginIfDue();
  }

  /**
   * The way to show a river. One whose growth has been seen to the end is not animated again, and a picture in its
   * place gives way to the finished river alone.
   */
  get #how(): ShowMode {
    const isNews = this.#isShown || (this.#seen?.state !== "finished" && this.#view.poster !== "picture");
    return isNews && !isStill(this) ? "watch" : "still";
  }

  /** The status of the requested rivers, if they have begun and not failed. */
  get #now() {
    this.#catchUp();
    return this.#requested.now;
  }

  /** Follows changed attributes now, so that a script that has just changed them reads the new state. */
  #catchUp(): void {
    if (this.#isChanging && this.#life) this.#follow();
  }

  // ---- lifecycle

  #listen(signal: AbortSignal): void {
    const on = (target: EventTarget, type: string, listener: () => void): void =>
      target.addEventListener(type, listener, { signal });
    on(document, "visibilitychange", () => this.#rest());
    on(matchMedia(DARK_PAGES), "change", () => this.#followSoon());
    on(reducedMotion(), "change", () => this.#finishIfStill());
    const near = (isNear: boolean): void => {
      this.#isNear = isNear;
      this.#wasNear ||= isNear;
      this.#rest();
      this.#beginIfDue();
    };
    watch(this, { near, resized: () => this.#resized() }, signal);
    const squeezing = setTimeout(() => this.#warnIfSqueezed(), SQUEEZED_MS);
    signal.addEventListener("abort", () => clearTimeout(squeezing));
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
    const link = linkToReadOf(this);
    const isNew =
      link.text !== before?.text ||
      link.options.values !== before.options.values ||
      link.options.dark !== before.options.dark;
    this.#link = link;
    if (isNew && !isArriving) this.#requested.renew("the attributes ask for other rivers");
    // Another recipe may succeed after a failure.
    if (isNew && this.#hasFailed) this.#hasBegun = this.#hasFailed = false;
    if (isNew) this.#shape(aspectOf(linkOf(this)));
    this.#describe();
    if (isNew && this.#river.isThere) this.#river.show({ link, how: this.#how, size: this.#view.fit() });
    // The old status belongs to another river.
    else if (isNew) this.#seen = undefined;
    this.#pace();
    this.#finishIfStill();
    this.#beginIfDue();
  }

  #pace(): void {
    this.#river.send({ do: "speed", speed: speedOf(this) });
  }

  #shape(aspect: number): void {
    this.#aspect = aspect;
    this.#view.shape(aspect, this.#hasFailed);
  }

  #beginIfDue(): void {
    const isDue = this.#isNear || this.#river.isAskedToPlay || this.getAttribute("loading") === "eager";
    if (!isDue || this.#hasBegun || !this.#life || this.#view.size.width === 0) return;
    this.#hasBegun = true;
    void this.#enter(this.#life.signal);
  }

  async #enter(signal: AbortSignal): Promise<void> {
    try {
      await this.#river.enter(this.#client, initOf(this), signal, () => this.#opening);
      this.#pace();
      this.#rest();
    } catch (thrown) {
      if (!signal.aborted) this.#fail(thrown instanceof PageError ? thrown : new PageError("unknown", String(thrown)));
    }
  }

  get #opening(): Opening {
    const canvas = this.#view.prepare();
    return { canvas, link: linkToReadOf(this), how: this.#how, size: this.#view.fit() };
  }

  /**
   * Moves to a new engine, since the old one stopped in another river or no longer answers. The same river goes on
   * there. The old canvas is shown until the new one has a picture.
   */
  #move(): void {
    this.#river.move(this.#seen?.state);
    if (this.#life) void this.#enter(this.#life.signal);
  }

  #leave(): void {
    this.#life?.abort();
    this.#life = undefined;
    this.#isNear = this.#wasNear = this.#hasFailed = false;
    this.#close();
    this.#requested.renew("the river-seed was removed");
  }

  /** Closes the river and removes its canvas. */
  #close(): void {
    this.#river.leave();
    this.#hasBegun = this.#hasFailed;
    this.#isShown = false;
    this.#view.clear();
  }

  /** Rests while the tab is hidden, and until the element is seen. Once the reader is past it, it finishes unseen. */
  #rest(): void {
    const isAway = document.hidden || !this.#wasNear;
    this.#river.send({ do: isAway ? "rest" : this.#isNear ? "wake" : "finishUnseen" });
  }

  #finishIfStill(): void {
    if (isStill(this) && this.#seen?.state === "growing") this.#river.send({ do: "finish" });
  }

  #resized(): void {
    this.#beginIfDue();
    this.#view.stretch();
    clearTimeout(this.#resizing);
    this.#resizing = setTimeout(() => {
      if (this.#river.isThere) this.#river.send({ do: "resize", size: this.#view.fit() });
    }, RESIZE_PAUSE_MS);
  }

  #warnIfSqueezed(): void {
    if (this.#view.isSqueezed) console.warn("river-seed: its box leaves it no width, so there is no map", this);
  }

  // ---- reports

  #hear(report: Report): void {
    if (report.is === "failed") this.#fail(new PageError(report.code, report.message), report.links);
    if (report.is === "shown") this.#show(report);
  }

  #show(seen: Seen): void {
    const { state, phase, progress, summary, reading } = seen;
    const before = this.#seen?.state;
    this.#seen = seen;
    if (reading.links === this.#river.links) this.#requested.advance(seen);
    this.#river.answered();
    if (reading.aspect !== this.#aspect) this.#shape(reading.aspect);
    this.#tellCorrections(reading);
    if (this.#isWorthShowing(seen)) this.#reveal(seen);
    this.#describe();
    if (state !== "finished") this.#emit("progress", { phase, progress, summary });
    else if (before !== "finished") {
      announceEnd(this, this.#view, this.#strings, seen);
      this.#emit("complete", { link: reading.link, summary });
    }
  }

  /** True if a picture is better than what is there: a river without animation only when finished, land only than nothing. */
  #isWorthShowing({ state, phase, progress }: Seen): boolean {
    if (state === "settling") return phase === "finished";
    return progress > 0 || this.#isShown || !this.#view.poster;
  }

  #reveal({ reading: { link, notices } }: Seen): void {
    this.#view.reveal();
    if (this.#isShown) return;
    this.#isShown = true;
    this.#emit("ready", { link, notices });
  }

  /** Tells what was corrected in attributes and recipe, once for all pictures of it. */
  #tellCorrections({ link, notices }: Seen["reading"]): void {
    const corrections = notices.map(({ message }) => message).join("; ");
    if (corrections === this.#corrections) return;
    this.#corrections = corrections;
    if (!corrections) return;
    console.warn(`river-seed: ${corrections}`);
    this.#emit("corrected", { link, notices });
  }

  /** Handles a failure. `links` is the number of links that had been requested by then. */
  #fail(error: PageError, links = this.#river.links): void {
    if (!isRecoverable(error) || !this.#isShown) {
      this.#hasFailed = true;
      this.#seen = undefined;
      this.#close();
      this.#shape(this.#aspect);
      this.#view.note(this.#strings.failed);
    }
    // If an earlier link failed, the requested rivers are still to come.
    if (this.#hasFailed || links === this.#river.links) this.#requested.fail(error);
    void reportFailure(error, (detail) => this.#emit("error", detail));
  }

  #describe(): void {
    if (this.#seen) describeRiver(this, this.#view, this.#strings, this.#seen, this.#isShown);
  }

  #press(): void {
    const does = this.#seen && DOES[this.#seen.state];
    if (does === "replay") this.restart();
    else if (does) this[does]();
  }

  #emit<Type extends keyof RiverSeedEventMap>(type: Type, detail: RiverSeedEventMap[Type]["detail"]): boolean {
    return this.dispatchEvent(new CustomEvent(type, { detail, cancelable: type === "error" }));
  }
}

reflect(RiverSeed.prototype);

export type * from "./events.ts";
export type { BlobOptions } from "./files.ts";
export type { RiverSeedPhase } from "./state.ts";
export type { Strings } from "./strings.ts";

declare global {
  interface HTMLElementTagNameMap {
    "river-seed": RiverSeed;
  }
}
