/** Asks the renderer about the map on show. An answer about another map than the one that was shown last is none. */

import type { NameFacts } from "../../../engine/types.ts";
import type { Format, RasterOrder } from "../../../files/format-names.ts";
import type { Picture, Thumbnail } from "../../../player/thumbnails.ts";
import type {
  Making,
  Measured,
  Moment,
  NameablePlace,
  Nameables,
  Overlay,
  OverlayName,
  PointedRiver,
  RiverPlace,
} from "../../page-worker/protocol.ts";
import type { Line } from "./line.ts";

/** The links of the map that was asked for last, and of the one on show. */
interface Links {
  readonly wanted: string;
  readonly shown: string;
}

export class MapQuestions {
  constructor(
    private readonly line: Line,
    private readonly links: () => Links,
  ) {}

  /**
   * Makes thumbnails of the finished map on show in some styles; `size` is in device pixels. Returns none if another
   * map is shown before all are made.
   */
  async thumbnails(styles: readonly string[], size: { width: number; height: number }): Promise<readonly Thumbnail[]> {
    return (await this.line.ask({ about: "thumbnails", of: this.line.id, styles, size })) ?? [];
  }

  /**
   * Draws the finished map of another link, without letters; `size` is in device pixels. Returns nothing if another map
   * is shown before it is drawn.
   */
  picture(link: string, size: { width: number; height: number }): Promise<Picture | undefined> {
    return this.line.ask({ about: "picture", of: this.line.id, link, size });
  }

  /** Measures the finished map on show, and checks its promises. */
  measures(): Promise<Measured | undefined> {
    return this.line.ask({ about: "measures", of: this.line.id });
  }

  /** Makes a file of a link's finished rivers, starting from the river on show. */
  file(link: string, format: Format, rasters?: RasterOrder): Promise<Blob> {
    return this.line.ask({ about: "file", of: this.line.id, link, format, rasters });
  }

  /** Returns the greatest names on the finished map. */
  async names(count: number): Promise<readonly NameFacts[]> {
    return this.#ofLast(await this.line.ask({ about: "names", of: this.line.id, count }))?.names ?? [];
  }

  /** Returns the letters to carry along with a link of the finished map, which may leave out its style; none if it has none. */
  letters(link: string): Promise<string | undefined> {
    return this.line.ask({ about: "letters", of: this.line.id, link });
  }

  /** Returns the river at a place of the finished map, if there is one. */
  async river(place: RiverPlace): Promise<PointedRiver | undefined> {
    return this.#ofLast(await this.line.ask({ about: "river", of: this.line.id, place }));
  }

  /** Returns what has a name, or could have one, at a place of the finished map. */
  async nameables(place: NameablePlace): Promise<Nameables | undefined> {
    const found = this.#ofLast(await this.line.ask({ about: "nameables", of: this.line.id, place }));
    // A map that is not on show yet would take away what is opened over the last one.
    return found?.link === this.links().shown ? found : undefined;
  }

  /** Returns an overlay of the map, if there is one of this name. */
  async overlay(name: OverlayName): Promise<Overlay | undefined> {
    return this.#ofLast(await this.line.ask({ about: "overlay", of: this.line.id, name }));
  }

  /** Returns the progress of the map. If a moment is given, goes there first. */
  async making(to?: Moment): Promise<Making | undefined> {
    return this.#ofLast(await this.line.ask({ about: "making", of: this.line.id, to }));
  }

  /** Returns the parameter `names`, as `now` gives it, with another name for something, or with its usual one. */
  async renamed(now: () => string, mark: string, name: string | undefined): Promise<string> {
    const names = now();
    const renamed = await this.line.ask({ about: "renamed", names, mark, name });
    // Something else may have been renamed meanwhile.
    return names === now() ? renamed : this.renamed(now, mark, name);
  }

  #ofLast<Told extends { link: string }>(told: Told | undefined): Told | undefined {
    return told?.link === this.links().wanted ? told : undefined;
  }
}
