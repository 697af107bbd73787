# SPDX-License-Identifier: MIT
"""The same programs with scipy.spatial.Delaunay and with mgdt.Delaunay."""

import unittest

import numpy as np
import scipy.interpolate
import scipy.spatial
from support import matching, random_points, row_set

import mgdt

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

    def test_transform_of_a_flat_simplex_is_not_a_number(self):
        points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 1e-14]])
        # SciPy's Qhull gives no simplex at all here; ours is there, exact and too flat to invert.
        flat = mgdt.Delaunay(points)
        self.assertEqual(flat.transform.shape, (1, 4, 3))
        self.assertTrue(np.isnan(flat.transform).all())
        self.assertEqual(flat.find_simplex([0.5, 0.5, 2e-15]), 0)

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
        self.assertEqual(tri.vertex_to_simplex[40:].tolist(), [-1, -1, -1])
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


if __name__ == "__main__":
    unittest.main()
