#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Layout of C and C++ by clang-format, scripts by shellcheck, Python by pyflakes; and no stray files beside the
folders of the source.

  style_test.py SOURCE [FILE...]

Looks at the files that are named, or at all in the folders of the source.
"""
import re
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
from checks import check, finish

FOLDERS = ("bindings", "docs", "include", "src", "tests")
TOP_LEVEL = {*FOLDERS, "LICENSE", "README.md", "meson.build", "meson_options.txt"}

# What is never formatted: headers and clients as they were released.
AS_THEY_ARE = ("tests/abi/mgdt-", "tests/abi/client-")

# What a script that another one reads cannot show: variables that the other one sets or uses, and files
# whose path is known when it runs.
UNSEEN = "SC1090,SC1091,SC2034,SC2154"

TOOLS = {
    (".c", ".cpp", ".h", ".hpp"): ("clang-format", "--dry-run", "-Werror"),
    (".sh",): ("shellcheck", "--shell=sh", "--severity=warning", "--exclude=" + UNSEEN),
    (".py",): ("/usr/bin/python3", "-m", "pyflakes"),
}


def all_files(source):
    found = []
    for folder in FOLDERS:
        found += [path for path in (source / folder).rglob("*") if path.is_file()]
    return found


def stray(source):
    """What the top level has besides TOP_LEVEL and dot-files, of what git knows."""
    files = subprocess.run(["git", "-C", source, "ls-files"], capture_output=True, text=True, check=False)
    names = {line.split("/")[0].strip('"') for line in files.stdout.splitlines()}
    return sorted(name for name in names - TOP_LEVEL if not name.startswith("."))


def problem_of(command, files):
    try:
        run = subprocess.run([*command, *map(str, files)], capture_output=True, text=True)
    except FileNotFoundError:
        return f"{command[0]} is not installed"
    return (run.stdout + run.stderr).strip() if run.returncode else ""


def broken_comments(source):
    """Lines of documentation that clang-format has broken: they begin two blanks behind the asterisk."""
    found = []
    for path in sorted((source / "include").rglob("*.h*")):
        text = path.read_text(encoding="utf-8")
        for comment in re.finditer(r"/\*\*(?!\*).*?\*/", text, re.S):
            for line in re.finditer(r"\n *\* \S", comment.group()):
                number = text.count("\n", 0, comment.start() + line.start() + 1) + 1
                found.append(f"{path.relative_to(source)}:{number}")
    return " ".join(found)


def main():
    source = Path(sys.argv[1])
    named = [source / name for name in sys.argv[2:]]
    count = 0
    for endings, command in TOOLS.items():
        files = [path for path in named or all_files(source)
                 if path.name.endswith(endings) and path.is_file() and
                 not str(path.relative_to(source)).startswith(AS_THEY_ARE)]
        count += len(files)
        if files:
            what = f"{Path(command[0]).name} {' '.join(command[1:])}: {len(files)} files"
            check(what, problem_of(command, sorted(files)))
    check("comments of headers", broken_comments(source))
    check("the top level", " ".join(stray(source)))
    check("files to look at", "" if count > 300 or named else f"only {count}")
    finish()


if __name__ == "__main__":
    main()
