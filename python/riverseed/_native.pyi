from typing import Any

__all__ = ["network", "parameters", "relief", "render"]

def render(
    link: str,
    parameters: list[tuple[str, str]],
    form: str,
    size: int | None,
    ratio: float | None,
    raster_size: int | None,
) -> bytes: ...
def network(link: str, parameters: list[tuple[str, str]]) -> dict[str, Any]: ...
def relief(link: str, parameters: list[tuple[str, str]], raster_size: int | None) -> dict[str, Any]: ...
def parameters() -> list[tuple[str, str]]: ...
