"""Sizes of triangles, as users give them."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from . import _arrays
from ._native import OptionError

Size = Union[float, npt.ArrayLike, Callable[..., Any], "Raster"]


class Raster:
    """Lengths on a grid, bilinear between its nodes, and the nearest of them outside it.

    Parameters
    ----------
    values: float (ny, nx); NaN where nothing is asked for
    x: float (nx), ascending or descending; y: float (ny)

    >>> import numpy as np, trimalla
    >>> raster = trimalla.Raster(np.array([[0.1, 0.5], [0.1, 0.5]]), x=[0, 4], y=[0, 4])
    >>> float(raster(np.array([2.0]), np.array([1.0]))[0])
    0.3
    """

    def __init__(self, values: Any, x: Any, y: Any) -> None:
        values, x, y = (_arrays.numbers(a, w) for a, w in ((values, "values"), (x, "x"), (y, "y")))
        if values.ndim != 2 or values.shape != (y.size, x.size) or x.ndim != 1 or y.ndim != 1 or not values.size:
            raise _arrays.fail(OptionError, f"values must have shape ({y.size}, {x.size}), not {values.shape}", "option")
        if x[0] > x[-1]:
            x, values = x[::-1], values[:, ::-1]
        if y[0] > y[-1]:
            y, values = y[::-1], values[::-1]
        if not ((np.diff(x) > 0).all() and (np.diff(y) > 0).all()):
            raise _arrays.fail(OptionError, "x and y must ascend or descend", "option")
        self.x, self.y, self.values = x, y, np.where(np.isnan(values), np.inf, values)

    @classmethod
    def of_xarray(cls, array: Any) -> Raster:
        """A two-dimensional `xarray.DataArray` with coordinates: the last dimension is x."""
        if array.ndim != 2:
            raise _arrays.fail(OptionError, f"the array must have 2 dimensions, not {array.ndim}", "option")
        y, x = (np.asarray(array[name]) for name in array.dims)
        return cls(array.values, x, y)

    def __call__(self, x: npt.NDArray[np.float64], y: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        i, s = _place(self.x, x)
        j, t = _place(self.y, y)
        right, upper = np.minimum(i + 1, self.x.size - 1), np.minimum(j + 1, self.y.size - 1)
        v = self.values
        with np.errstate(invalid="ignore"):
            lower = np.where(s > 0, (1 - s) * v[j, i] + s * v[j, right], v[j, i])
            above = np.where(s > 0, (1 - s) * v[upper, i] + s * v[upper, right], v[upper, i])
            found = np.where(t > 0, (1 - t) * lower + t * above, lower)
        return np.where(np.isnan(found), np.inf, found)


def _place(nodes: npt.NDArray[np.float64], at: npt.NDArray[np.float64]) -> tuple[Any, Any]:
    at = np.clip(at, nodes[0], nodes[-1])
    i = np.clip(np.searchsorted(nodes, at, side="right") - 1, 0, max(nodes.size - 2, 0))
    if nodes.size == 1:
        return i, np.zeros_like(at)
    return i, (at - nodes[i]) / (nodes[i + 1] - nodes[i])


def native(
    points: npt.NDArray[np.float64],
    size: Size | None,
    sources: Any,
    gradation: float | None,
    growth: float | None,
    triangles: int | None,
) -> dict[str, Any]:
    """The sizes of a call as the native module takes them."""
    asked: dict[str, Any] = {"gradation": gradation, "growth": growth, "triangles": triangles}
    rows = [_sources(sources)]
    if size is not None:
        if hasattr(size, "dims") and hasattr(size, "values"):
            size = Raster.of_xarray(size)
        if callable(size):
            asked["function"] = _batches(size)
        elif np.ndim(size) == 0:  # type: ignore[arg-type]
            asked["edge"] = float(_arrays.numbers(size, "size"))
        else:
            lengths = _arrays.numbers(size, "size")
            if lengths.shape != (len(points),):
                message = f"size must be a number, a function, or have one length for each of {len(points)} points"
                raise _arrays.fail(OptionError, f"{message}, not shape {lengths.shape}", "option")
            has_size = np.isfinite(lengths)
            rows.append(np.column_stack([points, points, lengths])[has_size])
    stacked = np.vstack(rows)
    if len(stacked):
        asked["sources"] = np.ascontiguousarray(stacked)
    return asked


def _sources(sources: Any) -> npt.NDArray[np.float64]:
    if sources is None or np.size(sources) == 0:
        return np.empty((0, 5))
    array = _arrays.numbers(sources, "sources")
    if array.ndim == 2 and array.shape[1] == 3:
        return np.column_stack([array[:, :2], array])
    if array.ndim != 2 or array.shape[1] != 5:
        message = f"sources must have shape (k, 3): x, y, length; or (k, 5): x1, y1, x2, y2, length; not {array.shape}"
        raise _arrays.fail(OptionError, message, "option")
    return array


def _batches(function: Callable[..., Any]) -> Callable[[npt.NDArray[np.float64]], npt.NDArray[np.float64]]:
    def lengths(places: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        found = _arrays.numbers(function(places[:, 0].copy(), places[:, 1].copy()), "size")
        if found.ndim == 0:
            found = np.full(len(places), float(found))
        return np.ascontiguousarray(found.reshape(-1))

    return lengths
