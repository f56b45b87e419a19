"""vpype, which prepares drawings for plotters, reads the lines of a map: a layer for each pen, in millimetres, on the sheet.

    python3 tests/plot.py target/debug/riverseed

Needs vpype (`make test-plot` gets it). It prints what it has read, and fails if a promise is broken.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path
from xml.etree import ElementTree

import vpype

INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}"
SVG = "{http://www.w3.org/2000/svg}"
# CSS pixels to a millimetre: vpype's own unit.
PIXELS = 96 / 25.4
MARGIN = 10
# As coarse as numbers in the file.
NEAR = 0.01

# Links, sheets and their sides.
CALLS = (
    ("seed=kauri&land=island", "a4", (297, 210)),
    ("seed=kea&land=archipelago&growth=colonize", "a3", (420, 297)),
    ("seed=matai&land=valley&aspect=0.5", "letter", (215.9, 279.4)),
    ("seed=totara&land=rectangle&meander-rounds=200&oxbows=1", "a5", (210, 148)),
)


def lengths(root):
    """The length of the lines of each layer of a file, in millimetres, by the number that its label begins with."""
    found = {}
    for layer in root.findall(f"{SVG}g[@{INKSCAPE}groupmode='layer']"):
        number = int(layer.get(f"{INKSCAPE}label").split()[0])
        for path in layer.findall(f"{SVG}path"):
            for part in re.findall(r"M([^Mz]*)(z?)", path.get("d")):
                points = [complex(*map(float, pair.split())) for pair in part[0].split("L")]
                points += points[:1] if part[1] else []
                found[number] = found.get(number, 0) + sum(abs(b - a) for a, b in zip(points, points[1:]))
    return found


def check(program, link, sheet, sides):
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "map.plot.svg"
        subprocess.run([program, "render", link, "-o", str(file), "--sheet", sheet], check=True)
        root = ElementTree.parse(file).getroot()
        document = vpype.read_multilayer_svg(str(file), quantization=0.1)
    page = [side / PIXELS for side in document.page_size]
    assert all(abs(found - side) < NEAR for found, side in zip(page, sides)), f"{link}: a page of {page} mm"
    west, north, east, south = (side / PIXELS for side in document.bounds())
    inside = min(west, north, page[0] - east, page[1] - south)
    assert inside > MARGIN - NEAR, f"{link}: lines come as near as {inside} mm to the edge"
    written = lengths(root)
    orders = max(int(layer.get("id").split("-")[1]) for layer in root if layer.get("id", "").startswith("order-"))
    assert set(document.layers) == set(written), f"{link}: layers {sorted(document.layers)}, not {sorted(written)}"
    for number, lines in document.layers.items():
        name = lines.property(vpype.METADATA_FIELD_NAME)
        expected = f"{number} rivers of order {number}" if number <= orders else name
        assert name == expected, f"{link}: layer {number} is {name}"
        read = lines.length() / PIXELS
        assert abs(read - written[number]) < 1e-3 * written[number], f"{link}: {read} mm of {written[number]}"
    print(f"{sheet}, {link}: {len(document.layers)} layers, {document.length() / PIXELS / 1000:.1f} m of lines")


for call in CALLS:
    check(sys.argv[1], *call)
