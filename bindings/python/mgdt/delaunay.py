# SPDX-License-Identifier: MIT
"""The triangulation, in the meaning of ``scipy.spatial.Delaunay``."""

from __future__ import annotations

from typing import Any, Callable, Literal, Optional, Union, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _geometry, export
from ._arrays import (
    BoolArray,
    FloatArray,
    IndexArray,
    as_fill_value,
    as_number,
    as_places,
    as_planes,
    finite_rows,
)
from ._handle import MEASURES, METHODS, OUTSIDES, TETRAHEDRON_MEASURES, Handle
from ._tolerance import in_tolerance
from ._triangulation import GrowingTriangulation, whole
from .interpolation import Interpolator, Prepared, as_fields

# Numbers of points and of places from which a check and a location may take so long that Ctrl-C
# shall interrupt them.
_LONG_CHECK = 20_000
_LONG_LOCATION = 50_000


def _simplex_of_each(tetrahedra: IndexArray, point_map: IndexArray) -> IndexArray:
    """By point: a simplex around its vertex."""
    # The last is for points that were left out, whose vertex is -1.
    found = np.full(len(point_map) + 1, -1, dtype=np.int32)
    numbers = np.arange(len(tetrahedra), dtype=np.int32)
    for k in range(4):
        found[tetrahedra[:, k]] = numbers
    of_points: IndexArray = found[point_map]
    return of_points


def _bring_in(
    handle: Handle,
    method: str,
    rows: FloatArray,
    points: FloatArray,
    box: tuple[FloatArray, FloatArray],
    places: FloatArray,
    found: FloatArray,
    tolerance: float,
) -> None:
    """Gives those of the places that have no value and are near the hull that of the nearest place of
    the hull. Which place that is, is the value there of the points themselves, relative to the least
    corner of their box so that little is rounded."""
    low, high = box[0] - tolerance, box[1] + tolerance
    out = np.flatnonzero(np.isnan(found[:, -1]))
    out = out[((places[out] >= low) & (places[out] <= high)).all(axis=1)]
    if len(out) == 0:
        return
    some = np.ascontiguousarray(places[out])
    there = handle.interpolate(method, "boundary", np.column_stack([rows, points - box[0]]), some)
    way = there[:, -3:] - (some - box[0])
    is_near = np.einsum("ij,ij->i", way, way) <= tolerance * tolerance
    found[out[is_near]] = there[is_near, :-3]


