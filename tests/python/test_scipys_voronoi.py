# SPDX-License-Identifier: MIT
"""SciPy's own tests of its Voronoi diagrams that hold in space, run with mgdt's in their place.

Most of SciPy's are of sets in the plane, and of options of Qhull. Those that take any set have its
random points in space, and sets of ours.
"""

import itertools
import types
import unittest

import mgdt
import numpy as np
import scipy.spatial
from scipy.spatial.tests import test_qhull

IN_SPACE = {name: points for name, points in test_qhull.DATASETS.items() if points.shape[1] == 3}
IN_SPACE["cluster"] = np.random.default_rng(3).normal(size=(30, 3)) ** 3
IN_SPACE["lattice"] = np.array(list(itertools.product(range(4), repeat=3)), dtype=float)


def voronoi(points, incremental=False, qhull_options=None):
    return mgdt.Voronoi(points, incremental=incremental)


class SciPysVoronoi(unittest.TestCase):
    def setUp(self):
        chunks = {f"{name}-chunk-{size}": ([points[:5], *(points[k:k + size] for k in range(5, len(points), size))], None)
                  for name, points in IN_SPACE.items() for size in (1, 4, 16)}
        replacements = [
            ("Voronoi", voronoi),
            ("qhull", types.SimpleNamespace(Voronoi=voronoi)),
            ("DATASETS", IN_SPACE),
            ("INCREMENTAL_DATASETS", chunks),
        ]
        for name, replacement in replacements:
            self.addCleanup(setattr, test_qhull, name, getattr(test_qhull, name))
            setattr(test_qhull, name, replacement)
        self.tests = test_qhull.TestVoronoi()

    def test_point_region_structure(self):
        for points in (50, 100):
            # Without a point at infinity.
            self.tests.test_point_region_structure("Qbb Qc", points, 0, 3)

    def test_masked_array_fails(self):
        self.tests.test_masked_array_fails()

    def test_ridges(self):
        self.assertIn("random-3d", IN_SPACE)
        for name in IN_SPACE:
            with self.subTest(name):
                self.tests.test_ridges(name)

    def test_incremental(self):
        names = [n for n in test_qhull.INCREMENTAL_DATASETS if not n.startswith("lattice")]
        self.assertGreaterEqual(len(names), 6)
        for name in names:
            with self.subTest(name):
                self.tests.test_incremental(name)


class BesideSciPy(unittest.TestCase):
    def test_same_diagram(self):
        """Points without ties have one diagram: the same faces between the same points."""
        for name in ("random-3d", "cluster"):
            with self.subTest(name):
                ours, theirs = mgdt.Voronoi(IN_SPACE[name]), scipy.spatial.Voronoi(IN_SPACE[name])
                tree = scipy.spatial.KDTree(ours.vertices)
                distance, number = tree.query(theirs.vertices)
                self.assertLess((distance / (1 + np.abs(theirs.vertices).max(axis=1))).max(), 1e-6)
                number = np.append(number, -1)  # for infinity

                def faces(diagram, corners):
                    return {tuple(sorted(sides)): tuple(sorted(corners(face)))
                            for sides, face in zip(diagram.ridge_points.tolist(), diagram.ridge_vertices)}

                # SciPy leaves out unbounded faces that have one vertex (scipy#21379).
                wedges = {sides: face for sides, face in faces(ours, list).items() if len(face) == 2}
                self.assertTrue(all(face[0] == -1 for face in wedges.values()))
                found = faces(theirs, lambda face: number[face].tolist())
                self.assertEqual(faces(ours, list), {**wedges, **found})
                for i, region in enumerate(ours.point_region):
                    own = theirs.regions[theirs.point_region[i]]
                    self.assertEqual(sorted(ours.regions[region]), sorted(number[own].tolist()))


if __name__ == "__main__":
    unittest.main()
