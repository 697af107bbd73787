#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Shares of lines and branches of src/ that ran, by folder, and what did not where all has to.

  coverage.py SOURCE COVERAGE.json    as `llvm-cov export` writes it

A branch is an outcome, true or false, of a condition in the source: of if, for, while, ?:, && and ||.
It counts once, however often its line is compiled: templates and instruction sets are joined.
Conditions of `if constexpr` are the compiler's and do not count.
"""
import json
import re
import sys
from collections import defaultdict
from pathlib import Path

from not_covered import NOT_COVERED

# The folders that decide whether a result is right: each line and branch is taken by the tests, or
# tests/not_covered.py says why not.
COMPLETE = ("hole", "kernel", "predicates")
# Per cent of lines and of branches of all that are reached, less what depends on chance; they only go up.
FLOORS = {"src": (97.5, 92.8)}


def within(path, source):
    """The path below the source, or None."""
    try:
        return Path(path).resolve().relative_to(source).as_posix()
    except ValueError:
        return None


def text_of(lines, place):
    """The condition at a place: four numbers, and for a macro which operand of its argument."""
    first_line, first_column, last_line, last_column = place[:4]
    if len(place) == 5:
        rest = " ".join([lines[last_line - 1][last_column - 1:], *map(str.strip, lines[last_line:last_line + 4])])
        depth = 0
        for end, letter in enumerate(rest):
            depth += (letter == "(") - (letter == ")")
            if depth == 0:
                break
        argument, ordinal = rest[1:end], place[4]
        operands = [operand.strip() for operand in re.split(r"\|\||&&", argument)]
        if ordinal == 0:
            return argument
        return operands[ordinal - 1] if ordinal <= len(operands) else f"{argument}, operand {ordinal}"
    if first_line == last_line:
        text = lines[first_line - 1][first_column - 1:last_column - 1]
        # Whether a range has more.
        return lines[first_line - 1].strip() if text == ":" else text
    parts = [lines[first_line - 1][first_column - 1:], *lines[first_line:last_line - 1],
             lines[last_line - 1][:last_column - 1]]
    return " ".join(part.strip() for part in parts)


class Coverage:
    """Of each file of src/, by place of a condition or by line, how often it was true and false, or run.

    Taken together from all functions: what llvm-cov makes of a file loses the lines that one instance
    of a template has and another has not.
    """

    CODE, EXPANSION = 0, 1  # kinds of regions

    def __init__(self, file_name, source):
        self.source = source
        self.branches = defaultdict(lambda: defaultdict(lambda: [0, 0]))
        self.lines = defaultdict(lambda: defaultdict(int))
        self.texts = {}
        with open(file_name, encoding="utf-8") as file:
            for function in json.load(file)["data"][0]["functions"]:
                self.add(function)

    def text(self, name):
        if name not in self.texts:
            self.texts[name] = (self.source / name).read_text(encoding="utf-8").splitlines()
        return self.texts[name]

    def add(self, function):
        # A macro's text is a file of its own; it is at the place where the macro stands.
        place_of_macro = {region[6]: region for region in function["regions"] if region[7] == self.EXPANSION}
        name = within(function["filenames"][0], self.source)
        if name is None or not name.startswith("src/"):
            return
        of_macro = defaultdict(int)
        for branch in function["branches"]:
            place, in_file = tuple(branch[:4]), branch[6]
            if in_file in place_of_macro:
                # All operands of its argument are where the macro has its parameter, in their order.
                ordinal = of_macro[in_file]
                of_macro[in_file] += 1
                while in_file in place_of_macro:
                    place, in_file = tuple(place_of_macro[in_file][:4]), place_of_macro[in_file][5]
                place += (ordinal,)
            if in_file == 0:
                times = self.branches[name][place]
                times[0] += branch[4]
                times[1] += branch[5]
        self.add_lines(name, [region for region in function["regions"]
                              if region[5] == 0 and region[7] in (self.CODE, self.EXPANSION)])

    def add_lines(self, name, regions):
        lines = self.text(name)
        for number in range(min(r[0] for r in regions), max(r[2] for r in regions) + 1):
            line = lines[number - 1]
            if not re.search(r"\w", line.split("//")[0]):
                continue
            at = (number, len(line) - len(line.lstrip()) + 1)
            # The innermost region that the line begins in, or one that begins in the line.
            around = [r for r in regions if tuple(r[:2]) <= at < tuple(r[2:4])]
            within_it = [r for r in regions if r[0] == number]
            inner = max(around, key=lambda r: r[:2])[4] if around else 0
            self.lines[name][number] += max([inner] + [r[4] for r in within_it])


class Explanations:
    """The list of what no test takes, each item of which has to be about something."""

    def __init__(self):
        self.used = set()

    def explain(self, name, line, condition, outcome):
        """Whether an item is about this outcome ("true", "false" or "line") of this line's condition."""
        for index, (file, text, what, _) in enumerate(NOT_COVERED):
            if file == name and text == (line if outcome == "line" else condition) and outcome in what.split():
                self.used.add((index, outcome))
                return True
        return False

    def problems(self, taken):
        """Items about text that is not there, and about outcomes that the tests take now."""
        for index, (file, text, what, reason) in enumerate(NOT_COVERED):
            for outcome in what.split():
                if outcome == "sometimes" or (index, outcome) in self.used:
                    continue
                if (file, text, outcome) not in taken:
                    yield f"tests/not_covered.py: there is no such thing: {file}: {text} ({outcome})"
                elif "sometimes" not in what.split():
                    yield f"tests/not_covered.py: is taken now: {file}: {text} ({outcome})"
            if not reason:
                yield f"tests/not_covered.py: no reason: {file}: {text}"


