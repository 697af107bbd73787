# SPDX-License-Identifier: MIT
"""Points in periodic boxes."""

import copy
import doctest
import threading
import unittest
from typing import Any

import numpy as np

import mgdt
import mgdt.periodic

OBLIQUE = np.array([[4, 0, 0], [1.5, 3, 0], [-0.75, 0.5, 2.5]])


def random_points(n: int, box: Any, seed: int = 1) -> Any:
    return np.random.default_rng(seed).uniform(-1, 2, (n, len(box))) @ np.asarray(box)


def volumes(places: Any) -> Any:
    return np.linalg.det(places[:, 1:] - places[:, :1]) / 6


class PeriodicDelaunay(unittest.TestCase):
    def test_fills_the_box(self) -> None:
        for box in (OBLIQUE, OBLIQUE.tolist(), [4, 3, 2.5], (4.0, 3.0, 2.5)):
            mesh = mgdt.PeriodicDelaunay(random_points(100, OBLIQUE), box)
            mesh.check()
            size = volumes(mesh.places())
            self.assertTrue((size > 0).all())
            self.assertAlmostEqual(size.sum(), 30, places=10)
            self.assertAlmostEqual(mesh.volumes.sum(), 30, places=10)
            indptr, indices = mesh.vertex_neighbor_vertices
            self.assertEqual(len(indices), 2 * (100 + len(mesh.simplices)))
            self.assertEqual(mesh.vertex_neighbor_shifts.shape, (len(indices), 3))
            self.assertEqual(len(indptr), 101)
            # A corner, as its neighbour has it.
            for k in range(4):
                near = mesh.neighbors[:, k]
                places = mesh.places(near) + (mesh.neighbor_shifts[:, k] @ mesh.vectors)[:, None]
                both = np.concatenate([np.delete(mesh.places(), k, axis=1), places], axis=1)
                shared = [len(np.unique(rows.round(9), axis=0)) for rows in both]
                self.assertEqual(set(shared), {4})

    def test_neighbor_lists(self) -> None:
        for box in (OBLIQUE, OBLIQUE[:2]):
            points = np.concatenate([random_points(80, OBLIQUE), [[9.0, 9, 9]] * 2])
            cells = mgdt.PeriodicVoronoi(points, box)
            near = cells.neighbor_list
            self.assertEqual(len(near.indptr), 83)
            self.assertEqual(near.indptr[82], near.indptr[81])  # it repeats the one before
            where = np.repeat(np.arange(82), np.diff(near.indptr))
            places = cells.points[near.neighbors] + near.shifts[:, : len(box)] @ cells.delaunay.vectors
            apart = np.linalg.norm(places - cells.points[where], axis=1)
            self.assertTrue(np.allclose(near.distances, apart, rtol=1e-13))
            # What one point says of a neighbour, the neighbour says of it.
            said = {
                (a, b, *image): (area, distance)
                for a, b, image, area, distance in zip(
                    where.tolist(), near.neighbors.tolist(), near.shifts.tolist(),
                    near.areas.tolist(), near.distances.tolist(),
                )
            }
            self.assertEqual(len(said), len(where))
            for (a, b, *image), (area, distance) in said.items():
                back = said[(b, a) + tuple(-k for k in image)]
                self.assertAlmostEqual(back[0], area, places=12)
                self.assertAlmostEqual(back[1], distance, places=12)
            bounded = np.isfinite(cells.volumes) & (cells.volumes > 0)
            height = np.bincount(where, near.areas * near.distances, 82)[bounded] / 6
            self.assertTrue(np.allclose(height, cells.volumes[bounded], rtol=1e-11))

    def test_images_are_the_same(self) -> None:
        points = np.floor(random_points(60, OBLIQUE) * 64) / 64
        mesh = mgdt.PeriodicDelaunay(points, OBLIQUE)
        shift = np.random.default_rng(3).integers(-50, 50, (60, 3))
        other = mgdt.PeriodicDelaunay(points + shift @ OBLIQUE, OBLIQUE, threads=2)
        self.assertTrue((other.simplices == mesh.simplices).all())
        self.assertTrue((other.volumes == mesh.volumes).all())
        self.assertTrue((other.centroids == mesh.centroids).all())
        own = other.shifts + shift[other.simplices]
        self.assertTrue((own - own[:, :1] == mesh.shifts).all())
        both = mgdt.PeriodicDelaunay(np.concatenate([points, points + shift @ OBLIQUE]), OBLIQUE)
        self.assertTrue((both.point_map[60:] == np.arange(60)).all())
        self.assertTrue((both.point_shifts[60:] == shift).all())
        self.assertTrue((both.volumes[60:] == 0).all())

    def test_slabs_and_wires(self) -> None:
        points = random_points(80, np.eye(3))
        slab = mgdt.PeriodicDelaunay(points, np.eye(3), [True, True, False])
        slab.check()
        self.assertEqual(slab.vectors.shape, (2, 3))
        self.assertTrue((slab.shifts[..., 2] == 0).all())
        self.assertTrue((slab.neighbors == -1).any())
        again = mgdt.PeriodicDelaunay(points, np.eye(3)[:2])
        self.assertTrue((again.simplices == slab.simplices).all())
        wire = mgdt.PeriodicDelaunay(points, [1, 1, 1], np.array([False, True, False]))
        wire.check()
        self.assertEqual(wire.places(0).shape, (4, 3))
        self.assertTrue(np.isinf(wire.volumes).any())
        self.assertIn("1 vector,", repr(wire))

    def test_steps(self) -> None:
        points = random_points(200, OBLIQUE)
        mesh = mgdt.PeriodicDelaunay(points, OBLIQUE)
        before = mesh.volumes
        for _ in range(3):
            points += np.random.default_rng(5).normal(0, 0.05, points.shape)
            mesh.move(points)
            fresh = mgdt.PeriodicDelaunay(points, OBLIQUE)
            self.assertTrue((mesh.simplices == fresh.simplices).all())
            self.assertTrue((mesh.shifts == fresh.shifts).all())
        self.assertFalse((mesh.volumes == before).all())
        self.assertTrue((mesh.volumes == fresh.volumes).all())

    def test_steps_of_the_box(self) -> None:
        points = random_points(200, OBLIQUE)
        mesh = mgdt.PeriodicDelaunay(points, OBLIQUE)
        for k in range(1, 4):
            box = OBLIQUE * (1 + 0.01 * k)
            mesh.move(points, box)
            mesh.check()
            fresh = mgdt.PeriodicDelaunay(points, box)
            self.assertTrue((mesh.simplices == fresh.simplices).all())
            self.assertTrue((mesh.shifts == fresh.shifts).all())
        self.assertTrue((copy.copy(mesh).simplices == mesh.simplices).all())
        mesh.move(points, OBLIQUE, [True, True, False])
        self.assertEqual(mesh.vectors.shape, (2, 3))
        before = mesh.simplices
        with self.assertRaisesRegex(ValueError, "199 places"):
            mesh.move(points[1:], OBLIQUE)
        with self.assertRaisesRegex(TypeError, "not given"):
            mesh.move(points, periodic=[True])
        self.assertTrue((mesh.simplices == before).all())
        with self.assertRaisesRegex(ValueError, "in a plane"):
            mesh.move(points, np.ones((3, 3)))
        points[7, 1] = np.nan
        with self.assertRaisesRegex(ValueError, "point 7"):
            mesh.move(points, OBLIQUE)
        self.assertTrue((mesh.simplices == before).all())

    def test_crystals(self) -> None:
        corners = np.array([[0, 0, 0], [0.5, 0.5, 0], [0.5, 0, 0.5], [0, 0.5, 0.5]])
        for atoms, faces in (
            (corners[:1], 6),
            (np.array([[0, 0, 0], [0.5] * 3]), 14),
            (corners, 12),
            (np.concatenate([corners, corners + 0.25]), 16),
        ):
            mesh = mgdt.PeriodicDelaunay(atoms, [1, 1, 1])
            self.assertEqual(set(mesh.face_counts.tolist()), {faces})
            self.assertTrue(np.allclose(mesh.volumes, 1 / len(atoms), rtol=1e-13))
            self.assertTrue(np.allclose(mesh.centroids, 0, atol=1e-13))

    def test_progress_and_cancel(self) -> None:
        points = random_points(500, OBLIQUE)
        heard: list[float] = []
        mgdt.PeriodicDelaunay(points, OBLIQUE, progress=heard.append)
        self.assertEqual(heard[-1], 1)
        self.assertEqual(heard, sorted(heard))
        with self.assertRaises(mgdt.Cancelled):
            mgdt.PeriodicDelaunay(points, OBLIQUE, progress=lambda _: mgdt.CANCEL)

        def fails(_: float) -> None:
            raise KeyError("heard")

        with self.assertRaisesRegex(KeyError, "heard"):
            mgdt.PeriodicDelaunay(points, OBLIQUE, progress=fails)

    def test_memory_limit(self) -> None:
        with self.assertRaises(mgdt.OutOfMemoryError):
            mgdt.PeriodicDelaunay(random_points(500, OBLIQUE), OBLIQUE, memory_limit=100000)

    def test_what_is_refused(self) -> None:
        point = [[0.5, 0.5, 0.5]]
        for box in ([1, 1], np.eye(2), np.ones((4, 3)), 1, np.empty((0, 3))):
            with self.assertRaisesRegex(ValueError, "box must be three lengths"):
                mgdt.PeriodicDelaunay(point, box)
        with self.assertRaisesRegex(ValueError, "in a plane"):
            mgdt.PeriodicDelaunay(point, [1, 1, 0])
        with self.assertRaisesRegex(ValueError, "not finite"):
            mgdt.PeriodicDelaunay(point, [1, np.nan, 1])
        with self.assertRaisesRegex(TypeError, "box must be real numbers"):
            mgdt.PeriodicDelaunay(point, ["a", "b", "c"])
        for periodic in ([True, True], [1, 1, 1], [False] * 3, True):
            with self.assertRaisesRegex(ValueError, "periodic must have a bool"):
                mgdt.PeriodicDelaunay(point, [1, 1, 1], periodic)  # type: ignore[arg-type]
        with self.assertRaisesRegex(ValueError, r"\(n, 3\)"):
            mgdt.PeriodicDelaunay([[1, 2]], [1, 1, 1])
        with self.assertRaisesRegex(ValueError, "point 0"):
            mgdt.PeriodicDelaunay([[1, 2, np.inf]], [1, 1, 1])
        with self.assertRaisesRegex(ValueError, "point 0 is more than 536870912 boxes away"):
            mgdt.PeriodicDelaunay([[1, 2, 1e12]], [1, 1, 1])
        mesh = mgdt.PeriodicDelaunay(point, [1, 1, 1])
        with self.assertRaisesRegex(ValueError, "2 places"):
            mesh.move(point * 2)
        slab = mgdt.PeriodicDelaunay(point, np.eye(3)[:2])
        with self.assertRaisesRegex(ValueError, "do not span space"):
            slab.volumes
        self.assertEqual(mgdt.PeriodicDelaunay(np.empty((0, 3)), [1, 1, 1]).simplices.shape, (0, 4))

    def test_threads_of_python(self) -> None:
        sums: list[float] = []

        def work(seed: int) -> None:
            sums.append(mgdt.PeriodicDelaunay(random_points(2000, OBLIQUE, seed), OBLIQUE).volumes.sum())

        threads = [threading.Thread(target=work, args=(seed,)) for seed in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertTrue(np.allclose(sums, 30))

    def test_examples(self) -> None:
        self.assertGreater(doctest.testmod(mgdt.periodic).attempted, 4)
        self.assertEqual(doctest.testmod(mgdt.periodic).failed, 0)


class PeriodicVoronoi(unittest.TestCase):
    def test_cells(self) -> None:
        points = random_points(150, OBLIQUE)
        cells = mgdt.PeriodicVoronoi(points, OBLIQUE)
        mesh = cells.delaunay
        self.assertTrue(np.allclose(cells.volumes, mesh.volumes, rtol=1e-11))
        self.assertTrue(np.allclose(cells.centroids - points, mesh.centroids))
        np.testing.assert_allclose(cells.areas, mesh.areas, rtol=1e-11)
        self.assertEqual([len(n) for n in cells.neighbors], mesh.face_counts.tolist())
        self.assertEqual([len(n) for n in cells.neighbor_shifts], mesh.face_counts.tolist())
        # Every face separates its two sides in the middle.
        first, second = cells.ridge_points.T
        way = points[second] + cells.ridge_shifts @ OBLIQUE - points[first]
        length = np.linalg.norm(way, axis=1)
        self.assertTrue(np.allclose(way / length[:, None], cells.ridge_normals))
        height = np.einsum("ij,ij->i", cells.ridge_centroids - points[first], cells.ridge_normals)
        self.assertTrue(np.allclose(height, length / 2))
        # Both sides know of each other.
        known = {(i, j, *image) for i in range(150) for j, image in zip(cells.neighbors[i], cells.neighbor_shifts[i])}
        self.assertEqual(known, {(j, i, *(-k for k in image)) for i, j, *image in known})
        # The corners of a cell are as far from its point as from the others around.
        for region, point in zip(cells.regions, points):
            self.assertGreater(len(region), 3)
            self.assertNotIn(-1, region)
            self.assertLess(np.linalg.norm(cells.vertices[region] - point, axis=1).max(), 5)

    def test_of_a_triangulation(self) -> None:
        mesh = mgdt.PeriodicDelaunay(random_points(30, OBLIQUE), OBLIQUE)
        cells = mgdt.PeriodicVoronoi(mesh)
        self.assertIs(cells.delaunay, mesh)
        with self.assertRaisesRegex(TypeError, "has its box"):
            mgdt.PeriodicVoronoi(mesh, OBLIQUE)
        with self.assertRaisesRegex(TypeError, "box is needed"):
            mgdt.PeriodicVoronoi(mesh.points)

    def test_small_faces(self) -> None:
        # The atoms of a close-packed crystal, whose height is no short double.
        a, c = 1.0, (8 / 3) ** 0.5
        box = np.array([[a, 0, 0], [-a / 2, 3**0.5 / 2 * a, 0], [0, 0, c]])
        atoms = np.array([[0, 0, 0], [1 / 3, 2 / 3, 0.5]]) @ box
        cells = mgdt.PeriodicVoronoi(atoms, box, least_area=1e-9)
        self.assertEqual([len(n) for n in cells.neighbors], [12, 12])
        for bad in ({"least_area": -1}, {"least_share": 1}):
            with self.assertRaises(ValueError):
                mgdt.PeriodicVoronoi(atoms, box, **bad)

    def test_slab(self) -> None:
        cells = mgdt.PeriodicVoronoi(random_points(40, np.eye(3)), np.eye(3), [True, True, False])
        self.assertEqual(np.isinf(cells.volumes).sum(), 2)
        self.assertGreater(len(cells.ray_vertices), 0)
        self.assertEqual(sum(-1 in region for region in cells.regions), 2)


class Merging(unittest.TestCase):
    def test_images_on_both_sides(self):
        vectors = 14.44 * np.array([[1, 0, 0], [0.3, 1, 0], [0.2, -0.4, 1]])
        s = np.stack(np.meshgrid(*[np.linspace(0, 1, 5)] * 3, indexing="ij"), -1).reshape(-1, 3)
        box = mgdt.PeriodicDelaunay(s @ vectors, vectors, merge_distance=1e-9)
        stay = np.unique(box.point_map)
        self.assertEqual(len(stay), 64)
        np.testing.assert_allclose(box.volumes[stay], 14.44**3 / 64, rtol=1e-9)
        images = box.points[box.point_map] + box.point_shifts @ box.vectors
        np.testing.assert_allclose(images, box.points, atol=1e-9)
        twin = copy.copy(box)
        self.assertEqual(len(np.unique(twin.point_map)), 64)
        with self.assertRaises(mgdt.ArgumentError):
            mgdt.PeriodicDelaunay(s, [1, 1, 1], merge_distance=-1)


if __name__ == "__main__":
    unittest.main()
