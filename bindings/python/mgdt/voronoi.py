# SPDX-License-Identifier: MIT
"""The Voronoi diagram, in the meaning of ``scipy.spatial.Voronoi``."""

from __future__ import annotations

from functools import cached_property
from typing import Any, Callable, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import FloatArray, IndexArray, as_planes
from ._diagram import Diagram, blocks
from ._handle import Handle
from ._snapshot import Snapshot

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


class Voronoi(Snapshot, Diagram):
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
        The planes that bound the region to which cells are clipped: a, b, c, d each, where
        a x + b y + c z <= d.
    bounds : array_like of float, shape (2, 3), optional
        A box that bounds the region too: its least and its largest coordinates. Its planes come
        behind `planes`: three for the least coordinates, then three for the largest ones.
    least_area : float, optional
        Faces with a smaller area are left out. Since 1.3.
    least_share : float, optional
        Faces are left out whose area is a smaller share of the surface of each of their cells. Since
        1.3.
    **settings
        Of `Delaunay`.

    Attributes
    ----------
    delaunay : Delaunay
    points : ndarray of float, shape (n, 3)
    vertices : ndarray of float, shape (nvertices, 3)
    ridge_points : ndarray of int, shape (nridges, 2)
        The two points that each face is between, the lesser one first. A face in plane k of the
        region has -1 - k in place of the second point.
    ridge_offsets, ridge_list : ndarray of int
        The vertices of face k, in turn around it, are
        ``ridge_list[ridge_offsets[k]:ridge_offsets[k + 1]]``; -1, which comes first, is at infinity.
    ridge_areas : ndarray of float, shape (nridges,)
        The area of each face, infinite where a face has no end. Since 1.3.
    ridge_normals, ridge_centroids : ndarray of float, shape (nridges, 3)
        The unit normal of each face, out of the cell of its first point; and its centroid. Since 1.3.
    ridge_rays : ndarray of int, shape (nridges, 2)
        The rays that a face without end has behind its last vertex and before its first one; -1 for
        other faces. Since 1.3.
    ray_vertices, ray_directions : ndarray, shapes (nrays,) and (nrays, 3)
        Where each ray begins, and its direction, of length 1. Since 1.3.
    point_region : ndarray of int, shape (n,)
        The region of each point, that of its twin for one that repeats an earlier one; -1 of one that
        is not in.

    Notes
    -----
    A diagram stays that of the points as they were when it was made, also if the triangulation goes
    on. Lists and `areas` are computed when they are asked for, and once. Since 1.2; before 1.3, the
    vertices and faces of a diagram with planes were those without them.

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
        least_area: float = 0.0,
        least_share: float = 0.0,
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
        if not least_area >= 0:
            raise ValueError(f"least_area is {least_area!r}; it must be at least 0")
        if not 0 <= least_share < 1:
            raise ValueError(f"least_share is {least_share!r}; it must be at least 0 and below 1")
        self._least = float(least_area), float(least_share)
        super().__init__(points, settings)
        self._begin()

    def _take(self, handle: Handle) -> None:
        # Points in one plane, on one line or at one place have cells within a region.
        has_cells = handle.dimension == 3 or (handle.dimension >= 0 and len(self._planes) > 0)
        self._arrays = handle.voronoi(self._planes, *self._least) if has_cells else {}

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
        for name in ("regions", "ridge_vertices", "ridge_dict", "neighbors", "neighbor_list", "areas"):
            self.__dict__.pop(name, None)
        self._read_state()
        self._begin()

    def close(self) -> None:
        """Ends `add_points`. The diagram stays as it is."""
        if self._is_made:
            self.delaunay.close()

    def _places(self, points: IndexArray, _shifts: IndexArray) -> FloatArray:
        return self.points[points]

    @cached_property
    def ridge_dict(self) -> dict[tuple[int, int], list[int]]:
        """From the two points of each face to its vertices."""
        vertices = self.ridge_vertices

        def pair(is_left: Callable[[], bool]) -> dict[tuple[int, int], list[int]]:
            found: dict[tuple[int, int], list[int]] = {}
            for block in blocks(len(vertices), is_left):
                for (a, b), of_face in zip(self.ridge_points[block].tolist(), vertices[block]):
                    found[a, b] = of_face
            return found

        return self._aside(pair)

    @cached_property
    def areas(self) -> FloatArray:
        """Areas of the surfaces of the points' cells, within 1e-12, with the faces that are left
        out; infinite where a cell has no end."""
        return self._measured(lambda handle: handle.cell_measures("area", self._planes))

    def __repr__(self) -> str:
        return (
            f"<mgdt.Voronoi: {self.npoints} points, {len(self.vertices)} vertices, "
            f"{len(self.ridge_points)} faces>"
        )
