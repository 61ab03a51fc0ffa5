"""Drawings from shapely and geopandas; each module is imported only where it is needed."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _arrays
from ._drawing import Drawing
from ._native import DrawingError


def from_shapely(geometry: Any, *, max_areas: Any = None) -> Drawing:
    """A drawing of shapely geometries: one, or a list of them.

    Each polygon is a region, whose attribute is its number in the list, from 1 on; `max_areas` has the largest area of
    a triangle in each. Polygons may share edges. What no polygon covers is no part of the domain. Lines are kept as
    segments, points as vertices. A third coordinate is left out.

    >>> import shapely, trimalla
    >>> plate = shapely.box(0, 0, 4, 4) - shapely.box(1, 1, 2, 2)
    >>> round(float(trimalla.mesh(trimalla.from_shapely(plate), max_area=0.5).areas.sum()), 9)
    15.0
    """
    import shapely

    rows = list(geometry) if isinstance(geometry, (list, tuple, np.ndarray)) else [geometry]
    lines: list[Any] = []
    points: list[Any] = []
    seeds: list[tuple[float, float, float, float]] = []
    polygons: list[Any] = []
    areas = np.zeros(len(rows)) if max_areas is None else _arrays.numbers(max_areas, "max_areas").reshape(-1)
    if len(areas) != len(rows):
        raise _arrays.fail(DrawingError, f"max_areas must have {len(rows)} entries, not {len(areas)}")
    for number, row in enumerate(rows):
        if row is None or row.is_empty:
            continue
        for part in _parts(row):
            if part.geom_type == "Polygon":
                seed = part.representative_point()
                seeds.append((seed.x, seed.y, number + 1.0, float(areas[number])))
                polygons.append(part)
                lines.extend([part.exterior, *part.interiors])
            elif part.geom_type in ("LineString", "LinearRing"):
                lines.append(part)
            elif part.geom_type == "Point":
                points.append(part.coords[0][:2])
            else:
                raise _arrays.fail(DrawingError, f"{part.geom_type} is not known", "geometry")
    return _of_lines([np.asarray(line.coords)[:, :2] for line in lines], points, seeds, _gaps(shapely, polygons))


def _parts(geometry: Any) -> list[Any]:
    if not hasattr(geometry, "geoms"):
        return [geometry]
    return [part for inner in geometry.geoms for part in _parts(inner)]


def _gaps(shapely: Any, polygons: list[Any]) -> list[tuple[float, float]]:
    """A point in each part of the plane that polygons surround and do not cover."""
    if not polygons:
        return []
    union = shapely.union_all(polygons)
    gaps = []
    for part in _parts(union):
        for ring in part.interiors:
            for gap in _parts(shapely.Polygon(ring).difference(union)):
                if gap.geom_type == "Polygon" and not gap.is_empty:
                    point = gap.representative_point()
                    gaps.append((point.x, point.y))
    return gaps


def _of_lines(lines: list[Any], points: list[Any], seeds: list[Any], holes: list[Any]) -> Drawing:
    tables = [*lines, np.asarray(points, dtype=float).reshape(-1, 2)]
    stacked = np.vstack(tables)
    places, index = np.unique(stacked, axis=0, return_inverse=True)
    index = index.reshape(-1)
    ends, first = [np.empty((0, 2), dtype=np.int64)], 0
    for line in lines:
        own = index[first : first + len(line)]
        ends.append(np.column_stack([own[:-1], own[1:]]))
        first += len(line)
    segments = np.sort(np.vstack(ends), axis=1)
    segments = np.unique(segments[segments[:, 0] != segments[:, 1]], axis=0)
    domain = "seeds" if seeds else "hull"
    return Drawing(places, segments, holes or None, seeds or None, domain=domain)


def from_geopandas(frame: Any, *, max_area: str | None = None) -> Drawing:
    """A drawing of the rows of a `GeoDataFrame` or `GeoSeries`: polygons as regions, lines as segments.

    The attribute of a region is the number of its row, from 1 on, so `frame.iloc[(mesh.regions - 1).astype(int)]` has
    the row of each triangle. `max_area` names a column with the largest area of a triangle.
    """
    areas = None if max_area is None else np.nan_to_num(np.asarray(frame[max_area], dtype=float))
    return from_shapely(list(frame.geometry), max_areas=areas)


def to_geopandas(mesh: Any, *, crs: Any = None) -> Any:
    """The triangles of a mesh as a `GeoDataFrame` with the column `region`."""
    import geopandas
    import shapely

    corners = mesh.points[mesh.triangles]
    rings = np.concatenate([corners, corners[:, :1]], axis=1)
    return geopandas.GeoDataFrame({"region": mesh.regions.copy()}, geometry=shapely.polygons(rings), crs=crs)
