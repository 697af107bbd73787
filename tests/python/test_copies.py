# SPDX-License-Identifier: MIT
"""What every class keeps: copies of its objects share nothing that changes, and survive pickling."""

import copy
import pickle
import unittest
from typing import Any, Callable

import numpy as np

import mgdt

POINTS = np.random.default_rng(0).random((60, 3))
MOVED = np.random.default_rng(1).random((60, 3))
TETRAHEDRON = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]

# For each class an object, and what it says of itself.
MAKERS: dict[str, tuple[Callable[[], Any], tuple[str, ...]]] = {
    "Delaunay": (lambda: mgdt.Delaunay(POINTS), ("points", "simplices", "neighbors")),
    "Voronoi": (lambda: mgdt.Voronoi(POINTS), ("vertices", "ridge_points", "areas")),
    "PeriodicDelaunay": (
        lambda: mgdt.PeriodicDelaunay(POINTS, [1] * 3),
        ("points", "simplices", "shifts", "neighbors", "neighbor_shifts", "volumes", "areas"),
    ),
    "PeriodicVoronoi": (
        lambda: mgdt.PeriodicVoronoi(POINTS, [1] * 3),
        ("vertices", "ridge_points", "ridge_shifts", "volumes", "areas"),
    ),
    "DomainMesh": (
        lambda: mgdt.DomainMesh(TETRAHEDRON, [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]),
        ("points", "simplices", "faces", "simplex_regions"),
    ),
    "Mesh": (
        lambda: mgdt.Mesh(TETRAHEDRON, [[0, 1, 2, 3]], markers=[4]),
        ("points", "simplices", "faces", "region_markers"),
    ),
}


def state(thing: Any, names: tuple[str, ...]) -> list[Any]:
    return [np.asarray(getattr(thing, name)).tolist() for name in names]


class Copies(unittest.TestCase):
    def test_every_class(self) -> None:
        for name, (make, names) in MAKERS.items():
            with self.subTest(name):
                thing = make()
                self.assertEqual(type(thing).__name__, name)
                expected = state(thing, names)
                for twin in (copy.copy(thing), copy.deepcopy(thing), pickle.loads(pickle.dumps(thing))):
                    self.assertIs(type(twin), type(thing))
                    self.assertEqual(state(twin, names), expected)
                    self.assertEqual(repr(twin), repr(thing))
                    if hasattr(twin, "check"):
                        twin.check()
                del thing
                self.assertEqual(state(twin, names), expected)

    def test_a_copy_of_a_box_moves_alone(self) -> None:
        box = mgdt.PeriodicDelaunay(POINTS, [1] * 3)
        twin = copy.copy(box)
        twin.move(MOVED)
        _, names = MAKERS["PeriodicDelaunay"]
        self.assertEqual(state(box, names), state(mgdt.PeriodicDelaunay(POINTS, [1] * 3), names))
        self.assertEqual(state(twin, names), state(mgdt.PeriodicDelaunay(MOVED, [1] * 3), names))
        self.assertEqual(state(pickle.loads(pickle.dumps(twin)), names), state(twin, names))

    def test_a_diagram_stays_that_of_the_points_as_they_were(self) -> None:
        for settings in ({}, {"least_share": 0.01}):
            expected = mgdt.PeriodicDelaunay(POINTS, [1] * 3).areas
            box = mgdt.PeriodicDelaunay(POINTS, [1] * 3)
            cells = mgdt.PeriodicVoronoi(box, **settings)
            box.move(MOVED)
            np.testing.assert_allclose(cells.areas, expected, rtol=1e-11)

    def test_a_stopped_move_leaves_nothing(self) -> None:
        box = mgdt.PeriodicDelaunay(POINTS, [1] * 3)
        self.assertEqual(len(box.simplices), len(box.neighbors))
        box.progress = lambda fraction: mgdt.CANCEL
        self.assertRaises(mgdt.Cancelled, box.move, MOVED)
        for name in ("points", "simplices", "volumes", "point_map"):
            self.assertRaises(mgdt.NotBuiltError, getattr, box, name)
        self.assertRaises(mgdt.NotBuiltError, box.check)
        self.assertRaises(mgdt.NotBuiltError, mgdt.PeriodicVoronoi, box)
        box.progress = None
        box.move(MOVED)
        np.testing.assert_allclose(box.points, MOVED, atol=1e-13)
        box.check()


if __name__ == "__main__":
    unittest.main()
