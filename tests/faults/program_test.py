#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The program on files that fail: every call on files, short and interrupted reads and writes, and
inputs that are cut and changed, with bounded memory.

Usage: program_test.py MGDT FAILING_FILES_LIBRARY [unittest arguments]
"""

import errno
import os
import random
import resource
import shutil
import subprocess
import sys
import tempfile
import unittest

MGDT = SHIM = ""
SMALL = os.environ.get("MGDT_TEST_SMALL", "0") not in ("", "0")
OUTPUTS = [["m.vtu"], ["m.msh"], ["m.msh", "--to", "gmsh2"], ["m.ele"],
           ["m.npy", "--neighbors", "n.npy"]]
MESHES = {"m.vtu": [], "m.msh": [], "m2.msh": ["--to", "gmsh2"], "m.ele": []}
POINTS = ["p.npy", "p.xyz", "p.csv", "p.f64", "p.ply", "p.node"]


class FilesTest(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.mkdtemp(prefix="mgdt-files-")
        self.addCleanup(shutil.rmtree, self.directory)

    def path(self, name):
        return os.path.join(self.directory, name)

    def files(self):
        found = {}
        for name in os.listdir(self.directory):
            with open(self.path(name), "rb") as f:
                found[name] = f.read()
        return found

    def run_mgdt(self, *arguments, fault=None, **options):
        """Runs the program; returns its exit code, what it said, and whether the fault happened."""
        environment = dict(os.environ)
        happened = self.directory + "-happened"
        if fault is not None:
            environment.update(LD_PRELOAD=SHIM, MGDT_FAULT=fault, MGDT_FAULT_COUNT=happened)
        done = subprocess.run([MGDT, *map(str, arguments)], cwd=self.directory, env=environment,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120,
                              check=False, **options)
        reached = os.path.exists(happened)
        if reached:
            os.remove(happened)
        return done.returncode, done.stderr.decode(errors="replace"), reached

    def good(self, *arguments, **options):
        code, said, reached = self.run_mgdt(*arguments, **options)
        self.assertEqual(code, 0, said)
        return reached


class FailingCalls(FilesTest):
    def setUp(self):
        super().setUp()
        self.good("generate", "uniform", 200, "-o", "p.npy")

    def every_call(self, call, error, code, names, *arguments, may_succeed=False):
        """Fails the N-th of the calls, for every N."""
        before = self.files()
        for nth in range(1, 100):
            got, said, reached = self.run_mgdt(*arguments, fault=f"{call} {nth} {error}")
            if not reached:
                self.assertEqual(got, 0, said)
                break
            if got == 0 and may_succeed:
                for name in set(self.files()) - set(before):
                    os.remove(self.path(name))
                for name, content in before.items():
                    with open(self.path(name), "wb") as f:
                        f.write(content)
                continue
            self.assertEqual(got, code, (call, nth, said))
            self.assertTrue(said.startswith("mgdt: ") and said.count("\n") == 1, said)
            self.assertTrue(any(name in said for name in names), (call, nth, said))
            self.assertIn(os.strerror(error), said)
            self.assertEqual(self.files(), before, (call, nth, arguments))
        self.assertGreater(nth, 1, f"{call} is not called")

    def test_output(self):
        for output in OUTPUTS:
            for old in (False, True):
                for name in set(self.files()) - {"p.npy"}:
                    os.remove(self.path(name))
                names = [output[0].split(".")[0], "n.npy"]
                if old:
                    with open(self.path(output[0]), "w", encoding="ascii") as f:
                        f.write("old")
                for call, error in (("mkostemp", errno.ENOSPC), ("write", errno.ENOSPC),
                                    ("write", errno.EIO), ("fsync", errno.EIO)):
                    with self.subTest(output=output, call=call, old=old):
                        self.every_call(call, error, 4, names, "triangulate", "p.npy", "-o", *output)
                        for name in set(self.files()) - {"p.npy", output[0]}:
                            os.remove(self.path(name))
                        if old:
                            with open(self.path(output[0]), "w", encoding="ascii") as f:
                                f.write("old")
                        elif os.path.exists(self.path(output[0])):
                            os.remove(self.path(output[0]))

    def test_values(self):
        with open(self.path("s.csv"), "w", encoding="ascii") as f:
            f.write("x,y,z,t\n0,0,0,1\n2,0,0,2\n0,2,0,3\n0,0,2,4\n")
        for output in "o.vtu", "o.csv", "o.npy":
            for call, error in ("write", errno.ENOSPC), ("fsync", errno.EIO), ("rename", errno.EIO):
                self.every_call(call, error, 4, [output], "interpolate", "s.csv", "p.npy", "-o", output)
                os.remove(self.path(output))
        self.every_call("read", errno.EIO, 3, ["s.csv", "p.npy"], "interpolate", "s.csv", "p.npy",
                        "-o", "o.csv")

    def test_close(self):
        """That of the input does not matter; where the output's fails, nothing is left."""
        self.every_call("close", errno.EIO, 4, ["m.vtu"], "triangulate", "p.npy", "-o", "m.vtu",
                        may_succeed=True)

    def test_rename(self):
        before = self.files()
        for output in OUTPUTS[:3]:
            self.every_call("rename", errno.EIO, 4, [output[0]], "triangulate", "p.npy", "-o",
                            *output)
            os.remove(self.path(output[0]))
        self.assertEqual(self.files(), before)
        # Of files that belong together each has its own name: no temporary one stays.
        for nth in (1, 2):
            code, said, _ = self.run_mgdt("triangulate", "p.npy", "-o", "m.npy", "--neighbors",
                                          "n.npy", fault=f"rename {nth} {errno.EIO}")
            self.assertEqual(code, 4, said)
            self.assertFalse([name for name in self.files() if name.startswith(".")])

    def test_input(self):
        for call in "read", "fstat":
            # The program's start reads libraries by other means; a failure there is no test.
            self.every_call(call, errno.EIO, 3, ["p.npy"], "triangulate", "p.npy", "-o", "m.vtu")
            os.remove(self.path("m.vtu"))

    def test_short_and_interrupted(self):
        self.good("triangulate", "p.npy", "-o", "m.vtu", "--canonical")
        self.assertTrue(self.good("triangulate", "p.npy", "-o", "s.vtu", "--canonical",
                                  fault="short"))
        files = self.files()
        self.assertEqual(files["m.vtu"], files["s.vtu"])


