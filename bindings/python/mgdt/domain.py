# SPDX-License-Identifier: MIT
"""Meshes of what closed surfaces enclose."""

from __future__ import annotations

import copy
import ctypes
from ctypes import c_void_p
from typing import Any, Callable, NamedTuple, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _errors
from ._arrays import FloatArray, IndexArray, address, as_array, as_points
from ._building import build
from ._gate import Gate, interruptibly
from ._insertion import SHORT
from ._interface import CONSTANTS
from ._keyed import Keyed
from .export import to_meshio, to_pyvista

Facets = Union[ArrayLike, Sequence[Sequence[int]]]


class OffendingPair(NamedTuple):
    """Two facets, segments or points that do not meet in common corners and edges. What is bad by
    itself, such as a flat facet, is paired with itself."""

    first_kind: str
    """"facet", "segment" or "point"."""
    first: int
    second_kind: str
    second: int


class InvalidBoundary(_errors.Error, ValueError):
    """Facets, segments or points cross or touch where they must not, or are flat.

    Attributes
    ----------
    pairs : list of OffendingPair
        All of them.
    """

    pairs: list[OffendingPair]


class OpenBoundary(_errors.Error, ValueError):
    """The facets enclose nothing.

    Attributes
    ----------
    edges : (n, 3) array
        Where they are open: the ends of each edge that one facet alone has, and this facet.
    """

    edges: IndexArray


def _integers(values: Any, name: str, columns: Optional[int] = None) -> NDArray[np.int64]:
    array = as_array(values, name)
    if array.size == 0:
        array = array.astype(np.int64)
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name} must be integers, not {array.dtype}")
    if columns is not None and array.size == 0:
        array = array.reshape(0, columns)
    if array.ndim != (1 if columns is None else 2) or (columns and array.shape[1] != columns):
        shape = "(n,)" if columns is None else f"(n, {columns})"
        raise ValueError(f"{name} must have the shape {shape}, not {array.shape}")
    return np.ascontiguousarray(array, np.int64)


