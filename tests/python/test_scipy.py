# SPDX-License-Identifier: MIT
"""The same programs with scipy.spatial.Delaunay and with mgdt.Delaunay."""

import pickle
import time
import unittest
from fractions import Fraction
from unittest import mock

import numpy as np
import scipy.interpolate
import scipy.spatial
from support import exact_inverse, grid, matching, random_points, row_set, turned_grid

import mgdt
from mgdt import _geometry

SETS = {
    "few": random_points(5, 1),
    "uniform": random_points(2000, 2),
    "clustered": np.random.default_rng(3).normal(size=(1500, 3)) ** 3,
    "sphere": np.concatenate(
        [
            (lambda x: x / np.linalg.norm(x, axis=1, keepdims=True))(
                np.random.default_rng(4).normal(size=(400, 3))
            ),
            [[0.01, 0.02, 0.03]],
        ]
    ),
}


class Both(unittest.TestCase):
    """Attributes, on sets in general position, where there is one triangulation."""

    def pairs(self):
        for name, points in SETS.items():
            with self.subTest(name):
                ours, theirs = mgdt.Delaunay(points), scipy.spatial.Delaunay(points)
                ours.check(3)
                yield points, ours, theirs

    def test_simplices_are_the_same(self):
        for _, ours, theirs in self.pairs():
            self.assertEqual(row_set(ours.simplices), row_set(theirs.simplices))
            self.assertEqual(ours.nsimplex, theirs.nsimplex)

    def test_shapes_and_types_are_the_same(self):
        names = (
            "points simplices neighbors convex_hull coplanar equations transform min_bound "
            "max_bound vertex_to_simplex"
        )
        for _, ours, theirs in self.pairs():
            for name in names.split():
                a, b = getattr(ours, name), getattr(theirs, name)
                self.assertEqual((name, a.dtype, a.shape), (name, b.dtype, b.shape))
            for a, b in zip(ours.vertex_neighbor_vertices, theirs.vertex_neighbor_vertices):
                self.assertEqual((a.dtype, a.shape), (b.dtype, b.shape))
            for name in ("ndim", "npoints", "nsimplex", "furthest_site"):
                self.assertEqual(getattr(ours, name), getattr(theirs, name), name)
            np.testing.assert_array_equal(ours.points, theirs.points)
            np.testing.assert_array_equal(ours.min_bound, theirs.min_bound)
            np.testing.assert_array_equal(ours.max_bound, theirs.max_bound)

    def test_orientation_is_positive(self):
        for points, ours, _ in self.pairs():
            a, b, c, d = (points[ours.simplices[:, k]] for k in range(4))
            volumes = np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a)
            self.assertTrue((volumes > 0).all())

    def test_neighbors_are_the_same(self):
        for _, ours, theirs in self.pairs():
            match = matching(ours.simplices, theirs.simplices)
            for k in range(4):
                # Which of SciPy's vertices is our k-th: opposite it is the same neighbour.
                place = np.argmax(theirs.simplices[match] == ours.simplices[:, k : k + 1], axis=1)
                expected = theirs.neighbors[match, place]
                found = ours.neighbors[:, k]
                np.testing.assert_array_equal(found < 0, expected < 0)
                np.testing.assert_array_equal(match[found[found >= 0]], expected[found >= 0])
                self.assertTrue((found >= -1).all())

    def test_hull_is_the_same_and_turned_outward(self):
        for points, ours, theirs in self.pairs():
            self.assertEqual(row_set(ours.convex_hull), row_set(theirs.convex_hull))
            a, b, c = (points[ours.convex_hull[:, k]] for k in range(3))
            outward = np.einsum("ij,ij->i", np.cross(b - a, c - a), a - points.mean(axis=0))
            self.assertTrue((outward > 0).all())

    def test_transform_is_the_same(self):
        for points, ours, theirs in self.pairs():
            match = matching(ours.simplices, theirs.simplices)
            # The order of vertices differs, so weights are compared vertex by vertex.
            places = points[ours.simplices].mean(axis=1) + 1e-3
            ours_at, theirs_at = (
                np.einsum("ijk,ik->ij", t[:, :3], places - t[:, 3])
                for t in (ours.transform, theirs.transform[match])
            )
            known = ~np.isnan(ours_at).any(axis=1) & ~np.isnan(theirs_at).any(axis=1)
            self.assertGreater(known.mean(), 0.9)
            weights = np.c_[ours_at, 1 - ours_at.sum(axis=1)][known]
            expected = np.c_[theirs_at, 1 - theirs_at.sum(axis=1)][known]
            order = np.argsort(ours.simplices[known], axis=1)
            their_order = np.argsort(theirs.simplices[match][known], axis=1)
            weights = np.take_along_axis(weights, order, axis=1)
            expected = np.take_along_axis(expected, their_order, axis=1)
            # A flat simplex multiplies rounding by as much as it multiplies weights.
            size = np.abs(ours.transform[known, :3]).max(axis=(1, 2)) * np.abs(points).max()
            scale = (size**2)[:, np.newaxis]
            self.assertLess((np.abs(weights - expected) / scale).max(), 1e-13)

    def test_transform_of_a_flat_simplex(self):
        points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 1e-14]])
        # SciPy's Qhull gives no simplex at all here; ours is there.
        flat = mgdt.Delaunay(points)
        self.assertEqual(flat.transform.shape, (1, 4, 3))
        self.assertEqual(flat.find_simplex([0.5, 0.5, 2e-15]), 0)
        corners = points[flat.simplices[0]]
        expected = np.array(exact_inverse(corners), dtype=np.float64)
        np.testing.assert_array_equal(flat.transform[0, :3], expected)
        np.testing.assert_array_equal(flat.transform[0, 3], corners[3])

    def test_transform_is_exact_up_to_rounding(self):
        sets = {
            "turned grid": turned_grid(11),
            "sphere": SETS["sphere"],
            "clustered": SETS["clustered"],
            "far away": random_points(500, 1) + 1e9,
            "small": np.ldexp(turned_grid(4), -1022),
            "large": np.ldexp(turned_grid(4), 1020),
            "long": random_points(200, 2) * [1e-300, 1, 1e300],
        }
        for name, points in sets.items():
            with self.subTest(name):
                tri = mgdt.Delaunay(points)
                transform = tri.transform
                corners = points[tri.simplices]
                np.testing.assert_array_equal(transform[:, 3], corners[:, 3])
                self.assertFalse(np.isnan(transform).any())
                some = np.random.default_rng(2).permutation(tri.nsimplex)[:400]
                self.assertLessEqual(self.largest_error(transform[some], corners[some]), 1e-11)

    def largest_error(self, transforms, corners):
        """In parts of the largest entry of the row, but for what doubles have no digits for."""
        largest = Fraction(0)
        for transform, tetrahedron in zip(transforms, corners):
            for row, expected in zip(transform[:3], exact_inverse(tetrahedron)):
                for value, wanted in zip(row, expected):
                    if np.isinf(value):
                        self.assertGreaterEqual(abs(wanted), Fraction(1.797e308))
                        self.assertEqual(value > 0, wanted > 0)
                        continue
                    error = abs(Fraction(float(value)) - wanted)
                    if error > Fraction(1, 2**1075):
                        largest = max(largest, error / max(map(abs, expected)))
        return float(largest)

    def test_the_bound_for_doubles_is_needed(self):
        # All simplices of the turned grid by doubles alone.
        tri = mgdt.Delaunay(turned_grid(5))
        corners = tri.points[tri.simplices]
        self.assertLess(self.largest_error(tri.transform, corners), 1e-14)
        with mock.patch.object(_geometry, "_LEAST_VOLUME", 0):
            transforms = _geometry.barycentric_transforms(tri.points, tri.simplices)
        self.assertGreater(self.largest_error(transforms, corners), 1e-11)

    def test_transform_of_flat_simplices_is_quick(self):
        tri = mgdt.Delaunay(turned_grid(21))
        tri.simplices
        begin = time.process_time()
        transform = tri.transform
        seconds = time.process_time() - begin
        flat = np.abs(transform[:, :3]).max(axis=(1, 2)) > 1e9
        self.assertGreater(flat.sum(), 10_000)
        self.assertLess(seconds, 3)

    def test_transform_at_extreme_scales(self):
        points = random_points(50, 5)
        usual = mgdt.Delaunay(points)
        for exponent in (-900, 900):
            scaled = mgdt.Delaunay(np.ldexp(points, exponent))
            np.testing.assert_array_equal(scaled.simplices, usual.simplices)
            np.testing.assert_array_equal(
                np.ldexp(scaled.transform[:, :3], exponent), usual.transform[:, :3]
            )

    def test_equations_and_distances_are_the_same(self):
        for points, ours, theirs in self.pairs():
            match = matching(ours.simplices, theirs.simplices)
            self.assertAlmostEqual(ours.paraboloid_scale, theirs.paraboloid_scale, 12)
            self.assertAlmostEqual(ours.paraboloid_shift, theirs.paraboloid_shift, 12)
            lengths = np.linalg.norm(ours.equations[:, :4], axis=1)
            np.testing.assert_allclose(lengths, 1, rtol=1e-14)
            self.assertTrue((ours.equations[:, 3] <= 0).all())
            # Our planes pass through all four lifted vertices, by themselves.
            lifted = ours.lift_points(points[ours.simplices])
            size = np.abs(lifted).max()
            off = np.einsum("ijk,ik->ij", lifted, ours.equations[:, :4])
            off += ours.equations[:, 4:]
            self.assertLess(np.abs(off).max() / size, 1e-9)
            well_shaped = np.abs(theirs.equations[match, 3]) > 1e-3
            self.assertTrue(well_shaped.any())
            difference = np.abs(ours.equations - theirs.equations[match])[well_shaped]
            self.assertLess(difference.max() / size, 1e-8)
            places = random_points(7, 6).reshape(7, 1, 3)
            distances = ours.plane_distance(places)
            self.assertEqual(distances.shape, (7, 1, ours.nsimplex))
            expected = theirs.plane_distance(places)[..., match]
            self.assertLess(np.abs(distances - expected)[..., well_shaped].max() / size, 1e-8)
            np.testing.assert_allclose(
                ours.lift_points(places), theirs.lift_points(places), rtol=1e-12
            )

    def test_inside_the_circumsphere_is_above(self):
        points = random_points(200, 7)
        ours = mgdt.Delaunay(points)
        # Delaunay: no vertex is inside a circumsphere.
        self.assertLess(ours.plane_distance(points).max(), 1e-10)
        centers = points[ours.simplices].mean(axis=1)
        self.assertTrue((np.diagonal(ours.plane_distance(centers)) > 0).all())

    def test_vertices_neighbors_are_the_same(self):
        for points, ours, theirs in self.pairs():
            (starts, ends), (their_starts, their_ends) = (
                ours.vertex_neighbor_vertices,
                theirs.vertex_neighbor_vertices,
            )
            np.testing.assert_array_equal(starts, their_starts)
            for k in range(len(points)):
                self.assertEqual(
                    ends[starts[k] : starts[k + 1]].tolist(),
                    sorted(their_ends[their_starts[k] : their_starts[k + 1]].tolist()),
                )
            own = ours.vertex_to_simplex
            self.assertTrue((ours.simplices[own] == np.arange(len(points))[:, None]).any(1).all())

    def test_find_simplex_is_the_same(self):
        for points, ours, theirs in self.pairs():
            match = matching(ours.simplices, theirs.simplices)
            places = np.random.default_rng(8).uniform(
                points.min(axis=0) - 0.2, points.max(axis=0) + 0.2, (3000, 3)
            )
            found, expected = ours.find_simplex(places), theirs.find_simplex(places)
            self.assertEqual((found.dtype, found.shape), (expected.dtype, expected.shape))
            inside = found >= 0
            np.testing.assert_array_equal(inside, expected >= 0)
            np.testing.assert_array_equal(match[found[inside]], expected[inside])
            np.testing.assert_array_equal(ours.find_simplex(places, bruteforce=True), found)
            # Vertices are ties: in any simplex around them.
            at = ours.find_simplex(points)
            self.assertTrue((ours.simplices[at] == np.arange(len(points))[:, None]).any(1).all())

    def test_find_simplex_takes_the_same_arguments(self):
        ours, theirs = (c(SETS["uniform"]) for c in (mgdt.Delaunay, scipy.spatial.Delaunay))
        for places in (
            [5.5, 1, 0],
            [[5.5, 1, 0], [0, 0, 0]],
            np.full((2, 3, 4, 3), 0.5),
            np.zeros((0, 3)),
            np.zeros((4, 0, 3)),
            [[np.nan, 1, 0], [5.5, np.inf, 0], [5.5, 1, 0]],
            np.array([[5, 1, 0]], dtype=np.int16),
            np.full((6, 2), 5.4)[::2].T.copy(),
        ):
            found, expected = ours.find_simplex(places), theirs.find_simplex(places)
            self.assertIsInstance(found, np.ndarray)
            self.assertEqual((found.dtype, found.shape), (expected.dtype, expected.shape))
            np.testing.assert_array_equal(found < 0, expected < 0)


