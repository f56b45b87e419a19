import type { Phase } from "../pkg-make/riverseed.js";
import { FrameLoop, type Growing, type State } from "../src/player/frame-loop.ts";

/** A display and a clock that only move when told; a step takes as long as a test says. */
export class Stage implements Growing {
  time = 1000;
  /** Steps of any kind. */
  ticks = 0;
  drawn: number[] = [];
  phases: Phase[] = [];
  /** Which of the pictures could be drafts. */
  drafts: boolean[] = [];
  ready = 0;
  states: State[] = [];
  failures: unknown[] = [];
  restarts = 0;
  cost = 0;
  /** A picture is painted in so many parts, of so many milliseconds each. */
  partsOfPicture = 1;
  partCost = 0;
  parts = 0;
  #callbacks = new Map<number, (now: number) => void>();
  #handles = 0;
  readonly loop: FrameLoop;

  /**
   * Grows until its last tick; with rounds, it is then made into rivers, which meander for that many. Before that the sea
   * rises in some steps.
   */
  constructor(
    readonly lastTick = 600,
    readonly meanders?: number,
    readonly rises = 0,
    waitMs?: number,
  ) {
    const frames = {
      waitMs,
      now: () => this.time,
      request: (callback: (now: number) => void) => {
        this.#callbacks.set(++this.#handles, callback);
        return this.#handles;
      },
      cancel: (handle: number) => void this.#callbacks.delete(handle),
    };
    this.loop = new FrameLoop(this, frames, {
      draw: (asDraft) => {
        this.time += this.partCost;
        if (++this.parts < this.partsOfPicture) return true;
        this.parts = 0;
        this.drawn.push(this.ticks);
        this.phases.push(this.phase);
        this.drafts.push(asDraft);
        return false;
      },
      ready: () => void this.ready++,
      changed: (state) => void this.states.push(state),
      failed: (error) => void this.failures.push(error),
    });
  }

  get phase(): Phase {
    const risen = this.lastTick + this.rises;
    if (this.ticks < this.lastTick) return "growing";
    if (this.ticks < risen) return "drowning";
    if (this.meanders === undefined || this.ticks > risen + this.meanders) return "finished";
    return this.ticks === risen ? "shaping" : "meandering";
  }

  get progress(): number {
    if (this.phase === "growing") return this.ticks / this.lastTick;
    if (this.phase === "drowning") return (this.ticks - this.lastTick) / this.rises;
    return this.phase === "meandering" ? (this.ticks - this.lastTick - this.rises - 1) / this.rounds : 0;
  }

  get rounds(): number {
    return this.meanders ?? 0;
  }

  advance(ticks: number): boolean {
    const { phase } = this;
    if (phase === "finished") throw new Error("it is finished, and advances");
    this.ticks += ticks;
    this.time += this.cost;
    return this.phase !== "finished";
  }

  restart(): void {
    this.ticks = 0;
    this.restarts++;
  }

  get waiting(): number {
    return this.#callbacks.size;
  }

  /** Frames at a steady rate; a frame that works longer than its time makes the next one late. */
  frames(count: number, everyMs = 1000 / 60): void {
    for (let i = 0; i < count; i++) {
      const due = this.time + everyMs;
      const callbacks = [...this.#callbacks.values()];
      this.#callbacks.clear();
      for (const callback of callbacks) callback(this.time);
      this.time = Math.max(this.time, due);
    }
  }
}
