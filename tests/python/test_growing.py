# SPDX-License-Identifier: MIT
"""Points in rounds, settings, figures, and the end of an object."""

import copy
import ctypes
import io
import pickle
import threading
import unittest
import warnings

import numpy as np
from support import grid, random_points, row_set

import mgdt


class Rounds(unittest.TestCase):
    def test_settings_are_read_as_the_library_has_them(self):
        """Each property against the getter of the C interface."""
        tri = mgdt.Delaunay(
            random_points(100, 5),
            order="kd-tree",
            order_parameters={"separation": "passes", "threshold": 50},
            seed=2**64 - 1,
            memory_limit=2**40,
            compact=True,
            canonical=True,
        )
        library, pointer = mgdt._library.library, tri._handle._pointer

        def read(name, kind, *keys):
            value = kind()
            self.assertEqual(getattr(library, name)(pointer, *keys, ctypes.byref(value)), 0)
            return value.value

        scheme = read("mgdt_get_order_scheme", ctypes.c_int32)
        self.assertEqual(library.mgdt_order_scheme_name(scheme).decode(), tri.order)
        self.assertEqual(read("mgdt_get_seed", ctypes.c_uint64), tri.seed)
        self.assertEqual(read("mgdt_get_memory_limit", ctypes.c_int64), tri.memory_limit)
        self.assertEqual(read("mgdt_get_compact", ctypes.c_int32), tri.compact)
        self.assertEqual(read("mgdt_get_canonical_output", ctypes.c_int32), tri.canonical)
        self.assertEqual(tri.order_parameters, {"separation": "passes", "threshold": 50.0})
        self.assertEqual(read("mgdt_get_order_parameter", ctypes.c_double, 30), 1)
        self.assertEqual(read("mgdt_get_order_parameter", ctypes.c_double, 20), 50)
        tri.threads = 3
        self.assertEqual(read("mgdt_get_threads", ctypes.c_int32), 3)
        self.assertEqual(tri.threads, 3)
        for bad in ({"separation": "apart"}, {"threshold": "rounds"}):
            with self.assertRaisesRegex(ValueError, "must be a number"):
                mgdt.Delaunay([[0, 0, 0]], order_parameters=bad)
        with self.assertRaises(ValueError):
            tri.threads = -1

    def test_every_order_gives_the_same(self):
        points = np.concatenate([grid(6), random_points(300, 1)])
        expected = row_set(mgdt.Delaunay(points).simplices)
        self.assertGreaterEqual(len(mgdt.ORDER_SCHEMES), 10)
        for order in mgdt.ORDER_SCHEMES:
            tri = mgdt.Delaunay(points, order=order, seed=3, threads=2)
            self.assertEqual((tri.order, tri.seed, tri.threads), (order, 3, 2))
            self.assertEqual(row_set(tri.simplices), expected, order)
            tri.check()

    def test_order_parameters_reach_the_library(self):
        points = random_points(3000, 2)
        few, many = (
            mgdt.Delaunay(points, order="regular-grid", order_parameters={"points_per_cell": n})
            for n in (2, 500)
        )
        self.assertNotEqual(few.statistics["walk_steps"], many.statistics["walk_steps"])
        seeds = [mgdt.Delaunay(points, order="random", seed=s).statistics for s in (1, 1, 2)]
        steps = [figures["walk_steps"] for figures in seeds]
        self.assertEqual(steps[0], steps[1])
        self.assertNotEqual(steps[0], steps[2])

    def test_any_split_gives_the_same(self):
        points = np.concatenate([random_points(200, 3), random_points(50, 3), grid(4)])
        whole = mgdt.Delaunay(points)
        for sizes in ([1] * len(points), [0, 7, 0, 200], [3, 1]):
            tri = mgdt.Delaunay(np.zeros((0, 3)), incremental=True)
            begin = 0
            for size in sizes + [len(points)]:
                tri.add_points(points[begin : begin + size])
                begin += size
            tri.check()
            self.assertEqual(row_set(tri.simplices), row_set(whole.simplices))
            np.testing.assert_array_equal(tri.point_map, whole.point_map)
            np.testing.assert_array_equal(tri.coplanar[:, [0, 2]], whole.coplanar[:, [0, 2]])

    def test_restart(self):
        tri = mgdt.Delaunay(random_points(100, 4), incremental=True)
        tri.add_points(random_points(100, 5))
        tri.add_points(random_points(100, 6), restart=True)
        tri.check()
        self.assertEqual(tri.npoints, 300)
        self.assertEqual(tri.statistics["points_inserted"], 300)
        self.assertEqual(
            row_set(tri.simplices), row_set(mgdt.Delaunay(tri.points).simplices)
        )

    def test_close_ends_adding_only(self):
        tri = mgdt.Delaunay(random_points(100, 7), incremental=True)
        tri.close()
        tri.close()
        self.assertRaises(RuntimeError, tri.add_points, random_points(1))
        self.assertGreaterEqual(tri.find_simplex(tri.points.mean(axis=0)), 0)
        tri.check()

    def test_release(self):
        with mgdt.Delaunay(random_points(100, 8), incremental=True) as tri:
            simplices = tri.simplices
        tri.release()
        self.assertIs(tri.simplices, simplices)
        self.assertEqual(tri.npoints, 100)
        for use in (
            lambda: tri.neighbors,
            lambda: tri.nsimplex,
            lambda: tri.statistics,
            lambda: tri.find_simplex([0, 0, 0]),
            lambda: tri.nearest_vertex([0, 0, 0]),
            lambda: tri.add_points([[0, 0, 0]]),
            tri.check,
            lambda: pickle.dumps(tri),
        ):
            self.assertRaisesRegex(RuntimeError, "released|incremental", use)
        self.assertIn("released", repr(tri))
        tri.cancel()

    def test_copies_are_the_same(self):
        tri = mgdt.Delaunay(random_points(200, 9), incremental=True, order="hilbert", seed=5)
        for k in range(3):
            tri.add_points(random_points(50, 10 + k))
        for twin in (pickle.loads(pickle.dumps(tri)), copy.copy(tri), copy.deepcopy(tri)):
            for name in ("points", "simplices", "neighbors", "point_map"):
                np.testing.assert_array_equal(getattr(twin, name), getattr(tri, name))
            twin.add_points(random_points(5, 20))
            twin.check()
        self.assertEqual(tri.npoints, 350)
        tri.close()
        self.assertRaises(RuntimeError, pickle.loads(pickle.dumps(tri)).add_points, [[0, 0, 0]])

    def test_figures(self):
        tri = mgdt.Delaunay(np.concatenate([random_points(1000, 10), random_points(7, 10)]))
        figures = tri.statistics
        self.assertEqual(figures["points_inserted"], 1000)
        self.assertEqual(figures["duplicates"], 7)
        self.assertEqual(
            figures["tetrahedra_created"] - figures["tetrahedra_removed"],
            # The first star of five, and the ghosts, one on each facet of the hull.
            tri.nsimplex + len(tri.convex_hull) - 5,
        )
        self.assertGreater(figures["memory_bytes"], 48 * tri.nsimplex)
        self.assertGreater(figures["insert_seconds"], 0)
        self.assertEqual(len(figures), 24)
        self.assertIn(tri.isa, ("baseline", "avx2", "avx512", "neon"))
        self.assertEqual(repr(tri), f"<mgdt.Delaunay: 1007 points, {tri.nsimplex} tetrahedra>")

    def test_version(self):
        self.assertEqual(mgdt.__version__, mgdt.library_version())


