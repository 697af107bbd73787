# SPDX-License-Identifier: MIT
"""Nothing leaks: neither the library's memory nor Python's objects."""

import gc
import os
import sys
import tracemalloc
import unittest
import weakref

import numpy as np
from support import random_points

import mgdt


def resident_bytes():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


class Leaks(unittest.TestCase):
    def use_everything(self, k):
        points = random_points(1000, k)
        progress = (lambda _: None) if k % 5 == 0 else None
        tri = mgdt.Delaunay(points, incremental=True, progress=progress)
        tri.add_points(points[:100] + 0.5)
        tri.simplices, tri.neighbors, tri.convex_hull, tri.edges, tri.point_map, tri.coplanar
        tri.locate(points[:50])
        tri.nearest_vertex(points[:5])
        tri.statistics
        for wrong in (points[:5] * np.nan, points[:, :2]):
            try:
                tri.add_points(wrong)
            except ValueError:
                pass
        return tri

    def test_a_thousand_objects(self):
        # Warm: allocators keep what they once had.
        for k in range(100):
            held = self.use_everything(k).statistics["memory_bytes"]
        gc.collect()
        resident = resident_bytes()
        for k in range(1000):
            self.use_everything(k)
        gc.collect()
        # One leaked triangulation in ten would be a hundred of them.
        self.assertLess(resident_bytes() - resident, 20 * held)

    def test_python_objects(self):
        tracemalloc.start()
        try:
            # Warm: Python keeps freed objects of some kinds for the next.
            for k in range(100):
                self.use_everything(k)
            gc.collect()
            traced = tracemalloc.get_traced_memory()[0]
            for k in range(300):
                self.use_everything(k)
            gc.collect()
            # Less than the smallest array for each triangulation.
            self.assertLess(tracemalloc.get_traced_memory()[0] - traced, 300 * 100)
        finally:
            tracemalloc.stop()

    def test_objects_go_without_the_garbage_collector(self):
        gc.disable()
        try:
            for n, progress in (
                *((100, None), (100, lambda _: None)),
                *((60_000, None), (60_000, lambda _: None)),
            ):
                points = random_points(n, 1)
                tri = mgdt.Delaunay(points, progress=progress)
                tri.simplices
                handle = weakref.ref(tri._handle)
                tri = None
                self.assertIsNone(handle())
                # Nothing keeps the input either: this variable and the call's argument.
                self.assertEqual(sys.getrefcount(points), 2)
        finally:
            gc.enable()

    def test_a_stopped_insertion_keeps_nothing(self):
        gc.disable()
        try:
            for n in (1000, 60_000):
                points = random_points(n, 2)
                for progress in (
                    lambda f: mgdt.CANCEL if f > 0.5 else None,
                    lambda f: 1 / 0 if f > 0.5 else None,
                ):
                    try:
                        mgdt.Delaunay(points, progress=progress)
                    except (mgdt.Cancelled, ZeroDivisionError):
                        pass
                    self.assertEqual(sys.getrefcount(points), 2)
        finally:
            gc.enable()

    def test_long_calls_keep_nothing(self):
        gc.disable()
        try:
            tri = mgdt.Delaunay(random_points(210_000, 4))
            places = random_points(60_000, 5)
            tri.simplices
            tri.check(1)
            tri.locate(places)
            self.assertEqual(sys.getrefcount(places), 2)
            places[0] = np.nan
            self.assertEqual(tri.locate(places)[0][0], -1)
            self.assertEqual(sys.getrefcount(places), 2)
            handle = weakref.ref(tri._handle)
            tri = None
            self.assertIsNone(handle())
        finally:
            gc.enable()

    def test_release_gives_memory_back(self):
        tri = mgdt.Delaunay(random_points(300_000, 3))
        held = tri.statistics["memory_bytes"]
        self.assertGreater(held, 100_000_000)
        before = resident_bytes()
        tri.release()
        self.assertGreater(before - resident_bytes(), 0.8 * held)


if __name__ == "__main__":
    unittest.main()
