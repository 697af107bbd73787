#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The licence and the documents of an installed mgdt: all of the source's are there, and each link of
theirs leads to a file that is.

  documents_test.py SOURCE PREFIX [BINDING...]    the bindings that are installed
"""
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
sys.path[:0] = [str(Path(__file__).resolve().parents[1]), str(Path(__file__).resolve().parents[1] / "docs")]
from checks import check, differences, finish
from references_test import broken_links, prose


def targets(document):
    """The files that a document links."""
    found = re.findall(r"\]\(([^)\s#]+)[^)\s]*\)", prose(document.read_text(encoding="utf-8")))
    return {target for target in found if not re.match(r"\w+:", target)}


def main():
    source, prefix, *bindings = sys.argv[1:]
    source, documents = Path(source), Path(prefix) / "share" / "doc" / "mgdt"
    check("the licence", "" if (documents / "LICENSE").read_bytes() == (source / "LICENSE").read_bytes() else "differs")
    folders = ("", "theory")
    originals = {path.name: path for folder in folders for path in (source / "docs" / folder).glob("*.md")}
    originals["README.md"] = source / "README.md"
    places = {path.name: path for folder in folders for path in (documents / folder).glob("*.md")}
    installed = set(places)
    check("all documents", differences(set(originals), installed))
    for name in sorted(installed & set(originals)):
        document = places[name]
        check(f"links of {name}", " ".join(broken_links(document)))
        # The words stay, whatever becomes of the links.
        words = lambda path: re.sub(r"\]\([^)]*\)|[][]", "", path.read_text(encoding="utf-8"))
        check(f"text of {name}", "" if words(document) == words(originals[name]) else "differs")
        lost = {t for t in targets(originals[name]) if Path(t).name not in {Path(u).name for u in targets(document)}}
        lost = {t for t in lost if not re.match(r"(\.\./)?bindings/", t) or t.split("bindings/")[1].split("/")[0] in bindings}
        check(f"no link of {name} is lost", " ".join(sorted(lost)))
    finish()


if __name__ == "__main__":
    main()
