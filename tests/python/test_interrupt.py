# SPDX-License-Identifier: MIT
"""Ctrl-C and other signals during long calls, in processes of their own."""

import _thread
import os
import signal
import subprocess
import sys
import threading
import time
import unittest
from unittest import mock

import mgdt
import numpy as np
from mgdt._gate import interruptibly
from mgdt._insertion import Insertion
from mgdt._diagram import lists

# What the children have in common. A child says when its call begins and how long the call takes when
# nobody interrupts it, so that the signal comes within the call on a slow machine and on a fast one.
# Whether the call was interrupted is read off the triangulation, not off a clock.
PRELUDE = """
import signal, sys, time
import numpy as np
import mgdt

signal.signal(signal.SIGINT, signal.default_int_handler)  # also where the parent ignores it
rng = np.random.default_rng(1)
tri = mgdt.Delaunay(rng.random((1000, 3)), incremental=True)
many = rng.random((1_000_000, 3))

def seconds(work):
    begin = time.monotonic()
    work()
    return time.monotonic() - begin

def ready(usual=None):
    if usual is None:
        usual = len(many) / 100_000 * seconds(lambda: mgdt.Delaunay(many[:100_000]))
    print("ready", usual, flush=True)

def caught():
    print("caught", flush=True)

def still_valid():
    tri.check(2)
    inside = int((tri.point_map >= 0).sum())
    assert 1000 <= inside < tri.npoints == 1000 + len(many), (inside, tri.npoints)
    # A request to stop that nobody heard would stop this one.
    tri.add_points(rng.random((1000, 3)))
    assert int((tri.point_map >= 0).sum()) == inside + 1000
    tri.check(1)
    print("valid", flush=True)
"""


