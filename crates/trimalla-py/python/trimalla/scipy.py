"""`Delaunay` with the names of `scipy.spatial.Delaunay`, for points in the plane.

>>> from trimalla.scipy import Delaunay
>>> d = Delaunay([[0, 0], [1, 0], [1, 1], [0, 1]])
>>> d.simplices.shape, int(d.find_simplex([0.9, 0.5])) in (0, 1)
((2, 3), True)
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _arrays, _native
from ._mesh import Mesh

__all__ = ["Delaunay"]


class Delaunay:
    """The Delaunay triangulation of points in the plane.

    As in scipy: `points`, `simplices`, `neighbors`, `convex_hull`, `coplanar`, `transform`, `vertex_to_simplex`,
    `vertex_neighbor_vertices`, `npoints`, `nsimplex`, `ndim`, `find_simplex`. Signs are exact: `find_simplex` and the
    triangles need no tolerance, `tol` and `qhull_options` have no effect, and there is no point that scipy would list
    as `coplanar` but those that lie exactly on others. Points on one line raise an error.
    """

    ndim = 2

    def __init__(
        self, points: Any, furthest_site: bool = False, incremental: bool = False, qhull_options: str | None = None
    ) -> None:
        if furthest_site or incremental:
            raise NotImplementedError("furthest_site and incremental; trimalla.Triangulation inserts and removes points")
        self.points = np.array(_arrays.points(points))
        self.npoints = len(self.points)
        self.simplices: npt.NDArray[np.int32] = _native.delaunay(self.points)
        self.nsimplex = len(self.simplices)
        if not self.nsimplex:
            message = f"{self.npoints} points give no triangle"
            raise _arrays.fail(_native.DrawingError, message, "flat")
        self.min_bound, self.max_bound = self.points.min(axis=0), self.points.max(axis=0)

    @cached_property
    def _mesh(self) -> Mesh:
        return Mesh(self.points, self.simplices)

    @property
    def neighbors(self) -> npt.NDArray[np.int32]:
        """The triangle opposite each corner, -1 for none: int32 (t, 3)."""
        return self._mesh.neighbours

    @property
    def convex_hull(self) -> npt.NDArray[np.int32]:
        """The edges of the hull: int32 (h, 2)."""
        return self._mesh.boundary

    @cached_property
    def coplanar(self) -> npt.NDArray[np.int32]:
        """Points that lie on others: their index, a triangle of the other, and the other: int32 (k, 3)."""
        unused = np.setdiff1d(np.arange(self.npoints), self.simplices)
        if not unused.size:
            return np.empty((0, 3), dtype=np.int32)
        simplex = self.find_simplex(self.points[unused])
        corners = self.simplices[simplex]
        same = (self.points[corners] == self.points[unused][:, np.newaxis]).all(axis=2)
        on = corners[np.arange(len(unused)), same.argmax(axis=1)]
        return np.column_stack([unused, simplex, on]).astype(np.int32)

    @cached_property
    def transform(self) -> npt.NDArray[np.float64]:
        """Affine transforms to barycentric coordinates: float64 (t, 3, 2); NaN for triangles without an inverse."""
        corners = self.points[self.simplices]
        origin = corners[:, 2]
        columns = (corners[:, :2] - origin[:, np.newaxis]).transpose(0, 2, 1)
        (a, b), (c, d) = columns[:, 0].T, columns[:, 1].T
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            inverse = np.stack([np.stack([d, -b], -1), np.stack([-c, a], -1)], 1) / (a * d - b * c)[:, None, None]
        inverse[~np.isfinite(inverse).all(axis=(1, 2))] = np.nan
        return np.concatenate([inverse, origin[:, np.newaxis]], axis=1)

    @cached_property
    def vertex_to_simplex(self) -> npt.NDArray[np.int32]:
        """A triangle of each point, -1 for those that lie on others: int32 (n)."""
        found = np.full(self.npoints, -1, dtype=np.int32)
        found[self.simplices.ravel()] = np.repeat(np.arange(self.nsimplex, dtype=np.int32), 3)
        return found

    @cached_property
    def vertex_neighbor_vertices(self) -> tuple[npt.NDArray[np.int32], npt.NDArray[np.int32]]:
        """The neighbours of point `k` are `indices[indptr[k]:indptr[k + 1]]`: `(indptr, indices)`."""
        both = np.vstack([self._mesh.edges, self._mesh.edges[:, ::-1]])
        both = both[np.lexsort((both[:, 1], both[:, 0]))]
        counts = np.bincount(both[:, 0], minlength=self.npoints)
        return np.concatenate([[0], np.cumsum(counts)]).astype(np.int32), both[:, 1].copy()

    def find_simplex(self, xi: Any, bruteforce: bool = False, tol: float | None = None) -> npt.NDArray[np.int32]:
        """The triangle of each point, -1 outside; of the shape of `xi` without its last dimension."""
        xi = _arrays.numbers(xi, "xi")
        if xi.shape[-1:] != (2,):
            raise _arrays.fail(_native.DrawingError, f"xi must have shape (..., 2), not {xi.shape}")
        return self._mesh.locate(xi.reshape(-1, 2)).reshape(xi.shape[:-1])
