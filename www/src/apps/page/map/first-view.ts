/**
 * The first view of a wide map in a narrow window: of its land alone, since the sea around it would make a stamp of it.
 * Only for a link that may have been made for a wider window.
 */

import type { Line } from "./line.ts";
import type { PicturePlace } from "./picture-place.ts";

/** In windows narrower than this, in CSS pixels, a first view is of the land alone. */
const NARROW_PX = 620;

export class FirstView {
  /** True until the land was shown, or something else decided what is seen. */
  isToCome = false;

  constructor(
    private readonly frame: HTMLElement,
    private readonly line: Line,
    private readonly place: PicturePlace,
    /** Is told when the land begins to be awaited, and when no longer. */
    private readonly awaited: (isAwaited: boolean) => void,
  ) {}

  /** Shows the land of a finished map, if that is to be shown and is large there. `wanted` is the map asked for last. */
  async show(wanted: () => { link: string; aspect: number }): Promise<void> {
    if (!this.isToCome) return;
    this.isToCome = false;
    const { width, height } = this.frame.getBoundingClientRect();
    const { link, aspect } = wanted();
    const isUpright = height > width;
    if (width >= NARROW_PX || !isUpright || aspect < 1) return;
    const { moves } = this.place;
    this.awaited(true);
    // If it fails, the whole map stays.
    const land = await this.line.ask({ about: "land", of: this.line.id }).catch(() => undefined);
    // A hand may have moved the map meanwhile, or another one may be on its way.
    if (land && moves === this.place.moves && link === wanted().link) await this.place.show(land);
    this.awaited(false);
  }
}
