# SPDX-License-Identifier: MIT
"""Alpha shapes."""

from __future__ import annotations

from functools import cached_property
from typing import Any, Optional

import numpy as np

from ._arrays import IndexArray, as_number
from ._handle import Handle
from ._snapshot import Snapshot


class AlphaShape(Snapshot):
    """The solid that balls of a radius leave when they take away what they reach without touching a
    point: the Delaunay tetrahedra whose circumradius is at most `alpha`.

    Parameters
    ----------
    points : array_like of float, shape (n, 3), or Delaunay
        The points, or their triangulation.
    alpha : float, optional
        The radius; by default the least one with which all points are in one solid.
    **settings
        Of `Delaunay`.

    Attributes
    ----------
    delaunay : Delaunay
    points : ndarray of float, shape (n, 3)
    alpha : float
    simplices : ndarray of int, shape (k, 4)
        The tetrahedra.
    facets : ndarray of int, shape (m, 3)
        The surface, counter-clockwise seen from outside: closed, and at each edge as many facets
        turn one way as the other.

    Notes
    -----
    A shape stays that of the points as they were when it was made, also if the triangulation goes
    on. Since 1.2.

    Examples
    --------
    >>> import mgdt, numpy
    >>> lattice = numpy.indices((3, 3, 3)).reshape(3, -1).T
    >>> mgdt.AlphaShape(lattice, 1.0).volume
    8.0
    """

    def __init__(self, points: Any, alpha: Optional[float] = None, **settings: Any) -> None:
        self._given = None if alpha is None else as_number(alpha, "alpha")
        super().__init__(points, settings)

    def _take(self, handle: Handle) -> None:
        # The square of a square root may be another number.
        squared = handle.solid_alpha() if self._given is None else self._given * self._given
        self.alpha: float = float(np.sqrt(squared)) if self._given is None else self._given
        self.simplices: IndexArray = handle.tetrahedra()[handle.alphas(3) <= squared]
        self.facets: IndexArray = handle.alpha_surface(squared)

    @cached_property
    def volume(self) -> float:
        """Volume of the solid."""

        def measure(_: object) -> float:
            a, b, c, d = np.moveaxis(self.points[self.simplices], 1, 0)
            return float(np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a).sum() / 6)

        return self._aside(measure)

    @cached_property
    def area(self) -> float:
        """Area of the surface."""

        def measure(_: object) -> float:
            a, b, c = np.moveaxis(self.points[self.facets], 1, 0)
            return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)

        return self._aside(measure)

    def __repr__(self) -> str:
        return (
            f"<mgdt.AlphaShape: alpha {self.alpha:g}, {len(self.simplices)} tetrahedra, "
            f"{len(self.facets)} facets>"
        )

