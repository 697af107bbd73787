# SPDX-License-Identifier: MIT
"""Linear interpolation in tetrahedra that were found once."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import FloatArray, IndexArray

# Places interpolated together: temporary arrays stay small.
_BLOCK = 1 << 16


def as_fields(values: ArrayLike, count: int) -> tuple[NDArray[Any], FloatArray]:
    """Values of points as they are given, and as rows of doubles: two for a complex number."""
    given = np.asarray(values)
    if given.dtype.kind not in "biufc":
        raise TypeError(f"values must be numbers, not {given.dtype}")
    if given.ndim == 0 or len(given) != count:
        raise ValueError(f"there are {count} points, but the shape of values is {given.shape}")
    kind = np.complex128 if given.dtype.kind == "c" else np.float64
    fields = int(np.prod(given.shape[1:]))
    rows: FloatArray = np.ascontiguousarray(given, dtype=kind).reshape(count, fields).view(np.float64)
    return given, rows


class Interpolator:
    """Interpolates values of points at fixed places. Made by `Delaunay.interpolator`.

    It is independent of the triangulation that made it.

    Attributes
    ----------
    simplices : ndarray of int32, shape (...)
        The simplex of each place; -1 outside the hull and for places that are not finite.
    vertices : ndarray of int32, shape (..., 4)
        Its vertices; 0 outside the hull.
    weights : ndarray of float64, shape (..., 4)
        Their barycentric weights; 0 outside the hull.

    Notes
    -----
    Since 1.0.
    """

    def __init__(
        self,
        count: int,
        all_simplices: IndexArray,
        simplices: IndexArray,
        weights: FloatArray,
    ) -> None:
        self._count = count
        self.simplices = simplices
        self.weights = weights
        self.vertices: IndexArray = np.zeros(simplices.shape + (4,), dtype=np.int32)
        inside = simplices >= 0
        self.vertices[inside] = all_simplices[simplices[inside]]

    def __call__(self, values: ArrayLike, fill_value: complex = np.nan) -> NDArray[Any]:
        """Interpolates values.

        Parameters
        ----------
        values : array_like of float or complex, shape (npoints, ...)
        fill_value : number, optional
            The result outside the hull.

        Returns
        -------
        ndarray
            Shape of the places without their last axis, then that of `values` without its first.

        Raises
        ------
        ValueError
            If the numbers of values and points differ.
        """
        given = as_fields(values, self._count)[0]
        places = self.simplices.ravel()
        vertices = self.vertices.reshape(-1, 4)
        weights = self.weights.reshape(-1, 4)
        kind = np.result_type(given.dtype, np.float64, np.min_scalar_type(fill_value))
        out = np.empty((len(places),) + given.shape[1:], dtype=kind)
        for begin in range(0, len(places), _BLOCK):
            block = slice(begin, begin + _BLOCK)
            if self._count:
                out[block] = np.einsum("ij,ij...->i...", weights[block], given[vertices[block]])
            out[block][places[block] < 0] = fill_value
        return out.reshape(self.simplices.shape + given.shape[1:])
