"""Drawings cleaned, strategies compared, options listed."""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from . import _native
from ._drawing import Drawing


@dataclass(frozen=True)
class Fault:
    """A fault of a drawing: its kind, its place, a length or angle, and which vertices and segments it is about."""

    kind: str
    at: tuple[float, float]
    size: float
    vertices: list[int]
    segments: list[int]
    hole: int | None


class Cleaned(NamedTuple):
    """A drawing mended, how many changes were made, and the faults that are left."""

    drawing: Drawing
    changes: int
    left: list[Fault]


def faults(drawing: Drawing, *, tolerance: float | None = None) -> list[Fault]:
    """What is wrong with a drawing: crossings, overlaps, gaps, near duplicates, slivers, ...

    >>> import trimalla
    >>> bow_tie = trimalla.Drawing([[0, 0], [2, 2], [2, 0], [0, 2]], [[0, 1], [1, 2], [2, 3], [3, 0]])
    >>> [(fault.kind, fault.at) for fault in trimalla.faults(bow_tie)]
    [('crossing', (1.0, 1.0))]
    """
    return [Fault(**fault) for fault in _native.clean(drawing._given(), tolerance, False)[1]]


def clean(drawing: Drawing, *, tolerance: float | None = None) -> Cleaned:
    """Mends a drawing: merges vertices within the tolerance, splits segments where others meet or cross them.

    >>> import trimalla
    >>> bow_tie = trimalla.Drawing([[0, 0], [2, 2], [2, 0], [0, 2]], [[0, 1], [1, 2], [2, 3], [3, 0]])
    >>> mended = trimalla.clean(bow_tie)
    >>> len(mended.drawing.points), mended.left
    (5, [])
    """
    arrays, left, changes = _native.clean(drawing._given(), tolerance, True)
    mended = Drawing._of(arrays)
    mended.domain = drawing.domain
    return Cleaned(mended, changes, [Fault(**fault) for fault in left])


class Comparison:
    """Tables of a comparison: `data` as read from JSON, `markdown` as text; `print` shows the latter."""

    def __init__(self, data: dict[str, Any], markdown: str) -> None:
        self.data, self.markdown = data, markdown

    def _repr_markdown_(self) -> str:
        return self.markdown

    def __str__(self) -> str:
        return self.markdown


def compare(
    drawings: Drawing | dict[str, Drawing],
    presets: Sequence[str] = ("off-center", "circumcenter", "lepp-centroid"),
    *,
    angles: Sequence[float] = (20.0, 25.0, 30.0),
    jobs: int = 1,
    time_limit: float = 60.0,
) -> Comparison:
    """Compares strategies on drawings at some angles, each run bounded in time.

    >>> import trimalla
    >>> wedge = trimalla.Drawing([[0, 0], [9, 0], [9, 1], [0, 4]], [[0, 1], [1, 2], [2, 3], [3, 0]])
    >>> table = trimalla.compare({"wedge": wedge}, ["off-center", "lepp-centroid"], angles=[20, 30])
    >>> [recipe["recipe"] for recipe in table.data["inputs"][0]["recipes"]]
    ['off-center', 'lepp-centroid']
    """
    named = {"drawing": drawings} if isinstance(drawings, Drawing) else drawings
    given = [(title, drawing._given()) for title, drawing in named.items()]
    text, markdown = _native.compare(given, list(presets), [float(a) for a in angles], jobs, time_limit)
    return Comparison(json.loads(text), markdown)


def options() -> dict[str, str]:
    """The options of a refinement by name, and what each is for.

    >>> import trimalla
    >>> "protect" in trimalla.options()
    True
    """
    return {name: f"{summary} ({expected})" for name, expected, summary in _native.option_names()}


def recipe(path: str | os.PathLike[str] | None = None, **options: Any) -> str:
    """The text of a recipe file with these options, written to a file if there is a path; `mesh(recipe=path)` reads it.

    >>> import trimalla
    >>> "preset" in trimalla.recipe(preset="lepp-centroid", min_angle=33)
    True
    """
    return _native.recipe(None if path is None else os.fspath(path), options)
