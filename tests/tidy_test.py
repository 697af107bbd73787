#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs clang-tidy, with the checks of .clang-tidy, on the sources of a build: the library as one file, which reads
each header once and takes a fifteenth of the time, the programs in groups of files with the same flags, which are
included one after the other, and the formats of files one by one, since they use the same names.

  tidy_test.py SOURCE BUILD

What has passed is remembered by a hash of all that it depends on, in mgdt-tidy in the user's folder of caches, and not
looked at again. Most of the time goes into the headers of others.
"""
import hashlib
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
from checks import check, finish

DEFECT = "modernize-use-nullptr"
FILES_IN_GROUP = 12


def tidy(*arguments, cwd=None):
    """What it says where it finds something."""
    run = subprocess.run(["clang-tidy", "--quiet", *arguments], capture_output=True, text=True, cwd=cwd)
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
    """The flags of a compilation that decide what is compiled."""
    words, flags = iter(shlex.split(entry["command"])), []
    for word in words:
        if word in ("-o", "-MF", "-MQ", "-c"):
            next(words)
        elif word.startswith("-") and word != "-MD" and not re.fullmatch(r"-I\S+\.p", word):
            flags.append(word)
    return tuple(flags)


def findings_in_group(source, build, folder, number, flags, files):
    group = Path(folder) / f"group-{number}.cpp"
    group.write_text("".join(f'#include "{file}"\n' for file in files), encoding="utf-8")
    # Files that are included are headers to clang-tidy, and have a name that it finds suspicious. Warnings of g++ have
    # names that clang does not know.
    return tidy(f"--config-file={source / '.clang-tidy'}", "--checks=-bugprone-suspicious-include", group, "--",
                *flags, "-Wno-unknown-warning-option", cwd=build)


def findings_in_library(source, folder, passed):
    """As findings_in_group, with the files of the library that lines stand in. The text has a defect at its end, which has
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
    groups, known = {}, {}  # the files with the same flags; what each depends on, if the build has compiled it
    for entry in entries:
        file = (Path(entry["directory"]) / entry["file"]).resolve()
        if file.suffix == ".cpp" and any(file.is_relative_to(source / "src" / part) for part in ("bench", "cli", "mpi")):
            groups.setdefault(flags_of(entry), set()).add(file)
            known[file] = texts.get(entry["output"])
    parts = []
    for flags, files in groups.items():
        alone = sorted(file for file in files if file.parent.name == "formats")
        others = sorted(files.difference(alone))
        parts += [(flags, [file]) for file in alone]
        parts += [(flags, others[i:i + FILES_IN_GROUP]) for i in range(0, len(others), FILES_IN_GROUP)]

    def findings(number, flags, files):
        def find():
            return findings_in_group(source, build, folder, number, flags, files)
        if not all(known[file] for file in files):
            return find()
        return passed.unless_known([" ".join(flags).encode(), *(text for file in files for text in known[file])], find)

    with ThreadPoolExecutor(os.cpu_count()) as pool, tempfile.TemporaryDirectory() as folder:
        library = pool.submit(findings_in_library, source, folder, passed)
        found = pool.map(lambda part: findings(part[0], *part[1]), enumerate(parts))
        for (_, files), problem in zip(parts, found):
            check(" ".join(str(file.relative_to(source)) for file in files), problem, names_passed=False)
        check("the library, and a defect at its end", library.result())
    files = sum(len(files) for _, files in parts)
    check("files to look at", "" if files > 50 else f"only {files}")
    passed.forget_old()
    finish()


if __name__ == "__main__":
    main()
