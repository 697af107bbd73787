# SPDX-License-Identifier: MIT
"""Points in any layout, without copies where that can be; arrays out that are the caller's."""

import gc
import unittest
from unittest import mock

import numpy as np
from support import grid, random_points, row_set

import mgdt
from mgdt import _arrays, _handle


def layouts(points):
    """The same points in arrays of other layouts, and whether they can go in without a copy."""
    n = len(points)
    wide = np.zeros((n, 5))
    wide[:, 1:4] = points
    records = np.zeros(n, dtype=[("name", "i8"), ("xyz", "f8", 3), ("mass", "f8")])
    records["xyz"] = points
    odd = np.zeros(n, dtype=[("name", "i4"), ("xyz", "f8", 3)])
    odd["xyz"] = points
    unaligned = np.zeros(24 * n + 1, dtype=np.uint8)[1:].view(np.float64).reshape(n, 3)
    unaligned[:] = points
    read_only = points.copy()
    read_only.flags.writeable = False
    yield "contiguous", points, True
    yield "columns one after the other", np.asfortranarray(points), True
    yield "part of wider rows", wide[:, 1:4], True
    yield "every second row", np.repeat(points, 2, axis=0)[::2], True
    yield "backwards", points[::-1].copy()[::-1], True
    yield "columns backwards", points[:, ::-1].copy()[:, ::-1], True
    yield "in records", records["xyz"], True
    yield "read-only", read_only, True
    yield "in odd records", odd["xyz"], False
    yield "unaligned", unaligned, False
    yield "other byte order", points.astype(">f8"), False
    yield "list", points.tolist(), False
    yield "objects", points.astype(object), False


class Input(unittest.TestCase):
    def test_layouts_give_the_same(self):
        points = random_points(500, 1)
        expected = mgdt.Delaunay(points)
        for name, array, _ in layouts(points):
            with self.subTest(name):
                tri = mgdt.Delaunay(array)
                np.testing.assert_array_equal(tri.simplices, expected.simplices)
                np.testing.assert_array_equal(tri.points, points)
                tri.check()
                grown = mgdt.Delaunay(array[:100], incremental=True)
                grown.add_points(array[100:])
                self.assertEqual(row_set(grown.simplices), row_set(expected.simplices))
                np.testing.assert_array_equal(grown.points, points)

    def test_nothing_is_copied_on_the_way(self):
        points = random_points(500, 2)
        for name, array, is_direct in layouts(points):
            with self.subTest(name):
                addresses = []
                real = _handle.address

                def spy(array, column=0):
                    addresses.append(real(array, column))
                    return addresses[-1]

                with mock.patch.object(_handle, "address", spy):
                    mgdt.Delaunay(array)
                if is_direct:
                    self.assertEqual(addresses[0], array.ctypes.data)
                elif isinstance(array, np.ndarray):
                    self.assertNotEqual(addresses[0], array.ctypes.data)

    def test_the_array_is_kept_or_copied(self):
        points = random_points(50, 3)
        self.assertIs(mgdt.Delaunay(points).points, points)
        buffer = points.copy()
        tri = mgdt.Delaunay(buffer, incremental=True)
        buffer[:] = random_points(50, 4)
        tri.add_points(buffer)
        buffer[:] = 0
        np.testing.assert_array_equal(tri.points, np.concatenate([points, random_points(50, 4)]))

    def test_input_is_not_changed(self):
        points = random_points(100, 5)
        before = points.copy()
        tri = mgdt.Delaunay(points, incremental=True)
        tri.add_points(points)
        tri.locate(points)
        np.testing.assert_array_equal(points, before)

    def test_other_numbers(self):
        points = grid(4)
        expected = row_set(mgdt.Delaunay(points).simplices)
        for kind in (np.float32, np.float16, np.int8, np.uint64, np.longdouble):
            self.assertEqual(row_set(mgdt.Delaunay(points.astype(kind)).simplices), expected)
        self.assertEqual(mgdt.Delaunay(np.zeros((4, 3), dtype=bool)).dimension, 0)

    def test_long_chain_of_rounds_keeps_points(self):
        store = _arrays.PointStore(copies=True)
        views = []
        for k in range(200):
            store.append(np.full((k % 7, 3), float(k)))
            views.append((store.all, store.all.copy()))
        for view, copy in views:
            np.testing.assert_array_equal(view, copy)
        self.assertEqual(len(store.all), sum(k % 7 for k in range(200)))


