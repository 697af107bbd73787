# SPDX-License-Identifier: MIT
"""What the tests share: point sets, and comparisons that do not depend on numbering."""

import os
import subprocess
import sys

import numpy as np


def random_points(n, seed=0):
    """Points in general position in a box that is no cube and not at the origin."""
    return np.random.default_rng(seed).random((n, 3)) * [1, 2, 3] + [5, 0, -1]


def grid(n):
    """n x n x n points, as degenerate as can be."""
    axis = np.arange(n, dtype=float)
    return np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), axis=-1).reshape(-1, 3)


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
