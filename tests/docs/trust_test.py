#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What docs/trust.md names is there: each promise has a command, the tests of a command are known to
the build, scripts exist and know the words that follow them, and so do files.

  trust_test.py SOURCE TESTS.json    the latter as `meson introspect --tests` writes it
"""
import json
import re
import shlex
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
sys.path.append(str(Path(__file__).resolve().parents[1]))
from checks import check, differences, finish


def rows_of(text, section):
    """Rows of the tables of a section, without their headings."""
    tables = text.split(f"\n## {section}\n")[1].split("\n## ")[0]
    rows = [[cell.strip() for cell in line.strip("|").split("|")]
            for line in tables.splitlines() if line.startswith("|")]
    return [row for row in rows if row[0] != "subject" and not row[0].startswith("---")]


def problem_of(command, source, known):
    words = shlex.split(command)
    if words[:2] == ["meson", "test"]:
        names, rest = [], words[2:]
        while rest:
            word = rest.pop(0)
            if word in ("-C", "--setup"):
                rest.pop(0)
            elif word == "--suite":
                names.append("mgdt:" + rest.pop(0))
            else:
                names.append(word)
        unknown = [name for name in names if name not in known]
        return "no such test or suite: " + ", ".join(unknown) if unknown else "" if names else "no test named"
    if words[0] == "sh":
        script = source / words[1]
        if not script.is_file():
            return f"no {words[1]}"
        text = script.read_text()
        return " ".join(w for w in words[2:] if w != "TOOL" and not re.search(rf"(?<![\w-]){re.escape(w)}(?![\w-])", text))
    return ""


def main():
    source = Path(sys.argv[1])
    with open(sys.argv[2], encoding="utf-8") as file:
        tests = json.load(file)
    known = {test["name"] for test in tests} | {suite for test in tests for suite in test["suite"]}
    text = (source / "docs" / "trust.md").read_text(encoding="utf-8")
    promises = [row[0] for row in rows_of(text, "Promises")]
    tested = {row[0]: row for row in rows_of(text, "Tests of the promises")}
    check("there are promises", "" if len(promises) >= 15 else str(len(promises)))
    check("each has a row of tests", differences(set(promises), set(tested)))
    for subject, row in tested.items():
        commands = re.findall(r"`([^`]+)`", row[1]) if len(row) == 3 else []
        check(f"a command: {subject}", "" if commands and row[2] else "none")
    for command in sorted(set(re.findall(r"`((?:meson test|sh) [^`]+)`", text))):
        check(command, problem_of(command, source, known))
    for path in sorted(set(re.findall(r"`((?:src|tests|docs|include)/[^`\s]*)`", text))):
        check(path, "" if (source / path).exists() else "no such file")
    finish()


if __name__ == "__main__":
    main()
