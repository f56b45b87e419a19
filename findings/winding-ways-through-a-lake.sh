#!/usr/bin/env bash
# The larger a level lake is, the more the water winds in it: in one with 80,000 cells ways to the outlet are 32 times as long as they need be.
#
# Version:  fastscapelib 0.3.0; NumPy 2.2.6, Python 3.11.
# Input:    round lakes at one level, of radius 10, 40 and 160 cells of 1 m, in land that rises from the shore, with one outlet, lower than the lake.
# Guess:    both resolvers lead the lake to its outlet about as the crow flies over a grid: `PFloodSinkResolver` does, and `MSTSinkResolver` by
#           default only turns round the one way between the pit of a depression and its spill; a lake with an outlet is none.
# Seen:     radius  shortest way on the grid, mean   PFlood   MST
#           10                   12.9 m             13.0 m      44 m
#           40                   48.7 m             48.8 m     422 m
#           160                 191.9 m            192.0 m   6,087 m
#           MST takes a cell of a level lake for a basin of its own, with nothing to tell apart the passes between them, which are all as high; so
#           its tree is one of many, and no short one. All water does come to the outlet, and areas drained below it are right.
# So:       distances, times of travel and slopes through a lake mean nothing by MST. Use PFlood where lakes are level, or give it their beds.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder"
"$folder/bin/pip" install --quiet --disable-pip-version-check --only-binary :all: numpy==2.2.6 fastscapelib==0.3.0
cat > "$folder/ways.py" <<'PYTHON'
import sys

import fastscapelib
import numpy as np

LEVEL = 100.0


def lake_of(radius):
    """Heights, which cells are lake, and the cell of the outlet."""
    rows, columns = np.mgrid[0 : 2 * radius + 13, 0 : 2 * radius + 7]
    middle = radius + 3
    beyond = np.hypot(rows - middle, columns - middle) - radius
    heights = np.where(beyond > 0, LEVEL + 1 + beyond / 2, LEVEL)
    down = np.arange(middle + radius + 1, len(heights))
    heights[down, middle] = LEVEL - 0.5 - 0.1 * (down - middle - radius)
    return heights, beyond <= 0, (middle + radius + 1, middle)


def ways(heights, lake, outlet, *operators):
    """The lengths of all ways from the lake's cells to the outlet; infinite if one does not get there."""
    grid = fastscapelib.RasterGrid(heights.shape, [1.0, 1.0], fastscapelib.NodeStatus.FIXED_VALUE)
    graph = fastscapelib.FlowGraph(grid, list(operators))
    graph.update_routes(heights.copy())
    receivers, width = graph.impl().receivers[:, 0].astype(int), heights.shape[1]
    lengths = np.full(heights.size, np.nan)
    lengths[outlet[0] * width + outlet[1]] = 0
    for at in np.flatnonzero(lake):
        way = []
        while np.isnan(lengths[at]) and receivers[at] != at:
            way.append(at)
            at = receivers[at]
        reached = np.inf if np.isnan(lengths[at]) else lengths[at]
        for cell in reversed(way):
            reached += np.hypot(*np.subtract(divmod(cell, width), divmod(receivers[cell], width)))
            lengths[cell] = reached
    return lengths[lake.ravel()], float(graph.accumulate(1.0)[outlet])


seen = []
for radius in (10, 40, 160):
    heights, lake, outlet = lake_of(radius)
    away = np.sort(np.abs(np.argwhere(lake) - outlet), axis=1)
    shortest = (away[:, 1] + (np.sqrt(2) - 1) * away[:, 0]).mean()
    flood, below_flood = ways(heights, lake, outlet, fastscapelib.PFloodSinkResolver(), fastscapelib.SingleFlowRouter())
    tree, below_tree = ways(heights, lake, outlet, fastscapelib.SingleFlowRouter(), fastscapelib.MSTSinkResolver())
    print(f"{lake.sum()} cells: shortest {shortest:.1f}, PFlood {flood.mean():.1f}, MST {tree.mean():.1f} and {tree.max():.0f} at most;", end=" ")
    print(f"drained {below_flood:.0f} and {below_tree:.0f}")
    seen.append((flood.mean() / shortest < 1.02, round(tree.mean() / shortest, 1), below_flood == below_tree))
sys.exit(0 if seen == [(True, 3.4, True), (True, 8.7, True), (True, 31.7, True)] else "this has changed")
PYTHON
"$folder/bin/python" -W ignore "$folder/ways.py"
