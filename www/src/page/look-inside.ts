/** Looking inside: what a finished map is made of, laid over it by a button or a key, with a sentence on what one sees. */

import { count } from "../browser/count.ts";
import { el, mapLayer, svg } from "../browser/dom.ts";
import type { Overlay, OverlayName } from "./protocol.ts";

export interface InsideElements {
  /** Lies where the map does. */
  mapPlace: HTMLElement;
  /** The picture's place. */
  frame: HTMLElement;
  /** The place of its buttons in the panel. */
  inside: HTMLElement;
}

export interface InsideEvents {
  /** What there is to be laid over the finished map; none while it is not finished. */
  overlay(name: OverlayName): Promise<Overlay | undefined>;
}

interface Look {
  name: OverlayName;
  key: string;
  label: string;
  /** What one sees, of rivers that grew by a method. */
  sentence(growth: string): string;
}

const LOOKS: readonly Look[] = [
  {
    name: "attractors",
    key: "A",
    label: "Attractors or parcels",
    sentence: (growth) =>
      growth === "drainage"
        ? "Each dot is a parcel: a piece of land that drains to one of those beside it."
        : "Each dot is an attractor: a point that drew the nearest river towards it.",
  },
  {
    name: "sources",
    key: "T",
    label: "Tips",
    sentence: () => "Each dot is a source: the tip of a stream, farthest from the sea.",
  },
  {
    name: "orders",
    key: "O",
    label: "Orders",
    sentence: () => "Streams by Strahler’s order: where two of the highest order meet, it rises by one.",
  },
  {
    name: "basins",
    key: "B",
    label: "Basins",
    sentence: () => "Each area is the land of one river that reaches the sea: all its water goes there.",
  },
  {
    name: "flow",
    key: "D",
    label: "Direction of flow",
    sentence: () => "Arrows point downstream, each where a stream ends in a greater one or in the sea.",
  },
  {
    name: "held",
    key: "F",
    label: "Frozen courses",
    sentence: () => "These stretches stay where they are while others meander.",
  },
];

export class LookInside {
  readonly #svg = mapLayer("inside");
  readonly #card = el("div", { class: "inside-card", hidden: true, role: "status" });
  readonly #buttons = new Map<OverlayName, HTMLButtonElement>();
  #growth = "";
  #isFinished = false;
  #look: Look | undefined;
  #asked = 0;

  constructor(
    elements: InsideElements,
    private readonly events: InsideEvents,
  ) {
    elements.mapPlace.prepend(this.#svg);
    elements.frame.after(this.#card);
    elements.inside.replaceChildren(this.#group());
    document.addEventListener("keydown", (event) => this.#onKey(event));
  }

  /** While a map grows nothing lies over it; what did comes back with its end. */
  follow(state: string, growth: string): void {
    const isFinished = state === "finished";
    this.#growth = growth;
    this.#isFinished = isFinished;
    const attractors = this.#buttons.get("attractors");
    // A Brownian tree has none.
    if (attractors) attractors.disabled = growth === "brownian";
    if (isFinished) void this.#lay();
    else this.#clear();
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
    if (event.defaultPrevented || event.altKey || event.ctrlKey || event.metaKey || event.shiftKey) return;
    if (event.target instanceof Element && event.target.closest("input, select, textarea, dialog, [role=menu]")) return;
    if (event.key === "Escape" && this.#look) this.#toggle(this.#look);
    const look = LOOKS.find(({ key }) => key === event.key.toUpperCase());
    if (!look || this.#buttons.get(look.name)?.disabled) return;
    event.preventDefault();
    this.#toggle(look);
  }

  #toggle(look: Look): void {
    this.#look = this.#look === look ? undefined : look;
    for (const [name, button] of this.#buttons) button.setAttribute("aria-pressed", String(name === this.#look?.name));
    void this.#lay();
  }

  async #lay(): Promise<void> {
    const look = this.#look;
    const asked = ++this.#asked;
    const isMeant = look !== undefined && this.#isFinished && !this.#buttons.get(look.name)?.disabled;
    const overlay = isMeant ? await this.events.overlay(look.name).catch(() => undefined) : undefined;
    if (asked !== this.#asked) return;
    if (!overlay || !look) {
      this.#clear();
      return;
    }
    this.#draw(look, overlay);
    this.#describe(look, overlay);
  }

  #clear(): void {
    this.#asked++;
    this.#svg.replaceChildren();
    this.#svg.setAttribute("hidden", "");
    this.#card.hidden = true;
  }

  #draw({ name }: Look, { size: [width, height], kinds }: Overlay): void {
    this.#svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.#svg.removeAttribute("hidden");
    this.#svg.dataset["look"] = name;
    const groups = kinds.map((paths, i) => {
      // Arrows belong to each stream; all else of a kind is one path, which is drawn much faster.
      const data = name === "flow" || name === "basins" ? paths : [paths.join("")];
      const lines = data.filter((d) => d !== "").map((d) => svg("path", { d }));
      return svg("g", { "data-kind": Math.min(i + 1, MOST_KINDS) }, ...lines);
    });
    this.#svg.replaceChildren(...(name === "flow" ? [arrow()] : []), ...groups);
  }

  #describe(look: Look, { kinds }: Overlay): void {
    const legend = look.name === "orders" ? [ordersLegend(kinds.map((streams) => streams.length))] : [];
    const isEmpty = kinds.every((paths) => paths.every((path) => path === ""));
    const sentence = isEmpty ? "There are none on this map." : look.sentence(this.#growth);
    this.#card.replaceChildren(el("p", { class: "inside-name" }, look.label), el("p", {}, sentence), ...legend);
    this.#card.hidden = false;
  }
}

/** Orders from here on have one colour. */
const MOST_KINDS = 6;

function ordersLegend(counts: readonly number[]): HTMLElement {
  const row = (many: number, i: number): HTMLElement => {
    const swatch = el("span", { class: "swatch", "data-kind": Math.min(i + 1, MOST_KINDS), "aria-hidden": "true" });
    return el("li", {}, swatch, `Order ${i + 1}: ${count(many)} ${many === 1 ? "stream" : "streams"}`);
  };
  return el("ul", {}, ...counts.map(row));
}

/** The head of an arrow, in units: so it grows with the map. */
function arrow(): SVGElement {
  const place = { viewBox: "0 0 10 10", refX: 9, refY: 5, orient: "auto" };
  const size = { markerUnits: "userSpaceOnUse", markerWidth: 15, markerHeight: 15 };
  return svg("marker", { id: "flow-arrow", ...place, ...size }, svg("path", { d: "M0 0L10 5L0 10L3 5z" }));
}
