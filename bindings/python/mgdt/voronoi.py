# SPDX-License-Identifier: MIT
"""The Voronoi diagram, in the meaning of ``scipy.spatial.Voronoi``."""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property, partial
from typing import Any, Callable, Iterator, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import FloatArray, IndexArray, as_planes
from ._handle import Handle
from ._snapshot import Snapshot

# Edge k of a tetrahedron joins the first two; the four are an even permutation of 0, 1, 2, 3.
_EDGES = np.array(
    [[0, 1, 2, 3], [0, 2, 3, 1], [0, 3, 1, 2], [1, 2, 0, 3], [1, 3, 2, 0], [2, 3, 0, 1]]
)
# The edge that joins two places of a tetrahedron.
_EDGE_OF = np.full((4, 4), -1)
for _k, (_a, _b, _, _) in enumerate(_EDGES):
    _EDGE_OF[_a, _b] = _EDGE_OF[_b, _a] = _k


def _volume_is_zero(corners: FloatArray) -> bool:
    """Of a tetrahedron, exactly."""
    p, *others = [[Fraction(x) for x in corner] for corner in corners.tolist()]
    u, v, w = ([x - y for x, y in zip(q, p)] for q in others)
    volume = sum(
        u[k] * (v[k - 2] * w[k - 1] - v[k - 1] * w[k - 2]) for k in range(3)
    )
    return volume == 0


def _blocks(count: int, is_left: Callable[[], bool]) -> Iterator[slice]:
    """Slices short enough that between them a thread that waits gets its turn."""
    size = 1 << 14
    for begin in range(0, count, size):
        if is_left():
            return
        yield slice(begin, begin + size)


def _lists(
    flat: NDArray[Any], offsets: NDArray[Any], is_left: Callable[[], bool]
) -> list[list[int]]:
    """One list from each offset to the next."""
    lists: list[list[int]] = []
    for block in _blocks(len(offsets) - 1, is_left):
        ends = offsets[block.start : block.stop + 1]
        values = flat[ends[0] : ends[-1]].tolist()
        steps = (ends - ends[0]).tolist()
        lists += [values[begin:end] for begin, end in zip(steps, steps[1:])]
    return lists


def _planes_of_box(bounds: Optional[ArrayLike]) -> FloatArray:
    if bounds is None:
        return np.empty((0, 4))
    box = np.asarray(bounds, dtype=np.float64)
    if box.shape != (2, 3) or not (box[0] < box[1]).all():
        raise ValueError(
            "bounds must be the least and the largest coordinates of a box, of shape (2, 3), not "
            f"{bounds!r}"
        )
    normals = np.eye(3)
    return np.column_stack([np.concatenate([-normals, normals]), np.append(-box[0], box[1])])