class FewPoints(unittest.TestCase):
    """Sets without tetrahedra are valid; SciPy refuses them."""

    def empty_of(self, tri, dimension):
        tri.check()
        self.assertEqual((tri.nsimplex, tri.dimension), (0, dimension))
        self.assertEqual(tri.simplices.shape, (0, 4))
        self.assertEqual(tri.neighbors.shape, (0, 4))
        self.assertEqual(tri.convex_hull.shape, (0, 3))
        self.assertEqual(tri.edges.shape, (0, 2))
        self.assertEqual(tri.transform.shape, (0, 4, 3))
        self.assertEqual(tri.equations.shape, (0, 5))
        self.assertEqual(tri.vertex_to_simplex.tolist(), [-1] * tri.npoints)
        self.assertEqual(tri.gabriel_edges.shape, (0, 2))
        self.assertEqual(tri.spanning_tree.shape, (0, 2))
        self.assertEqual(tri.circumcenters.shape, (0, 3))
        self.assertEqual(tri.circumradii.shape, (0,))
        starts, ends = tri.vertex_neighbor_vertices
        self.assertEqual((starts.tolist(), ends.tolist()), ([0] * (tri.npoints + 1), []))
        self.assertEqual(tri.find_simplex([[0, 0, 0], [1, 1, 1]]).tolist(), [-1, -1])
        self.assertEqual(tri.find_simplex([0, 0, 0], tol=1).tolist(), -1)
        self.assertEqual(tri.plane_distance([0, 0, 0]).shape, (0,))
        # As in C: it is not that the place is outside.
        if dimension >= 0:
            with self.assertRaisesRegex(mgdt.ArgumentError, "there are no values between points: all"):
                tri.interpolate(np.ones(tri.npoints), [[0, 0, 0]], fill_value=-7)
        at = tri.interpolator([[0, 0, 0]])
        self.assertEqual(at(np.ones(tri.npoints), fill_value=-7).tolist(), [-7])

    def test_each_dimension(self):
        sets = {
            -1: np.zeros((0, 3)),
            0: [[1, 2, 3]],
            1: [[0, 0, 0], [1, 1, 1], [2, 2, 2]],
            2: [[x, y, x + y] for x in range(3) for y in range(3)],
        }
        for dimension, points in sets.items():
            with self.subTest(dimension):
                self.empty_of(mgdt.Delaunay(points), dimension)
                tri = mgdt.Delaunay(points, incremental=True)
                self.empty_of(tri, dimension)
                tri.add_points(random_points(20, 6))
                tri.check()
                self.assertEqual(tri.dimension, 3)
                together = mgdt.Delaunay(tri.points)
                self.assertEqual(row_set(tri.simplices), row_set(together.simplices))

    def test_bounds(self):
        tri = mgdt.Delaunay(np.zeros((0, 3)))
        self.assertEqual(tri.min_bound.tolist(), [np.inf] * 3)
        self.assertEqual(tri.max_bound.tolist(), [-np.inf] * 3)
        self.assertEqual(tri.nearest_vertex([0, 0, 0]), -1)

    def test_duplicates_in_a_plane(self):
        tri = mgdt.Delaunay([[0, 0, 0], [1, 0, 0], [0, 0, 0], [0, 1, 0], [1, 0, -0.0]])
        self.assertEqual(tri.coplanar.tolist(), [[2, -1, 0], [4, -1, 1]])
        self.assertEqual(tri.nearest_vertex([[0.9, 0, 0], [0, 0.9, 5]]).tolist(), [1, 3])


