# SPDX-License-Identifier: MIT
"""What SciPy derives from tetrahedra and their vertices' coordinates, in NumPy."""

from __future__ import annotations

from typing import Any, Callable, Iterator

import numpy as np
from numpy.typing import NDArray

from ._arrays import FloatArray, IndexArray

# Tetrahedra computed together: temporary arrays stay in the cache.
_BLOCK = 1 << 14

# Pairs of place and tetrahedron looked at together, unless the places are one.
_MOST_PAIRS = 1 << 21

# The least volume, over the product of three edges' largest coordinates, of a tetrahedron that
# doubles compute well enough. With u = 2^-53 each difference of coordinates is off by a factor
# within 1 +- u, so a coordinate of a cross product b x c is off by less than 8u |b| |c|, and the
# determinant a . (b x c) by less than 48u |a| |b| |c|, in largest coordinates. The largest
# coordinate of b x c is at least a third of the determinant over |a|. So an entry of the inverse is
# off by less than 80u |a| |b| |c| / |determinant| of the largest entry in its row: 1e-11 at most.
_LEAST_VOLUME = 2.0**-10


def _blocks(count: int) -> Iterator[slice]:
    for begin in range(0, count, _BLOCK):
        yield slice(begin, min(begin + _BLOCK, count))


def _edges_from_last(points: FloatArray, simplices: IndexArray) -> tuple[FloatArray, FloatArray]:
    """Of each tetrahedron the vectors from the last vertex to the others, and the last vertex.

    Tetrahedra are on the last axis, (3, 3, n) and (3, n), coordinates on the first: arithmetic on
    whole rows is several times as fast as on triples.
    """
    corners = points.T[:, simplices.T]
    last = corners[:, 3]
    return corners[:, :3] - last[:, np.newaxis], last


def _cross(a: FloatArray, b: FloatArray) -> FloatArray:
    return np.stack([a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2] for k in range(3)])


def _dot(a: FloatArray, b: FloatArray) -> FloatArray:
    product: FloatArray = a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    return product


def _quotient(numerator: int, denominator: int, exponent: int) -> float:
    """The double nearest to ``numerator / denominator * 2**exponent``."""
    if exponent >= 0:
        numerator <<= exponent
    else:
        denominator <<= -exponent
    try:
        # Python rounds the quotient of two integers correctly.
        return numerator / denominator
    except OverflowError:
        return np.inf if (numerator > 0) == (denominator > 0) else -np.inf
    except ZeroDivisionError:
        # Four points in a plane, if the caller has changed the array of points.
        return np.nan


_quotients = np.frompyfunc(_quotient, 3, 1)


def _as_integers(doubles: FloatArray) -> tuple[Any, Any]:
    """Doubles (..., n) as Python's integers, and an exponent of two for each of the n columns."""
    fractions, exponents = np.frexp(doubles)
    others = tuple(range(doubles.ndim - 1))
    exponents = np.where(doubles == 0, exponents.max(axis=others), exponents)
    least = exponents.min(axis=others)
    integers = (fractions * 2.0**53).astype(np.int64).astype(object)
    return integers << (exponents - least).astype(object), (least - 53).astype(object)


def _exact_inverses(corners: FloatArray) -> FloatArray:
    """The rows (3, 3, n) of the inverses for corners (3, 4, n), correctly rounded."""
    integers, exponents = _as_integers(corners)
    a, b, c = ((integers[:, :3] - integers[:, 3:])[:, k] for k in range(3))
    rows = np.stack([_cross(b, c), _cross(c, a), _cross(a, b)])
    inverses: FloatArray = _quotients(rows, _dot(a, rows[0]), -exponents).astype(np.float64)
    return inverses


def barycentric_transforms(points: FloatArray, simplices: IndexArray) -> FloatArray:
    """Matrices (n, 4, 3) that give barycentric coordinates.

    ``c = transform[i, :3] @ (x - transform[i, 3])`` are the weights of the first three vertices of
    tetrahedron i; the fourth is ``1 - c.sum()``. Entries are exact, rounded, for flat tetrahedra;
    for others they are off by less than 1e-11 of the largest entry in their row.
    """
    transforms = np.empty((len(simplices), 4, 3))
    for block in _blocks(len(simplices)):
        corners = points.T[:, simplices[block].T]
        last = corners[:, 3]
        with np.errstate(all="ignore"):
            edges = corners[:, :3] - last[:, np.newaxis]
            # Powers of two change no digit and keep the products in range.
            lengths = np.abs(edges).max(axis=0)
            exponent = np.frexp(lengths.max(axis=0))[1]
            a, b, c = np.ldexp(edges, -exponent).transpose(1, 0, 2)
            # The rows of the inverse of the matrix with columns a, b, c.
            rows = np.stack([_cross(b, c), _cross(c, a), _cross(a, b)])
            volume = _dot(a, rows[0])
            rows /= volume
            rows = np.ldexp(rows, -exponent)
            # Not at least, so that it takes NaN of differences that overflow. Underflow is far
            # below 2^-900.
            least = np.maximum(_LEAST_VOLUME * np.ldexp(lengths, -exponent).prod(axis=0), 2.0**-900)
            # Rows that leave the range of normal numbers lose digits.
            magnitude = np.abs(rows).max(axis=(0, 1))
            flat = ~((np.abs(volume) >= least) & (magnitude >= 2.0**-900))
        if flat.any():
            rows[:, :, flat] = _exact_inverses(corners[:, :, flat])
        transforms[block, :3] = rows.transpose(2, 0, 1)
        transforms[block, 3] = last.T
    return transforms


