/**
 * Looking inside: overlays that show how a map is made, each with a button, a key and a sentence that explains it. Some
 * are available while the map grows, and at any moment of its making.
 */

import { el, mapLayer, setText, svg } from "../../../browser/dom.ts";
import { isCombined, isTaken } from "../../../browser/keys.ts";
import type { Overlay, OverlayName } from "../../page-worker/protocol.ts";
import type { Point } from "../map/camera.ts";
import { LOOKS, type Look, MOST_KINDS } from "./looks.ts";
import { ReachCircles } from "./reach-circles.ts";

export interface InsideElements {
  /** The element in the map's place. */
  mapPlace: HTMLElement;
  /** The picture's place. */
  frame: HTMLElement;
  /** The place of the buttons in the panel. */
  inside: HTMLElement;
}

export interface InsideEvents {
  /** Returns an overlay of the map, if there is one of this name. */
  overlay(name: OverlayName): Promise<Overlay | undefined>;
  /** Returns the middle of the visible part of the map, on the page. */
  middle(): Point;
}

const UNFINISHED = "This is known once the map is finished: press Play, or go to the end of the line of time.";

export class LookInside {
  readonly #svg = mapLayer("inside");
  readonly #name = el("p", { class: "inside-name" });
  readonly #sentence = el("p");
  readonly #legend = el("div");
  /** The card. Its legend is outside of the status, since numbers that change all the time are not to be read aloud. */
  readonly #card = el(
    "div",
    { class: "inside-card", hidden: true },
    el("div", { role: "status" }, this.#name, this.#sentence),
    this.#legend,
  );
  readonly #buttons = new Map<OverlayName, HTMLButtonElement>();
  readonly #circles: ReachCircles;
  #growth = "";
  #isFinished = false;
  #look: Look | undefined;
  #shown: Look | undefined;
  /** True while an answer is due; below, true if to ask again after it. */
  #isAsking = false;
  #isStale = false;

