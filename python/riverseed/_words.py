"""A map in words: what a prompt shows, and a notebook under its picture."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable

    from riverseed._arrays import Rivers
    from riverseed._summary import Summary


def describe(link: str, title: str | None, summary: Summary, rivers: Rivers, kilometres: Callable[[float], str]) -> str:
    """Return the call that grows a map and, as its comment, the map in one sentence."""
    said = f"{_shown(title)}: " if title else ""
    return f"riverseed.grow({link!r})  # {said}{_rivers(summary, rivers, kilometres)}"


def _rivers(summary: Summary, rivers: Rivers, kilometres: Callable[[float], str]) -> str:
    if not len(rivers):
        return "no rivers"
    lengths = rivers.lengths
    longest = int(lengths.argmax())
    name = rivers.name[longest]
    count = "1 river" if len(rivers) == 1 else f"{len(rivers)} rivers"
    which = f"the longest, {_shown(name)}," if name else "the longest"
    return f"{count}, {summary.mouths} of which reach the sea; {which} runs {kilometres(lengths[longest])} km"


def _shown(text: str | None) -> str:
    """Return a name without what has no shape of its own, such as a mark that turns the rest of a line around."""
    return "".join(letter for letter in text or "" if letter.isprintable())
