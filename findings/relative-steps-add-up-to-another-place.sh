#!/usr/bin/env bash
# A path of many short relative steps ends elsewhere than the same path with absolute places: each step is rounded.
#
# Version:  CairoSVG 2.9.1 with cairocffi 1.7.1, beside resvg (resvg-py 0.5.0); Pillow 12.0.0, Python 3.11.
# Input:    a line of 10,000 steps to the east, each 0.1 long and 0.001 down, once by relative commands, once by absolute ones.
# Guess:    both end 10 units down. Relative commands are the usual way to make a path short, all optimizers write them, and a sum of
#           numbers of three places is exact enough in floating point.
# Seen:     the relative one ends where it began, 10 units too high. Cairo keeps places in 1/256 of a pixel, and a relative step is rounded
#           to that before it is added, so what is lost adds up. resvg draws the same line for both.
# So:       a long coast or contour of relative steps drifts, by half a pixel in ours. One absolute place now and then ends the drift; so does
#           drawing at a larger scale.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder"
"$folder/bin/pip" install --quiet --disable-pip-version-check --only-binary :all: cairosvg==2.9.1 cairocffi==1.7.1 resvg-py==0.5.0 pillow==12.0.0
"$folder/bin/python" - <<'PYTHON'
import io
import sys

import cairosvg
import resvg_py
from PIL import Image

STEPS = 10_000
RELATIVE = "M0 10l" + " ".join(["0.1 0.001"] * STEPS)
ABSOLUTE = "M0 10L" + " ".join(f"{i / 10} {10 + i / 1000}" for i in range(1, STEPS + 1))


def picture(path):
    return f"""<svg xmlns="http://www.w3.org/2000/svg" width="1000" height="40"><rect width="1000" height="40" fill="white"/>
<path d="{path}" fill="none" stroke="black" stroke-width="2"/></svg>"""


def end(png):
    """The middle of the ink near the right border."""
    column = Image.open(io.BytesIO(png)).convert("L").crop((997, 0, 998, 40))
    ink = [255 - value for value in column.tobytes()]
    return round(sum(y * value for y, value in enumerate(ink)) / sum(ink), 1)


cairo, resvg = (
    [end(draw(picture(path))) for path in (RELATIVE, ABSOLUTE)]
    for draw in (
        lambda svg: cairosvg.svg2png(bytestring=svg.encode()),
        lambda svg: bytes(resvg_py.svg_to_bytes(svg_string=svg)),
    )
)
print("ends by relative and by absolute commands: CairoSVG", cairo, "resvg", resvg)
sys.exit(0 if cairo == [9.5, 19.5] and resvg == [19.5, 19.5] else "this has changed")
PYTHON
