# SPDX-License-Identifier: MIT
"""The Voronoi diagram: beside SciPy's, and cells of lattices."""

import doctest
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


class Arguments(unittest.TestCase):
    """Those of SciPy, in its order; what is not possible says so."""

    def test_as_scipys(self):
        points = random_points(30)
        for given in ((points, False, True, "Qc"), (points, False, False, None)):
            ours, theirs = mgdt.Voronoi(*given), scipy.spatial.Voronoi(*given)
            self.assertEqual(len(ours.vertices), len(theirs.vertices))
        for error, words, given, named in (
            (ValueError, "furthest-site", (True,), {}),
            (TypeError, "furthest_site must be a bool, not list; give planes", ([[1, 0, 0, 1]],), {}),
            (TypeError, "furthest_site must be a bool, not ndarray", (np.zeros((1, 4)),), {}),
            (ValueError, "Qu", (False, False, "Qu"), {}),
            (TypeError, "unexpected keyword argument", (), {"box": 1}),
            (ValueError, "planes must have the shape", (), {"planes": [1, 2, 3]}),
            (ValueError, "plane", (), {"planes": [[0, 0, 0, 1]]}),
            (ValueError, "plane|finite", (), {"planes": [[1, 0, np.nan, 1]]}),
            (ValueError, "plane", (), {"planes": [[1, 0, 0, 0.5]]}),
            (ValueError, "bounds must be", (), {"bounds": [[0, 0, 0], [1, 1, 0]]}),
            (ValueError, "bounds must be", (), {"bounds": [0, 1]}),
        ):
            with self.subTest(given=given, named=named), self.assertRaisesRegex(error, words):
                mgdt.Voronoi(points, *given, **named)
        for named in ({"incremental": True}, {"qhull_options": "Qbb"}, {"threads": 2}):
            with self.subTest(named=named), self.assertRaisesRegex(TypeError, "has its settings already"):
                mgdt.Voronoi(mgdt.Delaunay(points), **named)
        with self.assertRaisesRegex(TypeError, "alpha is 'auto'; it must be a number"):
            mgdt.AlphaShape(points, "auto")
        with self.assertRaisesRegex(ValueError, "alpha is -1.5; it must be at least 0"):
            mgdt.Delaunay(points).alpha_surface(-1.5)

    def test_bounds(self):
        points = np.random.default_rng(3).random((40, 3))
        planes = [[-1, 0, 0, 1], [0, -1, 0, 2], [0, 0, -1, 3], [1, 0, 0, 4], [0, 1, 0, 5], [0, 0, 1, 6]]
        expected = mgdt.Voronoi(points, planes=planes).volumes
        np.testing.assert_array_equal(mgdt.Voronoi(points, bounds=[[-1, -2, -3], [4, 5, 6]]).volumes, expected)
        cut = mgdt.Voronoi(points, bounds=[[-1, -2, -3], [9, 5, 6]], planes=[[1, 0, 0, 4]])
        np.testing.assert_allclose(cut.volumes, expected, rtol=1e-12)
        self.assertAlmostEqual(expected.sum(), 5 * 7 * 9)

    def test_growing(self):
        points = np.random.default_rng(4).random((60, 3))
        diagram = mgdt.Voronoi(points[:40], incremental=True, bounds=[[0, 0, 0], [1, 1, 1]])
        before = diagram.volumes, diagram.regions, diagram.ridge_dict
        self.assertEqual(diagram.volumes.shape, (40,))
        diagram.add_points(points[40:])
        expected = mgdt.Voronoi(points, bounds=[[0, 0, 0], [1, 1, 1]])
        np.testing.assert_array_equal(diagram.points, points)
        np.testing.assert_array_equal(diagram.volumes, expected.volumes)
        self.assertEqual(faces(diagram), faces(expected))
        self.assertEqual(len(diagram.regions), 60)
        self.assertEqual((before[0].shape, len(before[1])), ((40,), 40))
        diagram.close()
        with self.assertRaises(RuntimeError):
            diagram.add_points(points[:1])
        np.testing.assert_array_equal(diagram.volumes, expected.volumes)
        with self.assertRaises(RuntimeError):
            mgdt.Voronoi(points).add_points(points[:1])
        with self.assertRaisesRegex(TypeError, "made of a Delaunay object"):
            mgdt.Voronoi(mgdt.Delaunay(points, incremental=True)).add_points(points[:1])

    def test_what_they_say_of_themselves(self):
        points = random_points(30)
        values = points[:, 0]
        for made, words in (
            (mgdt.Delaunay(points), "<mgdt.Delaunay: 30 points"),
            (mgdt.Voronoi(points), "<mgdt.Voronoi: 30 points"),
            (mgdt.AlphaShape(points), "<mgdt.AlphaShape: alpha"),
            (mgdt.LinearNDInterpolator(points, values), "<mgdt.LinearNDInterpolator: 30 points, values of shape (30,)>"),
            (mgdt.NearestNDInterpolator(points, values), "<mgdt.NearestNDInterpolator: 30 points"),
            (mgdt.NaturalNeighborInterpolator(points, values), "<mgdt.NaturalNeighborInterpolator: 30 points"),
            (mgdt.Delaunay(points).interpolator(points[:4]), "<mgdt.Interpolator: 30 points, places of shape (4,)>"),
        ):
            self.assertIn(words, repr(made))
            self.assertIn(">>> ", type(made).__doc__)

    def test_examples(self):
        for module in (mgdt.alpha, mgdt.delaunay, mgdt.interpolation, mgdt.scattered, mgdt.voronoi):
            result = doctest.testmod(module)
            self.assertEqual(result.failed, 0, module)
            self.assertGreater(result.attempted, 0, module)


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
        self.assertEqual(diagram.point_region[100:].tolist(), diagram.point_region[:3].tolist())
        self.assertAlmostEqual(diagram.volumes.sum(), 27, delta=1e-12)
        self.assertEqual(diagram.areas.shape, (103,))
        self.assertEqual(diagram.centroids.shape, (103, 3))
        self.assertIn("103 points", repr(diagram))
        tri = mgdt.Delaunay(points)
        self.assertIs(mgdt.Voronoi(tri).delaunay, tri)

    def test_clipped_faces(self):
        diagram = mgdt.Voronoi(grid(3), bounds=[[-0.5] * 3, [2.5] * 3])
        self.assertEqual(len(diagram.vertices), 64)
        self.assertEqual(len(diagram.ridge_points), 108)
        np.testing.assert_array_equal(diagram.ridge_areas, np.ones(108))
        np.testing.assert_array_equal(diagram.volumes, np.ones(27))
        np.testing.assert_array_equal(np.unique(diagram.ridge_points[:, 1])[:6], np.arange(-6, 0))
        np.testing.assert_array_equal(diagram.ridge_rays, np.full((108, 2), -1))
        self.assertEqual(len(diagram.ray_vertices), 0)
        middle = grid(3).tolist().index([1, 1, 1])
        self.assertEqual(len(diagram.neighbors[middle]), 6)
        self.assertEqual(sum(k < 0 for k in diagram.neighbors[0]), 3)
        # Planes 0 to 2 have the least coordinates.
        of_plane = diagram.ridge_normals[diagram.ridge_points[:, 1] == -1]
        np.testing.assert_array_equal(of_plane, np.tile([-1, 0, 0], (9, 1)))
        # The divergence theorem.
        flux = np.einsum("ij,ij->i", diagram.ridge_centroids, diagram.ridge_normals)
        volumes = np.zeros(27)
        np.add.at(volumes, diagram.ridge_points[:, 0], flux * diagram.ridge_areas / 3)
        inner = diagram.ridge_points[:, 1] >= 0
        np.add.at(volumes, diagram.ridge_points[inner, 1], -(flux * diagram.ridge_areas / 3)[inner])
        np.testing.assert_allclose(volumes, 1, rtol=1e-14)

    def test_neighbor_lists(self):
        points = np.random.default_rng(5).uniform(0.1, 1, (60, 3))
        cells = mgdt.Voronoi(points, bounds=[[0, 0, 0], [1, 1.5, 1]], planes=[[3, 4, 0, 8]])
        near = cells.neighbor_list
        self.assertIs(cells.neighbor_list, near)
        where = np.repeat(np.arange(60), np.diff(near.indptr))
        self.assertEqual(near.neighbors.tolist(), sum(cells.neighbors, []))
        self.assertFalse(near.shifts.any())
        planes = near.neighbors < 0
        self.assertEqual(set(near.neighbors[planes]), set(range(-7, 0)))
        apart = np.linalg.norm(points[near.neighbors] - points[where], axis=1)
        self.assertTrue(np.allclose(near.distances[~planes], apart[~planes], rtol=1e-13))
        oblique = near.neighbors == -1
        heights = (8 - points[where[oblique]] @ [3, 4, 0]) / 5
        self.assertTrue(np.allclose(near.distances[oblique], heights, rtol=1e-13))
        # The pyramids over the faces, whose bases are half way to a point.
        weights = near.areas * near.distances * np.where(planes, 2, 1)
        self.assertTrue(np.allclose(np.bincount(where, weights) / 6, cells.volumes, rtol=1e-11))

    def test_rays(self):
        diagram = mgdt.Voronoi(np.vstack([np.zeros(3), np.eye(3)]))
        self.assertEqual(diagram.ridge_vertices, [[-1, 0]] * 6)
        self.assertEqual(diagram.regions, [[-1, 0]] * 4)
        self.assertEqual(sorted(diagram.ridge_rays.ravel().tolist()), sorted([0, 1, 2, 3] * 3))
        np.testing.assert_array_equal(diagram.ray_vertices, np.zeros(4))
        np.testing.assert_allclose(np.linalg.norm(diagram.ray_directions, axis=1), 1)
        self.assertTrue(np.isinf(diagram.ridge_areas).all())

    def test_small_faces_are_left_out(self):
        turn = np.array([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]])
        points = (grid(5) - 2) @ turn.T + [0.1, 0.2, 0]
        box = [[-9] * 3, [9] * 3]
        middle = grid(5).tolist().index([2, 2, 2])
        whole = mgdt.Voronoi(points, bounds=box)
        self.assertGreater(len(whole.neighbors[middle]), 6)
        for named in ({"least_share": 1e-9}, {"least_area": 1e-9}):
            diagram = mgdt.Voronoi(points, bounds=box, **named)
            self.assertEqual(len(diagram.neighbors[middle]), 6)
            np.testing.assert_array_equal(diagram.volumes, whole.volumes)
        for named in ({"least_share": 1}, {"least_area": -1}, {"least_area": np.nan}):
            with self.subTest(named=named), self.assertRaisesRegex(ValueError, "must be at least 0"):
                mgdt.Voronoi(points, **named)

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



