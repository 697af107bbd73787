#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""mgdt.ParallelDelaunay on ranks, beside mgdt.Delaunay of all points.

Usage: test_mpi.py MGDT, the program, which makes points; on ranks of MPI
"""
import re
import signal
import subprocess
import sys
import tempfile

import mgdt
import numpy as np
from mgdt import _transport
from mpi4py import MPI

sys.dont_write_bytecode = True
comm = MPI.COMM_WORLD
rank, ranks = comm.Get_rank(), comm.Get_size()
failures = 0


def check(condition, what):
    global failures
    if not condition:
        failures += 1
        print(f"rank {rank}: failed: {what}", flush=True)


def raises(kind, words, call):
    try:
        call()
        check(False, f"nothing raised: {words}")
    except kind as error:
        check(words in str(error), f"{error!r} does not say {words!r}")


def compare(points, pieces):
    """All ranks together have the tetrahedra of one."""
    one = mgdt.Delaunay(points)
    mine = np.arange(len(points))[rank::ranks]
    with mgdt.ParallelDelaunay(points[mine], ids=mine) as t:
        t.check()
        ids, own = t.vertex_ids, t.own_simplices
        check((t.points == points[ids]).all(), "coordinates and ids")
        found = np.concatenate(comm.allgather(np.sort(ids[t.simplices[:own]], axis=1)))
        expected = np.sort(one.simplices, axis=1)
        check(sorted(map(tuple, found)) == sorted(map(tuple, expected)), f"tetrahedra, {pieces}")
        check(t.number("all_tetrahedra") == len(expected), "their number")
        numbers, ranges = t.vertex_numbers, t.vertex_ranges
        check((numbers[:t.own_vertices] == np.arange(ranges[rank], ranges[rank + 1])).all(), "own numbers")
        owners = t.vertex_owners
        check((ranges[owners] <= numbers).all() and (numbers < ranges[owners + 1]).all(), "owners")
        check((t.simplex_owners[:own] == rank).all() and not (t.simplex_owners[own:] == rank).any(), "owned")
        check((t.simplex_numbers[:own] == np.arange(*t.simplex_ranges[rank:rank + 2])).all(), "numbers")
        neighbors = np.concatenate(comm.allgather(t.neighbors))
        inner = np.argwhere(neighbors >= 0)
        back = neighbors[neighbors[inner[:, 0], inner[:, 1]]]
        check((back == inner[:, :1]).sum(axis=1).all(), "neighbours are mutual")
        check(len(t.point_map) == len(mine), "the point map")
    raises(ValueError, "closed", t.check)


points = np.random.default_rng(5).random((400, 3))
compare(points, "whole")
_transport.LARGEST_MESSAGE = 1000
compare(points, "in pieces")
_transport.LARGEST_MESSAGE = 1 << 30
lattice = np.stack(np.meshgrid(*[range(6)] * 3), -1).reshape(-1, 3).astype(float)
compare(lattice, "lattice")

# Points of every kind that the program makes.
program = sys.argv[1]
kinds = re.search(r"^Kinds:\n((?:  .*\n)+)", subprocess.run([program, "generate", "--help"], capture_output=True, text=True, check=True).stdout, re.M)
kinds = [line.split()[0] for line in kinds.group(1).splitlines()]
check(len(kinds) > 20, "kinds of points")
with tempfile.TemporaryDirectory() as folder:
    for kind in kinds:
        made = subprocess.run([program, "generate", "-q", kind, "300", "-o", f"{folder}/{kind}.npy"], check=False)
        check(made.returncode == 0, f"points of kind {kind}")
        if kind not in ("nan", "infinity"):
            compare(np.load(f"{folder}/{kind}.npy"), kind)

# Nothing on some ranks, and nothing at all.
with mgdt.ParallelDelaunay(points if rank == ranks - 1 else []) as t:
    check(t.number("all_vertices") == 400, "all from one rank")
with mgdt.ParallelDelaunay(np.empty((0, 3)), comm) as t:
    check(t.simplices.shape == (0, 4), "no points")

# What is wrong on one rank is raised on all.
last = rank == ranks - 1
bad = points.copy()
bad[7, 1] = np.nan
raises(mgdt.ArgumentError, "coordinate y of point 7 is", lambda: mgdt.ParallelDelaunay(bad if last else points + rank))
if last:
    raises(ValueError, "shape (n, 3)", lambda: mgdt.ParallelDelaunay(points[:, :2]))
else:
    raises(mgdt.Error, f"part {ranks - 1}: ", lambda: mgdt.ParallelDelaunay(points + rank))
if last:
    raises(ValueError, "ids must have", lambda: mgdt.ParallelDelaunay(points, ids=[1, 2]))
else:
    raises(mgdt.Error, f"part {ranks - 1}: ", lambda: mgdt.ParallelDelaunay(points + rank, ids=range(400)))
raises(MemoryError, "out of memory", lambda: mgdt.ParallelDelaunay(points, memory_limit=20000 if last else 0))
raises(mgdt.ArgumentError, "id 3 is given to two points",
       lambda: mgdt.ParallelDelaunay(points[2 * rank:2 * rank + 2], ids=[3, 3]))

# Progress, and its ways to stop all.
fractions = []
with mgdt.ParallelDelaunay(points + rank, progress=fractions.append) as t:
    check(fractions == sorted(fractions) and fractions[-1] == 1 and fractions[0] < 1, f"progress: {fractions[:9]}")


def stops(kind, progress):
    """It stops the last rank with an exception of this kind, and the others, by whatever was theirs."""
    raises(kind if last else mgdt.Cancelled, "", lambda: mgdt.ParallelDelaunay(points + rank, progress=progress if last else None))


def fails(fraction):
    raise ZeroDivisionError(fraction)


stops(mgdt.Cancelled, lambda fraction: mgdt.CANCEL)
stops(ZeroDivisionError, fails)
stops(KeyboardInterrupt, lambda fraction: signal.raise_signal(signal.SIGINT))
with mgdt.ParallelDelaunay(points + rank) as t:
    t.check()
total = comm.allreduce(failures)
if rank == 0:
    print(f"{ranks} ranks: {total} failures")
sys.exit(1 if total else 0)
