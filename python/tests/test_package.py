"""The package is whole: what it says of itself, and what it hands on."""

import inspect
import re
import subprocess
from importlib.metadata import distribution
from importlib.resources import files
from pathlib import Path

import pytest

import riverseed

README = Path(__file__).parents[1] / "README.md"


def test_the_version_is_that_of_the_program(program: Path) -> None:
    said = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
    assert said.split()[-1] == riverseed.__version__


def test_licences_and_notices_are_handed_on() -> None:
    held = {
        Path(str(path)).name: path.read_text()
        for path in distribution("riverseed").files or []
        if "licenses" in path.parts
    }
    for name in ("LICENSE-APACHE", "LICENSE-MIT", "OFL.txt", "THIRD-PARTY.txt"):
        assert held[name] == (README.parent / name).read_text()
    for crate in ("pyo3", "numpy", "ndarray", "tiny-skia"):
        assert re.search(rf"^  {crate} \d", held["THIRD-PARTY.txt"], re.MULTILINE), crate


def test_the_package_says_that_it_is_typed() -> None:
    assert files("riverseed").joinpath("py.typed").is_file()


def test_no_option_has_the_name_of_a_parameter() -> None:
    for function in (riverseed.render, riverseed.network, riverseed.relief):
        assert not set(inspect.signature(function).parameters) & set(riverseed.parameters())


def test_everything_public_is_explained() -> None:
    for name in riverseed.__all__:
        thing = getattr(riverseed, name)
        assert thing is riverseed.Form or inspect.getdoc(thing), name


def test_examples_of_the_readme_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    examples = re.findall(r"^```python\n(.*?)^```", README.read_text(), re.MULTILINE | re.DOTALL)
    assert len(examples) >= 4
    monkeypatch.chdir(tmp_path)
    known: dict[str, object] = {}
    for example in examples:
        exec(compile(example, str(README), "exec"), known)
    assert any(tmp_path.iterdir()), "no example has written its file"
