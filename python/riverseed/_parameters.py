"""The parameter table."""

from collections.abc import Mapping
from dataclasses import dataclass

from riverseed import _native
from riverseed._options import keyword


@dataclass(frozen=True)
class Parameter:
    """What a parameter does, and which values it takes."""

    name: str
    """Its name in links; as a keyword it has underscores for dashes."""
    label: str
    """Its name on the page."""
    help: str
    """What it does."""
    group: str
    """The heading under which the page has it."""
    unit: str
    """The unit of its numbers; empty for plain numbers."""
    kind: str
    """The kind of its values: ``"integer"``, ``"number"``, ``"choice"``, ``"text"``, ``"sides"`` for some of the
    letters n, e, s and w, or ``"outline"`` for a drawn land as text."""
    default: str | int | float
    """The value when none is given."""
    minimum: int | float | None = None
    """The least of its numbers; None if it has none."""
    maximum: int | float | None = None
    """The greatest of its numbers; None if it has none."""
    longest: int | None = None
    """How many characters its text may have; None if it is no text."""
    choices: Mapping[str, str] | None = None
    """The words to choose from, with what each stands for; None if it is no choice."""


def parameters() -> dict[str, Parameter]:
    """Return the parameter table: what each parameter does and which values it takes, by its name as a keyword.

    >>> import riverseed
    >>> curl = riverseed.parameters()["curl"]
    >>> curl.minimum, curl.maximum, curl.default
    (0.0, 2.0, 0.7)
    >>> list(riverseed.parameters()["growth"].choices)
    ['drainage', 'colonize', 'brownian']
    """
    return {keyword(fields["name"]): Parameter(**fields) for fields in _native.parameters()}
