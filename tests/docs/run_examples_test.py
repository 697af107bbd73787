#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The runner of examples must fail where an example fails, and say where.

  run_examples_test.py SOURCE DOCUMENT...   the documents are those that the build knows
"""
import functools
import os
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
sys.path.append(str(Path(__file__).resolve().parents[1]))
import checks

RUNNER = Path(__file__).with_name("run_examples.py")
PROGRAM = "```c a.c\nint main(void) { return 0; }\n```\n"
RUN = "```sh\ncc a.c -o a\n./a\n```\n"

# name, document, what must be printed; None for a document that must pass.
CASES = [
    ("a program", PROGRAM + RUN, None),
    ("output as expected", "```sh\necho one; echo two\n```\nprints\n```text\none\ntwo\n```\n", None),
    ("errors are output", "```sh\necho no >&2\n```\n```text\nno\n```\n", None),
    ("a progress bar", "```sh\nprintf '\\rat 0%%\\rat 50%%\\r      \\r' >&2; echo one\n```\n```text\none\n```\n", None),
    ("a line that ends as in DOS", "```sh\nprintf 'one\\r\\ntwo\\n'\n```\n```text\none\ntwo\n```\n", None),
    ("dots in a line", "```sh\necho took 12 ms\n```\n```text\ntook ... ms\n```\n", None),
    ("a line of dots", "```sh\nseq 9\n```\n```text\n1\n...\n9\n```\n", None),
    ("an illustration", "```\nrm nothing\n```\n" + PROGRAM + RUN, None),
    ("a block in a list", "- so:\n\n  ```python a.py\n  if True:\n      print(1)\n  ```\n\n"
     "  ```sh\n  python3 a.py\n  ```\n\n  ```text\n  1\n  ```\n", None),
    ("a file through a file", PROGRAM + "```make Makefile\na: a.c\n\tcc a.c -o a\n```\n```sh\nmake\n```\n", None),
    ("the source tree", "```sh\ntest -f \"$MGDT_SOURCE/include/mgdt/mgdt.h\"\n```\n", None),
    ("a folder of its own", "```sh\ntest -z \"$(ls -A)\"\n```\n", None),
    ("the prefix", "```sh\ntest \"$(pkg-config --modversion mgdt)\" = 9.9\n```\n", None),
    ("a status", "```sh\nfalse\n```\n", "line 1: the sh block ended with status 1"),
    ("a status before the end", "```sh\nfalse\ntrue\n```\n", "status 1"),
    ("an unset variable", "```sh\necho $nothing_of_that_name\n```\n", "status 2"),
    ("a program that fails", PROGRAM.replace("0;", "3;") + RUN, "line 4: the sh block ended with status 3"),
    ("a program that does not compile", PROGRAM.replace("return", "retrun") + RUN, "status 1"),
    ("output that differs", "```sh\necho one\n```\n```text\ntwo\n```\n", "line 1 is 'one', expected 'two'"),
    ("output that was overwritten", "```sh\nprintf 'one\\rtwo\\n'\n```\n```text\none\n```\n",
     "line 1 is 'two', expected 'one'"),
    ("output that is half overwritten", "```sh\nprintf 'three\\rtwo\\n'\n```\n```text\ntwo\n```\n",
     "line 1 is 'twoee', expected 'two'"),
    ("output that goes on", "```sh\nseq 2\n```\n```text\n1\n```\n", "line 2 is not expected: '2'"),
    ("output that ends early", "```sh\nseq 1\n```\n```text\n1\n2\n```\n", "line 2 is missing: '2'"),
    ("output after a line of dots", "```sh\nseq 9\n```\n```text\n1\n...\n8\n```\n", "nothing matches"),
    ("a line that is no pattern", "```sh\necho axb\n```\n```text\na.b\n```\n", "expected 'a.b'"),
    ("a file that nobody uses", PROGRAM + "```sh\ntrue\n```\n", "no sh block after it uses a.c"),
    ("a file that is used before it is there", RUN.replace("./a", "true") + PROGRAM, "no sh block after it uses a.c"),
    ("a name that only looks alike", PROGRAM + "```sh\ntouch a.cpp\n```\n", "uses a.c"),
    ("an unknown language", "```klingon a.k\n```\n" + PROGRAM + RUN, "unknown kind of block 'klingon a.k'"),
    ("a misspelt sh", "```shell\nfalse\n```\n" + PROGRAM + RUN, "unknown kind of block 'shell'"),
    ("a file without a name", "```c\nint x;\n```\n" + PROGRAM + RUN, "needs the name of one file"),
    ("a file elsewhere", "```c ../a.c\nint x;\n```\n```sh\nls ../a.c\n```\n", "outside"),
    ("output of nothing", PROGRAM + "```text\none\n```\n" + RUN, "there is none"),
    ("a block without an end", PROGRAM + RUN + "```sh\ntrue\n", "has no end"),
    ("no example", "# Nothing here\n", "no example"),
    ("a program without a run", PROGRAM, "no example"),
    ("a block that does not end", "```sh\nsleep 60\n```\n", "ran longer than"),
]

check = functools.partial(checks.check, names_passed=False)


def run(folder, text, *more):
    document = folder / "document.md"
    document.write_text(text)
    return subprocess.run([sys.executable, str(RUNNER), "--prefix", str(folder / "prefix"), "--scratch",
                           str(folder / "scratch"), "--timeout", "20" if "sleep" not in text else "1",
                           *more, str(document)], capture_output=True, text=True)


def make_prefix(folder):
    """As much of an installation as the runner looks at."""
    (folder / "include" / "mgdt").mkdir(parents=True)
    (folder / "include" / "mgdt" / "mgdt.h").touch()
    (folder / "lib" / "pkgconfig").mkdir(parents=True)
    (folder / "lib" / "pkgconfig" / "mgdt.pc").write_text("Name: mgdt\nDescription: none\nVersion: 9.9\n")


def main():
    source, known = Path(sys.argv[1]).resolve(), [Path(p).resolve() for p in sys.argv[2:]]
    os.environ.pop("MGDT_SOURCE", None)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        make_prefix(folder / "prefix")
        for what, text, wanted in CASES:
            result = run(folder, text)
            last = result.stdout.rstrip().split("\n")[-1]
            if wanted is None:
                problem = "" if result.returncode == 0 and last.endswith(" 0 failed") else result.stdout + result.stderr
            elif result.returncode == 0:
                problem = "it passed"
            else:
                reports = [line for line in result.stdout.split("\n") if line.startswith("failed: ")]
                problem = "" if any(wanted in r for r in reports) and "0 passed, 0 failed" not in last else \
                    f"no report has '{wanted}': {result.stdout}{result.stderr}"
            check(what, problem)

        result = run(folder, "# Prose\n", "--may-be-empty", "document.md")
        check("a document that may have none", "" if result.returncode == 0 else result.stdout)
        result = run(folder, "```sh\nfalse\n```\n", "--may-be-empty", "document.md")
        check("one that may have none and has one", "" if result.returncode == 1 else "it passed")
        result = run(folder, PROGRAM + RUN, "--prefix", str(folder / "nowhere"))
        check("no prefix", "" if result.returncode and "no mgdt is installed" in result.stderr else result.stdout)

    listed = checks.output_of(sys.executable, RUNNER, "--list", source).split("\n")
    there = {Path(line).resolve() for line in listed if line}
    check("the build knows every document (if not, run meson setup --reconfigure)",
          " ".join(str(p) for p in sorted(there ^ set(known))))
    checks.finish()


if __name__ == "__main__":
    main()
