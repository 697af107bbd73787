# SPDX-License-Identifier: MIT
"""Arrays of points as the library takes them, without a copy where that can be."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

FloatArray = NDArray[np.float64]
IndexArray = NDArray[np.int32]
BoolArray = NDArray[np.bool_]

# Rows looked at together: temporary arrays stay small.
_BLOCK = 1 << 16


def as_array(values: Any, name: str) -> NDArray[Any]:
    """An array of what may become one.

    Raises
    ------
    ValueError
        If it is masked, which NumPy's functions forget, or a list of rows of different lengths.
    """
    if isinstance(values, np.ma.MaskedArray):
        raise ValueError(f"{name} cannot be a masked array")
    try:
        return np.asarray(values)
    except ValueError as error:
        raise ValueError(f"{name} cannot be made into an array: {error}") from None


def _as_doubles(values: ArrayLike, name: str) -> FloatArray:
    array = as_array(values, name)
    if array.dtype.kind not in "biufO":
        raise TypeError(f"{name} must be real numbers, not {array.dtype}")
    try:
        # Native byte order and alignment; nothing is copied if the array has them.
        return np.require(array, dtype=np.float64, requirements="A")
    except (TypeError, ValueError) as error:
        raise type(error)(f"{name} must be real numbers: {error}") from None


def as_number(value: Any, name: str) -> float:
    """A number of at least 0, which may be infinite."""
    try:
        number = float(value) if not isinstance(value, (str, bytes)) else None
    except TypeError:
        number = None
    if number is None:
        raise TypeError(f"{name} is {value!r}; it must be a number")
    if not number >= 0:
        raise ValueError(f"{name} is {value}; it must be at least 0")
    return number


def as_fill_value(value: Any) -> Any:
    """A number, which a result has where there is no value."""
    array = np.asarray(value)
    if array.ndim != 0 or array.dtype.kind not in "biufc":
        raise TypeError(f"fill_value is {value!r}; it must be a number")
    return value


def as_points(values: ArrayLike, name: str = "points") -> FloatArray:
    """Points as doubles of shape (n, 3), in whatever strides they come.

    Raises
    ------
    ValueError
        If the shape is another one.
    TypeError
        If they are not real numbers.
    """
    array = _as_doubles(values, name)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(
            f"mgdt triangulates points in 3D: {name} must have the shape (n, 3), "
            f"not {array.shape}"
        )
    return array


def as_places(values: ArrayLike, name: str) -> tuple[FloatArray, tuple[int, ...]]:
    """Places of shape (..., 3) as contiguous rows (m, 3), and the shape before the last axis."""
    array = _as_doubles(values, name)
    if array.ndim == 0 or array.shape[-1] != 3:
        raise ValueError(
            f"mgdt works in 3D: the last axis of {name} must have 3 coordinates, "
            f"but the shape is {array.shape}"
        )
    return np.ascontiguousarray(array.reshape(-1, 3)), array.shape[:-1]


def as_planes(values: Optional[ArrayLike]) -> FloatArray:
    """Planes as contiguous rows (n, 4); none for None."""
    if values is None:
        return np.empty((0, 4))
    array = _as_doubles(values, "planes")
    if array.ndim != 2 or array.shape[1] != 4:
        raise ValueError(f"planes must have the shape (n, 4), not {array.shape}")
    return np.ascontiguousarray(array)


def stride_in_doubles(points: FloatArray) -> Optional[int]:
    """The distance from one row to the next in doubles; None if it is no whole number."""
    step: int = points.strides[0]
    return step // 8 if step % 8 == 0 else None


def address(array: NDArray[Any], column: int = 0) -> int:
    """Where an array, or a column of it, begins."""
    begin: int = array.ctypes.data
    return begin if column == 0 else begin + column * array.strides[-1]


def finite_rows(points: FloatArray) -> NDArray[np.bool_]:
    """Which rows have finite coordinates only."""
    finite = np.empty(len(points), dtype=np.bool_)
    for begin in range(0, len(points), _BLOCK):
        block = slice(begin, begin + _BLOCK)
        np.isfinite(points[block]).all(axis=1, out=finite[block])
    return finite


def describe_not_finite(points: FloatArray, name: str) -> str:
    """A message that names the first row that is not finite."""
    row = int(np.argmin(finite_rows(points)))
    x, y, z = points[row]
    return f"{name}[{row}] is ({x}, {y}, {z}): coordinates must be finite"


class PointStore:
    """The points given so far, in one array.

    Parameters
    ----------
    copies : bool
        Whether to keep copies, which grow in place, or the one array given.
    """

    def __init__(self, copies: bool) -> None:
        self._copies = copies
        self._room = np.empty((0, 3))
        self._size = 0

    def append(self, points: FloatArray) -> None:
        if not self._copies and self._size == 0:
            self._room, self._size = points, len(points)
            return
        size = self._size + len(points)
        if size > len(self._room):
            # Earlier views keep the old array.
            room = np.empty((max(size, 2 * len(self._room)) if self._size else size, 3))
            room[: self._size] = self._room[: self._size]
            self._room = room
        self._room[self._size : size] = points
        self._size = size

    def replace(self, points: FloatArray) -> None:
        """Takes an array of its own in place of all points; earlier views keep the old one."""
        self._room, self._size = points, len(points)

    @property
    def all(self) -> FloatArray:
        # The caller's own array where it was given at once.
        return self._room if self._size == len(self._room) else self._room[: self._size]
