# SPDX-License-Identifier: MIT
"""Values between points, in the shape of ``scipy.interpolate``."""

from __future__ import annotations

from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import FloatArray, as_array, as_fill_value, as_number, as_points
from .delaunay import Delaunay
from .interpolation import Prepared, as_fields


def _as_places(arguments: tuple[Any, ...]) -> NDArray[Any]:
    """Places as SciPy takes them: one array, a tuple of three, or three arguments."""
    if len(arguments) == 0:
        raise TypeError("no places: give an array of shape (..., 3), a tuple of three, or three arguments")
    given = arguments[0] if len(arguments) == 1 else arguments
    places: NDArray[Any]
    if isinstance(given, tuple):
        arrays = [as_array(x, "places") for x in given]
        places = np.stack(np.broadcast_arrays(*arrays), axis=-1)
    else:
        places = as_array(given, "places")
        if places.ndim == 1 and places.size % 3 == 0:
            places = places.reshape(-1, 3)
    if places.ndim == 0 or places.shape[-1] != 3:
        raise ValueError(f"places must have 3 coordinates, but the shape is {places.shape}")
    return places


class _Scattered:
    """Values at points, and the triangulation of these."""

    def __init__(self, points: Any, values: ArrayLike, rescale: bool, **options: Any) -> None:
        self._offset = np.zeros(3)
        self._scale = np.ones(3)
        is_triangulation = isinstance(points, Delaunay) or type(points).__name__ == "Delaunay"
        if rescale and is_triangulation:
            raise ValueError("rescale is not supported for points in a triangulation")
        if isinstance(points, Delaunay):
            self.tri = points
        else:
            if is_triangulation:  # SciPy's
                points = points.points
            array: FloatArray = as_points(
                _as_places((points,)) if isinstance(points, tuple) else points
            )
            if rescale and len(array):
                self._offset = array.mean(axis=0)
                extent = np.ptp(array, axis=0)
                self._scale = np.where(extent > 0, extent, 1)
                array = self._rescaled(array)
            self.tri = Delaunay(array, **options)
        self.points = self.tri.points
        self.values = as_fields(values, self.tri.npoints)[0]

    def __repr__(self) -> str:
        name, shape = type(self).__name__, np.shape(self.values)
        return f"<mgdt.{name}: {len(self.points)} points, values of shape {shape}>"

    def _rescaled(self, places: NDArray[Any]) -> NDArray[Any]:
        if not self._offset.any() and (self._scale == 1).all():
            return places
        rescaled: NDArray[Any] = (places - self._offset) / self._scale
        return rescaled


class LinearNDInterpolator(_Scattered):
    """Linear in each simplex, as ``scipy.interpolate.LinearNDInterpolator`` in three dimensions.

    Every place in the closed hull has a value, exactly located. As in SciPy, so has a place that is
    outside by no more than rounding: it gets the value of the nearest place of the hull.

    Parameters
    ----------
    points : array_like of float, shape (n, 3), tuple of three arrays, or Delaunay
        The last may be `mgdt.Delaunay` or SciPy's.
    values : array_like of float or complex, shape (n, ...)
    fill_value : number, optional
        The result outside the hull, and where a coordinate is NaN or infinite.
    rescale : bool, optional
        Whether to rescale points to unit extents before they are triangulated.
    outside : str, optional
        What is outside the hull: "none", which is `fill_value`; "nearest", "boundary" or "linear",
        see `mgdt.Delaunay.interpolate`.
    tol : float, optional
        How far outside the hull a place may be that counts as on it, by default 100 units in the last
        place of the largest extent of the points; 0 takes none.
    **options
        Of `mgdt.Delaunay`.

    Examples
    --------
    >>> import mgdt
    >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    >>> at = mgdt.LinearNDInterpolator(corners, [0.0, 1.0, 2.0, 4.0])
    >>> float(at(0.25, 0.25, 0.25))
    1.75

    Notes
    -----
    Call it with places: an array of shape (..., 3), a tuple of three arrays, or three arguments.
    Since 1.2.
    """

    _method = "linear"

    def __init__(
        self,
        points: Any,
        values: ArrayLike,
        fill_value: complex = np.nan,
        rescale: bool = False,
        *,
        outside: str = "none",
        tol: Optional[float] = None,
        **options: Any,
    ) -> None:
        self.fill_value = as_fill_value(fill_value)
        if tol is not None:
            tol = as_number(tol, "tol")
        super().__init__(points, values, rescale, **options)
        self.tri._require_manner(self._method, outside)
        self._prepared = Prepared(self.values, self.tri.npoints)
        self._outside = outside
        if tol is None:
            extent = np.ptp(self.points, axis=0).max() if len(self.points) else 0.0
            tol = 100 * float(np.finfo(float).eps * extent)
        self.tol = float(tol)

    def __call__(self, *places: Any) -> NDArray[Any]:
        return self.tri._interpolate(
            self._prepared,
            self._rescaled(_as_places(places)),
            self.fill_value,
            self._method,
            self._outside,
            self.tol if self._outside == "none" else 0.0,
        )


