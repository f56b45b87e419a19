/**
 * Naming things where they lie: a click on the map, or Enter on a river that keys have reached, pins the card of what is
 * there and asks for its name. A tap pins the card, and its button asks. The names in the panel show on the map what
 * they name.
 */

import { named } from "../../../engine/errors.ts";
import type { Nameable, NameablePlace, Nameables } from "../../page-worker/protocol.ts";
import { placeOn, REACH_PX, type RiverPointer } from "../look-inside/river-pointer.ts";
import { type Click, Clicks } from "./clicks.ts";
import { NameForm } from "./name-form.ts";

export interface NamingElements {
  stage: HTMLElement;
  /** The picture's place. */
  frame: HTMLElement;
  /** The element in the map's place. */
  mapPlace: HTMLElement;
}

export interface NamingEvents {
  /** Returns what has a name, or could have one, at a place of the finished map. */
  nameables(place: NameablePlace): Promise<Nameables | undefined>;
  /** Returns whether names are shown on the map. */
  hasLabels(): boolean;
  isOwn(mark: string): boolean;
  /** Gives something another name, or its made-up one. Rejects with the reason if that is not possible. */
  rename(mark: string, name: string | undefined): Promise<void>;
}

/** The most other things at the same place that are offered. */
const MOST_BESIDES = 3;
/** The kinds that are hit wherever no other thing is. */
const AREAS: readonly string[] = ["sea", "lake", "land", "island"];

export class Naming {
  readonly #form: NameForm;
  #open: { thing: Nameable; found: Nameables } | undefined;
  /** A click that waits for the map to be finished. */
  #waiting: Click | undefined;
  #asked = 0;
  /** The mark of the name in the panel that is shown on the map. */
  #listed: string | undefined;

