# SPDX-License-Identifier: MIT
"""Points in periodic boxes: their triangulation and their Voronoi cells."""

from __future__ import annotations

import ctypes
from ctypes import c_void_p
from functools import cached_property, partial
from typing import Any, Callable, Optional, Sequence, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import FloatArray, IndexArray, address, as_array, as_points
from ._building import build
from ._diagram import Diagram, cell_areas, lists, taken_diagram
from ._gate import Gate, interruptibly
from ._interface import CONSTANTS
from ._keyed import Keyed
from ._triangulation import LONG_EXPORT

_T = TypeVar("_T")


def _vectors(box: ArrayLike, periodic: Optional[Sequence[bool]]) -> FloatArray:
    """The vectors in which a box repeats, as rows."""
    array = np.asarray(as_array(box, "box"))
    if array.dtype.kind not in "biuf":
        raise TypeError(f"box must be real numbers, not {array.dtype}")
    array = array.astype(np.float64)
    if array.shape == (3,):
        array = np.diag(array)
    if array.ndim != 2 or array.shape[1] != 3 or not 1 <= len(array) <= 3:
        raise ValueError(
            f"box must be three lengths, or one to three vectors as rows, not of shape {array.shape}"
        )
    if periodic is not None:
        chosen = np.asarray(periodic)
        if chosen.dtype != np.bool_ or chosen.shape != (len(array),) or not chosen.any():
            raise ValueError(
                f"periodic must have a bool for each vector, at least one of them true, not {periodic!r}"
            )
        array = array[chosen]
    return np.ascontiguousarray(array)


class _Box(Keyed):
    """A periodic box of the library."""

    kind = "periodic"

    def __init__(self) -> None:
        super().__init__(self._create())

    def set_vectors(self, vectors: FloatArray) -> None:
        self.call("set_vectors", len(vectors), address(vectors))

    def measures(self, name: str, size: int) -> FloatArray:
        values = np.empty(size)
        self.call("get_cell_measures", CONSTANTS["measure"][name], size, address(values))
        return values

    def voronoi(self, area: float, share: float) -> dict[str, NDArray[Any]]:
        diagram = c_void_p()
        self.call("create_voronoi", ctypes.byref(diagram))
        return taken_diagram(diagram, area, share)


