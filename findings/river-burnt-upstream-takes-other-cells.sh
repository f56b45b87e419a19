#!/usr/bin/env bash
# A line that is burnt into a raster takes other cells the other way round, and some cells that it does not touch.
#
# Versions: rasterio 1.4.4, which carries GDAL 3.10.3, NumPy 2.2.6, Python 3.11. `gdal_rasterize` and QGIS burn by the same function.
# Input:    1,000 straight lines between places with decimals on 24 by 24 cells, each burnt by default, in both directions, and with
#           all_touched=True.
# Guess:    the default burns some of the cells that a line passes, which leave no gap (that is true), and the same ones in either direction.
# Seen:     300 of 1,000 lines take other cells when they are drawn the other way: 600 of 11,368 cells. And 762 cells, of 365 lines, are not
#           touched by their line at all; one is 0.43 of a cell away. The ends are rounded to whole cells first, and a line is drawn between those,
#           with an error that is rounded in its direction. With all_touched=True both ways give the same cells.
# So:       a river that one survey drew downstream and another upstream is not the same raster, and a difference of the two finds a strip of
#           cells; heights that are sampled where a river was burnt are partly those of its banks. Rivers are burnt with all_touched=True (-at).
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder"
"$folder/bin/pip" install --quiet --disable-pip-version-check numpy==2.2.6 rasterio==1.4.4
cat > "$folder/burn.py" <<'PYTHON'
import numpy as np
import rasterio
from rasterio.features import rasterize


def burnt(line, **how):
    return rasterize([({"type": "LineString", "coordinates": line}, 1)], out_shape=(24, 24), **how).astype(bool)


def away(line, cell):
    """The distance of a cell from a line, in sides of a cell."""
    (x, y), (to_x, to_y) = line
    row, column = cell
    along = np.linspace(0, 1, 400)
    across, down = x + (to_x - x) * along, y + (to_y - y) * along
    aside = np.maximum(np.maximum(column - across, across - column - 1), 0)
    above = np.maximum(np.maximum(row - down, down - row - 1), 0)
    return np.hypot(aside, above).min()


places = [((3 * i * i + 7 * i) % 211 / 211 * 22 + 1, (5 * i * i + 11 * i) % 199 / 199 * 22 + 1) for i in range(2000)]
cells = lines_by_way = cells_by_way = lines_beside = cells_beside = touched_by_way = 0
farthest = 0.0
for line in (places[i : i + 2] for i in range(0, 2000, 2)):
    there, back = burnt(line), burnt(line[::-1])
    touched = burnt(line, all_touched=True)
    cells += there.sum()
    cells_by_way += (there & ~back).sum()
    lines_by_way += (there != back).any()
    beside = there & ~touched
    cells_beside += beside.sum()
    lines_beside += beside.any()
    farthest = max([farthest, *(away(line, cell) for cell in np.argwhere(beside))])
    touched_by_way += (touched != burnt(line[::-1], all_touched=True)).sum()
print(f"rasterio {rasterio.__version__}, GDAL {rasterio.__gdal_version__}: {cells} cells of 1000 lines")
print(f"{lines_by_way} lines take other cells the other way round: {cells_by_way} cells; with all_touched=True {touched_by_way}")
print(f"{lines_beside} lines take cells that they do not touch: {cells_beside} cells, up to {farthest:.2f} of a cell away")
seen = [int(count) for count in (cells, lines_by_way, cells_by_way, lines_beside, cells_beside, touched_by_way)]
if seen != [11368, 300, 600, 365, 762, 0] or round(float(farthest), 2) != 0.43:
    raise SystemExit("this has changed")
PYTHON
"$folder/bin/python" "$folder/burn.py"