class BrokenInput(FilesTest):
    """Whatever is read: a result or one line that says why not, in bounded memory."""

    limit = 1 << 28

    def survives(self, name, content, *arguments):
        with open(self.path(name), "wb") as f:
            f.write(content)
        code, said, _ = self.run_mgdt(
            *arguments,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (self.limit, self.limit)))
        self.assertIn(code, (0, 1, 3), (name, said))
        if code != 0:
            self.assertTrue(said.startswith("mgdt: "), said)
            self.assertIn(name.split(".")[0], said)
        return code

    def attempts(self, content):
        """Cut and changed copies: all of the small part that headers are in, some of the rest."""
        steps = random.Random(1)
        size = len(content)
        dense = 24 if SMALL else 60
        places = sorted(set(range(0, min(size, dense))) | set(range(max(0, size - 12), size)) |
                        {steps.randrange(size) for _ in range(dense)})
        for at in places:
            yield content[:at]
            yield content[:at] + bytes([content[at] ^ 1 << steps.randrange(8)]) + content[at + 1:]

    def test_every_format(self):
        self.good("generate", "lattice", 27, "-o", "p.npy")
        for name in POINTS[1:]:
            self.good("generate", "lattice", 27, "-o", name)
        for name, to in MESHES.items():
            self.good("triangulate", "p.npy", "-o", name, *to)
        seen = {0: 0, 1: 0, 3: 0}
        for name in POINTS + list(MESHES):
            content = self.files()[name]
            for broken in self.attempts(content):
                seen[self.survives(name, broken, "check", name)] += 1
            with open(self.path(name), "wb") as f:
                f.write(content)
        self.assertGreater(seen[0], 10)
        self.assertGreater(seen[3], 100)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    MGDT, SHIM = os.path.abspath(sys.argv.pop(1)), os.path.abspath(sys.argv.pop(1))
    unittest.main()
