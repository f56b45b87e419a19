#!/usr/bin/env bash
# What a mask paints black stays visible: the converter takes a mask by opacity, not by brightness.
#
# Version:  CairoSVG 2.9.1 with cairocffi 1.7.1, beside resvg (resvg-py 0.5.0); Pillow 12.0.0, Python 3.11.
# Input:    a blue strip under a mask with a white square, a black square and nothing.
# Guess:    as SVG 1.1 and CSS Masking say: blue under the white, nothing under the black, nothing under nothing. resvg gives that, and so do
#           browsers.
# Seen:     blue under the black square, too. Black that is opaque masks as white does; only what the mask leaves out is hidden.
# So:       a mask of white with black holes, as drawing programs write them, hides nothing, and nothing is said. What has to be right in this
#           converter leaves its holes empty, or is rendered by another one.
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

SIZE = 'width="60" height="20"'
STRIP = f"""<svg xmlns="http://www.w3.org/2000/svg" {SIZE}>
<mask id="holes" maskUnits="userSpaceOnUse" x="0" y="0" {SIZE}>
<rect width="20" height="20" fill="white"/><rect x="20" width="20" height="20" fill="black"/></mask>
<rect {SIZE} fill="white"/><rect {SIZE} fill="blue" mask="url(#holes)"/></svg>"""


def is_blue(png):
    picture = Image.open(io.BytesIO(png)).convert("RGB")
    return [picture.getpixel((x, 10)) == (0, 0, 255) for x in (10, 30, 50)]


cairo = is_blue(cairosvg.svg2png(bytestring=STRIP.encode()))
resvg = is_blue(bytes(resvg_py.svg_to_bytes(svg_string=STRIP)))
print("blue under white, black, nothing: CairoSVG", cairo, "resvg", resvg)
sys.exit(0 if cairo == [True, True, False] and resvg == [True, False, False] else "this has changed")
PYTHON
