#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints a document as it is installed: in the folders of docs, with links that lead to where the other
files are installed. A link to a file that is not installed becomes plain text.

  installed.py SOURCE DOCUMENT DOCUMENTS INCLUDES BINDINGS [BINDING...]

DOCUMENTS, INCLUDES and BINDINGS are the folders of documents, headers and bindings, absolute or all
below one prefix; the bindings that are installed follow.
"""
import os
import re
import sys
from pathlib import Path


class Places:
    def __init__(self, documents, includes, bindings, installed):
        self.documents, self.includes, self.bindings, self.installed = documents, includes, bindings, installed

    def of(self, path):
        """Where a file or a folder of the source is when it is installed; None if nowhere."""
        folder, _, rest = path.partition("/")
        if path in ("LICENSE", "README.md", "."):
            return os.path.join(self.documents, path)
        if folder == "docs":
            return os.path.join(self.documents, rest)
        if folder == "include":
            return os.path.join(self.includes, rest)
        if folder == "bindings" and rest.split("/")[0] in self.installed:
            return os.path.join(self.bindings, rest)
        return None


def relink(text, folder, places):
    """The text of a document of the source's `folder`, with links for the installed one."""

    def link(match):
        target, _, section = match.group("target").partition("#")
        if not target or re.match(r"\w+:", target):
            return match.group()
        place = places.of(os.path.normpath(os.path.join(folder, target)))
        if place is None:
            return match.group("text")
        place = os.path.relpath(place, places.of(folder))
        return f"{match.group('image')}[{match.group('text')}]({place}{'#' + section if section else ''})"

    # Code is left as it is: `[](double x)` is no link.
    parts = re.split(r"(^ *(`{3,}).*?^ *\2\s*$)", text, flags=re.M | re.S)
    for k in range(0, len(parts), 3):
        parts[k] = re.sub(r"(?P<image>!?)\[(?P<text>[^][]*)\]\((?P<target>[^)\s]+)\)", link, parts[k])
    del parts[2::3]
    return "".join(parts)


def main():
    source, document, documents, includes, bindings, *installed = sys.argv[1:]
    folder = os.path.relpath(os.path.dirname(document), source)
    text = Path(document).read_text(encoding="utf-8")
    sys.stdout.reconfigure(encoding="utf-8")
    print(relink(text, folder, Places(documents, includes, bindings, installed)), end="")


if __name__ == "__main__":
    main()
