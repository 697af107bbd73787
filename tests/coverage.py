#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Shares of lines and branches of src/ that ran, by folder, and what did not where floors are set.

  coverage.py COVERAGE.json    as `gcovr --json` writes it
"""
import json
import sys
from collections import defaultdict

# Per cent of lines and of branches, in the folders that decide whether a result is right. They are
# what is reached, less what depends on how threads meet; they only go up.
FLOORS = {"predicates": (100.0, 93.5), "kernel": (86.0, 53.0)}


def folder_of(path):
    return "/".join(path.split("/")[1:-1]) or "."


def share(part, all_of_it):
    return 100.0 * part / all_of_it if all_of_it else 100.0


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        files = json.load(file)["files"]
    counts = defaultdict(lambda: [0, 0, 0, 0])  # lines run, lines, branches taken, branches
    missing = []
    for entry in files:
        folder = folder_of(entry["file"])
        for line in entry["lines"]:
            if line.get("gcovr/noncode") or line.get("gcovr/excluded"):
                continue
            branches = [b["count"] > 0 for b in line["branches"]]
            for name in {folder, "src"}:
                count = counts[name]
                count[0] += line["count"] > 0
                count[1] += 1
                count[2] += sum(branches)
                count[3] += len(branches)
            if folder in FLOORS and (line["count"] == 0 or not all(branches)):
                what = "not run" if line["count"] == 0 else f"{branches.count(False)} of {len(branches)} branches not taken"
                missing.append(f"{entry['file']}:{line['line_number']}: {what}")

    print(f"{'folder':16}{'lines':>8}{'run':>8}{'branches':>10}{'taken':>8}")
    failures = []
    for folder in sorted(counts, key=lambda name: (name == "src", name)):
        run, lines, taken, branches = counts[folder]
        print(f"{folder:16}{lines:8}{share(run, lines):7.1f}%{branches:10}{share(taken, branches):7.1f}%")
        for what, reached, floor in zip(("lines", "branches"), (share(run, lines), share(taken, branches)),
                                        FLOORS.get(folder, (0, 0))):
            if reached < floor:
                failures.append(f"failed: {reached:.2f} % of the {what} of src/{folder}; the floor is {floor} %")
    for folder in set(FLOORS) - set(counts):
        failures.append(f"failed: nothing is known of src/{folder}")
    print("\nNot run, or not in both ways:" if missing else "\nAll of it was run where there is a floor.")
    print("\n".join(missing + failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
