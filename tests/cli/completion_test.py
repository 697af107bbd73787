#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The completions of docs/completions, as the shells make them.

Usage: completion_test.py MGDT [unittest arguments]
"""

import os
import subprocess
import sys
import unittest

MGDT = ""
FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "docs", "completions")


class Bash(unittest.TestCase):
    def completed(self, *words):
        script = f"source {FOLDER}/mgdt.bash\n" + (
            'COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=(); _mgdt\n'
            'if [ ${#COMPREPLY[@]} -gt 0 ]; then printf "%s\\n" "${COMPREPLY[@]}"; fi')
        done = subprocess.run(["bash", "-c", script, "bash", MGDT, *words], capture_output=True, text=True,
                              timeout=60, check=True)
        self.assertEqual(done.stderr, "")
        return done.stdout.split()

    def test_commands(self):
        self.assertEqual(self.completed("tri"), ["triangulate"])
        self.assertLessEqual({"triangulate", "generate", "check", "info", "interpolate", "voronoi", "surface", "hull", "relax", "mesh", "refine", "improve", "validate", "--version"},
                             set(self.completed("")))

    def test_options(self):
        self.assertEqual(self.completed("triangulate", "--can"), ["--canonical"])
        self.assertEqual(self.completed("triangulate", "p.npy", "--memory"), ["--memory-limit"])
        self.assertIn("--output", self.completed("interpolate", "--"))
        self.assertNotIn("--canonical", self.completed("info", "--"))

    def test_names(self):
        self.assertEqual(self.completed("generate", "gal"), ["galaxy"])
        self.assertEqual(self.completed("triangulate", "-", "--from", "me"), ["medit", "meshb"])
        self.assertIn("hilbert", self.completed("triangulate", "--scheme", ""))
        self.assertEqual(self.completed("interpolate", "--method", "sib"), ["sibson", "sibson-c1"])
        self.assertEqual(self.completed("interpolate", "--outside", "b"), ["boundary"])
        # Files are the shell's own.
        self.assertEqual(self.completed("triangulate", "p"), [])


class Syntax(unittest.TestCase):
    def test_zsh(self):
        subprocess.run(["zsh", "-n", f"{FOLDER}/_mgdt"], timeout=60, check=True)

    def test_fish(self):
        subprocess.run(["fish", "-n", f"{FOLDER}/mgdt.fish"], timeout=60, check=True)

    def test_fish_names(self):
        script = f"set -x PATH {os.path.dirname(MGDT)} $PATH; source {FOLDER}/mgdt.fish; "
        for typed, expected in (("mgdt tri", "triangulate"), ("mgdt generate gal", "galaxy"),
                                ("mgdt triangulate --canon", "--canonical"), ("mgdt triangulate p --from med", "medit")):
            done = subprocess.run(["fish", "--no-config", "-c", script + f"complete -C '{typed}'"],
                                  capture_output=True, text=True, timeout=60, check=True)
            self.assertIn(expected, done.stdout.split(), typed)


if __name__ == "__main__":
    MGDT = os.path.abspath(sys.argv.pop(1))
    unittest.main()
