# SPDX-License-Identifier: MIT
"""A triangulation of the library's: safe to hold and to drop, its errors exceptions."""

from __future__ import annotations

import ctypes
from functools import partial
from typing import Any, Callable, Optional, Union

import numpy as np
from numpy.typing import NDArray

from . import _errors, _interface, _library
from ._arrays import (
    FloatArray,
    IndexArray,
    address,
    describe_not_finite,
    finite_rows,
    stride_in_doubles,
)
from ._diagram import taken_diagram
from ._gate import free
from ._insertion import Insertion

_STATISTICS = _interface.CONSTANTS["statistic"].values()
_ORDER_PARAMETERS = _interface.CONSTANTS["parameter"]
_SEPARATIONS = _interface.CONSTANTS["separation"]
MEASURES = _interface.CONSTANTS["measure"]
TETRAHEDRON_MEASURES = _interface.CONSTANTS["tetrahedron"]
METHODS = _interface.CONSTANTS["method"]
OUTSIDES = _interface.CONSTANTS["outside"]
_MESSAGE_BYTES = 256

# Values by natural neighbours and with gradients take longer than a location.
_INTERPOLATION_BLOCK = 1 << 17

# The library sorts locations in blocks of this size. A location that nobody waits for ends there.
_LOCATION_BLOCK = 1 << 20


def _order_schemes() -> dict[str, int]:
    schemes: dict[str, int] = {}
    key = ctypes.c_int32()
    while _library.library.mgdt_order_scheme_at(len(schemes), ctypes.byref(key)) == _errors.OK:
        schemes[_library.text(_library.library.mgdt_order_scheme_name(key))] = key.value
    return schemes


ORDER_SCHEMES = _order_schemes()
"""The order schemes by name."""


