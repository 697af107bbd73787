#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints what the tests of some suites need to be built, for ninja; without suites what all tests need and what is
built by default. Ninja's own default has the programs of benchmarks too.

usage: targets.py BUILD [SUITE...]
"""

import json
import os
import subprocess
import sys


def introspect(build, what):
    return json.loads(subprocess.check_output(["meson", "introspect", f"--{what}", build]))


def main(build, *suites):
    wanted = set()
    for test in introspect(build, "tests"):
        # A suite has the project's name in front.
        if not suites or any(suite.partition(":")[2] in suites for suite in test["suite"]):
            wanted.update(test["depends"])
    for target in introspect(build, "targets"):
        if target["id"] in wanted or (not suites and target["build_by_default"]):
            for file in target["filename"]:
                print(os.path.relpath(file, build))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
