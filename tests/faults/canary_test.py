#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The table of canary_test has every function of the header that writes through a pointer.

Usage: canary_test.py HEADER CANARY_TEST
"""

import re
import subprocess
import sys


def writers(header):
    """Names of the functions with a parameter that points to what is not const, the handle and
    the data of callbacks aside."""
    text = re.sub(r"/\*.*?\*/", " ", header, flags=re.S)
    declarations = re.findall(r"^MGDT_API\b([^;]*?)(\w+)\s*\(([^;]*)\)\s*;", text, flags=re.M)
    found = set()
    for _, name, parameters in declarations:
        for parameter in parameters.split(","):
            words = " ".join(parameter.split())
            if "*" not in words or words.startswith("const ") or re.fullmatch(r"void ?\* ?user", words) or \
                    re.fullmatch(r"mgdt_triangulation ?\* ?\w+", words):
                continue
            found.add(name)
    return found, len(declarations)


def main():
    with open(sys.argv[1], encoding="utf-8") as f:
        wanted, functions = writers(f.read())
    if functions < 40 or "mgdt_get_tetrahedra" not in wanted:
        sys.exit(f"{sys.argv[1]}: only {functions} functions were understood")
    done = subprocess.run([sys.argv[2], "--list"], stdout=subprocess.PIPE, check=True)
    table = set(done.stdout.decode().split())
    if table != wanted:
        sys.exit(f"not in the table: {sorted(wanted - table)}; not in the header: "
                 f"{sorted(table - wanted)}")
    print(f"{len(wanted)} of {functions} functions write, all are in the table")


main()
