#!/usr/bin/env bash
# Flow directions "based on steepest gradient" lead to the lowest neighbour, diagonal or not, and so across the slope.
#
# Versions: pyflwdir 0.5.12; for comparison pysheds 0.5; NumPy 2.2.6, Python 3.11.
# Input:    a plane of 60 by 60 cells that falls 10 m a cell to the east and 3 m to the south, without a pit or a flat.
# Guess:    every cell drains east: 10 m a cell against 13 m over a diagonal, which is 9.2 m a cell. The documentation of `from_dem` says that
#           directions are by steepest gradient; pysheds' `flowdir` gives them.
# Seen:     all 3,364 inner cells drain south-east. Cells are taken from a queue, the lowest first (Wang & Liu 2006), and each neighbour that is not
#           taken yet is led to the one that was, whatever the distance.
# So:       on hills with 70,000 cells 57 % of the directions were those of the steepest way or of a river, where pysheds has 92 %. Give pyflwdir
#           directions that another program has made, with `from_array`.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder"
"$folder/bin/pip" install --quiet --disable-pip-version-check --only-binary :all: numpy==2.2.6 pysheds==0.5 pyflwdir==0.5.12
"$folder/bin/python" -W ignore - <<'PYTHON'
import sys

import numpy as np
import pyflwdir
from affine import Affine
from pysheds.grid import Grid
from pysheds.view import Raster, ViewFinder

EAST, SOUTH_EAST = 1, 2
CODES = (64, 128, 1, 2, 4, 8, 16, 32)
rows, columns = np.mgrid[0:60, 0:60]
plane = 1000.0 - 10 * columns - 3 * rows


def by_pyflwdir(outlets):
    return pyflwdir.from_dem(plane.astype(np.float32), nodata=-9999.0, outlets=outlets).to_array("d8")


def by_pysheds():
    view = ViewFinder(affine=Affine(1, 0, 0, 0, -1, 0), shape=plane.shape, nodata=np.float64(-9999))
    return np.asarray(Grid(viewfinder=view).flowdir(Raster(plane, view), dirmap=CODES))


def counted(directions):
    codes, counts = np.unique(directions[1:-1, 1:-1], return_counts=True)
    return {int(code): int(count) for code, count in zip(codes, counts)}


seen = [counted(directions) for directions in (by_pyflwdir("edge"), by_pyflwdir("min"), by_pysheds())]
print("pyflwdir, outlets at the edge and at the lowest cell, and pysheds:", *seen)
sys.exit(0 if seen == [{SOUTH_EAST: 3364}, {SOUTH_EAST: 3364}, {EAST: 3364}] else "this has changed")
PYTHON
