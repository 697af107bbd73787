#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints what the tests of some suites need to be built, for ninja; without suites what all tests need and what is
built by default. Ninja's own default has the programs of benchmarks too. A suite with a minus sign in front is left
out: its tests need nothing.

usage: targets.py BUILD [SUITE... [-SUITE...]]
"""

import json
import os
import subprocess
import sys


def introspect(build, what):
    return json.loads(subprocess.check_output(["meson", "introspect", f"--{what}", build]))


def main(build, *suites):
    wanted = set()
    left_out = {suite[1:] for suite in suites if suite.startswith("-")}
    for test in introspect(build, "tests"):
        own = {suite.partition(":")[2] for suite in test["suite"]}  # which has the project's name in front
        if (not suites or own & set(suites)) and not own & left_out:
            wanted.update(test["depends"])
    for target in introspect(build, "targets"):
        if target["id"] in wanted or (not suites and target["build_by_default"]):
            for file in target["filename"]:
                print(os.path.relpath(file, build))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
