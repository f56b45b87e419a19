#!/usr/bin/env bash
# Rivers that end before the border of the grid are led back to the first cell of the network, so three rivers of an island become one.
#
# Version:  topotoolbox 0.0.12; NumPy 2.2.6, Python 3.11.
# Input:    24 by 31 heights, cells of 100 m: three straight valleys that fall 15 m a cell to the south and go on below the sea's level, 0 m.
#           As `stream_pixels`, the cells on land that 20 cells and more drain to: three rivers of ten cells.
# Guess:    three rivers of 900 m, each with its outlet at its last cell.
# Seen:     no outlet at all, and one confluence, at the first source, with Strahler's order 3. Two lines, with straight jumps of 2,193 m and 1,345 m
#           across the hills. The distance "from the outlet" is 1,183 m at two of the last cells, and 2,083 m at most. `klargestconncomps(1)` has no
#           cell. From each last cell an edge leads out of the network; instead of being dropped it ends at node 0. No error, no warning.
# So:       give the sea as NaN, or make the network by threshold and cut it with `subgraph`: both give what was guessed.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder"
"$folder/bin/pip" install --quiet --disable-pip-version-check --only-binary :all: numpy==2.2.6 topotoolbox==0.0.12
"$folder/bin/python" -W ignore - <<'PYTHON'
import sys

import numpy as np
import topotoolbox

CELL = 100.0
rows, columns = np.mgrid[0:24, 0:31]
heights = 200.0 - 15 * rows + 20 * np.abs(columns % 10 - 5)


def grid(values):
    made = topotoolbox.GridObject()
    made.z, made.cellsize = values.astype(np.float32), CELL
    return made


def rivers(land, is_cut=False):
    """The rivers on land: given as cells, or cut from the network that goes on to the border."""
    flow = topotoolbox.FlowObject(grid(land))
    cells = grid((np.asarray(flow.flow_accumulation()) >= 20) & (heights > 0))
    return topotoolbox.StreamObject(flow, threshold=20).subgraph(cells) if is_cut else topotoolbox.StreamObject(flow, stream_pixels=cells)


def measures(streams):
    distances = streams.upstream_distance()
    is_last = streams.node_indices[0] == streams.node_indices[0].max()
    steps = [np.hypot(*np.diff(np.array(line.coords), axis=0).T).max() * CELL for line in streams.to_geodataframe().geometry]
    return {
        "longest step of each line": sorted(round(float(step)) for step in steps),
        "outlets": int(streams.streampoi("outlets").sum()),
        "confluences": int(streams.streampoi("confluences").sum()),
        "highest order": int(streams.streamorder().max()),
        "last cells to outlet": sorted(round(float(distance)) for distance in distances[is_last]),
        "farthest": round(float(distances.max())),
        "cells of the largest system": int(streams.klargestconncomps(1).stream.size),
    }


given, cut = measures(rivers(heights)), measures(rivers(heights, is_cut=True))
without_sea = measures(rivers(np.where(heights > 0, heights, np.nan)))
print("as stream_pixels:", given, "the same, NaN at sea:", without_sea, "cut from the network:", cut, sep="\n")
wrong, right = [[1345, 2193], 0, 1, 3, [141, 1183, 1183], 2083, 0], [[100] * 3, 3, 0, 1, [0] * 3, 900, 10]
sys.exit(0 if [*given.values()] == wrong and [*without_sea.values()] == [*cut.values()] == right else "this has changed")
PYTHON