  constructor(
    elements: InsideElements,
    private readonly events: InsideEvents,
  ) {
    this.#circles = new ReachCircles(elements, () => events.middle());
    elements.mapPlace.prepend(this.#svg);
    elements.frame.after(this.#card);
    elements.inside.replaceChildren(this.#group());
    document.addEventListener("keydown", (event) => this.#onKey(event));
  }

  /**
   * Follows a change of the map's state. Overlays of finished maps are hidden while it grows, and come back at its end.
   */
  follow(state: string, growth: string): void {
    this.#isFinished = state === "finished";
    this.#growth = growth;
    for (const { name, of } of LOOKS) {
      const button = this.#buttons.get(name);
      if (!button) continue;
      button.disabled = of?.includes(growth) === false;
      button.title = button.disabled ? "This way of growing has none." : "";
    }
    this.refresh();
  }

  /** Updates the overlay, since the map may be at another moment. */
  refresh(): void {
    void this.#lay();
  }

  #group(): HTMLElement {
    const buttons = LOOKS.map((look) => {
      const button = el(
        "button",
        { type: "button", "aria-pressed": "false", "aria-keyshortcuts": look.key },
        look.label,
        " ",
        el("kbd", { "aria-hidden": "true" }, look.key),
      );
      button.addEventListener("click", () => this.#toggle(look));
      this.#buttons.set(look.name, button);
      return button;
    });
    const list = el("div", { class: "inside-buttons" }, ...buttons);
    return el("section", { class: "inside-group", "aria-label": "Look inside" }, el("h3", {}, "Look inside"), list);
  }

  #onKey(event: KeyboardEvent): void {
    if (isTaken(event) || isCombined(event) || event.shiftKey || event.repeat) return;
    const look = LOOKS.find(({ key }) => key === event.key.toUpperCase());
    if (!look || this.#buttons.get(look.name)?.disabled) return;
    event.preventDefault();
    this.#toggle(look);
  }

  /** Removes the overlay. */
  escape(): boolean {
    if (!this.#look) return false;
    this.#toggle(this.#look);
    return true;
  }

  #toggle(look: Look): void {
    this.#look = this.#look === look ? undefined : look;
    for (const [name, button] of this.#buttons) button.setAttribute("aria-pressed", String(name === this.#look?.name));
    void this.#lay();
  }

  /** The look that should be shown on the map in its present state, if any. */
  get #meant(): Look | undefined {
    const look = this.#look;
    return look && (look.isLive || this.#isFinished) && !this.#buttons.get(look.name)?.disabled ? look : undefined;
  }

  /**
   * Asks for the overlay and shows it. It asks one question at a time, so that answers keep coming while a map grows.
   */
  async #lay(): Promise<void> {
    this.#isStale = this.#isAsking;
    if (this.#isAsking) return;
    const look = this.#meant;
    if (look !== this.#shown) this.#clear();
    if (!look) {
      this.#excuse();
      return;
    }
    this.#isAsking = true;
    // The viewport tells of a renderer that fails.
    const overlay = await this.events.overlay(look.name).catch(() => undefined);
    this.#isAsking = false;
    const isMeant = look === this.#meant;
    if (overlay && isMeant) this.#show(look, overlay);
    else this.#clear();
    if (this.#isStale || !isMeant) await this.#lay();
  }

  #show(look: Look, overlay: Overlay): void {
    this.#shown = look;
    this.#draw(look, overlay);
    this.#describe(look, overlay);
  }

  /** Says why an overlay that was asked for is not there yet. */
  #excuse(): void {
    if (!this.#look || this.#isFinished) return;
    setText(this.#name, this.#look.label);
    setText(this.#sentence, UNFINISHED);
    this.#legend.replaceChildren();
    this.#card.hidden = false;
  }

  #clear(): void {
    this.#shown = undefined;
    this.#circles.hide();
    this.#svg.replaceChildren();
    this.#svg.setAttribute("hidden", "");
    this.#card.hidden = true;
  }

  #draw({ name }: Look, overlay: Overlay): void {
    const { size, kinds } = overlay;
    const [width, height] = size;
    this.#svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.#svg.removeAttribute("hidden");
    this.#svg.dataset["look"] = name;
    const groups = kinds.map((paths, i) => {
      // Every stream has an arrow. Otherwise a kind is one path, which is drawn much faster.
      const data = name === "flow" || name === "basins" ? paths : [paths.join("")];
      const lines = data.filter((d) => d !== "").map((d) => svg("path", { d: withFrame(name, i, d, size) }));
      return svg("g", { "data-kind": Math.min(i + 1, MOST_KINDS) }, ...lines);
    });
    const besides = name === "flow" ? [arrow()] : name === "reach" ? [this.#circles.element] : [];
    this.#svg.replaceChildren(...besides, ...groups);
    if (name === "reach") this.#circles.show(overlay);
  }

  #describe(look: Look, overlay: Overlay): void {
    const isEmpty = overlay.kinds.every((paths) => paths.every((path) => path === ""));
    setText(this.#name, look.label);
    setText(this.#sentence, isEmpty ? "There are none on this map." : look.sentence(this.#growth));
    this.#legend.replaceChildren(...(look.legend?.(overlay, this.#growth) ?? []));
    this.#card.hidden = false;
  }
}

/** Adds a frame far around the map to the mask of water, which covers everything but land. */
function withFrame(name: OverlayName, kind: number, path: string, [width, height]: Overlay["size"]): string {
  return name === "masks" && kind === 0
    ? `M${-9 * width} ${-9 * height}H${10 * width}V${10 * height}H${-9 * width}z${path}`
    : path;
}

/** Makes the head of an arrow. Its size is in units, so that it grows with the map. */
function arrow(): SVGElement {
  const place = { viewBox: "0 0 10 10", refX: 9, refY: 5, orient: "auto" };
  const size = { markerUnits: "userSpaceOnUse", markerWidth: 15, markerHeight: 15 };
  return svg("marker", { id: "flow-arrow", ...place, ...size }, svg("path", { d: "M0 0L10 5L0 10L3 5z" }));
}
