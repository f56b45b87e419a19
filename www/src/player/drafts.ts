/** Drafts: a dragged slider's link, painted over the river that is there, until the hand rests and the river goes over to it. */

import type { Drafted } from "../engine/full.ts";
import type { ReadOptions, River, Stage } from "../engine/types.ts";
import type { Wanted } from "./showing.ts";

/** A draft over the rivers that are there may take this long at once: a hand sees it sooner than in parts, a frame each. */
const AT_ONCE_MS = 46;

/** The methods of the full engine's rivers that drafts need. */
export interface Drafting {
  draft(text: string, options?: ReadOptions): void;
  paintDraft(): Drafted;
  paintUnfinished(): Drafted;
  adoptDraft(): Stage | "none";
}

/**
 * The draft of a link that the core has read: painted in part; on the canvas since a time; or impossible. `isOverOther`: until it is seen,
 * the canvas shows an earlier one.
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

  /** True while the canvas shows a draft, or one is begun. */
  get areShown(): boolean {
    return this.#draft?.is === "begun" || this.isOnCanvas;
  }

  /** Since when a draft of this link is on the canvas. */
  seenSince(wanted: Wanted): number | undefined {
    return this.#draft?.is === "seen" && this.#draft.of === wanted ? this.#draft.at : undefined;
  }

  /**
   * Paints a draft of a link, or as much of it as there is time for since the frame began. One that is begun is finished first: a fast hand
   * would starve it.
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

  /** Goes over to a link, which the core has read already if the draft is of it. There is no draft afterwards. */
  leaveFor(wanted: Wanted): Stage | "none" {
    const { river } = this;
    const isRead = this.#draft?.of === wanted;
    this.forget();
    if (isRead && river.adoptDraft) return river.adoptDraft();
    return river.change(wanted.link.text, wanted.link.options);
  }

  /** Something else was painted over it. */
  forget(): void {
    this.#draft = undefined;
  }
}
