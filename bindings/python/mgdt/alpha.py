# SPDX-License-Identifier: MIT
"""Alpha shapes."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from ._arrays import FloatArray, IndexArray
from .delaunay import Delaunay


class AlphaShape:
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
    alpha : float
    simplices : ndarray of int, shape (k, 4)
        The tetrahedra.
    facets : ndarray of int, shape (m, 3)
        The surface, counter-clockwise seen from outside: closed, and at each edge as many facets
        turn one way as the other.

    Notes
    -----
    Since 1.2.
    """

    def __init__(self, points: Any, alpha: Optional[float] = None, **settings: Any) -> None:
        self.delaunay: Delaunay = (
            points if isinstance(points, Delaunay) else Delaunay(points, **settings)
        )
        if alpha is not None and not alpha >= 0:
            raise ValueError(f"alpha is {alpha}; it must be at least 0")
        # The square of a square root may be another number.
        squared = self.delaunay.squared_solid_alpha if alpha is None else float(alpha) ** 2
        self.alpha: float = float(np.sqrt(squared)) if alpha is None else float(alpha)
        is_in = self.delaunay.squared_alphas(3) <= squared
        self.simplices: IndexArray = self.delaunay.simplices[is_in]
        self.facets: IndexArray = self.delaunay._surface(squared)

    @property
    def points(self) -> FloatArray:
        """The points given."""
        points: FloatArray = self.delaunay.points
        return points

    @property
    def volume(self) -> float:
        """Volume of the solid."""
        a, b, c, d = np.moveaxis(self.points[self.simplices], 1, 0)
        return float(np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a).sum() / 6)

    @property
    def area(self) -> float:
        """Area of the surface."""
        a, b, c = np.moveaxis(self.points[self.facets], 1, 0)
        return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)

    def __repr__(self) -> str:
        return (
            f"<mgdt.AlphaShape: alpha {self.alpha:g}, {len(self.simplices)} tetrahedra, "
            f"{len(self.facets)} facets>"
        )

