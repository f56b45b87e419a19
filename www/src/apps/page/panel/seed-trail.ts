/** The trail of seeds that were on show, along which one can go back and forth. */

export interface TrailElements {
  previous: HTMLButtonElement;
  next: HTMLButtonElement;
}

export class SeedTrail {
  #seeds: string[] = [];
  #at = -1;

  constructor(
    private readonly elements: TrailElements,
    private readonly go: (seed: string) => void,
  ) {
    elements.previous.addEventListener("click", () => this.#go(-1));
    elements.next.addEventListener("click", () => this.#go(1));
  }

  /** Takes the seed on show. One that is not next to the current place on the trail replaces the rest of it. */
  show(seed: string): void {
    const step = [0, -1, 1].find((step) => this.#seeds[this.#at + step] === seed);
    if (step === undefined) this.#seeds = [...this.#seeds.slice(0, this.#at + 1), seed];
    this.#at += step ?? 1;
    this.elements.previous.disabled = this.#at === 0;
    this.elements.next.disabled = this.#at === this.#seeds.length - 1;
  }

  #go(step: number): void {
    const seed = this.#seeds[this.#at + step];
    if (seed !== undefined) this.go(seed);
  }
}
