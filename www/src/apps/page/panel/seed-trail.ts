/** The seeds that were on show, one after the other, to go back and forth between. */

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

  /** A seed is on show. One that is not where the trail leads begins another way on. */
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
