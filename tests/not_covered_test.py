#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Each entry of tests/not_covered.py is about text that the source has. Whether the tests take it,
only a build that counts can tell (tests/coverage.sh).

  not_covered_test.py SOURCE
"""
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
from checks import check, finish
from not_covered import NOT_COVERED

OUTCOMES = {"true", "false", "line", "sometimes"}


def has_condition(lines, condition):
    """Whether the condition stands in the source, as one operand or whole; it may span lines."""
    text = " ".join(line.split("//")[0].strip() for line in lines)
    before, after = r"(?:[!(,;=?:{]|&&|\|\||\breturn)\s*", r"\s*(?:[);?]|&&|\|\|)"
    return re.search(before + re.escape(condition) + after, text) is not None


def problem_of(source, file, text, outcomes, reason):
    """What is wrong with an entry; nothing if it is right."""
    words = set(outcomes.split())
    if not words & {"true", "false", "line"} or words - OUTCOMES:
        return f"the outcomes '{outcomes}'"
    if not reason:
        return "no reason"
    if not (source / file).is_file():
        return "no such file"
    lines = (source / file).read_text(encoding="utf-8").splitlines()
    # The coverage names a line, and the head of a loop over a range, by the whole line.
    if text in [line.strip() for line in lines]:
        return ""
    if "line" in words:
        return "no such line"
    return "" if has_condition(lines, text) else "no such condition"


def main():
    source = Path(sys.argv[1])
    for entry in NOT_COVERED:
        check(f"{entry[0]}: {entry[1]}", problem_of(source, *entry))
    keys = [entry[:2] for entry in NOT_COVERED]
    check("each is there once", ", ".join(text for file, text in keys if keys.count((file, text)) > 1))

    # Entries that have to be found wrong.
    file = NOT_COVERED[0][0]
    for what, entry in {"a condition that is gone": (file, "no_such_name >= 0", "true", "why"),
                        "a part of a condition": ("src/kernel/select.cpp", "avx512", "true", "why"),
                        "a line that is gone": (file, "return no_such_name;", "line", "why"),
                        "a condition as a line": ("src/kernel/select.cpp", "kernel", "line", "why"),
                        "a file that is gone": ("src/kernel/no_such_file.cpp", "a", "true", "why"),
                        "an unknown outcome": (file, "true", "never", "why"),
                        "no outcome": (file, "true", "sometimes", "why"),
                        "no reason": (file, "true", "true", "")}.items():
        check(f"{what} is found", "" if problem_of(source, *entry) else "it passed")
    finish()


if __name__ == "__main__":
    main()
