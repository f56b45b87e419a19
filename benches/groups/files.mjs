// Files: of whole maps, and of pictures. All natively.

import { atLeast, atMost, guide, row } from "../table.mjs";
import { inTurn, median, ratios } from "../turns.mjs";

export const GROUPS = {
  "Whole maps with their files, natively: islands of which nothing is trimmed, with their relief": whole,
  "A picture of 2048² as PNG, natively": png,
};

async function* whole({ native }) {
  const [few, many] = [100_000, 1_000_000];
  for (const growth of ["drainage", "colonize"]) {
    const tasks = [few, many].map((attractors) => [native, `whole ${growth} ${attractors}`]);
    const [short, long] = await inTurn(3, ...tasks);
    const exponent = Math.log(median(ratios(long, short))) / Math.log(many / few);
    yield row(`${growth}: exponent from 100,000 to 1,000,000 attractors`, exponent, "", atMost(1.1));
    yield guide("N = 100,000", median(short), "ms");
    yield guide("N = 1,000,000", median(long), "ms");
  }
  for (const form of ["json", "geojson", "svg"]) {
    const [written] = await inTurn(5, [native, `file ${form} ${few}`]);
    yield guide(`${form} of the second, N = 100,000`, median(written), "ms");
  }
}

async function* png({ native }) {
  for (const style of ["ink", "atlas"]) {
    const tasks = [`png ${style}`, `balanced-png ${style}`];
    const [size, balancedSize] = [(await native.run(tasks[0])).result, (await native.run(tasks[1])).result];
    const [ours, balanced] = await inTurn(7, ...tasks.map((task) => [native, task]));
    yield row(
      `${style}: the crate's balanced compression / ours`,
      median(ratios(balanced, ours)),
      "×",
      atLeast(1.5, 2),
    );
    yield guide("ours", median(ours), "ms");
    yield row(`${style}: size of ours / balanced`, size / balancedSize, "×", atMost(1.1));
  }
}
