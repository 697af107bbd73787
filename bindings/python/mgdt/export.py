# SPDX-License-Identifier: MIT
"""The triangulation for SciPy, meshio and PyVista, where they are installed."""

from __future__ import annotations

import importlib
from typing import Any, Optional, Protocol, Sequence

import numpy as np

from ._arrays import FloatArray, IndexArray

# VTK's number of the linear tetrahedron; its vertices are positively oriented as mgdt's.
_VTK_TETRA = 10


class Triangulated(Protocol):
    """What the exports read of an `mgdt.Delaunay`."""

    @property
    def points(self) -> FloatArray: ...
    @property
    def simplices(self) -> IndexArray: ...
    @property
    def neighbors(self) -> IndexArray: ...
    @property
    def equations(self) -> FloatArray: ...
    @property
    def coplanar(self) -> IndexArray: ...
    @property
    def vertex_to_simplex(self) -> IndexArray: ...
    @property
    def min_bound(self) -> FloatArray: ...
    @property
    def max_bound(self) -> FloatArray: ...
    @property
    def paraboloid_scale(self) -> float: ...
    @property
    def paraboloid_shift(self) -> float: ...
    @property
    def npoints(self) -> int: ...
    @property
    def dimension(self) -> int: ...


def _module(name: str, package: str, caller: str) -> Any:
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise ImportError(f"{caller} needs {package}, which is not installed: {error}") from error


def to_scipy(triangulation: Triangulated) -> Any:
    """All points and the tetrahedra as a ``scipy.spatial.Delaunay``, without a run of Qhull.

    It takes no more points, as SciPy's without ``incremental=True``. Its `find_simplex` is SciPy's,
    which rounds. `transform`, which SciPy makes when it is asked for, has NaN for flat simplices:
    SciPy looks for their places in the neighbours. Arrays are shared with the triangulation where
    they are contiguous, and stay as they are when that goes on.

    Raises
    ------
    ImportError
        If SciPy is not installed.
    ValueError
        If there are no tetrahedra, which SciPy's object must have.

    Notes
    -----
    Since 1.2.
    """
    scipy_delaunay = _module("scipy.spatial", "SciPy", "to_scipy").Delaunay
    simplices = triangulation.simplices
    if len(simplices) == 0:
        raise ValueError(
            f"to_scipy: the {triangulation.npoints} points have dimension "
            f"{triangulation.dimension}, so there are no tetrahedra, and SciPy has no "
            "triangulation without"
        )
    given = scipy_delaunay.__new__(scipy_delaunay)
    given._qhull = None
    # SciPy's compiled code takes the addresses of these: all are contiguous.
    given._points = np.ascontiguousarray(triangulation.points)
    given.ndim = 3
    given.npoints = len(given._points)
    given.min_bound = triangulation.min_bound
    given.max_bound = triangulation.max_bound
    given.furthest_site = False
    given.paraboloid_scale = triangulation.paraboloid_scale
    given.paraboloid_shift = triangulation.paraboloid_shift
    given.simplices = simplices
    given.nsimplex = len(simplices)
    given.neighbors = triangulation.neighbors
    given.equations = triangulation.equations
    given.coplanar = triangulation.coplanar
    given.good = np.ones(len(simplices), dtype=np.intc)
    # None is made by SciPy when it is asked for.
    given._transform = None
    given._vertex_to_simplex = triangulation.vertex_to_simplex
    given._vertex_neighbor_vertices = None
    if hasattr(scipy_delaunay, "vertices"):
        given._vertices = simplices  # an old name, until SciPy 1.10
    return given


class Tetrahedra(Protocol):
    """Points and tetrahedra, of a triangulation or of a mesh."""

    @property
    def points(self) -> FloatArray: ...
    @property
    def simplices(self) -> IndexArray: ...


def to_meshio(
    triangulation: Tetrahedra,
    cells: Sequence[tuple[str, Any]] = (),
    cell_data: Optional[dict[str, list[Any]]] = None,
) -> Any:
    """All points and the tetrahedra as a ``meshio.Mesh``, with further blocks of cells behind them, and
    data for all blocks.

    Raises
    ------
    ImportError
        If meshio is not installed.

    Notes
    -----
    Since 1.0; further cells and data since 1.3.
    """
    meshio = _module("meshio", "meshio", "to_meshio")
    return meshio.Mesh(
        triangulation.points, [("tetra", triangulation.simplices), *cells], cell_data=cell_data
    )


def to_pyvista(triangulation: Tetrahedra) -> Any:
    """All points and the tetrahedra as a ``pyvista.UnstructuredGrid``.

    Raises
    ------
    ImportError
        If PyVista is not installed.

    Notes
    -----
    Since 1.0.
    """
    pyvista = _module("pyvista", "PyVista", "to_pyvista")
    return pyvista.UnstructuredGrid({_VTK_TETRA: triangulation.simplices}, triangulation.points)
