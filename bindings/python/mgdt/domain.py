# SPDX-License-Identifier: MIT
"""Meshes of what closed surfaces enclose."""

from __future__ import annotations

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
from .mesh import Mesh, MeshHandle, integers, markers_of

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


def _lists(facets: Facets) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Offsets and corners of facets: rows of an array, or lists of any lengths."""
    if not isinstance(facets, np.ndarray) and len({len(f) for f in facets}) > 1:  # type: ignore
        corners = integers([v for f in facets for v in f], "facets")  # type: ignore
        sizes = [len(f) for f in facets]  # type: ignore
        offsets = np.zeros(len(sizes) + 1, np.int64)
        np.cumsum(sizes, out=offsets[1:])
        return offsets, corners
    array = as_array(facets, "facets")
    if array.size == 0:
        return np.zeros(1, np.int64), np.empty(0, np.int64)
    if array.ndim != 2:
        raise ValueError(f"facets must have the shape (n, corners), not {array.shape}")
    rows = integers(array, "facets", array.shape[1])
    return np.arange(len(rows) + 1, dtype=np.int64) * rows.shape[1], rows.reshape(-1)


class _Domain(Keyed):
    """A domain of the library, and the mesh of its last build."""

    kind = "domain"
    mesh: MeshHandle

    def __init__(self) -> None:
        super().__init__(self._create())

    def quiet(self, name: str, *arguments: Any) -> int:
        if name != "build":
            return super().quiet(name, *arguments)
        pointer = c_void_p()
        status = super().quiet(name, ctypes.byref(pointer))
        if status == _errors.OK:
            self.mesh = MeshHandle(pointer)
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
        of_facets = markers_of(markers, n, "markers")
        self.call(
            "set_facets",
            n,
            address(offsets),
            address(corners),
            None if of_facets is None else address(of_facets),
        )
        ends = integers([] if segments is None else segments, "segments", 2)
        of_segments = markers_of(segment_markers, len(ends), "segment_markers")
        self.call(
            "set_segments",
            len(ends),
            address(ends),
            None if of_segments is None else address(of_segments),
        )

    def clean(self, weld: float, flatness: float) -> None:
        self.set_double_option("weld", weld)
        self.set_double_option("flatness", flatness)
        self.call("clean")

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
        values = markers_of([marker for _, marker in regions], len(rows), "the markers of regions")
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


class CleanSurface(NamedTuple):
    """Facets and segments that have been cleaned; see `clean_surface`."""

    points: FloatArray
    """The points that were given, with the coordinates of others where they were welded."""
    facets: list[NDArray[np.int64]]
    markers: IndexArray
    """The marker of each facet."""
    origins: IndexArray
    """The facet that was given that each is, or is a part of."""
    segments: IndexArray
    segment_markers: IndexArray
    segment_origins: IndexArray
    covered: IndexArray
    """Rows of two facets that were given: one that is covered, and the one that stays there."""
    counts: dict[str, int]
    """What was done: ``moved_points``, ``repeated_corners``, ``collapsed_facets``,
    ``points_in_edges``, ``points_in_facets``, ``edges_in_facets`` and ``exchanged_edges``."""


def clean_surface(
    points: ArrayLike,
    facets: Facets,
    segments: Optional[ArrayLike] = None,
    *,
    markers: Optional[ArrayLike] = None,
    segment_markers: Optional[ArrayLike] = None,
    weld: float = 0,
    flatness: float = 0,
    threads: int = 1,
) -> CleanSurface:
    """Mends what needs no new points: repeated corners, collapsed and equal facets, points in edges
    and in facets, and edges in facets.

    Exact, unless `weld` is set. Facets that cross each other stay; `offending_pairs` finds them.
    ``mgdt_domain_clean`` in mgdt/mgdt_domain.h says what is done.

    Since 1.4.

    Parameters
    ----------
    points, facets, segments, markers, segment_markers : as for `DomainMesh`
    weld : the distance within which places are one, as a share of the diagonal of the points' box
    flatness : the distance within which facets of one marker are in one plane, as a share of the same;
        edges inside of such facets are exchanged so that a mesh needs fewer Steiner points
    threads : 0 for all cores

    Examples
    --------
    A point in the middle of an edge of one of two triangles:

    >>> import mgdt
    >>> points = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [1, -1, 0], [1, 0, 0]]
    >>> clean = mgdt.clean_surface(points, [[0, 1, 2], [0, 3, 4], [4, 3, 1]])
    >>> [facet.tolist() for facet in clean.facets]
    [[0, 4, 2], [4, 1, 2], [0, 3, 4], [4, 3, 1]]
    >>> clean.origins.tolist()
    [0, 0, 1, 2]
    """
    handle = _Domain()
    handle.set_option("threads", threads)
    handle.set(points, facets, markers, segments, segment_markers)
    interruptibly(lambda _: handle.clean(weld, flatness), True)
    offsets = handle.array("facet_offsets", np.int64)
    corners = handle.array("facet_corners", np.int64)
    names = ("moved_points", "repeated_corners", "collapsed_facets", "points_in_edges",
             "points_in_facets", "edges_in_facets", "exchanged_edges")  # fmt: skip
    return CleanSurface(
        handle.array("points"),
        [corners[a:b] for a, b in zip(offsets[:-1], offsets[1:])],
        handle.array("facet_markers"),
        handle.array("facet_origins"),
        handle.array("segments"),
        handle.array("segment_markers"),
        handle.array("segment_origins"),
        handle.array("covered_facets"),
        {name: handle.statistic(name) for name in names},
    )


class DomainMesh(Mesh):
    """Tetrahedra that fill what facets enclose.

    Every facet is a union of faces of the mesh, and every segment a union of edges. The mesh has few
    Steiner points; where that takes no more of them, it is constrained Delaunay.

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
    keep_boundary : whether each triangle of a facet is one face and each segment one edge, with Steiner
        points inside only. Since 1.4
    clean : whether facets and segments are cleaned before: see `clean_surface`. Since 1.4
    weld, flatness : distances for that; if one is not 0, they are cleaned. Since 1.4
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
    covered_facets : (c, 2) array
        Facets that were covered by others, which were left out, and those others. Since 1.4
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
        keep_boundary: bool = False,
        clean: bool = False,
        weld: float = 0,
        flatness: float = 0,
        threads: int = 1,
        memory_limit: int = 0,
        progress: Optional[Callable[[float], Any]] = None,
    ) -> None:
        self._keep(
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
                "keep_boundary": keep_boundary,
                "clean": clean,
                "weld": weld,
                "flatness": flatness,
                "threads": threads,
                "memory_limit": memory_limit,
            }
        )
        handle = self._domain = _Domain()
        handle.set_option("threads", threads)
        handle.set_option("memory_limit", memory_limit)
        handle.set_option("round_points", int(rounded))
        handle.set_option("strict", int(strict))
        handle.set_option("keep_boundary", int(keep_boundary))
        handle.set(points, facets, markers, segments, segment_markers)
        handle.set_places(holes, regions)
        if clean or weld != 0 or flatness != 0:
            interruptibly(lambda _: handle.clean(weld, flatness), True)
        # A small surface may need many points.
        build(handle, Gate(), progress, SHORT)
        self.open_edges: IndexArray = handle.array("open_edges")
        self.covered_facets: IndexArray = handle.array("covered_facets")
        self._take(handle.mesh)

    def _prove(self) -> None:
        super()._prove()
        # What has been improved is no longer the mesh of the domain alone.
        if self._mesh.statistic("is_of_domain"):
            self._domain.call("check", self._mesh.pointer)

    _keep_at_first = "all"
