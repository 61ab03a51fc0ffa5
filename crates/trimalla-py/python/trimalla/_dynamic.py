"""A triangulation that changes, and a refinement step by step."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _arrays, _native
from ._drawing import Drawing
from ._mesh import Mesh, Report


class Triangulation:
    """A (constrained) Delaunay triangulation of points, of which every change can be taken back.

    Vertices keep their numbers; new ones get the next. Memory grows with the changes, which can all be taken back.

    >>> import trimalla
    >>> t = trimalla.Triangulation([[0, 0], [4, 0], [4, 4], [0, 4]])
    >>> t.insert([1, 2]), t.neighbours(4)
    (4, [3, 0, 1, 2])
    >>> t.nearest([[0.9, 1.9], [5, 5]]).tolist()
    [4, 2]
    >>> t.undo(), len(t.triangles)
    (True, 2)
    """

    def __init__(self, points: Any = None, segments: Any = None, *, crossings: str = "refuse") -> None:
        ends = _arrays.indices(segments, "segments", 2)
        self._t = _native.Triangulation(_arrays.points(points), ends, crossings)

    def insert(self, points: Any) -> Any:
        """Inserts a point or rows of points; the number of its vertex, or an array of them.

        A point on a vertex is that vertex. All points are inserted, or none.
        """
        array = _arrays.numbers(points, "points")
        if array.ndim == 1 and array.size == 2:
            return int(self._t.insert(array.reshape(1, 2))[0])
        return self._t.insert(_arrays.points(array))

    def remove(self, vertex: int, *, with_segments: bool = False) -> None:
        """Removes a vertex; one at which segments end only with them."""
        self._t.remove(vertex, with_segments)

    def move(self, vertex: int, to: Any) -> int:
        """Moves a vertex with its segments; the vertex that is at the place then."""
        x, y = _arrays.numbers(to, "the place").reshape(-1)
        return self._t.move_to(vertex, float(x), float(y))[0]

    def insert_segment(self, a: int, b: int, *, crossings: str = "refuse") -> int:
        """Joins two vertices by a segment; its number."""
        return self._t.insert_segment(a, b, crossings)

    def remove_segment(self, segment: int) -> bool:
        """Removes a segment; whether it was there."""
        return self._t.remove_segment(segment)

    def undo(self) -> bool:
        """Takes back the last change; whether there was one."""
        return self._t.undo()

    @property
    def changes(self) -> int:
        """How many changes can be taken back."""
        return self._t.changes

    def locate(self, points: Any) -> npt.NDArray[np.int32]:
        """The corners of the triangle in which each point lies, -1 three times outside: int32 (k, 3)."""
        return self._t.locate(_arrays.points(points))

    def nearest(self, points: Any) -> npt.NDArray[np.int32]:
        """The vertex nearest to each point: int32 (k)."""
        return self._t.nearest(_arrays.points(points))

    def neighbours(self, vertex: int) -> list[int]:
        """The vertices joined to a vertex by edges, counter-clockwise."""
        return self._t.neighbours(vertex)

    neighbors = neighbours

    def interpolate(self, values: Any, points: Any, *, method: str = "linear") -> npt.NDArray[np.float64]:
        """Values at points from one value for each vertex; NaN outside.

        `linear` in each triangle, `natural-neighbour` (Sibson) or `laplace`; the last two pass over segments.
        """
        return self._t.interpolate(_arrays.numbers(values, "values").reshape(-1), _arrays.points(points), method)

    @property
    def points(self) -> npt.NDArray[np.float64]:
        """All vertices, removed ones too: float64 (n, 2)."""
        return self._t.points

    @property
    def used(self) -> npt.NDArray[np.bool_]:
        """Which vertices are part of the triangulation: bool (n)."""
        return self._t.used

    @property
    def triangles(self) -> npt.NDArray[np.int32]:
        """The triangles: int32 (t, 3), counter-clockwise."""
        return self._t.triangles

    @property
    def edges(self) -> npt.NDArray[np.int32]:
        """The edges, the lower number first, sorted: int32 (e, 2)."""
        return self._t.edges

    def mesh(self) -> Mesh:
        """The triangulation as a mesh, without removed vertices."""
        return Mesh._of((self._t.mesh(), None, []))

    def check(self) -> list[str]:
        """What is wrong with the triangulation, in words."""
        return self._t.check()

    def __repr__(self) -> str:
        return f"<Triangulation: {int(self.used.sum())} vertices, {len(self.triangles)} triangles>"


class Refinement:
    """A refinement step by step, and back.

    The arguments are those of `mesh`, sizes other than `max_area` and regions excepted.

    >>> import trimalla
    >>> r = trimalla.Refinement([[0, 0], [9, 0], [9, 1], [0, 4]], [[0, 1], [1, 2], [2, 3], [3, 0]], min_angle=30)
    >>> before = r.mesh()
    >>> steps = r.run()
    >>> r.report.complete
    True
    >>> while r.back(): pass
    >>> r.mesh() == before
    True
    """

    def __init__(
        self, points: Any, segments: Any = None, holes: Any = None, regions: Any = None,
        *, history_bytes: int = 256 << 20, **options: Any,
    ) -> None:  # fmt: skip
        drawing = points if isinstance(points, Drawing) else Drawing(points, segments, holes, regions)
        if drawing.domain:
            options.setdefault("domain", drawing.domain)
        self._r = _native.Refinement(drawing._given(), options, history_bytes)

    def step(self) -> str:
        """Makes one step; what it did: `Triangle`, `SubsegmentSplit`, `Filled`, ..., `Finished`."""
        return self._r.step()

    def run(self, most: int = 2**63) -> int:
        """Makes steps until none is left, at most so many; how many were made."""
        return self._r.run(most)

    def back(self) -> bool:
        """Takes back the last step; whether there was one that is recorded."""
        return self._r.back()

    @property
    def steps(self) -> int:
        """How many steps were made."""
        return self._r.step_number

    @property
    def warnings(self) -> list[str]:
        """What is unusual in the input."""
        return self._r.warnings

    @property
    def min_angle(self) -> float | None:
        """The smallest angle now, in degrees."""
        return self._r.overview[2]

    def mesh(self) -> Mesh:
        """The mesh now."""
        return Mesh._of((self._r.mesh(), None, self.warnings))

    @property
    def report(self) -> Report:
        """The report, as if the refinement ended here."""
        return Report(**self._r.finish()[1])

    def finish(self) -> Mesh:
        """The mesh and its report, as if the refinement ended here."""
        arrays, report = self._r.finish()
        return Mesh._of((arrays, report, self.warnings))

    def __repr__(self) -> str:
        vertices, triangles, angle = self._r.overview
        return f"<Refinement: {vertices} vertices, {triangles} triangles, smallest angle {angle}>"
