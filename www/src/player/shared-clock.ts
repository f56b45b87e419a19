/** One clock for several rivers: whatever each of them costs, they grow tick by tick together, so that they can be compared. */

import type { Growing } from "./frame-loop.ts";

/** A river as its frame loop sees it, and how many ticks it has grown on the clock. */
interface Member extends Growing {
  readonly river: Growing;
  ticks: number;
  /** The error that its river threw, perhaps in another's frame, for its own loop to report. Nothing is asked of the river after that. */
  failure: { thrown: unknown } | undefined;
}

export class SharedClock {
  #members: Member[] = [];

  /** A river that grows by this clock from now on, for its frame loop; late, it catches up. What comes after growth each makes at its own pace. */
  join(river: Growing): Growing {
    const member: Member = {
      river,
      ticks: 0,
      failure: undefined,
      get phase() {
        return member.failure ? "growing" : river.phase;
      },
      get rounds() {
        return river.rounds;
      },
      get progress() {
        return progress();
      },
      advance: (steps) => (member.phase === "growing" ? this.#advance(member) : river.advance(steps)),
      restart: () => {
        member.ticks = 0;
        river.restart();
      },
    };
    const progress = (): number => {
      if (member.failure) return 0;
      return river.phase === "growing" ? this.#progress() : river.progress;
    };
    this.#members.push(member);
    return member;
  }

  /** The others go on without it. */
  leave(member: Growing): void {
    this.#members = this.#members.filter((one) => one !== member);
  }

  get #growing(): Member[] {
    return this.#members.filter(({ phase }) => phase === "growing");
  }

  /** The pace of the river that has the longest way to go, so that none is hurried. */
  #progress(): number {
    return Math.min(...this.#growing.map(({ river }) => river.progress));
  }

  #advance(by: Member): boolean {
    const wasMoved = by.failure === undefined && this.#tick(by);
    if (by.failure) throw by.failure.thrown;
    return wasMoved;
  }

  /** A tick of those that are behind, or of all. The first that grows moves the clock, the others wait for it; returns whether it was moved. */
  #tick(by: Member): boolean {
    const growing = this.#growing;
    if (growing[0] !== by) return false;
    const least = Math.min(...growing.map(({ ticks }) => ticks));
    for (const member of growing) {
      if (member.ticks === least) this.#grow(member);
    }
    return true;
  }

  /** One that fails leaves. */
  #grow(member: Member): void {
    member.ticks++;
    try {
      member.river.advance(1);
    } catch (thrown) {
      member.failure = { thrown };
      this.leave(member);
    }
  }
}
