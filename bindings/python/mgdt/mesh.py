# SPDX-License-Identifier: MIT
"""Meshes of tetrahedra, their refinement and their improvement."""

from __future__ import annotations

import copy
from ctypes import c_double, c_void_p
from typing import Any, Callable, NamedTuple, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import FloatArray, IndexArray, address, as_array, as_points
from ._building import build
from ._gate import Gate, interruptibly
from ._insertion import SHORT
from ._interface import CONSTANTS, SIZE
from ._keyed import Keyed
from .export import to_meshio, to_pyvista


def integers(values: Any, name: str, columns: Optional[int] = None) -> NDArray[np.int64]:
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


def markers_of(values: Optional[ArrayLike], n: int, name: str) -> Optional[NDArray[np.int32]]:
    if values is None:
        return None
    wide = integers(values, name)
    if wide.shape != (n,):
        raise ValueError(f"{name} must have the shape ({n},), not {wide.shape}")
    if n and (wide.min() < -(1 << 31) or wide.max() >= 1 << 31):
        raise ValueError(f"{name} must fit 32-bit integers")
    return wide.astype(np.int32)


def sizes_of(values: Optional[ArrayLike], n: int, name: str) -> FloatArray:
    if values is None:
        return np.empty(0)
    array = np.ascontiguousarray(as_array(values, name), float)
    if array.shape != (n,):
        raise ValueError(f"sizes {name} must have the shape ({n},), not {array.shape}")
    return array


NO_SIZES = SIZE(0)


class SizeFunction:
    """What the library calls for sizes, and what the caller's function raises."""

    def __init__(self, function: Callable[[FloatArray], ArrayLike]) -> None:
        self._function = function
        self._raised: Optional[BaseException] = None
        self.callback = SIZE(self._answer)

    def _answer(self, n: int, xyz: int, sizes: int, _: Any) -> int:
        """Writes the sizes; 1 stops the call, through which nothing may be raised."""
        try:
            places = np.ctypeslib.as_array((c_double * (3 * n)).from_address(xyz)).reshape(n, 3)
            found = np.asarray(self._function(places.copy()), float)
            if found.shape != (n,):
                raise ValueError(f"size_function must give the shape ({n},), not {found.shape}")
            np.ctypeslib.as_array((c_double * n).from_address(sizes))[:] = found
        except BaseException as error:  # pylint: disable=broad-except
            self._raised = error
            return 1
        return 0

    def raise_again(self) -> None:
        if self._raised is not None:
            raise self._raised from None


def finite_places(places: ArrayLike) -> tuple[FloatArray, tuple[int, ...], NDArray[np.bool_]]:
    """Those places whose coordinates are finite, the shape of all, and which of them they are."""
    array = np.asarray(places, float)
    if array.ndim < 1 or array.shape[-1] != 3:
        raise ValueError(f"places must have the shape (..., 3), not {array.shape}")
    rows = array.reshape(-1, 3)
    is_finite = np.isfinite(rows).all(axis=1)
    return np.ascontiguousarray(rows[is_finite]), array.shape[:-1], is_finite


def _outside(nearest: bool) -> int:
    return CONSTANTS["outside"]["boundary" if nearest else "none"]


class MeshHandle(Keyed):
    """A mesh of the library."""

    kind = "mesh"

    def __init__(self, pointer: Optional[c_void_p] = None) -> None:
        super().__init__(self._create() if pointer is None else pointer)

    def measures(self, name: str) -> FloatArray:
        values = np.empty(self.statistic("tetrahedra"))
        self.call("get_tetrahedron_measures", CONSTANTS["tetrahedron"][name], values.size, address(values))
        return values

    def set_items(self, function: str, items: NDArray[np.int64], markers: Optional[NDArray[np.int32]]) -> None:
        self.call(function, len(items), address(items), None if markers is None else address(markers))


