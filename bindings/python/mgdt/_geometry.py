# SPDX-License-Identifier: MIT
"""What SciPy derives from tetrahedra and their vertices' coordinates, in NumPy."""

from __future__ import annotations

from typing import Iterator

import numpy as np

from ._arrays import FloatArray, IndexArray

# Tetrahedra computed together: temporary arrays stay in the cache.
_BLOCK = 1 << 14

# SciPy's: a tetrahedron whose matrix has a worse reciprocal condition has no transform.
_LEAST_CONDITION = 1000 * np.finfo(np.float64).eps


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


def barycentric_transforms(points: FloatArray, simplices: IndexArray) -> FloatArray:
    """Matrices (n, 4, 3) that give barycentric coordinates.

    ``c = transform[i, :3] @ (x - transform[i, 3])`` are the weights of the first three vertices of
    tetrahedron i; the fourth is ``1 - c.sum()``. NaN for a tetrahedron too flat for that.
    """
    transforms = np.empty((len(simplices), 4, 3))
    for block in _blocks(len(simplices)):
        edges, last = _edges_from_last(points, simplices[block])
        # Powers of two change no digit and keep the products in range.
        exponent = np.frexp(np.abs(edges).max(axis=(0, 1)))[1]
        scaled = np.ldexp(edges, -exponent)
        a, b, c = scaled[:, 0], scaled[:, 1], scaled[:, 2]
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            # The rows of the inverse of the matrix with columns a, b, c.
            rows = np.stack([_cross(b, c), _cross(c, a), _cross(a, b)])
            rows /= _dot(a, rows[0])
            # One-norms, of the matrix and its inverse: largest sums of columns.
            condition = 1 / (
                np.abs(scaled).sum(axis=0).max(axis=0) * np.abs(rows).sum(axis=0).max(axis=0)
            )
            rows = np.ldexp(rows, -exponent)
        flat = ~(condition >= _LEAST_CONDITION)
        rows[:, :, flat] = np.nan
        transforms[block, :3] = rows.transpose(2, 0, 1)
        transforms[block, 3] = np.where(flat, np.nan, last).T
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


def in_tolerance(
    places: FloatArray, transforms: FloatArray, numbers: IndexArray, tolerance: float
) -> IndexArray:
    """For each place one of the tetrahedra `numbers` in which no weight is below -tolerance; -1
    where there is none."""
    found = np.full(len(places), -1, dtype=np.int32)
    for k, place in enumerate(places):
        first = np.einsum("ijk,ik->ij", transforms[:, :3], place - transforms[:, 3])
        least = np.minimum(first.min(axis=1), 1 - first.sum(axis=1))
        # NaN, of flat tetrahedra, is never the best.
        least[np.isnan(least)] = -np.inf
        best = int(np.argmax(least)) if len(least) else -1
        if best >= 0 and least[best] >= -tolerance:
            found[k] = numbers[best]
    return found
