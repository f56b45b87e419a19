"""What a call may be given, as the text that a link would have."""

import operator
from collections.abc import Mapping
from typing import TypeVar

import numpy as np

T = TypeVar("T")


def keyword(name: str) -> str:
    """Return the name of a parameter as Python spells it."""
    return name.replace("-", "_")


def by_keyword(values: Mapping[str, T]) -> dict[str, T]:
    """Return values of parameters by their names in Python."""
    return {keyword(name): value for name, value in values.items()}


def texts(parameters: Mapping[str, object]) -> list[tuple[str, str]]:
    """Return names and values as links spell them."""
    return [(name.replace("_", "-"), _text(name, value)) for name, value in parameters.items()]


def _text(name: str, value: object) -> str:
    if isinstance(value, str):
        return value
    if isinstance(value, (int, np.integer)) and not isinstance(value, bool):
        return _digits(name, int(value))
    if isinstance(value, (float, np.floating)):
        # Plain digits, as links have them: 0.00001, not 1e-05.
        return np.format_float_positional(value, trim="-")
    message = f"{name}: a text or a number is wanted, not {type(value).__name__}"
    raise TypeError(message)


def _digits(name: str, value: int) -> str:
    try:
        return str(value)
    except ValueError:  # thousands of digits
        message = f"{name}: the number has too many digits"
        raise ValueError(message) from None


def pixels(name: str, value: object, most: int) -> int | None:
    """Return a number of pixels, from 1 to `most`, or None if none is given."""
    if value is None:
        return None
    try:
        number = operator.index(value)  # type: ignore[arg-type]
    except TypeError:
        message = f"{name}: a whole number is wanted, not {type(value).__name__}"
        raise TypeError(message) from None
    if not 1 <= number <= most:
        message = f"{name}: {_digits(name, number)} is not between 1 and {most}"
        raise ValueError(message)
    return number
