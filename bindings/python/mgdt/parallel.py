# SPDX-License-Identifier: MIT
"""Triangulations of points that are spread over processes of MPI."""

from __future__ import annotations

import ctypes
import signal
import threading
from ctypes import c_int32, c_int64, c_void_p
from functools import partial
from typing import Any, Callable, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _errors, _library
from ._arrays import FloatArray, address
from ._insertion import CANCEL, ProgressFunction
from ._interface import PROGRESS
from ._parts_interface import CONSTANTS
from ._transport import MpiTransport

Int64Array = NDArray[np.int64]

_THIS_PART = CONSTANTS["part"]["this_part"]
_MESSAGE_BYTES = 256


def _function(name: str) -> Any:
    return getattr(_library.library, f"mgdt_parts_{name}")


class _DeferredInterrupt:
    """While the library calls functions of Python's, Ctrl-C is noted; its handler is called afterwards.
    What a handler raises as such a function is entered would be lost."""

    def __init__(self) -> None:
        self.has_come = False
        self._handler: Any = None

    def __enter__(self) -> "_DeferredInterrupt":
        handler = signal.getsignal(signal.SIGINT)
        if callable(handler) and threading.current_thread() is threading.main_thread():
            signal.signal(signal.SIGINT, self._note)
            self._handler = handler
        return self

    def _note(self, *_: Any) -> None:
        self.has_come = True

    def __exit__(self, *_: Any) -> None:
        if self._handler is None:
            return
        signal.signal(signal.SIGINT, self._handler)
        if not self.has_come:
            return
        try:
            signal.raise_signal(signal.SIGINT)
        except BaseException as error:
            # In the place of the library's word that it was cancelled.
            raise error from None