def paraboloid(points: FloatArray) -> tuple[float, float]:
    """Scale and shift of the lifted coordinate, ``scale |x|^2 + shift``.

    As Qhull's option Qbb has it, with the point above the paraboloid that Qz adds: the coordinate
    goes from 0 to the largest magnitude of the others.
    """
    if len(points) == 0:
        return 1.0, 0.0
    squares = np.einsum("ij,ij->i", points, points)
    least, most = float(squares.min()), 1.1 * float(squares.max())
    magnitude = float(np.abs(points).max())
    with np.errstate(all="ignore"):
        scale = float(np.float64(magnitude) / np.float64(most - least))
    if not (0 < scale < np.inf):
        return 1.0, 0.0
    return scale, -least * scale


def lift(places: FloatArray, scale: float, shift: float) -> FloatArray:
    """Places (m, 3) on the paraboloid (m, 4)."""
    lifted = np.empty((len(places), 4))
    lifted[:, :3] = places
    lifted[:, 3] = scale * np.einsum("ij,ij->i", places, places) + shift
    return lifted


def hyperplanes(
    points: FloatArray, simplices: IndexArray, scale: float, shift: float
) -> FloatArray:
    """Hyperplanes (n, 5) through the lifted tetrahedra: unit normals, pointing down, and offsets.

    ``normal @ lifted + offset`` is positive for what is inside the circumsphere.
    """
    planes = np.empty((len(simplices), 5))
    for block in _blocks(len(simplices)):
        edges, last = _edges_from_last(points, simplices[block])
        a, b, c = edges[:, 0], edges[:, 1], edges[:, 2]
        bc = _cross(b, c)
        volume = _dot(a, bc)
        # The circumcentre is at center / (2 volume) from the last vertex; nothing is divided, so
        # that flat tetrahedra have a hyperplane too.
        center = _dot(a, a) * bc + _dot(b, b) * _cross(c, a) + _dot(c, c) * _cross(a, b)
        normal = np.concatenate([center + 2 * volume * last, -volume[np.newaxis] / scale])
        with np.errstate(divide="ignore", invalid="ignore"):
            normal *= np.where(volume < 0, -1, 1) / np.sqrt((normal**2).sum(axis=0))
        planes[block, :4] = normal.T
        planes[block, 4] = -(normal * lift(last.T, scale, shift).T).sum(axis=0)
    return planes


def vertex_neighbors(edges: IndexArray, count: int) -> tuple[IndexArray, IndexArray]:
    """The neighbours of each of `count` vertices as a compressed list, ascending."""
    wide = edges.astype(np.int64)
    # One number for both ends of an edge sorts faster than two.
    keys = np.concatenate([wide[:, 0] * count + wide[:, 1], wide[:, 1] * count + wide[:, 0]])
    keys.sort()
    ends = np.bincount(edges.ravel(), minlength=count)
    offsets = np.zeros(count + 1, dtype=np.int32)
    np.cumsum(ends, out=offsets[1:])
    neighbors = (keys % max(count, 1)).astype(np.int32)
    return offsets, neighbors


# Places outside the hull, within a tolerance
#
# Let g be the centroid of the hull, t the tolerance, and x a place with no weight below -t in some
# tetrahedron T. At most three weights are negative, so x is beyond no hull plane by more than 3t of
# the hull's width across that plane. The centroid of a convex body is at least a quarter of that
# width away from the plane. So the place x + s (g - x) is in the hull for s = 12t / (1 + 12t), and
# a place x for which it is not is in no such T. T contains the place c + (x - c) / (1 + 4t), where
# c is its own centroid. That is no farther from x than 3t diameters of T, so T meets the ball
# around x of that radius. Ball and hull are convex, so the tetrahedra that meet the ball are
# connected by facets: all T are found from one that meets it, by way of others that do.


def _hull_center(corners: FloatArray) -> tuple[FloatArray, float]:
    """Of the hull with facets (n, 3, 3) the centroid, and a lower bound of its width."""
    middle = corners.mean(axis=(0, 1))
    arms = (corners - middle).transpose(1, 2, 0)
    volumes = _dot(arms[0], _cross(arms[1], arms[2]))
    center = middle + (volumes * arms.sum(axis=0)).sum(axis=1) / (4 * volumes.sum())
    # Across any plane the standard deviation is at most half the width.
    spread = np.cov(corners.reshape(-1, 3).T, bias=True)
    return center, 2 * float(np.sqrt(max(np.linalg.eigvalsh(spread)[0], 0.0)))