class Output(unittest.TestCase):
    NAMES = (
        "simplices neighbors convex_hull edges point_map vertex_to_simplex coplanar transform "
        "equations"
    ).split()

    def test_arrays_outlive_the_object(self):
        points = np.concatenate([random_points(3000, 7), random_points(3, 7)])
        tri = mgdt.Delaunay(points)
        arrays = {name: getattr(tri, name) for name in self.NAMES}
        copies = {name: array.copy() for name, array in arrays.items()}
        located = tri.locate(points)
        located_copy = [array.copy() for array in located]
        del tri
        gc.collect()
        for _ in range(20):
            mgdt.Delaunay(random_points(3000, 8))
        for name in self.NAMES:
            np.testing.assert_array_equal(arrays[name], copies[name])
        for array, copy in zip(located, located_copy):
            np.testing.assert_array_equal(array, copy)

    def test_arrays_are_made_once_and_belong_to_the_caller(self):
        tri = mgdt.Delaunay(random_points(100, 9), incremental=True)
        before = {name: getattr(tri, name) for name in self.NAMES}
        for name, array in before.items():
            self.assertIs(getattr(tri, name), array)
            self.assertTrue(array.flags.writeable and array.flags.c_contiguous)
        old = tri.simplices.copy()
        tri.add_points(random_points(100, 10))
        np.testing.assert_array_equal(before["simplices"], old)
        for name, array in before.items():
            self.assertIsNot(getattr(tri, name), array, name)

    def test_edges(self):
        tri = mgdt.Delaunay(grid(5))
        pairs = [(i, j) for i in range(4) for j in range(i)]
        expected = row_set(np.concatenate([tri.simplices[:, pair] for pair in pairs]))
        self.assertEqual(len(tri.edges), len(expected))
        self.assertEqual(row_set(tri.edges), expected)
        self.assertTrue((tri.edges[:, 0] < tri.edges[:, 1]).all())

    def test_circumspheres(self):
        tri = mgdt.Delaunay(random_points(300))
        corners = tri.points[tri.simplices]
        distances = np.linalg.norm(corners - tri.circumcenters[:, np.newaxis], axis=2)
        self.assertEqual(tri.circumcenters.shape, (tri.nsimplex, 3))
        np.testing.assert_allclose(distances, np.tile(tri.circumradii, (4, 1)).T, rtol=1e-6)
        cubes = mgdt.Delaunay(grid(4))
        self.assertEqual(len(np.unique(cubes.circumcenters, axis=0)), 27)
        self.assertEqual(len(np.unique(cubes.circumradii)), 1)

    def test_tetrahedron_measures(self):
        tri = mgdt.Delaunay(random_points(300))
        corners = tri.points[tri.simplices]
        edges = corners[:, 1:] - corners[:, :1]
        volumes = np.abs(np.linalg.det(edges)) / 6
        np.testing.assert_allclose(tri.tetrahedron_measures("volume"), volumes, rtol=1e-6)
        spans = np.linalg.norm(corners[:, :, np.newaxis] - corners[:, np.newaxis], axis=3)
        np.testing.assert_allclose(tri.tetrahedron_measures("longest_edge"), spans.max(axis=(1, 2)), rtol=1e-12)
        first, second = np.triu_indices(4, 1)
        lengths = spans[:, first, second]
        np.testing.assert_allclose(tri.tetrahedron_measures("edge_ratio"),
                                   lengths.max(axis=1) / lengths.min(axis=1), rtol=1e-12)
        means = np.sqrt((lengths**2).mean(axis=1))
        np.testing.assert_allclose(tri.tetrahedron_measures("volume_length"), 6 * np.sqrt(2) * volumes / means**3, rtol=1e-6)
        ratios = tri.tetrahedron_measures("radius_ratio")
        self.assertTrue(((ratios > 0) & (ratios < 1)).all())
        least, largest = (tri.tetrahedron_measures(m) for m in ("least_dihedral_angle", "largest_dihedral_angle"))
        self.assertTrue(((0 < least) & (least < largest) & (largest < np.pi)).all())
        with self.assertRaisesRegex(ValueError, "there is no measure 'size'; there are volume, radius_ratio"):
            tri.tetrahedron_measures("size")

    def test_flat_ones_are_peeled(self):
        """A turned block has flat tetrahedra on its skin; the volume stays."""
        turn = np.array([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]]) @ np.array([[1, 0, 0], [0, 0.28, -0.96], [0, 0.96, 0.28]])
        tri = mgdt.Delaunay(grid(6) @ turn.T)
        stays = tri.peel_flat()
        volumes = tri.tetrahedron_measures("volume")
        self.assertGreater(np.count_nonzero(~stays), 10)
        bare = (~stays[tri.neighbors] | (tri.neighbors < 0)).any(axis=1) & stays
        self.assertGreater(tri.tetrahedron_measures("radius_ratio")[bare].min(), 0.1)
        self.assertAlmostEqual(volumes[stays].sum(), 125, delta=1e-9)
        # Without flat tetrahedra all stay.
        self.assertTrue(mgdt.Delaunay(grid(4)).peel_flat().all())
        self.assertTrue(mgdt.Delaunay(random_points(100)).peel_flat(0).all())
        # What is flat inside stays.
        inner = mgdt.Delaunay(random_points(300))
        exposed = (inner.neighbors < 0).any(axis=1)
        stays = inner.peel_flat(0.05)
        flat = inner.tetrahedron_measures("radius_ratio") < 0.05
        self.assertFalse((stays & flat & exposed).any())
        self.assertTrue((stays & flat).any())

    def test_alphas(self):
        tri = mgdt.Delaunay(random_points(300))
        squares = tri.squared_alphas(3)
        np.testing.assert_array_equal(np.sqrt(squares), tri.circumradii)
        self.assertTrue((tri.squared_alphas(2) <= squares[:, np.newaxis]).all())
        self.assertEqual(tri.squared_alphas(1).shape, (len(tri.edges),))
        self.assertEqual(tri.squared_alphas(0).tolist(), [0] * 300)
        self.assertEqual(tri.alpha_surface(1e9).shape, tri.convex_hull.shape)
        self.assertEqual(tri.alpha_surface(0).shape, (0, 3))
        solid = mgdt.AlphaShape(tri)
        self.assertEqual(set(solid.simplices.ravel()), set(range(300)))
        self.assertAlmostEqual(solid.alpha**2, tri.squared_solid_alpha)
        hull = mgdt.AlphaShape(tri.points, 1e9)
        self.assertEqual(len(hull.simplices), tri.nsimplex)
        self.assertGreater(hull.volume, solid.volume)
        self.assertGreater(solid.area, hull.area)
        self.assertIn("AlphaShape", repr(hull))
        # The volume inside a closed surface.
        a, b, c = np.moveaxis(solid.points[solid.facets], 1, 0)
        self.assertAlmostEqual(np.einsum("ij,ij->", a, np.cross(b, c)) / 6, solid.volume)
        for wrong in (-1, np.nan):
            with self.assertRaisesRegex(ValueError, "at least 0"):
                mgdt.AlphaShape(tri, wrong)
            with self.assertRaisesRegex(ValueError, "at least 0"):
                tri.alpha_surface(wrong)

    def test_cell_measures(self):
        points = random_points(300)
        low, high = points.min(axis=0) - 0.25, points.max(axis=0) + 0.5
        box = np.concatenate(
            [np.column_stack([np.eye(3), high]), np.column_stack([-np.eye(3), -low])]
        )
        tri = mgdt.Delaunay(np.concatenate([points, points[:2]]))
        volumes = tri.cell_measures("volume", box)
        self.assertAlmostEqual(volumes.sum(), np.prod(high - low), delta=1e-12)
        self.assertEqual(volumes[300:].tolist(), [0, 0])
        centroids = tri.cell_measures("centroid", box)
        np.testing.assert_allclose(
            volumes @ centroids, (low + high) / 2 * np.prod(high - low), rtol=1e-12
        )
        # Nothing but the number of faces is finite where a cell has no end.
        open_ones = np.isinf(tri.cell_measures("volume"))
        self.assertEqual(
            np.flatnonzero(open_ones).tolist(), np.unique(tri.convex_hull).tolist()
        )
        self.assertEqual(np.isinf(tri.cell_measures("area")).tolist(), open_ones.tolist())
        self.assertTrue(np.isfinite(tri.cell_measures("faces")).all())
        self.assertEqual(mgdt.Delaunay(grid(5)).cell_measures("faces")[62], 6)
        for planes, message in (
            (box[:5], "plane 5 has no end|do not bound"),
            (box[:, :3], "shape"),
            (box - [0, 0, 0, 1], "is beyond plane"),
        ):
            with self.assertRaisesRegex(ValueError, message):
                tri.cell_measures("volume", planes)
        with self.assertRaisesRegex(ValueError, "there is no measure"):
            tri.cell_measures("mass")

    def test_neighbors_of_vertices(self):
        tri = mgdt.Delaunay(np.concatenate([random_points(200), random_points(200)[:3]]))
        starts, ends = tri.vertex_neighbor_vertices
        self.assertEqual((starts.dtype, ends.dtype), (np.int32, np.int32))
        expected = [set() for _ in range(tri.npoints)]
        for a, b in tri.edges.tolist():
            expected[a].add(b)
            expected[b].add(a)
        for k, of_point in enumerate(expected):
            self.assertEqual(ends[starts[k] : starts[k + 1]].tolist(), sorted(of_point))

    def test_graphs(self):
        tri = mgdt.Delaunay(random_points(200))
        edges = set(map(tuple, tri.edges.tolist()))
        gabriel = set(map(tuple, tri.gabriel_edges.tolist()))
        tree = set(map(tuple, tri.spanning_tree.tolist()))
        self.assertEqual(len(tree), 199)
        self.assertTrue(tree < gabriel < edges)
        a, b = tri.points[tri.edges[:, 0]], tri.points[tri.edges[:, 1]]
        distances = np.linalg.norm((a + b)[:, np.newaxis] / 2 - tri.points, axis=2)
        alone = distances.min(axis=1) >= np.linalg.norm(a - b, axis=1) / 2 * (1 - 1e-12)
        self.assertEqual(set(map(tuple, tri.edges[alone].tolist())), gabriel)

    def test_canonical_output_is_a_function_of_the_points(self):
        points = random_points(400, 11)
        one = mgdt.Delaunay(points, canonical=True)
        two = mgdt.Delaunay(points[:10], incremental=True, canonical=True, order="random", seed=9)
        two.add_points(points[10:])
        for name in self.NAMES:
            np.testing.assert_array_equal(getattr(one, name), getattr(two, name))
        self.assertTrue((one.simplices[:, 0] == one.simplices.min(axis=1)).all())
        self.assertTrue((np.diff(one.simplices[:, 0]) >= 0).all())
        two.check()


if __name__ == "__main__":
    unittest.main()
