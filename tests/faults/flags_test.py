#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Flags that change arithmetic are refused when mgdt is configured, however they are given, or
when it is compiled; flags that do not are accepted.

Usage: flags_test.py SOURCE_DIRECTORY MESON
"""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = MESON = ""

# Of the compilers that are there, those that know the flag must be refused with it.
REFUSED = [
    ("g++", "-ffast-math"), ("g++", "-Ofast"), ("g++", "--optimize=fast"),
    ("g++", "-funsafe-math-optimizations"), ("g++", "-ffinite-math-only"),
    ("g++", "-fassociative-math"), ("g++", "-freciprocal-math"), ("g++", "-fno-signed-zeros"),
    ("g++", "-fsingle-precision-constant"), ("g++", "-mfpmath=387"), ("g++", "-mfpmath=both"),
    ("clang++", "-Ofast"), ("clang++", "-ffp-model=fast"),
    ("clang++", "-fassociative-math"),
    ("clang++", "-fdenormal-fp-math=preserve-sign"), ("clang++", "-Xclang -menable-unsafe-fp-math"),
]
X86_ONLY = ["-mfpmath=387", "-mfpmath=both"]


def other(compiler):
    return {"g++": "gcc", "clang++": "clang"}[compiler]


class Flags(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.mkdtemp(prefix="mgdt-flags-")
        self.addCleanup(shutil.rmtree, self.directory)

    def setup_build(self, *arguments, compiler="g++", **environment):
        clean = {k: v for k, v in os.environ.items()
                 if k not in ("CFLAGS", "CXXFLAGS", "CPPFLAGS", "LDFLAGS")}
        clean.update(environment, CXX=compiler, CC=other(compiler))
        build = tempfile.mkdtemp(dir=self.directory)
        return subprocess.run(
            [MESON, "setup", build, SOURCE, "-Dtests=disabled", "-Dprogram=disabled", *arguments],
            env=clean, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300,
            check=False)

    def refused(self, says, *arguments, **options):
        done = self.setup_build(*arguments, **options)
        with self.subTest(arguments=arguments, options=options):
            self.assertNotEqual(done.returncode, 0, done.stdout)
            self.assertIn("mgdt is exact and cannot be built with", done.stdout)
            self.assertIn(says, done.stdout.split("mgdt is exact")[1])

    def test_every_spelling(self):
        for compiler, flag in REFUSED:
            if flag in X86_ONLY and os.uname().machine != "x86_64":
                continue
            self.refused(flag.split()[-1], CXXFLAGS="-g " + flag, compiler=compiler)

    def test_every_place(self):
        self.refused("-ffast-math", "-Dcpp_args=-ffast-math")
        self.refused("-ffast-math", "-Dcpp_args=-g -ffast-math -fno-fast-math")
        self.refused("-Ofast", CPPFLAGS="-Ofast")
        # The C compiler's and the linker's would have the library set flush-to-zero when loaded.
        self.refused("-ffast-math", LDFLAGS="-ffast-math")
        self.refused("-Ofast", "-Dcpp_link_args=-Ofast")
        self.refused("-Ofast", CFLAGS="-Ofast")

    def test_response_file(self):
        response = os.path.join(self.directory, "flags")
        with open(response, "w", encoding="utf-8") as f:
            f.write("-ffast-math\n")
        self.refused("these flags", CXXFLAGS="@" + response)

    # 32-bit x86 computes in the x87 unit unless it is told otherwise: how is said where that is refused.
    @unittest.skipUnless(os.uname().machine in ("x86_64", "i686"), "there is no x87 unit")
    def test_x87_is_told_what_to_configure(self):
        flags = "-msse2 -mfpmath=sse"
        response = os.path.join(self.directory, "flags")
        with open(response, "w", encoding="utf-8") as f:
            f.write("-mfpmath=387\n")
        self.refused(f"meson setup build -Dc_args='{flags}' -Dcpp_args='{flags}'",
                     CXXFLAGS="@" + response)
        done = subprocess.run(
            ["g++", "-std=c++17", "-fsyntax-only", "-mfpmath=387", "-x", "c++",
             SOURCE + "/src/platform/strict.hpp"],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn(f"-Dc_args='{flags}' -Dcpp_args='{flags}'", done.stdout)

    def test_harmless_flags(self):
        done = self.setup_build(CXXFLAGS="-O3 -march=native -funroll-loops -frounding-math "
                                         "-fexcess-precision=fast -ffp-contract=fast "
                                         "-fno-math-errno -fno-trapping-math")
        self.assertEqual(done.returncode, 0, done.stdout)
        # A contraction that was asked for is taken back for what is compiled.
        build = done.stdout.split("Build dir: ")[1].split("\n")[0].strip()
        with open(os.path.join(build, "build.ninja"), encoding="utf-8") as f:
            lines = [line for line in f
                     if line.startswith(" ARGS") and "-ffp-contract=fast" in line]
        self.assertTrue(lines)
        for line in lines:
            self.assertLess(line.rindex("-ffp-contract=fast"), line.rindex("-ffp-contract=off"))

    def test_compiled_without_the_build_system(self):
        for flags in ("-ffast-math", "-Ofast", "-funsafe-math-optimizations", "-ffinite-math-only",
                      "-fno-signed-zeros", "-fsingle-precision-constant"):
            for file in ("predicates/sphere.cpp", "mesh/mesh.cpp"):
                done = subprocess.run(
                    ["g++", "-std=c++17", "-fsyntax-only", flags, "-I", SOURCE + "/src", "-I",
                     SOURCE + "/include", f"{SOURCE}/src/{file}"],
                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
                self.assertNotEqual(done.returncode, 0, (flags, file))
                self.assertIn("mgdt is exact", done.stdout)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    SOURCE, MESON = os.path.abspath(sys.argv.pop(1)), sys.argv.pop(1)
    unittest.main()