class Documented(unittest.TestCase):
    """What SciPy's manual shows, in space."""

    def both(self, program):
        return program(mgdt.Delaunay), program(scipy.spatial.Delaunay)

    def test_first_steps(self):
        def program(Delaunay):
            points = np.array([[0, 0, 0], [0, 1.1, 0], [1, 0, 0], [1, 1, 0.1], [0.4, 0.3, 1]])
            tri = Delaunay(points)
            corners = points[tri.simplices[0]]
            neighbor = tri.neighbors[0].max()
            shared = set(tri.simplices[0].tolist()) & set(tri.simplices[neighbor].tolist())
            return row_set(tri.simplices), corners.shape, len(shared)

        ours, theirs = self.both(program)
        self.assertEqual(ours, theirs)
        self.assertEqual(ours[1:], ((4, 3), 3))

    def test_barycentric_coordinates_by_transform(self):
        points = random_points(30, 9)
        places = points.mean(axis=0) + [[0, 0, 0], [0.1, 0.2, 0.1], [-0.1, 0, 0.2]]

        def program(Delaunay):
            tri = Delaunay(points)
            found = tri.find_simplex(places)
            transform = tri.transform[found]
            b = np.einsum("njk,nk->nj", transform[:, :3], places - transform[:, 3])
            weights = np.c_[b, 1 - b.sum(axis=1)]
            return np.einsum("nj,njk->nk", weights, points[tri.simplices[found]]), weights

        (ours, weights), (theirs, their_weights) = self.both(program)
        np.testing.assert_allclose(ours, places, atol=1e-12)
        np.testing.assert_allclose(theirs, places, atol=1e-12)
        np.testing.assert_allclose(np.sort(weights), np.sort(their_weights), atol=1e-12)

    def test_duplicates_are_coplanar(self):
        points = np.concatenate([random_points(40, 10), random_points(40, 10)[[3, 7, 7]]])

        def program(Delaunay):
            tri = Delaunay(points)
            rows = tri.coplanar
            # Of two equal points either may be the vertex.
            for point, simplex, vertex in rows:
                np.testing.assert_array_equal(points[point], points[vertex])
                self.assertNotIn(point, tri.simplices)
                self.assertIn(vertex, tri.simplices)
                # Near the facet: SciPy's may touch only the vertex, ours has it.
                self.assertTrue(0 <= simplex < tri.nsimplex)
            places = sorted(tuple(points[row[0]]) for row in rows)
            return places, rows.dtype, rows.shape

        ours, theirs = self.both(program)
        self.assertEqual(ours, theirs)
        tri = mgdt.Delaunay(points)
        np.testing.assert_array_equal(tri.coplanar[:, 0], [40, 41, 42])
        np.testing.assert_array_equal(tri.coplanar[:, 2], [3, 7, 7])
        for _, simplex, vertex in tri.coplanar:
            self.assertIn(vertex, tri.simplices[simplex])
        # Indexed by point it gives a simplex around the point, also for these. SciPy gives the
        # number of a vertex for them.
        around = tri.simplices[tri.vertex_to_simplex]
        self.assertTrue((around == tri.point_map[:, np.newaxis]).any(axis=1).all())
        their = scipy.spatial.Delaunay(points)
        np.testing.assert_array_equal(
            their.vertex_to_simplex[their.coplanar[:, 0]], their.coplanar[:, 2]
        )
        np.testing.assert_array_equal(tri.point_map[40:], [3, 7, 7])

    def test_adding_points(self):
        batches = [random_points(20, seed) for seed in range(11, 15)]

        def program(Delaunay):
            tri = Delaunay(batches[0], incremental=True)
            sets = [row_set(tri.simplices)]
            for k, batch in enumerate(batches[1:]):
                tri.add_points(batch, restart=k == 1)
                sets.append(row_set(tri.simplices))
            tri.close()
            with self.assertRaises(RuntimeError):
                tri.add_points(batches[0])
            np.testing.assert_array_equal(tri.points, np.concatenate(batches))
            return sets, tri.npoints, int((tri.find_simplex(tri.points) < 0).sum())

        ours, theirs = self.both(program)
        self.assertEqual(ours, theirs)

    def test_points_cannot_be_added_without_asking(self):
        def program(Delaunay):
            with self.assertRaises(RuntimeError):
                Delaunay(random_points(20)).add_points(random_points(1))

        self.both(program)

    def test_hull_of_a_shape(self):
        angle = np.linspace(0, 2 * np.pi, 12, endpoint=False)
        points = np.concatenate(
            [np.c_[np.cos(angle), np.sin(angle) * 0.9, z + 0.1 * angle] for z in (0.0, 1.0)]
        )

        def program(Delaunay):
            tri = Delaunay(points)
            return sorted(np.unique(tri.convex_hull).tolist())

        self.assertEqual(*self.both(program))

    def test_interpolation_by_hand(self):
        points, places = random_points(300, 15), random_points(500, 16)
        values = np.sin(points).sum(axis=1)

        def program(Delaunay):
            tri = Delaunay(points)
            found = tri.find_simplex(places)
            transform = tri.transform[found]
            b = np.einsum("njk,nk->nj", transform[:, :3], places - transform[:, 3])
            weights = np.c_[b, 1 - b.sum(axis=1)]
            out = np.einsum("nj,nj->n", values[tri.simplices[found]], weights)
            out[found < 0] = np.nan
            return out

        ours, theirs = self.both(program)
        np.testing.assert_allclose(ours, theirs, atol=1e-10)
        expected = scipy.interpolate.LinearNDInterpolator(points, values)(places)
        np.testing.assert_allclose(mgdt.Delaunay(points).interpolate(values, places), expected)

    def test_code_that_catches_qhull_errors(self):
        self.assertTrue(issubclass(mgdt.QhullError, Exception))
        with self.assertRaises(scipy.spatial.QhullError):
            scipy.spatial.Delaunay([[0, 0, 0], [1, 0, 0], [0, 1, 0]])
        few = mgdt.Delaunay([[0, 0, 0], [1, 0, 0], [0, 1, 0]])
        self.assertEqual((few.nsimplex, few.dimension), (0, 2))


