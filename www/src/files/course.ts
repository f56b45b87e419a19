/** The making of a file in steps; between them it reports its progress and lets others have their turn. */

import type { WholeRiver } from "../engine/whole.ts";

/** The course of one file. */
export interface Course {
  /** Reports how far it is, from 0 to 1. */
  tell(share: number): void;
  /** Lets others have their turn. Throws once the file is no longer wanted. */
  pause(): Promise<void>;
}

/** A part of a course, between two shares of it. */
export function partOf(course: Course, from: number, to: number): Course {
  return { tell: (share) => course.tell(from + (to - from) * share), pause: () => course.pause() };
}

/** The time between two pauses, too short to be noticed. */
const SLICE_MS = 12;

/** Takes steps until one returns false, and between some of them reports their `share` and pauses. */
export async function inSteps(course: Course, step: () => boolean, share: () => number): Promise<void> {
  let end = performance.now() + SLICE_MS;
  while (step()) {
    if (performance.now() < end) continue;
    course.tell(share());
    await course.pause();
    end = performance.now() + SLICE_MS;
  }
}

/** The end of each phase, as a share of growing. */
const OVER = { growing: 0.6, drowning: 0.63, shaping: 0.66, meandering: 0.8, relief: 1, finished: 1 } as const;

/** Takes a river to its end. */
export function grow(river: WholeRiver, course: Course): Promise<void> {
  let before = 0;
  const share = (): number => {
    const over = OVER[river.phase];
    const earlier = Math.max(0, ...Object.values(OVER).filter((other) => other < over));
    before = Math.max(before, earlier + (over - earlier) * river.progress);
    return before;
  };
  return inSteps(course, () => river.advance(1), share);
}
