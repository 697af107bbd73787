#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""isa_test.py NM ARCHIVE...: no code for newer processors that others may be given.

The linker keeps one copy of an inline function for everybody. If that copy came from a file
compiled for AVX-512, older processors would stop at it. So every such function in an archive of
one instruction set must stand in the namespace of that set.
"""
import os
import re
import subprocess
import sys


def main():
    nm, archives = sys.argv[1], sys.argv[2:]
    failures = 0
    checked = 0
    for archive in archives:
        isa = re.search(r"mgdt_(\w+)\.a$", os.path.basename(archive)).group(1)
        lines = subprocess.run([nm, "-C", archive], check=True, capture_output=True,
                               text=True).stdout.splitlines()
        shared = [line for line in lines if re.match(r"[0-9a-f]+ [WVu] ", line)]
        own = [line for line in lines if f"mgdt::{isa}::" in line]
        checked += len(own)
        for line in shared:
            # A pointer to the runtime's handler of exceptions is data, the same for everybody.
            if f"mgdt::{isa}::" not in line and "DW.ref." not in line:
                print(f"{os.path.basename(archive)}: {line.split(' ', 2)[2]}")
                failures += 1
    if checked == 0:
        print("no function of any instruction set was found")
        failures += 1
    sys.exit(1 if failures else 0)


main()
