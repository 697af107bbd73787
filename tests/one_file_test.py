#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The library compiles as one file, so no two of its files define what has one name: a linker takes
one of two classes for both, and says nothing.

  one_file_test.py SOURCE COMPILER
"""
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
from checks import check, finish

source, compiler = Path(sys.argv[1]), sys.argv[2]
with tempfile.TemporaryDirectory() as folder:
    made = subprocess.run([sys.executable, source / "docs" / "packaging" / "amalgamate.py", folder],
                          capture_output=True, text=True)
    check("it is written", made.stderr if made.returncode else "")

    asked = subprocess.run([sys.executable, source / "docs" / "packaging" / "amalgamate.py", "--help"],
                           capture_output=True, text=True, cwd=folder)
    check("an option is no folder", "" if asked.returncode and "FOLDER" in asked.stderr and
          not (Path(folder) / "--help").exists() else "it is taken for one")

    def problem_of(file):
        done = subprocess.run([compiler, "-std=c++17", "-fsyntax-only", "-ffp-contract=off", "-I", folder, file],
                              capture_output=True, text=True)
        return done.stderr[:2000] if done.returncode else ""

    whole = Path(folder) / "mgdt.cpp"
    check("it compiles", problem_of(whole))
    with open(whole, "a", encoding="utf-8") as out:
        out.write("namespace mgdt { class Parts { int other; }; }\n")
    check("a second class of a name is seen", "" if "redefinition" in problem_of(whole) else "not")
finish()
