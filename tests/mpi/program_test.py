#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""mgdt-mpi: what ranks read and write together is what mgdt triangulates alone.

Usage: program_test.py MPIEXEC MGDT-MPI MGDT [unittest arguments]
"""

import os
import re
import subprocess
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
sys.path.append(str(Path(__file__).resolve().parents[1] / "cli"))
import cli_test
import numpy as np
from parts_test import Pieces


class Ranks(Pieces):
    def ranks(self, count, *arguments, code=0, data=None, says=""):
        done = subprocess.run([MPIEXEC, "-n", str(count), MGDT_MPI, *map(str, arguments)], input=data, cwd=self.directory,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120, check=False)
        self.said, errors = done.stdout.decode(), done.stderr.decode()
        self.assertEqual(done.returncode, code, errors)
        messages = [line for line in errors.split("\n") if line.startswith("mgdt: ")]
        self.assertEqual(len(messages), 0 if code == 0 else 1, errors)
        if code != 0:
            self.assertIn(says, messages[0])

    def same(self, count, name, *arguments, **options):
        self.ranks(count, name, "-o", "out.pvtu", *arguments, **options)
        names, pieces = self.pieces("out.pvtu")
        self.assertEqual(len(names), count)
        found = self.tetrahedra(pieces)
        self.assertRegex(self.said, rf"\b{len(found)} tetrahedr\w+, {count} rank")
        return found

    def test_the_one_triangulation(self):
        for kind, n, ranks in (("uniform", 3000, 4), ("lattice", 1000, 3), ("galaxy", 2000, 1), ("uniform", 5, 4)):
            with self.subTest(kind=kind):
                self.mgdt("generate", "-q", kind, n, "-o", "points.npy")
                self.assertEqual(self.same(ranks, "points.npy", "--check", 3), self.expected("points.npy"))
                self.assertIn("check at level 3 passed", self.said)

    def test_formats(self):
        points = np.random.default_rng(1).random((500, 3)).astype("f4")
        np.save(self.path("little.npy"), points.astype("<f8"))
        expected = self.expected("little.npy")
        np.save(self.path("big.npy"), points.astype(">f8"))
        np.save(self.path("short.npy"), points)
        np.save(self.path("columns.npy"), np.asfortranarray(points))
        points.astype("<f8").tofile(self.path("bare.f64"))
        self.mgdt("triangulate", "-q", "little.npy", "-o", "mesh.msh")
        for name in ("big.npy", "short.npy", "columns.npy", "bare.f64", "mesh.msh"):
            with self.subTest(name=name):
                self.assertEqual(self.same(3, name), expected)
        self.assertIn("out_2.vtu", self.names())
        self.assertEqual(self.same(2, "-", data=self.get("little.npy")), expected)
        self.assertNotIn("out_2.vtu", self.names())  # of the three ranks before

    def test_no_points(self):
        np.save(self.path("none.npy"), np.zeros((0, 3)))
        self.assertEqual(self.same(2, "none.npy"), [])
        self.put("empty.xyz", "")
        self.ranks(2, "empty.xyz", "-o", "out2.pvtu", code=3, says="is empty")
        self.assertEqual(self.same(2, "empty.xyz", "--allow-empty"), [])

    def test_failures_are_those_of_all_and_said_once(self):
        points = np.random.default_rng(1).random((20000, 3))
        np.save(self.path("points.npy"), points)
        points[15000, 1] = np.nan
        np.save(self.path("bad.npy"), points)
        begin = len(self.get("bad.npy")) - points.nbytes
        self.put("cut.npy", self.get("points.npy")[:-5])
        self.put("half.f64", b"12345")
        before = self.names()
        # The place in the file, though the rank has read a part of it.
        self.ranks(4, "bad.npy", "-o", "out.pvtu", code=3, says=f"byte {begin + 8 * (3 * 15000 + 1)}: a coordinate is not")
        self.ranks(2, "cut.npy", "-o", "out.pvtu", code=3, says="cut short")
        self.ranks(2, "half.f64", "-o", "out.pvtu", code=3, says="no whole number of points")
        self.ranks(2, "nothing.npy", "-o", "out.pvtu", code=3, says="check the name")
        self.ranks(2, "points.npy", "-o", "out.pvtu", "--memory-limit", "1MB", code=5, says="out of memory")
        self.ranks(2, "points.npy", "-o", "nowhere/out.pvtu", code=4, says="nowhere")
        self.ranks(2, "points.npy", "-o", "out.vtu", code=2, says="say -o FILE.pvtu")
        self.ranks(2, "points.npy", code=2, says="nothing to do")
        self.ranks(2, "points.npy", "-o", "out.pvtu", "--scheme", "random", code=2, says="--scheme")
        self.assertEqual(self.names(), before)

    def test_the_input_stays(self):
        self.mgdt("generate", "-q", "uniform", 100, "-o", "points.npy")
        for name in ("m_0.vtu", "m_1.vtu"):
            self.mgdt("triangulate", "-q", "points.npy", "-o", name)
            before = self.get(name)
            self.ranks(2, name, "-o", "m.pvtu", code=2, says="would overwrite the input")
            self.assertEqual(self.get(name), before)
            os.remove(self.path(name))

    def test_a_pipe_with_a_name(self):
        self.mgdt("generate", "-q", "uniform", 20000, "-o", "points.f64")
        os.mkfifo(self.path("pipe.f64"))
        # In pieces that a pipe holds: the writer waits for its reader.
        writer = subprocess.Popen(["sh", "-c", "cat points.f64 >pipe.f64"], cwd=self.directory)
        found = self.same(2, "pipe.f64")
        writer.wait(timeout=60)
        self.assertEqual(found, self.expected("points.f64"))

    def test_help(self):
        self.ranks(2, "--help")
        self.assertEqual(self.said.count("--memory-limit"), 1)
        self.ranks(2, "--version")
        self.assertTrue(re.fullmatch(r"mgdt-mpi [\d.]+ \(ABI \d+\)\n", self.said), self.said)


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    MPIEXEC, MGDT_MPI, cli_test.MGDT = map(os.path.abspath, sys.argv[1:4])
    del sys.argv[1:4]
    unittest.main()
