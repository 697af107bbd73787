# SPDX-License-Identifier: MIT
"""Linear interpolation in tetrahedra that were found once."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import FloatArray, IndexArray, as_array, as_fill_value

# Places interpolated together: temporary arrays stay small.
_BLOCK = 1 << 16


def as_fields(values: ArrayLike, count: int) -> tuple[NDArray[Any], FloatArray]:
    """Values of points as they are given, and as rows of doubles: two for a complex number."""
    given = as_array(values, "values")
    if given.dtype.kind not in "biufc":
        raise TypeError(f"values must be numbers, not {given.dtype}")
    if given.ndim == 0 or len(given) != count:
        raise ValueError(f"there are {count} points, but the shape of values is {given.shape}")
    kind = np.complex128 if given.dtype.kind == "c" else np.float64
    fields = int(np.prod(given.shape[1:]))
    rows: FloatArray = np.ascontiguousarray(given, dtype=kind).reshape(count, fields).view(np.float64)
    return given, rows


class Prepared:
    """Values of points as the library takes them: rows of doubles, the last of which is 1, so that it is
    NaN where there is no value, and only there."""

    def __init__(self, values: ArrayLike, count: int) -> None:
        given, rows = as_fields(values, count)
        self.shape = given.shape[1:]
        self.rows: FloatArray = np.column_stack([rows, np.ones(len(rows))])
        self._kind = given.dtype

    def result(
        self, found: FloatArray, finite: NDArray[np.bool_], fill_value: complex
    ) -> NDArray[Any]:
        """Of rows found at the finite ones among places."""
        kind = np.result_type(self._kind, np.float64, np.min_scalar_type(fill_value))
        out = np.full((len(finite),) + self.shape, fill_value, dtype=kind)
        is_known = ~np.isnan(found[:, -1])
        known = np.flatnonzero(finite)[is_known]
        fields = np.ascontiguousarray(found[is_known, :-1])
        if self._kind.kind == "c":
            fields = fields.view(np.complex128)
        out[known] = fields.reshape((len(known),) + self.shape)
        return out


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

    Examples
    --------
    >>> import mgdt
    >>> d = mgdt.Delaunay([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    >>> at = d.interpolator([[0.25, 0.25, 0.25], [0.5, 0.5, 0.0]])
    >>> at([0.0, 1.0, 2.0, 4.0]).tolist()
    [1.75, 1.5]

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

    def __repr__(self) -> str:
        shape = self.simplices.shape
        return f"<mgdt.Interpolator: {self._count} points, places of shape {shape}>"

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
        kind = np.result_type(given.dtype, np.float64, np.min_scalar_type(as_fill_value(fill_value)))
        out = np.empty((len(places),) + given.shape[1:], dtype=kind)
        for begin in range(0, len(places), _BLOCK):
            block = slice(begin, begin + _BLOCK)
            if self._count:
                out[block] = np.einsum("ij,ij...->i...", weights[block], given[vertices[block]])
            out[block][places[block] < 0] = fill_value
        return out.reshape(self.simplices.shape + given.shape[1:])
