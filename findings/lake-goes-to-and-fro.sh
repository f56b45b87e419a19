#!/usr/bin/env bash
# Water that enters a level lake with an outlet goes to and fro there for ever, and the river below the outlet has nearly none of it.
#
# Version:  landlab 2.11.0 with py-richdem 2.2.0rc3; NumPy 2.2.6, Python 3.11.
# Input:    60 by 41 heights: a valley, in it a lake of 519 cells at one level with an island, and one outlet, lower than the lake. No cell is
#           lower than all around it.
# Guess:    `PriorityFloodFlowRouter` with `depression_handler="breach"`, all else by default, leads the lake to its outlet as it does with "fill":
#           the documentation says that breaching gives every cell a way to the border, and `epsilon`, on by default, every flat a gradient. At
#           worst each cell of the lake drains to itself, as a note in its source says and as its other metrics do.
# Seen:     only 7 of 519 cells reach the outlet. From the others water goes to and fro between two neighbours, as a receiver may be as high as
#           the cell itself. The outlet drains 6 cells instead of 1,592, and of 2,262 cells that have rain only 676 are counted at the border.
#           By Rho8, Quinn, Freeman and D-infinity 516 cells drain to themselves. No warning. The same with "fill" and `epsilon=False`: what is
#           level is left level by both, as it is no depression.
# So:       loops over receivers never end in such a lake. Keep "fill" with `epsilon`, or take FlowAccumulator with a depression finder.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder"
"$folder/bin/pip" install --quiet --disable-pip-version-check --only-binary :all: numpy==2.2.6 landlab==2.11.0 py-richdem==2.2.0rc3
cat > "$folder/lake.py" <<'PYTHON'
import sys

import numpy as np
from landlab import RasterModelGrid
from landlab.components import DepressionFinderAndRouter, FlowAccumulator, PriorityFloodFlowRouter

LEVEL, OUTLET = 100.0, (40, 20)
rows, columns = np.mgrid[0:60, 0:41]
across = np.abs(columns - 20)
lake = ((rows - 27.5) / 12.5) ** 2 + (across / 14) ** 2 < 1
island = np.hypot(rows - 26, columns - 17)
heights = LEVEL + np.maximum(40 - rows + 3 * across, 0.5)
heights[lake] = LEVEL
heights[40] = LEVEL + 2 + across[40]
heights[41:] = (LEVEL - 0.5 - (rows - 40) + 3 * across)[41:]
heights[OUTLET] = LEVEL - 0.5
heights = np.where(island < 3, LEVEL + 3 - island, heights)
lake &= island >= 3


def field(grid, name):
    return np.array(grid.at_node[name])


def grid():
    made = RasterModelGrid(heights.shape, 1.0)
    made.add_field("topographic__elevation", heights.ravel().copy(), at="node")
    return made


def by_accumulator():
    made = grid()
    FlowAccumulator(made, flow_director="FlowDirectorD8", depression_finder=DepressionFinderAndRouter).run_one_step()
    return made


def by_flood(metric="D8", **options):
    made = grid()
    PriorityFloodFlowRouter(made, flow_metric=metric, suppress_out=True, **options).run_one_step()
    return made


def measures(made):
    """Cells of the lake that reach the outlet, that drain to themselves, that circle; cells above the outlet; cells counted at the border."""
    receivers, area = field(made, "flow__receiver_node"), field(made, "drainage_area").reshape(heights.shape)
    if receivers.ndim > 1:
        receivers = receivers[:, 0]
    reach = ends = circle = 0
    for at in np.flatnonzero(lake):
        seen = set()
        while at not in seen and at != np.ravel_multi_index(OUTLET, heights.shape):
            seen.add(at)
            before, at = at, receivers[at]
        if at not in seen:
            reach += 1
        elif at == before:
            ends += 1
        else:
            circle += 1
    border = area[0].sum() + area[-1].sum() + area[1:-1, 0].sum() + area[1:-1, -1].sum()
    return reach, ends, circle, round(float(area[OUTLET])), round(float(border))


assert all(heights[y - 1 : y + 2, x - 1 : x + 2].min() < heights[y, x] or lake[y, x] for y in range(1, 59) for x in range(1, 40))
print(f"{lake.sum()} cells of a lake; reach the outlet, end, go to and fro; cells above the outlet; cells counted at the border")
seen = {
    "FlowAccumulator": measures(by_accumulator()),
    "fill": measures(by_flood()),
    "fill, no epsilon": measures(by_flood(depression_handler="fill", epsilon=False)),
    "breach": measures(by_flood(depression_handler="breach")),
}
for name, measured in seen.items():
    print(f"{name}: {measured}")
still = []
for metric in ("Rho8", "Quinn", "Freeman", "Dinf"):
    receivers = field(by_flood(metric, depression_handler="breach"), "flow__receiver_node").reshape(heights.size, -1)[:, 0]
    still.append(int((receivers == np.arange(heights.size))[lake.ravel()].sum()))
print("cells that drain to themselves by other metrics:", *still)
right, wrong = (519, 0, 0, 1592, 2262), (7, 0, 512, 6, 676)
expected = {"FlowAccumulator": right, "fill": right, "fill, no epsilon": wrong, "breach": wrong}
sys.exit(0 if seen == expected and still == [516] * 4 else "this has changed")
PYTHON
"$folder/bin/python" -W ignore "$folder/lake.py"
