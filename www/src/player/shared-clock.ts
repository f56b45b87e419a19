/**
 * One clock for several rivers: they grow tick by tick together, however long each takes, so that they can be compared.
 */

import type { Growing } from "./frame-loop.ts";

/** A river as its frame loop sees it, and how many ticks it has grown on the clock. */
interface Member extends Growing {
  readonly river: Growing;
  ticks: number;
  /**
   * The error that its river threw, perhaps in another's frame, for its own loop to report. The river is not used after
   * that.
   */
  failure: { thrown: unknown } | undefined;
}

export class SharedClock {
  #members: Member[] = [];

  /**
   * Lets a river grow by this clock, and returns it for its frame loop. One that joins late catches up. After growth
   * each river has its own pace.
   */
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

  /** Removes a river; the others go on without it. */
  leave(member: Growing): void {
    this.#members = this.#members.filter((one) => one !== member);
  }

  get #growing(): Member[] {
    return this.#members.filter(({ phase }) => phase === "growing");
  }

  /** Returns the progress of the river that has the longest way to go, so that none is hurried. */
  #progress(): number {
    return Math.min(...this.#growing.map(({ river }) => river.progress));
  }

  #advance(by: Member): boolean {
    const wasMoved = by.failure === undefined && this.#tick(by);
    if (by.failure) throw by.failure.thrown;
    return wasMoved;
  }

  /**
   * Makes a tick for the rivers that are behind, or for all. Only the first growing river moves the clock; the others
   * wait for it. Returns whether the clock was moved.
   */
  #tick(by: Member): boolean {
    const growing = this.#growing;
    if (growing[0] !== by) return false;
    const least = Math.min(...growing.map(({ ticks }) => ticks));
    for (const member of growing) {
      if (member.ticks === least) this.#grow(member);
    }
    return true;
  }

  /** Grows one river by a tick. A river that fails leaves. */
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