class Improvement(NamedTuple):
    """What `Mesh.improve` has done. Pairs are before and after."""

    least_angle: tuple[float, float]
    """Least dihedral angle, in degrees."""
    largest_angle: tuple[float, float]
    """Largest dihedral angle, in degrees."""
    mean_shape: tuple[float, float]
    """Mean of the measure "volume_length": 1 if all tetrahedra are regular."""
    angles: IndexArray
    """(18, 2) numbers of dihedral angles from 0 to 10 degrees, 10 to 20 and so on; six for each tetrahedron."""
    below: IndexArray
    """(6, 2) numbers of tetrahedra with an angle below 5, 10, 15, 20, 25 and 30 degrees."""
    reasons: IndexArray
    """For each tetrahedron 0, or why it is below the goal: 1 for an angle between facets, 2 for a thin face of
    the surface, 3 if all of its corners are fixed, 4 for anything else."""
    left: int
    """Tetrahedra below the goal."""


class Refinement(NamedTuple):
    """What `Mesh.refine` has done."""

    inserted: int
    """Points that were inserted."""
    refused: int
    """Tetrahedra that are beyond the sizes and bounds."""
    refusals: IndexArray
    """For each tetrahedron 0, or why it was not divided: 1 if a facet is between it and the point that would
    divide it, 2 if that point is near another one, 3 if it is near a facet, 4 if there is no place for
    tetrahedra around it, 5 for the most points."""
    sizes: FloatArray
    """The size of edges that was wanted at each point, or 0."""