class NaturalNeighborInterpolator(LinearNDInterpolator):
    """By natural neighbours: smooth between the points, with no parameters.

    Parameters
    ----------
    points, values, fill_value, rescale, tol, **options
        As `LinearNDInterpolator`.
    method : str, optional
        "sibson"; "laplace", which takes half the time; or "sibson_c1", which has gradients too and
        is smooth at the points.
    outside : str, optional
        As `LinearNDInterpolator`.

    Examples
    --------
    >>> import mgdt, numpy
    >>> lattice = numpy.indices((3, 3, 3)).reshape(3, -1).T
    >>> at = mgdt.NaturalNeighborInterpolator(lattice, lattice.sum(axis=1))
    >>> round(float(at(0.5, 0.75, 1.25)), 12)
    2.5

    Notes
    -----
    Since 1.2.
    """

    def __init__(
        self,
        points: Any,
        values: ArrayLike,
        fill_value: complex = np.nan,
        rescale: bool = False,
        method: str = "sibson",
        outside: str = "none",
        *,
        tol: Optional[float] = None,
        **options: Any,
    ) -> None:
        self._method = method
        super().__init__(points, values, fill_value, rescale, outside=outside, tol=tol, **options)


class NearestNDInterpolator(_Scattered):
    """The value of the nearest point, as ``scipy.interpolate.NearestNDInterpolator``.

    Parameters
    ----------
    x : as the points of `LinearNDInterpolator`
    y : array_like, shape (n, ...)
        Values; of any type.
    rescale : bool, optional
        As `LinearNDInterpolator`.
    tree_options : optional
        Has no effect: there is no tree.

    Notes
    -----
    Of several points as near, the first. A place with a coordinate that is NaN or infinite has the
    value NaN; where the values' type has none, it is an error. Since 1.2.

    Examples
    --------
    >>> import mgdt
    >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    >>> str(mgdt.NearestNDInterpolator(corners, ["a", "b", "c", "d"])(0.1, 0.9, 0))
    'c'
    """

    def __init__(
        self, x: Any, y: ArrayLike, rescale: bool = False, tree_options: Any = None, **options: Any
    ) -> None:
        values = as_array(y, "y")
        count = values.shape[0] if values.ndim else -1
        super().__init__(x, np.zeros(max(count, 0)), rescale, **options)
        self.values = values

    def __call__(self, *places: Any) -> NDArray[Any]:
        nearest = self.tri.nearest_vertex(self._rescaled(_as_places(places)))
        found: NDArray[Any] = self.values[nearest]
        is_nowhere = nearest < 0
        if is_nowhere.any():
            if self.values.dtype.kind not in "fc":
                raise ValueError(
                    f"a place is not finite, and values of type {self.values.dtype} have no NaN"
                )
            found = np.where(is_nowhere[(...,) + (None,) * (found.ndim - nearest.ndim)], np.nan, found)
        return found


def griddata(
    points: Any,
    values: ArrayLike,
    xi: Any,
    method: str = "linear",
    fill_value: complex = np.nan,
    rescale: bool = False,
    *,
    outside: str = "none",
    tol: Optional[float] = None,
) -> NDArray[Any]:
    """Interpolates scattered values once, as ``scipy.interpolate.griddata`` in three dimensions.

    Parameters
    ----------
    points : array_like of float, shape (n, 3), or tuple of three arrays
    values : array_like of float or complex, shape (n, ...)
    xi : array_like of float, shape (..., 3), or tuple of three arrays
        Where to interpolate.
    method : str, optional
        "linear" or "nearest"; with mgdt also "sibson", "laplace" and "sibson_c1".
    fill_value : number, optional
        The result outside the hull; without effect for "nearest".
    rescale, outside, tol : optional
        As `LinearNDInterpolator`.

    Examples
    --------
    >>> import mgdt
    >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    >>> mgdt.griddata(corners, [0.0, 1.0, 2.0, 4.0], [[0.5, 0.25, 0.25], [2, 2, 2]]).tolist()
    [2.0, nan]

    Notes
    -----
    Since 1.2.
    """
    as_fill_value(fill_value)
    interpolator: Union[NearestNDInterpolator, LinearNDInterpolator]
    if method == "nearest":
        interpolator = NearestNDInterpolator(points, values, rescale)
    elif method == "linear":
        interpolator = LinearNDInterpolator(
            points, values, fill_value, rescale, outside=outside, tol=tol
        )
    elif method in ("sibson", "laplace", "sibson_c1"):
        interpolator = NaturalNeighborInterpolator(
            points, values, fill_value, rescale, method, outside, tol=tol
        )
    else:
        raise ValueError(f"Unknown interpolation method {method!r} for 3 dimensional data")
    return interpolator(xi)
