#!/usr/bin/env bash
# Layers of a drawing that Inkscape keeps apart are one layer, and one pen, for the program that prepares drawings for plotters.
#
# Versions: vpype 1.15.0 from PyPI (NumPy 2.2.6 beside it), on an SVG with layers as Inkscape writes them: groups with
#           inkscape:groupmode="layer" and a label.
# Guess:    three layers are three layers, in order of appearance or numbered by their labels; a number in a label matters if the label
#           begins with it, as for the software of AxiDraw.
# Seen:     labels                                          layers that are read
#           coast, lakes, rivers                            1 coast, 2 lakes, 3 rivers
#           coast, lakes, rivers of order 2                 1 coast, 2 rivers of order 2: with the lakes in it, whose name is gone
#           map 2024: coast, map 2024: lakes                2024 map 2024: lakes, with the coast in it
#           3 coast, 4 lakes, 2 rivers of order 2           as they are labelled
#           Any digits anywhere in a label are the layer's number. Layers without take 1, 2, 3 by their place, also where another has
#           that number: lines of both are drawn with one pen, with no warning.
# So:       write a number of its own at the beginning of every label, or of none; and nothing of other digits before it.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
python3 -m venv venv
venv/bin/pip install --quiet --disable-pip-version-check --only-binary :all: vpype==1.15.0 numpy==2.2.6
cat > layers.py <<'PYTHON'
import io

import vpype

INKSCAPE = 'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'


def read(*labels):
    """The layers of a drawing with a line in each of some layers: their names and numbers of lines."""
    layers = (
        f'<g inkscape:groupmode="layer" inkscape:label="{label}"><path d="M10 {y}0H90" fill="none" stroke="#000"/></g>'
        for y, label in enumerate(labels, 1)
    )
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" {INKSCAPE} width="100mm" height="100mm" viewBox="0 0 100 100">{"".join(layers)}</svg>'
    document = vpype.read_multilayer_svg(io.StringIO(svg), quantization=0.1)
    return {number: (lines.property("vp_name"), len(lines)) for number, lines in sorted(document.layers.items())}


for labels, expected in (
    (("coast", "lakes", "rivers"), {1: ("coast", 1), 2: ("lakes", 1), 3: ("rivers", 1)}),
    (("coast", "lakes", "rivers of order 2"), {1: ("coast", 1), 2: ("rivers of order 2", 2)}),
    (("map 2024: coast", "map 2024: lakes"), {2024: ("map 2024: lakes", 2)}),
    (("3 coast", "4 lakes", "2 rivers of order 2"), {2: ("2 rivers of order 2", 1), 3: ("3 coast", 1), 4: ("4 lakes", 1)}),
):
    found = read(*labels)
    print(", ".join(labels), "->", found)
    assert found == expected, "this has changed"
PYTHON
venv/bin/python layers.py
