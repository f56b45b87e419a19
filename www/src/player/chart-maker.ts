/** Charts over rivers: once rivers that want names or labels are finished, the module that makes these is fetched, once. */

import type { Framing } from "../browser/canvas.ts";
import type { Charts } from "../engine/charts.ts";
import { named, PageError } from "../engine/errors.ts";
import type { River } from "../engine/types.ts";

type Chart = InstanceType<Charts["Chart"]>;

export type LoadCharts = () => Promise<Charts>;

/** The part of a river that a chart is made of, and laid over. */
export type Chartable = Pick<River, "wantsChart" | "mapData" | "takeChart" | "width" | "height">;

export interface ChartMakerEvents {
  /** The charts module has arrived: a picture may be painted with one. */
  arrived(): void;
  failed(error: PageError): void;
}

export class ChartMaker {
  #charts: Charts | undefined;
  #isAsked = false;

  constructor(
    private readonly load: LoadCharts,
    private readonly events: ChartMakerEvents,
  ) {}

  /**
   * Lays a chart over a picture that wants one, whose pixels are so many to a CSS pixel, if what makes it is there. Returns whether it
   * did: the picture is then to be painted again.
   */
  lay(river: Chartable, ratio: number, framing?: Framing): boolean {
    if (!river.wantsChart()) return false;
    if (this.#charts) return this.#lay(river, this.#charts, ratio, framing);
    void this.#ask();
    return false;
  }

  #lay(river: Chartable, charts: Charts, ratio: number, framing: Framing | undefined): boolean {
    try {
      layChart(river, charts, ratio, framing);
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

/** Asks a chart of a river. */
export function askChart<Said>(river: Chartable, { Chart }: Charts, ask: (chart: Chart) => Said): Said {
  const chart = new Chart(river.mapData());
  try {
    return ask(chart);
  } finally {
    chart.free();
  }
}

/** The means of making a file, besides its river. */
export interface FileMeans {
  readonly loadCharts: LoadCharts;
  /** Called before a step that takes long: what is painted or written for a file is, in one. */
  holdOn(): void;
}

/** Asks a chart for a file, and fetches the charts module if need be. Work that follows at once may take as long. */
export async function askChartForFile<Said>(
  river: Chartable,
  { loadCharts, holdOn }: FileMeans,
  ask: (chart: Chart) => Said,
): Promise<Said> {
  const charts = await forFile(loadCharts);
  holdOn();
  return askChart(river, charts, ask);
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

export function layChart(river: Chartable, charts: Charts, ratio = 1, framing?: Framing): void {
  const shown = new Float32Array(framing ?? []);
  river.takeChart(askChart(river, charts, (chart) => chart.masks(river.width, river.height, ratio, shown)));
}

function unlabelled(error: unknown): PageError {
  const { code, message } = named(error);
  return new PageError(
    "no-chart",
    `The part of Riverseed that names rivers cannot be had (${code}: ${message}). The map is shown without names.`,
  );
}