class Changes(unittest.TestCase):
    def compare(self, tri, places, is_in):
        """The same, array by array, as an object that never had another point."""
        fresh = mgdt.Delaunay(places[is_in], canonical=True)
        index = np.flatnonzero(is_in)
        tri.check()
        np.testing.assert_array_equal(tri.points[is_in], places[is_in])
        np.testing.assert_array_equal(tri.simplices, index[fresh.simplices])
        np.testing.assert_array_equal(tri.neighbors, fresh.neighbors)
        np.testing.assert_array_equal(tri.convex_hull, index[fresh.convex_hull])
        np.testing.assert_array_equal(tri.point_map[is_in], index[fresh.point_map])
        self.assertTrue((tri.point_map[~is_in] == -1).all())
        np.testing.assert_array_equal(tri.min_bound, fresh.min_bound)

    def test_histories(self):
        rng = np.random.default_rng(4)
        places = np.round(random_points(300, 31) * 8) / 8
        tri = mgdt.Delaunay(places, incremental=True, canonical=True)
        is_in = np.ones(300, dtype=bool)
        for share in (0.01, 0.3, 0.02, 0.5):
            out = is_in & (rng.random(300) < share)
            tri.remove_points(out if share > 0.1 else np.flatnonzero(out)[::-1])
            is_in &= ~out
            self.compare(tri, places, is_in)
            places = places.copy()
            some = np.flatnonzero(is_in & (rng.random(300) < share))
            places[some] = random_points(len(some), 32)
            tri.move_points(places[some], some)
            self.compare(tri, places, is_in)
            places = places + 0.01 * rng.random(places.shape)
            tri.move_points(np.where(is_in[:, None], places, np.nan))
            self.compare(tri, places, is_in)
            twin = pickle.loads(pickle.dumps(tri))
            np.testing.assert_array_equal(twin.simplices, tri.simplices)
        tri.add_points(np.empty((0, 3)), restart=True)
        self.compare(tri, places, is_in)
        index = tri.renumber_points()
        np.testing.assert_array_equal(index, np.where(is_in, np.cumsum(is_in) - 1, -1))
        self.compare(tri, places[is_in], np.ones(is_in.sum(), dtype=bool))
        tri.add_points(random_points(50, 33))
        tri.check()
        self.assertEqual(tri.npoints, is_in.sum() + 50)
        self.assertEqual(pickle.loads(pickle.dumps(tri)).nsimplex, tri.nsimplex)

    def test_refused(self):
        tri = mgdt.Delaunay(random_points(50, 34), incremental=True)
        tri.remove_points([7])
        before = tri.simplices
        for wrong, words in (
            (lambda: tri.remove_points([7]), "point 7 is not in"),
            (lambda: tri.remove_points([3, 3]), "point 3 is to be removed twice"),
            (lambda: tri.remove_points([50]), "there is no point 50"),
            (lambda: tri.remove_points([-1]), "there is no point -1"),
            (lambda: tri.remove_points([2**40]), "there is no point 1099511627776"),
            (lambda: tri.remove_points([0.5]), "must be integers"),
            (lambda: tri.remove_points([[1, 2]]), "must be integers"),
            (lambda: tri.remove_points([True, False]), "the mask has shape"),
            (lambda: tri.move_points([[0, 0, 0]], [1, 2]), "2 points and 1 places"),
            (lambda: tri.move_points([[0, 0, 0]]), "50 points and 1 places"),
            (lambda: tri.move_points([[0, 0, 0], [0, np.nan, 0]], [1, 2]), "point 2 is NaN"),
        ):
            self.assertRaisesRegex(ValueError, words, wrong)
        np.testing.assert_array_equal(tri.simplices, before)
        tri.remove_points([])
        tri.move_points(np.empty((0, 3)), [])
        tri.close()
        for closed in (
            lambda: tri.remove_points([1]),
            lambda: tri.move_points([[0, 0, 0]], [1]),
            tri.renumber_points,
        ):
            self.assertRaisesRegex(RuntimeError, "incremental", closed)

    def test_cancelling(self):
        places = random_points(20_000, 35)
        tri = mgdt.Delaunay(places, incremental=True, canonical=True)
        tri.progress = lambda fraction: mgdt.CANCEL if fraction > 0.5 else None
        some = np.arange(0, 1000)
        some[::2] = np.arange(1000, 1500)
        with self.assertRaisesRegex(mgdt.Cancelled, "cancelled after 5.. of 1000 points"):
            tri.move_points(random_points(1000, 36), some)
        moved = (tri.points != places).any(axis=1)
        self.assertTrue(500 <= moved.sum() < 600)
        self.assertTrue(moved[some[: moved.sum()]].all())
        tri.progress = None
        self.compare(tri, tri.points, np.ones(20_000, dtype=bool))
        tri.progress = lambda fraction: mgdt.CANCEL if fraction > 0.5 else None
        with self.assertRaisesRegex(mgdt.Cancelled, "cancelled after 5.. of 1000 points"):
            tri.remove_points(some)
        tri.progress = None
        is_in = tri.point_map >= 0
        self.assertTrue(500 <= (~is_in).sum() < 600)
        self.compare(tri, tri.points, is_in)
        # Nor does a restart that is stopped bring them back.
        tri.progress = lambda fraction: mgdt.CANCEL if fraction > 0.5 else None
        with self.assertRaises(mgdt.Cancelled):
            tri.add_points(np.empty((0, 3)), restart=True)
        tri.progress = None
        self.assertTrue((tri.point_map[~is_in] == -1).all())
        self.compare(tri, tri.points, tri.point_map >= 0)


