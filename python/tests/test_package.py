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


def test_everything_public_is_explained() -> None:
    for name in riverseed.__all__:
        thing = getattr(riverseed, name)
        assert isinstance(thing, tuple) or inspect.getdoc(thing), name
    for name, member in vars(riverseed.Map).items():
        assert name.startswith("_") or inspect.getdoc(member), name


def test_parameters_are_those_of_the_manual() -> None:
    manual = (README.parents[1] / "docs" / "parameters.md").read_text()
    table = riverseed.parameters()
    assert len(table) > 50
    for keyword, parameter in table.items():
        assert keyword == parameter.name.replace("-", "_")
        assert parameter.help in manual, keyword
        assert f"`{parameter.name}`" in manual, keyword


def test_defaults_are_those_of_recipes() -> None:
    recipe = riverseed.grow("country=usual&attractors=100").recipe
    defaults = {keyword: parameter.default for keyword, parameter in riverseed.parameters().items()}
    assert {**recipe, "attractors": 20000, "country": "auto"} == defaults


@pytest.mark.parametrize("keyword", riverseed.parameters())
def test_ranges_and_choices_are_those_that_are_kept(keyword: str) -> None:
    parameter = riverseed.parameters()[keyword]
    has_range, has_length = parameter.kind in ("integer", "number"), parameter.kind in ("text", "outline")
    assert (parameter.minimum is not None, parameter.maximum is not None) == (has_range, has_range)
    assert (parameter.longest is not None, parameter.choices is not None) == (has_length, parameter.kind == "choice")
    if parameter.maximum is not None and keyword != "edition":
        allowed = f"is not between {parameter.minimum} and {parameter.maximum}".replace(".0 ", " ").removesuffix(".0")
        with pytest.raises(ValueError, match=re.escape(allowed)):
            riverseed.grow(**{keyword: parameter.maximum + 1})
    if parameter.choices is not None:
        with pytest.raises(ValueError, match=re.escape(f"'none such' is not one of {', '.join(parameter.choices)}")):
            riverseed.grow(**{keyword: "none such"})
    if parameter.longest is not None:
        with pytest.raises(ValueError, match=f"at most {parameter.longest} are allowed"):
            riverseed.grow(**{keyword: "x" * (parameter.longest + 1)})


def test_examples_of_the_readme_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    examples = re.findall(r"^```python\n(.*?)^```", README.read_text(), re.MULTILINE | re.DOTALL)
    assert len(examples) >= 4
    monkeypatch.chdir(tmp_path)
    known: dict[str, object] = {}
    for example in examples:
        exec(compile(example, str(README), "exec"), known)
    assert any(tmp_path.iterdir()), "no example has written its file"


@pytest.mark.parametrize("guide", ["python.md", "scientists.md"])
def test_programs_of_the_guides_run(guide: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = (README.parents[1] / "docs" / "for" / guide).read_text()
    programs = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    assert programs
    monkeypatch.chdir(tmp_path)
    known: dict[str, object] = {}
    for program in programs:
        # A hundred networks take half a minute.
        exec(compile(program.replace("range(100)", "range(3)"), guide, "exec"), known)
