# SPDX-License-Identifier: MIT
"""Meshes of the caller's tetrahedra, their refinement and their improvement."""

import copy
import doctest
import itertools
import pickle
import unittest
from typing import Any

import numpy as np

import mgdt
import mgdt.mesh

CUBE = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
SIDES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
N = 5


def lattice(seed: int = 1, move: float = 0.4) -> tuple[Any, Any]:
    """The points of cubes, of which those inside are moved, and six tetrahedra for each cube."""
    at = np.indices((N + 1,) * 3).reshape(3, -1).T[:, ::-1].astype(float)
    inner = (at > 0) & (at < N)
    points = at + inner * np.random.default_rng(seed).uniform(-move / 2, move / 2, at.shape)
    first = np.flatnonzero((at < N).all(axis=1))
    steps = np.array([1, N + 1, (N + 1) ** 2])
    corners = [np.stack([first, *(first + np.cumsum(steps[list(order)])[k] for k in range(3))], 1)
               for order in itertools.permutations(range(3))]
    return points, np.concatenate(corners)


POINTS, SIMPLICES = lattice()


class Mesh(unittest.TestCase):
    def test_tetrahedra_keep_their_order(self) -> None:
        markers = (np.arange(len(SIMPLICES)) % 2) * 5
        mesh = mgdt.Mesh(POINTS, SIMPLICES, markers=markers)
        mesh.check()
        self.assertTrue((np.sort(mesh.simplices, 1) == np.sort(SIMPLICES, 1)).all())
        self.assertTrue((mesh.points == POINTS).all())
        self.assertEqual(mesh.region_markers.tolist(), [0, 5])
        self.assertTrue((mesh.region_markers[mesh.simplex_regions] == markers).all())
        self.assertAlmostEqual(mesh.tetrahedron_measures("volume").sum(), N**3)
        self.assertEqual(repr(mesh), f"<mgdt.Mesh: {len(POINTS)} points, {len(SIMPLICES)} tetrahedra, 2 regions>")

    def test_faces_and_edges(self) -> None:
        mesh = mgdt.Mesh(CUBE, [[0, 1, 3, 7], [0, 1, 5, 7]], faces=[[7, 1, 0], [0, 1, 3]], face_markers=[4, -4],
                         edges=[[7, 1]], edge_markers=[9])
        self.assertEqual(mesh.faces[:2].tolist(), [[7, 1, 0], [0, 1, 3]])
        self.assertEqual(mesh.face_markers[:3].tolist(), [4, -4, 0])
        self.assertEqual(mesh.edges[0].tolist(), [7, 1])
        self.assertEqual((mesh.edge_markers[0], mesh.edge_segments[0], mesh.edge_segments[1]), (9, 0, -1))
        self.assertEqual(mesh.unused_points, 3)

    def test_improvement(self) -> None:
        results = []
        for threads in (1, 3):
            mesh = mgdt.Mesh(POINTS, SIMPLICES, threads=threads)
            heard: list[float] = []
            done = mesh.improve(30, slide=True, progress=heard.append)
            mesh.check()
            self.assertEqual(heard, sorted(heard))
            self.assertEqual(heard[-1], 1)
            least = np.degrees(mesh.tetrahedron_measures("least_dihedral_angle").min())
            largest = np.degrees(mesh.tetrahedron_measures("largest_dihedral_angle").max())
            self.assertAlmostEqual(done.least_angle[1], least)
            self.assertAlmostEqual(done.largest_angle[1], largest)
            self.assertAlmostEqual(done.mean_shape[1], mesh.tetrahedron_measures("volume_length").mean())
            self.assertGreaterEqual(least, 30)
            self.assertLess(done.least_angle[0], 25)
            self.assertGreater(done.mean_shape[1], done.mean_shape[0])
            self.assertEqual(done.angles.sum(axis=0).tolist(), [6 * len(SIMPLICES), 6 * mesh.nsimplex])
            self.assertEqual(done.below[:, 1].tolist(), [0] * 6)
            self.assertEqual((done.left, done.reasons.tolist()), (0, [0] * mesh.nsimplex))
            self.assertAlmostEqual(mesh.tetrahedron_measures("volume").sum(), N**3)
            results.append((mesh.points.tolist(), mesh.simplices.tolist()))
        self.assertEqual(*results)
        before = mesh.points.copy()
        mesh.improve(30, slide=True)
        self.assertTrue((mesh.points == before).all())

    def test_refinement(self) -> None:
        results = []
        for threads in (1, 3):
            mesh = mgdt.Mesh(POINTS, SIMPLICES, threads=threads)
            heard: list[float] = []
            done = mesh.refine(0.8, region_sizes=[0.6], gradation=0.5, progress=heard.append)
            mesh.check()
            self.assertEqual(heard, sorted(heard))
            self.assertEqual(heard[-1], 1)
            self.assertEqual(done.inserted, mesh.npoints - len(POINTS))
            self.assertGreater(done.inserted, 100)
            self.assertEqual(done.refused, np.count_nonzero(done.refusals))
            self.assertEqual(done.refusals.shape, (mesh.nsimplex,))
            self.assertEqual(done.sizes.tolist(), [0.6] * mesh.npoints)
            self.assertTrue((mesh.points[:len(POINTS)] == POINTS).all())
            self.assertAlmostEqual(mesh.tetrahedron_measures("volume").sum(), N**3)
            results.append((mesh.points.tolist(), mesh.simplices.tolist()))
        self.assertEqual(*results)
        self.assertGreaterEqual(mesh.improve(15).least_angle[1], 15)

    def test_sizes(self) -> None:
        at = np.linalg.norm(POINTS, axis=1)
        mesh = mgdt.Mesh(POINTS, SIMPLICES)
        by_points = mesh.refine(point_sizes=0.2 + 0.3 * at, most_points=3000)
        self.assertGreater(by_points.sizes.max(), 2 * by_points.sizes.min())
        mesh.check()
        mesh = mgdt.Mesh(POINTS, SIMPLICES)
        mesh.refine(simplex_sizes=np.where(np.arange(len(SIMPLICES)) == 0, 0.3, 0), volume=0.1)
        mesh.check()
        self.assertLess(np.count_nonzero(mesh.tetrahedron_measures("volume") > 0.1), mesh.nsimplex / 10)
        mesh = mgdt.Mesh(POINTS, SIMPLICES)
        done = mesh.refine(0.3, sizes_of_surface=True, radius_edge=0, most_points=50)
        self.assertEqual(done.inserted, 50)
        self.assertIn(5, done.refusals)

    def test_sizes_in_space(self) -> None:
        places: list[int] = []

        def size(xyz: np.ndarray) -> np.ndarray:
            self.assertEqual(xyz.shape[1], 3)
            places.append(len(xyz))
            return 0.2 + 0.2 * np.linalg.norm(xyz, axis=1)

        mesh = mgdt.Mesh(POINTS, SIMPLICES)
        done = mesh.refine(size_function=size)
        mesh.check()
        self.assertGreater(sum(places), done.inserted / 10)
        at = np.linalg.norm(mesh.points, axis=1)
        self.assertTrue((done.sizes <= 0.22 + 0.22 * at).all())
        again = copy.deepcopy(mesh)
        self.assertEqual(again.points.tolist(), mesh.points.tolist())
        by_field = mgdt.Mesh(POINTS, SIMPLICES)
        done = by_field.refine(size_field=(POINTS, size(POINTS)))
        by_field.check()
        self.assertGreater(done.inserted, 0.5 * mesh.npoints)
        with self.assertRaisesRegex(mgdt.Error, "the size function gives -1"):
            mesh.refine(size_function=lambda xyz: np.full(len(xyz), -1.0))
        with self.assertRaisesRegex(ValueError, r"shape \(\d+,\), not \(3,\)"):
            mesh.refine(size_function=lambda xyz: [1, 2, 3])
        with self.assertRaises(KeyError):
            mesh.refine(size_function=lambda xyz: {}["size"])
        with self.assertRaisesRegex(ValueError, "size_field"):
            mesh.refine(size_field=(POINTS, [1.0]))
        self.assertEqual(again.points.tolist(), mesh.points.tolist())

    def test_what_stays(self) -> None:
        on_surface = ((POINTS == 0) | (POINTS == N)).any(axis=1)
        fixed = np.flatnonzero(~on_surface)[:7]
        mesh = mgdt.Mesh(POINTS, SIMPLICES)
        mesh.improve(28, fixed=fixed)
        moved = (mesh.points[:len(POINTS)] != POINTS).any(axis=1)
        self.assertFalse(moved[on_surface].any() or moved[fixed].any())
        self.assertTrue(moved.any())
        self.assertEqual(mesh.unused_points, 0)
        self.assertTrue((mesh.point_origins[:len(POINTS)] == np.arange(len(POINTS))).all())
        mesh = mgdt.Mesh(POINTS, SIMPLICES)
        mesh.improve(28, keep="all")
        self.assertTrue((mesh.points[:len(POINTS)] == POINTS).all())

    def test_places(self) -> None:
        mesh = mgdt.Mesh(POINTS, SIMPLICES)
        places = np.random.default_rng(2).uniform(-1, N + 1, (4, 50, 3))
        places[0, 0] = np.nan
        inside = ((places >= 0) & (places <= N)).all(axis=-1)
        found, weights = mesh.locate(places)
        self.assertTrue((mesh.contains(places) == inside).all())
        self.assertTrue(((found >= 0) == inside).all())
        self.assertTrue((mesh.find_simplex(places) == found).all())
        self.assertEqual(weights.shape, (4, 50, 4))
        self.assertEqual(abs(weights[~inside]).max(), 0)
        reached = np.einsum("...k,...kd->...d", weights, mesh.points[mesh.simplices[found]])
        self.assertLess(abs(reached - places)[inside].max(), 1e-13)
        found, weights = mesh.locate(places[1], nearest=True)
        self.assertGreaterEqual(found.min(), 0)
        reached = np.einsum("...k,...kd->...d", weights, mesh.points[mesh.simplices[found]])
        self.assertLess(abs(reached - np.clip(places[1], 0, N)).max(), 1e-13)
        values = mesh.points @ [1, -2, 3]
        self.assertTrue((np.isnan(mesh.interpolate(values, places)) == ~inside).all())
        self.assertLess(abs(mesh.interpolate(mesh.points, places[1], nearest=True) - np.clip(places[1], 0, N)).max(), 1e-13)
        self.assertEqual(mesh.interpolate(values, [1, 1, 1]).shape, ())
        mesh.improve(30)
        self.assertTrue((mesh.contains(places) == inside).all())
        for call in (lambda: mesh.locate([1, 2]), lambda: mesh.interpolate(values[:-1], places)):
            with self.assertRaises(ValueError):
                call()

    def test_reasons(self) -> None:
        mesh = mgdt.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.2, 0.2, 0.01]], [[0, 1, 2, 3]])
        done = mesh.improve()
        self.assertEqual((done.left, done.reasons.tolist()), (1, [1]))
        self.assertEqual(done.least_angle[0], done.least_angle[1])

    def test_domain_mesh(self) -> None:
        points = np.concatenate([CUBE, [[0.5, 0.5, 0.02]]])
        mesh = mgdt.DomainMesh(points, SIDES)
        mesh.check()
        done = mesh.improve(25)
        self.assertTrue((mesh.points[:9] == points).all())
        self.assertGreaterEqual(done.least_angle[1], done.least_angle[0])
        mesh.check()

    def test_copies(self) -> None:
        mesh = mgdt.Mesh(POINTS, SIMPLICES, markers=np.ones(len(SIMPLICES), int))
        mesh.refine(0.8)
        mesh.improve(25, slide=True, mean_passes=1)
        for twin in (copy.copy(mesh), copy.deepcopy(mesh), pickle.loads(pickle.dumps(mesh))):
            self.assertTrue((twin.points == mesh.points).all())
            self.assertTrue((twin.simplices == mesh.simplices).all())
        with self.assertRaises(mgdt.Cancelled):
            mesh.improve(35, progress=lambda _: mgdt.CANCEL)
        mesh.check()
        with self.assertRaisesRegex(TypeError, "cancelled"):
            copy.copy(mesh)

    def test_bad_arguments(self) -> None:
        for arguments, words in (
            (dict(simplices=[[0, 1, 2, 8]]), "corner 8"), (dict(simplices=[[0, 1, 2, 3]]), "is flat"),
            (dict(simplices=[[0, 1, 2]]), "shape"), (dict(markers=[1, 2]), "markers"),
            (dict(faces=[[0, 3, 4]]), "no face"), (dict(edges=[[2, 3]]), "no edge"),
            (dict(simplices=[[0, 1, 2, 4], [4, 2, 1, 0]]), "same corners"),
            (dict(simplices=np.empty((0, 4), int)), "no tetrahedra"), (dict(threads=-1), "-1"),
        ):
            with self.subTest(arguments), self.assertRaisesRegex(ValueError, words):
                mgdt.Mesh(**{"points": CUBE, "simplices": [[0, 1, 2, 4]], **arguments})  # type: ignore
        mesh = mgdt.Mesh(CUBE, [[0, 1, 2, 4]])
        for arguments, words in (
            (dict(goal=71), "71"), (dict(keep="some"), "'some'"), (dict(fixed=[8]), "fixed point 0 is 8"),
            (dict(mean_passes=-1), "-1"), (dict(most_passes=10**6), "1000000"),
        ):
            with self.subTest(arguments), self.assertRaisesRegex(ValueError, words):
                mesh.improve(**arguments)  # type: ignore
        for arguments, words in (
            (dict(size=-1), "-1"), (dict(size=np.nan), "nan"), (dict(size=1e-9), "would take"),
            (dict(point_sizes=[1, 2]), "shape"), (dict(simplex_sizes=[-1]), "size 0 is -1"),
            (dict(region_sizes=[np.nan]), "size 0 is"), (dict(most_points=-1), "-1"), (dict(gradation=1e7), "1e"),
        ):
            with self.subTest(arguments), self.assertRaisesRegex((ValueError, mgdt.TooLargeError), words):
                mesh.refine(**arguments)  # type: ignore
        with self.assertRaises(mgdt.Cancelled):
            mesh.refine(0.1, progress=lambda _: mgdt.CANCEL)
        self.assertEqual(mesh.nsimplex, 1)
        mesh.check()

    def test_examples(self) -> None:
        self.assertEqual(doctest.testmod(mgdt.mesh).failed, 0)


if __name__ == "__main__":
    unittest.main()
