"""Meshing: drawings and meshes in, meshes out."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _arrays, _native, _size
from ._bar import bar
from ._drawing import Drawing
from ._mesh import Mesh
from ._size import Size

Progress = bool | Callable[[int, int], object] | None


def mesh(
    points: Any,
    segments: Any = None,
    holes: Any = None,
    regions: Any = None,
    *,
    min_angle: float | None = None,
    size: Size | None = None,
    max_area: float | None = None,
    triangles: int | None = None,
    growth: float | None = None,
    sources: Any = None,
    gradation: float | None = None,
    domain: str | None = None,
    crossings: str | None = None,
    point_markers: Any = None,
    segment_markers: Any = None,
    point_attributes: Any = None,
    progress: Progress = None,
    **options: Any,
) -> Mesh:
    """Meshes a drawing.

    Parameters
    ----------
    points: (n, 2) numbers, or a `Drawing`
    segments: (m, 2) indices of points
    holes: (h, 2) points; what they reach without crossing a segment is removed
    regions: (r, 4): x, y, attribute, largest area of a triangle there (0 for none)
    min_angle: the smallest angle in degrees, 30 where nothing is said
    size: the length of edges: a number, one for each input point, a function `size(x, y)` of arrays, a `Raster` or
        an `xarray.DataArray`. It is that of an equilateral triangle with the largest area that is allowed. A function
        is called before the work, in batches, on a grid that is finer where its values change.
    max_area: the largest area of a triangle
    triangles: about how many triangles there are to be; the other sizes are scaled
    growth: the largest factor between an edge and the next one, away from small features
    sources: (k, 3): x, y, length; or (k, 5): x1, y1, x2, y2, length; lengths grow with the distance by `gradation`
    domain: `seeds`: what segments enclose, less the holes (as Triangle does); `nesting`: what lies behind an odd number
        of segments; `hull`: the convex hull. Without segments, the hull
    crossings: `refuse` or `split`
    progress: `True` for a line on standard error, or a function `(vertices, waiting)`, called about every 20 ms; where
        it returns `False`, the mesh so far is returned
    options: those of `trimalla.options()`: `preset`, `protect`, `max_vertices`, `recipe` (a file), the five steps

    Returns
    -------
    Mesh: input points first, in order, bit for bit; every input segment a chain of edges; the same input gives the same
    bytes.

    Raises
    ------
    DrawingError, OptionError: with `kind`, `indices` and `points` that say where.

    >>> import trimalla
    >>> square = [[0, 0], [4, 0], [4, 4], [0, 4]]
    >>> mesh = trimalla.mesh(square, [[0, 1], [1, 2], [2, 3], [3, 0]], min_angle=30, size=lambda x, y: 0.2 + 0.2 * x)
    >>> mesh.report.complete
    True
    >>> trimalla.mesh(square, [[0, 2], [1, 3]])
    Traceback (most recent call last):
    ...
    trimalla.DrawingError: 1 pair of segments cross: segments 0 and 1 cross near (2, 2)
    """
    if isinstance(points, Drawing):
        drawing = points
        domain = domain or drawing.domain
    else:
        drawing = Drawing(points, segments, holes, regions, point_markers, segment_markers, point_attributes)
    if size is None and sources is None and triangles is None and growth is None:
        sizes: dict[str, Any] = {}
    else:
        sizes = _size.native(drawing.points, size, sources, gradation, growth, triangles)
    chosen = {"min_angle": min_angle, "max_area": max_area, "domain": domain, "crossings": crossings, **options}
    return Mesh._of(_native.mesh(drawing._given(), chosen, sizes, bar(progress)))


def polygon(rings: Any, **options: Any) -> Mesh:
    """Meshes polygons: rings of points, or anything with `__geo_interface__`, such as a shapely polygon.

    What lies inside an odd number of rings is meshed, so holes and islands need no seeds. Rings may run either way, and
    may repeat their first point. Options are those of `mesh`.

    >>> import trimalla
    >>> outer, hole = [(0, 0), (4, 0), (4, 4), (0, 4)], [(1, 1), (3, 1), (3, 3), (1, 3)]
    >>> round(float(trimalla.polygon([outer, hole], size=1).areas.sum()), 9)
    12.0
    """
    return mesh(rings_of(rings), **{"domain": "nesting", **options})


def rings_of(rings: Any) -> Drawing:
    """A drawing of rings."""
    if hasattr(rings, "__geo_interface__"):
        rings = _geo_rings(rings.__geo_interface__)
    elif isinstance(rings, np.ndarray) and rings.ndim == 2:
        rings = [rings]
    try:
        rings = list(rings)
    except TypeError as error:
        raise _arrays.fail(_native.DrawingError, f"rings must be a list of rings of points: {error}") from error
    tables, ends, first = [], [], 0
    for ring in rings:
        if len(np.shape(ring)) == 1 and len(ring) == 2 and len(rings) > 2:
            return rings_of([rings])  # One ring of plain points.
        table = _arrays.points(ring, "a ring")
        if len(table) > 1 and (table[0] == table[-1]).all():
            table = table[:-1]
        index = np.arange(first, first + len(table))
        tables.append(table)
        ends.append(np.column_stack([index, np.roll(index, -1)]))
        first += len(table)
    if not tables:
        raise _arrays.fail(_native.DrawingError, "there is no ring")
    return Drawing(np.vstack(tables), np.vstack(ends), domain="nesting")


def _geo_rings(geometry: dict[str, Any]) -> list[Any]:
    kind = geometry.get("type")
    if kind == "Polygon":
        return [np.asarray(ring, dtype=float)[:, :2] for ring in geometry["coordinates"]]
    if kind == "MultiPolygon":
        return [np.asarray(ring, dtype=float)[:, :2] for polygon in geometry["coordinates"] for ring in polygon]
    if kind == "Feature":
        return _geo_rings(geometry["geometry"])
    if kind in ("FeatureCollection", "GeometryCollection"):
        parts: Iterable[Any] = geometry.get("features") or geometry.get("geometries") or ()
        return [ring for part in parts for ring in _geo_rings(part)]
    raise _arrays.fail(_native.DrawingError, f"expected polygons, found {kind}", "geometry")


def triangulate(
    points: Any,
    segments: Any = None,
    holes: Any = None,
    regions: Any = None,
    *,
    method: str = "incremental",
    domain: str | None = None,
    crossings: str | None = None,
    point_markers: Any = None,
    segment_markers: Any = None,
    point_attributes: Any = None,
) -> Mesh:
    """The constrained Delaunay triangulation of a drawing's domain: no point is added but where segments cross.

    Other methods: `conforming-delaunay`, `ears`, `min-weight`, ... as `trimalla list` of the program names them.

    >>> import trimalla
    >>> trimalla.triangulate([[0, 0], [1, 0], [1, 1], [0, 1]]).triangles.tolist()
    [[3, 1, 2], [3, 0, 1]]
    """
    if isinstance(points, Drawing):
        drawing, domain = points, domain or points.domain
    else:
        drawing = Drawing(points, segments, holes, regions, point_markers, segment_markers, point_attributes)
    return Mesh._of(_native.triangulate(drawing._given(), method, {"domain": domain, "crossings": crossings}))


def delaunay(points: Any) -> npt.NDArray[np.int32]:
    """The Delaunay triangulation of points: int32 (t, 3), counter-clockwise.

    Of equal points the first is used. Of four points on a circle the diagonal is the same whatever their order.

    >>> import trimalla
    >>> len(trimalla.delaunay([[0, 0], [2, 0], [1, 1], [0, 2], [2, 2]]))
    4
    """
    return _native.delaunay(_arrays.points(points))


def refine(
    mesh: Mesh,
    *,
    drawing: Drawing | None = None,
    areas: Any = None,
    min_angle: float | None = None,
    size: Size | None = None,
    max_area: float | None = None,
    triangles: int | None = None,
    growth: float | None = None,
    sources: Any = None,
    gradation: float | None = None,
    progress: Progress = None,
    **options: Any,
) -> Mesh:
    """Refines a mesh; its vertices stay, at their indices.

    `areas` has the largest area of each triangle, 0 or NaN for none. With the drawing from which the mesh was made,
    segments are split from their ends. The other options are those of `mesh`.

    >>> import numpy as np, trimalla
    >>> coarse = trimalla.polygon([[(0, 0), (4, 0), (4, 3), (0, 3)]])
    >>> fine = trimalla.refine(coarse, areas=coarse.areas / 8)
    >>> len(fine.triangles) > 16 and bool((fine.points[:4] == coarse.points).all())
    True
    """
    bounds = np.empty(0) if areas is None else np.nan_to_num(_arrays.numbers(areas, "areas").reshape(-1))
    sizes = _size.native(mesh.points, size, sources, gradation, growth, triangles)
    chosen = {"min_angle": min_angle, "max_area": max_area, **options}
    given = None if drawing is None else drawing._given()
    return Mesh._of(_native.refine(mesh._given(), given, bounds, chosen, sizes, bar(progress)))
