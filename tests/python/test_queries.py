# SPDX-License-Identifier: MIT
"""Location, weights, interpolation and nearest vertices, against SciPy and known functions."""

import unittest
from unittest import mock

import numpy as np
import scipy.interpolate
import scipy.spatial
from support import exact_weights, grid, on_a_sphere, random_points, turned_grid

import mgdt
from mgdt import _tolerance


class Location(unittest.TestCase):
    def test_weights(self):
        points = random_points(1000, 1)
        tri = mgdt.Delaunay(points)
        places = np.random.default_rng(2).uniform(tri.min_bound, tri.max_bound, (40, 50, 3))
        found, weights = tri.locate(places)
        self.assertEqual((found.dtype, found.shape), (np.int32, (40, 50)))
        self.assertEqual((weights.dtype, weights.shape), (np.float64, (40, 50, 4)))
        inside = found >= 0
        self.assertTrue(0.5 < inside.mean() < 1)
        again = np.einsum("...k,...kx->...x", weights, points[tri.simplices[found]])
        np.testing.assert_allclose(again[inside], places[inside], atol=1e-12)
        np.testing.assert_allclose(weights[inside].sum(axis=-1), 1, rtol=1e-14)
        self.assertTrue((weights >= 0).all())
        self.assertTrue((weights[~inside] == 0).all())
        np.testing.assert_array_equal(tri.locate(places, weights=False), found)
        np.testing.assert_array_equal(tri.find_simplex(places), found)
        # One by one, and in other layouts.
        self.assertEqual(int(tri.find_simplex(places[3, 4])), found[3, 4])
        np.testing.assert_array_equal(tri.locate(np.asfortranarray(places))[1], weights)
        np.testing.assert_array_equal(tri.locate(places[::2, ::-1])[0], found[::2, ::-1])

    def test_segments(self):
        tri = mgdt.Delaunay(random_points(3000, 1))
        a, b = np.array([4.9, 0.2, -0.9]), np.array([6.1, 1.7, 1.6])
        simplices, parameters = tri.traverse_segment(a, b)
        self.assertEqual((simplices.dtype, parameters.dtype), (np.int32, np.float64))
        self.assertEqual(len(parameters), len(simplices) + 1)
        self.assertGreater(len(simplices), 20)
        self.assertTrue((np.diff(parameters) > 0).all())
        middles = a + (b - a) * ((parameters[1:] + parameters[:-1]) / 2)[:, np.newaxis]
        np.testing.assert_array_equal(tri.find_simplex(middles), simplices)
        # Each one is a neighbour of the one before.
        self.assertTrue((tri.neighbors[simplices[:-1]] == simplices[1:, np.newaxis]).any(axis=1).all())
        # More than there is room for at first.
        line = mgdt.Delaunay(np.vstack([np.column_stack([np.zeros(300), np.zeros(300), np.arange(300.0)]),
                                        [[1, 0, 0], [0, 1, 0], [-1, -1, 0]]]))
        self.assertGreater(len(line.traverse_segment([0.01, 0.01, 0], [0.01, 0.01, 299])[0]), 250)
        # Along an edge of a lattice's hull.
        simplices, parameters = mgdt.Delaunay(grid(4)).traverse_segment([-1, 0, 0], [4, 0, 0])
        self.assertEqual((parameters[0], parameters[-1]), (0.2, 0.8))
        for array in tri.traverse_segment([2, 2, 2], [3, 3, 3.5]):
            self.assertEqual(len(array), 0)
        with self.assertRaisesRegex(ValueError, "a must be one point"):
            tri.traverse_segment([[0, 0, 0]], b)
        with self.assertRaisesRegex(ValueError, "a coordinate of b is not finite"):
            tri.traverse_segment(a, [0, np.inf, 0])

    def test_more_than_a_block(self):
        tri = mgdt.Delaunay(random_points(300, 3))
        places = random_points((1 << 20) + 1000, 4)
        found, weights = tri.locate(places)
        ends = np.r_[0:500, (1 << 20) - 500 : len(places)]
        found_alone, weights_alone = tri.locate(places[ends])
        np.testing.assert_array_equal(found[ends], found_alone)
        np.testing.assert_array_equal(weights[ends], weights_alone)
        places[(1 << 20) + 7] = np.nan
        found[(1 << 20) + 7] = -1
        np.testing.assert_array_equal(tri.locate(places)[0], found)
        np.testing.assert_array_equal(tri.find_simplex(places), found)

    def test_boundaries_belong_to_the_inside(self):
        points = grid(4)
        tri = mgdt.Delaunay(points)
        self.assertTrue((tri.find_simplex(points) >= 0).all())
        on_faces = points[(points[:, 0] == 3) & (points < 3).all(axis=1, where=[False, True, True])]
        on_faces = on_faces + [0, 0.3, 0.7]
        self.assertTrue((tri.find_simplex(on_faces) >= 0).all())
        just_outside = on_faces.copy()
        just_outside[:, 0] = np.nextafter(3, 4)
        self.assertTrue((tri.find_simplex(just_outside) == -1).all())

    def test_tolerance(self):
        tri = mgdt.Delaunay(random_points(200, 5))
        theirs = scipy.spatial.Delaunay(tri.points)
        # Points on the hull, of which rounding puts half outside.
        generator = np.random.default_rng(6)
        facets = tri.points[tri.convex_hull]
        weights = generator.dirichlet([1, 1, 1], len(facets))
        places = np.einsum("ij,ijk->ik", weights, facets)
        exact = tri.find_simplex(places)
        self.assertTrue(0 < (exact < 0).sum() < len(places))
        # Which are in depends on the tolerance, as for SciPy.
        for tolerance in (1e-12, 1e-10, 1e-8):
            np.testing.assert_array_equal(
                tri.find_simplex(places, tol=tolerance) < 0,
                theirs.find_simplex(places, tol=tolerance) < 0,
            )
        tolerant = tri.find_simplex(places, tol=1e-8)
        self.assertTrue((tolerant >= 0).all())
        np.testing.assert_array_equal(tolerant[exact >= 0], exact[exact >= 0])
        facet_sets = np.sort(tri.convex_hull, axis=1)
        for simplex, facet in zip(tolerant, facet_sets):
            self.assertLessEqual(len(set(facet) - set(tri.simplices[simplex])), 1)
        # Farther out it takes a larger one.
        center = tri.points.mean(axis=0)
        outside = center + (places - center) * 1.001
        for tolerance, least, most in ((0, 0, 0), (1e-6, 0, 0), (0.5, len(places), len(places))):
            count = int((tri.find_simplex(outside, tol=tolerance) >= 0).sum())
            self.assertTrue(least <= count <= most, (tolerance, count))
        self.assertTrue((theirs.find_simplex(outside, tol=0.5) >= 0).all())
        self.assertEqual(tri.find_simplex([np.nan, 0, 0], tol=0.1), -1)


