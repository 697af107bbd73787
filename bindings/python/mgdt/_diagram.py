# SPDX-License-Identifier: MIT
"""What Voronoi diagrams of points and of periodic boxes share: arrays of the library, as SciPy names
them."""

from __future__ import annotations

import ctypes
from functools import cached_property, partial
from typing import Any, Callable, Iterator, TypeVar

import numpy as np
from numpy.typing import NDArray

from . import _errors, _library
from ._arrays import FloatArray, IndexArray, address
from ._interface import CONSTANTS

_T = TypeVar("_T")
_ARRAYS = CONSTANTS["voronoi"]


def _array(diagram: ctypes.c_void_p, key: int) -> NDArray[Any]:
    library, size = _library.library, ctypes.c_int64()
    library.mgdt_voronoi_get_size(diagram, key, ctypes.byref(size))
    is_real = key >= _ARRAYS["vertices"]
    values = np.empty(size.value, dtype=np.float64 if is_real else np.int32)
    name = "mgdt_voronoi_get_doubles" if is_real else "mgdt_voronoi_get_array_i32"
    status = getattr(library, name)(diagram, key, size.value, address(values))
    if status != _errors.OK:
        raise _errors.make(status, "the diagram is too large for indices of 32 bits")
    return values


def cell_areas(arrays: dict[str, NDArray[Any]]) -> FloatArray:
    """The total area of the faces of each cell."""
    offsets = arrays["cell_offsets"]
    areas = np.zeros(len(offsets) - 1)
    has_faces = offsets[1:] > offsets[:-1]
    if has_faces.any():
        of_faces = arrays["face_areas"][arrays["cell_faces"]]
        areas[has_faces] = np.add.reduceat(of_faces, offsets[:-1][has_faces])
    return areas


def taken_diagram(diagram: ctypes.c_void_p, area: float, share: float) -> dict[str, NDArray[Any]]:
    """The arrays of a diagram of the library by their names, without the faces that are smaller, and then
    "cell_areas", with them. The diagram is freed."""
    more = {}
    try:
        if area > 0 or share > 0:
            names = ("cell_offsets", "cell_faces", "face_areas")
            more["cell_areas"] = cell_areas({name: _array(diagram, _ARRAYS[name]) for name in names})
            status = _library.library.mgdt_voronoi_drop_small_faces(diagram, area, share)
            if status != _errors.OK:
                raise _errors.make(status, "memory for the faces that stay was refused")
        return {**{name: _array(diagram, key) for name, key in _ARRAYS.items()}, **more}
    finally:
        _library.library.mgdt_voronoi_destroy(diagram)


def blocks(count: int, is_left: Callable[[], bool]) -> Iterator[slice]:
    """Slices short enough that between them a thread that waits gets its turn."""
    size = 1 << 14
    for begin in range(0, count, size):
        if is_left():
            return
        yield slice(begin, begin + size)


def lists(
    flat: NDArray[Any], offsets: NDArray[Any], is_left: Callable[[], bool]
) -> list[list[Any]]:
    """One list from each offset to the next."""
    found: list[list[Any]] = []
    for block in blocks(len(offsets) - 1, is_left):
        ends = offsets[block.start : block.stop + 1]
        values = flat[ends[0] : ends[-1]].tolist()
        steps = (ends - ends[0]).tolist()
        found += [values[begin:end] for begin, end in zip(steps, steps[1:])]
    return found