class ParallelDelaunay:
    """One triangulation of the points of all ranks; this object has the part of its rank.

    Each rank gives points of its own. A part owns the vertices in its region, as many on each rank,
    and has all tetrahedra with one of these as a corner; those that it owns come first. Making the
    object, `check` and `close` are collective: all ranks do it. An error on one rank is raised on all.

    Since 1.2.

    Parameters
    ----------
    points : (n, 3) array of the points of this rank; n may be 0 and differ
    comm : communicator of mpi4py, ``MPI.COMM_WORLD`` by default
    ids : n integers, different for different points of all ranks; without, points are numbered from
        0 on, those of rank 0 first
    threads : for the triangulation of this rank, 0 for all cores
    memory_limit : bytes for this rank, 0 for none
    progress : called as ``progress(fraction)`` with 0 to 1, on this rank. The result ``mgdt.CANCEL``
        before 1 cancels, and so does an exception, and Ctrl-C within a call of it; then the other
        ranks raise `mgdt.Cancelled`. It must not raise at 1, when all is done

    Examples
    --------
    On one rank, or on any number by ``mpiexec``:

    >>> import mgdt, numpy  # doctest: +SKIP
    >>> d = mgdt.ParallelDelaunay(numpy.random.random((1000, 3)))  # doctest: +SKIP
    >>> d.number("all_vertices")  # doctest: +SKIP
    1000
    """

    def __init__(
        self,
        points: ArrayLike,
        comm: Optional[Any] = None,
        *,
        ids: Optional[ArrayLike] = None,
        threads: int = 1,
        memory_limit: int = 0,
        progress: Optional[ProgressFunction] = None,
    ) -> None:
        self._pointer = c_void_p()
        if comm is None:
            from mpi4py import MPI  # pylint: disable=import-outside-toplevel

            comm = MPI.COMM_WORLD
        self._communicator = comm.Dup()
        self._transport = MpiTransport(self._communicator)
        self._rank = self._communicator.Get_rank()
        status = _function("create_with_transport")(
            ctypes.byref(self._transport.functions), ctypes.byref(self._pointer)
        )
        if status != _errors.OK:
            raise _errors.make(status, "the library gave no part: out of memory")
        self._call("set_option", CONSTANTS["option"]["threads"], threads)
        self._call("set_option", CONSTANTS["option"]["memory_limit"], memory_limit)
        problem: Optional[Exception] = None
        try:
            self._insert(points, ids)
        except (TypeError, ValueError, _errors.Error) as error:
            problem = error
        # What is wrong here is so on all ranks, which wait for this one.
        if problem is not None and not isinstance(problem, _errors.Error):
            self._call_quietly("insert_points", _THIS_PART, -1, None, None)
        with _DeferredInterrupt() as interrupt:
            # Without a function to call, too, so that Ctrl-C is heard.
            report = PROGRESS(partial(self._report, progress, lambda: interrupt.has_come))
            self._call_quietly("set_progress", report, None)
            try:
                self._call("build")
            except _errors.Error:
                if problem is not None:
                    raise problem from None
                raise
            finally:
                self._call_quietly("set_progress", _library.NO_PROGRESS, None)

    def _report(
        self,
        progress: Optional[ProgressFunction],
        is_interrupted: Callable[[], bool],
        fraction: float,
        _: Any,
    ) -> int:
        try:
            is_cancelled = progress is not None and progress(fraction) is CANCEL
            return 1 if is_cancelled or is_interrupted() else 0
        except BaseException as error:  # pylint: disable=broad-exception-caught
            self._transport.failure = error
            return 1

    def _insert(self, points: ArrayLike, ids: Optional[ArrayLike]) -> None:
        rows = np.ascontiguousarray(points, np.float64)
        if rows.size == 0:
            rows = rows.reshape(0, 3)
        if rows.ndim != 2 or rows.shape[1] != 3:
            raise ValueError(f"points must have the shape (n, 3), not {rows.shape}")
        numbers = None
        if ids is not None:
            numbers = np.ascontiguousarray(ids, np.int64)
            if numbers.shape != (len(rows),):
                raise ValueError(f"ids must have the shape ({len(rows)},), not {numbers.shape}")
        at_ids = address(numbers) if numbers is not None and len(rows) else None
        self._call("insert_points", _THIS_PART, len(rows), address(rows), at_ids)

    def _call_quietly(self, name: str, *arguments: Any) -> int:
        return int(_function(name)(self._pointer, *arguments))

    def _call(self, name: str, *arguments: Any) -> None:
        if not self._pointer:
            raise ValueError("the triangulation is closed")
        status = self._call_quietly(name, *arguments)
        if self._transport.failure is not None:
            failure, self._transport.failure = self._transport.failure, None
            raise failure
        if status != _errors.OK:
            buffer = ctypes.create_string_buffer(_MESSAGE_BYTES)
            _function("get_error")(self._pointer, _MESSAGE_BYTES, buffer)
            raise _errors.make(status, _library.text(buffer.value))

    def close(self) -> None:
        """Frees the part and the communicator. Collective, and optional: MPI frees them at its end."""
        if self._pointer:
            pointer, self._pointer = self._pointer, c_void_p()
            _function("destroy")(pointer)
            self._communicator.Free()

    def __del__(self) -> None:
        # Not the communicator: other ranks may drop theirs at another time.
        if self._pointer:
            _function("destroy")(self._pointer)

    def __repr__(self) -> str:
        if not self._pointer:
            return "<mgdt.ParallelDelaunay: closed>"
        return (
            f"<mgdt.ParallelDelaunay: rank {self._rank}, {self.own_vertices} vertices and "
            f"{self.own_simplices} tetrahedra of its own>"
        )

    def __enter__(self) -> "ParallelDelaunay":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def check(self, level: int = 3) -> None:
        """Proves the triangulation of all ranks; see `Delaunay.check`. Collective."""
        with _DeferredInterrupt():
            self._call("check", level)

    def number(self, name: str) -> int:
        """A number of the part, such as "own_vertices", "tetrahedra", "all_tetrahedra", "received"."""
        value = c_int64()
        self._call("get_stat", _THIS_PART, CONSTANTS["number"][name], ctypes.byref(value))
        return value.value

    def _array(self, name: str) -> Int64Array:
        key = CONSTANTS["array"][name]
        columns, size = c_int32(), c_int64()
        _function("array_info")(key, ctypes.byref(columns), None)
        self._call("get_size", _THIS_PART, key, ctypes.byref(size))
        values = np.empty(size.value, np.int64)
        self._call("get_array", _THIS_PART, key, size.value, address(values))
        return values if columns.value == 1 else values.reshape(-1, columns.value)

    @property
    def points(self) -> FloatArray:
        """Coordinates of the part's vertices: its own, then its ghosts."""
        xyz = np.empty((self.number("vertices"), 3))
        self._call("get_coordinates", _THIS_PART, xyz.size, address(xyz))
        return xyz

    @property
    def own_vertices(self) -> int:
        """How many of `points` are the part's own."""
        return self.number("own_vertices")

    @property
    def own_simplices(self) -> int:
        """How many of `simplices` are the part's own."""
        return self.number("own_tetrahedra")

    @property
    def simplices(self) -> Int64Array:
        """Four rows of `points` for each tetrahedron: those that the part owns, then others."""
        return self._array("local_corners")

    @property
    def neighbors(self) -> Int64Array:
        """Four numbers of tetrahedra for each that the part owns, opposite its corners; -1: none."""
        return self._array("neighbors")

    @property
    def vertex_numbers(self) -> Int64Array:
        """The number of each vertex among those of all ranks."""
        return self._array("vertex_numbers")

    @property
    def vertex_ids(self) -> Int64Array:
        """The id of each vertex."""
        return self._array("vertex_ids")

    @property
    def vertex_owners(self) -> Int64Array:
        """The rank that owns each vertex."""
        return self._array("vertex_owners")

    @property
    def vertex_ranges(self) -> Int64Array:
        """The number of the first vertex of each rank, and the end of the last."""
        return self._array("vertex_ranges")

    @property
    def simplex_numbers(self) -> Int64Array:
        """The number of each tetrahedron among those of all ranks."""
        return self._array("tetrahedron_numbers")

    @property
    def simplex_owners(self) -> Int64Array:
        """The rank that owns each tetrahedron."""
        return self._array("tetrahedron_owners")

    @property
    def simplex_ranges(self) -> Int64Array:
        """The number of the first tetrahedron of each rank, and the end of the last."""
        return self._array("tetrahedron_ranges")

    @property
    def point_map(self) -> Int64Array:
        """For each point that this rank gave, the number of its vertex."""
        return self._array("point_map")
