#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints what the tests of some suites need to be built, for ninja.

usage: targets.py BUILD SUITE...
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
        if any(suite.partition(":")[2] in suites for suite in test["suite"]):
            wanted.update(test["depends"])
    for target in introspect(build, "targets"):
        if target["id"] in wanted:
            for file in target["filename"]:
                print(os.path.relpath(file, build))


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
