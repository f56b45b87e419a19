/** Lays charts over rivers. The charts module is fetched, once, when rivers that want names or labels are finished. */

import type { Framing } from "../browser/canvas.ts";
import type { Charts } from "../engine/charts.ts";
import { named, PageError } from "../engine/errors.ts";
import type { River } from "../engine/types.ts";

type Chart = InstanceType<Charts["Chart"]>;

export type LoadCharts = () => Promise<Charts>;

/** The part of a river that a chart is made from and laid over. */
export type Chartable = Pick<River, "wantsChart" | "mapData" | "takeChart" | "width" | "height">;

export interface ChartMakerEvents {
  /** Called when the charts module has arrived: pictures can be painted with charts now. */
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
   * Lays a chart over a picture that wants one, if the charts module has arrived; `ratio` is device pixels per CSS
   * pixel. Returns whether it did: then the picture is to be painted again.
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
      // An empty chart, so that it is not tried again and again.
      river.takeChart(new Uint8Array());
      this.events.failed(unlabelled(error));
    }
    return true;
  }

  /** Fetches the charts module. A failure is reported once and not tried again: the map is shown without labels. */
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

/** Makes a chart of a river and asks it something. */
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
  /** Called before a long step: a file is painted or written in one. */
  holdOn(): void;
}

/**
 * Asks a chart for a file's data, fetching the charts module if need be. Calls `holdOn` first; it covers the work that
 * follows at once, too.
 */
export async function askChartForFile<Said>(
  river: Chartable,
  { loadCharts, holdOn }: FileMeans,
  ask: (chart: Chart) => Said,
): Promise<Said> {
  const charts = await forFile(loadCharts);
  holdOn();
  return askChart(river, charts, ask);
}

/**
 * Loads the charts module for a file. Fails if it does not arrive, since a file without its names would be incomplete.
 */
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
    `The part of Riverseed that names rivers could not be loaded (${code}: ${message}). The map is shown without names.`,
  );
}
