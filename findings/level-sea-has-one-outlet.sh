#!/usr/bin/env bash
# A level sea, or a lake that the border cuts, has one outlet, the first of its cells in the order of rows: so all its rivers become one system.
#
# Versions: pyflwdir 0.5.12; for comparison pysheds 0.5 and topotoolbox 0.0.12; NumPy 2.2.6, Python 3.11.
# Input:    60 by 60 heights: three straight valleys that fall to the south, 1 m a cell, and from row 40 to the border a sea with the height 0. The
#           same turned by a half.
# Guess:    `from_dem` has outlets at the edge of what is valid, as its documentation says, that is at every cell of the border that does not fall
#           inwards: 98 in the sea. So three rivers leave by three ways, as in pysheds (with its flats resolved) and in topotoolbox.
# Seen:     a single pit. All 3,600 cells are one basin, and the third river runs 50 cells along the coast, past the mouths of the other two, to the
#           sea's first cell, in the corner with the lowest row and column; the border to the south is 20 cells away, that to the east 9. Turned by
#           a half it crosses the sea to the corner of the whole map, and the highest order is 4 instead of 3. The border's cells are in the queue,
#           but the first that is taken from it, the least row of the lowest, takes its equals for its tributaries; and so on along the border.
# So:       basins and orders depend on how the map lies. Give the sea as no data: three pits, three basins, whichever way it is turned.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder"
"$folder/bin/pip" install --quiet --disable-pip-version-check --only-binary :all: numpy==2.2.6 pyflwdir==0.5.12 pysheds==0.5 topotoolbox==0.0.12
cat > "$folder/sea.py" <<'PYTHON'
import sys

import numpy as np
import pyflwdir
import topotoolbox
from affine import Affine
from pysheds.grid import Grid
from pysheds.view import Raster, ViewFinder

NO_DATA = -9999.0
CODES = {(-1, 0): 64, (-1, 1): 128, (0, 1): 1, (1, 1): 2, (1, 0): 4, (1, -1): 8, (0, -1): 16, (-1, -1): 32}
MOUTHS = (39, 10), (39, 30), (39, 50)
rows, columns = np.mgrid[0:60, 0:60]
heights = np.where(rows < 40, 40 - rows + np.abs(columns % 20 - 10) / 2, 0.0)


def ends(downstream):
    """Where the rivers end, and after how many cells."""
    seen = []
    for at in MOUTHS:
        count = 0
        while at in downstream:
            at, count = downstream[at], count + 1
        seen.append((*at, count))
    return seen


def by_pysheds():
    raster = Raster(heights, ViewFinder(affine=Affine(1, 0, 0, 0, -1, 60), shape=heights.shape, nodata=np.float64(NO_DATA)))
    grid = Grid.from_raster(raster)
    found = np.asarray(grid.flowdir(grid.resolve_flats(raster), dirmap=tuple(CODES.values())))
    steps = {code: step for step, code in CODES.items()}
    downstream = {}
    for at in np.ndindex(found.shape):
        if found[at] in steps:
            downstream[at] = tuple(int(place) for place in np.add(at, steps[found[at]]))
    return downstream


def by_topotoolbox():
    grid = topotoolbox.GridObject()
    grid.z, grid.cellsize = heights.astype(np.float32), 1.0
    flow = topotoolbox.FlowObject(grid)
    pairs = zip(zip(*flow.source_indices), zip(*flow.target_indices))
    return {tuple(map(int, here)): tuple(map(int, there)) for here, there in pairs}


def by_pyflwdir(values):
    """Pits, how many basins the mouths are in, and the highest order; and the cell downstream of each."""
    flow = pyflwdir.from_dem(values, nodata=NO_DATA)
    basins, turned = flow.basins(), values[0, 0] <= 0
    mouths = [(59 - row, 59 - column) if turned else (row, column) for row, column in MOUTHS]
    pits = [tuple(int(place) for place in divmod(pit, 60)) for pit in flow.idxs_pit]
    measured = pits if len(pits) == 1 else len(pits), len({int(basins[mouth]) for mouth in mouths}), int(flow.stream_order().max())
    downstream = {}
    for at in np.ndindex(values.shape):
        here = at[0] * 60 + at[1]
        there = int(flow.idxs_ds[here])
        if there not in (here, -1):
            downstream[at] = divmod(there, 60)
    return measured, downstream


level, downstream = by_pyflwdir(heights)
turned, _ = by_pyflwdir(np.ascontiguousarray(np.rot90(heights, 2)))
without_sea = np.where(heights > 0, heights, NO_DATA)
cut, _ = by_pyflwdir(without_sea)
cut_turned, _ = by_pyflwdir(np.ascontiguousarray(np.rot90(without_sea, 2)))
print("pyflwdir: pits, basins of three rivers, highest order:", level, "turned:", turned, "sea as no data:", cut, "turned:", cut_turned)
found = {"pyflwdir": ends(downstream), "pysheds": ends(by_pysheds()), "topotoolbox": ends(by_topotoolbox())}
for name, places in found.items():
    print(f"{name}: rivers end at (row, column, after so many cells) {places}")
apart = all(len(set(found[name])) == 3 and {count for *_, count in found[name]} != {0} for name in ("pysheds", "topotoolbox"))
is_same = level == ([(40, 0)], 1, 3) and turned == ([(0, 0)], 1, 4) and cut[:2] == cut_turned[:2] == (3, 3) and apart
sys.exit(0 if is_same and found["pyflwdir"] == [(40, 0, 10), (40, 0, 30), (40, 0, 50)] else "this has changed")
PYTHON
"$folder/bin/python" -W ignore "$folder/sea.py"
