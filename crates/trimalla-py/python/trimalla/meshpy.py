"""`MeshInfo` and `build` with the names of `meshpy.triangle`.

>>> import trimalla.meshpy as triangle
>>> info = triangle.MeshInfo()
>>> info.set_points([(0, 0), (4, 0), (4, 4), (0, 4)])
>>> info.set_facets([(0, 1), (1, 2), (2, 3), (3, 0)])
>>> mesh = triangle.build(info, max_volume=0.5, min_angle=30)
>>> len(mesh.points) > 4 and len(mesh.elements[0]) == 3
True
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np

from . import _arrays, _native
from .triangle import _given, _result

__all__ = ["MeshInfo", "build", "refine", "subdivide_facets"]

#: How often a refinement function is asked about all triangles at most.
_ROUNDS = 64


class _Rows(list[Any]):
    """A list that can be resized, as the arrays of MeshPy."""

    def __init__(self, width: int, rows: Iterable[Any] = ()) -> None:
        super().__init__(rows)
        self.width = width

    def resize(self, count: int) -> None:
        """Makes the list so long, with rows of zeros."""
        del self[count:]
        self.extend([0.0] * self.width for _ in range(count - len(self)))


class MeshInfo:
    """What goes in, and what comes out.

    `points`, `point_markers`, `point_attributes`, `facets`, `facet_markers`, `holes`, `regions` (x, y, attribute,
    largest area), `elements`, `element_attributes`, `element_volumes`, `neighbors`, `faces`, `face_markers`.
    """

    def __init__(self) -> None:
        self.points: Any = []
        self.point_markers: Any = []
        self.point_attributes: Any = []
        self.facets: Any = []
        self.facet_markers: Any = []
        self.holes: Any = _Rows(2)
        self.regions: Any = _Rows(4)
        self.elements: Any = []
        self.element_attributes: Any = []
        self.element_volumes: Any = []
        self.neighbors: Any = []
        self.faces: Any = []
        self.face_markers: Any = []

    def set_points(self, points: Any, point_markers: Any = None) -> None:
        """Sets the points, and a marker for each."""
        self.points = points
        self.point_markers = [] if point_markers is None else point_markers

    def set_facets(self, facets: Any, facet_markers: Any = None) -> None:
        """Sets the segments, and a marker for each."""
        self.facets = facets
        self.facet_markers = [] if facet_markers is None else facet_markers

    def set_holes(self, holes: Any) -> None:
        """Sets a point in each hole."""
        self.holes = _Rows(2, holes)

    def copy(self) -> MeshInfo:
        """A copy."""
        other = MeshInfo()
        other.__dict__.update({key: list(rows) for key, rows in self.__dict__.items()})
        other.holes, other.regions = _Rows(2, self.holes), _Rows(4, self.regions)
        return other

    def _dictionary(self) -> dict[str, Any]:
        pairs = {
            "vertices": self.points,
            "vertex_markers": self.point_markers,
            "vertex_attributes": self.point_attributes,
            "segments": self.facets,
            "segment_markers": self.facet_markers,
            "holes": self.holes,
            "regions": self.regions,
            "triangles": self.elements,
            "triangle_attributes": self.element_attributes,
        }
        return {key: rows for key, rows in pairs.items() if len(rows)} | {"vertices": self.points}

    @classmethod
    def _of(cls, found: dict[str, Any], regions: Any) -> MeshInfo:
        info = cls()
        info.points, info.elements = found["vertices"], found["triangles"]
        info.point_markers = found.get("vertex_markers", np.empty((0, 1), dtype=np.int32))[:, 0]
        info.point_attributes = found.get("vertex_attributes", [])
        info.facets = found.get("segments", np.empty((0, 2), dtype=np.int32))
        info.facet_markers = found.get("segment_markers", np.empty((0, 1), dtype=np.int32))[:, 0]
        info.element_attributes = found.get("triangle_attributes", [])
        info.neighbors = found.get("neighbors", [])
        info.faces = found.get("edges", [])
        info.face_markers = found.get("edge_markers", np.empty((0, 1), dtype=np.int32))[:, 0]
        info.holes, info.regions = _Rows(2, found.get("holes", [])), _Rows(4, regions)
        return info


def build(
    mesh_info: MeshInfo,
    verbose: bool = False,
    refinement_func: Callable[[Any, float], bool] | None = None,
    attributes: bool = False,
    volume_constraints: bool = False,
    max_volume: float | None = None,
    allow_boundary_steiner: bool = True,
    allow_volume_steiner: bool = True,
    quality_meshing: bool = True,
    generate_edges: bool | None = None,
    generate_faces: bool = False,
    generate_neighbor_lists: bool = False,
    min_angle: float | None = None,
    mesh_order: int | None = None,
) -> MeshInfo:
    """Meshes what a `MeshInfo` has.

    `refinement_func(vertices, area)` says whether a triangle is to be smaller. It is called for all triangles of a
    mesh, and then for those of the mesh in which the named ones are at most half as large, until it names none or no
    triangle can be added.
    """
    switches = "pj" + ("A" if attributes else "") + ("a" if volume_constraints else "")
    switches += "e" if generate_faces or generate_edges else ""
    switches += "n" if generate_neighbor_lists else ""
    bounds = ""
    if quality_meshing:
        bounds += "q" if min_angle is None else f"q{float(min_angle):.17f}"
    if max_volume is not None:
        bounds += f"a{_decimal(max_volume)}"
    bounds += "" if allow_boundary_steiner else "Y"
    bounds += "" if allow_volume_steiner else "S0"
    if mesh_order not in (None, 1):
        switches += f"o{mesh_order}"
    if refinement_func is not None:
        return _until_fine(mesh_info, switches, bounds, refinement_func)
    return _build(mesh_info, switches + bounds)


def refine(input_mesh: MeshInfo, verbose: bool = False, **options: Any) -> MeshInfo:
    """Refines a mesh: `max_volume`, `min_angle`, `element_volumes` of the mesh."""
    bounds = f"q{float(options.get('min_angle') or 20.0):.17f}"
    if options.get("max_volume") is not None:
        bounds += f"a{_decimal(options['max_volume'])}"
    areas = input_mesh.element_volumes if len(input_mesh.element_volumes) else None
    return _build(input_mesh, "rp" + bounds + ("a" if areas is not None else ""), areas)


def subdivide_facets(
    subdivisions: int | Sequence[int], points: Any, facets: Any, facet_markers: Any = None
) -> tuple[list[Any], list[Any]] | tuple[list[Any], list[Any], list[Any]]:
    """Divides each segment into equal parts; new points follow the old ones.

    >>> subdivide_facets(2, [(0.0, 0.0), (2.0, 0.0)], [(0, 1)])
    ([(0.0, 0.0), (2.0, 0.0), (1.0, 0.0)], [(0, 2), (2, 1)])
    """
    points = list(points)
    new: list[Any] = []
    markers: list[Any] = []
    for i, (a, b) in enumerate(facets):
        parts = subdivisions if isinstance(subdivisions, int) else subdivisions[i]
        chain = [a]
        for k in range(1, parts):
            t = k / parts
            points.append(tuple((1 - t) * p + t * q for p, q in zip(points[a], points[b])))
            chain.append(len(points) - 1)
        chain.append(b)
        new.extend(zip(chain[:-1], chain[1:]))
        if facet_markers is not None:
            markers.extend([facet_markers[i]] * parts)
    return (points, new) if facet_markers is None else (points, new, markers)


def _decimal(area: float) -> str:
    """Digits with at most one point, as switches take them."""
    return np.format_float_positional(float(area), trim="-")


def _build(info: MeshInfo, switches: str, areas: Any = None) -> MeshInfo:
    given = info._dictionary()
    if areas is not None:
        given["triangle_max_area"] = areas
    arrays, bounds = _given(given)
    return MeshInfo._of(_result(given, _native.by_switches(arrays, bounds, switches)), info.regions)


def _until_fine(info: MeshInfo, switches: str, bounds: str, coarse: Callable[[Any, float], bool]) -> MeshInfo:
    mesh = _build(info, switches + bounds)
    for _ in range(_ROUNDS):
        corners = np.asarray(mesh.points)[np.asarray(mesh.elements)[:, :3]]
        u, v = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        areas = 0.5 * (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
        is_coarse = np.array([bool(coarse(list(map(tuple, t)), a)) for t, a in zip(corners.tolist(), areas.tolist())])
        before = len(mesh.elements)
        if not is_coarse.any():
            return mesh
        own = switches.replace("A", "").replace("a", "").replace("j", "")
        mesh = _build(mesh, "r" + own + bounds + "a", np.where(is_coarse, areas / 2, 0.0))
        if len(mesh.elements) == before:
            return mesh
    raise _arrays.fail(_native.OptionError, "refinement_func still asks for smaller triangles", "option")