def spoiled(points):
    """A triangulation whose arrays the user has sorted."""
    triangulation = mgdt.Delaunay(points)
    for array in (
        triangulation.simplices,
        triangulation.neighbors,
        triangulation.convex_hull,
        triangulation.point_map,
        triangulation.circumcenters,
    ):
        array.sort(axis=0)
        array[...] = array[::-1]
    return triangulation


class FlatSets(unittest.TestCase):
    """Points that do not span space have cells within bounds: those of the middle of three equal layers
    at a distance, between the planes half-way to the others."""

    def test_beside_layers(self):
        rng = np.random.default_rng(3)
        plane, line = rng.random((30, 3)) * [1, 1, 0], rng.random((9, 3)) * [1, 0, 0]
        grid = np.array([(i, j, 0) for i in range(4) for j in range(4)]) / 3
        for points, axes in ((plane, [2]), (grid, [2]), (line, [1, 2]), (np.zeros((1, 3)), [0, 1, 2]),
                             (np.concatenate([plane, plane[3:5]]), [2])):
            low, high = points.min(0) - 0.25, points.max(0) + 0.5
            layers = [np.zeros(3)]
            for axis in axes:
                low[axis], high[axis] = -1.0, 1.0
                step = 2 * np.eye(3)[axis]
                layers = [at + k * step for k in (0, -1, 1) for at in layers]
            copies = np.concatenate([points + at for at in layers])
            wide = [low - 3 * np.isin(range(3), axes), high + 3 * np.isin(range(3), axes)]
            expected = mgdt.Voronoi(copies, bounds=wide)
            cells = mgdt.Voronoi(points, bounds=(low, high))
            n = len(points)
            self.assertEqual((len(cells.volumes), cells.points.shape), (n, (n, 3)))
            np.testing.assert_allclose(cells.volumes, expected.volumes[:n], rtol=1e-11)
            np.testing.assert_allclose(cells.areas, expected.areas[:n], rtol=1e-11)
            np.testing.assert_allclose(cells.centroids, expected.centroids[:n], atol=1e-11)
            self.assertEqual([len(of) for of in cells.neighbors], [len(of) for of in expected.neighbors[:n]])
            self.assertLess(cells.ridge_points.max(), n)
            np.testing.assert_allclose(cells.volumes.sum(), np.prod(high - low), rtol=1e-12)
            triangulation = mgdt.Delaunay(points)
            planes = [[*(s * np.eye(3)[k]), s * (high, low)[s < 0][k]] for k in range(3) for s in (1, -1)]
            for measure, of in (("volume", cells.volumes), ("area", cells.areas), ("centroid", cells.centroids)):
                np.testing.assert_allclose(triangulation.cell_measures(measure, planes), of, rtol=1e-11, atol=1e-12)
            counts = triangulation.cell_measures("faces", planes)
            self.assertEqual(counts.tolist(), [len(of) for of in cells.neighbors])

    def test_what_is_refused(self):
        flat = np.random.default_rng(3).random((9, 3)) * [1, 1, 0]
        with self.assertRaises(mgdt.QhullError):
            mgdt.Voronoi(flat)
        with self.assertRaises(mgdt.ArgumentError):
            mgdt.Delaunay(flat).cell_measures("volume")
        for bounds, says in (([0, 0, 0.5], [1, 1, 1]), "point 0 is beyond plane"), (
                ([-1e308] * 3, [1e308] * 3), "too large for doubles"):
            with self.assertRaisesRegex(mgdt.ArgumentError, says):
                mgdt.Voronoi(flat, bounds=bounds)


