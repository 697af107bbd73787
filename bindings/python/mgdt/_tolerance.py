# SPDX-License-Identifier: MIT
"""Tetrahedra for places outside the hull, within a tolerance."""

from __future__ import annotations

from typing import Callable, Optional

import numpy as np
from numpy.typing import NDArray

from ._arrays import FloatArray, IndexArray
from ._geometry import as_integers, blocks, cross, dot, edges_from_last

# Let g be the centroid of the hull, t the tolerance, and x a place with no weight below -t in some
# tetrahedron T. At most three weights are negative, so x is beyond no hull plane by more than 3t of
# the hull's width across that plane. The centroid of a convex body is at least a quarter of that
# width away from the plane. So the place x + s (g - x) is in the hull for s = 12t / (1 + 12t), and
# a place x for which it is not is in no such T. T contains the place c + (x - c) / (1 + 4t), where
# c is its own centroid. That is no farther from x than 3t diameters of T, so T meets the ball
# around x of that radius. Ball and hull are convex, so the tetrahedra that meet the ball are
# connected by facets: all T are found from one that meets it, by way of others that do.
#
# With a large t the ball holds most of the tetrahedra. Then the search stays within the ball of a
# small t, and if it finds nothing, walks towards x take the first T that they find: from where the
# way to g enters the hull, and from g.

# Pairs of place and tetrahedron looked at together, unless the places are one.
_MOST_PAIRS = 1 << 21

# The largest tolerance with which all tetrahedra in the ball are looked at.
_SEARCHED = 2.0**-20

# Shares of the way from a place to the centroid of the hull that are tried, to enter the hull near the
# place.
_SHARES = [2.0**-40, 2.0**-30, 2.0**-20, *2.0 ** np.arange(-12, 0)]

# Steps after which a walk gives up, which rounding may lead around.
_MOST_STEPS = 1000


def _hull_center(corners: FloatArray) -> tuple[FloatArray, float]:
    """Of the hull with facets (n, 3, 3) the centroid, and a lower bound of its width."""
    middle = corners.mean(axis=(0, 1))
    arms = (corners - middle).transpose(1, 2, 0)
    volumes = dot(arms[0], cross(arms[1], arms[2]))
    center = middle + (volumes * arms.sum(axis=0)).sum(axis=1) / (4 * volumes.sum())
    # Across any plane the standard deviation is at most half the width.
    spread = np.cov(corners.reshape(-1, 3).T, bias=True)
    return center, 2 * float(np.sqrt(max(np.linalg.eigvalsh(spread)[0], 0.0)))


def _are_within(corners: FloatArray, places: FloatArray, tolerance: float) -> NDArray[np.bool_]:
    """Whether no weight of places (3, n) is below -tolerance, exactly."""
    integers, _ = as_integers(np.concatenate([corners, places[:, np.newaxis]], axis=1))
    a, b, c, x = ((integers[:, [0, 1, 2, 4]] - integers[:, 3:4])[:, k] for k in range(4))
    volume = dot(a, cross(b, c))
    sides = [dot(x, cross(b, c)), dot(x, cross(c, a)), dot(x, cross(a, b))]
    least = np.minimum.reduce(
        [side * np.where(volume < 0, -1, 1) for side in (*sides, volume - sum(sides))]
    )
    numerator, denominator = tolerance.as_integer_ratio()
    within: NDArray[np.bool_] = least * denominator >= -numerator * np.abs(volume)
    return within.astype(np.bool_)


