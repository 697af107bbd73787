# SPDX-License-Identifier: MIT
"""The Voronoi diagram: beside SciPy's, and cells of lattices."""

import unittest

import numpy as np
import scipy.spatial
from support import grid, random_points

import mgdt


def places(diagram, numbers):
    """The vertices with these numbers, infinity first; from lists of one diagram or another."""
    rounded = [
        tuple((np.round(diagram.vertices[k], 6) + 0.0).tolist()) if k >= 0 else () for k in numbers
    ]
    return sorted(set(rounded))


def faces(diagram):
    pairs = map(tuple, np.sort(diagram.ridge_points, axis=1).tolist())
    return {
        pair: places(diagram, vertices) for pair, vertices in zip(pairs, diagram.ridge_vertices)
    }


def count_of_faces(diagram):
    return np.bincount(diagram.ridge_points.ravel(), minlength=diagram.npoints)


class Voronoi(unittest.TestCase):
    def test_beside_scipy(self):
        for n in (4, 5, 20, 300):
            points = random_points(n)
            ours, theirs = mgdt.Voronoi(points), scipy.spatial.Voronoi(points)
            self.assertEqual(len(ours.vertices), len(theirs.vertices))
            # Qhull leaves out faces with one vertex and infinity.
            wide = {pair: corners for pair, corners in faces(ours).items() if len(corners) > 2}
            self.assertEqual(wide, faces(theirs))
            for k in range(n):
                self.assertEqual(
                    places(ours, ours.regions[ours.point_region[k]]),
                    places(theirs, theirs.regions[theirs.point_region[k]]),
                )
            np.testing.assert_array_equal(
                count_of_faces(ours), ours.delaunay.cell_measures("faces")
            )
            np.testing.assert_allclose(ours.min_bound, theirs.min_bound)
            np.testing.assert_allclose(ours.max_bound, theirs.max_bound)
            self.assertEqual((ours.npoints, ours.ndim), (theirs.npoints, theirs.ndim))

    def test_vertices_go_round_their_faces(self):
        diagram = mgdt.Voronoi(random_points(200))
        for (i, j), vertices in diagram.ridge_dict.items():
            if -1 in vertices:
                self.assertEqual(vertices[0], -1)
                continue
            corners = diagram.vertices[vertices]
            axis = diagram.points[j] - diagram.points[i]
            around = np.cross(corners, np.roll(corners, -1, axis=0)) @ axis
            turns = np.cross(
                np.roll(corners, -1, axis=0) - corners, np.roll(corners, -2, axis=0) - corners
            )
            # Convex: all turns go one way.
            self.assertGreater(abs(np.sign(turns @ axis).sum()), len(vertices) - 1)
            self.assertNotEqual(around.sum(), 0)

    def test_lattices(self):
        cubes = mgdt.Voronoi(grid(5))
        self.assertEqual(len(cubes.vertices), 64)
        np.testing.assert_array_equal(
            count_of_faces(cubes), cubes.delaunay.cell_measures("faces")
        )
        middle = grid(5).tolist().index([2, 2, 2])
        self.assertEqual(len(cubes.regions[cubes.point_region[middle]]), 8)
        self.assertEqual(
            {len(v) for pair, v in cubes.ridge_dict.items() if middle in pair}, {4}
        )
        body = np.concatenate([grid(5), grid(4) + 0.5])
        crystal = mgdt.Voronoi(body)
        sizes = [len(v) for pair, v in crystal.ridge_dict.items() if middle in pair]
        self.assertEqual(sorted(sizes), [4] * 6 + [6] * 8)

    def test_repeats_and_measures(self):
        points = np.random.default_rng(4).random((100, 3))
        box = [[1, 0, 0, 2], [-1, 0, 0, 1], [0, 1, 0, 2], [0, -1, 0, 1], [0, 0, 1, 2], [0, 0, -1, 1]]
        diagram = mgdt.Voronoi(np.concatenate([points, points[:3]]), planes=box)
        self.assertEqual(diagram.point_region[100:].tolist(), [-1, -1, -1])
        self.assertAlmostEqual(diagram.volumes.sum(), 27, delta=1e-12)
        self.assertEqual(diagram.areas.shape, (103,))
        self.assertEqual(diagram.centroids.shape, (103, 3))
        self.assertIn("103 points", repr(diagram))
        tri = mgdt.Delaunay(points)
        self.assertIs(mgdt.Voronoi(tri).delaunay, tri)

    def test_flat_sets_are_refused(self):
        for points in (np.zeros((0, 3)), np.eye(3), grid(3)[:9]):
            with self.assertRaisesRegex(ValueError, "there are no cells"):
                mgdt.Voronoi(points)

    def test_many_on_a_sphere(self):
        points = random_points(2000) - 0.5
        points /= np.linalg.norm(points, axis=1)[:, np.newaxis]
        diagram = mgdt.Voronoi(points)
        np.testing.assert_array_equal(
            count_of_faces(diagram), diagram.delaunay.cell_measures("faces")
        )


if __name__ == "__main__":
    unittest.main()
