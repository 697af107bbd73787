# SPDX-License-Identifier: MIT
"""Meshes of what facets enclose."""

import copy
import doctest
import itertools
import threading
import unittest
from typing import Any

import numpy as np

import mgdt
import mgdt.domain

CUBE = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
SIDES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]


def volumes(mesh: mgdt.DomainMesh) -> Any:
    a, b, c, d = (mesh.points[mesh.simplices[:, k]] for k in range(4))
    return np.linalg.det(np.stack([b - a, c - a, d - a], axis=1)) / 6


class DomainMesh(unittest.TestCase):
    def test_cube(self) -> None:
        for facets in (SIDES, np.array(SIDES), np.array(SIDES, np.int32), tuple(map(tuple, SIDES))):
            mesh = mgdt.DomainMesh(CUBE, facets)
            mesh.check()
            self.assertEqual(len(mesh.simplices), 6)
            self.assertAlmostEqual(volumes(mesh).sum(), 1)
            self.assertTrue((volumes(mesh) > 0).all())
            self.assertTrue((mesh.points == CUBE).all())
            self.assertEqual(mesh.neighbors.shape, (6, 4))
            self.assertEqual(len(mesh.faces), 12)
            self.assertTrue((mesh.face_simplices[:, 0] == -1).all())
            self.assertTrue((mesh.face_simplices[:, 1] >= 0).all())
            self.assertEqual(sorted(set(mesh.face_facets.tolist())), [0, 1, 2, 3, 4, 5])
            self.assertEqual(len(mesh.edges), 12)
            self.assertFalse(mesh.is_rounded)
            self.assertEqual(repr(mesh), "<mgdt.DomainMesh: 8 points, 6 tetrahedra, 1 region>")

    def test_lists_of_different_lengths(self) -> None:
        facets = [SIDES[0], *SIDES[1:5], [1, 3, 7], [1, 7, 5]]
        mesh = mgdt.DomainMesh(CUBE, facets, markers=range(7), segments=[[0, 7]], segment_markers=[5])
        mesh.check()
        a, b = (mesh.points[mesh.edges[:, k]] for k in range(2))
        length = np.linalg.norm(a - b, axis=1)
        # The segment, and the diagonal of the last side, which different markers keep.
        given = mesh.edge_segments == 0
        self.assertAlmostEqual(length[given].sum(), 3**0.5)
        self.assertEqual(set(mesh.edge_markers[given].tolist()), {5})
        self.assertAlmostEqual(length[~given].sum(), 12 + 2**0.5)
        self.assertEqual(set(mesh.face_markers.tolist()), set(range(7)))

    def test_holes_and_regions(self) -> None:
        points = np.concatenate([CUBE, 0.25 + CUBE / 2])
        facets = SIDES + [[v + 8 for v in side] for side in SIDES]
        mesh = mgdt.DomainMesh(points, facets, regions=[((0.5, 0.5, 0.5), 7), ([0.1, 0.1, 0.1], -3)])
        mesh.check()
        markers = mesh.region_markers[mesh.simplex_regions]
        self.assertAlmostEqual(volumes(mesh)[markers == 7].sum(), 1 / 8)
        self.assertAlmostEqual(volumes(mesh)[markers == -3].sum(), 7 / 8)
        hollow = mgdt.DomainMesh(points, facets, holes=[[0.5, 0.5, 0.5]])
        self.assertAlmostEqual(volumes(hollow).sum(), 7 / 8)
        self.assertEqual(hollow.region_markers.tolist(), [0])

    def test_what_is_left_out(self) -> None:
        points = np.vstack([CUBE, 0.25 + CUBE / 2])
        inner = [[v + 8 for v in side] for side in SIDES]
        mesh = mgdt.DomainMesh(points, SIDES[1:] + inner, holes=[(9, 9, 9)], regions=[((5, 5, 5), 3)])
        self.assertEqual((mesh.unused_points, mesh.unused_faces), (8, 10))
        self.assertEqual((mesh.unused_regions, mesh.unused_holes), (1, 1))
        with self.assertRaises(mgdt.OpenBoundary):
            mgdt.DomainMesh(points, SIDES[1:] + inner, strict=True)
        mesh = mgdt.DomainMesh(points, SIDES + inner, strict=True)
        self.assertEqual((mesh.unused_points, mesh.unused_faces), (0, 0))

    def test_steiner_points(self) -> None:
        # Schoenhardt's polyhedron.
        turn = np.arange(3) * 2 * np.pi / 3
        points = np.concatenate([np.stack([np.cos(turn + z), np.sin(turn + z), 0 * turn + z], 1)
                                 for z in (0, -0.5)])
        points[3:, 2] = 1
        facets = [[0, 2, 1], [3, 4, 5]]
        for i in range(3):
            k = (i + 1) % 3
            facets += [[i, k, 3 + i], [k, 3 + k, 3 + i]]
        mesh = mgdt.DomainMesh(points, facets, rounded=True)
        mesh.check()
        self.assertGreater(len(mesh.steiner_parameters), 0)
        self.assertTrue(mesh.is_rounded)
        a, b = (mesh.points[mesh.steiner_edges[:, k]] for k in range(2))
        t = mesh.steiner_parameters[:, None]
        self.assertTrue((a + t * (b - a) == mesh.points[6:]).all())

        self.assertEqual(mesh.point_origins.tolist(), [*range(6), *[-1] * (mesh.npoints - 6)])

        kept = mgdt.DomainMesh(points, facets, keep_boundary=True)
        kept.check()
        self.assertEqual((kept.npoints, len(kept.faces)), (7, 8))
        self.assertEqual(kept.steiner_edges.tolist(), [[-1, -1]])
        self.assertTrue((kept.points[:6] == points).all())

    def test_cleaning(self) -> None:
        # A point in an edge of one of the facets at it, and a wall that is given twice.
        points = np.array([[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2], [1, 0, 0], [0, 0, -2]])
        facets = [[0, 2, 1], [0, 4, 3], [4, 1, 3], [1, 2, 3], [2, 0, 3],
                  [0, 1, 2], [0, 1, 5], [1, 2, 5], [2, 0, 5]]  # fmt: skip
        with self.assertRaises(mgdt.InvalidBoundary):
            mgdt.DomainMesh(points, facets)
        cleaned = mgdt.clean_surface(points, facets, markers=range(9), threads=2)
        self.assertEqual(cleaned.origins.tolist(), [0, 0, 1, 2, 3, 4, 6, 6, 7, 8])
        self.assertEqual(cleaned.markers.tolist(), cleaned.origins.tolist())
        self.assertEqual(cleaned.covered.tolist(), [[5, 0]])
        self.assertEqual(cleaned.counts["points_in_edges"], 1)
        self.assertTrue((cleaned.points == points).all())
        for options in ({"clean": True}, {"weld": 1e-9}, {"flatness": 1e-9}):
            mesh = mgdt.DomainMesh(points, facets, markers=range(9), **options)  # type: ignore
            mesh.check()
            self.assertEqual(set(mesh.face_facets.tolist()), {0, 1, 2, 3, 4, 6, 7, 8})
            self.assertEqual(mesh.covered_facets.tolist(), [[5, 0]])
            self.assertEqual(copy.copy(mesh).simplices.tolist(), mesh.simplices.tolist())
        torn = np.concatenate([points[f] for f in facets[:5]]) + 1e-10
        torn[::2] -= 2e-10
        welded = mgdt.clean_surface(torn, np.arange(15).reshape(5, 3), weld=1e-8)
        self.assertEqual(len(np.unique(welded.points, axis=0)), 5)
        with self.assertRaisesRegex(ValueError, "option 70"):
            mgdt.clean_surface(points, facets, weld=0.5)

    def test_measures(self) -> None:
        mesh = mgdt.DomainMesh(CUBE, SIDES, markers=range(6), regions=[((0.5, 0.25, 0.125), 7)])
        self.assertTrue(np.allclose(mesh.tetrahedron_measures("volume"), volumes(mesh)))
        self.assertEqual((mesh.npoints, mesh.nsimplex), (8, 6))
        with self.assertRaisesRegex(ValueError, "radius_ratio"):
            mesh.tetrahedron_measures("weight")

    def test_other_libraries(self) -> None:
        mesh = mgdt.DomainMesh(CUBE, SIDES, markers=range(6), regions=[((0.5, 0.25, 0.125), 7)])
        try:
            other = mesh.to_meshio()
        except ImportError as error:
            self.assertIn("meshio", str(error))
        else:
            self.assertTrue((other.points == mesh.points).all())
            self.assertTrue((other.cells_dict["tetra"] == mesh.simplices).all())
            self.assertTrue((other.cells_dict["triangle"] == mesh.faces).all())
            tetrahedra, faces = other.cell_data["marker"]
            self.assertEqual(set(tetrahedra.tolist()), {7})
            self.assertTrue((faces == mesh.face_markers).all())
        try:
            grid = mesh.to_pyvista()
        except ImportError as error:
            self.assertIn("PyVista", str(error))
        else:
            self.assertEqual(grid.n_cells, 6)
            self.assertEqual(set(grid.cell_data["marker"].tolist()), {7})

    def test_offending_pairs(self) -> None:
        points = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0.5, 0.5, -1], [0.5, 0.5, 1], [3, 0, 1]]
        facets = [[0, 1, 2], [3, 4, 5], [0, 1, 1]]
        pairs = mgdt.offending_pairs(points, facets)
        self.assertEqual(pairs, [("facet", 0, "facet", 1), ("facet", 2, "facet", 2)])
        self.assertEqual(pairs[0].second, 1)
        self.assertEqual(mgdt.offending_pairs(points, facets[:1], [[4, 5]], threads=0), [])
        self.assertEqual(mgdt.offending_pairs(points, facets[:1], [[3, 4]]),
                         [("facet", 0, "segment", 0)])
        with self.assertRaises(mgdt.InvalidBoundary) as raised:
            mgdt.DomainMesh(points, facets)
        self.assertEqual(raised.exception.pairs, pairs)
        self.assertIsInstance(raised.exception, ValueError)
        self.assertIn("facet 0 and facet 1", str(raised.exception))

    def test_bad_arguments(self) -> None:
        for arguments, error in (
            (dict(points=CUBE[:, :2]), ValueError), (dict(points=CUBE * np.nan), ValueError),
            (dict(facets=[[0, 1, 8]]), ValueError), (dict(facets=[[0, 1]]), ValueError),
            (dict(facets=[[0.5, 1, 2]]), TypeError), (dict(facets=[0, 1, 2]), (TypeError, ValueError)),
            (dict(facets=[[0, 1, 2], [0.5, 1, 2, 3]]), TypeError),
            (dict(markers=[1]), ValueError), (dict(markers=[1 << 40] * 6), ValueError),
            (dict(segments=[0, 1]), ValueError), (dict(segments=[[0, 9]]), ValueError),
            (dict(segments=[[0, 1]], segment_markers=[1, 2]), ValueError),
            (dict(holes=[0, 0, 0]), ValueError), (dict(holes=[[0, 0, np.inf]]), ValueError),
            (dict(regions=[((0, 0), 1)]), ValueError), (dict(threads=-1), ValueError),
            (dict(memory_limit=3000), MemoryError),
        ):
            with self.subTest(arguments=arguments), self.assertRaises(error):
                mgdt.DomainMesh(**{"points": CUBE, "facets": SIDES, **arguments})  # type: ignore

    def test_progress(self) -> None:
        heard: list[float] = []
        mgdt.DomainMesh(CUBE, SIDES, progress=heard.append)
        self.assertEqual(heard, sorted(heard))
        self.assertEqual((heard[0], heard[-1]), (0, 1))
        with self.assertRaises(mgdt.Cancelled):
            mgdt.DomainMesh(CUBE, SIDES, progress=lambda _: mgdt.CANCEL)

        def fail(fraction: float) -> None:
            if fraction > 0.3:
                raise KeyError("mine")

        with self.assertRaises(KeyError):
            mgdt.DomainMesh(CUBE, SIDES, progress=fail)

    def test_examples(self) -> None:
        self.assertGreater(doctest.testmod(mgdt.domain).attempted, 4)
        self.assertEqual(doctest.testmod(mgdt.domain).failed, 0)

    def test_nothing(self) -> None:
        for points in (np.empty((0, 3)), CUBE):
            with self.assertRaisesRegex(mgdt.OpenBoundary, "no facets") as caught:
                mgdt.DomainMesh(points, [])
            self.assertEqual(caught.exception.edges.shape, (0, 3))
        with self.assertRaisesRegex(mgdt.OpenBoundary, "4 such edges") as caught:
            mgdt.DomainMesh(CUBE, SIDES[:5])
        edges = caught.exception.edges
        self.assertEqual(sorted(set(edges[:, :2].ravel().tolist())), sorted(SIDES[5]))
        self.assertEqual(mgdt.DomainMesh(CUBE, SIDES).open_edges.shape, (0, 3))

    def test_threads_of_python(self) -> None:
        expected = mgdt.DomainMesh(CUBE, SIDES).simplices
        found: list[Any] = []
        crew = [threading.Thread(target=lambda: found.append(mgdt.DomainMesh(CUBE, SIDES).simplices))
                for _ in range(4)]
        for thread in crew:
            thread.start()
        for thread in crew:
            thread.join()
        self.assertEqual(len(found), 4)
        for one, other in itertools.product(found, [expected]):
            self.assertTrue((one == other).all())


if __name__ == "__main__":
    unittest.main()