class PeriodicDelaunay:
    """Delaunay triangulation of points in a periodic box: of the infinite set of their images.

    Since 1.3.

    Parameters
    ----------
    points : array_like of float, shape (n, 3)
        They may lie anywhere, also outside of the box.
    box : array_like of float
        Three lengths, of a box along the axes; or one to three vectors as rows, of any shape. A cell of
        ASE (``atoms.cell``) is three vectors.
    periodic : sequence of bool, optional
        Which of the vectors repeat, such as ``atoms.pbc``. By default all do. With two it is a slab, with
        one a wire.
    threads : int
        0 for all cores.
    memory_limit : int
        Bytes; 0 for none.
    merge_distance : float
        Points that have images within this distance of an earlier point become equal to it, in the order
        of the points. 0 for none. For points on the faces of an oblique box, such as those at the
        fractional coordinates 0 and 1, whose images differ by rounding.
    progress : callable, optional
        Called as ``progress(fraction)`` with 0 to 1; the result ``mgdt.CANCEL`` cancels.

    Attributes
    ----------
    points : ndarray of float, shape (n, 3)
        The points where they were put, rounded to at most 2^-47 of the size of the box along each axis.
    vectors : ndarray of float, shape (1 to 3, 3)
        The vectors that repeat, rounded likewise.
    simplices : ndarray of int, shape (ntets, 4)
        The corners of one tetrahedron of each class of tetrahedra that differ by multiples of the vectors.
    shifts : ndarray of int, shape (ntets, 4, 3)
        How often each vector has to be added to the point of a corner to get the corner. 0 for the first
        corner, and for vectors that there are not.
    neighbors : ndarray of int, shape (ntets, 4)
        The tetrahedra opposite the corners; -1 where a slab or a wire ends.
    neighbor_shifts : ndarray of int, shape (ntets, 4, 3)
        The multiples by which a neighbour is moved to be there.

    Examples
    --------
    >>> import mgdt
    >>> crystal = mgdt.PeriodicDelaunay([[0, 0, 0], [1, 1, 1]], [2, 2, 2])
    >>> crystal
    <mgdt.PeriodicDelaunay: 2 points, 3 vectors, 12 tetrahedra>
    >>> crystal.volumes.tolist(), crystal.face_counts.tolist()
    ([4.0, 4.0], [14, 14])
    """

    def __init__(
        self,
        points: ArrayLike,
        box: ArrayLike,
        periodic: Optional[Sequence[bool]] = None,
        *,
        threads: int = 1,
        memory_limit: int = 0,
        merge_distance: float = 0.0,
        progress: Optional[Callable[[float], Any]] = None,
    ) -> None:
        rows = np.array(as_points(points), np.float64, order="C")
        self.progress = progress
        settings = {"threads": threads, "memory_limit": memory_limit}
        self._make(rows, _vectors(box, periodic), settings, float(merge_distance))

    def _make(
        self, rows: FloatArray, vectors: FloatArray, settings: dict[str, int], merge_distance: float
    ) -> None:
        self._given, self._given_vectors, self._settings = rows, vectors, settings
        self._merge_distance = merge_distance
        self._gate = Gate()
        handle = self._box = _Box()
        handle.set_vectors(vectors)
        for name, value in settings.items():
            handle.set_option(name, value)
        handle.call("set_merge_distance", merge_distance)
        self._build(rows, lambda: handle.call("insert_points", len(rows), address(rows)))

    def _build(self, rows: FloatArray, place: Callable[[], None]) -> None:
        """Puts the points at new places, and builds."""

        def change() -> None:
            place()
            # What was fetched is forgotten first: if the build is stopped, there is no triangulation.
            self._given = rows
            self._cache: dict[str, Any] = {}

        build(self._box, self._gate, self.progress, len(rows), change)

    def _aside(self, work: Callable[[], _T]) -> _T:
        """Reads, beside other readers; signals interrupt it where there are many points."""

        def read(is_left: Callable[[], bool]) -> _T:
            with self._gate.reading(is_left):
                return work()

        self._gate.refuse_if_kept_out()
        return interruptibly(read, len(self._given) >= LONG_EXPORT)

    def _cached(self, name: str, make: Callable[[], _T]) -> _T:
        # An array made while another thread moves points belongs to the cache of before.
        cache = self._cache
        if name not in cache:
            cache[name] = self._aside(make)
        value: _T = cache[name]
        return value

    # Copies are built again from what was given, and share nothing with the original.

    def __getstate__(self) -> dict[str, Any]:
        return {
            "points": self._given,
            "vectors": self._given_vectors,
            "settings": self._settings,
            "merge_distance": self._merge_distance,
        }

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.progress = None
        self._make(
            state["points"].copy(),
            state["vectors"].copy(),
            dict(state["settings"]),
            state["merge_distance"],
        )

    @property
    def points(self) -> FloatArray:
        """The points where they were put, rounded."""
        return self._cached("points", lambda: self._box.array("points"))

    @property
    def vectors(self) -> FloatArray:
        """The vectors that repeat, rounded."""
        return self._cached("vectors", lambda: self._box.array("vectors"))

    @property
    def simplices(self) -> IndexArray:
        """The corners of one tetrahedron of each class."""
        return self._cached("simplices", lambda: self._box.array("tetrahedra"))

    @property
    def shifts(self) -> IndexArray:
        """The multiples of the vectors that are added to the points of the corners."""
        return self._cached("shifts", lambda: self._box.array("tetrahedron_shifts").reshape(-1, 4, 3))

    @property
    def neighbors(self) -> IndexArray:
        """The tetrahedra opposite the corners; -1 where a slab or a wire ends."""
        return self._cached("neighbors", lambda: self._box.array("neighbors"))

    @property
    def neighbor_shifts(self) -> IndexArray:
        """The multiples by which a neighbour is moved to be there."""
        return self._cached(
            "neighbor_shifts", lambda: self._box.array("neighbor_shifts").reshape(-1, 4, 3)
        )

    def move(
        self,
        points: ArrayLike,
        box: Optional[ArrayLike] = None,
        periodic: Optional[Sequence[bool]] = None,
    ) -> None:
        """Moves all points, as in a time step, and sets other vectors of the box, if there are any. What was computed before is forgotten. The triangulation
        starts with the images that the last one needed. If the call is stopped or fails after the points
        have moved, there is no triangulation until the next one, and attributes raise `NotBuiltError`.

        Parameters
        ----------
        points : array_like of float, shape (n, 3)
            Where they are now.
        box, periodic : optional
            As for the constructor: what the box is now. By default its vectors stay.
        """
        rows = np.array(as_points(points), np.float64, order="C")
        if box is None and periodic is not None:
            raise TypeError("periodic is of a box, which is not given")
        vectors = None if box is None else _vectors(box, periodic)

        def place() -> None:
            if len(rows) != len(self._given):
                raise ValueError(f"{len(rows)} places are given for all points, which are {len(self._given)}")
            if vectors is not None:
                bad = np.flatnonzero(~np.isfinite(rows).all(axis=1))
                if len(bad):
                    raise ValueError(f"point {bad[0]} has a coordinate that is not finite")
                self._box.set_vectors(vectors)
                self._given_vectors = vectors
            self._box.call("move_points", len(rows), None, address(rows))

        self._build(rows, place)

    def check(self) -> None:
        """Proves the triangulation, exactly.

        Raises
        ------
        CheckFailed
            If it has a defect. The message says what and where.
        """
        self._aside(partial(self._box.call, "check"))

    def places(self, simplices: Any = slice(None)) -> FloatArray:
        """The coordinates of the corners of tetrahedra, of shape (m, 4, 3).

        Parameters
        ----------
        simplices : index, optional
            Which of them, as an index of `simplices`; all by default.
        """
        shifts = self.shifts[simplices][..., : len(self.vectors)]
        corners: FloatArray = self.points[self.simplices[simplices]] + shifts @ self.vectors
        return corners

    @property
    def point_map(self) -> IndexArray:
        """For each point the least point with the same images."""
        return self._cached("point_map", lambda: self._box.array("point_map"))

    @property
    def point_shifts(self) -> NDArray[np.int64]:
        """The multiples of the vectors that are added to that point to get this one, shape (n, 3)."""
        return self._cached("point_shifts", lambda: self._box.array("point_shifts", np.int64))

    @property
    def vertex_neighbor_vertices(self) -> tuple[IndexArray, IndexArray]:
        """Two arrays: the points at the other ends of the edges at point k are
        ``indices[indptr[k]:indptr[k + 1]]``. A point may come several times, as several images."""
        handle = self._box
        names = "vertex_neighbor_offsets", "vertex_neighbors"
        return self._cached(
            "vertex_neighbor_vertices", lambda: (handle.array(names[0]), handle.array(names[1]))
        )

    @property
    def vertex_neighbor_shifts(self) -> IndexArray:
        """The shift of each of the ``indices``, shape (m, 3)."""
        return self._cached("vertex_neighbor_shifts", lambda: self._box.array("vertex_neighbor_shifts"))

    @property
    def volumes(self) -> FloatArray:
        """Volumes of the points' Voronoi cells. With three vectors their sum is that of the box."""
        return self._cached("volumes", lambda: self._box.measures("volume", len(self._given)))

    @property
    def areas(self) -> FloatArray:
        """Areas of the surfaces of the cells."""
        return self._cached("areas", lambda: self._box.measures("area", len(self._given)))

    @property
    def centroids(self) -> FloatArray:
        """Centroids of the cells, relative to the points, shape (n, 3)."""
        return self._cached(
            "centroids", lambda: self._box.measures("centroid", 3 * len(self._given)).reshape(-1, 3)
        )

    @property
    def face_counts(self) -> IndexArray:
        """How many faces each cell has."""
        return self._cached(
            "face_counts", lambda: self._box.measures("faces", len(self._given)).astype(np.int32)
        )

    def __repr__(self) -> str:
        k = len(self._given_vectors)
        return (
            f"<mgdt.PeriodicDelaunay: {len(self._given)} points, {k} vector{'' if k == 1 else 's'}, "
            f"{self._aside(lambda: self._box.statistic('tetrahedra'))} tetrahedra>"
        )


