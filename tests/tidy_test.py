#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs clang-tidy, with the checks of .clang-tidy, on the sources of a build: the library as one file, which reads
each header once and takes a fifteenth of the time, and the program file by file.

  tidy_test.py SOURCE BUILD

What has passed is remembered by a hash of all that it depends on, in mgdt-tidy in the user's folder of caches, and not
looked at again. Most of the time goes into the headers of others.
"""
import hashlib
import json
import os
import re
import subprocess
import sys
import tempfile
import time
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


class Passed:
    """Remembers what has passed, by a hash of the tool, its checks, and the text that it has looked at."""

    def __init__(self, source):
        self.folder = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "mgdt-tidy"
        version = subprocess.run(["clang-tidy", "--version"], capture_output=True, check=True).stdout
        self.start = hashlib.sha256(version + (source / ".clang-tidy").read_bytes() + Path(__file__).read_bytes())

    def unless_known(self, texts, find):
        """What find() says, which is not called if it has said nothing of these texts before."""
        key = self.start.copy()
        for text in texts:
            key.update(b"%d:" % len(text) + text)
        file = self.folder / key.hexdigest()
        if file.exists():
            file.touch()
            return ""
        problem = find()
        if not problem:
            self.folder.mkdir(parents=True, exist_ok=True)
            file.touch()
        return problem

    def forget_old(self):
        """Removes what no run has asked for in a month."""
        for file in self.folder.glob("*"):
            if time.time() - file.stat().st_mtime > 30 * 86400:
                file.unlink(missing_ok=True)


def texts_by_object(source, build):
    """For each object of a build the files that the compiler has read: the contents of the project's own, and the names,
    sizes and times of others."""
    texts = {}

    def text(name):
        if name not in texts:
            path = Path(build) / name
            status = path.stat()
            texts[name] = (path.read_bytes() if path.resolve().is_relative_to(source) else
                           f"{path.resolve()} {status.st_size} {status.st_mtime_ns}".encode())
        return texts[name]

    objects = {}
    listing = subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True, check=True).stdout
    for paragraph in listing.split("\n\n"):
        head, *files = paragraph.strip().split("\n")
        if head.endswith("(VALID)"):
            objects[head.partition(": ")[0]] = [text(file.strip()) for file in sorted(files)]
    return objects


def flags_of(entry):
    """The flags of a compilation, without the paths of what it writes."""
    return re.sub(r" -(o|MF|MQ) \S+", "", entry["command"]).encode()


def findings_in_file(build, file):
    # Warnings of g++ have names that clang does not know.
    return tidy("-p", build, "--extra-arg=-Wno-unknown-warning-option", file)


def findings_in_library(source, folder, passed):
    """As findings_in_file, with the files of the library that lines stand in. The text has a defect at its end, which has
    to be found."""
    subprocess.run([sys.executable, source / "docs" / "packaging" / "amalgamate.py", folder], check=True)
    whole = Path(folder) / "mgdt.cpp"
    with open(whole, "a", encoding="utf-8") as out:
        out.write("// ---- the defect\nint* nothing = 0;\n")
    text = whole.read_text(encoding="utf-8")
    lines = text.split("\n")

    def part(match):
        before = reversed(lines[:int(match[1])])
        return next((line[8:] for line in before if line.startswith("// ---- ")), "mgdt.cpp") + f":{match[1]}:"

    def find():
        found = tidy(f"--config-file={source / '.clang-tidy'}", whole, "--", "-std=c++17", f"-I{folder}")
        found = re.sub(rf"{re.escape(str(whole))}:(\d+):", part, found)
        found = re.split(r"^(?=\S[^\n]*:\d+:\d+: )", found, flags=re.MULTILINE)
        others = [one.strip() for one in found if one.strip() and not one.startswith("the defect:")]
        return "\n".join(others) or ("" if any(DEFECT in one for one in found) else "the defect at its end is not found")

    headers = [file.read_bytes() for file in sorted(Path(folder).glob("**/*.h"))]
    return passed.unless_known([text.encode(), *headers], find)


def main():
    source, build = Path(sys.argv[1]).resolve(), sys.argv[2]
    # The compiler's database has paths as seen from the build.
    entries = json.loads((Path(build) / "compile_commands.json").read_text(encoding="utf-8"))
    passed, texts = Passed(source), texts_by_object(source, build)
    files = {}  # with what each depends on, or nothing if that is not known
    for entry in entries:
        file = (Path(entry["directory"]) / entry["file"]).resolve()
        if file.suffix == ".cpp" and any(file.is_relative_to(source / "src" / part) for part in ("bench", "cli", "mpi")):
            known = texts.get(entry["output"])
            files[file] = known and [flags_of(entry), *known]

    def findings(file):
        def find():
            return findings_in_file(build, str(file))
        return passed.unless_known(files[file], find) if files[file] else find()

    with ThreadPoolExecutor(os.cpu_count()) as pool, tempfile.TemporaryDirectory() as folder:
        library = pool.submit(findings_in_library, source, folder, passed)
        for file, problem in zip(files, pool.map(findings, files)):
            check(str(file.relative_to(source)), problem, names_passed=False)
        check("the library, and a defect at its end", library.result())
    check("files to look at", "" if len(files) > 50 else f"only {len(files)}")
    passed.forget_old()
    finish()


if __name__ == "__main__":
    main()
