# SPDX-License-Identifier: MIT
"""A triangulation that grows: points in, threads, stopping, and the end of it."""

from __future__ import annotations

import operator
import threading
from contextlib import contextmanager
from types import FunctionType
from typing import Any, Callable, Iterator, Mapping, Optional, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _errors, _qhull_options
from ._arrays import (
    FloatArray,
    IndexArray,
    PointStore,
    as_points,
    describe_not_finite,
    finite_rows,
)
from ._gate import Gate, interruptibly
from ._handle import Handle
from ._insertion import Insertion, ProgressFunction

# Points from which an export may take so long that Ctrl-C shall interrupt it.
LONG_EXPORT = 20_000

_T = TypeVar("_T")
_Self = TypeVar("_Self", bound="GrowingTriangulation")


def whole(value: Any, name: str, least: int, most: int) -> int:
    """An integer in its range: ctypes would cut it to its bits."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} must be an integer, not {type(value).__name__}") from None
    if not least <= number <= most:
        raise ValueError(f"{name} is {number}; it must be from {least} to {most}")
    return number


def _number_or_name(value: Any, name: object) -> Union[float, str]:
    try:
        return float(value)
    except ValueError:
        return str(value)
    except TypeError:
        kind = type(value).__name__
        raise TypeError(f"the order parameter {name!r} must be a number, not {kind}") from None


class GrowingTriangulation:
    """What `mgdt.Delaunay` does with points before anyone asks for tetrahedra.

    The parameters are documented there.
    """

    def __init__(
        self,
        points: ArrayLike,
        furthest_site: bool = False,
        incremental: bool = False,
        qhull_options: Union[None, str, bytes] = None,
        *,
        order: str = "auto",
        order_parameters: Optional[Mapping[str, Union[float, str]]] = None,
        seed: int = 0,
        threads: int = 1,
        memory_limit: Optional[int] = None,
        compact: bool = False,
        canonical: bool = False,
        progress: Optional[ProgressFunction] = None,
    ) -> None:
        if furthest_site:
            raise ValueError("mgdt has no furthest-site triangulation")
        _qhull_options.check(qhull_options)
        if not isinstance(order, str):
            raise TypeError(f"order must be a string, not {type(order).__name__}")
        if order_parameters is not None and not isinstance(order_parameters, Mapping):
            kind = type(order_parameters).__name__
            raise TypeError(f"order_parameters must be a dict of names and numbers, not {kind}")
        if progress is not None and not callable(progress):
            raise TypeError(f"progress must be a function, not {type(progress).__name__}")
        self.progress = progress
        self._settings: dict[str, Any] = {
            "order": order,
            "order_parameters": {
                k: _number_or_name(v, k)
                for k, v in (order_parameters or {}).items()
            },
            "seed": whole(seed, "seed", 0, 2**64 - 1),
            "threads": whole(threads, "threads", 0, 2**31 - 1),
            "memory_limit": self._bytes(memory_limit),
            "compact": bool(compact),
            "canonical": bool(canonical),
        }
        self._begin(bool(incremental))
        self._insert(as_points(points))

    def _begin(self, incremental: bool) -> None:
        settings = self._settings
        self._gate = Gate()
        self._running: Optional[Insertion] = None
        self._incremental = incremental
        self._closed = False
        self._cache: dict[str, Any] = {}
        self._store = PointStore(copies=incremental)
        self._batches: list[int] = []
        self._handle: Optional[Handle] = Handle()
        self._handle.set_order(settings["order"], settings["order_parameters"])
        self._handle.set_seed(settings["seed"])
        self._handle.set_threads(settings["threads"])
        self._handle.set_memory_limit(settings["memory_limit"])
        self._handle.set_compact(settings["compact"])
        self._handle.set_canonical(settings["canonical"])

    # Access: many threads that read, or one that writes.

    @contextmanager
    def _reading(self) -> Iterator[Handle]:
        with self._gate.reading():
            yield self._held()

    @contextmanager
    def _writing(self) -> Iterator[Handle]:
        with self._gate.writing():
            yield self._held()

    def _held(self) -> Handle:
        if self._handle is None:
            raise RuntimeError("the triangulation has been released")
        return self._handle

    def _cached(self, name: str, make: Callable[[], _T]) -> _T:
        # An array made while another thread adds points belongs to the cache of before.
        cache = self._cache
        if name not in cache:
            cache[name] = make()
        value: _T = cache[name]
        return value

    def _read(self, work: Callable[[Handle, Callable[[], bool]], _T], is_long: bool) -> _T:
        """Reads by the work, which signals interrupt if it is long. See `interruptibly`."""

        def read(is_left: Callable[[], bool]) -> _T:
            with self._gate.reading(is_left):
                return work(self._held(), is_left)

        self._gate.refuse_if_kept_out()
        return interruptibly(read, is_long)

    def _exported(self, name: str) -> Any:
        """What the method of the handle that has that name gives."""

        def export(handle: Handle) -> Any:
            return getattr(handle, name)()

        def read() -> Any:
            result: Any = self._read_long(export)
            return result

        return self._cached(name, read)

    def _fresh(self, *names: str) -> list[Any]:
        """What the methods of the handle that have these names give, all of one state, in arrays of
        their own: the user may have written into those that attributes gave."""
        return self._read_long(lambda handle: [getattr(handle, name)() for name in names])

    @property
    def _state(self) -> object:
        """Another object after each change of the points."""
        return self._cache

    @property
    def _is_released(self) -> bool:
        return self._handle is None

    def _read_long(self, work: Callable[[Handle], _T]) -> _T:
        """Reads by the work, which signals interrupt where there are many points."""
        return self._read(lambda handle, _: work(handle), self.npoints >= LONG_EXPORT)

    def _kept(self, handle: Handle, name: str) -> Any:
        """The same of one method, which is kept for the next time."""
        return self._cached("kept " + name, getattr(handle, name))

    # Points in

    def _insert(self, points: FloatArray, restart: bool = False) -> None:
        self._change(
            lambda insertion: self._insert_by(insertion, points, restart),
            len(points) + (self.npoints if restart else 0),
        )

    def _change(self, change: Callable[[Insertion], None], n: int) -> None:
        """Makes a change of n points, which can be stopped."""
        insertion = Insertion(self._gate.guarded(self.progress))
        caller = threading.get_ident()

        # All that must not be left half done, since signals may cut short the thread that waits.
        def work() -> None:
            with self._gate.writing(caller, lambda: insertion.has_to_end) as got_in:
                if not got_in:
                    raise _errors.make(_errors.CANCELLED, "cancelled before the first point")
                try:
                    self._running = insertion
                    change(insertion)
                finally:
                    self._running = None

        self._gate.refuse_if_kept_out()
        insertion.run(work, n)

    def _insert_by(self, insertion: Insertion, points: FloatArray, restart: bool) -> None:
        handle = self._held()
        absent = np.empty(0, dtype=np.int32)
        if restart:
            absent = np.flatnonzero(handle.point_map() < 0).astype(np.int32)
            if not finite_rows(points).all():
                raise _errors.make(_errors.NOT_FINITE, describe_not_finite(points, "points"))
            points = np.concatenate([self._store.all, points])
            handle.clear()
            self._store, self._batches, self._cache = PointStore(copies=True), [], {}
        before = handle.point_count
        try:
            handle.insert(points, insertion, "points")
        finally:
            # Also after an insertion that was stopped: its points have their indices.
            if handle.point_count > before:
                self._store.append(points)
                self._batches.append(len(points))
                self._cache = {}
                # What was out stays out.
                back = absent[handle.point_map()[absent] >= 0]
                if len(back) > 0:
                    handle.remove(back, Insertion(None))

    def add_points(self, points: ArrayLike, restart: bool = False) -> None:
        """Adds points; they get the next indices.

        Parameters
        ----------
        points : array_like of float, shape (m, 3)
            Any number of points, also none.
        restart : bool, optional
            Whether to triangulate all points anew. The tetrahedra are the same either way; their
            numbers may differ.

        Raises
        ------
        RuntimeError
            If the object was made without ``incremental=True``, or is closed.
        Exception
            What the constructor raises. After ValueError and TypeError nothing has changed. After
            `Cancelled`, `OutOfMemoryError` and KeyboardInterrupt the triangulation is that of the
            points that got in; all of the call's points are in `points`, and `point_map` is -1 for
            those that are not in. They can be added again, under new indices.

        Notes
        -----
        Adding points in many rounds is cheap: a point costs the same however many are there. Since
        1.0.
        """
        self._require_incremental("added")
        self._insert(as_points(points), restart)

    def _require_incremental(self, change: str) -> None:
        if not self._incremental or self._closed:
            raise RuntimeError(
                f"points can be {change} only in Delaunay(points, incremental=True) before close()"
            )

    # Points out, and moved

    def remove_points(self, points: ArrayLike) -> None:
        """Takes points out, given by their indices. The others keep theirs.

        Parameters
        ----------
        points : array_like of int, shape (m,)
            Each once, in any order; or a mask, array_like of bool, shape (npoints,).

        Raises
        ------
        RuntimeError
            If the object was made without ``incremental=True``, or is closed.
        ValueError
            For an index of no point, of one that is not in, or that is there twice. Nothing has
            changed then.
        Exception
            What the constructor raises. After `Cancelled`, `OutOfMemoryError` and KeyboardInterrupt
            some of the points are out: `point_map` is -1 for them.

        Notes
        -----
        A point that is out stays in `points`; `renumber_points` forgets it. Since 1.2.
        """
        self._require_incremental("removed")
        indices = self._indices(points)

        def remove(insertion: Insertion) -> None:
            try:
                self._held().remove(indices, insertion)
            finally:
                self._cache = {}

        self._change(remove, len(indices))

    def move_points(self, xyz: ArrayLike, points: Optional[ArrayLike] = None) -> None:
        """Moves points. They keep their indices.

        Parameters
        ----------
        xyz : array_like of float, shape (m, 3)
            Where the points go.
        points : array_like of int, shape (m,), optional
            Which points, by their indices, each once; or a mask, array_like of bool, shape
            (npoints,). None for all: then those that are not in stay out, and their rows of `xyz`
            are not looked at.

        Raises
        ------
        RuntimeError
            If the object was made without ``incremental=True``, or is closed.
        ValueError
            For what the constructor and `remove_points` refuse. Nothing has changed then.
        Exception
            What the constructor raises. After `Cancelled`, `OutOfMemoryError` and KeyboardInterrupt
            some of the points have moved; `points` says where each is.

        Notes
        -----
        `points` becomes another array. Since 1.2.
        """
        self._require_incremental("moved")
        places = np.ascontiguousarray(as_points(xyz))
        listed = None if points is None else self._indices(points)

        def move(insertion: Insertion) -> None:
            handle = self._held()
            indices, rows = listed, places
            if indices is None:
                indices = np.arange(handle.point_count, dtype=np.int32)
            if len(indices) != len(rows):
                raise ValueError(f"there are {len(indices)} points and {len(rows)} places")
            if listed is None:
                is_in = handle.point_map() >= 0
                if not is_in.all():
                    indices, rows = indices[is_in], np.ascontiguousarray(rows[is_in])
            now = self._store.all.copy()
            before = handle.moved_count()
            is_done = False
            try:
                handle.move(indices, rows, insertion)
                is_done = True
            finally:
                # The library counts those that changed.
                stays = 0 if is_done else handle.moved_count() - before
                changed = np.flatnonzero((now[indices] != rows).any(axis=1)) if stays else None
                size = len(indices) if is_done else 0 if changed is None else changed[stays - 1] + 1
                now[indices[:size]] = rows[:size]
                self._store.replace(now)
                self._cache = {}

        self._change(move, len(places))

    def renumber_points(self) -> IndexArray:
        """Numbers the points that are in anew, in their order, and forgets the others.

        Returns
        -------
        ndarray of int32, shape (npoints,) as it was
            For each point its new index; -1 if it was not in.

        Notes
        -----
        `points` becomes another array. Since 1.2.
        """
        self._require_incremental("renumbered")
        with self._writing() as handle:
            kept = self._store.all[handle.point_map() >= 0]
            index = handle.renumber()
            self._store.replace(kept)
            self._batches = [len(self._store.all)]
            self._cache = {}
            return index

    def _indices(self, points: ArrayLike) -> IndexArray:
        array = np.asarray(points)
        if array.dtype == np.bool_:
            if array.shape != (self.npoints,):
                raise ValueError(f"the mask has shape {array.shape}; it must be ({self.npoints},)")
            array = np.flatnonzero(array)
        if array.size == 0:
            return np.empty(0, dtype=np.int32)
        if array.ndim != 1 or not np.issubdtype(array.dtype, np.integer):
            raise ValueError(
                f"points are {array.dtype} of shape {array.shape}; they must be integers of shape (m,)"
            )
        # An index that does not fit is one of no point.
        for index in (array.min(), array.max()):
            if not 0 <= index < self.npoints:
                raise ValueError(f"there is no point {index}: {self.npoints} were given, counted from 0")
        return np.ascontiguousarray(array, dtype=np.int32)

    def close(self) -> None:
        """Ends adding of points, as in SciPy. All else stays; see `release`. Since 1.0."""
        self._closed = True

    def release(self) -> None:
        """Gives the library's memory back now, not when the object goes.

        Arrays that were read stay; whatever still needs the library raises RuntimeError. A
        ``with`` statement releases at its end. A call that Ctrl-C has interrupted may go on without
        a result: the memory then goes when that ends. Since 1.0.
        """
        with self._gate.writing(beside_left=True):
            self._closed = True
            self._handle = None

    def __enter__(self: _Self) -> _Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.release()

    def cancel(self) -> None:
        """Stops the insertion that runs on another thread; it raises `Cancelled` there.

        Without one, nothing happens. Since 1.0.
        """
        running = self._running
        if running is not None:
            running.stop()

    @staticmethod
    def _bytes(limit: Optional[int]) -> int:
        return whole(limit or 0, "memory_limit", 0, 2**63 - 1)

    @property
    def memory_limit(self) -> Optional[int]:
        """Bytes that the triangulation may hold in the library; None for no limit. May be set.

        Arrays for the caller do not count; what the library needs to make them, or to check, does.
        """
        return self._settings["memory_limit"] or None

    @memory_limit.setter
    def memory_limit(self, limit: Optional[int]) -> None:
        limit_in_bytes = self._bytes(limit)
        with self._writing() as handle:
            handle.set_memory_limit(limit_in_bytes)
            self._settings["memory_limit"] = limit_in_bytes

    @property
    def compact(self) -> bool:
        """Whether storage is compact: 30 % less memory, 20 to 40 % more time. May be set.

        The arrays are the same. Set after the last points, it gives memory back; taken back, the
        library needs that memory again and may raise OutOfMemoryError, with nothing changed. Since
        1.1.
        """
        return bool(self._settings["compact"])

    @compact.setter
    def compact(self, on: bool) -> None:
        with self._writing() as handle:
            handle.set_compact(bool(on))
            self._settings["compact"] = bool(on)

    @property
    def order(self) -> str:
        """The order scheme, as given to the constructor. Since 1.2."""
        return str(self._settings["order"])

    @property
    def order_parameters(self) -> dict[str, Union[float, str]]:
        """The parameters of the order scheme that were given to the constructor. Since 1.2."""
        return dict(self._settings["order_parameters"])

    @property
    def seed(self) -> int:
        """The seed of the order schemes that shuffle. Since 1.2."""
        return int(self._settings["seed"])

    @property
    def threads(self) -> int:
        """How many threads a call may use; 0 for all cores. May be set. Since 1.2."""
        return int(self._settings["threads"])

    @threads.setter
    def threads(self, threads: int) -> None:
        count = whole(threads, "threads", 0, 2**31 - 1)
        with self._writing() as handle:
            handle.set_threads(count)
            self._settings["threads"] = count

    @property
    def canonical(self) -> bool:
        """Whether arrays are a function of the set of points alone. Since 1.2."""
        return bool(self._settings["canonical"])

    def shrink(self) -> None:
        """Frees what the library keeps for speed alone: room for more points, working arrays, where
        locations start. All is made again when it is wanted.

        Arrays that were read are Python's and stay. Since 1.2.
        """
        with self._writing() as handle:
            handle.shrink()

    # What is in

    @property
    def points(self) -> FloatArray:
        """All points ever given, where they are now, shape (npoints, 3)."""
        return self._store.all

    @property
    def npoints(self) -> int:
        """Number of points ever given, those left out that `renumber_points` forgot."""
        return len(self._store.all)

    @property
    def nsimplex(self) -> int:
        """Number of tetrahedra."""
        with self._reading() as handle:
            return handle.tetrahedron_count

    # Copies for other processes: the same calls again give the same simplices, in another order where
    # points were removed or moved.

    def __getstate__(self) -> dict[str, Any]:
        with self._reading() as handle:
            point_map = handle.point_map()
            points = self.points.copy()
            batches = list(self._batches)
        return {
            "absent": np.flatnonzero(point_map < 0),
            "points": points,
            "batches": batches,
            "settings": self._settings,
            "incremental": self._incremental,
            "closed": self._closed,
        }

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.progress = None
        self._settings = {"compact": False, **state["settings"]}  # 1.0 had no such setting
        self._begin(state["incremental"])
        ends = np.cumsum(state["batches"], dtype=np.int64)
        for begin, end in zip(np.concatenate([[0], ends]), ends):
            self._insert(state["points"][begin:end])
        # States of before 1.2 have no such points.
        absent = state.get("absent", np.empty(0, dtype=np.int64))
        if len(absent) > 0:
            self.remove_points(absent)
        self._closed = state["closed"]

    def __repr__(self) -> str:
        if self._handle is None:
            return f"<mgdt.Delaunay: {self.npoints} points, released>"
        return f"<mgdt.Delaunay: {self.npoints} points, {self.nsimplex} tetrahedra>"


def _show_as(name: str) -> None:
    """Gives the functions the name of the class that users know, for messages."""
    for member in vars(GrowingTriangulation).values():
        parts = [getattr(member, part, None) for part in ("__func__", "fget", "fset")]
        for function in (member, *parts):
            if isinstance(function, FunctionType):
                function.__qualname__ = f"{name}.{function.__name__}"


_show_as("Delaunay")