class ArraysOfTheUser(unittest.TestCase):
    """Nothing but the user reads the arrays that attributes have given."""

    def setUp(self):
        self.points = np.concatenate([random_points(100), random_points(3)])
        self.mean = self.points[:100].mean(axis=0)

    def test_diagrams_and_shapes(self):
        ours, theirs = mgdt.Voronoi(spoiled(self.points)), mgdt.Voronoi(self.points)
        for name in ("vertices", "ridge_points", "ridge_list", "point_region", "volumes"):
            np.testing.assert_array_equal(getattr(ours, name), getattr(theirs, name), name)
        self.assertEqual(ours.regions, theirs.regions)
        shape, expected = mgdt.AlphaShape(spoiled(self.points)), mgdt.AlphaShape(self.points)
        np.testing.assert_array_equal(shape.simplices, expected.simplices)
        self.assertEqual(shape.volume, expected.volume)

    def test_what_follows_from_others(self):
        ours, theirs = spoiled(self.points), mgdt.Delaunay(self.points)
        for name in ("coplanar", "vertex_to_simplex", "transform", "equations", "circumradii",
                     "min_bound"):
            np.testing.assert_array_equal(getattr(ours, name), getattr(theirs, name), name)
        values = self.points[:, 0]
        self.assertEqual(
            ours.interpolator(self.mean)(values), theirs.interpolator(self.mean)(values)
        )
        outside = theirs.max_bound + 1e-9
        self.assertEqual(
            ours.find_simplex(outside, tol=0.5), theirs.find_simplex(outside, tol=0.5)
        )


