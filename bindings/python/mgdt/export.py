# SPDX-License-Identifier: MIT
"""Meshes for meshio and PyVista, where they are installed."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .delaunay import Delaunay

# VTK's number of the linear tetrahedron; its vertices are positively oriented as mgdt's.
_VTK_TETRA = 10


def _module(name: str, package: str, caller: str) -> Any:
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise ImportError(f"{caller} needs {package}, which is not installed: {error}") from error


def to_meshio(triangulation: Delaunay) -> Any:
    """All points and the tetrahedra as a ``meshio.Mesh``.

    Raises
    ------
    ImportError
        If meshio is not installed.

    Notes
    -----
    Since 1.0.
    """
    meshio = _module("meshio", "meshio", "to_meshio")
    return meshio.Mesh(triangulation.points, [("tetra", triangulation.simplices)])


def to_pyvista(triangulation: Delaunay) -> Any:
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