def main():
    source = Path(sys.argv[1]).resolve()
    coverage = Coverage(sys.argv[2], source)
    branches, lines = coverage.branches, coverage.lines
    counts = defaultdict(lambda: [0, 0, 0, 0, 0])  # lines, run, branches, taken, explained
    explanations, taken, missing = Explanations(), set(), []
    for name in sorted(set(branches) | set(lines)):
        text = coverage.text(name)
        folder = "/".join(name.split("/")[1:-1])
        totals = [counts[folder], counts["src"]]
        is_complete = folder in COMPLETE

        def look(kind, place, what, outcome, times):
            """Counts one line or branch; kind is 0 for a line, 2 for a branch."""
            condition = what if kind else ""
            line = text[place - 1].strip()
            for total in totals:
                total[kind] += 1
                total[kind + 1] += times > 0
            if times > 0:
                taken.add((name, condition or line, outcome))
            elif is_complete and explanations.explain(name, line, condition, outcome):
                for total in totals:
                    total[4] += 1
            elif is_complete:
                missing.append(f"{name}:{place}: " + (f"never {outcome}: {condition}" if kind else f"not run: {line}"))

        for place, times in sorted(branches[name].items()):
            if re.search(r"\bconstexpr\b", text[place[0] - 1][:place[1] - 1]):
                continue
            condition = text_of(text, place)
            look(2, place[0], condition, "true", times[0])
            look(2, place[0], condition, "false", times[1])
        for number, times in sorted(lines[name].items()):
            look(0, number, "", "line", times)

    print(f"{'folder':16}{'lines':>8}{'run':>8}{'branches':>10}{'taken':>8}{'explained':>11}")
    failures = list(explanations.problems(taken))
    for folder in sorted(counts, key=lambda name: (name == "src", name)):
        all_lines, run, all_branches, took, explained = counts[folder]
        shares = [100.0 * part / whole if whole else 100.0 for part, whole in ((run, all_lines), (took, all_branches))]
        print(f"{folder:16}{all_lines:8}{shares[0]:7.1f}%{all_branches:10}{shares[1]:7.1f}%"
              f"{explained if folder in COMPLETE else '':>11}")
        for what, share, floor in zip(("lines", "branches"), shares, FLOORS.get(folder, (0.0, 0.0))):
            if share < floor:
                failures.append(f"{share:.2f} % of the {what} of {folder}; the floor is {floor} %")
    for folder in COMPLETE:
        if not counts[folder][0]:
            failures.append(f"nothing is known of src/{folder}")
    failures += missing
    for failure in failures:
        print(f"failed: {failure}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
