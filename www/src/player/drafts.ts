/**
 * Drafts: previews of a dragged slider's link, painted over the current river until the hand rests and the river
 * changes to that link.
 */

import type { ReadOptions, River, Stage } from "../engine/types.ts";
import type { Drafted } from "../engine/whole.ts";
import type { Wanted } from "./showing.ts";

/** The time for painting a draft in one go. The hand sees it sooner than if each part had to wait for a frame. */
const AT_ONCE_MS = 46;

/** The methods of the whole engine's rivers that drafts need. */
export interface Drafting {
  draft(text: string, options?: ReadOptions): void;
  paintDraft(): Drafted;
  paintUnfinished(): Drafted;
  adoptDraft(): Stage | "none";
}

/**
 * The draft of a link that the core has read: `begun`, `impossible`, or `seen` on the canvas since a time.
 * `isOverOther` is true if the canvas still shows an earlier draft.
 */
type Draft = { is: "begun" | "impossible"; of: Wanted; isOverOther: boolean } | { is: "seen"; of: Wanted; at: number };

export class Drafts {
  #draft: Draft | undefined;

  constructor(
    private readonly river: Pick<River, "change"> & Partial<Drafting>,
    private readonly now: () => number,
  ) {}

  /** True while the canvas shows a draft. */
  get isOnCanvas(): boolean {
    return this.#draft !== undefined && (this.#draft.is === "seen" || this.#draft.isOverOther);
  }

  /** True while the canvas shows a draft, or one has been begun. */
  get areShown(): boolean {
    return this.#draft?.is === "begun" || this.isOnCanvas;
  }

  /** Returns the time at which a draft of this link came on the canvas, if it is there. */
  seenSince(wanted: Wanted): number | undefined {
    return this.#draft?.is === "seen" && this.#draft.of === wanted ? this.#draft.at : undefined;
  }

  /**
   * Paints a draft of a link, or as much of it as the time since the frame began allows. A draft that was begun is
   * finished first, since a fast hand would starve it.
   */
  paint(wanted: Wanted, began: number): Drafted {
    const isOverOther = this.isOnCanvas;
    const of = this.#draft?.is === "begun" ? this.#draft.of : wanted;
    if (this.#draft?.is !== "begun") this.river.draft?.(of.link.text, of.link.options);
    let drafted: Drafted;
    do drafted = this.river.paintDraft?.() ?? "impossible";
    while (drafted === "part" && this.now() - began < AT_ONCE_MS);
    if (drafted === "whole") this.#draft = { is: "seen", of, at: began };
    else this.#draft = { is: drafted === "part" ? "begun" : "impossible", of, isOverOther };
    return drafted;
  }

  /**
   * Changes the river to a link, which the core has read already if the draft is of it. There is no draft afterwards.
   */
  leaveFor(wanted: Wanted): Stage | "none" {
    const { river } = this;
    const isRead = this.#draft?.of === wanted;
    this.forget();
    if (isRead && river.adoptDraft) return river.adoptDraft();
    return river.change(wanted.link.text, wanted.link.options);
  }

  /** Forgets the draft: something else was painted over it. */
  forget(): void {
    this.#draft = undefined;
  }
}