  constructor(
    private readonly elements: NamingElements,
    private readonly pointer: RiverPointer,
    private readonly events: NamingEvents,
  ) {
    this.#form = new NameForm({
      save: (name) => void this.#save(name),
      cancel: () => this.#close(),
      begun: () => pointer.refit(),
      choose: (thing) => void this.#choose(thing),
    });
    const { frame } = elements;
    new Clicks(frame, { click: (click) => void this.#onClick(click), double: () => this.#close() });
    frame.addEventListener("keydown", (event) => this.#onFrameKey(event));
    this.#listenToNames();
    window.visualViewport?.addEventListener("resize", () => pointer.refit());
  }

  /** Follows the map's state, after the pointer. */
  follow(): void {
    if (this.#open && !this.pointer.isPinned) this.#forget();
    const waiting = this.#waiting;
    if (waiting && this.pointer.isFinished) void this.#answer(waiting);
  }

  /** Closes the card. */
  escape(): boolean {
    const wasOpen = this.#open !== undefined;
    this.#close();
    return wasOpen;
  }

  // ---- what is meant

  async #onClick(click: Click): Promise<void> {
    if (this.elements.stage.hasAttribute("data-drawing")) return;
    // A name that was typed is kept when somebody goes on to the next thing, as in the list.
    if (this.#form.changed !== undefined && this.#open && !(await this.#save(this.#form.changed))) return;
    await this.#answer(click);
  }

  async #answer(click: Click): Promise<void> {
    this.#waiting = undefined;
    if (!this.pointer.isFinished) return;
    const reachPx = click.isTouch ? REACH_PX.touch : REACH_PX.mouse;
    const at = placeOn(this.elements.mapPlace, click.x, click.y, reachPx);
    const asked = ++this.#asked;
    const found = await this.#find({ ...at, hasLabels: this.events.hasLabels() });
    if (asked !== this.#asked) return;
    const [first] = found?.things ?? [];
    const isBesideAll = first !== undefined && AREAS.includes(first.kind) && found?.things.length === 1;
    // A click beside everything closes what is open; where nothing is, it means the land or the sea itself.
    if (!found || !first || (isBesideAll && this.#open)) this.#close();
    else await this.#show(first, found, !click.isTouch);
    // The map is about to change: it is asked again when it has.
    if (!found) this.#waiting = click;
  }

  /** Names the river that was reached with keys. */
  #onFrameKey(event: KeyboardEvent): void {
    const mark = this.pointer.walkedTo;
    if (event.key !== "Enter" || event.target !== this.elements.frame || event.repeat || mark === undefined) return;
    event.preventDefault();
    void this.#showMark(mark, true);
  }

  async #showMark(mark: string, isTyped: boolean): Promise<void> {
    const asked = ++this.#asked;
    const found = await this.#find({ mark });
    const [thing] = found?.things ?? [];
    if (asked === this.#asked && found && thing) await this.#show(thing, found, isTyped);
  }

  #find(place: NameablePlace): Promise<Nameables | undefined> {
    // The viewport tells of a renderer that fails.
    return this.events.nameables(place).catch(() => undefined);
  }

  // ---- the card

  /** Pins the card of a thing. `isTyped` opens its field, too. */
  async #show(thing: Nameable, found: Nameables, isTyped: boolean): Promise<void> {
    const others = found.things.filter(({ mark }) => mark !== thing.mark).slice(0, MOST_BESIDES);
    const isOwn = this.events.isOwn(thing.mark);
    const isShown = thing.kind !== "river" || thing.name === "" || found.labelled.includes(thing.mark);
    this.#form.show(thing, isOwn, !isOwn || isShown || !this.events.hasLabels(), others);
    this.#open = { thing, found };
    if (!(await this.pointer.pin(thing, found, this.#form.elements))) return;
    if (isTyped) this.#form.begin();
    else this.#form.focusRename();
  }

  async #choose(thing: Nameable): Promise<void> {
    if (this.#open) await this.#show(thing, this.#open.found, true);
  }

  /** Saves a name. Returns whether it can be one; if not, the card says why. */
  async #save(name: string | undefined): Promise<boolean> {
    const open = this.#open;
    if (!open) return false;
    try {
      await this.events.rename(open.thing.mark, name);
    } catch (thrown) {
      this.#form.refuse(named(thrown).message);
      this.pointer.refit();
      return false;
    }
    if (this.#open === open) this.#close();
    this.pointer.say(name === undefined ? "It has its made-up name again." : `Named: ${name}.`);
    return true;
  }

  /** Closes the card, and gives the focus back to the map. */
  #close(): void {
    this.#asked++;
    this.#waiting = undefined;
    if (!this.#open) return;
    this.pointer.hide();
    this.#forget();
  }

  #forget(): void {
    this.#open = undefined;
    // The element that had the focus is gone.
    if (document.activeElement === document.body || !document.activeElement)
      this.elements.frame.focus({ preventScroll: true });
  }

  // ---- the names in the panel

  /** Shows on the map what a name in the panel names, while the pointer or the focus is on it. */
  #listenToNames(): void {
    const markOf = (target: EventTarget | null): string | undefined =>
      target instanceof Element ? target.closest<HTMLElement>(".names [data-mark]")?.dataset["mark"] : undefined;
    document.addEventListener("focusin", ({ target }) => void this.#list(markOf(target)));
    document.addEventListener("focusout", ({ target, relatedTarget }) => {
      if (markOf(target) !== undefined && markOf(relatedTarget) === undefined) void this.#list(undefined);
    });
    document.addEventListener("pointerover", ({ target, pointerType }) => {
      if (pointerType === "touch") return;
      const mark = markOf(target) ?? markOf(document.activeElement);
      if (mark !== undefined || this.#listed !== undefined) void this.#list(mark);
    });
  }

  async #list(mark: string | undefined): Promise<void> {
    if (mark === this.#listed) return;
    const wasListed = this.#listed !== undefined;
    this.#listed = mark;
    if (mark === undefined) {
      if (wasListed && !this.#open) this.pointer.hide();
      return;
    }
    if (!this.pointer.isFinished) return;
    if (this.#open) this.#close();
    const found = await this.#find({ mark });
    if (mark !== this.#listed || this.#open) return;
    const [thing] = found?.things ?? [];
    if (found && thing && thing.kind !== "map") await this.pointer.pin(thing, found);
    else this.pointer.hide();
  }
}
