#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes docs/files.md, which says of each file of src what it has: the first sentence of the comment
that the file begins with.

  files.py [--check]

With --check nothing is written, and the exit status is 1 if the document is not what would be written.
Files without such a comment are an error.
"""
import re
import sys
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[1]
DOCUMENT = SOURCE / "docs" / "files.md"
ENDINGS = (".hpp", ".h", ".cpp", ".c")
HEAD = """# The files of the source

What each file of `src/` has, by folder. [architecture.md](architecture.md) says what the folders are and how they depend on each
other. `python3 docs/files.py` writes this page from the first sentences of the files. A name without an ending is that of a header
and of the source with the same name.
"""


def opening(path):
    """The first paragraph of the comment after the licence, as one line; nothing if there is none."""
    text = path.read_text(encoding="utf-8")
    comment = re.match(r"// SPDX[^\n]*\n((?://[^\n]*\n)+)", text) or re.match(r"/\* SPDX[^\n]*\n((?: \*[^\n]*\n)+)", text)
    if not comment:
        return ""
    lines = [re.sub(r"^ ?(?://|\*/?) ?", "", line).strip() for line in comment.group(1).splitlines()]
    lines = lines[next((i for i, line in enumerate(lines) if line), 0):]
    return " ".join(lines[:lines.index("")] if "" in lines else lines)


def sentence(path):
    """What a file has. A header that only includes another one has what that has."""
    found = opening(path)
    if not found:
        code = [line for line in path.read_text(encoding="utf-8").splitlines()[1:] if line and line != "#pragma once"]
        included = re.fullmatch(r'#include "(.*)"', code[0]) if len(code) == 1 else None
        return f"The same as `{included.group(1)}`." if included else ""
    # A full stop behind one letter belongs to an initial.
    return re.split(r"(?<![ .][A-Za-z])\. ", found)[0].rstrip(".:") + "."


def rows(folder):
    names = {}
    for path in sorted(p for p in folder.iterdir() if p.suffix in ENDINGS):
        names.setdefault(path.stem, []).append(path)
    for stem, paths in sorted(names.items()):
        paths.sort(key=lambda p: ENDINGS.index(p.suffix))
        text = next(filter(None, map(sentence, paths)), "")
        if not text:
            sys.exit(f"{paths[0].relative_to(SOURCE)} begins with no comment that says what it has")
        yield (stem if len(paths) > 1 else paths[0].name), text.replace("|", "\\|")


def page():
    text = HEAD
    folders = sorted({p.parent for p in (SOURCE / "src").rglob("*") if p.suffix in ENDINGS})
    for folder in folders:
        text += f"\n## {folder.relative_to(SOURCE)}\n\n| file | what it has |\n|---|---|\n"
        text += "".join(f"| `{name}` | {what} |\n" for name, what in rows(folder))
    return text


if __name__ == "__main__":
    if sys.argv[1:] not in ([], ["--check"]):
        sys.exit(__doc__)
    wanted = page()
    if sys.argv[1:]:
        if DOCUMENT.read_text(encoding="utf-8") != wanted:
            sys.exit("docs/files.md is not up to date: python3 docs/files.py")
        print("docs/files.md has each file of src\n1 passed, 0 failed")
    else:
        DOCUMENT.write_text(wanted, encoding="utf-8")
