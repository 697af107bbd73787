# SPDX-License-Identifier: MIT
"""What the tests share: point sets, and comparisons that do not depend on numbering."""

import os
import subprocess
import sys
from fractions import Fraction

import numpy as np


def random_points(n, seed=0):
    """Points in general position in a box that is no cube and not at the origin."""
    return np.random.default_rng(seed).random((n, 3)) * [1, 2, 3] + [5, 0, -1]


def grid(n):
    """n x n x n points, as degenerate as can be."""
    axis = np.arange(n, dtype=float)
    return np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), axis=-1).reshape(-1, 3)


def turned_grid(n):
    """A grid turned by a rotation: its tetrahedra are many as thin as rounding makes them."""
    rotation, _ = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))
    return grid(n) @ rotation


def on_a_sphere(n, seed=0):
    """Points in every direction at the distance 1, up to rounding."""
    points = np.random.default_rng(seed).normal(size=(n, 3))
    return points / np.linalg.norm(points, axis=1, keepdims=True)


def exact_inverse(corners):
    """The inverse of the matrix of three edges from the fourth corner, as fractions."""
    a, b, c, d = ([Fraction(float(x)) for x in corner] for corner in corners)
    edges = [[x - y for x, y in zip(corner, d)] for corner in (a, b, c)]

    def cross(u, v):
        return [u[k - 2] * v[k - 1] - u[k - 1] * v[k - 2] for k in range(3)]

    rows = [cross(edges[k - 2], edges[k - 1]) for k in range(3)]
    volume = sum(x * y for x, y in zip(edges[0], rows[0]))
    return [[x / volume for x in row] for row in rows]


def exact_weights(corners, place):
    """The four weights of a place, as fractions."""
    arm = [Fraction(float(x)) - Fraction(float(y)) for x, y in zip(place, corners[3])]
    weights = [sum(x * y for x, y in zip(row, arm)) for row in exact_inverse(corners)]
    return [*weights, 1 - sum(weights)]


def row_set(rows):
    """Rows as a set, each without its order."""
    return set(map(tuple, np.sort(rows, axis=1).tolist()))


def matching(rows, others):
    """For each row the place of the row in others with the same elements in any order."""
    rows, others = np.sort(rows, axis=1), np.sort(others, axis=1)
    order, other_order = np.lexsort(rows.T), np.lexsort(others.T)
    np.testing.assert_array_equal(rows[order], others[other_order])
    match = np.empty(len(rows), dtype=int)
    match[order] = other_order
    return match


def run_python(program, *arguments, **environment):
    """Runs a program in a Python of its own. A variable that is None is unset."""
    variables = {**os.environ, **environment}
    return subprocess.run(
        [sys.executable, "-c", program, *arguments],
        env={name: value for name, value in variables.items() if value is not None},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=120,
    )