class Handle:
    """Owns an ``mgdt_triangulation``. The caller keeps the library's thread rule (see `Gate`)."""

    def __init__(self) -> None:
        self._library = _library.library
        self._pointer = ctypes.c_void_p()
        self._memory_limit = 0
        status = self._library.mgdt_create(ctypes.byref(self._pointer))
        if status != _errors.OK:
            raise _errors.make(status, "the library gave no triangulation: out of memory")

    def __del__(self) -> None:
        if self._pointer:
            free(self._library.mgdt_destroy, self._pointer)

    def _message(self, status: int) -> str:
        buffer = ctypes.create_string_buffer(_MESSAGE_BYTES)
        self._library.mgdt_get_error(self._pointer, _MESSAGE_BYTES, buffer)
        message = _library.text(buffer.value) or _library.text(
            self._library.mgdt_status_string(status)
        )
        if status == _errors.OUT_OF_MEMORY and self._memory_limit:
            message += f"; the memory limit is {self._memory_limit} bytes"
        return message

    def _call(self, name: str, *arguments: Any) -> None:
        status = getattr(self._library, name)(self._pointer, *arguments)
        if status != _errors.OK:
            raise _errors.make(status, self._message(status))

    # Settings

    def set_order(self, scheme: str, parameters: dict[str, Union[float, str]]) -> None:
        if scheme not in ORDER_SCHEMES:
            raise _errors.make(
                _errors.UNKNOWN_SCHEME,
                f"there is no order scheme {scheme!r}; there are {', '.join(ORDER_SCHEMES)}",
            )
        self._call("mgdt_set_order_scheme", ORDER_SCHEMES[scheme])
        for name, value in parameters.items():
            if name not in _ORDER_PARAMETERS:
                raise _errors.make(
                    _errors.UNKNOWN_KEY,
                    f"there is no order parameter {name!r}; "
                    f"there are {', '.join(_ORDER_PARAMETERS)}",
                )
            if isinstance(value, str) and (name != "separation" or value not in _SEPARATIONS):
                raise ValueError(
                    f"the order parameter {name!r} is {value!r}; it must be a number"
                    + (f" or one of {', '.join(_SEPARATIONS)}" if name == "separation" else "")
                )
            number = _SEPARATIONS[value] if isinstance(value, str) else value
            self._call("mgdt_set_order_parameter", _ORDER_PARAMETERS[name], number)

    def set_seed(self, seed: int) -> None:
        self._call("mgdt_set_seed", seed)

    def set_threads(self, threads: int) -> None:
        self._call("mgdt_set_threads", threads)

    def set_memory_limit(self, limit: int) -> None:
        self._call("mgdt_set_memory_limit", limit)
        self._memory_limit = limit

    def set_compact(self, on: bool) -> None:
        self._call("mgdt_set_compact", int(on))

    def set_canonical(self, on: bool) -> None:
        self._call("mgdt_set_canonical_output", int(on))

    def shrink(self) -> None:
        self._call("mgdt_shrink")

    # Points

    def clear(self) -> None:
        self._call("mgdt_clear")

    def insert(self, points: FloatArray, insertion: Insertion, name: str) -> None:
        """Inserts rows of doubles. Copies them only if they are no whole doubles apart."""
        stride = stride_in_doubles(points)
        if stride is None:
            points, stride = np.ascontiguousarray(points), 3
        try:
            if points.flags.c_contiguous:
                self._change(insertion, "mgdt_insert_points", len(points), address(points))
            else:
                columns = (address(points, k) for k in range(3))
                name_of_call = "mgdt_insert_points_strided"
                self._change(insertion, name_of_call, len(points), *columns, stride)
        except _errors.ArgumentError as error:
            if error.status != _errors.NOT_FINITE:
                raise
            raise _errors.make(error.status, describe_not_finite(points, name)) from None

    def remove(self, points: IndexArray, insertion: Insertion) -> None:
        """Takes out points of a contiguous list."""
        self._change(insertion, "mgdt_remove_points_i32", len(points), address(points))

    def move(self, points: IndexArray, places: FloatArray, insertion: Insertion) -> None:
        """Moves points of a contiguous list to contiguous rows."""
        name = "mgdt_move_points_i32"
        self._change(insertion, name, len(points), address(points), address(places))

    def renumber(self) -> IndexArray:
        return self._export("mgdt_renumber_points_i32", self.point_count)

    def moved_count(self) -> int:
        """Moves so far."""
        return int(self._statistic(_interface.CONSTANTS["statistic"]["points_moved"]))

    def _change(self, insertion: Insertion, name: str, *arguments: Any) -> None:
        """A call that may take long and can be stopped."""
        insertion.attach(partial(self._library.mgdt_cancel, self._pointer))
        report = _interface.PROGRESS(insertion.report)
        self._call("mgdt_set_progress", report, None)
        try:
            self._call(name, *arguments)
        finally:
            insertion.detach()
            self._call("mgdt_set_progress", _library.NO_PROGRESS, None)

    # Counts

    def _count(self, name: str) -> int:
        return int(getattr(self._library, name)(self._pointer))

    @property
    def point_count(self) -> int:
        return self._count("mgdt_point_count")

    @property
    def vertex_count(self) -> int:
        return self._count("mgdt_vertex_count")

    @property
    def tetrahedron_count(self) -> int:
        return self._count("mgdt_tetrahedron_count")

    @property
    def dimension(self) -> int:
        return self._count("mgdt_dimension")

    # Arrays

    def _export(self, name: str, *shape: int) -> IndexArray:
        out = np.empty(shape, dtype=np.int32)
        self._call(name, out.size, address(out))
        return out

    def tetrahedra(self) -> IndexArray:
        return self._export("mgdt_get_tetrahedra_i32", self.tetrahedron_count, 4)

    def neighbors(self) -> IndexArray:
        return self._export("mgdt_get_neighbors_i32", self.tetrahedron_count, 4)

    def hull_facets(self) -> IndexArray:
        return self._export("mgdt_get_hull_facets_i32", self._count("mgdt_hull_facet_count"), 3)

    def edges(self) -> IndexArray:
        return self._export("mgdt_get_edges_i32", self._count("mgdt_edge_count"), 2)

    def vertex_neighbors(self) -> tuple[IndexArray, IndexArray]:
        offsets = np.empty(self.point_count + 1, dtype=np.int32)
        found = np.empty(self._count("mgdt_vertex_neighbors_count"), dtype=np.int32)
        self._call("mgdt_get_vertex_neighbors_i32", offsets.size, address(offsets), found.size,
                   address(found))
        return offsets, found

    def _graph(self, name: str, most: int) -> IndexArray:
        edges, count = np.empty((most, 2), dtype=np.int32), np.empty(1, dtype=np.int32)
        self._call(name, edges.size, address(edges), address(count))
        return edges[: count[0]].copy()

    def gabriel_edges(self) -> IndexArray:
        return self._graph("mgdt_get_gabriel_edges_i32", self._count("mgdt_edge_count"))

    def spanning_tree(self) -> IndexArray:
        return self._graph("mgdt_get_spanning_tree_i32", self.vertex_count)

    def circumcenters(self) -> tuple[FloatArray, FloatArray]:
        """And the squares of the radii."""
        count = self.tetrahedron_count
        centers, squares = np.empty((count, 3)), np.empty(count)
        self._call("mgdt_get_circumcenters", count, address(centers), address(squares))
        return centers, squares

    def alphas(self, dimension: int) -> FloatArray:
        tetrahedra = self.tetrahedron_count
        shape: Union[int, tuple[int, int]] = (
            self.point_count if dimension == 0
            else self._count("mgdt_edge_count") if dimension == 1
            else (tetrahedra, 4) if dimension == 2
            else tetrahedra
        )
        x = np.empty(shape)
        self._call("mgdt_get_alphas", dimension, x.size, address(x))
        return x

    def alpha_surface(self, alpha2: float) -> IndexArray:
        count = np.empty(1, dtype=np.int32)
        # Enough for one surface or some; the count says what others need.
        facets = np.empty((2 * self.vertex_count + 4, 3), dtype=np.int32)
        for _ in range(2):
            status = self._library.mgdt_get_alpha_surface_i32(
                self._pointer, alpha2, facets.size, address(facets), address(count)
            )
            if status != _errors.BUFFER_TOO_SMALL:
                break
            facets = np.empty((count[0], 3), dtype=np.int32)
        if status != _errors.OK:
            raise _errors.make(status, self._message(status))
        return facets[: count[0]].copy()

    def solid_alpha(self) -> float:
        alpha2 = ctypes.c_double()
        self._call("mgdt_get_solid_alpha", ctypes.byref(alpha2))
        return alpha2.value

    def tetrahedron_measures(self, measure: str) -> FloatArray:
        x = np.empty(self.tetrahedron_count)
        self._call("mgdt_get_tetrahedron_measures", TETRAHEDRON_MEASURES[measure], x.size, address(x))
        return x

    def cell_measures(self, measure: str, planes: FloatArray) -> FloatArray:
        width = 3 if measure == "centroid" else 1
        x = np.empty((self.point_count, 3) if width == 3 else self.point_count)
        self._call("mgdt_get_cell_measures", MEASURES[measure], len(planes), address(planes), x.size,
                   address(x))
        return x

    def voronoi(self, planes: FloatArray, area: float, share: float) -> dict[str, NDArray[Any]]:
        """The arrays of the Voronoi diagram by their names, without the faces that are smaller."""
        diagram = ctypes.c_void_p()
        self._call("mgdt_voronoi_create", len(planes), address(planes), ctypes.byref(diagram))
        return taken_diagram(diagram, area, share)

    def point_map(self) -> IndexArray:
        return self._export("mgdt_get_point_map_i32", self.point_count)

    # Queries

    def _locate(
        self, places: FloatArray, weights: Optional[FloatArray], is_left: Callable[[], bool]
    ) -> IndexArray:
        """The tetrahedra of contiguous, finite rows; -1 outside. Fills weights (m, 4) where given."""
        out = np.empty(len(places), dtype=np.int32)
        for begin in range(0, len(places), _LOCATION_BLOCK):
            if is_left():
                break
            block = places[begin : begin + _LOCATION_BLOCK]
            to = None if weights is None else address(weights[begin:])
            self._call("mgdt_locate_points_i32", len(block), address(block), address(out[begin:]), to)
        return out

    def traverse_segment(self, a: FloatArray, b: FloatArray) -> tuple[IndexArray, FloatArray]:
        count = np.empty(1, dtype=np.int32)
        # Enough for most segments; the count says what others need.
        room = 128
        for _ in range(2):
            found, parameters = np.empty(room, dtype=np.int32), np.empty(room + 1)
            status = self._library.mgdt_traverse_segment_i32(
                self._pointer, address(a), address(b), room, address(found), address(parameters), address(count)
            )
            if status != _errors.BUFFER_TOO_SMALL:
                break
            room = count[0]
        if status != _errors.OK:
            raise _errors.make(status, self._message(status))
        n = count[0]
        return found[:n].copy(), parameters[: n + 1 if n else 0].copy()

    def locate_finite(
        self,
        places: FloatArray,
        weights: Optional[FloatArray] = None,
        is_left: Callable[[], bool] = lambda: False,
    ) -> IndexArray:
        """The tetrahedra of contiguous rows; -1 outside and for rows that are not finite. Fills weights
        (m, 4) where given."""
        try:
            return self._locate(places, weights, is_left)
        except _errors.ArgumentError:
            finite = finite_rows(places)
            out = np.full(len(places), -1, dtype=np.int32)
            some = None if weights is None else np.empty((int(finite.sum()), 4))
            out[finite] = self._locate(places[finite], some, is_left)
            if weights is not None:
                weights[...] = 0
                weights[finite] = some
            return out

    def nearest_vertices(
        self, places: FloatArray, is_left: Callable[[], bool] = lambda: False
    ) -> IndexArray:
        """The vertices nearest to contiguous rows; -1 where there are none, and for rows that are not
        finite."""
        try:
            return self._nearest_to_finite(places, is_left)
        except _errors.ArgumentError:
            finite = finite_rows(places)
            out = np.full(len(places), -1, dtype=np.int32)
            out[finite] = self._nearest_to_finite(places[finite], is_left)
            return out

    def _nearest_to_finite(self, places: FloatArray, is_left: Callable[[], bool]) -> IndexArray:
        out = np.empty(len(places), dtype=np.int32)
        size = _LOCATION_BLOCK
        if self.tetrahedron_count == 0:
            size = 1 + 64 * size // (1 + self.vertex_count)
        for begin in range(0, len(places), size):
            if is_left():
                break
            block = places[begin : begin + size]
            name = "mgdt_nearest_vertices_i32"
            self._call(name, len(block), address(block), address(out[begin:]))
        return out

    # Values between points. Values are contiguous rows of doubles, one for each point; places are
    # contiguous and finite.

    def interpolate(
        self,
        method: str,
        outside: str,
        values: FloatArray,
        places: FloatArray,
        is_left: Callable[[], bool] = lambda: False,
    ) -> FloatArray:
        """Rows of values; NaN where there are none."""
        fields = values.shape[1]
        out = np.empty((len(places), fields))
        for begin in range(0, len(places), _INTERPOLATION_BLOCK):
            if is_left():
                break
            block = places[begin : begin + _INTERPOLATION_BLOCK]
            self._call("mgdt_interpolate", METHODS[method], OUTSIDES[outside], fields,
                       address(values), len(block), address(block), address(out[begin:]))
        return out

    def interpolation_weights(
        self, method: str, outside: str, places: FloatArray
    ) -> tuple[IndexArray, IndexArray, FloatArray]:
        """Offsets, points and weights."""
        offsets = np.empty(len(places) + 1, dtype=np.int32)
        # Enough for most; the last offset says what others need.
        room = (4 if method == "linear" else 24) * len(places) + 8
        for _ in range(2):
            points, weights = np.empty(room, dtype=np.int32), np.empty(room)
            status = self._library.mgdt_get_interpolation_weights_i32(
                self._pointer, METHODS[method], OUTSIDES[outside], len(places), address(places),
                offsets.size, address(offsets), room, address(points), address(weights),
            )
            if status != _errors.BUFFER_TOO_SMALL:
                break
            room = int(offsets[-1])
        if status != _errors.OK:
            raise _errors.make(status, self._message(status))
        return offsets, points[: offsets[-1]].copy(), weights[: offsets[-1]].copy()

    def gradients(self, values: FloatArray) -> FloatArray:
        out = np.empty(values.shape + (3,))
        self._call("mgdt_get_gradients", values.shape[1], address(values), address(out))
        return out

    # Trust and figures

    def check(self, level: int) -> None:
        self._call("mgdt_check", level)

    def statistics(self) -> dict[str, float]:
        figures: dict[str, float] = {}
        for key in _STATISTICS:
            name = _library.text(self._library.mgdt_stat_name(key)).replace(" ", "_")
            value = self._statistic(key)
            figures[name] = value if name.endswith("seconds") else int(value)
        return figures

    def _statistic(self, key: int) -> float:
        value = ctypes.c_double()
        self._call("mgdt_get_stat", key, ctypes.byref(value))
        return value.value

    def isa(self) -> str:
        return _library.text(self._library.mgdt_isa_name(self._pointer))