class Diagram:
    """Vertices, faces and cells. A subclass sets `points`, `_point_map` and `_arrays`, and then calls
    `_begin`."""

    points: FloatArray
    _point_map: IndexArray
    _arrays: dict[str, NDArray[Any]]

    def _aside(self, work: Callable[[Callable[[], bool]], _T]) -> _T:
        """Does work that signals interrupt where there are many points."""
        raise NotImplementedError

    def _begin(self) -> None:
        if not self._arrays:
            raise ValueError("there are no cells: all points are in one plane, or fewer than four")
        arrays = self._arrays
        self.vertices: FloatArray = arrays["vertices"].reshape(-1, 3)
        self.ridge_points: IndexArray = arrays["face_sides"].reshape(-1, 2)
        self.ridge_areas: FloatArray = arrays["face_areas"]
        self.ridge_normals: FloatArray = arrays["face_normals"].reshape(-1, 3)
        self.ridge_centroids: FloatArray = arrays["face_centroids"].reshape(-1, 3)
        self.ray_vertices: IndexArray = arrays["ray_vertices"]
        self.ray_directions: FloatArray = arrays["ray_directions"].reshape(-1, 3)
        self.volumes: FloatArray = arrays["cell_volumes"]
        """Volumes of the points' cells, within 1e-12; infinite where a cell has no end."""
        self.centroids: FloatArray = arrays["cell_centroids"].reshape(-1, 3)
        """Centroids of the points' cells, likewise."""
        self.ridge_offsets: IndexArray
        self.ridge_list: IndexArray
        self.ridge_rays: IndexArray
        self.point_region: IndexArray
        self._aside(self._build)

    def _build(self, _is_left: Callable[[], bool]) -> None:
        number = np.arange(len(self.points), dtype=np.int32)
        is_vertex = self._point_map == number
        region_of = np.full(len(self.points) + 1, -1, dtype=np.int32)
        region_of[:-1][is_vertex] = np.arange(is_vertex.sum(), dtype=np.int32)
        self.point_region = region_of[self._point_map]
        # In place of the two rays at the end of a face, -1 at its beginning.
        corners, offsets = self._arrays["face_corners"], self._arrays["face_offsets"]
        is_open = corners[offsets[1:] - 1] < 0
        self.ridge_rays = np.full((len(is_open), 2), -1, dtype=np.int32)
        ends = offsets[1:][is_open]
        self.ridge_rays[is_open] = np.column_stack([-1 - corners[ends - 2], -1 - corners[ends - 1]])
        sizes = np.diff(offsets)
        self.ridge_offsets = np.zeros(len(offsets), dtype=np.int32)
        np.cumsum(sizes - is_open, out=self.ridge_offsets[1:])
        self.ridge_list = np.full(self.ridge_offsets[-1], -1, dtype=np.int32)
        is_vertex = corners >= 0
        shift = self.ridge_offsets[:-1] + is_open - offsets[:-1]
        place = np.arange(len(corners)) + np.repeat(shift, sizes)
        self.ridge_list[place[is_vertex]] = corners[is_vertex]

    @property
    def npoints(self) -> int:
        """Number of points given."""
        return len(self.points)

    @property
    def ndim(self) -> int:
        """3."""
        return 3

    @property
    def min_bound(self) -> FloatArray:
        """Least coordinates of the points."""
        low: FloatArray = self.points.min(axis=0)
        return low

    @property
    def max_bound(self) -> FloatArray:
        """Largest coordinates of the points."""
        high: FloatArray = self.points.max(axis=0)
        return high

    @cached_property
    def ridge_vertices(self) -> list[list[int]]:
        """The vertices of each face in turn, -1 standing for infinity."""
        return self._aside(partial(lists, self.ridge_list, self.ridge_offsets))

    @cached_property
    def regions(self) -> list[list[int]]:
        """The vertices of each cell, ascending, -1 first where the cell has no end."""
        return self._aside(self._make_regions)

    def _make_regions(self, is_left: Callable[[], bool]) -> list[list[int]]:
        # Region and vertex in one number, which NumPy sorts much faster than pairs. Infinity is 0.
        width = len(self.vertices) + 1
        faces, cells = self._arrays["cell_faces"], self._arrays["cell_offsets"]
        of_face = np.repeat(self.point_region.astype(np.int64), np.diff(cells))
        sizes = np.diff(self.ridge_offsets)[faces]
        ends = np.cumsum(sizes)
        corner = np.arange(ends[-1] if len(ends) else 0) + np.repeat(
            self.ridge_offsets[:-1][faces] - (ends - sizes), sizes
        )
        keys = np.repeat(of_face, sizes) * width + self.ridge_list[corner] + 1
        of_region, vertices = np.divmod(np.unique(keys), width)
        offsets = np.searchsorted(of_region, np.arange(self.point_region.max(initial=-1) + 2))
        return lists(vertices - 1, offsets, is_left)

    @cached_property
    def neighbors(self) -> list[list[int]]:
        """For each point, the points whose cells share a face with its cell, and -1 - k for plane k
        of the region, by the numbers of the faces. Since 1.3."""
        faces, offsets = self._arrays["cell_faces"], self._arrays["cell_offsets"]
        point = np.repeat(np.arange(len(self.points)), np.diff(offsets))
        sides = self.ridge_points[faces]
        others = np.where(sides[:, 0] == point, sides[:, 1], sides[:, 0])
        return self._aside(partial(lists, others, offsets))
