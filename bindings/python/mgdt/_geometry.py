# SPDX-License-Identifier: MIT
"""What SciPy derives from tetrahedra and their vertices' coordinates, in NumPy."""

from __future__ import annotations

from typing import Any, Iterator

import numpy as np

from ._arrays import FloatArray, IndexArray

# Tetrahedra computed together: temporary arrays stay in the cache.
_BLOCK = 1 << 14

# The least volume, over the product of three edges' largest coordinates, of a tetrahedron that
# doubles compute well enough. With u = 2^-53 each difference of coordinates is off by a factor
# within 1 +- u, so a coordinate of a cross product b x c is off by less than 8u |b| |c|, and the
# determinant a . (b x c) by less than 48u |a| |b| |c|, in largest coordinates. The largest
# coordinate of b x c is at least a third of the determinant over |a|. So an entry of the inverse is
# off by less than 80u |a| |b| |c| / |determinant| of the largest entry in its row: 1e-11 at most.
_LEAST_VOLUME = 2.0**-10


def blocks(count: int) -> Iterator[slice]:
    for begin in range(0, count, _BLOCK):
        yield slice(begin, min(begin + _BLOCK, count))


def edges_from_last(points: FloatArray, simplices: IndexArray) -> tuple[FloatArray, FloatArray]:
    """Of each tetrahedron the vectors from the last vertex to the others, and the last vertex.

    Tetrahedra are on the last axis, (3, 3, n) and (3, n), coordinates on the first: arithmetic on
    whole rows is several times as fast as on triples.
    """
    corners = points.T[:, simplices.T]
    last = corners[:, 3]
    return corners[:, :3] - last[:, np.newaxis], last


def cross(a: FloatArray, b: FloatArray) -> FloatArray:
    return np.stack([a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2] for k in range(3)])


def dot(a: FloatArray, b: FloatArray) -> FloatArray:
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


def as_integers(doubles: FloatArray) -> tuple[Any, Any]:
    """Doubles (..., n) as Python's integers, and an exponent of two for each of the n columns."""
    fractions, exponents = np.frexp(doubles)
    others = tuple(range(doubles.ndim - 1))
    exponents = np.where(doubles == 0, exponents.max(axis=others), exponents)
    least = exponents.min(axis=others)
    integers = (fractions * 2.0**53).astype(np.int64).astype(object)
    return integers << (exponents - least).astype(object), (least - 53).astype(object)


def _exact_inverses(corners: FloatArray) -> FloatArray:
    """The rows (3, 3, n) of the inverses for corners (3, 4, n), correctly rounded."""
    integers, exponents = as_integers(corners)
    a, b, c = ((integers[:, :3] - integers[:, 3:])[:, k] for k in range(3))
    rows = np.stack([cross(b, c), cross(c, a), cross(a, b)])
    inverses: FloatArray = _quotients(rows, dot(a, rows[0]), -exponents).astype(np.float64)
    return inverses


def barycentric_transforms(points: FloatArray, simplices: IndexArray) -> FloatArray:
    """Matrices (n, 4, 3) that give barycentric coordinates.

    ``c = transform[i, :3] @ (x - transform[i, 3])`` are the weights of the first three vertices of
    tetrahedron i; the fourth is ``1 - c.sum()``. Entries are exact, rounded, for flat tetrahedra;
    for others they are off by less than 1e-11 of the largest entry in their row.
    """
    transforms = np.empty((len(simplices), 4, 3))
    for block in blocks(len(simplices)):
        corners = points.T[:, simplices[block].T]
        last = corners[:, 3]
        with np.errstate(all="ignore"):
            edges = corners[:, :3] - last[:, np.newaxis]
            # Powers of two change no digit and keep the products in range.
            lengths = np.abs(edges).max(axis=0)
            exponent = np.frexp(lengths.max(axis=0))[1]
            a, b, c = np.ldexp(edges, -exponent).transpose(1, 0, 2)
            # The rows of the inverse of the matrix with columns a, b, c.
            rows = np.stack([cross(b, c), cross(c, a), cross(a, b)])
            volume = dot(a, rows[0])
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
    for block in blocks(len(simplices)):
        edges, last = edges_from_last(points, simplices[block])
        a, b, c = edges[:, 0], edges[:, 1], edges[:, 2]
        bc = cross(b, c)
        volume = dot(a, bc)
        # The circumcentre is at center / (2 volume) from the last vertex; nothing is divided, so
        # that flat tetrahedra have a hyperplane too.
        center = dot(a, a) * bc + dot(b, b) * cross(c, a) + dot(c, c) * cross(a, b)
        normal = np.concatenate([center + 2 * volume * last, -volume[np.newaxis] / scale])
        with np.errstate(divide="ignore", invalid="ignore"):
            normal *= np.where(volume < 0, -1, 1) / np.sqrt((normal**2).sum(axis=0))
        planes[block, :4] = normal.T
        planes[block, 4] = -(normal * lift(last.T, scale, shift).T).sum(axis=0)
    return planes
