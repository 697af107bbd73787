# SPDX-License-Identifier: MIT
"""Meshes of what closed surfaces enclose."""

from __future__ import annotations

import copy
import ctypes
from ctypes import c_int64, c_void_p
from typing import Any, Callable, NamedTuple, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _errors, _library
from ._arrays import FloatArray, IndexArray, address, as_array, as_points
from ._building import build
from ._gate import Gate, free, interruptibly
from ._insertion import SHORT
from ._interface import CONSTANTS

_MESSAGE_BYTES = 512
_DOUBLES = ("points", "steiner_parameters")

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


def _function(name: str) -> Callable[..., Any]:
    function: Callable[..., Any] = getattr(_library.library, "mgdt_domain_" + name)
    return function


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


class _Handle:
    """A domain of the library."""

    def __init__(self) -> None:
        self._pointer = c_void_p()
        status = _function("create")(ctypes.byref(self._pointer))
        if status != _errors.OK:
            raise _errors.make(status, "the library made no domain: out of memory")

    def __del__(self) -> None:
        if getattr(self, "_pointer", None):
            free(_function("destroy"), self._pointer)

    def quiet(self, name: str, *arguments: Any) -> int:
        return int(_function(name)(self._pointer, *arguments))

    def call(self, name: str, *arguments: Any) -> None:
        status = self.quiet(name, *arguments)
        if status == _errors.OK:
            return
        buffer = ctypes.create_string_buffer(_MESSAGE_BYTES)
        self.quiet("get_error", _MESSAGE_BYTES, buffer)
        message = _library.text(buffer.value)
        if status == _errors.INVALID_BOUNDARY:
            invalid = InvalidBoundary(message)
            invalid.status = status
            invalid.pairs = self.pairs()
            raise invalid
        if status == _errors.OPEN_BOUNDARY:
            is_open = OpenBoundary(message)
            is_open.status = status
            is_open.edges = self.array("open_edges").reshape(-1, 3)
            raise is_open
        raise _errors.make(status, message)

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

    def number(self, name: str) -> int:
        value = c_int64()
        self.call("get_stat", CONSTANTS["domain_number"][name], ctypes.byref(value))
        return value.value

    def array(self, name: str) -> Any:
        key, size = CONSTANTS["domain_array"][name], c_int64()
        self.call("get_size", key, ctypes.byref(size))
        if name in _DOUBLES:
            doubles = np.empty(size.value)
            self.call("get_doubles", key, size.value, address(doubles))
            return doubles
        integers = np.empty(size.value, np.int32)
        self.call("get_array_i32", key, size.value, address(integers))
        return integers

    def pairs(self) -> list[OffendingPair]:
        kinds = {value: name for name, value in CONSTANTS["domain_kind"].items()}
        rows = self.array("offending_pairs").reshape(-1, 4).tolist()
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
    handle = _Handle()
    handle.call("set_option", CONSTANTS["domain_option"]["threads"], threads)
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
    simplices, neighbors : (t, 4) arrays
        Corners of tetrahedra, and the tetrahedra opposite them; -1 where the domain ends.
    regions : (t,) array
        The number of the region of each tetrahedron, from 0.
    region_markers : array
        The marker of each region: that of the last of `regions` inside of it, or 0.
    faces : (f, 3) array
        Corners of the faces that are parts of facets; they turn like the facet's.
    face_simplices : (f, 2) array
        The tetrahedra at each face: the one that the normal points to, and the other; -1 for none.
    face_facets, face_markers : (f,) arrays
    segments : (e, 2) array
        Edges that are parts of segments or of edges of facets.
    segment_sources, segment_markers : (e,) arrays
        The segment that was given, or -1, and its marker, or 0.
    steiner_edges : (q, 2) array
        The ends a and b of the edge that each Steiner point divides.
    steiner_parameters : (q,) array
        The t for which it is a + t (b - a).
    open_edges : (o, 3) array
        The ends of each edge that one facet alone has, and this facet.
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
        handle = self._handle = _Handle()
        option = CONSTANTS["domain_option"]
        handle.call("set_option", option["threads"], threads)
        handle.call("set_option", option["memory_limit"], memory_limit)
        handle.call("set_option", option["round_points"], int(rounded))
        handle.call("set_option", option["strict"], int(strict))
        handle.set(points, facets, markers, segments, segment_markers)
        if holes is not None:
            for place in np.ascontiguousarray(as_points(holes, "holes")):
                handle.call("add_hole", address(place))
        for where, marker in regions:
            row = np.ascontiguousarray(as_points(np.asarray(where)[None], "regions"))
            value = _markers([marker], 1, "the markers of regions")
            handle.call("add_region", address(row), 0 if value is None else int(value[0]))
        # A small surface may need many points.
        build(handle, Gate(), progress, SHORT)

        def rows(name: str, columns: int) -> Any:
            return handle.array(name).reshape(-1, columns)

        self.points: FloatArray = rows("points", 3)
        self.simplices: IndexArray = rows("tetrahedra", 4)
        self.neighbors: IndexArray = rows("neighbors", 4)
        self.regions: IndexArray = handle.array("regions")
        self.region_markers: IndexArray = handle.array("region_markers")
        self.faces: IndexArray = rows("faces", 3)
        self.face_simplices: IndexArray = rows("face_tetrahedra", 2)
        self.face_facets: IndexArray = handle.array("face_facets")
        self.face_markers: IndexArray = handle.array("face_markers")
        self.segments: IndexArray = rows("segments", 2)
        self.segment_sources: IndexArray = handle.array("segment_sources")
        self.segment_markers: IndexArray = handle.array("segment_markers")
        self.open_edges: IndexArray = rows("open_edges", 3)
        self.steiner_edges: IndexArray = rows("steiner_edges", 2)
        self.steiner_parameters: FloatArray = handle.array("steiner_parameters")
        self.is_rounded = handle.number("is_rounded") == 1
        self.unused_points = handle.number("unused_points")
        self.unused_faces = handle.number("unused_faces")
        self.unused_regions = handle.number("unused_regions")
        self.unused_holes = handle.number("unused_holes")

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
        interruptibly(lambda _: self._handle.call("check"), True)

    def __repr__(self) -> str:
        n = len(self.region_markers)
        return (
            f"<mgdt.DomainMesh: {len(self.points)} points, {len(self.simplices)} tetrahedra, "
            f"{n} region{'' if n == 1 else 's'}>"
        )
