// What is laid over a map: labels, woods and hills.

import { atMost, guide, row } from "../table.mjs";
import { inTurn, median, ratios } from "../turns.mjs";

export const GROUPS = {
  "Labels of a map at 1024², from the link to the finished picture": labels,
  "Labels of a moved frame, against the first ones of the map": movedLabels,
  "Woods and hills of a map at 1024², from the link to the finished picture": woods,
};

async function* labels({ native }) {
  const [bare, labelled] = await inTurn(15, [native, "labelled none"], [native, "labelled some"]);
  yield row("native: with labels / without", median(ratios(labelled, bare)), "×", atMost(1.2, 1.12));
  yield guide("with labels", median(labelled), "ms");
}

async function* movedLabels({ native, wasm }) {
  for (const side of [native, wasm]) {
    for (const many of ["some", "many"]) {
      const [first, moved] = await inTurn(15, [side, `labels ${many} anew`], [side, `labels ${many} kept`]);
      yield row(
        `${side.name}: ${many} labels of a moved frame / the first ones`,
        median(ratios(moved, first)),
        "×",
        atMost(1 / 6),
      );
      yield guide("the first ones", median(first), "ms");
      yield guide("those of a moved frame", median(moved), "ms");
    }
  }
}

async function* woods({ native }) {
  const [bare, wooded] = await inTurn(15, [native, "wooded 0"], [native, "wooded 1"]);
  yield row("native: with woods and hills / without", median(ratios(wooded, bare)), "×", atMost(1.25, 1.15));
  yield guide("with woods and hills", median(wooded), "ms");
}
