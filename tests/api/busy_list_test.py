#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every function of mgdt.h that a busy handle refuses is called by test_busy.c.

  busy_list_test.py SOURCE
"""
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
source = Path(sys.argv[1])
sys.path.insert(0, str(source / "tests"))
from checks import check, finish

# Functions of a handle that may be called at any time.
ALLOWED = {"mgdt_cancel", "mgdt_get_error"}


def main():
    header = (source / "include" / "mgdt" / "mgdt.h").read_text(encoding="utf-8")
    test = (source / "tests" / "api" / "test_busy.c").read_text(encoding="utf-8")
    names = re.findall(r"\b(mgdt_\w+)\(\s*(?:const )?mgdt_triangulation\s*\*\s*\w", header)
    check("there are functions of a handle", "" if len(names) > 70 else f"only {len(names)}")
    for name in sorted(set(names) - ALLOWED):
        check(name, "" if re.search(rf"\b{name}\(", test) else "test_busy.c does not call it", names_passed=False)
    finish()


if __name__ == "__main__":
    main()