def places_near_the_hull(tri, count, spread, seed):
    """Places on hull facets and as far as `spread` from there, as a part of the size."""
    generator = np.random.default_rng(seed)
    facets = tri.points[tri.convex_hull[generator.integers(0, len(tri.convex_hull), count)]]
    on_facets = np.einsum("ij,ijk->ik", generator.dirichlet([1, 1, 1], count), facets)
    center = tri.points.mean(axis=0)
    return center + (on_facets - center) * (1 + spread * generator.uniform(-1, 1, (count, 1)))


class Tolerance(unittest.TestCase):
    """`find_simplex` with `tol`."""

    def expected(self, tri, place, tolerance):
        """The tetrahedra in which exact weights are not below the tolerance."""
        return [
            k
            for k, corners in enumerate(tri.points[tri.simplices])
            if min(exact_weights(corners, place)) >= -tolerance
        ]

    def test_against_all_tetrahedra(self):
        sets = {
            "uniform": random_points(60, 1),
            "sphere": on_a_sphere(40, 2),
            "turned grid": turned_grid(3),
            "plate": random_points(40, 3) * [1, 1, 1e-4],
            "thin plate": random_points(30, 4) * [1, 1, 1e-9],
            "far away": random_points(40, 5) * 1e-4 + 1e6,
            "small": np.ldexp(random_points(30, 6), -1000),
            "large": np.ldexp(random_points(30, 6), 1000),
        }
        for name, points in sets.items():
            tri = mgdt.Delaunay(points)
            for tolerance in (1e-9, 9e-7, 1e-3, 0.5, 1e300):
                places = places_near_the_hull(tri, 5, min(3 * tolerance, 3), 7)
                exact = tri.find_simplex(places)
                found = tri.find_simplex(places, tol=tolerance)
                for place, inside, simplex in zip(places, exact, found):
                    with self.subTest(name, tolerance=tolerance, place=place):
                        if inside >= 0:
                            self.assertEqual(simplex, inside)
                            continue
                        expected = self.expected(tri, place, tolerance)
                        # With a large tolerance a walk may miss them.
                        if tolerance < 2**-20 or tolerance > 1e200:
                            self.assertEqual(simplex >= 0, bool(expected))
                        if simplex >= 0:
                            self.assertIn(simplex, expected)

    def test_few_pairs_at_a_time(self):
        tri = mgdt.Delaunay(random_points(300, 1))
        places = places_near_the_hull(tri, 300, 1e-5, 2)
        expected = tri.find_simplex(places, tol=9e-7)
        self.assertTrue(0 < (expected >= 0).sum() < len(places))
        with mock.patch.object(_tolerance, "_MOST_PAIRS", 100):
            np.testing.assert_array_equal(tri.find_simplex(places, tol=9e-7), expected)

    def test_behind_flat_tetrahedra(self):
        # All of them are as far outside as rounding puts them; the nearest tetrahedron with a
        # volume to speak of need not have a vertex on the hull.
        points = turned_grid(9)
        tri = mgdt.Delaunay(points)
        places = places_near_the_hull(tri, 2000, 0, 1)
        self.assertTrue(0 < (tri.find_simplex(places) < 0).mean() < 1)
        self.assertTrue((tri.find_simplex(places, tol=1e-9) >= 0).all())

    def test_few_tetrahedra_are_looked_at(self):
        # Of these sets every tetrahedron has vertices on the hull.
        for points in (on_a_sphere(5000, 1), random_points(20_000, 2)):
            tri = mgdt.Delaunay(points)
            for spread in (0, 0.1):
                places = places_near_the_hull(tri, 20_000, spread, 3)
                outside = (tri.find_simplex(places) < 0).sum()
                self.assertGreater(outside, 5000)
                for tolerance, most in ((1e-9, 5), (0.01, 300), (0.1, 300), (1, 300)):
                    pairs = []

                    def weigh(self, at, *others):
                        pairs.append(len(at))
                        return weigh_as_ever(self, at, *others)

                    weigh_as_ever = _tolerance._Search._weigh
                    with mock.patch.object(_tolerance._Search, "_weigh", weigh):
                        tri.find_simplex(places, tol=tolerance)
                    self.assertLess(sum(pairs), most * outside)

    def test_a_large_tolerance_takes_nearly_what_scipy_takes(self):
        points = random_points(2000, 4)
        tri, theirs = mgdt.Delaunay(points), scipy.spatial.Delaunay(points)
        places = places_near_the_hull(tri, 2000, 2, 5)
        for tolerance in (0.1, 1, 10):
            taken = tri.find_simplex(places, tol=tolerance) >= 0
            by_scipy = theirs.find_simplex(places, tol=tolerance) >= 0
            self.assertGreaterEqual(taken.sum(), by_scipy.sum())
            self.assertLess((by_scipy & ~taken).sum(), 0.01 * len(places))
        self.assertTrue((tri.find_simplex(places, tol=np.inf) >= 0).all())

    def test_nothing_to_be_near_to(self):
        for points in ([], [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]):
            tri = mgdt.Delaunay(np.reshape(points, (-1, 3)))
            self.assertEqual(tri.find_simplex([0.1, 0.1, 0], tol=0.1), -1)
        tri = mgdt.Delaunay(random_points(30, 1))
        far = [[1e308, -1e308, 1e308], [np.inf, 0, 0], [np.nan, 0, 0]]
        self.assertEqual(tri.find_simplex(far, tol=1e-6).tolist(), [-1, -1, -1])
        self.assertEqual(tri.find_simplex(np.zeros((0, 3)), tol=1e-6).shape, (0,))


