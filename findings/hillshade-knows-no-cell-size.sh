#!/usr/bin/env bash
# A hillshade does not depend on how large cells are, although the slope of the same package does.
#
# Version:  xarray-spatial 0.5.3 with xarray 2026.9.0; NumPy 2.2.6, Python 3.11.
# Input:    the same hills, 300 m high, with 10 m, 100 m and 1,000 m from cell to cell, as coordinates and as the attribute `res`.
# Guess:    the wider the cells, the gentler the slopes and the fainter the shade; `slope` gives that (47, 6 and 0.6 degrees at most), and so does
#           gdaldem.
# Seen:     three hillshades that are the same to the bit. The gradient is taken between cells, in metres a cell, as if every cell were a metre wide.
# So:       cells of two kilometres look like cliffs. Divide heights by the cell size, times the exaggeration that is wanted, before shading.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder"
"$folder/bin/pip" install --quiet --disable-pip-version-check --only-binary :all: numpy==2.2.6 xarray==2026.9.0 xarray-spatial==0.5.3
"$folder/bin/python" -W ignore - <<'PYTHON'
import sys

import numpy as np
import xarray
import xrspatial

rows, columns = np.mgrid[0:200, 0:200]
heights = 150 * (1 + np.sin(rows / 14) * np.cos(columns / 17))


def hills(cell):
    along = np.arange(200) * float(cell)
    coordinates = {"y": along[::-1], "x": along}
    return xarray.DataArray(heights, coords=coordinates, dims=("y", "x"), attrs={"res": (cell, cell)})


cells = (10, 100, 1000)
shades = [np.asarray(xrspatial.hillshade(hills(cell))) for cell in cells]
slopes = [float(np.nanmax(xrspatial.slope(hills(cell)))) for cell in cells]
is_same = all(np.array_equal(shades[0], shade, equal_nan=True) for shade in shades[1:])
print("greatest slopes:", *(f"{slope:.1f}" for slope in slopes), "degrees; the same hillshade:", is_same)
sys.exit(0 if is_same and slopes[0] > 5 * slopes[1] > 25 * slopes[2] else "this has changed")
PYTHON
