# SPDX-License-Identifier: MIT
"""Every argument, wrong: an error that says what and where, and an object as it was."""

import pickle
import unittest

import numpy as np
from support import random_points

import mgdt


class Wrong(unittest.TestCase):
    def refused(self, error, words, call, *arguments, **keywords):
        with self.subTest(words), self.assertRaisesRegex(error, words):
            call(*arguments, **keywords)

    def test_shapes(self):
        for points, shape in (
            (np.zeros((10, 2)), r"3D.*\(10, 2\)"),
            (np.zeros((10, 4)), r"3D.*\(10, 4\)"),
            (np.zeros((2, 10, 3)), r"3D.*\(2, 10, 3\)"),
            ([1, 2, 3], r"3D.*\(3,\)"),
            ([], r"3D.*\(0,\)"),
            (7, r"3D.*\(\)"),
            (np.zeros((0, 2)), r"3D.*\(0, 2\)"),
        ):
            self.refused(ValueError, shape, mgdt.Delaunay, points)
        self.refused(ValueError, "points cannot be made into an array", mgdt.Delaunay, [[1, 2, 3], [1, 2]])

    def test_numbers(self):
        self.refused(TypeError, "complex", mgdt.Delaunay, np.zeros((5, 3), dtype=complex))
        self.refused(TypeError, "<U1", mgdt.Delaunay, [["a", "b", "c"]])
        self.refused(TypeError, "datetime64", mgdt.Delaunay, np.zeros((5, 3), dtype="M8[s]"))
        self.refused(TypeError, "points must be real numbers", mgdt.Delaunay, [[print, 1, 2]] * 5)
        self.refused(TypeError, "points must be real numbers", mgdt.Delaunay, {"x": 1})
        self.refused(ValueError, r"points\[0\].*nan", mgdt.Delaunay, [[None, 1, 2]] * 5)
        self.refused(ValueError, "points must be real numbers", mgdt.Delaunay, np.array([["x", 1, 2]] * 5, dtype=object))
        self.refused(ValueError, "masked", mgdt.Delaunay, np.ma.zeros((5, 3)))
        self.refused(TypeError, "points", mgdt.Delaunay)

    def test_messages_name_the_argument(self):
        points = random_points(30, 1)
        linear = mgdt.LinearNDInterpolator(points, points[:, 0])
        refused = self.refused
        refused(TypeError, "order_parameters must be a dict", mgdt.Delaunay, points, order_parameters=[1])
        refused(TypeError, "order parameter 'threshold' must be a number, not NoneType", mgdt.Delaunay, points,
                order_parameters={"threshold": None})
        refused(TypeError, "progress must be a function, not int", mgdt.Delaunay, points, progress=3)
        refused(TypeError, "no places: give an array", linear)
        refused(ValueError, "places must have 3 coordinates", linear, 1, 2)
        refused(ValueError, "places cannot be made into an array", linear, [[1, 2, 3], [1, 2]])
        refused(ValueError, "values cannot be made into an array", mgdt.LinearNDInterpolator, points, [[1], [1, 2]])
        for bad in ("auto", {}, [1, 2]):
            refused(TypeError, "alpha is .*; it must be a number", mgdt.AlphaShape, points, bad)
            refused(TypeError, "alpha is .*; it must be a number", mgdt.Delaunay(points).alpha_surface, bad)
            refused(TypeError, "tol is .*; it must be a number", mgdt.Delaunay(points).find_simplex, points, tol=bad)
            refused(TypeError, "tol is .*; it must be a number", mgdt.LinearNDInterpolator, points, points, tol=bad)
        refused(MemoryError, "the memory limit is 10 bytes", mgdt.Delaunay, points, memory_limit=10)
        tri = mgdt.Delaunay(points, incremental=True)
        refused(ValueError, "there is no point 30: 30 were given, counted from 0", tri.remove_points, [30])

    def test_not_finite(self):
        for value, name in ((np.nan, "nan"), (np.inf, "inf"), (-np.inf, "-inf")):
            for row in (0, 70_000, 99_999):
                points = random_points(100_000, 1)
                points[row, 1] = value
                words = rf"points\[{row}\] is \(.*, {name}, .*\): coordinates must be finite"
                self.refused(ValueError, words, mgdt.Delaunay, points)
                self.refused(ValueError, words, mgdt.Delaunay, np.asfortranarray(points))
        tri = mgdt.Delaunay(random_points(10, 2), incremental=True)
        for restart in (False, True):
            points = [[1, 2, 3], [1, 2, np.nan]]
            self.refused(mgdt.ArgumentError, r"points\[1\]", tri.add_points, points, restart)
        self.assertEqual(tri.npoints, 10)
        tri.check()

    def test_settings(self):
        points = random_points(10, 3)

        def refused(error, words, **keywords):
            self.refused(error, words, mgdt.Delaunay, points, **keywords)

        refused(ValueError, "furthest-site", furthest_site=True)
        refused(ValueError, "Qu", qhull_options="Qbb Qu")
        refused(ValueError, "'Qfoo'", qhull_options="Qfoo")
        refused(ValueError, "'QG4'", qhull_options=b"QG4")
        refused(TypeError, "int", qhull_options=7)
        refused(ValueError, "'hilbret'.*hilbert", order="hilbret")
        refused(ValueError, "order scheme", order="auto\0")
        refused(TypeError, "NoneType", order=None)
        refused(ValueError, "'cells'.*points_per_cell", order_parameters={"cells": 3})
        refused(ValueError, "-1", order_parameters={"points_per_cell": -1})
        refused(ValueError, "nan", order_parameters={"round_ratio": np.nan})
        refused(ValueError, "", order_parameters={"threshold": "many"})
        refused(ValueError, "seed is -1", seed=-1)
        refused(ValueError, "seed", seed=2**64)
        refused(TypeError, "seed.*float", seed=1.5)
        refused(ValueError, "threads is -1", threads=-1)
        refused(ValueError, "threads", threads=2**32)
        refused(TypeError, "threads.*str", threads="all")
        refused(ValueError, "memory_limit is -5", memory_limit=-5)
        refused(TypeError, "memory_limit.*float", memory_limit=1e9)
        refused(TypeError, "progress must be a function", progress=7)
        refused(TypeError, "unexpected", number=7)
        for good in ("Qbb Qc Qz Q12", "QJ", "Qt Qx Pp", b"Qbb", "", None):
            mgdt.Delaunay(points, qhull_options=good).check()
        mgdt.Delaunay(points, furthest_site=False, incremental=1, seed=np.int64(3), threads=0)

    def test_messages_name_what_users_know(self):
        points = random_points(10, 3)
        tri = mgdt.Delaunay(points, incremental=True)
        for call, name in (
            (mgdt.Delaunay, "Delaunay.__init__"),
            (tri.add_points, "Delaunay.add_points"),
            (tri.find_simplex, "Delaunay.find_simplex"),
            (tri.interpolator(points), "Interpolator.__call__"),
        ):
            for words, error in (
                (rf"{name}\(\) got an unexpected keyword argument 'colour'", dict(colour=3)),
                (rf"{name}\(\) missing 1 required positional argument", {}),
            ):
                arguments = (points,) if error else ()
                self.refused(TypeError, words, call, *arguments, **error)
        self.refused(TypeError, r"Delaunay.release\(\) takes 1", tri.release, 1)
        self.refused(TypeError, r"Delaunay.cancel\(\) takes 1", tri.cancel, 1)

    def test_methods(self):
        tri = mgdt.Delaunay(random_points(10, 4), incremental=True)
        for call in (tri.find_simplex, tri.locate, tri.nearest_vertex, tri.lift_points):
            self.refused(ValueError, r"3D.*\(2,\)", call, [1, 2])
            self.refused(ValueError, r"3D.*\(\)", call, 5)
            self.refused(ValueError, r"3D.*\(3, 2\)", call, np.zeros((3, 2)))
            self.refused(TypeError, "real", call, np.zeros(3, dtype=complex))
            self.refused(TypeError, "real", call, "abc")
        self.refused(ValueError, "3D", tri.add_points, np.zeros((3, 2)))
        self.refused(ValueError, "3D", tri.add_points, [1, 2, 3])
        self.refused(ValueError, "tol is -1", tri.find_simplex, [1, 2, 3], tol=-1)
        self.refused(ValueError, "tol is nan", tri.find_simplex, [1, 2, 3], tol=np.nan)
        for level in (0, 4, -1, 2**32 + 1):
            self.refused(ValueError, f"level is {level}", tri.check, level)
        self.refused(TypeError, "level.*float", tri.check, 2.0)
        place = [[5.5, 1, 0]]
        self.refused(ValueError, r"10 points.*\(9,\)", tri.interpolate, np.zeros(9), place)
        self.refused(ValueError, r"10 points.*\(\)", tri.interpolate, 1.0, place)
        self.refused(TypeError, "numbers", tri.interpolate, ["a"] * 10, place)
        self.assertEqual(tri.npoints, 10)
        tri.check()

    def test_memory_limit(self):
        points = random_points(20_000, 5)
        self.refused(MemoryError, "memory", mgdt.Delaunay, points, memory_limit=100_000)
        tri = mgdt.Delaunay(points[:1000], incremental=True, memory_limit=4_000_000)
        with self.assertRaises(mgdt.OutOfMemoryError):
            tri.add_points(points[1000:])
        self.assertEqual(tri.memory_limit, 4_000_000)
        self.assertLessEqual(tri.statistics["peak_memory_bytes"], 4_000_000)
        self.assertRaises(mgdt.OutOfMemoryError, tri.check)
        with self.assertRaises(ValueError):
            tri.memory_limit = -1
        tri.memory_limit = None
        self.assertIsNone(tri.memory_limit)
        tri.check()
        # Whether the call's points were counted or not, all arrays agree.
        self.assertEqual(tri.npoints, len(tri.point_map))
        self.assertEqual(tri.npoints, len(tri.points))
        self.assertEqual(tri.npoints, len(tri.vertex_to_simplex))
        self.assertEqual(int((tri.point_map >= 0).sum()), len(np.unique(tri.simplices)))
        tri.add_points(points[1000:1010])
        tri.check()

    def test_compact(self):
        points = random_points(20_000, 5)

        def memory(tri):
            return tri.statistics["memory_bytes"]

        tri = mgdt.Delaunay(points, canonical=True)
        self.assertIs(tri.compact, False)
        small = mgdt.Delaunay(points, incremental=True, canonical=True, compact=True)
        self.assertIs(small.compact, True)
        self.assertLess(memory(small), 350 * 20_000)
        self.assertLess(memory(small), memory(tri) - 100 * 20_000)
        np.testing.assert_array_equal(small.simplices, tri.simplices)
        small.add_points(points + 2, restart=True)
        self.assertIs(small.compact, True)
        self.assertLess(memory(small), 350 * 40_000)
        again = pickle.loads(pickle.dumps(small))
        self.assertIs(again.compact, True)
        self.assertLess(memory(again), 350 * 40_000)

        # What 1.0 pickled does not say.
        state = small.__getstate__()
        state["settings"] = {k: v for k, v in state["settings"].items() if k != "compact"}
        again = mgdt.Delaunay.__new__(mgdt.Delaunay)
        again.__setstate__(state)
        self.assertIs(again.compact, False)
        self.assertEqual(again.npoints, 40_000)

        before = memory(tri)
        tri.compact = 1
        self.assertIs(tri.compact, True)
        after = memory(tri)
        self.assertLess(after, before - 100 * 20_000)
        tri.check()
        tri.memory_limit = int(after)
        with self.assertRaises(mgdt.OutOfMemoryError):
            tri.compact = False
        self.assertIs(tri.compact, True)
        tri.memory_limit = None
        tri.compact = False
        self.assertGreater(memory(tri), after + 100 * 20_000)
        tri.check()
        np.testing.assert_array_equal(tri.neighbors, mgdt.Delaunay(points, canonical=True).neighbors)
        tri.release()
        with self.assertRaises(RuntimeError):
            tri.compact = True


if __name__ == "__main__":
    unittest.main()