class PeriodicVoronoi(Diagram):
    """Voronoi diagram of points in a periodic box.

    Each cell is where its point is. Where it meets an image of another cell, or of itself, it has that
    face for itself. What has a name in `Voronoi` means the same here.

    Since 1.3.

    Parameters
    ----------
    points : array_like of float, shape (n, 3), or PeriodicDelaunay
    box, periodic
        As `PeriodicDelaunay`; not with a triangulation, which has them.
    least_area, least_share : float, optional
        As `Voronoi`: smaller faces are left out.
    **settings
        Of `PeriodicDelaunay`.

    Attributes
    ----------
    delaunay : PeriodicDelaunay
    ridge_shifts : ndarray of int, shape (nridges, 3)
        How often each vector has to be added to the second point of a face to get the image on the other
        side.

    Examples
    --------
    >>> import mgdt
    >>> cells = mgdt.PeriodicVoronoi([[0.5, 0.5, 0.5]], [1, 1, 1])
    >>> cells
    <mgdt.PeriodicVoronoi: 1 points, 8 vertices, 6 faces>
    >>> cells.ridge_shifts[0].tolist(), float(cells.volumes[0])
    ([-1, 0, 0], 1.0)
    """

    def __init__(
        self,
        points: Any,
        box: Optional[ArrayLike] = None,
        periodic: Optional[Sequence[bool]] = None,
        *,
        least_area: float = 0.0,
        least_share: float = 0.0,
        **settings: Any,
    ) -> None:
        if isinstance(points, PeriodicDelaunay):
            if box is not None or periodic is not None or settings:
                raise TypeError("a PeriodicDelaunay object has its box and its settings already")
            self.delaunay = points
        else:
            if box is None:
                raise TypeError("box is needed with points")
            self.delaunay = PeriodicDelaunay(points, box, periodic, **settings)
        if not least_area >= 0:
            raise ValueError(f"least_area is {least_area!r}; it must be at least 0")
        if not 0 <= least_share < 1:
            raise ValueError(f"least_share is {least_share!r}; it must be at least 0 and below 1")
        handle, limits = self.delaunay._box, (float(least_area), float(least_share))

        # All of one state, while another thread may move the points.
        def read() -> tuple[FloatArray, FloatArray, IndexArray, dict[str, NDArray[Any]]]:
            rows, vectors = handle.array("points"), handle.array("vectors")
            return rows, vectors, handle.array("point_map"), handle.voronoi(*limits)

        self.points, self._vectors, self._point_map, self._arrays = self.delaunay._aside(read)
        self._begin()
        self.ridge_shifts: IndexArray = self._arrays["face_shifts"]

    def _aside(self, work: Callable[[Callable[[], bool]], _T]) -> _T:
        return interruptibly(work, len(self.points) >= LONG_EXPORT)

    @cached_property
    def areas(self) -> FloatArray:
        """Areas of the surfaces of the cells, with the faces that are left out."""
        return self._arrays["cell_areas"] if "cell_areas" in self._arrays else cell_areas(self._arrays)

    @cached_property
    def neighbor_shifts(self) -> list[list[list[int]]]:
        """The shifts of the points in `neighbors`."""
        neighbors = self.neighbor_list
        return self._aside(partial(lists, neighbors.shifts, neighbors.indptr))

    def _places(self, points: IndexArray, shifts: IndexArray) -> FloatArray:
        return self.points[points] + shifts[:, : len(self._vectors)] @ self._vectors

    def __repr__(self) -> str:
        return (
            f"<mgdt.PeriodicVoronoi: {self.npoints} points, {len(self.vertices)} vertices, "
            f"{len(self.ridge_points)} faces>"
        )
