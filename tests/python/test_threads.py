# SPDX-License-Identifier: MIT
"""Several Python threads: the interpreter lock is given up, and misuse waits or is refused."""

import os
import signal
import threading
import time
import unittest
from unittest import mock

import numpy as np
from support import random_points, row_set

import mgdt
from mgdt._gate import Gate


def together(*works):
    """Runs functions on threads of their own that start at the same time; gives their results."""
    results = [None] * len(works)
    barrier = threading.Barrier(len(works))

    def run(k, work):
        barrier.wait()
        try:
            results[k] = work()
        except BaseException as error:
            results[k] = error

    threads = [threading.Thread(target=run, args=item) for item in enumerate(works)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for result in results:
        if isinstance(result, BaseException):
            raise result
    return results


@unittest.skipUnless(hasattr(os, "fork"), "needs fork")
class Forks(unittest.TestCase):
    def in_child(self, work):
        """What the work raises or returns in a child of this process."""
        out, into = os.pipe()
        child = os.fork()
        if child == 0:
            signal.alarm(60)
            try:
                said = repr(work())
            except BaseException as error:
                said = f"{type(error).__name__}: {error}"
            os.write(into, said.encode())
            os._exit(0)
        os.close(into)
        with open(out, encoding="utf-8") as f:
            said = f.read()
        os.waitpid(child, 0)
        return said

    def test_while_another_thread_inserts(self):
        for many in (300_000, 30_000):
            tri = mgdt.Delaunay(random_points(1000, 21), incremental=True)
            inside, go_on = threading.Event(), threading.Event()

            def progress(fraction):
                inside.set()
                go_on.wait()

            tri.progress = progress
            thread = threading.Thread(target=lambda: tri.add_points(random_points(many, 22)))
            thread.start()
            inside.wait()
            for work in (lambda: tri.find_simplex([0.5, 0.5, 0.5]), lambda: tri.add_points([[2, 2, 2]])):
                self.assertRegex(self.in_child(work), "^BusyError: .*mgdt_insert_points")
            go_on.set()
            thread.join()
            tri.progress = None
            tri.check(1)
            # After the fork both are free.
            self.assertEqual(self.in_child(lambda: int(tri.find_simplex([9, 9, 9]))), "-1")

    def test_while_others_read(self):
        tri = mgdt.Delaunay(random_points(1000, 23), incremental=True)
        inside, go_on = threading.Event(), threading.Event()

        def read():
            with tri._gate.reading():
                inside.set()
                go_on.wait()

        thread = threading.Thread(target=read)
        thread.start()
        inside.wait()
        self.assertEqual(self.in_child(lambda: tri.add_points([[2, 2, 2]])), "None")
        go_on.set()
        thread.join()


class Threads(unittest.TestCase):
    def test_locating_in_one_object(self):
        points = random_points(20_000, 1)
        places = [random_points(100_000, seed) for seed in (2, 3, 4)]
        expected = [mgdt.Delaunay(points).locate(p) for p in places]
        # A fresh object: what is made on first use is made by several at once.
        tri = mgdt.Delaunay(points)
        works = [
            lambda p=p: (tri.locate(p), tri.simplices, tri.nearest_vertex(p[:500])) for p in places
        ]
        for ((found, weights), simplices, _), (e_found, e_weights) in zip(
            together(*works), expected
        ):
            np.testing.assert_array_equal(found, e_found)
            np.testing.assert_array_equal(weights, e_weights)
            np.testing.assert_array_equal(simplices, tri.simplices)

    def test_insertions_overlap(self):
        # The library's clock runs from an insertion's beginning to its end. If one waited for the
        # other, both would add up to less than what both took.
        sets = [random_points(200_000, seed) for seed in (5, 6)]
        begin = time.monotonic()
        one, two = together(*(lambda p=p: mgdt.Delaunay(p) for p in sets))
        total = time.monotonic() - begin
        seconds = [t.statistics["insert_seconds"] for t in (one, two)]
        self.assertGreater(sum(seconds), 1.2 * total, (seconds, total))
        one.check(1)
        two.check(1)

    def assert_others_run_during(self, work):
        """This thread comes to run again and again while another does the work."""
        thread = threading.Thread(target=work)
        ticks = 0
        begin = time.monotonic()
        thread.start()
        while thread.is_alive():
            ticks += 1
            time.sleep(0.001)
        milliseconds = 1000 * (time.monotonic() - begin)
        # Without a release of the interpreter lock it runs once before and once after.
        self.assertGreater(ticks, max(2, milliseconds / 30))

    def test_others_run_during_calls(self):
        points = random_points(300_000, 7)
        made = []
        self.assert_others_run_during(lambda: made.append(mgdt.Delaunay(points)))
        (tri,) = made
        places = random_points(300_000, 8)
        self.assert_others_run_during(lambda: tri.find_simplex(places))
        self.assert_others_run_during(lambda: tri.check(2))

    def test_readers_wait_for_a_writer(self):
        points = random_points(150_000, 9)
        tri = mgdt.Delaunay(points[:1000], incremental=True)
        sizes = []

        def read():
            while not sizes or sizes[-1][0] < len(points):
                sizes.append((tri.npoints, tri.nsimplex, len(tri.convex_hull)))
                tri.find_simplex(points[:10])
            return len(sizes)

        def write():
            for begin in range(1000, len(points), 29_800):
                tri.add_points(points[begin : begin + 29_800])

        together(write, read, read)
        tri.check()
        self.assertEqual(row_set(tri.simplices), row_set(mgdt.Delaunay(points).simplices))

    def test_writers_wait_for_each_other(self):
        sets = [random_points(500, seed) for seed in range(10, 14)]
        tri = mgdt.Delaunay(np.zeros((0, 3)), incremental=True)

        def add(points):
            for begin in range(0, len(points), 10):
                tri.add_points(points[begin : begin + 10])

        together(*(lambda p=p: add(p) for p in sets))
        tri.check()
        self.assertEqual(tri.npoints, 2000)
        self.assertEqual(row_set(tri.points), row_set(np.concatenate(sets)))
        # Each point has the index under which it is in.
        at = tri.find_simplex(tri.points)
        self.assertTrue((tri.simplices[at] == np.arange(2000)[:, None]).any(axis=1).all())

    def test_cancelling_from_another_thread(self):
        for inserts_on_main in (True, False):
            tri = mgdt.Delaunay(random_points(100, 15), incremental=True)
            many = random_points(2_000_000, 16)
            begun = threading.Event()
            errors = []

            def insert():
                begun.set()
                try:
                    tri.add_points(many)
                    errors.append("not cancelled")
                except mgdt.Cancelled as error:
                    errors.append(error)

            def cancel():
                begun.wait()
                while not errors:
                    time.sleep(0.001)
                    tri.cancel()

            work, other = (insert, cancel) if inserts_on_main else (cancel, insert)
            thread = threading.Thread(target=other)
            thread.start()
            work()
            thread.join()
            self.assertRegex(str(errors[0]), "cancelled (after|before)")
            tri.check(2)
            # The request is spent.
            tri.add_points(random_points(1000, 17))

    def test_progress_on_the_calling_thread(self):
        names = []
        work = lambda: mgdt.Delaunay(
            random_points(60_000, 18), progress=lambda _: names.append(threading.current_thread())
        )
        work()
        self.assertEqual(set(names), {threading.main_thread()})
        names.clear()
        thread = threading.Thread(target=work)
        thread.start()
        thread.join()
        self.assertEqual(set(names), {thread})

    def test_an_exception_on_another_thread(self):
        def progress(fraction):
            if fraction > 0.5:
                raise KeyError("mine")

        work = lambda: mgdt.Delaunay(random_points(60_000, 19), progress=progress)
        with self.assertRaises(KeyError):
            together(work, work)

    def test_release_waits_for_readers(self):
        tri = mgdt.Delaunay(random_points(50_000, 20))
        places = random_points(300_000, 21)
        expected = tri.find_simplex(places)
        begun = threading.Event()

        def locate():
            begun.set()
            return tri.find_simplex(places)

        def release():
            begun.wait()
            time.sleep(0.02)
            tri.release()

        try:
            found, _ = together(locate, release)
            np.testing.assert_array_equal(found, expected)
        except RuntimeError as error:
            # The release was first.
            self.assertIn("released", str(error))


class Rules(unittest.TestCase):
    """Who goes in while who is in."""

    def setUp(self):
        self.gate = Gate()
        self.threads = []
        self.addCleanup(lambda: [thread.join() for thread in self.threads])

    def enter(self, passage):
        """Goes in on a thread of its own; gives the events "is in" and "may go out"."""
        inside, leave = threading.Event(), threading.Event()

        def stay():
            with passage():
                inside.set()
                leave.wait(10)

        self.threads.append(threading.Thread(target=stay))
        self.threads[-1].start()
        return inside, leave

    def test_readers_together(self):
        (one, leave), (two, leave_too) = (self.enter(self.gate.reading) for _ in range(2))
        self.assertTrue(one.wait(5) and two.wait(5))
        leave.set()
        leave_too.set()

    def test_a_writer_alone(self):
        for first in (self.gate.reading, self.gate.writing):
            for second in (self.gate.reading, self.gate.writing):
                if first == second == self.gate.reading:
                    continue
                is_in, leave = self.enter(first)
                self.assertTrue(is_in.wait(5))
                is_in_too, leave_too = self.enter(second)
                self.assertFalse(is_in_too.wait(0.05))
                leave.set()
                self.assertTrue(is_in_too.wait(5))
                leave_too.set()
                self.threads[-1].join()

    def test_a_waiting_writer_goes_first(self):
        reading, stop_reading = self.enter(self.gate.reading)
        self.assertTrue(reading.wait(5))
        writing, stop_writing = self.enter(self.gate.writing)
        self.assertFalse(writing.wait(0.05))
        late, stop_late = self.enter(self.gate.reading)
        self.assertFalse(late.wait(0.05))
        stop_reading.set()
        self.assertTrue(writing.wait(5))
        self.assertFalse(late.is_set())
        stop_writing.set()
        self.assertTrue(late.wait(5))
        stop_late.set()

    def test_readers_that_were_left(self):
        is_left = threading.Event()
        reading, stop_reading = self.enter(lambda: self.gate.reading(is_left.is_set))
        self.assertTrue(reading.wait(5))
        taking, stop_taking = self.enter(lambda: self.gate.writing(beside_left=True))
        self.assertFalse(taking.wait(0.1))
        is_left.set()
        self.assertTrue(taking.wait(5))
        stop_taking.set()
        self.threads[-1].join()
        # Who changes the triangulation waits for them.
        writing, stop_writing = self.enter(self.gate.writing)
        self.assertFalse(writing.wait(0.1))
        # One that is left while it waits does not begin.
        with self.assertRaises(RuntimeError), self.gate.reading(lambda: True):
            pass
        stop_reading.set()
        self.assertTrue(writing.wait(5))
        stop_writing.set()

    def test_exceptions_open_it(self):
        for passage in (self.gate.reading, self.gate.writing):
            with self.assertRaises(KeyError), passage():
                raise KeyError
        # A writer that stops waiting leaves the way to others.
        is_in, leave = self.enter(self.gate.reading)
        self.assertTrue(is_in.wait(5))
        with mock.patch.object(self.gate._changed, "wait_for", side_effect=KeyboardInterrupt):
            with self.assertRaises(KeyboardInterrupt), self.gate.writing():
                pass
        # Also one that gives up.
        with self.gate.writing(gives_up=lambda: True) as got_in:
            self.assertFalse(got_in)
        with self.gate.reading():
            leave.set()
        self.threads[-1].join()

    def test_whom_the_writer_waits_for_is_refused(self):
        with self.gate.writing(), self.gate.keeping_out():
            for passage in (self.gate.reading, self.gate.writing):
                with self.assertRaisesRegex(RuntimeError, "progress") as raised, passage():
                    pass
                self.assertIsInstance(raised.exception, mgdt.BusyError)
                self.assertEqual(raised.exception.status, 41)
        with self.gate.reading():
            pass


if __name__ == "__main__":
    unittest.main()
