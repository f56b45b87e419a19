"""A map in numbers."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Summary:
    """A map in numbers."""

    ticks: int
    """How many ticks the tree grew, tick 0 not counted."""
    nodes: int
    """How many nodes the trimmed tree has."""
    mouths: int
    """How many rivers reach the sea."""
    sources: int
    """How many sources there are, and so rivers."""
    order: int
    """The highest of Strahler's orders."""
    attractors: int
    """How many attractors were scattered, or parcels of drainage; 0 for a Brownian tree."""
    unreached: int
    """Attractors that no river came near, or parcels with no way to a river mouth."""
    complete: bool
    """False if the tree met its node limit."""
    rounds: int
    """How many rounds the rivers meandered."""
    oxbows: int
    """How many lakes they left."""
    shortfall: str | None
    """Why much of the land is dry: ``"no-river"`` if no land lies open to the sea, ``"unreached"`` if rivers came near
    too few attractors, ``"cut-off"`` if parcels have no way to a mouth; None if it is not."""
