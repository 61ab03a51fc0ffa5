"""Meshes: arrays, and what is done with them."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _arrays, _native
from ._drawing import Drawing

if TYPE_CHECKING:
    from ._size import Size

#: Meshes with more triangles are shown in notebooks as PNG, not as SVG.
MOST_IN_SVG = 20_000


@dataclass(frozen=True, eq=False)
class Report:
    """What came of a refinement.

    `complete` says whether all triangles meet the bounds, but for those where the input forbids it. The others are
    listed in `leftover_triangles` with `leftover_angles` in degrees and `leftover_reasons`. `stop` is `finished`,
    `budget`, `cancelled` or `no-longer-improves`.
    """

    complete: bool
    stop: str
    min_angle: float
    max_angle: float
    vertices: int
    triangles: int
    steiner_points: int
    edges_flipped: int
    points_inserted: int
    points_rejected: int
    segments_split: int
    lost_segments: list[int]
    leftover_triangles: npt.NDArray[np.int32]
    leftover_angles: npt.NDArray[np.float64]
    leftover_reasons: list[str]

    def __repr__(self) -> str:
        state = "complete" if self.complete else f"{len(self.leftover_triangles)} triangles left, stop: {self.stop}"
        return f"<Report: {self.triangles} triangles, {self.min_angle:.2f} to {self.max_angle:.2f} degrees, {state}>"


class Mesh:
    """A triangle mesh as plain arrays, which are read-only.

    Attributes
    ----------
    points: float64 (n, 2); the input points first, bit for bit
    triangles: int32 (t, 3), counter-clockwise
    segments: int32 (s, 2): the pieces of input segments, and the boundary
    segment_markers: int32 (s); point_markers (or `markers`): int32 (n)
    point_attributes: float64 (n, k); triangle_attributes: float64 (t, k)
    holes: float64 (h, 2); input_points: how many points are those of the input
    report: a `Report`, or None where nothing was refined; warnings: what is unusual in the input

    >>> import trimalla
    >>> mesh = trimalla.polygon([[(0, 0), (4, 0), (4, 3), (0, 3)]], min_angle=30)
    >>> mesh.triangles.shape, float(mesh.areas.sum())
    ((2, 3), 12.0)
    """

    __slots__ = ("_arrays", "_derived", "report", "warnings")

    _KEYS = (
        "points", "point_markers", "point_attributes", "triangles", "triangle_attributes", "segments",
        "segment_markers", "holes", "input_points",
    )  # fmt: skip

    def __init__(
        self,
        points: Any,
        triangles: Any,
        segments: Any = None,
        *,
        point_markers: Any = None,
        segment_markers: Any = None,
        point_attributes: Any = None,
        triangle_attributes: Any = None,
        holes: Any = None,
        input_points: int | None = None,
    ) -> None:
        points = np.array(_arrays.points(points))
        corners = _arrays.indices(triangles, "triangles", 3)
        ends = _arrays.indices(segments, "segments", 2)
        for what, rows in (("triangles", corners), ("segments", ends)):
            wrong = np.flatnonzero(((rows < 0) | (rows >= len(points))).any(axis=1))
            if wrong.size:
                row = int(wrong[0])
                message = f"row {row} of {what} names a point that is not there: there are {len(points)} points"
                error = _arrays.fail(_native.MeshError, message, "no-such-vertex")
                error.indices = [row]
                raise error
        rows_of: dict[str, Any] = {
            "points": points,
            "triangles": corners.astype(np.int32),
            "segments": ends.astype(np.int32),
            "point_markers": np.array(_arrays.markers(point_markers, "point_markers")),
            "segment_markers": np.array(_arrays.markers(segment_markers, "segment_markers")),
            "point_attributes": _table(point_attributes, len(points), "point_attributes"),
            "triangle_attributes": _table(triangle_attributes, len(corners), "triangle_attributes"),
            "holes": np.array(_arrays.points(holes, "holes")),
            "input_points": len(points) if input_points is None else int(input_points),
        }
        for key in ("point_markers", "segment_markers"):
            count = len(points) if key == "point_markers" else len(ends)
            if len(rows_of[key]) not in (0, count):
                raise _arrays.fail(_native.MeshError, f"{key} must have {count} entries, not {len(rows_of[key])}")
        self._set(rows_of, None, [])

    def _set(self, arrays: dict[str, Any], report: Report | None, warnings: list[str]) -> None:
        self._arrays = {key: arrays[key] for key in self._KEYS}
        for key, array in self._arrays.items():
            if key != "input_points":
                _arrays.frozen(array)
        self._derived: dict[str, Any] = {}
        self.report, self.warnings = report, warnings

    @classmethod
    def _of(cls, made: tuple[dict[str, Any], dict[str, Any] | None, list[str]]) -> Mesh:
        arrays, report, warnings = made
        mesh = cls.__new__(cls)
        mesh._set(arrays, None if report is None else Report(**report), warnings)
        return mesh

    def _given(self) -> dict[str, Any]:
        arrays = dict(self._arrays)
        for key in ("triangles", "segments"):
            arrays[key] = arrays[key].astype(np.int64)
        return arrays

    def _once(self, key: str, make: Callable[[], Any]) -> Any:
        if key not in self._derived:
            self._derived[key] = _arrays.frozen(make())
        return self._derived[key]

    points: npt.NDArray[np.float64] = property(lambda self: self._arrays["points"])  # type: ignore[assignment]
    triangles: npt.NDArray[np.int32] = property(lambda self: self._arrays["triangles"])  # type: ignore[assignment]
    segments: npt.NDArray[np.int32] = property(lambda self: self._arrays["segments"])  # type: ignore[assignment]
    holes: npt.NDArray[np.float64] = property(lambda self: self._arrays["holes"])  # type: ignore[assignment]
    input_points: int = property(lambda self: self._arrays["input_points"])  # type: ignore[assignment]
    point_attributes: npt.NDArray[np.float64] = property(  # type: ignore[assignment]
        lambda self: self._arrays["point_attributes"]
    )
    triangle_attributes: npt.NDArray[np.float64] = property(  # type: ignore[assignment]
        lambda self: self._arrays["triangle_attributes"]
    )

    @property
    def point_markers(self) -> npt.NDArray[np.int32]:
        """A marker for each point: int32 (n)."""
        return self._column("point_markers", len(self.points))

    markers = point_markers

    @property
    def segment_markers(self) -> npt.NDArray[np.int32]:
        """A marker for each segment: int32 (s)."""
        return self._column("segment_markers", len(self.segments))

    def _column(self, key: str, rows: int) -> Any:
        column = self._arrays[key]
        return column if len(column) == rows else self._once(key, lambda: np.zeros(rows, dtype=np.int32))

    @property
    def edges(self) -> npt.NDArray[np.int32]:
        """Each edge once, the lower index first, sorted: int32 (e, 2)."""
        return self._once("edges", lambda: _native.edges(self._given()))

    @property
    def boundary(self) -> npt.NDArray[np.int32]:
        """The edges of one triangle only, with it on the left: int32 (b, 2)."""
        return self._once("boundary", lambda: _native.boundary(self._given()))

    @property
    def neighbours(self) -> npt.NDArray[np.int32]:
        """The triangle opposite each corner, -1 for none: int32 (t, 3)."""
        return self._once("neighbours", lambda: _native.neighbours(self._given()))

    neighbors = neighbours

    @property
    def regions(self) -> npt.NDArray[np.float64]:
        """The attribute of the region of each triangle, 0 where there are no regions: float64 (t)."""
        attributes = self.triangle_attributes
        if attributes.shape[1]:
            return attributes[:, 0]
        return self._once("regions", lambda: np.zeros(len(self.triangles)))

    @property
    def areas(self) -> npt.NDArray[np.float64]:
        """The area of each triangle: float64 (t)."""

        def areas() -> npt.NDArray[np.float64]:
            a, b, c = (self.points[self.triangles[:, k]] for k in range(3))
            u, v = b - a, c - a
            return 0.5 * (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])

        return self._once("areas", areas)

    @property
    def angles(self) -> npt.NDArray[np.float64]:
        """The angle at each corner, in degrees: float64 (t, 3)."""

        def angles() -> npt.NDArray[np.float64]:
            corners = self.points[self.triangles]
            u = np.roll(corners, -1, axis=1) - corners
            v = np.roll(corners, 1, axis=1) - corners
            cross = u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]
            return np.degrees(np.arctan2(np.abs(cross), (u * v).sum(axis=-1)))

        return self._once("angles", angles)

    def drawing(self) -> Drawing:
        """The points, segments and holes as a drawing."""
        return Drawing(self.points, self.segments, self.holes, None, self.point_markers, self.segment_markers)

    def check(self, *, delaunay: bool = False) -> list[str]:
        """What is wrong with the mesh, in words; with `delaunay`, also edges that are neither Delaunay nor segments.

        >>> import trimalla
        >>> trimalla.Mesh([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]]).check()
        []
        """
        return _native.check(self._given(), delaunay)

    def refine(self, *, areas: Any = None, drawing: Drawing | None = None, **options: Any) -> Mesh:
        """A finer mesh: see `trimalla.refine`."""
        from ._make import refine

        return refine(self, areas=areas, drawing=drawing, **options)

    def locate(self, points: Any) -> npt.NDArray[np.int32]:
        """The triangle in which each point lies, -1 outside: int32 (k).

        >>> import trimalla
        >>> trimalla.Mesh([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]]).locate([[0.2, 0.2], [5, 5]]).tolist()
        [0, -1]
        """
        return self._locator().locate(_arrays.points(points))

    def interpolate(self, values: Any, points: Any) -> npt.NDArray[np.float64]:
        """Values at points from values at the vertices, linear in each triangle; NaN outside."""
        return self._locator().interpolate(_arrays.numbers(values, "values"), _arrays.points(points))

    def _locator(self) -> _native.Locator:
        if "locator" not in self._derived:
            self._derived["locator"] = _native.Locator(self._given())
        return self._derived["locator"]

    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes the mesh; the ending of the name says in which format (.vtu, .msh, .ele, .poly, .svg, .png, ...)."""
        _native.write(os.fspath(path), self._given())

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Mesh:
        """Reads a mesh: .ele with .node, .vtu, .msh, .off, .ply and others."""
        return cls._of((_native.read_mesh(os.fspath(path)), None, []))

    def svg(self, title: str = "") -> str:
        """A picture of the mesh as SVG."""
        return _native.picture(self._given(), "svg", title).decode()

    def png(self, title: str = "") -> bytes:
        """A picture of the mesh as PNG."""
        return _native.picture(self._given(), "png", title)

    def _repr_svg_(self) -> str | None:
        return self.svg() if len(self.triangles) <= MOST_IN_SVG else None

    def _repr_png_(self) -> bytes | None:
        return self.png() if len(self.triangles) > MOST_IN_SVG else None

    def plot(self, ax: Any = None, *, values: Any = None, **style: Any) -> Any:
        """Draws the mesh with matplotlib, coloured by values at vertices or triangles if there are any; the axes."""
        import matplotlib.pyplot as plt

        ax = plt.gca() if ax is None else ax
        if values is None:
            ax.triplot(self.to_matplotlib(), **{"linewidth": 0.5, "color": "0.3", **style})
        else:
            values = np.asarray(values)
            colours = ax.tripcolor(self.to_matplotlib(), values, **style)
            ax.figure.colorbar(colours, ax=ax)
        ends = self.points[self.segments]
        ax.plot(*_with_gaps(ends), color="k", linewidth=1.0)
        ax.set_aspect("equal")
        return ax

    def to_matplotlib(self) -> Any:
        """A `matplotlib.tri.Triangulation`."""
        from matplotlib.tri import Triangulation

        return Triangulation(self.points[:, 0], self.points[:, 1], self.triangles)

    def to_meshio(self) -> Any:
        """A `meshio.Mesh` with triangles and lines, markers and regions."""
        import meshio

        cells = [("triangle", self.triangles)]
        data: dict[str, list[Any]] = {
            "region": [self.regions],
            "marker": [np.zeros(len(self.triangles), dtype=np.int32)],
        }
        if len(self.segments):
            cells.append(("line", self.segments))
            data["region"].append(np.zeros(len(self.segments)))
            data["marker"].append(self.segment_markers)
        return meshio.Mesh(self.points, cells, {"marker": self.point_markers}, data)

    @classmethod
    def from_meshio(cls, mesh: Any) -> Mesh:
        """The triangles and lines of a `meshio.Mesh`; a third coordinate is left out."""
        triangles = [block.data for block in mesh.cells if block.type == "triangle"]
        lines = [block.data for block in mesh.cells if block.type == "line"]
        return cls(
            np.asarray(mesh.points)[:, :2],
            np.vstack(triangles) if triangles else None,
            np.vstack(lines) if lines else None,
        )

    def to_pyvista(self) -> Any:
        """A `pyvista.UnstructuredGrid` in the plane z = 0."""
        import pyvista

        count = len(self.triangles)
        cells = np.column_stack([np.full(count, 3), self.triangles]).ravel()
        points = np.column_stack([self.points, np.zeros(len(self.points))])
        grid = pyvista.UnstructuredGrid(cells, np.full(count, pyvista.CellType.TRIANGLE), points)
        grid.cell_data["region"] = np.array(self.regions)
        grid.point_data["marker"] = np.array(self.point_markers)
        return grid

    def to_networkx(self, *, dual: bool = False) -> Any:
        """A `networkx.Graph` of vertices and edges; with `dual`, of triangles and shared edges."""
        import networkx

        graph = networkx.Graph()
        if dual:
            centres = self.points[self.triangles].mean(axis=1)
            graph.add_nodes_from((i, {"pos": tuple(p)}) for i, p in enumerate(centres.tolist()))
            rows, columns = np.nonzero(self.neighbours > np.arange(len(self.triangles))[:, np.newaxis])
            graph.add_edges_from(zip(rows.tolist(), self.neighbours[rows, columns].tolist()))
        else:
            graph.add_nodes_from((i, {"pos": tuple(p)}) for i, p in enumerate(self.points.tolist()))
            lengths = np.linalg.norm(np.diff(self.points[self.edges], axis=1)[:, 0], axis=1)
            graph.add_weighted_edges_from(zip(*self.edges.T.tolist(), lengths.tolist()), weight="length")
        return graph

    def __reduce__(self) -> Any:
        state = {key: np.array(a) if key != "input_points" else a for key, a in self._arrays.items()}
        return _restored, (state, self.report, self.warnings)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Mesh):
            return NotImplemented
        return all(np.array_equal(self._arrays[key], other._arrays[key]) for key in self._KEYS)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"<Mesh: {len(self.points)} points, {len(self.triangles)} triangles>"


def _table(values: Any, rows: int, what: str) -> npt.NDArray[np.float64]:
    table = _arrays.attributes(values, rows, what)
    return np.empty((rows, 0)) if table is None else np.array(table)


def _restored(arrays: dict[str, Any], report: Report | None, warnings: list[str]) -> Mesh:
    mesh = Mesh.__new__(Mesh)
    mesh._set(arrays, report, warnings)
    return mesh


def _with_gaps(ends: npt.NDArray[np.float64]) -> tuple[Any, Any]:
    rows = np.full((len(ends), 3, 2), np.nan)
    rows[:, :2] = ends
    return rows[..., 0].ravel(), rows[..., 1].ravel()