class _Search:
    """Finds tetrahedra in which places have no weight below -tolerance.

    Points and places are computed with times ``2**-exponent``.
    """

    def __init__(
        self,
        points: FloatArray,
        exponent: int,
        simplices: IndexArray,
        neighbors: IndexArray,
        tolerance: float,
    ) -> None:
        self._points = points
        self._scaled = np.ldexp(points, -exponent) if exponent else points
        self._exponent = exponent
        self._simplices = simplices
        self._neighbors = neighbors
        self._tolerance = tolerance

    def _weigh(
        self, places: FloatArray, numbers: IndexArray, radii: Optional[FloatArray] = None
    ) -> tuple[FloatArray, NDArray[np.bool_], NDArray[np.bool_]]:
        """For each place and tetrahedron the weights, whether they are known well enough to compare
        the least with the tolerance, and whether the tetrahedron may meet the ball.
        """
        edges, last = edges_from_last(self._scaled, self._simplices[numbers])
        arm = np.ldexp(places.T, -self._exponent) - last
        a, b, c = edges[:, 0], edges[:, 1], edges[:, 2]
        normals = np.stack([cross(b, c), cross(c, a), cross(a, b)])
        volume = dot(a, normals[0])
        sides = np.stack([dot(arm, normal) for normal in normals])
        sides = np.concatenate([sides, (volume - sides.sum(axis=0))[np.newaxis]])
        sides *= np.where(volume < 0, -1, 1)
        volume = np.abs(volume)
        # Each determinant is off as for _LEAST_VOLUME, by 48u of the largest coordinates. The
        # fourth side is off by what the others are, and by its own sums. 128u is more than that.
        p, q, r = np.abs(edges).max(axis=0)
        error = 2.0**-46 * (p * q * r + np.abs(arm).max(axis=0) * (p * q + q * r + r * p))
        error += 2.0**-900
        weights = sides / volume
        doubt = error * (1 + self._tolerance) / volume
        is_known = (doubt <= 2.0**-37) | (np.abs(weights.min(axis=0) + self._tolerance) > doubt)
        if radii is None:
            return weights, is_known, np.ones(len(places), dtype=np.bool_)
        areas = np.concatenate([normals, normals.sum(axis=0)[np.newaxis]])
        areas = np.sqrt((areas**2).sum(axis=1)) * (1 + 2.0**-20)
        meets = (sides >= -radii * areas - error).all(axis=0)
        return weights, is_known, meets

    def _are_within(self, places: FloatArray, numbers: IndexArray) -> NDArray[np.bool_]:
        corners = self._points.T[:, self._simplices[numbers].T]
        return _are_within(corners, places.T, self._tolerance)

    def walk(self, places: FloatArray, starts: IndexArray, middle: int) -> IndexArray:
        """The tetrahedra, or -1, that walks from the tetrahedra `starts` find, or from `middle`.

        A walk crosses the facet that its place is farthest behind, of those that have a neighbour.
        It may end in a flat tetrahedron of the hull, which one that comes from the middle avoids.
        """
        found = np.full(len(places), -1, dtype=np.int32)
        for begin in (starts, np.full(len(places), middle)):
            left = np.flatnonzero(found < 0)
            numbers = begin[left]
            for _ in range(_MOST_STEPS):
                if len(left) == 0:
                    break
                at = places[left]
                weights, is_known, _ = self._weigh(at, numbers)
                within = weights.min(axis=0) >= -self._tolerance
                doubtful = np.flatnonzero(~is_known)
                within[doubtful] = self._are_within(at[doubtful], numbers[doubtful])
                found[left[within]] = numbers[within]
                neighbors = self._neighbors[numbers].T
                is_open = (neighbors >= 0) & (weights < -self._tolerance)
                face = np.where(is_open, weights, np.inf).argmin(axis=0)
                goes_on = ~within & is_open.any(axis=0)
                left, numbers = left[goes_on], neighbors[face, np.arange(len(face))][goes_on]
        return found

    def find(self, places: FloatArray, starts: IndexArray, radii: FloatArray) -> IndexArray:
        """The tetrahedra, or -1, for places whose balls meet the tetrahedra `starts`."""
        count = len(self._simplices)
        found = np.full(len(places), -1, dtype=np.int32)
        doubtful = []
        # Pairs of a place and a tetrahedron as one number: those before, and those to look at.
        before = np.empty(0, dtype=np.int64)
        pairs = np.arange(len(places), dtype=np.int64) * count + starts
        while len(pairs):
            if len(pairs) > _MOST_PAIRS and len(places) > 1:
                halves = (slice(None, len(places) // 2), slice(len(places) // 2, None))
                return np.concatenate([self.find(places[h], starts[h], radii[h]) for h in halves])
            who, numbers = np.divmod(pairs, count)
            # The least weights, NaN where rounding might decide about the tolerance.
            weights, meets = np.empty(len(pairs)), np.empty(len(pairs), dtype=np.bool_)
            for block in blocks(len(pairs)):
                at = who[block]
                each, is_known, meets[block] = self._weigh(places[at], numbers[block], radii[at])
                weights[block] = np.where(is_known, each.min(axis=0), np.nan)
            taken = np.flatnonzero(weights >= -self._tolerance)
            taken = taken[np.argsort(weights[taken])]
            # Of several the last, with the largest weight, stays.
            found[who[taken]] = numbers[taken]
            doubtful.append(pairs[np.isnan(weights)])
            goes_on = meets & (found[who] < 0)
            neighbors = self._neighbors[numbers[goes_on]]
            following = who[goes_on, np.newaxis] * count + neighbors
            following = np.unique(following[neighbors >= 0])
            seen = np.concatenate([before, pairs])
            before, pairs = pairs, np.setdiff1d(following, seen, assume_unique=True)
        who, numbers = np.divmod(np.concatenate([np.empty(0, dtype=np.int64), *doubtful]), count)
        left = np.flatnonzero(found[who] < 0)
        for block in blocks(len(left)):
            at, number = who[left[block]], numbers[left[block]]
            within = self._are_within(places[at], number)
            found[at[within]] = number[within]
        return found


class _Ways:
    """The ways of places to the centroid of the hull, where they enter the hull, and where they end."""

    def __init__(
        self, facets: FloatArray, exponent: int, locate: Callable[[FloatArray], IndexArray]
    ) -> None:
        """Of a hull with `facets` (n, 3, 3), computed with times ``2**-exponent``."""
        self._locate = locate
        self._exponent = exponent
        facets = np.ldexp(facets, -exponent)
        self._size = float(np.abs(facets).max())
        self._low, self._high = facets.min(axis=(0, 1)), facets.max(axis=(0, 1))
        self.diagonal = float(np.sqrt(((self._high - self._low) ** 2).sum()))
        self._center, width = _hull_center(facets)
        middle = int(locate(np.ldexp(self._center[np.newaxis], exponent))[0])
        is_flat = width <= 1e-6 * self.diagonal or middle < 0
        self.middle = max(middle, 0)
        # Twice as much as needed, for rounding of the centroid and of what is computed with it.
        self._rounding = np.inf if is_flat else 2.0**-46 * self._size / width

    def near(self, places: FloatArray, tolerance: float) -> IndexArray:
        """Which places may be within the tolerance."""
        scaled = np.ldexp(places, -self._exponent)
        margin = 3.001 * tolerance * (self._high - self._low) + 2.0**-50 * self._size
        is_near = (scaled >= self._low - margin) & (scaled <= self._high + margin)
        return np.flatnonzero(is_near.all(axis=1))

    def enter(self, places: FloatArray, tolerance: float) -> tuple[IndexArray, FloatArray]:
        """Tetrahedra next to where the ways enter the hull, -1 for places that cannot be within the
        tolerance, and how far away at most they are.
        """
        starts = np.full(len(places), -1, dtype=np.int32)
        distances = np.full(len(places), np.inf)
        if self._rounding >= 0.5:
            # A hull so flat has no inside to speak of.
            starts[:] = 0
            return starts, distances
        scaled = np.ldexp(places, -self._exponent)
        last = max(24 / (1 / tolerance + 24), 2.0**-30, self._rounding)
        for share in [s for s in _SHARES if s < last] + [last]:
            left = np.flatnonzero(starts < 0)
            arms = self._center - scaled[left]
            starts[left] = self._locate(np.ldexp(scaled[left] + share * arms, self._exponent))
            distances[left] = share * np.sqrt((arms**2).sum(axis=1))
        return starts, distances


def in_tolerance(
    places: FloatArray,
    tolerance: float,
    points: FloatArray,
    hull: IndexArray,
    locate: Callable[[FloatArray], IndexArray],
    mesh: Callable[[], tuple[IndexArray, IndexArray]],
) -> IndexArray:
    """For each place outside the hull a tetrahedron in which no weight is below -tolerance, or -1.

    `locate` finds the tetrahedra of places, `mesh` gives all of them and their neighbours.
    """
    found = np.full(len(places), -1, dtype=np.int32)
    if len(hull) == 0:
        return found
    facets = points[hull]
    # Products of three coordinates stay in range.
    exponent = int(np.frexp(np.abs(facets).max())[1])
    exponent = exponent if abs(exponent) > 200 else 0
    with np.errstate(all="ignore"):
        ways = _Ways(facets, exponent, locate)

        def take_within(limit: float) -> None:
            left = np.flatnonzero(found < 0)
            left = left[ways.near(places[left], limit)]
            starts, distances = ways.enter(places[left], limit)
            enters = starts >= 0
            left, starts, distances = left[enters], starts[enters], distances[enters]
            if len(left) == 0 or limit == np.inf:
                found[left] = starts
                return
            search = _Search(points, exponent, *mesh(), limit)
            radii = np.maximum(distances, 3 * limit * ways.diagonal) * (1 + 2.0**-20)
            for block in blocks(len(left)):
                at, start = places[left[block]], starts[block]
                if limit <= _SEARCHED:
                    found[left[block]] = search.find(at, start, radii[block])
                else:
                    found[left[block]] = search.walk(at, start, ways.middle)

        take_within(min(tolerance, _SEARCHED))
        if tolerance > _SEARCHED:
            take_within(tolerance)
    return found
