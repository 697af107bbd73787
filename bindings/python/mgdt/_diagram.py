# SPDX-License-Identifier: MIT
"""What Voronoi diagrams of points and of periodic boxes share: arrays of the library, as SciPy names
them."""

from __future__ import annotations

import ctypes
from functools import cached_property, partial
from typing import Any, Callable, Iterator, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from . import _errors
from ._arrays import FloatArray, IndexArray
from ._interface import CONSTANTS
from ._keyed import Keyed

_T = TypeVar("_T")


class Cells(Keyed):
    """A diagram of the library."""

    kind = "voronoi"


# The other arrays follow from these, and are made when they are asked for.
_ARRAYS = [
    name
    for name in CONSTANTS["voronoi_array"]
    if "neighbor" not in name and name != "cell_face_areas"
]


class NeighborList(NamedTuple):
    """The neighbours of all points in one list: those of point i are
    ``neighbors[indptr[i]:indptr[i + 1]]``, and so are the other arrays. Since 1.3.

    Attributes
    ----------
    indptr : ndarray of int, shape (n + 1,)
    neighbors : ndarray of int, shape (m,)
        The points whose cells share a face with the cell; -1 - k for plane k of the region.
    shifts : ndarray of int, shape (m, 3)
        How often each vector of the periodic box has to be added to the neighbour to get its image at
        the face; 0 if there is no box.
    areas, distances : ndarray of float, shape (m,)
        The area of the face, and the distance of the point from the neighbour or the plane.
    """

    indptr: IndexArray
    neighbors: IndexArray
    shifts: IndexArray
    areas: FloatArray
    distances: FloatArray


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
    cells = Cells(diagram)
    more = {}
    if area > 0 or share > 0:
        names = ("cell_offsets", "cell_faces", "face_areas")
        more["cell_areas"] = cell_areas({name: cells.array(name) for name in names})
        cells.call("drop_small_faces", area, share)
    return {**{name: cells.array(name) for name in _ARRAYS}, **more}


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
    _planes: FloatArray  # of the region, with a, b, c, d each; only if there is one

    def _aside(self, work: Callable[[Callable[[], bool]], _T]) -> _T:
        """Does work that signals interrupt where there are many points."""
        raise NotImplementedError

    def _begin(self) -> None:
        if not self._arrays:
            raise _errors.make(
                _errors.INVALID_ARGUMENT,
                "there are no cells: all points are in one plane, or fewer than four",
            )
        arrays = self._arrays
        self.vertices: FloatArray = arrays["vertices"]
        self.ridge_points: IndexArray = arrays["face_sides"]
        self.ridge_areas: FloatArray = arrays["face_areas"]
        self.ridge_normals: FloatArray = arrays["face_normals"]
        self.ridge_centroids: FloatArray = arrays["face_centroids"]
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
        offsets = self._arrays["cell_offsets"]
        return self._aside(partial(lists, self._other_sides()[1], offsets))

    def _other_sides(self) -> tuple[IndexArray, IndexArray, NDArray[np.bool_]]:
        """For each face of each cell the cell, the other side, and whether the cell is the first side."""
        faces, offsets = self._arrays["cell_faces"], self._arrays["cell_offsets"]
        cells = np.repeat(np.arange(len(self.points), dtype=np.int32), np.diff(offsets))
        first, second = self._arrays["face_sides"][faces].T
        is_first = first == cells
        return cells, np.where(is_first, second, first), is_first

    @cached_property
    def neighbor_list(self) -> NeighborList:
        """The neighbours of all points in one list, with areas and distances. Since 1.3."""
        return self._aside(self._make_neighbor_list)

    def _make_neighbor_list(self, _is_left: Callable[[], bool]) -> NeighborList:
        cells, others, is_first = self._other_sides()
        faces = self._arrays["cell_faces"]
        shifts = np.zeros((len(faces), 3), dtype=np.int32)
        if len(self._arrays["face_shifts"]):
            shifts = self._arrays["face_shifts"][faces]
            shifts[~is_first] *= -1
        ways = self._places(others, shifts) - self.points[cells]
        distances = np.sqrt(np.einsum("ij,ij->i", ways, ways))
        is_plane = others < 0
        if is_plane.any():
            planes = self._planes[-1 - others[is_plane]]
            heights = planes[:, 3] - np.einsum(
                "ij,ij->i", planes[:, :3], self.points[cells[is_plane]]
            )
            distances[is_plane] = heights / np.linalg.norm(planes[:, :3], axis=1)
        return NeighborList(
            self._arrays["cell_offsets"], others, shifts, self._arrays["face_areas"][faces], distances
        )

    def _places(self, points: IndexArray, shifts: IndexArray) -> FloatArray:
        """Where images of points are."""
        raise NotImplementedError