class Child:
    """A process that inserts points, and what it says."""

    def __init__(self, program):
        self.process = subprocess.Popen(
            [sys.executable, "-c", PRELUDE + program],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.communicate()

    def wait_for(self, share):
        """Waits until that share of the call is done."""
        word, *usual = self.line().split()
        assert word == "ready", (word, usual)
        time.sleep(share * float(usual[0]))

    def line(self):
        line = self.process.stdout.readline()
        return line if line else self.process.stderr.read()

    def send(self, number=signal.SIGINT):
        os.kill(self.process.pid, number)

    def end(self):
        # Not communicate(), which does not know what line() has read ahead.
        out, errors = self.process.stdout.read(), self.process.stderr.read()
        return self.process.wait(timeout=60), out, errors


class Requests(unittest.TestCase):
    """When a request to stop goes to the library, which keeps one that comes outside a call."""

    def insertion(self, progress=None):
        sent = []
        insertion = Insertion(progress)
        insertion.attach(lambda: sent.append(1))
        return insertion, sent

    def test_before_the_first_report(self):
        insertion, sent = self.insertion()
        insertion.stop()
        self.assertEqual((sent, insertion.report(0.0)), ([], 1))

    def test_within(self):
        insertion, sent = self.insertion()
        self.assertEqual(insertion.report(0.0), 0)
        insertion.stop()
        self.assertEqual((sent, insertion.report(0.5)), ([1], 1))
        # Once: the call may have heeded the first and returned.
        insertion.stop()
        self.assertEqual(sent, [1])

    def test_when_the_progress_function_has_stopped_it(self):
        insertion, sent = self.insertion(
            lambda fraction: mgdt.CANCEL if fraction > 0.3 else None
        )
        self.assertEqual([insertion.report(f) for f in (0.0, 0.5)], [0, 1])
        insertion.stop()
        self.assertEqual(sent, [])

    def test_when_the_call_has_failed(self):
        insertion, sent = self.insertion()
        insertion.report(0.0)
        insertion.detach()
        insertion.stop()
        self.assertEqual(sent, [])

    def test_after_the_last_report(self):
        insertion, sent = self.insertion()
        for fraction in (0.0, 0.5, 1.0):
            self.assertEqual(insertion.report(fraction), 0)
        insertion.stop()
        self.assertEqual(sent, [])

    def test_a_call_not_yet_begun_is_not_made(self):
        insertion, _ = self.insertion()
        made = []
        with mock.patch("_thread.start_new_thread") as start, self.assertRaises(KeyboardInterrupt):
            # The signal comes when the thread is on its way but has not begun.
            start.side_effect = KeyboardInterrupt
            insertion.run(lambda: made.append(1), 10**6)
        start.call_args.args[0]()
        self.assertEqual(made, [])

    def test_what_the_call_raises(self):
        insertion, _ = self.insertion()
        with self.assertRaises(ZeroDivisionError):
            insertion.run(lambda: 1 // 0, 10**6)


class Aside(unittest.TestCase):
    """Long reading, by a thread of its own."""

    def test_what_the_work_gives_and_raises(self):
        for is_long in (False, True):
            ident = interruptibly(lambda _: threading.get_ident(), is_long)
            self.assertEqual(ident == threading.get_ident(), not is_long)
            with self.assertRaises(ZeroDivisionError):
                interruptibly(lambda _: 1 // 0, is_long)

    def test_on_another_thread_it_stays(self):
        idents = []

        def run():
            idents.append(interruptibly(lambda _: threading.get_ident(), True))

        thread = threading.Thread(target=run)
        thread.start()
        thread.join()
        self.assertEqual(idents, [thread.ident])

    def test_without_threads(self):
        with mock.patch("_thread.start_new_thread", side_effect=RuntimeError("no more")):
            ident = interruptibly(lambda _: threading.get_ident(), True)
        self.assertEqual(ident, threading.get_ident())

    def test_the_work_hears_that_it_is_left(self):
        flags = []
        with mock.patch("_thread.start_new_thread") as start, self.assertRaises(KeyboardInterrupt):
            start.side_effect = KeyboardInterrupt
            interruptibly(lambda is_left: flags.append(is_left()), True)
        start.call_args.args[0]()
        self.assertEqual(flags, [True])


class Snapshots(unittest.TestCase):
    """What takes long of a diagram and of a shape is done aside, so that Ctrl-C is heard at once."""

    @staticmethod
    def threads_begun_by(work):
        begin = _thread.start_new_thread
        with mock.patch("_thread.start_new_thread", side_effect=begin) as start:
            work()
        return start.call_count

    def test_long_work_is_done_aside(self):
        points = np.random.default_rng(1).random((25_000, 3))
        made = []
        self.assertGreaterEqual(self.threads_begun_by(lambda: made.append(mgdt.Voronoi(points))), 2)
        self.assertGreaterEqual(self.threads_begun_by(lambda: made.append(mgdt.AlphaShape(points))), 1)
        diagram, shape = made
        names = ["regions", "ridge_vertices", "ridge_dict", "neighbors", "areas"]
        for thing, name in [(diagram, n) for n in names] + [(shape, "volume"), (shape, "area")]:
            with self.subTest(name=name):
                self.assertEqual(self.threads_begun_by(lambda: getattr(thing, name)), 1)
                self.assertEqual(self.threads_begun_by(lambda: getattr(thing, name)), 0)

    def test_lists_end_when_they_are_left(self):
        offsets = np.arange(100_001)
        asked = []

        def is_left():
            asked.append(1)
            return len(asked) == 3

        self.assertLess(len(lists(np.arange(100_000), offsets, is_left)), 50_000)
        whole = lists(np.arange(100_000), offsets, lambda: False)
        self.assertEqual(whole, [[i] for i in range(100_000)])
        self.assertEqual(lists(np.arange(0), np.zeros(1, int), lambda: False), [])
        self.assertEqual(lists(np.arange(3), np.array([0, 0, 3, 3]), lambda: False), [[], [0, 1, 2], []])


class Interrupts(unittest.TestCase):
    def interrupted(self, program, number=signal.SIGINT, times=1, after=0.3):
        with Child(program) as child:
            child.wait_for(after)
            child.send(number)
            for _ in range(times - 1):
                time.sleep(0.002)
                child.send(number)
            self.assertEqual(child.line(), "caught\n")
            code, out, errors = child.end()
            self.assertEqual((code, out, errors), (0, "valid\n", ""))

    def test_ctrl_c(self):
        self.interrupted(
            """
ready()
try:
    tri.add_points(many)
except KeyboardInterrupt:
    caught()
still_valid()
"""
        )

    def test_ctrl_c_while_points_are_ordered(self):
        self.interrupted(
            """
ready()
try:
    tri.add_points(many)
except KeyboardInterrupt:
    caught()
still_valid()
""",
            after=0.02,
        )

    def test_ctrl_c_with_a_progress_function(self):
        self.interrupted(
            """
ready()
fractions = []
tri.progress = fractions.append
try:
    tri.add_points(many)
except KeyboardInterrupt:
    caught()
assert fractions and fractions[-1] < 1
tri.progress = None
still_valid()
"""
        )

    def test_impatience(self):
        # The later signals raise in add_points alone, too: they may come when it has already ended.
        self.interrupted(
            """
def press(number, frame):
    while frame:
        if frame.f_code.co_name == "add_points":
            raise KeyboardInterrupt
        frame = frame.f_back
signal.signal(signal.SIGINT, press)
ready()
try:
    tri.add_points(many)
    print("not interrupted")
except KeyboardInterrupt:
    caught()
still_valid()
""",
            times=5,
        )

    def test_great_impatience(self):
        # Signals all the time, also when the insertion begins and ends, and while it is being
        # stopped, so that some get past everything. Whatever they cut short, the object agrees with
        # itself, and goes on. They raise in add_points alone: no program can do anything if they do
        # so everywhere.
        with Child(
            """
class Alarm(Exception):
    pass
def ring(number, frame):
    while frame:
        if frame.f_code.co_name == "add_points":
            raise Alarm
        frame = frame.f_back
many = rng.random((100_000, 3))
signal.signal(signal.SIGALRM, ring)
stopped = 0
for k in range(60):
    tri = mgdt.Delaunay(rng.random((10, 3)), incremental=True)
    signal.setitimer(signal.ITIMER_REAL, 0.0001 + 0.003 * k, 0.0002)
    try:
        tri.add_points(many)
    except Alarm:
        stopped += 1
    signal.setitimer(signal.ITIMER_REAL, 0)
    before = int((tri.point_map >= 0).sum())
    assert tri.npoints in (10, 100_010), tri.npoints
    assert len(tri.point_map) == tri.npoints
    tri.add_points(rng.random((10, 3)))
    assert int((tri.point_map >= 0).sum()) == before + 10
    tri.check(1)
assert stopped >= 10, stopped
print("valid")
"""
        ) as child:
            # Python complains of what it cannot raise; the status and the assertions count.
            code, out, errors = child.end()
            self.assertEqual((code, out), (0, "valid\n"), errors)

    def test_another_signal_whose_handler_raises(self):
        self.interrupted(
            """
def stop(number, frame):
    sys.exit(0)
signal.signal(signal.SIGTERM, stop)
ready()
try:
    tri.add_points(many)
except SystemExit:
    caught()
still_valid()
""",
            number=signal.SIGTERM,
        )

    def test_a_handler_that_does_not_raise(self):
        with Child(
            """
def handle(number, frame):
    assert tri._running is not None, "the insertion had ended"
    caught()
signal.signal(signal.SIGUSR1, handle)
many = many[:600_000]
ready()
tri.add_points(many)
print("end", flush=True)
tri.check(1)
assert (tri.point_map >= 0).all()
"""
        ) as child:
            child.wait_for(0.3)
            child.send(signal.SIGUSR1)
            self.assertEqual(child.line(), "caught\n")
            self.assertEqual(child.end(), (0, "end\n", ""))

    def test_unhandled_it_ends_the_program(self):
        with Child("ready()\nmgdt.Delaunay(many)\n") as child:
            child.wait_for(0.3)
            child.send()
            code, _, errors = child.end()
            self.assertEqual(code, -signal.SIGINT)
            self.assertTrue(errors.rstrip().endswith("KeyboardInterrupt"), errors)

    def test_while_memory_is_freed(self):
        # As long as that takes: a handle's destruction calls no Python, so the handler runs at its end.
        with Child(
            """
from mgdt import _library
destroy = _library.library.mgdt_destroy
class Library:
    def __getattr__(self, name):
        return getattr(_library.library, name)
    def mgdt_destroy(self, pointer):
        destroy(pointer)
        signal.raise_signal(signal.SIGINT)
caught = 0
for k in range(20):
    tri = mgdt.Delaunay(many[:100])
    tri._handle._library = Library()
    try:
        del tri
        for _ in range(1000):
            time.sleep(0.01)
    except KeyboardInterrupt:
        caught += 1
assert caught == 20, caught
print("valid")
"""
        ) as child:
            self.assertEqual(child.end(), (0, "valid\n", ""))

    def test_between_blocks_of_locations(self):
        self.interrupted(
            """
many = many[:1000]
queries = rng.random((20_000_000, 3))
# Without weights: a C library that fills fresh memory takes long for theirs.
ready(20 * seconds(lambda: tri.locate(queries[:1_000_000], weights=False)))
try:
    tri.locate(queries, weights=False)
    print("not interrupted")
except KeyboardInterrupt:
    assert tri._gate._readers, "the call had ended"
    caught()
tri.check()
print("valid")
"""
        )

    READING = "tri.add_points(many[:200_000])\n"
    AFTERWARDS = """
assert len(tri.point_map) == tri.npoints == 201_000
# Who changes the triangulation waits for the call.
tri.add_points(rng.random((1000, 3)))
assert (tri.point_map >= 0).all()
assert tri.locate(many[:10])[0].min() >= 0
tri.check(1)
print("valid", flush=True)
"""

    def test_a_check(self):
        self.interrupted(
            self.READING
            + """
ready(seconds(tri.check))
try:
    tri.check()
    print("not interrupted")
except KeyboardInterrupt:
    assert tri._gate._readers, "the check had ended"
    caught()
"""
            + self.AFTERWARDS
        )

    def test_a_check_of_what_is_then_dropped(self):
        # The call holds the triangulation until it ends.
        for end in ("", "other = tri._handle; tri = None", "tri.release()"):
            self.interrupted(
                self.READING
                + f"""
ready(seconds(tri.check))
gate = tri._gate
try:
    with tri:
        tri.check()
    print("not interrupted")
except KeyboardInterrupt:
    caught()
{end}
assert gate._readers, "the check had ended"
tri = mgdt.Delaunay(rng.random((1000, 3)))
tri.check()
print("valid")
"""
            )

    def test_a_location_and_an_export(self):
        for call in ("tri.locate(queries)", "tri.interpolate(queries[:, 0], queries)", "tri.edges"):
            self.interrupted(
                self.READING
                + f"""
queries = rng.random((tri.npoints, 3))
def call():
    {call}
    tri._cache = {{}}
ready(25 * seconds(call))
try:
    for _ in range(25):
        call()
    print("not interrupted")
except KeyboardInterrupt:
    caught()
"""
                + self.AFTERWARDS
            )

    def test_an_unhandled_one_ends_a_check(self):
        with Child(self.READING + "ready(seconds(tri.check))\ntri.check()\n") as child:
            child.wait_for(0.3)
            child.send()
            code, _, errors = child.end()
            self.assertEqual(code, -signal.SIGINT)
            self.assertTrue(errors.rstrip().endswith("KeyboardInterrupt"), errors)

    def test_another_check_from_a_progress_function(self):
        # It would wait for the insertion, which waits for it.
        with Child(
            """
def progress(fraction):
    try:
        tri.check()
    except RuntimeError as error:
        assert "progress function" in str(error), error
        return mgdt.CANCEL
tri.add_points(many[:50_000])
tri.progress = progress
try:
    tri.add_points(many[:1000])
except mgdt.Cancelled:
    print("valid")
"""
        ) as child:
            self.assertEqual(child.end(), (0, "valid\n", ""))

    def test_checks_at_any_moment(self):
        with Child(
            """
many = many[:30_000]
class Alarm(Exception):
    pass
def ring(number, frame):
    raise Alarm
tri = mgdt.Delaunay(many, incremental=True)
begin = time.monotonic()
tri.check()
usual = time.monotonic() - begin
signal.signal(signal.SIGALRM, ring)
stopped = finished = 0
for k in range(60):
    try:
        try:
            signal.setitimer(signal.ITIMER_REAL, usual * (0.02 + 1.2 * k / 60))
            tri.check()
            finished += 1
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
    except Alarm:
        stopped += 1
    if k % 10 == 0:
        tri.add_points(rng.random((10, 3)))
assert stopped >= 10, (stopped, finished)
tri.check()
print("valid")
"""
        ) as child:
            self.assertEqual(child.end(), (0, "valid\n", ""))

    def test_at_any_moment(self):
        # Signals at all phases of insertions that last about as long as the signals are apart:
        # before, within, at the very end, after. A request to stop must never reach the next call.
        with Child(
            """
many = rng.random((60_000, 3))
class Alarm(Exception):
    pass
def ring(number, frame):
    raise Alarm
begin = time.monotonic()
mgdt.Delaunay(many)
usual = time.monotonic() - begin
signal.signal(signal.SIGALRM, ring)
stopped = finished = 0
for k in range(60):
    tri = mgdt.Delaunay(rng.random((10, 3)), incremental=True)
    tri.progress = None if k % 3 else (lambda fraction: None)
    try:
        try:
            signal.setitimer(signal.ITIMER_REAL, usual * (0.02 + 1.2 * k / 60))
            tri.add_points(many)
            finished += 1
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
    except Alarm:
        stopped += 1
    before = int((tri.point_map >= 0).sum())
    tri.add_points(rng.random((10, 3)))
    assert int((tri.point_map >= 0).sum()) == before + 10
    if k % 10 == 0:
        tri.check(2)
assert stopped >= 10, (stopped, finished)
print("valid")
"""
        ) as child:
            self.assertEqual(child.end(), (0, "valid\n", ""))


if __name__ == "__main__":
    unittest.main()