class Progress(unittest.TestCase):
    def test_fractions(self):
        seen = []
        tri = mgdt.Delaunay(random_points(20_000, 11), incremental=True, progress=seen.append)
        self.assertEqual((seen[0], seen[-1]), (0, 1))
        self.assertEqual(seen, sorted(seen))
        self.assertTrue(50 <= len(seen) <= 200)
        tri.progress = None
        tri.add_points(random_points(20_000, 12))
        self.assertEqual(seen[-1], 1)

    def test_cancelling(self):
        for at in (0.0, 0.3, 0.99):
            tri = mgdt.Delaunay(random_points(100, 13), incremental=True)
            tri.progress = lambda fraction: mgdt.CANCEL if fraction >= at else None
            with self.assertRaisesRegex(mgdt.Cancelled, "cancelled after .* of 20000 points"):
                tri.add_points(random_points(20_000, 14))
            tri.check()
            self.assertEqual(tri.npoints, 20_100)
            left_out = tri.point_map < 0
            self.assertEqual(int((~left_out).sum()), len(np.unique(tri.simplices)))
            self.assertAlmostEqual(left_out[100:].mean(), 1 - at, delta=0.02)
            self.assertEqual(len(tri.coplanar), 0)
            self.assertTrue((tri.vertex_to_simplex[left_out] == -1).all())
            twin = pickle.loads(pickle.dumps(tri))
            np.testing.assert_array_equal(twin.point_map, tri.point_map)
            self.assertEqual(twin.nsimplex, tri.nsimplex)
            # It goes on: the same points again, under new indices.
            tri.progress = None
            tri.add_points(tri.points[left_out])
            tri.check()
            self.assertEqual(tri.nsimplex, mgdt.Delaunay(tri.points[:20_100]).nsimplex)

    def test_results_that_mean_nothing(self):
        points = random_points(20_000, 23)
        for result in (True, 1, np.True_, "cancel", [0], mgdt.Cancelled, 0.5, False, None):
            seen = []
            tri = mgdt.Delaunay(points, progress=lambda f: seen.append(f) or result)
            self.assertEqual((seen[-1], tri.npoints), (1, 20_000))

    def test_progress_bars(self):
        class Bar:
            """As tqdm: `update` says True when it has drawn."""

            n = 0

            def update(self, count):
                self.n += count
                return True

        bars = [Bar()]
        try:
            from tqdm import tqdm

            bars.append(tqdm(total=1, file=io.StringIO(), mininterval=0))
        except ImportError:
            pass
        for bar in bars:
            self.assertIs(bar.update(0.0) or True, True)
            tri = mgdt.Delaunay(
                random_points(60_000, 24),
                incremental=True,
                progress=lambda fraction: bar.update(fraction - bar.n),
            )
            self.assertAlmostEqual(bar.n, 1)
            self.assertEqual(tri.statistics["points_inserted"], 60_000)
            tri.progress = bar.update
            tri.add_points(random_points(100, 25))
            self.assertEqual(tri.npoints, 60_100)

    def test_on_a_thread(self):
        errors = []

        def insert():
            try:
                mgdt.Delaunay(
                    random_points(20_000, 26), progress=lambda f: mgdt.CANCEL if f > 0.5 else True
                )
            except mgdt.Cancelled as error:
                errors.append(str(error))

        thread = threading.Thread(target=insert)
        thread.start()
        thread.join()
        self.assertIn("cancelled after", errors[0])

    def test_what_cancelled_until_1_1_is_told(self):
        # True after False is a program that means to cancel.
        with self.assertWarnsRegex(RuntimeWarning, r"return mgdt\.CANCEL"):
            mgdt.Delaunay(random_points(20_000, 27), progress=lambda fraction: fraction > 0.3)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaises(RuntimeWarning):
                mgdt.Delaunay(random_points(20_000, 27), progress=lambda fraction: fraction > 0.3)
            mgdt.Delaunay(random_points(20_000, 27), progress=lambda fraction: True)

    def test_the_word_for_it(self):
        self.assertEqual(repr(mgdt.CANCEL), "mgdt.CANCEL")
        self.assertIs(pickle.loads(pickle.dumps(mgdt.CANCEL)), mgdt.CANCEL)

    def test_an_exception_gets_through(self):
        tri = mgdt.Delaunay(random_points(100, 15), incremental=True)

        class Mine(Exception):
            pass

        def progress(fraction):
            if fraction > 0.5:
                raise Mine("at half")

        tri.progress = progress
        with self.assertRaisesRegex(Mine, "at half"):
            tri.add_points(random_points(20_000, 16))
        tri.check()
        tri.progress = None
        tri.add_points(random_points(10, 17))
        with self.assertRaises(Mine):
            mgdt.Delaunay(random_points(20_000, 16), progress=progress)

    def test_it_may_not_use_the_triangulation(self):
        tri = mgdt.Delaunay(random_points(100, 18), incremental=True)
        messages = []

        def progress(_):
            for use in (
                lambda: tri.nsimplex,
                lambda: tri.add_points([[0, 0, 0]]),
                lambda: tri.find_simplex([0, 0, 0]),
                tri.release,
            ):
                try:
                    use()
                except RuntimeError as error:
                    messages.append(str(error))

        tri.progress = progress
        tri.add_points(random_points(100, 19))
        self.assertTrue(messages and len(messages) % 4 == 0)
        self.assertEqual(len(set(messages)), 1)
        self.assertIn("progress function", messages[0])

    def test_it_may_cancel(self):
        tri = mgdt.Delaunay(random_points(100, 20), incremental=True)
        tri.progress = lambda fraction: tri.cancel() if fraction > 0.5 else None
        with self.assertRaises(mgdt.Cancelled):
            tri.add_points(random_points(20_000, 21))
        tri.progress = None
        tri.cancel()
        tri.add_points(random_points(20_000, 22))
        tri.check()


if __name__ == "__main__":
    unittest.main()