class Snapshots(unittest.TestCase):
    """A diagram and a shape stay what they were, whatever the triangulation does next."""

    def changes(self):
        yield lambda t: t.move_points(random_points(60) + 1)
        yield lambda t: t.remove_points(np.arange(0, 60, 2))
        yield lambda t: t.add_points(random_points(30) + 0.25)

        def renumber(t):
            t.remove_points([0, 7])
            t.renumber_points()

        yield renumber

    def test_whatever_the_triangulation_does_next(self):
        points = random_points(60)
        expected = mgdt.Voronoi(np.delete(points, 5, axis=0))
        solid = mgdt.AlphaShape(np.delete(points, 5, axis=0))
        others = np.delete(np.arange(60), 5)
        for change in self.changes():
            triangulation = mgdt.Delaunay(points, incremental=True)
            triangulation.remove_points([5])
            diagram, shape = mgdt.Voronoi(triangulation), mgdt.AlphaShape(triangulation)
            change(triangulation)
            for name in ("volumes", "areas", "centroids"):
                np.testing.assert_array_equal(
                    getattr(diagram, name)[others], getattr(expected, name)
                )
            self.assertEqual(diagram.volumes[5], 0)
            self.assertEqual(diagram.point_region[5], -1)
            self.assertEqual(len(diagram.regions), 59)
            np.testing.assert_array_equal(np.sort(diagram.vertices, axis=0),
                                          np.sort(expected.vertices, axis=0))
            self.assertAlmostEqual(shape.volume, solid.volume, delta=1e-12 * solid.volume)
            self.assertEqual(len(shape.points), 60)

    def test_points_given_twice_have_the_region_of_their_twins(self):
        points = random_points(20)
        diagram = mgdt.Voronoi(np.concatenate([points, points[3:5]]))
        np.testing.assert_array_equal(diagram.point_region[20:], diagram.point_region[3:5])

    def test_planes_stay_what_they_were(self):
        points = random_points(50)
        planes = np.array([[s if j == k else 0.0 for j in range(3)] + [1000.0]
                           for k in range(3) for s in (1, -1)])
        diagram, expected = mgdt.Voronoi(points, planes=planes), mgdt.Voronoi(points, planes=planes.copy())
        volumes = expected.volumes
        planes[:, 3] = 2000
        np.testing.assert_array_equal(diagram.volumes, volumes)

    def test_points_and_released_triangulations(self):
        points = random_points(50)
        shape, volume = mgdt.AlphaShape(points), mgdt.AlphaShape(points).volume
        points += 1
        self.assertEqual(shape.volume, volume)
        shape = mgdt.AlphaShape(points, 1e200)
        self.assertEqual(len(shape.simplices), shape.delaunay.nsimplex)
        diagram = mgdt.Voronoi(points)
        areas = mgdt.Voronoi(points).areas
        diagram.delaunay.release()
        np.testing.assert_array_equal(diagram.areas, areas)

    def test_what_takes_long_is_computed_once(self):
        diagram, shape = mgdt.Voronoi(random_points(50)), mgdt.AlphaShape(random_points(50))
        for of, names in (
            (diagram, ("regions", "ridge_vertices", "ridge_dict", "volumes", "areas", "centroids")),
            (shape, ("volume", "area")),
        ):
            for name in names:
                self.assertIs(getattr(of, name), getattr(of, name), name)

    def test_settings_of_a_triangulation_are_not_ignored(self):
        triangulation = mgdt.Delaunay(random_points(10))
        for make in (mgdt.Voronoi, mgdt.AlphaShape):
            with self.assertRaisesRegex(TypeError, "threads"):
                make(triangulation, threads=2)


if __name__ == "__main__":
    unittest.main()