class Delaunay(GrowingTriangulation):
    """Exact Delaunay triangulation of points in space.

    Takes the place of ``scipy.spatial.Delaunay`` for three dimensions: what has a name there has
    the same name, shape, type and meaning here, but for what is listed under Notes.

    Parameters
    ----------
    points : array_like of float, shape (n, 3)
        Coordinates, in any one unit of length. Doubles in any regular layout are handed to the
        library as they are; anything else is converted once.
    furthest_site : bool, optional
        Must be false: mgdt has no furthest-site triangulation.
    incremental : bool, optional
        Whether `add_points`, `remove_points` or `move_points` will be used. If so, the coordinates
        are copied; if not, `points` is the array given.
    qhull_options : str, optional
        Qhull's options. Those that do not change an exact triangulation are accepted and have no
        effect; others are refused.
    order : str, optional
        In which order points are inserted; one of `ORDER_SCHEMES`. It changes the time, not the
        tetrahedra.
    order_parameters : mapping, optional
        Of ``points_per_cell``, ``threshold``, ``separation``, ``round_ratio``, those to set.
    seed : int, optional
        For the orders that shuffle. From 0 to 2**64 - 1.
    threads : int, optional
        How many threads an insertion may use; 0 for all cores.
    memory_limit : int, optional
        Bytes that the triangulation may hold in the library; None for no limit.
    compact : bool, optional
        Whether the library keeps no circumspheres: 30 % less memory, 20 to 40 % more time,
        the same arrays. Since 1.1.
    canonical : bool, optional
        Whether the arrays shall be a function of the set of points alone, byte for byte: sorted,
        each tetrahedron's least vertex first. Takes longer.
    progress : callable, optional
        Called as ``progress(fraction)`` with 0 to 1 some hundred times an insertion, on the thread
        that inserts. The result ``mgdt.CANCEL`` cancels, and so does an exception, which goes on to
        the caller. Any other result means nothing: until 1.1 a true one cancelled. It must not use
        the triangulation, except `cancel`.

    Raises
    ------
    ValueError
        For a shape other than (n, 3), a coordinate that is NaN or infinite (the message names the
        point), or any argument out of its range.
    TypeError
        For points that are no real numbers.
    mgdt.OutOfMemoryError
        When the system or `memory_limit` refuses memory. Also a MemoryError.
    mgdt.TooLargeError
        For more points than can be numbered.
    mgdt.Cancelled
        When `progress` returned ``mgdt.CANCEL``.

    Notes
    -----
    Points equal to an earlier one are no vertices; `coplanar` and `point_map` list them. Fewer than
    four points, or points on one plane, are no error: there are no simplices then (`dimension`
    says why), until `add_points` brings points that span space with them.

    Simplices are positively oriented: ``(v1 - v0) x (v2 - v0) . (v3 - v0) > 0``.

    Any number of threads may use an object at a time. One that changes it waits for those that
    read it, and they for it. The interpreter lock is not held during work in the library.

    Ctrl-C during an insertion raises KeyboardInterrupt within some milliseconds. After that, as
    after `Cancelled` and `OutOfMemoryError`, the triangulation is that of the points that got in.
    Ctrl-C during a check, a location or the export of an array raises it at once; the library's
    call goes on to its end without a result, and what changes the triangulation waits for it.

    Since 1.0.

    Examples
    --------
    >>> import mgdt
    >>> d = mgdt.Delaunay([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    >>> d.nsimplex
    1
    >>> int(d.find_simplex([0.1, 0.1, 0.1]))
    0
    """

    furthest_site: bool = False
    """Always false."""
    ndim: int = 3
    """Number of coordinates of a point. Always 3."""

    # Points

    def _bounds(self) -> tuple[FloatArray, FloatArray]:
        def find() -> Any:
            points = self.points[self._fresh("point_map")[0] >= 0]
            return points.min(axis=0, initial=np.inf), points.max(axis=0, initial=-np.inf)

        bounds: tuple[FloatArray, FloatArray] = self._cached("bounds", find)
        return bounds

    @property
    def min_bound(self) -> FloatArray:
        """Least coordinates of the points that are in, shape (3,); inf without points."""
        return self._bounds()[0]

    @property
    def max_bound(self) -> FloatArray:
        """Largest coordinates of the points that are in, shape (3,); -inf without points."""
        return self._bounds()[1]

    @property
    def point_map(self) -> IndexArray:
        """For each point the vertex that stands for it, int32, shape (npoints,): its own index,
        that of the first point at the same place, or -1 if it is not in: removed, or left out by a
        stopped insertion."""
        points: IndexArray = self._exported("point_map")
        return points

    @property
    def dimension(self) -> int:
        """Dimension of what the points span: -1 no points, 0 one place, 1 a line, 2 a plane,
        3 space. There are simplices only at 3."""
        with self._reading() as handle:
            return handle.dimension

    @property
    def coplanar(self) -> IndexArray:
        """Points that are no vertices because they are equal to one, int32, shape (m, 3).

        The columns are the point, a simplex that has its vertex (-1 if there are no simplices),
        and the vertex. SciPy lists here also points that Qhull drops; mgdt drops none.
        """

        def find() -> Any:
            point_map, tetrahedra = self._fresh("point_map", "tetrahedra")
            own = np.arange(len(point_map), dtype=np.int32)
            points = np.flatnonzero((point_map != own) & (point_map >= 0))
            vertices = point_map[points]
            simplices = _simplex_of_each(tetrahedra, point_map)[vertices]
            return np.stack([points, simplices, vertices], axis=1).astype(np.int32)

        rows: IndexArray = self._cached("coplanar", find)
        return rows

    # Tetrahedra

    @property
    def simplices(self) -> IndexArray:
        """Vertices of the tetrahedra, int32, shape (nsimplex, 4), positively oriented."""
        array: IndexArray = self._exported("tetrahedra")
        return array

    @property
    def neighbors(self) -> IndexArray:
        """Neighbours of the tetrahedra, int32, shape (nsimplex, 4): the k-th shares the facet
        opposite the k-th vertex; -1 at the hull."""
        array: IndexArray = self._exported("neighbors")
        return array

    @property
    def convex_hull(self) -> IndexArray:
        """Triangles of the convex hull, int32, shape (m, 3), counter-clockwise seen from
        outside."""
        array: IndexArray = self._exported("hull_facets")
        return array

    @property
    def edges(self) -> IndexArray:
        """Edges, int32, shape (m, 2), the lesser vertex first; each once. Not in SciPy."""
        array: IndexArray = self._exported("edges")
        return array

    @property
    def vertex_to_simplex(self) -> IndexArray:
        """For each point one of the simplices around it, int32, shape (npoints,).

        For a point equal to an earlier one it is the simplex of the vertex that stands for it, as
        in `coplanar`. SciPy gives the number of that vertex in its place. -1 for points that
        are not in, and where there are no simplices.
        """

        def find() -> IndexArray:
            return _simplex_of_each(*self._fresh("tetrahedra", "point_map"))

        return self._cached("vertex_to_simplex", find)

    @property
    def vertex_neighbor_vertices(self) -> tuple[IndexArray, IndexArray]:
        """Neighbours of the vertices as two int32 arrays: those of vertex k are
        ``indices[indptr[k]:indptr[k + 1]]`` of ``(indptr, indices)``, ascending."""
        lists: tuple[IndexArray, IndexArray] = self._exported("vertex_neighbors")
        return lists

    @property
    def gabriel_edges(self) -> IndexArray:
        """Edges of the Gabriel graph, int32, shape (m, 2), sorted: those that are the diameter of a
        sphere with no vertex inside, decided exactly. Not in SciPy. Since 1.2."""
        array: IndexArray = self._exported("gabriel_edges")
        return array

    @property
    def spanning_tree(self) -> IndexArray:
        """Edges of the Euclidean minimum spanning tree, int32, shape (m, 2), sorted. Lengths are
        compared exactly. Empty without simplices. Not in SciPy. Since 1.2."""
        array: IndexArray = self._exported("spanning_tree")
        return array

    @property
    def circumcenters(self) -> FloatArray:
        """Centres of the simplices' circumspheres, shape (nsimplex, 3): vertices of the Voronoi
        diagram.

        Each coordinate is the double nearest to the exact one, and infinite beyond the largest. So
        simplices with one circumsphere, as in a lattice, have equal rows. Not in SciPy. Since 1.2.
        """
        centers: FloatArray = self._exported("circumcenters")[0]
        return centers

    @property
    def circumradii(self) -> FloatArray:
        """Radii of the circumspheres, shape (nsimplex,): square roots of doubles that are nearest
        to the exact squares. Not in SciPy. Since 1.2."""

        def roots() -> FloatArray:
            squares: FloatArray = self._fresh("circumcenters")[0][1]
            radii: FloatArray = np.sqrt(squares)
            return radii

        return self._cached("circumradii", roots)

    def squared_alphas(self, dimension: int) -> FloatArray:
        """Squares of the radii at which simplices join the alpha shape, as `gudhi.AlphaComplex` has.

        That of the least sphere through the vertices of a simplex if no vertex is inside it, decided
        exactly; else the least of the simplices that it is a face of. Not in SciPy. Since 1.2.

        Parameters
        ----------
        dimension : int
            3 for the simplices, shape (nsimplex,); 2 for the facets opposite their vertices,
            shape (nsimplex, 4); 1 for `edges`; 0 for the points.
        """
        dimension = whole(dimension, "dimension", 0, 3)
        return self._read(lambda handle, _: handle.alphas(dimension), self.npoints >= _LONG_CHECK)

    def alpha_surface(self, alpha: float) -> IndexArray:
        """Facets between the simplices with circumradii of at most `alpha` and all others, int32,
        shape (m, 3), counter-clockwise seen from outside: a closed surface. Not in SciPy. Since
        1.2."""
        number = as_number(alpha, "alpha")
        return self._surface(number * number)

    def _surface(self, alpha2: float) -> IndexArray:
        return self._read(
            lambda handle, _: handle.alpha_surface(alpha2), self.npoints >= _LONG_CHECK
        )

    @property
    def squared_solid_alpha(self) -> float:
        """The least squared alpha whose simplices are one solid with all vertices. Since 1.2."""
        alpha2: float = self._exported("solid_alpha")
        return alpha2

    def tetrahedron_measures(self, measure: str) -> FloatArray:
        """Measures each tetrahedron.

        The error of a number is less than 1e-12 of it, and that of an angle less than 1e-12, however
        flat the tetrahedron is. Not in SciPy. Since 1.3.

        Parameters
        ----------
        measure : str
            "volume"; "radius_ratio", 3 times the radius of the inscribed sphere over that of the
            circumsphere, which is 1 for a regular tetrahedron and near 0 for a flat one;
            "least_dihedral_angle" or "largest_dihedral_angle" of the six dihedral angles, in radians; or
            "longest_edge", its length; since 1.4 "volume_length", 6 sqrt(2) times the volume over the
            third power of the root mean square of the edges, and "edge_ratio", the longest edge over
            the shortest one.

        Returns
        -------
        ndarray
            Shape (nsimplex,).
        """
        if measure not in TETRAHEDRON_MEASURES:
            raise ValueError(
                f"there is no measure {measure!r}; there are {', '.join(TETRAHEDRON_MEASURES)}"
            )
        return self._read(
            lambda handle, _: handle.tetrahedron_measures(measure), self.npoints >= _LONG_CHECK
        )

    def peel_flat(self, tolerance: float = 1e-9) -> BoolArray:
        """Says which tetrahedra stay when flat ones are peeled off the hull, one layer after another.

        The skin of points with rounded coordinates, such as those of a block that was turned, has
        tetrahedra of four points that were in one plane. Flat tetrahedra inside stay, so what is
        left has no holes. Not in SciPy. Since 1.3.

        Parameters
        ----------
        tolerance : float
            Tetrahedra whose radius ratio is less are flat; see `tetrahedron_measures`.

        Returns
        -------
        ndarray of bool
            Shape (nsimplex,). ``tri.simplices[stays]`` are the tetrahedra that stay, and
            ``np.count_nonzero(~stays)`` is the number of the others.
        """
        neighbors = self.neighbors
        stays = np.ones(len(neighbors), dtype=bool)
        flat = self.tetrahedron_measures("radius_ratio") < tolerance
        layer = np.flatnonzero(flat & (neighbors < 0).any(axis=1))
        while len(layer) > 0:
            stays[layer] = False
            behind = np.unique(neighbors[layer])
            behind = behind[behind >= 0]
            layer = behind[flat[behind] & stays[behind]]
        return stays

    def cell_measures(self, measure: str, planes: Optional[ArrayLike] = None) -> FloatArray:
        """Measures the Voronoi cell of each point: what is nearer to it than to any other.

        The same numbers on every run and with any number of threads. Volumes and areas are off by
        less than 1e-12 of themselves, centroids by less than 1e-12 of the size of the cell. A point
        that is no vertex has 0. Not in SciPy. Since 1.2.

        Parameters
        ----------
        measure : str
            "volume", "area" (of the surface), "centroid" or "faces" (their number).
        planes : array_like of float, shape (n, 4), optional
            Bound the region that cells are clipped to: a, b, c, d each, where
            a x + b y + c z <= d. No point may be outside. Without them cells of hull vertices have
            no end, and their measures are infinite but for faces.

        Returns
        -------
        ndarray
            Shape (npoints,), or (npoints, 3) of centroids.
        """
        if measure not in MEASURES:
            raise ValueError(f"there is no measure {measure!r}; there are {', '.join(MEASURES)}")
        rows = as_planes(planes)
        return self._read(
            lambda handle, _: handle.cell_measures(measure, rows), self.npoints >= _LONG_CHECK
        )

    @property
    def transform(self) -> FloatArray:
        """Barycentric transforms, shape (nsimplex, 4, 3).

        ``c = transform[i, :3] @ (x - transform[i, 3])`` are the weights at x of the first three
        vertices of simplex i, ``1 - c.sum()`` is that of the fourth. Entries are those of exact
        arithmetic, rounded, for simplices however flat; of others they are off by less than 1e-11
        of the largest in their row. An entry beyond the largest double is infinite. SciPy gives NaN
        for flat simplices.

        The weights of a flat simplex are small sums of large products, which doubles round. Those
        of `locate` are better.
        """
        return self._cached(
            "transform",
            lambda: _geometry.barycentric_transforms(self.points, self._fresh("tetrahedra")[0]),
        )

    # The paraboloid

    def _paraboloid(self) -> tuple[float, float]:
        return self._cached("paraboloid", lambda: _geometry.paraboloid(self.points))

    @property
    def paraboloid_scale(self) -> float:
        """Factor of the squared length in `lift_points`."""
        return self._paraboloid()[0]

    @property
    def paraboloid_shift(self) -> float:
        """What is added to it."""
        return self._paraboloid()[1]

    @property
    def equations(self) -> FloatArray:
        """Hyperplanes through the lifted simplices, shape (nsimplex, 5): a unit normal in four
        dimensions, pointing down, and the offset."""
        return self._cached(
            "equations",
            lambda: _geometry.hyperplanes(
                self.points, self._fresh("tetrahedra")[0], *self._paraboloid()
            ),
        )

    def lift_points(self, x: ArrayLike) -> FloatArray:
        """Lifts places, shape (..., 3), to the paraboloid, shape (..., 4). Since 1.0."""
        places, shape = as_places(x, "x")
        return _geometry.lift(places, *self._paraboloid()).reshape(shape + (4,))

    def plane_distance(self, xi: ArrayLike) -> FloatArray:
        """Distances of lifted places from all hyperplanes.

        Parameters
        ----------
        xi : array_like of float, shape (..., 3)

        Returns
        -------
        ndarray of float64, shape (..., nsimplex)
            Positive where the place is inside the simplex's circumsphere, up to rounding.
        """
        lifted = self.lift_points(xi)
        equations = self.equations
        distances: FloatArray = lifted @ equations[:, :4].T + equations[:, 4]
        return distances

    # Queries

    def find_simplex(
        self, xi: ArrayLike, bruteforce: bool = False, tol: Optional[float] = None
    ) -> IndexArray:
        """Finds the simplices that contain places.

        Parameters
        ----------
        xi : array_like of float, shape (..., 3)
        bruteforce : bool, optional
            Has no effect: the result is exact.
        tol : float, optional
            Takes also places outside the hull, in a simplex in which they have no barycentric
            weight below -`tol`, up to rounding by 1e-11. None, the default, and 0 take none. Up to
            a `tol` of 2**-20 a place is taken if there is such a simplex anywhere. With a larger
            one a walk towards the place takes the first that it finds, as in SciPy, and may find
            none.

        Returns
        -------
        ndarray of int32, shape (...)
            Numbers of simplices; -1 outside, and where a coordinate is NaN or infinite. On a
            shared facet, edge or vertex it is one of those that share it.

        Notes
        -----
        Many places in one call are much faster than one by one. Since 1.0.
        """
        places, shape = as_places(xi, "xi")
        tolerance = 0.0 if tol is None else as_number(tol, "tol")
        found = self._locate_finite(places, None)
        if tolerance:
            outside = np.flatnonzero((found < 0) & finite_rows(places))
            with self._reading() as handle:
                found[outside] = in_tolerance(
                    places[outside],
                    tolerance,
                    self.points,
                    self._kept(handle, "hull_facets"),
                    handle.locate_finite,
                    lambda: (self._kept(handle, "tetrahedra"), self._kept(handle, "neighbors")),
                )
        return found.reshape(shape)

    @overload
    def locate(
        self, points: ArrayLike, weights: Literal[True] = ...
    ) -> tuple[IndexArray, FloatArray]: ...

    @overload
    def locate(self, points: ArrayLike, weights: Literal[False]) -> IndexArray: ...

    @overload
    def locate(
        self, points: ArrayLike, weights: bool
    ) -> Union[IndexArray, tuple[IndexArray, FloatArray]]: ...

    def locate(
        self, points: ArrayLike, weights: bool = True
    ) -> Union[IndexArray, tuple[IndexArray, FloatArray]]:
        """Finds the simplices that contain places, and barycentric weights in them.

        Parameters
        ----------
        points : array_like of float, shape (..., 3)
        weights : bool, optional
            Whether to return weights.

        Returns
        -------
        simplices : ndarray of int32, shape (...)
            As `find_simplex`.
        weights : ndarray of float64, shape (..., 4)
            In the order of the vertices in `simplices`; they add up to 1 within rounding, and are
            zeros outside. Only if asked for.
        """
        places, shape = as_places(points, "points")
        room = np.empty((len(places), 4)) if weights else None
        found = self._locate_finite(places, room).reshape(shape)
        return found if room is None else (found, room.reshape(shape + (4,)))

    def _locate_finite(self, places: FloatArray, weights: Optional[FloatArray]) -> IndexArray:
        """Locates rows; those that are not finite are outside."""

        def find(handle: Handle, is_left: Callable[[], bool]) -> IndexArray:
            return handle.locate_finite(places, weights, is_left)

        return self._read(find, len(places) >= _LONG_LOCATION)

    def traverse_segment(self, a: ArrayLike, b: ArrayLike) -> tuple[IndexArray, FloatArray]:
        """Finds the simplices that the segment from `a` to `b` passes through, in order, exactly.

        Parameters
        ----------
        a, b : array_like of float, shape (3,)

        Returns
        -------
        simplices : ndarray of int32, shape (m,)
            Empty if the segment misses the hull.
        parameters : ndarray of float64, shape (m + 1,), or (0,) if m is 0
            The segment enters ``simplices[k]`` at ``a + parameters[k] * (b - a)`` and leaves it at
            ``a + parameters[k + 1] * (b - a)``. Each parameter is correctly rounded.

        Raises
        ------
        ValueError
            If a coordinate is NaN or infinite.

        Notes
        -----
        A simplex that the segment meets in one point is left out. Where the segment runs in a facet
        or an edge, one simplex beside it is named. Not in SciPy. Since 1.3.
        """
        ends = []
        for name, point in (("a", a), ("b", b)):
            places, shape = as_places(point, name)
            if shape != ():
                raise ValueError(f"{name} must be one point, shape (3,)")
            if not np.isfinite(places).all():
                raise ValueError(f"a coordinate of {name} is not finite")
            ends.append(places)

        def find(
            handle: Handle, _: Callable[[], bool]
        ) -> tuple[IndexArray, FloatArray]:
            return handle.traverse_segment(ends[0], ends[1])

        return self._read(find, False)

    def nearest_vertex(self, points: ArrayLike) -> IndexArray:
        """Finds the vertices nearest to places, exactly; of several as near the lowest index.

        Parameters
        ----------
        points : array_like of float, shape (..., 3)

        Returns
        -------
        ndarray of int32, shape (...)
            -1 if there are no points, and where a coordinate is NaN or infinite.
        """
        places, shape = as_places(points, "points")

        def find(handle: Handle, is_left: Callable[[], bool]) -> IndexArray:
            return handle.nearest_vertices(places, is_left)

        # Where there are no tetrahedra each place is compared with each vertex.
        steps = len(places) * (1 if self.nsimplex else 1 + self.npoints // 64)
        return self._read(find, steps >= _LONG_LOCATION).reshape(shape)

    def interpolator(self, points: ArrayLike) -> Interpolator:
        """Locates places once, for interpolation of many sets of values there.

        Parameters
        ----------
        points : array_like of float, shape (..., 3)
            One with a coordinate that is NaN or infinite counts as outside the hull.

        Returns
        -------
        Interpolator
        """
        places, shape = as_places(points, "points")
        weights = np.empty((len(places), 4))

        def find(handle: Handle, is_left: Callable[[], bool]) -> tuple[IndexArray, IndexArray]:
            return handle.locate_finite(places, weights, is_left), self._kept(handle, "tetrahedra")

        simplices, tetrahedra = self._read(find, len(places) >= _LONG_LOCATION)
        return Interpolator(
            self.npoints, tetrahedra, simplices.reshape(shape), weights.reshape(shape + (4,))
        )

    def interpolate(
        self,
        values: ArrayLike,
        points: ArrayLike,
        fill_value: complex = np.nan,
        method: str = "linear",
        outside: str = "none",
    ) -> NDArray[Any]:
        """Interpolates values at the points: linearly in each simplex, or in another way.

        Parameters
        ----------
        values : array_like of float or complex, shape (npoints, ...)
            Those of points that are no vertices are not used.
        points : array_like of float, shape (..., 3)
            Where to interpolate.
        fill_value : number, optional
            The result where there is no value: outside the hull, unless `outside` says more, and where
            a coordinate is NaN or infinite.
        method : str, optional
            "linear"; "nearest", the value of the nearest vertex; "sibson" or "laplace", by natural
            neighbours; "sibson_c1", Sibson's with gradients, which is smooth at the points too.
            Since 1.2.
        outside : str, optional
            What is outside the hull: "none"; "nearest", the value of the nearest vertex;
            "boundary", that of the nearest place of the hull; "linear", the same and on with the
            gradient there. Since 1.2.

        Returns
        -------
        ndarray
            Shape of `points` without its last axis, then that of `values` without its first.

        Notes
        -----
        A place is in the hull or not, exactly: one that should lie on its boundary and is off by
        rounding may have no value. `mgdt.LinearNDInterpolator` has a tolerance, as SciPy's, and so
        has ``outside="boundary"``, which has no end. Methods but "nearest" raise
        `mgdt.ArgumentError` for points in one plane.
        """
        self._require_manner(method, outside)
        return self._interpolate(Prepared(values, self.npoints), points, fill_value, method, outside)

    def _interpolate(
        self,
        values: Prepared,
        points: ArrayLike,
        fill_value: complex,
        method: str,
        outside: str,
        tolerance: float = 0.0,
    ) -> NDArray[Any]:
        """Places outside the hull by at most the tolerance have the value of the nearest one in it."""
        as_fill_value(fill_value)
        places, shape = as_places(points, "points")
        finite = finite_rows(places)
        some = places if finite.all() else np.ascontiguousarray(places[finite])
        # Not within the call below, which reads already.
        box = self._bounds() if tolerance > 0 else None
        own = self.points

        def find(handle: Handle, is_left: Callable[[], bool]) -> FloatArray:
            found = handle.interpolate(method, outside, values.rows, some, is_left)
            if box is not None and not is_left() and np.isnan(found[:, -1]).any():
                _bring_in(handle, method, values.rows, own, box, some, found, tolerance)
            return found

        found = self._read(find, len(places) >= _LONG_LOCATION)
        return values.result(found, finite, fill_value).reshape(shape + values.shape)

    def _require_manner(self, method: str, outside: str) -> None:
        for name, value, known in (("method", method, METHODS), ("outside", outside, OUTSIDES)):
            if value not in known:
                raise ValueError(f"{name} is {value!r}; it must be one of {', '.join(known)}")

    def interpolation_weights(
        self, points: ArrayLike, method: str = "linear", outside: str = "none"
    ) -> tuple[IndexArray, IndexArray, FloatArray]:
        """The same as weights, for values that come later: a sparse matrix by rows.

        Parameters
        ----------
        points : array_like of float, shape (m, 3)
            One with a coordinate that is NaN or infinite has no weights.
        method, outside : str, optional
            As `interpolate`.

        Returns
        -------
        offsets : ndarray of int32, shape (m + 1,)
        indices : ndarray of int32
        weights : ndarray of float64
            Place i has the value of point indices[k] with weights[k], for k from offsets[i] to
            before offsets[i + 1]. So ``scipy.sparse.csr_array((weights, indices, offsets), (m,
            npoints))`` times values is the values at the places, and its transpose carries loads
            from the places to the points.

        Notes
        -----
        Since 1.2.
        """
        self._require_manner(method, outside)
        places = as_places(points, "points")[0]
        finite = finite_rows(places)
        some = places if finite.all() else np.ascontiguousarray(places[finite])
        offsets, indices, weights = self._read(
            lambda handle, _: handle.interpolation_weights(method, outside, some),
            len(places) >= _LONG_LOCATION // 16,
        )
        if len(some) < len(places):
            counts = np.zeros(len(places) + 1, dtype=np.int32)
            counts[1:][finite] = np.diff(offsets)
            offsets = np.cumsum(counts, dtype=np.int32)
        return offsets, indices, weights

    def gradients(self, values: ArrayLike) -> NDArray[Any]:
        """Gradients of values at the points.

        Those of the linear functions through the vertices' values that are nearest to their
        neighbours' in the sense of least squares of differences over distances.

        Parameters
        ----------
        values : array_like of float or complex, shape (npoints, ...)

        Returns
        -------
        ndarray, shape (npoints, ..., 3)
            NaN for points that are not in.

        Notes
        -----
        Since 1.2.
        """
        given, rows = as_fields(values, self.npoints)
        found = self._read(lambda handle, _: handle.gradients(rows), self.npoints >= _LONG_CHECK)
        if given.dtype.kind == "c":
            pairs = found.reshape(self.npoints, -1, 2, 3)
            found = pairs[:, :, 0] + 1j * pairs[:, :, 1]
        return found.reshape(given.shape + (3,))

    # Trust and figures

    def check(self, level: int = 3) -> None:
        """Proves by exact arithmetic that the triangulation is what it claims to be.

        Parameters
        ----------
        level : int, optional
            1 adjacency and counts, 2 also orientation and the Delaunay property at every facet,
            3 also the convex hull and ties.

        Raises
        ------
        mgdt.CheckFailed
            The message says what is wrong and where.
        """
        level = whole(level, "level", 1, 3)
        self._read(lambda handle, _: handle.check(level), self.npoints >= _LONG_CHECK)

    @property
    def statistics(self) -> dict[str, float]:
        """Figures about the work done and the memory held, by name: counts, seconds, bytes."""
        with self._reading() as handle:
            return handle.statistics()

    @property
    def isa(self) -> str:
        """Instruction set of the kernel in use."""
        with self._reading() as handle:
            return handle.isa()

    # Other packages

    def __array__(self, dtype: Any = None, **_: Any) -> NDArray[Any]:
        # An array of objects may hold this one. Any other is a mistake, which NumPy would hide.
        if dtype == np.dtype(object):
            array = np.empty((), dtype=object)
            array[()] = self
            return array
        raise TypeError(
            "a mgdt.Delaunay is no array; for scipy.interpolate.LinearNDInterpolator and others that "
            "take a scipy.spatial.Delaunay, give them to_scipy() of it"
        )

    def to_scipy(self) -> Any:
        """A ``scipy.spatial.Delaunay`` with these points and simplices, made without Qhull.

        For ``scipy.interpolate.LinearNDInterpolator`` and what else asks for SciPy's class. See
        `mgdt.export.to_scipy`. Since 1.2.
        """
        return export.to_scipy(self)

    def to_meshio(self) -> Any:
        """A ``meshio.Mesh`` of all points and the tetrahedra. ImportError without meshio."""
        return export.to_meshio(self)

    def to_pyvista(self) -> Any:
        """A ``pyvista.UnstructuredGrid`` of all points and the tetrahedra. ImportError without
        PyVista."""
        return export.to_pyvista(self)
