"""The functions of the `triangle` package: change the import line to `import trimalla.triangle as triangle`.

Dictionaries have the same keys and shapes. What differs: input at fault raises an exception that names the place,
where `triangle` returns nonsense, hangs or ends the process; numbers of triangles are a little lower; the order of
triangles and of new vertices is another one. The result has the keys `report` and `warnings` only where asked for by
`trimalla.mesh`.

>>> import trimalla.triangle as triangle
>>> square = {"vertices": [[0, 0], [1, 0], [1, 1], [0, 1]]}
>>> sorted(triangle.triangulate(square, "qa0.1"))
['triangles', 'vertex_markers', 'vertices']
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _arrays, _native
from ._drawing import read as _read
from ._drawing import regions_of

__all__ = ["compare", "convex_hull", "delaunay", "get_data", "load", "loads", "plot", "triangulate", "voronoi"]

_KEYS = frozenset(
    [
        "vertices", "vertex_attributes", "vertex_markers", "triangles", "triangle_max_area", "triangle_attributes",
        "segments", "segment_markers", "holes", "regions", "neighbors", "edges", "edge_markers",
    ]
)  # fmt: skip


def triangulate(tri: Mapping[str, Any], opts: str = "") -> dict[str, Any]:
    """Triangulates or meshes a dictionary as the switches say.

    `tri` has `vertices` and, where the switches ask for it, `segments`, `holes`, `regions`, `triangles`, markers,
    attributes, `triangle_max_area`. Indices count from 0. The switches are those of `trimalla triangle`, whose page
    says what each does.

    >>> box = {"vertices": [[0, 0], [2, 0], [2, 1], [0, 1]], "segments": [[0, 1], [1, 2], [2, 3], [3, 0]]}
    >>> mesh = triangulate(box, "pq30a0.1e")
    >>> mesh["vertex_markers"].shape[1], mesh["edges"].shape[1]
    (1, 2)
    """
    unknown = [key for key in tri if key not in _KEYS]
    if unknown:
        raise KeyError(unknown[0])
    if "vertices" not in tri:
        raise KeyError("vertices")
    given, areas = _given(tri)
    made = _native.by_switches(given, areas, opts)
    return _result(tri, made)


def _given(tri: Mapping[str, Any]) -> tuple[dict[str, Any], npt.NDArray[np.float64]]:
    points = _arrays.points(tri["vertices"], "vertices")
    corners = tri.get("triangles")
    if corners is not None and np.ndim(corners) == 2 and np.shape(corners)[1] == 6:
        corners = np.asarray(corners)[:, :3]
    triangles = _arrays.indices(corners, "triangles", 3)
    given = {
        "points": points,
        "point_markers": _arrays.markers(tri.get("vertex_markers"), "vertex_markers"),
        "point_attributes": _arrays.attributes(tri.get("vertex_attributes"), len(points), "vertex_attributes"),
        "segments": _arrays.indices(tri.get("segments"), "segments", 2),
        "segment_markers": _arrays.markers(tri.get("segment_markers"), "segment_markers"),
        "holes": _arrays.points(tri.get("holes"), "holes"),
        "regions": regions_of(tri.get("regions")),
        "triangles": triangles,
        "triangle_attributes": _arrays.attributes(
            tri.get("triangle_attributes"), len(triangles), "triangle_attributes"
        ),
    }
    areas = tri.get("triangle_max_area")
    return given, np.empty(0) if areas is None else _arrays.numbers(areas, "triangle_max_area").reshape(-1)


def _result(tri: Mapping[str, Any], made: dict[str, Any]) -> dict[str, Any]:
    result: dict[str, Any] = {}
    if made["has_vertices"]:
        result["vertices"] = made["points"]
        if made["point_attributes"].shape[1]:
            result["vertex_attributes"] = made["point_attributes"]
        if len(made["point_markers"]) == len(made["points"]):
            result["vertex_markers"] = made["point_markers"].reshape(-1, 1)
    if made["has_triangles"]:
        result["triangles"] = np.hstack([made["triangles"], made["middles"]]) if len(made["middles"]) else made["triangles"]
        # `triangle` has them only where the input has regions or attributes of triangles.
        has_regions = any(np.size(tri.get(key, ())) for key in ("regions", "triangle_attributes"))
        if made["triangle_attributes"].shape[1] and has_regions:
            result["triangle_attributes"] = made["triangle_attributes"]
    if made["has_segments"]:
        result["segments"] = made["segments"]
        if len(made["segment_markers"]) == len(made["segments"]):
            result["segment_markers"] = made["segment_markers"].reshape(-1, 1)
    if "edges" in made:
        result["edges"] = made["edges"]
        if len(made["edge_markers"]):
            result["edge_markers"] = made["edge_markers"].reshape(-1, 1)
    if "neighbors" in made:
        result["neighbors"] = made["neighbors"]
    for key in ("holes", "regions"):
        if key in tri and made["drawing"] and np.size(tri[key]):
            result[key] = _arrays.numbers(tri[key], key)
    return result


def delaunay(pts: Any) -> npt.NDArray[np.int32]:
    """The Delaunay triangulation of points: int32 (t, 3).

    >>> len(delaunay([[0, 0], [2, 0], [1, 1], [0, 2], [2, 2]]))
    4
    """
    return triangulate({"vertices": pts})["triangles"]


def convex_hull(pts: Any) -> npt.NDArray[np.int32]:
    """The edges of the convex hull: int32 (h, 2).

    >>> len(convex_hull([[0, 0], [2, 0], [1, 1], [0, 2], [2, 2]]))
    4
    """
    return triangulate({"vertices": pts}, "c")["segments"]


def voronoi(pts: Any) -> tuple[Any, Any, Any, Any]:
    """The Voronoi diagram: vertices, edges between them, and rays: the vertices where they begin, their directions.

    >>> vertices, edges, origins, directions = voronoi([[0, 0], [2, 0], [1, 1], [0, 2], [2, 2]])
    >>> vertices.shape, len(edges), len(origins), directions.shape
    ((4, 2), 4, 4, (4, 2))
    """
    given, areas = _given({"vertices": pts})
    made = _native.by_switches(given, areas, "v")
    return made["voronoi_vertices"], made["voronoi_edges"], made["ray_origins"], made["ray_directions"]


def load(directory: str | os.PathLike[str], name: str) -> dict[str, Any]:
    """Reads `name.poly`, or `name.node` with `name.ele`, from a directory."""
    path = os.path.join(os.fspath(directory), name)
    for ending in (".poly", ".node"):
        if os.path.exists(path + ending):
            return _dictionary(path, path + ending)
    raise FileNotFoundError(f"{path}.poly, {path}.node")


def loads(poly: str) -> dict[str, Any]:
    """Reads the text of a .poly file."""
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "text")
        with open(path + ".poly", "w", encoding="utf-8") as file:
            file.write(poly)
        return _dictionary(path, path + ".poly")


def _dictionary(path: str, file: str) -> dict[str, Any]:
    drawing = _read(file)
    found: dict[str, Any] = {"vertices": drawing.points}
    if drawing.point_attributes is not None:
        found["vertex_attributes"] = drawing.point_attributes
    if len(drawing.point_markers):
        found["vertex_markers"] = drawing.point_markers.reshape(-1, 1)
    for key in ("segments", "holes", "regions"):
        if len(getattr(drawing, key)):
            found[key] = getattr(drawing, key)
    if len(drawing.segments) and len(drawing.segment_markers):
        found["segment_markers"] = drawing.segment_markers.reshape(-1, 1)
    if os.path.exists(path + ".ele"):
        mesh = _native.read_mesh(path + ".ele")
        found["triangles"] = mesh["triangles"]
        if mesh["triangle_attributes"].shape[1]:
            found["triangle_attributes"] = mesh["triangle_attributes"]
    return found


def get_data(name: str) -> dict[str, Any]:
    """A drawing by name, drawn for this package: `box`, `plate`, `star`.

    >>> len(get_data("plate")["holes"])
    2
    """
    if name not in _DATA:
        raise KeyError(f"{name}; there are {', '.join(sorted(_DATA))}")
    return {key: np.array(rows) for key, rows in _DATA[name].items()}


def _ring(first: int, count: int) -> list[list[int]]:
    return [[first + i, first + (i + 1) % count] for i in range(count)]


def _circle(x: float, y: float, radius: float, count: int) -> list[list[float]]:
    turn = 2 * np.pi * np.arange(count) / count
    return np.column_stack([x + radius * np.cos(turn), y + radius * np.sin(turn)]).tolist()


_BOX = [[0.0, 0.0], [8.0, 0.0], [8.0, 4.0], [0.0, 4.0]]
_DATA: dict[str, dict[str, Any]] = {
    "box": {"vertices": _BOX, "segments": _ring(0, 4)},
    "plate": {
        "vertices": _BOX + _circle(2.0, 2.0, 1.0, 16) + _circle(6.0, 2.0, 1.0, 16),
        "segments": _ring(0, 4) + _ring(4, 16) + _ring(20, 16),
        "holes": [[2.0, 2.0], [6.0, 2.0]],
    },
    "star": {
        "vertices": [p for i in range(5) for p in (_circle(0, 0, 2, 5)[i], _circle(0, 0, 0.9, 10)[2 * i + 1])],
        "segments": _ring(0, 10),
    },
}


def plot(ax: Any, **kw: Any) -> None:
    """Draws what a dictionary has: `plot(ax, **tri)`."""
    vertices = np.asarray(kw["vertices"], dtype=float)
    ax.set_aspect("equal")
    if "triangles" in kw:
        ax.triplot(vertices[:, 0], vertices[:, 1], np.asarray(kw["triangles"])[:, :3], color="0.6", linewidth=0.7)
    if "edges" in kw and "triangles" not in kw:
        for a, b in vertices[np.asarray(kw["edges"])]:
            ax.plot([a[0], b[0]], [a[1], b[1]], color="0.6", linewidth=0.7)
    if "segments" in kw:
        for a, b in vertices[np.asarray(kw["segments"])]:
            ax.plot([a[0], b[0]], [a[1], b[1]], color="C3", linewidth=1.5)
    if "holes" in kw:
        ax.plot(*np.asarray(kw["holes"], dtype=float)[:, :2].T, "kx")
    if "regions" in kw:
        ax.plot(*np.asarray(kw["regions"], dtype=float)[:, :2].T, "C0+")
    ax.plot(*vertices.T, "k.", markersize=3)


def compare(plt: Any, A: Mapping[str, Any], B: Mapping[str, Any], figsize: tuple[float, float] = (6, 3)) -> None:
    """Draws two dictionaries side by side."""
    figure = plt.figure(figsize=figsize)
    first = figure.add_subplot(121)
    plot(first, **A)
    second = figure.add_subplot(122, sharex=first, sharey=first)
    plot(second, **B)
    figure.tight_layout()
