# SPDX-License-Identifier: MIT
"""mgdt: exact 3D Delaunay triangulation of any set of points.

`Delaunay` takes the place of ``scipy.spatial.Delaunay`` for points in space.
"""

from __future__ import annotations

from . import _handle, _library
from ._errors import (
    ArgumentError,
    BusyError,
    Cancelled,
    CheckFailed,
    Error,
    NotBuiltError,
    OutOfMemoryError,
    TooLargeError,
)
from ._insertion import CANCEL
from .alpha import AlphaShape
from .delaunay import Delaunay
from .domain import (
    CleanSurface,
    DomainMesh,
    InvalidBoundary,
    OffendingPair,
    OpenBoundary,
    clean_surface,
    offending_pairs,
)
from .interpolation import Interpolator
from .mesh import Improvement, Mesh, Refinement
from .parallel import ParallelDelaunay
from .periodic import PeriodicDelaunay, PeriodicVoronoi
from .scattered import (
    LinearNDInterpolator,
    NaturalNeighborInterpolator,
    NearestNDInterpolator,
    griddata,
)
from .voronoi import Voronoi

__all__ = [
    "AlphaShape",
    "ArgumentError",
    "BusyError",
    "CANCEL",
    "Cancelled",
    "CheckFailed",
    "CleanSurface",
    "Delaunay",
    "DomainMesh",
    "Error",
    "Improvement",
    "Refinement",
    "Interpolator",
    "InvalidBoundary",
    "LinearNDInterpolator",
    "Mesh",
    "NaturalNeighborInterpolator",
    "NearestNDInterpolator",
    "NotBuiltError",
    "ORDER_SCHEMES",
    "OffendingPair",
    "OpenBoundary",
    "OutOfMemoryError",
    "ParallelDelaunay",
    "PeriodicDelaunay",
    "PeriodicVoronoi",
    "QhullError",
    "TooLargeError",
    "Voronoi",
    "clean_surface",
    "griddata",
    "library_path",
    "library_version",
    "offending_pairs",
]

__version__ = "1.4.0"

ORDER_SCHEMES = tuple(_handle.ORDER_SCHEMES)
"""Names of the order schemes, for the parameter ``order`` of `Delaunay`."""

QhullError = Error
"""So that code which catches SciPy's runs. Few or flat points, its usual cause, raise nothing."""


def library_version() -> str:
    """Version of the library in use, such as "1.4.0". Since 1.0."""
    return _library.text(_library.library.mgdt_version_string())


def library_path() -> str:
    """The library in use: a file, or the name that the system's loader resolved. Since 1.0."""
    return _library.path
