# SPDX-License-Identifier: MIT
"""Annotations, for the package and for a program that uses it; and the oldest Python."""

import ast
import inspect
import pathlib
import subprocess
import sys
import tempfile
import unittest

import mgdt

PACKAGE = pathlib.Path(mgdt.__file__).parent

PROGRAM = """
import numpy as np
from numpy.typing import NDArray
from mgdt import CANCEL, Delaunay

def volume(tri: Delaunay) -> float:
    simplices: NDArray[np.int32] = tri.simplices
    a, b, c, d = (tri.points[simplices[:, k]] for k in range(4))
    return float(np.einsum("ij,ij->", np.cross(b - a, c - a), d - a) / 6)

def located(tri: Delaunay, places: NDArray[np.float64], asked: bool) -> NDArray[np.int32]:
    simplices, weights = tri.locate(places)
    again: NDArray[np.float64] = tri.locate(places, weights=True)[1] + weights
    alone: NDArray[np.int32] = tri.locate(places, weights=False)
    either = tri.locate(places, asked)
    return (either[0] if isinstance(either, tuple) else either) + alone + simplices

with Delaunay([[0, 0, 0]], incremental=True, progress=lambda f: CANCEL if f > 2 else None) as tri:
    tri.add_points(np.zeros((4, 3)))
    volume(tri)
"""


class Typing(unittest.TestCase):
    def mypy(self, *arguments):
        with tempfile.TemporaryDirectory() as cache:
            return subprocess.run(
                [sys.executable, "-m", "mypy", "--strict", "--python-version", "3.9"]
                + ["--cache-dir", cache, *map(str, arguments)],
                cwd=PACKAGE.parent,
                capture_output=True,
                text=True,
            )

    def test_the_package_and_its_use(self):
        with tempfile.TemporaryDirectory() as folder:
            good, wrong = pathlib.Path(folder, "good.py"), pathlib.Path(folder, "wrong.py")
            good.write_text(PROGRAM)
            wrong.write_text(PROGRAM + "tri.add_points(np.zeros((4, 3)), restrat=True)\n")
            result = self.mypy(PACKAGE, good)
            self.assertEqual(result.returncode, 0, result.stdout)
            result = self.mypy(wrong)
            self.assertEqual(result.returncode, 1)
            self.assertIn('"restrat"', result.stdout)
            # Each of these takes one result for another.
            wrong.write_text(
                PROGRAM
                + "a: NDArray[np.float64] = tri.locate(tri.points, weights=False)\n"
                + "b, c = tri.locate(tri.points, weights=False), tri.locate(tri.points).shape\n"
            )
            result = self.mypy(wrong)
            self.assertEqual(result.stdout.count(": error:"), 2, result.stdout)
        self.assertTrue((PACKAGE / "py.typed").exists())

    def test_python_3_9_reads_it(self):
        files = sorted(PACKAGE.glob("*.py"))
        self.assertGreater(len(files), 5)
        for file in files:
            source = file.read_text()
            tree = ast.parse(source, str(file), feature_version=(3, 9))
            self.assertIn("SPDX-License-Identifier: MIT", source[:100])
            # Annotations are not evaluated, so that newer forms do no harm.
            self.assertIn("from __future__ import annotations", source, file)
            self.assertFalse([n for n in ast.walk(tree) if isinstance(n, getattr(ast, "Match"))])

    def test_everything_public_is_documented(self):
        for name in mgdt.__all__:
            thing = getattr(mgdt, name)
            if inspect.isclass(thing) or inspect.isfunction(thing):
                self.assertTrue(inspect.getdoc(thing), name)
        for name, thing in inspect.getmembers(mgdt.Delaunay):
            if not name.startswith("_") and name not in ("ndim", "furthest_site"):
                self.assertTrue(inspect.getdoc(thing), name)


if __name__ == "__main__":
    unittest.main()
