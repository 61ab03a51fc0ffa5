"""Drawings: points, segments between them, seeds of holes and of regions."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _arrays, _native


@dataclass(eq=False)
class Drawing:
    """A planar straight-line graph.

    Attributes
    ----------
    points: float64 (n, 2)
    segments: int (m, 2), indices of points
    holes: float64 (h, 2); what they reach without crossing a segment is removed
    regions: float64 (r, 4): x, y, attribute, largest area of a triangle (0 for none)
    point_markers, segment_markers: int32, empty or one each
    point_attributes: float64 (n, k) or None

    Lists and other types of numbers are converted.

    >>> import trimalla
    >>> square = trimalla.Drawing([[0, 0], [2, 0], [2, 2], [0, 2]], [[0, 1], [1, 2], [2, 3], [3, 0]])
    >>> trimalla.mesh(square, size=0.5).report.complete
    True
    """

    points: Any
    segments: Any = None
    holes: Any = None
    regions: Any = None
    point_markers: Any = None
    segment_markers: Any = None
    point_attributes: Any = None
    domain: str | None = field(default=None)

    def __post_init__(self) -> None:
        self.points = _arrays.points(self.points)
        self.segments = _arrays.indices(self.segments, "segments", 2)
        self.holes = _arrays.points(self.holes, "holes")
        self.regions = regions_of(self.regions)
        self.point_markers = _arrays.markers(self.point_markers, "point_markers")
        self.segment_markers = _arrays.markers(self.segment_markers, "segment_markers")
        self.point_attributes = _arrays.attributes(self.point_attributes, len(self.points), "point_attributes")

    def _given(self) -> dict[str, Any]:
        keys = ("points", "segments", "holes", "regions", "point_markers", "segment_markers", "point_attributes")
        return {key: getattr(self, key) for key in keys}

    @classmethod
    def _of(cls, arrays: dict[str, Any]) -> Drawing:
        if arrays["point_attributes"].shape[1] == 0:
            arrays["point_attributes"] = None
        return cls(**arrays)

    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes the drawing; the ending of the name says in which format."""
        _native.write_drawing(os.fspath(path), self._given())

    def __repr__(self) -> str:
        return f"<Drawing: {len(self.points)} points, {len(self.segments)} segments>"


def regions_of(values: Any) -> npt.NDArray[np.float64]:
    """Rows of x, y, attribute and largest area; the last one or two may be missing."""
    if values is None or np.size(values) == 0:
        return np.empty((0, 4))
    array = _arrays.numbers(values, "regions")
    if array.ndim != 2 or not 2 <= array.shape[1] <= 4:
        message = f"regions must have shape (n, 4): x, y, attribute, largest area; not {array.shape}"
        raise _arrays.fail(_native.DrawingError, message)
    full = np.zeros((len(array), 4))
    full[:, : array.shape[1]] = array
    return full


def read(path: str | os.PathLike[str]) -> Drawing:
    """Reads a drawing: .poly, .node, GeoJSON, DXF, SVG, WKT, shapefile, CSV and others, by the ending of the name."""
    return Drawing._of(_native.read_drawing(os.fspath(path)))
