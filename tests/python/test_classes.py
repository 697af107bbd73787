# SPDX-License-Identifier: MIT
"""What the user is promised of `Delaunay`, in the other classes that build: Ctrl-C, threads, progress."""

import os
import signal
import subprocess
import sys
import threading
import time
import unittest
import warnings
from typing import Any, Callable, Optional

import numpy as np

import mgdt

POINTS = np.random.default_rng(0).random((3000, 3))
CUBE = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)])
SIDES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]

Progress = Optional[Callable[[float], Any]]

MAKERS: dict[str, Callable[[Progress], Any]] = {
    "Delaunay": lambda progress: mgdt.Delaunay(POINTS, progress=progress),
    "PeriodicDelaunay": lambda progress: mgdt.PeriodicDelaunay(POINTS, [1] * 3, progress=progress),
    "PeriodicVoronoi": lambda progress: mgdt.PeriodicVoronoi(POINTS, [1] * 3, progress=progress),
    "DomainMesh": lambda progress: mgdt.DomainMesh(CUBE, SIDES, progress=progress),
    "Mesh": lambda progress: mgdt.Mesh(CUBE, [[0, 1, 2, 4]], progress=progress),
}

# A child builds what takes a while twice, and is interrupted in the second build.
CHILD = """
import signal, time
import numpy as np
import mgdt

signal.signal(signal.SIGINT, signal.default_int_handler)
rng = np.random.default_rng(1)
points = rng.random((100_000, 3))

def crumpled_sheet(n=16, thickness=1e-4):
    x, y = (c.ravel() / n for c in np.meshgrid(np.arange(n + 1), np.arange(n + 1), indexing="ij"))
    low = np.stack([x, y, rng.uniform(-0.3, 0.3, len(x))], 1)
    a = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    faces = np.concatenate([np.stack([a, a + n + 1, a + n + 2], 1), np.stack([a, a + n + 2, a + 1], 1)])
    k = np.arange(n)
    border = np.concatenate([k * (n + 1), n * (n + 1) + k, (n - k) * (n + 1) + n, n - k])
    after = np.roll(border, -1)
    up = len(low)
    sides = [np.stack([border, after, after + up], 1), np.stack([border, after + up, border + up], 1)]
    return np.concatenate([low, low + [0, 0, thickness]]), np.concatenate([faces, faces + up, *sides])

surface = crumpled_sheet()
build = {
    "Delaunay": lambda: mgdt.Delaunay(points),
    "PeriodicDelaunay": lambda: mgdt.PeriodicDelaunay(points, [1] * 3),
    "PeriodicVoronoi": lambda: mgdt.PeriodicVoronoi(points, [1] * 3),
    "DomainMesh": lambda: mgdt.DomainMesh(*surface),
    "Mesh": lambda: mgdt.Mesh(points[:5000], mgdt.Delaunay(points[:5000]).simplices).improve(30, most_passes=5),
}[KIND]
begin = time.monotonic()
build()
print(time.monotonic() - begin, flush=True)
try:
    build()
except KeyboardInterrupt:
    print("caught", flush=True)
"""


class Interrupts(unittest.TestCase):
    def test_ctrl_c(self) -> None:
        for name in MAKERS:
            with self.subTest(name):
                with subprocess.Popen(
                    [sys.executable, "-c", CHILD.replace("KIND", repr(name))],
                    stdout=subprocess.PIPE,
                    stderr=subprocess.PIPE,
                    text=True,
                ) as child:
                    assert child.stdout is not None and child.stderr is not None
                    line = child.stdout.readline()
                    self.assertTrue(line, child.stderr.read() if not line else "")
                    time.sleep(0.3 * float(line))
                    os.kill(child.pid, signal.SIGINT)
                    out, errors = child.stdout.read(), child.stderr.read()
                    self.assertEqual((child.wait(timeout=60), out, errors), (0, "caught\n", ""))


class ProgressFunctions(unittest.TestCase):
    def test_what_they_hear(self) -> None:
        for name, make in MAKERS.items():
            with self.subTest(name):
                heard: list[float] = []
                make(heard.append)
                self.assertEqual((heard[0], heard[-1]), (0, 1))
                self.assertEqual(heard, sorted(heard))

    def test_what_cancels(self) -> None:
        for name, make in MAKERS.items():
            with self.subTest(name):
                with self.assertRaises(mgdt.Cancelled):
                    make(lambda fraction: mgdt.CANCEL)
                with self.assertRaises(ZeroDivisionError):
                    make(lambda fraction: 1 // 0)
                # What a progress bar may give for reasons of its own, with a warning.
                with warnings.catch_warnings(record=True) as said:
                    warnings.simplefilter("always")
                    make(lambda fraction: fraction > 0)
                self.assertEqual([w.category for w in said], [RuntimeWarning])

    def test_their_own_object_is_refused(self) -> None:
        box = mgdt.PeriodicDelaunay(POINTS, [1] * 3)
        box.progress = lambda fraction: box.volumes
        with self.assertRaises(mgdt.BusyError):
            box.move(POINTS)
        box.progress = None
        box.move(POINTS)
        self.assertAlmostEqual(float(box.volumes.sum()), 1)


class Errors(unittest.TestCase):
    def test_qhull_error_catches_them(self) -> None:
        flat = POINTS * [1, 1, 0]
        for call in (
            lambda: mgdt.Voronoi(flat),
            lambda: mgdt.PeriodicVoronoi(flat, [[1, 0, 0], [0, 1, 0]]),
            lambda: mgdt.PeriodicDelaunay(POINTS * np.nan, [1] * 3),
            lambda: mgdt.PeriodicDelaunay(POINTS, [1, 1, 0]),
            lambda: mgdt.DomainMesh(CUBE, SIDES[:5]),
            lambda: mgdt.DomainMesh(CUBE, [*SIDES, [0, 1, 6]]),
        ):
            with self.assertRaises(mgdt.QhullError) as caught:
                call()
            self.assertIsInstance(caught.exception, ValueError)


class Moves(unittest.TestCase):
    def test_wait_for_readers_of_a_box(self) -> None:
        box = mgdt.PeriodicDelaunay(POINTS, [1] * 3)
        failures: list[BaseException] = []
        ended = threading.Event()

        def read() -> None:
            try:
                while not ended.is_set():
                    box._cache.clear()
                    assert abs(box.volumes.sum() - 1) < 1e-9
                    assert len(mgdt.PeriodicVoronoi(box).points) == len(POINTS)
            except BaseException as error:  # pylint: disable=broad-exception-caught
                failures.append(error)

        readers = [threading.Thread(target=read) for _ in range(3)]
        for reader in readers:
            reader.start()
        for k in range(10):
            box.move(POINTS + 1e-3 * k)
        ended.set()
        for reader in readers:
            reader.join()
        self.assertEqual(failures, [])

    def test_a_stopped_move_leaves_nothing_old(self) -> None:
        box = mgdt.PeriodicDelaunay(POINTS, [1] * 3)
        self.assertEqual(len(box.volumes), len(POINTS))
        box.progress = lambda fraction: mgdt.CANCEL
        with self.assertRaises(mgdt.Cancelled):
            box.move(POINTS[::-1])
        for name in ("simplices", "volumes", "vertex_neighbor_vertices"):
            with self.assertRaises(mgdt.NotBuiltError):
                getattr(box, name)
        self.assertEqual(repr(box), "<mgdt.PeriodicDelaunay: 3000 points, 3 vectors, 0 tetrahedra>")
        box.progress = None
        box.move(POINTS)
        self.assertAlmostEqual(float(box.volumes.sum()), 1)


if __name__ == "__main__":
    unittest.main()
