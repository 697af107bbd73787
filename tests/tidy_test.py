#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs clang-tidy, with the checks of .clang-tidy, on the sources of a build.

  tidy_test.py SOURCE BUILD
"""
import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
from checks import check, finish


def findings(build, file):
    # Warnings of g++ have names that clang does not know.
    run = subprocess.run(["clang-tidy", "-p", build, "--quiet", "--extra-arg=-Wno-unknown-warning-option", file],
                         capture_output=True, text=True)
    # What it counts, in headers of others too, goes to the standard error.
    return (run.stdout.strip() or run.stderr.strip()) if run.returncode or "warning:" in run.stdout else ""


def main():
    source, build = Path(sys.argv[1]).resolve(), sys.argv[2]
    # The compiler's database has paths as seen from the build.
    entries = json.loads((Path(build) / "compile_commands.json").read_text(encoding="utf-8"))
    files = {(Path(e["directory"]) / e["file"]).resolve() for e in entries}
    files = sorted(f for f in files if f.suffix == ".cpp" and f.is_relative_to(source / "src"))
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for file, problem in zip(files, pool.map(lambda f: findings(build, str(f)), files)):
            check(str(file.relative_to(source)), problem, names_passed=False)
    check("files to look at", "" if len(files) > 70 else f"only {len(files)}")
    # Something is found where it is: a source that uses 0 for a pointer.
    wrong = Path(build) / "tests" / "tidy_test.cpp"
    wrong.write_text("int* nothing = 0;\n", encoding="utf-8")
    run = subprocess.run(["clang-tidy", f"--config-file={source / '.clang-tidy'}", str(wrong), "--"],
                         capture_output=True, text=True)
    check("a defect is found", "" if "modernize-use-nullptr" in run.stdout and run.returncode else run.stdout)
    finish()


if __name__ == "__main__":
    main()
