/** The drawing of what is pointed at: of a river its way to the sea and its basin, of a place its line or its point. */

import { mapLayer, svg } from "../../../browser/dom.ts";
import type { Nameable, PointedRiver } from "../../page-worker/protocol.ts";

/** The edges of a part of the page, in CSS pixels. */
export interface Edges {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/** Paths, each for what it shows. */
type Drawn = Partial<Record<"basin" | "letters" | "way" | "spot", string>>;

export class Lines {
  readonly element = mapLayer("river-pointer");
  readonly #paths = ["basin", "letters", "way-halo", "way", "spot-halo", "spot"].map((name) =>
    svg("path", { class: name }),
  );

  constructor() {
    this.element.append(...this.#paths);
  }

  show({ basin, way, x, y, size }: PointedRiver): void {
    this.#draw({ basin, way, spot: pathOf([x, y], size) }, size);
  }

  /** Marks a thing by its name, as with a marker pen, by its line, or by its only point. */
  mark({ line, em }: Pick<Nameable, "line" | "em">, size: PointedRiver["size"]): void {
    const path = pathOf(line, size);
    this.element.style.setProperty("--em", String((em ?? 0) * size[0]));
    this.#draw(em ? { letters: path } : line.length > 2 ? { way: path } : { spot: path }, size);
  }

  #draw({ basin = "", letters = "", way = "", spot = "" }: Drawn, [width, height]: PointedRiver["size"]): void {
    this.element.removeAttribute("hidden");
    this.element.setAttribute("viewBox", `0 0 ${width} ${height}`);
    for (const [i, data] of [basin, letters, way, way, spot, spot].entries()) {
      if (this.#paths[i]?.getAttribute("d") !== data) this.#paths[i]?.setAttribute("d", data);
    }
  }

  hide(): void {
    this.element.setAttribute("hidden", "");
  }

  /** Returns its edges on the page, with the basin or without. */
  extent(hasBasin: boolean): Edges | undefined {
    const boxes = this.#paths
      .slice(hasBasin ? 0 : 1)
      .filter((path) => path.getAttribute("d"))
      .map((path) => path.getBoundingClientRect())
      .filter(({ width, height }) => width > 0 || height > 0);
    if (boxes.length === 0) return undefined;
    return {
      left: Math.min(...boxes.map(({ left }) => left)),
      top: Math.min(...boxes.map(({ top }) => top)),
      right: Math.max(...boxes.map(({ right }) => right)),
      bottom: Math.max(...boxes.map(({ bottom }) => bottom)),
    };
  }
}

/** Returns points in shares of the map's sides as a path in units. */
function pathOf(line: ArrayLike<number>, [width, height]: PointedRiver["size"]): string {
  const points = Array.from(line, (share, i) => Math.round(share * (i % 2 === 0 ? width : height) * 10) / 10);
  const path = points.map((at, i) => (i % 2 === 0 ? `${i === 0 ? "M" : "L"}${at}` : ` ${at}`)).join("");
  // A single point is seen by its round ends.
  return points.length === 2 ? `${path}h0` : path;
}
