#!/usr/bin/env bash
# Where three rivers meet in one cell, two libraries of hydrology give wrong Strahler orders, each in a way of its own, without a warning.
#
# Versions: pysheds 0.5, topotoolbox 0.0.12, pyflwdir 0.5.12; NumPy 2.2.6, Python 3.11.
# Input:    a grid of flow directions (D8) in which three tributaries reach one cell from the west, the north and the east. By Strahler's rule
#           the order rises by one where the highest of the orders that meet is there at least twice.
# Guess:    all three know the rule, as orders are what they are used for.
# Seen:     orders that meet   rule  pyflwdir  pysheds  topotoolbox
#           2, 2 and 1          3       3         2         3           pysheds raises the order only where all are equal
#           1, 2 and 1          2       2         2         3           topotoolbox adds one river after the other: 1 and 1 are 2, then 2 and 2 are 3;
#           2, 1 and 1          2       2         2         2           so its answer depends on the side from which the greatest comes
#           In pysheds, too, the cell after a river's last, outside the mask, is one order higher than the river.
# So:       with these two, orders are safe only on networks where never more than two rivers meet; pyflwdir is right everywhere here.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder"
"$folder/bin/pip" install --quiet --disable-pip-version-check --only-binary :all: numpy==2.2.6 pysheds==0.5 topotoolbox==0.0.12 pyflwdir==0.5.12
"$folder/bin/python" -W ignore - <<'PYTHON'
import sys

import numpy as np
import pyflwdir
import topotoolbox
from affine import Affine
from pysheds.grid import Grid
from pysheds.view import Raster, ViewFinder

STEPS = {1: (0, 1), 2: (1, 1), 4: (1, 0), 8: (1, -1), 16: (0, -1), 32: (-1, -1), 64: (-1, 0), 128: (-1, 1)}
MEETING, LAST = (5, 5), (9, 5)


def directions(west, north, east):
    """ESRI's codes; a tributary of order 1 is one line, one of order 2 begins with two sources."""
    flow = np.zeros((11, 11), np.uint8)
    flow[5:10, 5] = 4
    flow[5, 2:5], flow[2:5, 5], flow[5, 6:9] = 1, 4, 16
    for order, one, two in [
        (west, [((5, 1), 1)], [((4, 1), 2), ((6, 1), 128)]),
        (north, [((1, 5), 4)], [((1, 4), 2), ((1, 6), 8)]),
        (east, [((5, 9), 16)], [((4, 9), 8), ((6, 9), 32)]),
    ]:
        for cell, code in one if order == 1 else two:
            flow[cell] = code
    return flow


def by_pyflwdir(flow):
    codes = np.where(flow == 0, 247, flow).astype(np.uint8)  # 247: no data
    codes[LAST] = 0
    return pyflwdir.from_array(codes, ftype="d8").stream_order()


def by_pysheds(flow):
    view = lambda nodata: ViewFinder(affine=Affine(1, 0, 0, 0, -1, 11), shape=flow.shape, nodata=nodata)
    codes = Raster(flow.astype(np.int64), viewfinder=view(np.int64(0)))
    return Grid.from_raster(codes).stream_order(codes, Raster(flow > 0, viewfinder=view(np.bool_(False))))


def by_topotoolbox(flow):
    """It wants heights: so steep that each cell's steepest way down is the given one."""
    heights = np.full(flow.shape, 1e6, np.float32)
    for cell in zip(*np.nonzero(flow)):
        at, length = cell, 0
        while flow[at]:
            at, length = tuple(np.add(at, STEPS[flow[at]])), length + 1
        heights[cell] = 3.0**length
    heights[10, 5] = 1

    def grid(values):
        made = topotoolbox.GridObject()
        made.z, made.cellsize = values, 1.0
        return made

    streams = topotoolbox.StreamObject(topotoolbox.FlowObject(grid(heights)), stream_pixels=grid((heights < 1e6).astype(np.float32)))
    orders = np.zeros(flow.shape)
    orders[tuple(np.array(streams.node_indices))] = streams.streamorder()
    return orders


seen = {}
for meet in [(2, 2, 1), (1, 2, 1), (2, 1, 1)]:
    flow = directions(*meet)
    seen[meet] = tuple(int(orders(flow)[8, 5]) for orders in (by_pyflwdir, by_pysheds, by_topotoolbox))
    print(*meet, "meet: pyflwdir {}, pysheds {}, topotoolbox {}".format(*seen[meet]))
river, after = by_pysheds(directions(2, 2, 1))[9:11, 5]
print(f"pysheds: the river's last cell {river}, the cell after it {after}")
expected = {(2, 2, 1): (3, 2, 3), (1, 2, 1): (2, 2, 3), (2, 1, 1): (2, 2, 2)}
sys.exit(0 if seen == expected and (river, after) == (2, 3) else "this has changed")
PYTHON
