/** Charts over rivers: once rivers that want names or labels are finished, the module that makes these is fetched, once. */

import type { Charts } from "../engine/charts.ts";
import { named, PageError } from "../engine/errors.ts";
import type { River } from "../engine/types.ts";

export type LoadCharts = () => Promise<Charts>;

/** What of a river a chart is made of, and laid over. */
export type Charted = Pick<River, "wantsChart" | "mapWords" | "takeChart" | "width" | "height">;

export interface CharterEvents {
  /** What makes charts has come: a picture may be painted with one. */
  arrived(): void;
  failed(error: PageError): void;
}

export class Charter {
  #charts: Charts | undefined;
  #isAsked = false;

  constructor(
    private readonly load: LoadCharts,
    private readonly events: CharterEvents,
  ) {}

  /**
   * Lays a chart over a picture that wants one, whose pixels are so many to a CSS pixel, if what makes it is there. Returns whether it
   * did: the picture is then to be painted again.
   */
  lay(river: Charted, ratio: number): boolean {
    if (!river.wantsChart()) return false;
    if (this.#charts) return this.#lay(river, this.#charts, ratio);
    void this.#ask();
    return false;
  }

  #lay(river: Charted, charts: Charts, ratio: number): boolean {
    try {
      layChart(river, charts, ratio);
    } catch (error) {
      // None, so that it is not tried again and again.
      river.takeChart(new Uint8Array());
      this.events.failed(unlabelled(error));
    }
    return true;
  }

  /** Once: a map without labels is a map, and whoever shows it has been told. */
  async #ask(): Promise<void> {
    if (this.#isAsked) return;
    this.#isAsked = true;
    try {
      this.#charts = await this.load();
      this.events.arrived();
    } catch (error) {
      this.events.failed(unlabelled(error));
    }
  }
}

/** What a chart of a river, for a file, says. */
export async function charted<Said>(
  river: Charted,
  load: LoadCharts,
  ask: (chart: InstanceType<Charts["Chart"]>) => Said,
): Promise<Said> {
  const { Chart } = await forFile(load);
  const chart = new Chart(river.mapWords());
  try {
    return ask(chart);
  } finally {
    chart.free();
  }
}

/** A file without the names that it should have is none. */
async function forFile(load: LoadCharts): Promise<Charts> {
  try {
    return await load();
  } catch (error) {
    const { code, message } = named(error);
    throw new PageError(
      "no-files",
      `the part of Riverseed that names rivers did not arrive (${code}: ${message}). Check the connection and try again.`,
    );
  }
}

export function layChart(river: Charted, { Chart }: Charts, ratio = 1): void {
  const chart = new Chart(river.mapWords());
  try {
    river.takeChart(chart.masks(river.width, river.height, ratio));
  } finally {
    chart.free();
  }
}

function unlabelled(error: unknown): PageError {
  const { code, message } = named(error);
  return new PageError(
    "no-chart",
    `The part of Riverseed that names rivers cannot be had (${code}: ${message}). The map is shown without names.`,
  );
}