class ForScipy(unittest.TestCase):
    """`to_scipy`: an object of SciPy's class."""

    def test_a_triangulation_as_it_is(self):
        tri = mgdt.Delaunay(SETS["few"])
        for interpolator in (
            scipy.interpolate.LinearNDInterpolator,
            scipy.interpolate.CloughTocher2DInterpolator,
        ):
            with self.assertRaisesRegex(TypeError, "to_scipy"):
                interpolator(tri, np.zeros(5))
        with self.assertRaisesRegex(TypeError, "to_scipy"):
            np.asarray(tri)
        self.assertIs(np.array([tri, tri], dtype=object)[1], tri)

    def test_it_has_what_theirs_has(self):
        points = np.concatenate([random_points(40, 1), random_points(40, 1)[[3, 7]]])
        ours, theirs = mgdt.Delaunay(points).to_scipy(), scipy.spatial.Delaunay(points)
        self.assertIs(type(ours), scipy.spatial.Delaunay)
        self.assertEqual(set(vars(ours)), set(vars(theirs)))
        for name, value in vars(theirs).items():
            if value is not None:
                self.assertIs(type(getattr(ours, name)), type(value), name)
            if isinstance(value, np.ndarray):
                self.assertEqual(getattr(ours, name).dtype, value.dtype, name)
                self.assertEqual(getattr(ours, name).shape, value.shape, name)
                self.assertTrue(getattr(ours, name).flags.c_contiguous, name)
        self.assertEqual(row_set(ours.simplices), row_set(theirs.simplices))
        self.assertEqual(row_set(ours.convex_hull), row_set(theirs.convex_hull))
        self.assertEqual(ours.transform.shape, theirs.transform.shape)
        for a, b in zip(ours.vertex_neighbor_vertices, theirs.vertex_neighbor_vertices):
            self.assertEqual(a.shape, b.shape)
        places = random_points(300, 2)
        expected = theirs.find_simplex(places)
        inside = expected >= 0
        self.assertTrue(0 < inside.sum() < len(places))
        for by_force in (False, True):
            found = ours.find_simplex(places, bruteforce=by_force)
            np.testing.assert_array_equal(found >= 0, inside)
            np.testing.assert_array_equal(
                np.sort(ours.simplices[found[inside]]), np.sort(theirs.simplices[expected[inside]])
            )
        self.assertEqual(ours.plane_distance(places).shape, (300, ours.nsimplex))
        np.testing.assert_array_equal(pickle.loads(pickle.dumps(ours)).simplices, ours.simplices)
        with self.assertRaises(RuntimeError):
            ours.add_points(points)
        ours.close()

    def test_linear_interpolation(self):
        generator = np.random.default_rng(3)
        strided = np.asfortranarray(random_points(2000, 4))
        strided.flags.writeable = False
        sets = {
            "uniform": random_points(20_000, 1),
            "clustered": SETS["clustered"],
            "sphere": SETS["sphere"],
            "lattice": grid(9),
            "turned lattice": turned_grid(6),
            "repeated": np.concatenate([random_points(500, 2)] * 2),
            "in another layout": strided,
        }
        for name, points in sets.items():
            with self.subTest(name):
                tri = mgdt.Delaunay(points)
                given = tri.to_scipy()
                low, high = tri.min_bound, tri.max_bound
                places = low + (high - low) * generator.uniform(-0.05, 1.05, (1000, 3))
                size = np.abs(points).max()

                def field(x):
                    return x @ [[1, 0.5j], [-2, 1], [0.5, 3]] / size + [3, 1j]

                found = scipy.interpolate.LinearNDInterpolator(given, field(points))(places)
                outside = tri.find_simplex(places) < 0
                self.assertTrue(0 < outside.sum() < len(places))
                np.testing.assert_array_equal(np.isnan(found[:, 0]), outside)
                np.testing.assert_allclose(found[~outside], field(places[~outside]), atol=1e-10)
                if name not in ("lattice", "turned lattice"):
                    # There is one triangulation, so curved fields are the same too.
                    values = np.sin(3 * points / size).sum(axis=1)
                    values[tri.point_map] = values
                    theirs = scipy.interpolate.LinearNDInterpolator(points, values)(places)
                    found = scipy.interpolate.LinearNDInterpolator(given, values)(places)
                    np.testing.assert_allclose(found, theirs, atol=1e-10)

    def test_flat_points_are_refused(self):
        for points, words in (
            (np.zeros((0, 3)), "0 points have dimension -1"),
            ([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], "4 points have dimension 2"),
        ):
            with self.assertRaisesRegex(ValueError, words):
                mgdt.Delaunay(points).to_scipy()

    def test_it_stays_when_points_are_added(self):
        tri = mgdt.Delaunay(random_points(50, 1), incremental=True)
        given = tri.to_scipy()
        before = given.simplices.copy(), given.points.copy()
        tri.add_points(random_points(50, 2))
        tri.release()
        np.testing.assert_array_equal(given.simplices, before[0])
        np.testing.assert_array_equal(given.points, before[1])
        self.assertGreaterEqual(given.find_simplex(before[1].mean(axis=0)), 0)


if __name__ == "__main__":
    unittest.main()
