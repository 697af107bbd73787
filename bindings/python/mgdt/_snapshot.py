# SPDX-License-Identifier: MIT
"""What is made of a triangulation as it is, and stays so when that goes on."""

from __future__ import annotations

from typing import Any, Callable, TypeVar

import numpy as np

from ._arrays import FloatArray, IndexArray
from ._gate import interruptibly
from ._handle import Handle
from ._triangulation import LONG_EXPORT
from .delaunay import Delaunay

_T = TypeVar("_T")


class Snapshot:
    """Base of what is made of points or of their triangulation."""

    def __init__(self, points: Any, settings: dict[str, Any]) -> None:
        self._is_made = not isinstance(points, Delaunay)
        self.delaunay: Delaunay = Delaunay(points, **settings) if self._is_made else points
        if settings and not self._is_made:
            names = ", ".join(settings)
            raise TypeError(f"{names}: a Delaunay object has its settings already")
        self.points: FloatArray
        self._point_map: IndexArray
        self._read_state()

    def _read_state(self) -> None:
        # All of one state of the triangulation.
        def take(handle: Handle) -> None:
            self._state = self.delaunay._state
            self.points = self.delaunay.points.copy()
            self._point_map = handle.point_map()
            self._take(handle)

        self.delaunay._read_long(take)

    def _take(self, handle: Handle) -> None:
        """Takes what the triangulation has to give, in arrays of its own."""
        raise NotImplementedError

    def _aside(self, work: Callable[[Callable[[], bool]], _T]) -> _T:
        """Does work in NumPy that signals interrupt where there are many points. The work is given a
        function that says whether it has been left; it may then end early, and give anything."""
        return interruptibly(work, len(self.points) >= LONG_EXPORT)

    def _measured(self, measure: Callable[[Handle], _T]) -> _T:
        """What the library measures in the triangulation that this was made of: in that itself, or
        where it went on, in one of the points as they were."""
        result: list[_T] = []

        def work(handle: Handle) -> None:
            if self.delaunay._state is self._state:
                result.append(measure(handle))

        try:
            self.delaunay._read_long(work)
        except RuntimeError:
            if not self.delaunay._is_released:
                raise
        if not result:
            again = Delaunay(self.points, incremental=True)
            again.remove_points(np.flatnonzero(self._point_map < 0))
            return again._read_long(measure)
        return result[0]
