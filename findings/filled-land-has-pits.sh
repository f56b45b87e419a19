#!/usr/bin/env bash
# A land whose pits a library of hydrology has filled still has pits: more than a fifth of the cells that it raised lie in one.
#
# Versions: pyflwdir 0.5.12; for comparison topotoolbox 0.0.12; NumPy 2.2.6, Python 3.11.
# Input:    120 by 120 heights from 0 to 4,000 m, as 32-bit and as 64-bit floats.
# Guess:    filled cells have exactly the height over which their water leaves, so filling once more changes nothing.
# Seen:     pyflwdir adds to each cell what it lacks, z + (level - z), which is not `level` in floats. So a filled lake is not flat: its cells are
#           up to 0.00012 m off. Filled once more by an exact rule, 1,115 of its 5,018 raised cells rise again. With 64 bits it is worse, 2,307 of
#           5,064, as levels are kept in 32. topotoolbox, given 32 bits, leaves none.
# So:       take the directions that it returns beside the heights, which are right, and never directions made of the filled heights.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder"
"$folder/bin/pip" install --quiet --disable-pip-version-check --only-binary :all: numpy==2.2.6 topotoolbox==0.0.12 pyflwdir==0.5.12
"$folder/bin/python" -W ignore - <<'PYTHON'
import heapq
import sys

import numpy as np
import pyflwdir
import topotoolbox


def exact(heights):
    """Each cell as high as the lowest way from it to the border, by copying heights only."""
    filled, queue = np.full(heights.shape, np.inf, heights.dtype), []
    rows, columns = heights.shape
    for at in np.ndindex(heights.shape):
        if at[0] in (0, rows - 1) or at[1] in (0, columns - 1):
            filled[at] = heights[at]
            heapq.heappush(queue, (heights[at], at))
    while queue:
        level, (row, column) = heapq.heappop(queue)
        for near in np.ndindex(3, 3):
            at = row + near[0] - 1, column + near[1] - 1
            if 0 <= at[0] < rows and 0 <= at[1] < columns and filled[at] == np.inf:
                filled[at] = max(heights[at], level)
                heapq.heappush(queue, (filled[at], at))
    return filled


def by_pyflwdir(heights):
    return pyflwdir.dem.fill_depressions(heights.copy(), nodata=-9999)[0]


def by_topotoolbox(heights):
    grid = topotoolbox.GridObject()
    grid.z, grid.cellsize = heights.copy(), 1.0
    return grid.fillsinks().z


seen = {}
land = np.random.default_rng(1).random((120, 120)) * 4000
for fill, kind in [(by_pyflwdir, np.float32), (by_pyflwdir, np.float64), (by_topotoolbox, np.float32)]:
    heights = land.astype(kind)
    filled = fill(heights)
    left = int((exact(filled) > filled).sum())
    seen[fill.__name__, kind.__name__] = left
    off = float(np.abs(filled - exact(heights)).max())
    print(fill.__name__, kind.__name__, f"{int((filled > heights).sum())} cells raised, {left} of them still in a pit; at most {off:.6f} m off")
few, more, none = seen.values()
sys.exit(0 if 1000 < few < more and none == 0 else "this has changed")
PYTHON