def _are_within(corners: FloatArray, places: FloatArray, tolerance: float) -> NDArray[np.bool_]:
    """Whether no weight of places (3, n) is below -tolerance, exactly."""
    integers, _ = _as_integers(np.concatenate([corners, places[:, np.newaxis]], axis=1))
    a, b, c, x = ((integers[:, [0, 1, 2, 4]] - integers[:, 3:4])[:, k] for k in range(4))
    volume = _dot(a, _cross(b, c))
    sides = [_dot(x, _cross(b, c)), _dot(x, _cross(c, a)), _dot(x, _cross(a, b))]
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
        self, places: FloatArray, numbers: IndexArray, radii: FloatArray
    ) -> tuple[FloatArray, NDArray[np.bool_]]:
        """For each place and tetrahedron the least weight, and whether it may meet the ball.

        The weight is NaN where rounding might decide about the tolerance.
        """
        edges, last = _edges_from_last(self._scaled, self._simplices[numbers])
        arm = np.ldexp(places.T, -self._exponent) - last
        a, b, c = edges[:, 0], edges[:, 1], edges[:, 2]
        normals = np.stack([_cross(b, c), _cross(c, a), _cross(a, b)])
        volume = _dot(a, normals[0])
        sides = np.stack([_dot(arm, normal) for normal in normals])
        sides = np.concatenate([sides, (volume - sides.sum(axis=0))[np.newaxis]])
        sides *= np.where(volume < 0, -1, 1)
        volume = np.abs(volume)
        # Each determinant is off as for _LEAST_VOLUME, by 48u of the largest coordinates. The
        # fourth side is off by what the others are, and by its own sums. 128u is more than that.
        p, q, r = np.abs(edges).max(axis=0)
        error = 2.0**-46 * (p * q * r + np.abs(arm).max(axis=0) * (p * q + q * r + r * p))
        error += 2.0**-900
        areas = np.concatenate([normals, normals.sum(axis=0)[np.newaxis]])
        areas = np.sqrt((areas**2).sum(axis=1)) * (1 + 2.0**-20)
        meets = (sides >= -radii * areas - error).all(axis=0)
        weights = sides.min(axis=0) / volume
        doubt = error * (1 + self._tolerance) / volume
        is_known = (doubt <= 2.0**-37) | (np.abs(weights + self._tolerance) > doubt)
        return np.where(is_known, weights, np.nan), meets

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
            weights, meets = np.empty(len(pairs)), np.empty(len(pairs), dtype=np.bool_)
            for block in _blocks(len(pairs)):
                at = who[block]
                weights[block], meets[block] = self._weigh(places[at], numbers[block], radii[at])
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
        for block in _blocks(len(left)):
            at, number = who[left[block]], numbers[left[block]]
            corners = self._points.T[:, self._simplices[number].T]
            within = _are_within(corners, places[at].T, self._tolerance)
            found[at[within]] = number[within]
        return found


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
    if len(hull) == 0 or len(places) == 0:
        return found
    facets = points[hull]
    size = float(np.abs(facets).max())
    # Products of three coordinates stay in range.
    exponent = int(np.frexp(size)[1])
    exponent = exponent if abs(exponent) > 200 else 0
    with np.errstate(all="ignore"):
        facets, scaled = np.ldexp(facets, -exponent), np.ldexp(places, -exponent)
        size = float(np.ldexp(size, -exponent))
        low, high = facets.min(axis=(0, 1)), facets.max(axis=(0, 1))
        diagonal = float(np.sqrt(((high - low) ** 2).sum()))
        margin = 3.001 * tolerance * (high - low) + 2.0**-50 * size
        near = ((scaled >= low - margin) & (scaled <= high + margin)).all(axis=1)
        near = np.flatnonzero(near)
        if len(near) == 0:
            return found
        center, width = _hull_center(facets)
        # Twice as much as needed, for rounding of the centroid and of what is computed with it.
        rounding = 2.0**-46 * size / width if width > 1e-6 * diagonal else np.inf
        last = max(24 * tolerance / (1 + 24 * tolerance), 2.0**-30, rounding)
        starts = np.full(len(near), -1, dtype=np.int32)
        radii = np.full(len(near), np.inf)
        if rounding < 0.5:
            shares = [s for s in 2.0 ** np.arange(-40, 0, 10) if s < last] + [last]
            for share in shares:
                left = np.flatnonzero(starts < 0)
                arms = center - scaled[near[left]]
                inside = np.ldexp(scaled[near[left]] + share * arms, exponent)
                starts[left] = locate(inside)
                radii[left] = share * np.sqrt((arms**2).sum(axis=1))
            radii = np.maximum(radii, 3 * tolerance * diagonal) * (1 + 2.0**-20)
        else:
            # In a hull so flat all tetrahedra are looked at.
            starts[:] = 0
        near, starts, radii = (array[starts >= 0] for array in (near, starts, radii))
        if len(near):
            search = _Search(points, exponent, *mesh(), tolerance)
            for block in _blocks(len(near)):
                at = near[block]
                found[at] = search.find(places[at], starts[block], radii[block])
    return found