class Nearest(unittest.TestCase):
    def test_against_a_tree(self):
        for points in (random_points(3000, 7), random_points(30, 8) * [1, 1, 0]):
            tri = mgdt.Delaunay(points)
            places = np.random.default_rng(9).normal(size=(20, 100, 3)) * 3 + [5, 1, 0]
            found = tri.nearest_vertex(places)
            self.assertEqual((found.dtype, found.shape), (np.int32, (20, 100)))
            _, expected = scipy.spatial.cKDTree(points).query(places)
            np.testing.assert_array_equal(found, expected)
            self.assertEqual(tri.nearest_vertex(places[0, 0]).shape, ())
            tri.shrink()
            np.testing.assert_array_equal(tri.nearest_vertex(places), expected)

    def test_many_with_threads(self):
        tri = mgdt.Delaunay(random_points(500, 11), threads=2)
        places = np.random.default_rng(12).normal(size=(40000, 3))
        _, expected = scipy.spatial.cKDTree(tri.points).query(places)
        np.testing.assert_array_equal(tri.nearest_vertex(places), expected)

    def test_ties_go_to_the_lowest(self):
        points = grid(3)[::-1]
        tri = mgdt.Delaunay(points)
        self.assertEqual(
            tri.nearest_vertex([0.5, 0.5, 0.5]),
            min(k for k, p in enumerate(points.tolist()) if max(p) <= 1),
        )


