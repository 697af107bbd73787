#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs clang-tidy, with the checks of .clang-tidy, on the sources of a build: the library as one file, which reads
each header once and takes a fifteenth of the time, and the program file by file.

  tidy_test.py SOURCE BUILD
"""
import json
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
from checks import check, finish

DEFECT = "modernize-use-nullptr"


def tidy(*arguments):
    """What it says where it finds something."""
    run = subprocess.run(["clang-tidy", "--quiet", *arguments], capture_output=True, text=True)
    # What it counts, in headers of others too, goes to the standard error.
    return (run.stdout.strip() or run.stderr.strip()) if run.returncode or "warning:" in run.stdout else ""


def findings_in_file(build, file):
    # Warnings of g++ have names that clang does not know.
    return tidy("-p", build, "--extra-arg=-Wno-unknown-warning-option", file)


def findings_in_library(source, folder):
    """As findings_in_file, with a defect at its end, and the file of the library that a line stands in."""
    subprocess.run([sys.executable, source / "docs" / "packaging" / "amalgamate.py", folder], check=True)
    whole = Path(folder) / "mgdt.cpp"
    with open(whole, "a", encoding="utf-8") as out:
        out.write("// ---- the defect\nint* nothing = 0;\n")
    lines = whole.read_text(encoding="utf-8").split("\n")

    def part(match):
        before = reversed(lines[:int(match[1])])
        return next((line[8:] for line in before if line.startswith("// ---- ")), "mgdt.cpp") + f":{match[1]}:"

    found = tidy(f"--config-file={source / '.clang-tidy'}", whole, "--", "-std=c++17", f"-I{folder}")
    return re.sub(rf"{re.escape(str(whole))}:(\d+):", part, found)


def main():
    source, build = Path(sys.argv[1]).resolve(), sys.argv[2]
    # The compiler's database has paths as seen from the build.
    entries = json.loads((Path(build) / "compile_commands.json").read_text(encoding="utf-8"))
    files = {(Path(e["directory"]) / e["file"]).resolve() for e in entries}
    files = sorted(f for f in files if f.suffix == ".cpp" and
                   any(f.is_relative_to(source / "src" / part) for part in ("bench", "cli", "mpi")))
    with ThreadPoolExecutor(os.cpu_count()) as pool, tempfile.TemporaryDirectory() as folder:
        library = pool.submit(findings_in_library, source, folder)
        for file, problem in zip(files, pool.map(lambda f: findings_in_file(build, str(f)), files)):
            check(str(file.relative_to(source)), problem, names_passed=False)
        found = re.split(r"^(?=\S[^\n]*:\d+:\d+: )", library.result(), flags=re.MULTILINE)
    others = [one.strip() for one in found if one.strip() and not one.startswith("the defect:")]
    check("the library", "\n".join(others))
    check("a defect at its end is found", "" if any(DEFECT in one for one in found) else "not")
    check("files to look at", "" if len(files) > 50 else f"only {len(files)}")
    finish()


if __name__ == "__main__":
    main()
