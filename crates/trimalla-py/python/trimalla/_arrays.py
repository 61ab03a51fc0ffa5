"""What users pass, as contiguous arrays of the types that the native module takes."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from ._native import DrawingError, Error

Points = npt.NDArray[np.float64]
Indices = npt.NDArray[np.int32]
Markers = npt.NDArray[np.int32]


def fail(kind: type[Error], message: str, name: str = "shape") -> Error:
    """An exception with the attributes that those of the native module have."""
    error = kind(message)
    error.kind, error.indices, error.points = name, [], []
    return error


def numbers(values: Any, what: str) -> npt.NDArray[np.float64]:
    """An array of float64; what has no numbers, or complex ones, is refused."""
    try:
        array = np.asarray(values)
        if array.dtype.kind not in "fiub" and not (array.dtype.kind == "O" and array.size):
            if array.size:
                raise fail(DrawingError, f"{what} must be numbers, not {array.dtype}")
        return np.asarray(array, dtype=np.float64, order="C")
    except Error:
        raise
    except (TypeError, ValueError, OverflowError) as error:
        raise fail(DrawingError, f"{what} cannot be read as an array of numbers: {error}") from error


def table(values: Any, what: str, columns: int) -> npt.NDArray[np.float64]:
    """A table of float64 with so many columns; nothing is one without rows."""
    if values is None:
        return np.empty((0, columns))
    array = numbers(values, what)
    if array.size == 0:
        return np.empty((0, columns))
    if array.ndim != 2 or array.shape[1] != columns:
        raise fail(DrawingError, f"{what} must have shape (n, {columns}), not {array.shape}")
    return array


def points(values: Any, what: str = "points") -> npt.NDArray[np.float64]:
    """A table of x and y."""
    return table(values, what, 2)


def indices(values: Any, what: str, columns: int) -> npt.NDArray[np.int64]:
    """A table of whole numbers; whether they are indices of points is checked later."""
    if values is None:
        return np.empty((0, columns), dtype=np.int64)
    try:
        array = np.asarray(values)
        if array.size == 0:
            return np.empty((0, columns), dtype=np.int64)
        if array.dtype.kind not in "iuf":
            raise fail(DrawingError, f"{what} must be whole numbers, not {array.dtype}")
        with np.errstate(invalid="ignore"):
            whole = array.astype(np.int64, copy=False)
        if array.dtype.kind != "i" and not (whole == array).all():
            raise fail(DrawingError, f"{what} must be whole numbers")
    except Error:
        raise
    except (TypeError, ValueError, OverflowError) as error:
        raise fail(DrawingError, f"{what} cannot be read as an array of whole numbers: {error}") from error
    if whole.ndim != 2 or whole.shape[1] != columns:
        raise fail(DrawingError, f"{what} must have shape (n, {columns}), not {whole.shape}")
    return np.ascontiguousarray(whole)


def markers(values: Any, what: str) -> npt.NDArray[np.int32]:
    """A column of int32; one of shape (n, 1) is taken, too."""
    if values is None:
        return np.empty(0, dtype=np.int32)
    array = indices(np.reshape(np.asarray(values), (-1, 1)), what, 1)[:, 0]
    if array.size and (array.min() < -(2**31) or array.max() >= 2**31):
        raise fail(DrawingError, f"{what} must fit into 32 bits")
    return np.ascontiguousarray(array, dtype=np.int32)


def attributes(values: Any, rows: int, what: str) -> npt.NDArray[np.float64] | None:
    """A table of float64 with a row for each point or triangle; one number each is taken as one column."""
    if values is None:
        return None
    array = numbers(values, what)
    if array.ndim == 1:
        array = array[:, np.newaxis]
    if array.ndim != 2 or len(array) != rows:
        raise fail(DrawingError, f"{what} must have {rows} rows, not shape {array.shape}")
    return np.ascontiguousarray(array)


def frozen(array: Any) -> Any:
    """The array, which nobody may change from now on."""
    array.flags.writeable = False
    return array