class Interpolation(unittest.TestCase):
    def setUp(self):
        self.points = random_points(800, 10)
        self.tri = mgdt.Delaunay(self.points)
        self.places = np.random.default_rng(11).uniform(
            self.points.min(axis=0) - 0.1, self.points.max(axis=0) + 0.1, (30, 40, 3)
        )

    def test_linear_functions_are_exact(self):
        def f(x):
            return x @ [[2, -1], [0.5, 3], [-4, 1]] + [1, 2]

        values = self.tri.interpolate(f(self.points), self.places)
        self.assertEqual(values.shape, (30, 40, 2))
        outside = self.tri.find_simplex(self.places) < 0
        self.assertTrue(np.isnan(values[outside]).all())
        np.testing.assert_allclose(values[~outside], f(self.places[~outside]), atol=1e-12)

    def test_as_scipy(self):
        generator = np.random.default_rng(12)
        for values in (
            generator.random(800),
            generator.random((800, 2, 3)),
            generator.random(800) + 1j * generator.random(800),
            generator.integers(0, 100, 800),
            generator.random(800).astype(np.float32),
        ):
            theirs = scipy.interpolate.LinearNDInterpolator(self.points, values, fill_value=-1)
            expected = theirs(self.places)
            found = self.tri.interpolate(values, self.places, fill_value=-1)
            self.assertEqual((found.dtype, found.shape), (expected.dtype, expected.shape))
            np.testing.assert_allclose(found, expected, atol=1e-9)

    def test_places_that_are_not_finite_are_filled(self):
        places = np.concatenate([self.places.reshape(-1, 3)[:50], np.full((4, 3), self.points[0])])
        places[10, 1], places[11, 2], places[50, 0] = np.nan, np.inf, -np.inf
        values = np.random.default_rng(13).random((800, 2))
        expected = scipy.interpolate.LinearNDInterpolator(self.points, values, -7)(places)
        np.testing.assert_allclose(self.tri.interpolate(values, places, -7), expected, atol=1e-9)
        self.assertTrue((expected[[10, 11, 50]] == -7).all())
        at = self.tri.interpolator(places)
        self.assertTrue((at.simplices[[10, 11, 50]] == -1).all())
        self.assertTrue((at.weights[[10, 11, 50]] == 0).all())
        simplices, weights = self.tri.locate(self.places)
        np.testing.assert_array_equal(self.tri.interpolator(self.places).weights, weights)
        np.testing.assert_array_equal(self.tri.interpolator(self.places).simplices, simplices)
        alone = self.tri.interpolate(values, [np.nan, 0, 0])
        self.assertTrue(alone.shape == (2,) and np.isnan(alone).all())

    def test_weights_are_used_again(self):
        at = self.tri.interpolator(self.places)
        self.tri.release()
        for k in range(3):
            values = np.random.default_rng(k).random((800, 4))
            expected = mgdt.Delaunay(self.points).interpolate(values, self.places)
            np.testing.assert_allclose(at(values), expected, atol=1e-14)
        self.assertEqual(at.simplices.shape, (30, 40))
        self.assertEqual(at.vertices.shape, (30, 40, 4))
        self.assertEqual(at.weights.shape, (30, 40, 4))

    def test_fill_value(self):
        outside = [[100, 100, 100]]
        self.assertTrue(np.isnan(self.tri.interpolate(np.ones(800), outside)[0]))
        self.assertEqual(self.tri.interpolate(np.ones(800), outside, fill_value=2j)[0], 2j)
        inside = self.points.mean(axis=0)
        self.assertAlmostEqual(float(self.tri.interpolate(np.ones(800), inside)), 1)

    def test_values_at_duplicates(self):
        tri = mgdt.Delaunay(np.concatenate([self.points, self.points[:5]]))
        values = np.r_[np.arange(800.0), [np.nan] * 5]
        np.testing.assert_allclose(tri.interpolate(values, self.points), values[:800], atol=1e-9)


if __name__ == "__main__":
    unittest.main()