class Mesh:
    """A mesh of tetrahedra.

    Since 1.4.

    Parameters
    ----------
    points : (n, 3) array
    simplices : (m, 4) array of rows of `points`. The corners may have any order
    markers : m integers; 0 by default. Tetrahedra with one marker form a region
    faces : (f, 3) array of rows of `points`: faces with markers, and faces inside that have to stay
    face_markers : f integers; 0 by default
    edges : (e, 2) array of rows of `points`: edges that have to stay
    edge_markers : e integers; 0 by default
    threads : 0 for all cores
    memory_limit : bytes, 0 for none
    progress : called as ``progress(fraction)`` with 0 to 1; the result ``mgdt.CANCEL`` cancels

    Raises
    ------
    ValueError
        If tetrahedra are flat, or do not meet in common faces; the message has their numbers.

    Attributes
    ----------
    points : (n, 3) array
        Those that were given, then those that a refinement or an improvement has added.
    point_origins : (n,) array
        The given point that each point is, or -1.
    simplices : (m, 4) array
        Positively oriented. Those that were given keep their order until they are refined or improved.
    neighbors : (m, 4) array
        The simplices opposite the corners of each; -1 where the mesh ends.
    simplex_regions : (m,) array
    region_markers : (r,) array
    faces : (f, 3) array
        The faces that were given, those at which the mesh ends, and those between regions.
    face_simplices : (f, 2) array
        The simplices on both sides, or -1.
    face_facets : (f,) array
        Faces in one plane form a facet; its number.
    face_markers : (f,) array
    edges : (e, 2) array
        The edges that were given, and those at which facets end.
    edge_segments : (e,) array
        The given edge that each is, or a part of; or -1.
    edge_markers : (e,) array
    npoints, nsimplex : int
        The numbers of points and of tetrahedra.
    unused_points : int
        How many of the points are no corner of a tetrahedron.

    Examples
    --------
    >>> import mgdt
    >>> points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4], [.2, .3, .2]]
    >>> mesh = mgdt.Mesh(points, [[0, 1, 2, 4], [0, 1, 3, 4], [0, 2, 3, 4], [1, 2, 3, 4]])
    >>> mesh
    <mgdt.Mesh: 5 points, 4 tetrahedra, 1 region>
    >>> done = mesh.improve(25)
    >>> [round(angle, 1) for angle in done.least_angle]
    [4.6, 26.4]
    """

    def __init__(
        self,
        points: ArrayLike,
        simplices: ArrayLike,
        *,
        markers: Optional[ArrayLike] = None,
        faces: Optional[ArrayLike] = None,
        face_markers: Optional[ArrayLike] = None,
        edges: Optional[ArrayLike] = None,
        edge_markers: Optional[ArrayLike] = None,
        threads: int = 1,
        memory_limit: int = 0,
        progress: Optional[Callable[[float], Any]] = None,
    ) -> None:
        self._keep(
            {
                "points": points,
                "simplices": simplices,
                "markers": markers,
                "faces": faces,
                "face_markers": face_markers,
                "edges": edges,
                "edge_markers": edge_markers,
                "threads": threads,
                "memory_limit": memory_limit,
            }
        )
        handle = MeshHandle()
        handle.set_option("threads", threads)
        handle.set_option("memory_limit", memory_limit)
        rows = np.ascontiguousarray(as_points(points))
        handle.call("set_points", len(rows), address(rows))
        corners = integers(simplices, "simplices", 4)
        handle.set_items("set_tetrahedra", corners, markers_of(markers, len(corners), "markers"))
        size = len(corners)
        corners = integers([] if faces is None else faces, "faces", 3)
        handle.set_items("set_faces", corners, markers_of(face_markers, len(corners), "face_markers"))
        ends = integers([] if edges is None else edges, "edges", 2)
        handle.set_items("set_edges", ends, markers_of(edge_markers, len(ends), "edge_markers"))
        build(handle, Gate(), progress, size)
        self._take(handle)

    # Copies are built and changed again from what was given, and share nothing with the original.

    def _keep(self, given: dict[str, Any]) -> None:
        self._given = copy.deepcopy(given)
        # The names and arguments of all refinements and improvements; None once an improvement was
        # cancelled.
        self._changes: Optional[list[tuple[str, dict[str, Any]]]] = []

    def __getstate__(self) -> dict[str, Any]:
        if self._changes is None:
            raise TypeError("a mesh whose improvement was cancelled cannot be copied")
        return {"given": self._given, "changes": self._changes}

    def __setstate__(self, state: dict[str, Any]) -> None:
        # Version 1.3 has saved what was given alone.
        given = state.get("given", state)
        type(self).__init__(self, **given)
        for name, arguments in state.get("changes", []):
            getattr(self, name)(**arguments)

    def _take(self, mesh: MeshHandle) -> None:
        """Takes a mesh of the library."""
        self._mesh = mesh
        self._gate = Gate()
        self._read()

    def _read(self) -> None:
        mesh = self._mesh
        self.points: FloatArray = mesh.array("points")
        self.point_origins: IndexArray = mesh.array("point_origins")
        self.simplices: IndexArray = mesh.array("tetrahedra")
        self.neighbors: IndexArray = mesh.array("neighbors")
        self.simplex_regions: IndexArray = mesh.array("tetrahedron_regions")
        self.region_markers: IndexArray = mesh.array("region_markers")
        self.faces: IndexArray = mesh.array("faces")
        self.face_simplices: IndexArray = mesh.array("face_tetrahedra")
        self.face_facets: IndexArray = mesh.array("face_facets")
        self.face_markers: IndexArray = mesh.array("face_markers")
        self.edges: IndexArray = mesh.array("edges")
        self.edge_segments: IndexArray = mesh.array("edge_segments")
        self.edge_markers: IndexArray = mesh.array("edge_markers")
        self.steiner_edges: IndexArray = mesh.array("steiner_edges")
        self.steiner_parameters: FloatArray = mesh.array("steiner_parameters")
        self.is_rounded = mesh.statistic("is_rounded") == 1
        self.unused_points = mesh.statistic("unused_points")
        self.unused_faces = mesh.statistic("unused_faces")
        self.unused_regions = mesh.statistic("unused_regions")
        self.unused_holes = mesh.statistic("unused_holes")

    @property
    def npoints(self) -> int:
        """The number of points, Steiner points included."""
        return len(self.points)

    @property
    def nsimplex(self) -> int:
        """The number of tetrahedra."""
        return len(self.simplices)

    def refine(
        self,
        size: float = 0,
        *,
        point_sizes: Optional[ArrayLike] = None,
        simplex_sizes: Optional[ArrayLike] = None,
        region_sizes: Optional[ArrayLike] = None,
        size_field: Optional[tuple[ArrayLike, ArrayLike]] = None,
        size_function: Optional[Callable[[FloatArray], ArrayLike]] = None,
        sizes_of_surface: bool = False,
        gradation: float = 0.3,
        radius_edge: float = 1.4,
        volume: float = 0,
        most_points: int = 0,
        progress: Optional[Callable[[float], Any]] = None,
    ) -> Refinement:
        """Inserts points until the tetrahedra have the wanted sizes and shapes. The attributes have the
        refined mesh then.

        Of several sizes that are wanted at a place the least one counts. Faces, edges, regions and markers
        stay. `improve` is the next step, which removes flat tetrahedra. If the call is cancelled, the mesh
        stays as it was.

        Since 1.4.

        Parameters
        ----------
        size : the length of edges everywhere, 0 for any
        point_sizes : that at each point, 0 for any
        simplex_sizes : that in each tetrahedron, such as an estimate of an error wants it; 0 for any
        region_sizes : that in each region, in the order of `region_markers`; 0 for any
        size_field : points in space and the sizes there, which are linear between them
        size_function : called as ``size_function(places)`` with an array of the shape (n, 3); it gives the
            n sizes there, 0 for any
        sizes_of_surface : whether edges at a point are to be as long as those of the surface there
        gradation : how fast sizes may grow with the distance
        radius_edge : the most that the radius of a circumsphere should be, in shortest edges of its
            tetrahedron; 0 for any
        volume : the most volume that a tetrahedron should have, 0 for any
        most_points : the most points that are inserted, 0 for any number
        progress : called as ``progress(fraction)`` with 0 to 1; the result ``mgdt.CANCEL`` cancels

        Examples
        --------
        >>> import mgdt
        >>> points = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4], [1, 1, 1]]
        >>> mesh = mgdt.Mesh(points, [[0, 1, 2, 4], [0, 1, 3, 4], [0, 2, 3, 4], [1, 2, 3, 4]])
        >>> mesh.refine(0.5).inserted > 0
        True
        >>> mesh.refine(size_function=lambda places: 0.2 + 0.2 * places[:, 2]).inserted > 0
        True
        """
        mesh = self._mesh
        lists = {
            "of_points": (point_sizes, len(self.points)),
            "of_tetrahedra": (simplex_sizes, len(self.simplices)),
            "of_regions": (region_sizes, len(self.region_markers)),
        }
        sizes = {name: sizes_of(values, n, name) for name, (values, n) in lists.items()}

        field_points = as_points(size_field[0]) if size_field is not None else np.empty((0, 3))
        field_sizes = sizes_of(size_field[1] if size_field is not None else None, len(field_points), "size_field")
        asked = SizeFunction(size_function) if size_function is not None else None

        def change() -> None:
            mesh.call("set_size_field", len(field_points), address(field_points), address(field_sizes))
            mesh.call("set_size_function", asked.callback if asked else NO_SIZES, None)
            mesh.set_double_option("size", size)
            mesh.set_double_option("gradation", gradation)
            mesh.set_double_option("radius_edge", radius_edge)
            mesh.set_double_option("volume", volume)
            mesh.set_option("most_points", most_points)
            mesh.set_option("sizes_of_surface", 1 if sizes_of_surface else 0)
            for name, values in sizes.items():
                mesh.call("set_sizes", CONSTANTS["sizes"][name], len(values), address(values))

        # How long it takes is not known before.
        try:
            build(mesh, self._gate, progress, SHORT, change, "refine")
        except BaseException:
            if asked is not None:
                asked.raise_again()
            raise
        finally:
            mesh.quiet("set_size_function", NO_SIZES, None)
        self._read()
        arguments = {
            "size": size,
            "point_sizes": point_sizes,
            "simplex_sizes": simplex_sizes,
            "region_sizes": region_sizes,
            "size_field": size_field,
            "size_function": size_function,
            "sizes_of_surface": sizes_of_surface,
            "gradation": gradation,
            "radius_edge": radius_edge,
            "volume": volume,
            "most_points": most_points,
        }
        if self._changes is not None:
            self._changes = [*self._changes, ("refine", copy.deepcopy(arguments))]
        return Refinement(
            mesh.statistic("inserted_points"),
            mesh.statistic("refused"),
            mesh.array("refusals"),
            mesh.array("sizes"),
        )

    def improve(
        self,
        goal: int = 25,
        *,
        slide: bool = False,
        keep: Optional[str] = None,
        fixed: Optional[ArrayLike] = None,
        mean_passes: int = 0,
        most_passes: int = 100,
        progress: Optional[Callable[[float], Any]] = None,
    ) -> Improvement:
        """Improves the shapes of the tetrahedra until all dihedral angles reach a goal, or nothing
        helps. The attributes have the improved mesh then.

        The worst tetrahedron never becomes worse, and the shape of the surface, regions, facets and
        markers stay. A mesh that reaches the goal stays as it is. If the call is cancelled, the mesh is
        better, but not as good as it would be.

        Since 1.4.

        Parameters
        ----------
        goal : the least dihedral angle, in degrees from 0 to 70
        slide : whether points of the surface may move within their facets and along straight edges
        keep : what happens to the points that were given: "all" leaves them where they are, "numbers" moves
            them, "none" may also leave some without a tetrahedron. By default "all" for a
            `DomainMesh`, "numbers" for others
        fixed : rows of `points`, of those that were given, that stay where they are
        mean_passes : passes that move all points for the mean of the shapes, after the goal; three of them
            do most of what can be done
        most_passes : a limit for goals that are out of reach
        progress : called as ``progress(fraction)`` with 0 to 1; the result ``mgdt.CANCEL`` cancels
        """
        keeps = {"all": "keep", "numbers": "move", "none": "remove"}
        if keep is not None and keep not in keeps:
            raise ValueError(f"keep is {keep!r}; it must be one of {', '.join(map(repr, keeps))}")
        mesh = self._mesh
        points = integers([] if fixed is None else fixed, "fixed")
        kept = self._keep_at_first if keep is None else keep

        def change() -> None:
            mesh.set_option("goal", goal)
            mesh.set_option("boundary", CONSTANTS["boundary"]["slide" if slide else "fixed"])
            mesh.set_option("points", CONSTANTS["points"][keeps[kept]])
            mesh.set_option("mean_passes", mean_passes)
            mesh.set_option("most_passes", most_passes)
            mesh.call("set_fixed_points", len(points), address(points))

        changes, self._changes = self._changes, None
        try:
            # A small mesh may need many passes.
            build(mesh, self._gate, progress, SHORT, change, "improve")
        finally:
            self._read()
        arguments = {
            "goal": goal,
            "slide": slide,
            "keep": keep,
            "fixed": fixed,
            "mean_passes": mean_passes,
            "most_passes": most_passes,
        }
        if changes is not None:
            self._changes = [*changes, ("improve", copy.deepcopy(arguments))]
        least, largest, mean = ((float(row[0]), float(row[1])) for row in mesh.array("shapes"))
        return Improvement(
            least,
            largest,
            mean,
            mesh.array("angle_histogram", np.int64),
            mesh.array("tetrahedra_below", np.int64),
            mesh.array("reasons"),
            mesh.statistic("below_goal"),
        )

    _keep_at_first = "numbers"

    def check(self) -> None:
        """Proves the mesh, exactly; that of a domain also against the facets and segments, until it is
        improved.

        Raises
        ------
        CheckFailed
            If it has a defect. The message says what and where.
        """

        def check(is_left: Callable[[], bool]) -> None:
            with self._gate.reading(is_left):
                self._prove()

        interruptibly(check, True)

    def _prove(self) -> None:
        self._mesh.call("check")

    def tetrahedron_measures(self, measure: str) -> FloatArray:
        """A measure of each tetrahedron, as `Delaunay.tetrahedron_measures` has it.

        Parameters
        ----------
        measure : "volume", "radius_ratio", "least_dihedral_angle", "largest_dihedral_angle",
            "longest_edge", "volume_length" or "edge_ratio"
        """
        if measure not in CONSTANTS["tetrahedron"]:
            known = ", ".join(CONSTANTS["tetrahedron"])
            raise ValueError(f"there is no measure {measure!r} of tetrahedra; there are {known}")

        def read(is_left: Callable[[], bool]) -> FloatArray:
            with self._gate.reading(is_left):
                return self._mesh.measures(measure)

        return interruptibly(read, True)

    def find_simplex(self, places: ArrayLike, *, nearest: bool = False) -> IndexArray:
        """The simplices that contain places, exactly, also where the mesh is not convex; -1 outside.

        Parameters
        ----------
        places : (..., 3) array. A place with a coordinate that is not finite is outside
        nearest : whether a place outside gets the simplex of the nearest place of the boundary
        """
        return self.locate(places, nearest=nearest)[0]

    def locate(self, places: ArrayLike, *, nearest: bool = False) -> tuple[IndexArray, FloatArray]:
        """The simplices that contain places, and barycentric weights in the order of the vertices in
        `simplices`; -1 and zeros outside.

        Parameters
        ----------
        places : (..., 3) array
        nearest : whether a place outside gets the simplex and the weights of the nearest place of the
            boundary
        """
        xyz, shape, is_finite = finite_places(places)
        found = np.full(len(is_finite), -1, np.int32)
        weights = np.zeros((len(is_finite), 4))
        inside, of_inside = np.empty(len(xyz), np.int32), np.empty((len(xyz), 4))

        def read(is_left: Callable[[], bool]) -> None:
            with self._gate.reading(is_left):
                self._mesh.call("locate_points_i32", _outside(nearest), len(xyz), address(xyz), address(inside),
                                address(of_inside))

        interruptibly(read, True)
        found[is_finite], weights[is_finite] = inside, of_inside
        return found.reshape(shape), weights.reshape(*shape, 4)

    def contains(self, places: ArrayLike) -> NDArray[np.bool_]:
        """Whether places are in the mesh, its boundary included, exactly."""
        return self.find_simplex(places) >= 0

    def interpolate(self, values: ArrayLike, places: ArrayLike, *, nearest: bool = False) -> FloatArray:
        """Values at places, linear in each simplex, as finite elements of the first order have them; NaN
        outside.

        Parameters
        ----------
        values : (n, ...) array, for each of the `points`
        places : (..., 3) array
        nearest : whether a place outside gets the value of the nearest place of the boundary
        """
        given = np.asarray(values, float)
        if given.ndim < 1 or len(given) != len(self.points):
            raise ValueError(f"values must have the length {len(self.points)}, not {given.shape}")
        of_points = np.ascontiguousarray(given.reshape(len(given), -1))
        xyz, shape, is_finite = finite_places(places)
        fields = of_points.shape[1]
        out = np.full((len(is_finite), fields), np.nan)
        found = np.empty((len(xyz), fields))

        def read(is_left: Callable[[], bool]) -> None:
            with self._gate.reading(is_left):
                self._mesh.call("interpolate", _outside(nearest), fields, address(of_points), len(xyz),
                                address(xyz), address(found))

        interruptibly(read, True)
        out[is_finite] = found
        return out.reshape((*shape, *given.shape[1:]))

    def to_meshio(self) -> Any:
        """Points, tetrahedra and faces as a ``meshio.Mesh``. Cell data "marker" has the markers of the
        regions of tetrahedra, and those of faces."""
        return to_meshio(self, [("triangle", self.faces)], self._cell_data())

    def to_pyvista(self) -> Any:
        """Points and tetrahedra as a ``pyvista.UnstructuredGrid``, with the markers of regions as the
        cell data "marker"."""
        grid = to_pyvista(self)
        grid.cell_data["marker"] = self._cell_data()["marker"][0]
        return grid

    def _cell_data(self) -> dict[str, list[Any]]:
        return {"marker": [self.region_markers[self.simplex_regions], self.face_markers]}

    def __repr__(self) -> str:
        n = len(self.region_markers)
        return (
            f"<mgdt.{type(self).__name__}: {len(self.points)} points, {len(self.simplices)} tetrahedra, "
            f"{n} region{'' if n == 1 else 's'}>"
        )