def _lists(facets: Facets) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Offsets and corners of facets: rows of an array, or lists of any lengths."""
    if not isinstance(facets, np.ndarray) and len({len(f) for f in facets}) > 1:  # type: ignore
        corners = _integers([v for f in facets for v in f], "facets")  # type: ignore
        sizes = [len(f) for f in facets]  # type: ignore
        offsets = np.zeros(len(sizes) + 1, np.int64)
        np.cumsum(sizes, out=offsets[1:])
        return offsets, corners
    array = as_array(facets, "facets")
    if array.size == 0:
        return np.zeros(1, np.int64), np.empty(0, np.int64)
    if array.ndim != 2:
        raise ValueError(f"facets must have the shape (n, corners), not {array.shape}")
    rows = _integers(array, "facets", array.shape[1])
    return np.arange(len(rows) + 1, dtype=np.int64) * rows.shape[1], rows.reshape(-1)


def _markers(values: Optional[ArrayLike], n: int, name: str) -> Optional[NDArray[np.int32]]:
    if values is None:
        return None
    wide = _integers(values, name)
    if wide.shape != (n,):
        raise ValueError(f"{name} must have the shape ({n},), not {wide.shape}")
    if n and (wide.min() < -(1 << 31) or wide.max() >= 1 << 31):
        raise ValueError(f"{name} must fit 32-bit integers")
    return wide.astype(np.int32)


class _Mesh(Keyed):
    """A mesh of the library."""

    kind = "mesh"

    def measures(self, name: str) -> FloatArray:
        values = np.empty(self.statistic("tetrahedra"))
        self.call("get_tetrahedron_measures", CONSTANTS["tetrahedron"][name], values.size, address(values))
        return values


class _Domain(Keyed):
    """A domain of the library, and the mesh of its last build."""

    kind = "domain"
    mesh: _Mesh

    def __init__(self) -> None:
        super().__init__(self._create())

    def quiet(self, name: str, *arguments: Any) -> int:
        if name != "build":
            return super().quiet(name, *arguments)
        pointer = c_void_p()
        status = super().quiet(name, ctypes.byref(pointer))
        if status == _errors.OK:
            self.mesh = _Mesh(pointer)
        return status

    def error(self, status: int, message: str) -> BaseException:
        if status == _errors.INVALID_BOUNDARY:
            invalid = InvalidBoundary(message)
            invalid.status = status
            invalid.pairs = self.pairs()
            return invalid
        if status == _errors.OPEN_BOUNDARY:
            is_open = OpenBoundary(message)
            is_open.status = status
            is_open.edges = self.array("open_edges")
            return is_open
        return super().error(status, message)

    def set(
        self,
        points: ArrayLike,
        facets: Facets,
        markers: Optional[ArrayLike],
        segments: Optional[ArrayLike],
        segment_markers: Optional[ArrayLike],
    ) -> None:
        rows = np.ascontiguousarray(as_points(points))
        self.call("set_points", len(rows), address(rows))
        offsets, corners = _lists(facets)
        n = len(offsets) - 1
        of_facets = _markers(markers, n, "markers")
        self.call(
            "set_facets",
            n,
            address(offsets),
            address(corners),
            None if of_facets is None else address(of_facets),
        )
        ends = _integers([] if segments is None else segments, "segments", 2)
        of_segments = _markers(segment_markers, len(ends), "segment_markers")
        self.call(
            "set_segments",
            len(ends),
            address(ends),
            None if of_segments is None else address(of_segments),
        )

    def set_places(
        self, holes: Optional[ArrayLike], regions: Sequence[tuple[ArrayLike, int]]
    ) -> None:
        rows = np.ascontiguousarray(as_points(np.empty((0, 3)) if holes is None else holes, "holes"))
        self.call("set_holes", len(rows), address(rows))
        places = [np.asarray(where) for where, _ in regions]
        rows = np.ascontiguousarray(
            np.concatenate([as_points(place[None], "regions") for place in places])
            if places
            else np.empty((0, 3))
        )
        values = _markers([marker for _, marker in regions], len(rows), "the markers of regions")
        self.call("set_regions", len(rows), address(rows), None if values is None else address(values))

    def pairs(self) -> list[OffendingPair]:
        kinds = {value: name for name, value in CONSTANTS["domain_kind"].items()}
        rows = self.array("offending_pairs").tolist()
        return [OffendingPair(kinds[a], i, kinds[b], k) for a, i, b, k in rows]


def offending_pairs(
    points: ArrayLike,
    facets: Facets,
    segments: Optional[ArrayLike] = None,
    *,
    threads: int = 1,
) -> list[OffendingPair]:
    """All pairs of facets, segments and points that do not meet in common corners and edges.

    Exact, without tolerances. Facets that are flat or no polygons, and segments without length, are
    paired with themselves. A surface without such pairs can be meshed.

    Since 1.3.

    Parameters
    ----------
    points : (n, 3) array
    facets : (m, k) array of rows of `points`, or lists of any lengths of at least 3
    segments : (s, 2) array of rows of `points`
    threads : 0 for all cores

    Examples
    --------
    >>> import mgdt
    >>> points = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [.5, .5, -1], [.5, .5, 1], [3, 0, 1]]
    >>> mgdt.offending_pairs(points, [[0, 1, 2], [3, 4, 5]])
    [OffendingPair(first_kind='facet', first=0, second_kind='facet', second=1)]
    """
    handle = _Domain()
    handle.set_option("threads", threads)
    handle.set(points, facets, None, segments, None)
    try:
        interruptibly(lambda _: handle.call("validate"), True)
    except InvalidBoundary as error:
        return error.pairs
    return []


class DomainMesh:
    """Tetrahedra that fill what facets enclose.

    Every facet is a union of faces of the mesh, and every segment a union of edges. The mesh is the
    constrained Delaunay triangulation of its points.

    Since 1.3.

    Parameters
    ----------
    points : (n, 3) array
    facets : (m, k) array of rows of `points`, or lists of any lengths of at least 3. Facets with
        equal markers that share an edge and are in one plane, exactly, are one facet
    markers : m integers; 0 by default
    segments : (s, 2) array of rows of `points`: edges that the mesh has to have besides
    segment_markers : s integers; 0 by default
    holes : (h, 3) array of places. What facets enclose around them stays empty
    regions : pairs of a place and a marker, such as ``[((0, 0, 0), 7)]``
    rounded : whether `points` of the mesh are rounded, mostly to 2^-36 of the largest coordinate, so that
        facets are covered exactly by what is returned
    strict : whether a mesh that leaves out points, facets, regions or holes is refused; otherwise the
        attributes ``unused_points`` and so on count them
    threads : 0 for all cores
    memory_limit : bytes, 0 for none
    progress : called as ``progress(fraction)`` with 0 to 1; the result ``mgdt.CANCEL`` cancels

    Raises
    ------
    InvalidBoundary
        If facets, segments or points cross or touch where they must not; it has all pairs.
    OpenBoundary
        If the facets enclose nothing; it has the edges where they are open.

    Attributes
    ----------
    points : (p, 3) array
        The points that were given, then the Steiner points.
    point_origins : (p,) array
        The row of the points that were given that each point is, of equal ones the first; -1 for a
        Steiner point.
    simplices, neighbors : (t, 4) arrays
        Corners of tetrahedra, and the tetrahedra opposite them; -1 where the domain ends.
    simplex_regions : (t,) array
        The number of the region of each tetrahedron, from 0.
    region_markers : array
        The marker of each region: that of the last of `regions` inside of it, or 0.
    faces : (f, 3) array
        Corners of the faces that are parts of facets; they turn like the facet's.
    face_simplices : (f, 2) array
        The tetrahedra at each face: the one that the normal points to, and the other; -1 for none.
    face_facets, face_markers : (f,) arrays
    edges : (e, 2) array
        Edges that are parts of segments or of edges of facets.
    edge_segments, edge_markers : (e,) arrays
        The segment that was given, or -1, and its marker, or 0.
    steiner_edges : (q, 2) array
        The ends a and b of the edge that each Steiner point divides.
    steiner_parameters : (q,) array
        The t for which it is a + t (b - a).
    open_edges : (o, 3) array
        The ends of each edge that one facet alone has, and this facet.
    npoints, nsimplex : int
        The numbers of points and of tetrahedra.
    is_rounded : bool
        Whether `points` are rounded.
    unused_points : int
        How many of the points are neither a corner of a tetrahedron nor equal to one.
    unused_faces : int
        How many faces have no tetrahedron: their facets bound nothing and are outside.
    unused_regions, unused_holes : int
        How many of `regions` and `holes` are in nothing that the facets enclose.

    Examples
    --------
    >>> import mgdt, numpy
    >>> cube = numpy.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)])
    >>> sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    >>> mesh = mgdt.DomainMesh(cube, sides)
    >>> mesh
    <mgdt.DomainMesh: 8 points, 6 tetrahedra, 1 region>
    """

    def __init__(
        self,
        points: ArrayLike,
        facets: Facets,
        *,
        markers: Optional[ArrayLike] = None,
        segments: Optional[ArrayLike] = None,
        segment_markers: Optional[ArrayLike] = None,
        holes: Optional[ArrayLike] = None,
        regions: Sequence[tuple[ArrayLike, int]] = (),
        rounded: bool = False,
        strict: bool = False,
        threads: int = 1,
        memory_limit: int = 0,
        progress: Optional[Callable[[float], Any]] = None,
    ) -> None:
        self._given = copy.deepcopy(
            {
                "points": points,
                "facets": facets,
                "markers": markers,
                "segments": segments,
                "segment_markers": segment_markers,
                "holes": holes,
                "regions": regions,
                "rounded": rounded,
                "strict": strict,
                "threads": threads,
                "memory_limit": memory_limit,
            }
        )
        handle = self._domain = _Domain()
        handle.set_option("threads", threads)
        handle.set_option("memory_limit", memory_limit)
        handle.set_option("round_points", int(rounded))
        handle.set_option("strict", int(strict))
        handle.set(points, facets, markers, segments, segment_markers)
        handle.set_places(holes, regions)
        # A small surface may need many points.
        build(handle, Gate(), progress, SHORT)
        mesh = self._mesh = handle.mesh
        self.points: FloatArray = mesh.array("points")
        self.point_origins: IndexArray = mesh.array("point_origins")
        self.simplices: IndexArray = mesh.array("tetrahedra")
        self.neighbors: IndexArray = mesh.array("neighbors")
        self.simplex_regions: IndexArray = mesh.array("tetrahedron_regions")
        self.region_markers: IndexArray = mesh.array("region_markers")
        self.faces: IndexArray = mesh.array("faces")
        self.face_simplices: IndexArray = mesh.array("face_tetrahedra")
        self.face_facets: IndexArray = mesh.array("face_facets")
        self.face_markers: IndexArray = mesh.array("face_markers")
        self.edges: IndexArray = mesh.array("edges")
        self.edge_segments: IndexArray = mesh.array("edge_segments")
        self.edge_markers: IndexArray = mesh.array("edge_markers")
        self.steiner_edges: IndexArray = mesh.array("steiner_edges")
        self.steiner_parameters: FloatArray = mesh.array("steiner_parameters")
        self.open_edges: IndexArray = handle.array("open_edges")
        self.is_rounded = mesh.statistic("is_rounded") == 1
        self.unused_points = mesh.statistic("unused_points")
        self.unused_faces = mesh.statistic("unused_faces")
        self.unused_regions = mesh.statistic("unused_regions")
        self.unused_holes = mesh.statistic("unused_holes")

    @property
    def npoints(self) -> int:
        """The number of points, Steiner points included."""
        return len(self.points)

    @property
    def nsimplex(self) -> int:
        """The number of tetrahedra."""
        return len(self.simplices)

    # Copies are built again from what was given, and share nothing with the original.

    def __getstate__(self) -> dict[str, Any]:
        return self._given

    def __setstate__(self, state: dict[str, Any]) -> None:
        DomainMesh.__init__(self, **state)

    def check(self) -> None:
        """Proves the mesh against the facets and segments, exactly.

        Raises
        ------
        CheckFailed
            If it has a defect. The message says what and where.
        """
        def check(_: Callable[[], bool]) -> None:
            self._mesh.call("check")
            self._domain.call("check", self._mesh.pointer)

        interruptibly(check, True)

    def tetrahedron_measures(self, measure: str) -> FloatArray:
        """A measure of each tetrahedron, as `Delaunay.tetrahedron_measures` has it.

        Parameters
        ----------
        measure : "volume", "radius_ratio", "least_dihedral_angle", "largest_dihedral_angle" or "longest_edge"
        """
        if measure not in CONSTANTS["tetrahedron"]:
            known = ", ".join(CONSTANTS["tetrahedron"])
            raise ValueError(f"there is no measure {measure!r} of tetrahedra; there are {known}")
        return interruptibly(lambda _: self._mesh.measures(measure), True)

    def to_meshio(self) -> Any:
        """Points, tetrahedra and faces as a ``meshio.Mesh``. Cell data "marker" has the markers of the
        regions of tetrahedra, and those of faces."""
        return to_meshio(self, [("triangle", self.faces)], self._cell_data())

    def to_pyvista(self) -> Any:
        """Points and tetrahedra as a ``pyvista.UnstructuredGrid``, with the markers of regions as the
        cell data "marker"."""
        grid = to_pyvista(self)
        grid.cell_data["marker"] = self._cell_data()["marker"][0]
        return grid

    def _cell_data(self) -> dict[str, list[Any]]:
        return {"marker": [self.region_markers[self.simplex_regions], self.face_markers]}

    def __repr__(self) -> str:
        n = len(self.region_markers)
        return (
            f"<mgdt.DomainMesh: {len(self.points)} points, {len(self.simplices)} tetrahedra, "
            f"{n} region{'' if n == 1 else 's'}>"
        )
