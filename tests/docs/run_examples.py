#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the examples of documents, as a reader would who pastes them one after the other.

  run_examples.py --prefix DIRECTORY [--scratch DIRECTORY] DOCUMENT...   an installed mgdt
  run_examples.py --build DIRECTORY [--scratch DIRECTORY] DOCUMENT...    installs a build's first
  run_examples.py --list SOURCE                                          the documents there are

What the fenced blocks of a document mean:

  ```LANGUAGE FILE   a whole file, written under that name
  ```sh              run with `sh -eu`, after the files before it were written
  ```text            what the sh block before it prints (standard output and error), line by
                     line; `...` stands for any text in a line, a line of `...` for any lines.
                     A progress bar that has been overwritten by carriage returns is not there
  ```                an illustration, neither run nor checked

Each document has a folder of its own. The environment is that of a reader who has installed
mgdt to a prefix and said so: PATH, LD_LIBRARY_PATH, PKG_CONFIG_PATH, CMAKE_PREFIX_PATH and
PYTHONPATH name it; MGDT_SOURCE is the source tree. A file must be used: named by a later sh
block, by a file that is, or as the file that a tool reads by itself (CMakeLists.txt by cmake).
"""
import argparse
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
import installation

# Any other info string is a mistake: a block would silently not be run.
LANGUAGES = set("""ada c cmake cpp csharp csv d fortran go haskell java javascript json julia lua make
    matlab meson nim ocaml octave pascal perl python r ruby rust swift toml typescript zig""".split())
# What a tool reads without being told its name.
READ_BY = {"CMakeLists.txt": "cmake", "meson.build": "meson", "Makefile": "make", "makefile": "make",
           "Cargo.toml": "cargo", "build.rs": "cargo", "go.mod": "go", "package.json": "npm|node",
           "fpm.toml": "fpm", "pyproject.toml": "pip|python3", "Project.toml": "julia"}


class Block:
    def __init__(self, line, info, text):
        self.line, self.info, self.text = line, info, text
        words = info.split()
        self.kind = words[0] if words else ""
        self.file = words[1] if len(words) == 2 and self.kind in LANGUAGES else None


def blocks_of(document):
    """The fenced blocks, and what is wrong with the fences."""
    blocks, problems = [], []
    fence = None
    for number, line in enumerate(document.read_text(encoding="utf-8").splitlines(), 1):
        if fence is None:
            start = re.match(r"( *)(`{3,}|~{3,})\s*([^`]*)$", line)
            if start:
                fence, body = (start.group(2), len(start.group(1)), number, start.group(3).strip()), []
        elif re.fullmatch(r" *" + fence[0][0] + "{%d,}\\s*" % len(fence[0]), line):
            blocks.append(Block(fence[2], fence[3], "".join(b + "\n" for b in body)))
            fence = None
        else:
            # A block inside a list is indented as a whole.
            indent = len(line) - len(line.lstrip(" "))
            body.append(line[min(indent, fence[1]):])
    if fence is not None:
        problems.append(f"line {fence[2]}: the block has no end")
    return blocks, problems


def names(text, word):
    return re.search(r"(?<![\w-])" + re.escape(word) + r"(?![\w-])", text) is not None


def is_used(block, later):
    """Whether a later block runs the file, by itself or through another file."""
    commands = "".join(b.text for b in later if b.kind == "sh")
    texts, files, grown = commands, [b for b in later if b.file], True
    tool = READ_BY.get(Path(block.file).name)
    if names(commands, block.file) or (tool and re.search(r"\b(%s)\b" % tool, commands)):
        return True
    while grown:
        grown = False
        for other in list(files):
            reader = READ_BY.get(Path(other.file).name)
            if names(texts, other.file) or (reader and re.search(r"\b(%s)\b" % reader, commands)):
                texts += other.text
                files.remove(other)
                grown = True
    return names(texts, block.file) or names(texts, Path(block.file).name)


def problems_of(blocks, may_be_empty):
    """What is wrong with a document before anything is run."""
    problems = []
    previous = ""
    for k, block in enumerate(blocks):
        where = f"line {block.line}"
        if block.info == "text":
            if previous != "sh":
                problems.append(f"{where}: a text block is what the sh block right before it prints; "
                                "there is none")
        elif block.file:
            path = Path(block.file)
            # The files after this one count as well: a project's parts come in any order.
            following = [b for b in blocks[k + 1:]] + [b for b in blocks[:k] if b.file]
            if path.is_absolute() or ".." in path.parts:
                problems.append(f"{where}: {block.file} is outside of the example's folder")
            elif not is_used(block, following):
                problems.append(f"{where}: no sh block after it uses {block.file}")
        elif block.kind in LANGUAGES:
            problems.append(f"{where}: '{block.info}' needs the name of one file to write")
        elif block.info not in ("", "sh"):
            problems.append(f"{where}: unknown kind of block '{block.info}'")
        if block.info:
            previous = block.info
    if not may_be_empty and not any(b.kind == "sh" for b in blocks):
        problems.append("no example: no sh block at all")
    return problems


def difference(expected, printed):
    """The first line of the output that is not as expected; None if all are."""
    expected = [line.rstrip() for line in expected.rstrip("\n").split("\n")]
    printed = [line.rstrip() for line in printed.rstrip("\n").split("\n")]
    k = 0
    for at, pattern in enumerate(expected):
        if pattern.strip() == "...":
            rest = expected[at + 1:]
            # Whatever follows must match some tail of what is left.
            for skip in range(k, len(printed) + 1):
                if not rest and skip == len(printed):
                    return None
                if rest and difference("\n".join(rest), "\n".join(printed[skip:])) is None:
                    return None
            return f"after line {k}, nothing matches what follows '...'"
        form = ".*".join(re.escape(part) for part in pattern.split("..."))
        if k >= len(printed):
            return f"line {k + 1} is missing: '{pattern}'"
        if not re.fullmatch(form, printed[k]):
            return f"line {k + 1} is '{printed[k]}', expected '{pattern}'"
        k += 1
    return None if k == len(printed) else f"line {k + 1} is not expected: '{printed[k]}'"


def shown(output):
    """The output as a terminal shows it in the end: a carriage return goes back to the beginning of the
    line, and what follows overwrites it. Meson draws a progress bar so where Python has tqdm."""
    lines = []
    for line in output.split("\n"):
        cells = ""
        for part in line.split("\r"):
            cells = part + cells[len(part):]
        lines.append(cells)
    return "\n".join(lines)


def execute(script, folder, environment, limit):
    """Runs one sh block; gives its exit status (None if it ran too long) and what it printed."""
    process = subprocess.Popen(["sh", "-eu", "-c", script], cwd=folder, env=environment,
                               stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, start_new_session=True)
    try:
        output, _ = process.communicate(timeout=limit)
        return process.returncode, shown(output.decode("utf-8", "replace"))
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        return None, process.communicate()[0].decode("utf-8", "replace")


def run_document(document, folder, environment, limit, may_be_empty):
    """Gives how many blocks did what they should, and what went wrong."""
    blocks, problems = blocks_of(document)
    problems += problems_of(blocks, may_be_empty)
    if problems:
        return 0, problems
    good = 0
    output = ""
    for block in blocks:
        if block.file:
            path = folder / block.file
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(block.text, encoding="utf-8")
            print(f"wrote {block.file} ({len(block.text.splitlines())} lines)")
        elif block.info == "sh":
            print("".join(f"$ {line}\n" for line in block.text.splitlines()), end="")
            status, output = execute(block.text, folder, environment, limit)
            print("".join(f"  {line}\n" for line in output.splitlines()), end="", flush=True)
            if status != 0:
                # What follows may need what this block should have made.
                how = f"ran longer than {limit} s" if status is None else f"ended with status {status}"
                return good, [f"line {block.line}: the sh block {how}"]
            good += 1
        elif block.info == "text":
            wrong = difference(block.text, output)
            if wrong:
                problems.append(f"line {block.line}: the output differs: {wrong}")
            else:
                good += 1
    return good, problems


def main():
    parser = argparse.ArgumentParser(description="Runs the examples of documents.")
    parser.add_argument("--prefix", type=Path, help="where mgdt is installed")
    parser.add_argument("--build", type=Path, help="a Meson build folder, installed to --scratch first")
    parser.add_argument("--scratch", type=Path, help="where the examples are run (default: a new folder)")
    parser.add_argument("--source", type=Path, default=Path(__file__).resolve().parents[2])
    parser.add_argument("--timeout", type=float, default=300, help="seconds for one sh block")
    parser.add_argument("--may-be-empty", action="append", default=[], metavar="NAME",
                        help="a document that need not have examples")
    parser.add_argument("--list", type=Path, metavar="SOURCE", help="print the documents of a source tree")
    parser.add_argument("documents", type=Path, nargs="*")
    options = parser.parse_args()
    if options.list:
        print("\n".join(str(d) for d in documents_of(options.list)))
        return 0
    if not options.documents:
        parser.error("no documents")
    if (options.prefix is None) == (options.build is None):
        parser.error("give one of --prefix and --build")

    scratch = (options.scratch or Path(tempfile.mkdtemp(prefix="mgdt-examples-"))).resolve()
    scratch.mkdir(parents=True, exist_ok=True)
    if options.build:
        prefix = installation.of_build(options.build.resolve(), scratch / "installed")
    else:
        prefix = installation.Installation(options.prefix.resolve())
    good = bad = 0
    for document in options.documents:
        name = re.sub(r"\W+", "-", document.stem)
        folder = scratch / name
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        home = scratch / (name + ".home")
        shutil.rmtree(home, ignore_errors=True)
        home.mkdir()
        print(f"== {document} in {folder}")
        environment = prefix.environment(options.source.resolve(), home)
        done, problems = run_document(document, folder, environment, options.timeout,
                                      document.name in options.may_be_empty)
        for problem in problems:
            print(f"failed: {document}: {problem}")
        good += done
        bad += len(problems)
    print(f"{len(options.documents)} documents: {good} passed, {bad} failed")
    return 1 if bad else 0


def documents_of(source):
    return [source / "README.md", *sorted((source / "docs").glob("*.md")), *sorted((source / "docs" / "theory").glob("*.md"))]


if __name__ == "__main__":
    sys.exit(main())