class Voronoi(Snapshot):
    """Voronoi diagram of points in space: the cells of what is nearest to each point.

    What has a name in ``scipy.spatial.Voronoi`` has the same name, shape and meaning here. Vertices
    that are equidistant from more than four points are one, decided by their exact values, so that
    the cells of a lattice are those of the lattice.

    Parameters
    ----------
    points : array_like of float, shape (n, 3), or Delaunay
        The points, or their triangulation.
    furthest_site : bool, optional
        Must be false: there is no diagram of what is farthest.
    incremental : bool, optional
        Whether `add_points` may be called. Not with a triangulation, which grows by itself.
    qhull_options : str, optional
        As `Delaunay`.
    planes : array_like of float, shape (k, 4), optional
        Bound the region that `volumes`, `areas` and `centroids` are clipped to: a, b, c, d each,
        where a x + b y + c z <= d.
    bounds : array_like of float, shape (2, 3), optional
        A box that bounds it too: its least and its largest coordinates.
    **settings
        Of `Delaunay`.

    Attributes
    ----------
    delaunay : Delaunay
    points : ndarray of float, shape (n, 3)
    vertices : ndarray of float, shape (nvertices, 3)
    ridge_points : ndarray of int, shape (nridges, 2)
        The two points that each face is between.
    ridge_offsets, ridge_list : ndarray of int
        The vertices of face k, in turn around it, are
        ``ridge_list[ridge_offsets[k]:ridge_offsets[k + 1]]``; -1, which comes first, is at infinity.
    point_region : ndarray of int, shape (n,)
        The region of each point, that of its twin for one that repeats an earlier one; -1 of one that
        is not in.

    Notes
    -----
    A diagram stays that of the points as they were when it was made, also if the triangulation goes
    on. What takes long is computed when it is asked for, and once. Since 1.2.

    Examples
    --------
    >>> import mgdt, numpy
    >>> lattice = numpy.indices((3, 3, 3)).reshape(3, -1).T
    >>> diagram = mgdt.Voronoi(lattice)
    >>> len(diagram.vertices)
    8
    >>> float(diagram.volumes[13])
    1.0
    """

    furthest_site = False

    def __init__(
        self,
        points: Any,
        furthest_site: bool = False,
        incremental: bool = False,
        qhull_options: Union[None, str, bytes] = None,
        *,
        planes: Optional[ArrayLike] = None,
        bounds: Optional[ArrayLike] = None,
        **settings: Any,
    ) -> None:
        if not isinstance(furthest_site, (bool, np.bool_)):
            raise TypeError(
                f"furthest_site must be a bool, not {type(furthest_site).__name__}; give planes and "
                "bounds by name"
            )
        if furthest_site:
            raise ValueError("mgdt has no furthest-site diagram")
        if incremental:
            settings["incremental"] = True
        if qhull_options is not None:
            settings["qhull_options"] = qhull_options
        self._planes = np.concatenate([as_planes(planes), _planes_of_box(bounds)])
        super().__init__(points, settings)
        self._begin()

    def _begin(self) -> None:
        if len(self._simplices) == 0:
            raise ValueError("there are no cells: all points are in one plane, or fewer than four")
        self.vertices: FloatArray
        self.ridge_points: IndexArray
        self.ridge_offsets: IndexArray
        self.ridge_list: IndexArray
        self.point_region: IndexArray
        if len(self._planes):
            # The library says what is wrong with them, before the rest takes its time.
            self.volumes  # pylint: disable=pointless-statement
        self._aside(self._build)

    def _take(self, handle: Handle) -> None:
        self._simplices: IndexArray = handle.tetrahedra()
        self._neighbors: IndexArray = handle.neighbors()
        self._hull: IndexArray = handle.hull_facets()
        self._centers, self._squares = handle.circumcenters()

    def _build(self, is_left: Callable[[], bool]) -> None:
        is_vertex = np.unique(self._simplices)
        region_of = np.full(len(self.points) + 1, -1, dtype=np.int32)
        region_of[is_vertex] = np.arange(len(is_vertex), dtype=np.int32)
        self.point_region = region_of[self._point_map]
        self.vertices, self._vertex_of = self._join_vertices()
        if not is_left():
            self.ridge_points, self.ridge_offsets, self.ridge_list = self._faces(is_left)

    def add_points(self, points: ArrayLike, restart: bool = False) -> None:
        """Makes the diagram one of more points. What was computed of the diagram before is forgotten.

        Parameters
        ----------
        points, restart
            As `Delaunay.add_points`.

        Raises
        ------
        RuntimeError
            If the diagram was made without ``incremental=True``, or is closed.
        TypeError
            If it was made of a triangulation: add them there, and make another diagram.
        """
        if not self._is_made:
            raise TypeError(
                "this diagram was made of a Delaunay object: add the points to that, and make another "
                "diagram of it"
            )
        self.delaunay.add_points(points, restart)
        for name in ("regions", "ridge_vertices", "ridge_dict", "volumes", "areas", "centroids"):
            self.__dict__.pop(name, None)
        self._read_state()
        self._begin()

    def close(self) -> None:
        """Ends `add_points`. The diagram stays as it is."""
        if self._is_made:
            self.delaunay.close()

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
        return self._aside(partial(_lists, self.ridge_list, self.ridge_offsets))

    @cached_property
    def ridge_dict(self) -> dict[tuple[int, int], list[int]]:
        """From the two points of each face to its vertices."""
        vertices = self.ridge_vertices

        def pair(is_left: Callable[[], bool]) -> dict[tuple[int, int], list[int]]:
            found: dict[tuple[int, int], list[int]] = {}
            for block in _blocks(len(vertices), is_left):
                for (a, b), of_face in zip(self.ridge_points[block].tolist(), vertices[block]):
                    found[a, b] = of_face
            return found

        return self._aside(pair)

    @cached_property
    def regions(self) -> list[list[int]]:
        """The vertices of each cell, ascending, -1 first where the cell has no end."""
        return self._aside(self._make_regions)

    def _make_regions(self, is_left: Callable[[], bool]) -> list[list[int]]:
        # Region and vertex in one number, which NumPy sorts much faster than pairs. Infinity is 0.
        width = len(self.vertices) + 1
        region = self.point_region[self._simplices.ravel()].astype(np.int64)
        keys = region * width + np.repeat(self._vertex_of, 4) + 1
        hull = self.point_region[np.unique(self._hull)].astype(np.int64) * width
        of_region, vertices = np.divmod(np.unique(np.append(keys, hull)), width)
        offsets = np.searchsorted(of_region, np.arange(self.point_region.max() + 2))
        return _lists(vertices - 1, offsets, is_left)

    @cached_property
    def volumes(self) -> FloatArray:
        """Volumes of the points' cells, within 1e-12; infinite where a cell has no end."""
        return self._cell_measures("volume")

    @cached_property
    def areas(self) -> FloatArray:
        """Areas of the surfaces of the points' cells, likewise."""
        return self._cell_measures("area")

    @cached_property
    def centroids(self) -> FloatArray:
        """Centroids of the points' cells, likewise, shape (n, 3)."""
        return self._cell_measures("centroid")

    def _cell_measures(self, measure: str) -> FloatArray:
        return self._measured(lambda handle: handle.cell_measures(measure, self._planes))

    def _join_vertices(self) -> tuple[FloatArray, IndexArray]:
        """Circumcentres of spheres that differ, in the order of their first simplices, and the
        number of each simplex's: simplices on one sphere have equal numbers, rounded once."""
        centers, squares = self._centers, self._squares
        order = np.lexsort((squares, *centers.T))
        sorted_ = np.column_stack([centers, squares])[order]
        is_new = np.ones(len(order), dtype=np.bool_)
        is_new[1:] = (sorted_[1:] != sorted_[:-1]).any(axis=1)
        number = np.empty(len(order), dtype=np.int32)
        number[order] = np.cumsum(is_new) - 1
        first = np.full(number.max() + 1, len(order))
        np.minimum.at(first, number, np.arange(len(order)))
        by_first = np.argsort(first)
        rank = np.empty_like(by_first)
        rank[by_first] = np.arange(len(by_first))
        of_simplices: IndexArray = rank[number].astype(np.int32)
        vertices: FloatArray = centers[first[by_first]]
        return vertices, of_simplices

    def _faces(self, is_left: Callable[[], bool]) -> tuple[IndexArray, IndexArray, IndexArray]:
        """Walks around all edges at once: the next simplex is across the facet opposite the third
        vertex, and its third vertex is the fourth of this one."""
        simplices, neighbors = self._simplices, self._neighbors
        # By 6 * simplex + edge; from the lesser end to the other one.
        ends = simplices[:, _EDGES[:, :2]].reshape(-1, 2)
        is_turned = ends[:, 0] > ends[:, 1]
        # The simplex that this one comes after.
        before = np.where(
            is_turned, neighbors[:, _EDGES[:, 2]].ravel(), neighbors[:, _EDGES[:, 3]].ravel()
        )
        keys = np.sort(ends, axis=1)
        key = keys[:, 0].astype(np.int64) * len(self.points) + keys[:, 1]
        # Where no simplex comes before, the face has no end: it begins there.
        order = np.lexsort((before >= 0, key))
        starts = order[np.append(True, key[order][1:] != key[order][:-1])]
        simplex, edge = np.divmod(starts, 6)
        a, b, c, d = simplices[simplex[:, np.newaxis], _EDGES[edge]].T
        c, d = np.where(is_turned[starts], (d, c), (c, d))
        first = simplex.copy()
        faces = np.arange(len(starts))
        steps_face, steps_vertex = [faces], [self._vertex_of[simplex]]
        while len(faces) and not is_left():
            at = np.argmax(simplices[simplex] == c[:, np.newaxis], axis=1)
            simplex = neighbors[simplex, at]
            goes_on = (simplex >= 0) & (simplex != first)
            faces, first, simplex = faces[goes_on], first[goes_on], simplex[goes_on]
            a, b, c = a[goes_on], b[goes_on], d[goes_on]
            corners = simplices[simplex]
            d = corners.sum(axis=1) - a - b - c
            steps_face.append(faces)
            steps_vertex.append(self._vertex_of[simplex])
        of_face, vertex = np.concatenate(steps_face), np.concatenate(steps_vertex)
        turn = np.argsort(of_face, kind="stable")
        is_open = before[starts] < 0
        return self._without_repeats(starts, is_open, keys[starts], of_face[turn], vertex[turn])

    def _without_repeats(
        self,
        starts: NDArray[Any],
        is_open: NDArray[Any],
        pairs: IndexArray,
        of_face: NDArray[Any],
        vertex: IndexArray,
    ) -> tuple[IndexArray, IndexArray, IndexArray]:
        """Leaves edges of no length out, and faces of no area."""
        begins = np.append(True, of_face[1:] != of_face[:-1])
        last = np.append(np.flatnonzero(begins)[1:], len(vertex)) - 1
        kept = np.append(True, (vertex[1:] != vertex[:-1]) | begins[1:])
        # The last vertex of a closed face may be the first one again.
        first = np.flatnonzero(begins)
        counts = np.bincount(of_face[kept], minlength=len(starts))
        again = ~is_open & (counts > 1) & (vertex[last] == vertex[first])
        # Among equal ones at the end it is the first that is kept.
        ends = np.flatnonzero(kept)
        last_kept = ends[np.searchsorted(ends, last, side="right") - 1]
        kept[last_kept[again]] = False
        counts -= again
        is_face = np.where(is_open, counts >= 1, counts >= 3)
        lone = np.flatnonzero(is_open & (counts == 1))
        is_face[lone] = ~self._are_flat(pairs[lone])
        kept &= is_face[of_face]
        order = np.argsort(pairs[:, 0].astype(np.int64) * len(self.points) + pairs[:, 1])
        order = order[is_face[order]]
        sizes = counts + is_open
        offsets = np.concatenate([[0], np.cumsum(sizes[order])]).astype(np.int32)
        place = np.zeros(len(starts), dtype=np.int64)
        place[order] = offsets[:-1]
        result = np.full(offsets[-1], -1, dtype=np.int32)
        faces = of_face[kept]
        rank = np.arange(len(faces)) - np.searchsorted(faces, faces)
        result[place[faces] + is_open[faces] + rank] = vertex[kept]
        return pairs[order].astype(np.int32), offsets, result

    def _are_flat(self, pairs: NDArray[Any]) -> NDArray[np.bool_]:
        """Whether the two hull facets at each edge are in one plane."""
        hull, n = self._hull.astype(np.int64), len(self.points)
        key = np.concatenate(
            [hull[:, [k - 2, k - 1]].min(axis=1) * n + hull[:, [k - 2, k - 1]].max(axis=1)
             for k in range(3)]
        )
        order = np.argsort(key)
        apex = hull.T.ravel()[order]
        at = np.searchsorted(key[order], pairs[:, 0].astype(np.int64) * n + pairs[:, 1])
        corners = self.points[np.stack([*pairs.T, apex[at], apex[at + 1]])]
        u, v, w = corners[1:] - corners[0]
        size = np.abs(u).max(axis=1) * np.abs(v).max(axis=1) * np.abs(w).max(axis=1)
        # Off by less than 48 roundings of the sizes' product. Not a number means not known.
        is_near = ~(np.abs(np.einsum("ij,ij->i", u, np.cross(v, w))) > 64 * 2.0**-53 * size)
        is_flat = np.zeros(len(pairs), dtype=np.bool_)
        for k in np.flatnonzero(is_near):
            is_flat[k] = _volume_is_zero(corners[:, k])
        return is_flat

    def __repr__(self) -> str:
        return (
            f"<mgdt.Voronoi: {self.npoints} points, {len(self.vertices)} vertices, "
            f"{len(self.ridge_points)} faces>"
        )
