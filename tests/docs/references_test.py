#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What documents refer to is there: files that are linked, sections, functions of the C interface;
and docs/c.md lists each of these.

  references_test.py SOURCE DOCUMENT...
"""
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
sys.path.append(str(Path(__file__).resolve().parents[1]))
from checks import check, finish

# Documents that are to be read at one sitting.
MOST_WORDS = {"architecture.md": 2000, "performance.md": 2000}


def headings(text):
    """The names under which a document's sections can be linked."""
    found = set()
    for title in re.findall(r"^#+ +(.*)$", text, flags=re.M):
        found.add(re.sub(r"[^\w -]", "", title.lower()).replace(" ", "-"))
    return found


def prose(text):
    return re.sub(r"^ *(`{3,}).*?^ *\1\s*$", "", text, flags=re.M | re.S)


def broken_links(document):
    text = prose(document.read_text(encoding="utf-8"))
    problems = []
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        if re.match(r"\w+:", target):
            continue
        path, _, section = target.partition("#")
        file = (document.parent / path) if path else document
        if not file.exists():
            problems.append(target)
        elif section and file.suffix == ".md" and section not in headings(file.read_text(encoding="utf-8")):
            problems.append(f"{target} (no such section)")
    return problems


def missing_paths(source, text):
    """Files and folders that are named from the root of the source, in code blocks too, and are not
    there. A program that the tests build is named without its ending."""
    named = set(re.findall(r"(?<![\w/.@-])((?:src|tests|docs|include|bindings)/[\w./-]*\w)", text))
    endings = ("", ".hpp", ".cpp", ".c", ".f90", ".f")
    return sorted(n for n in named if not any((source / (n + end)).exists() for end in endings))


def missing_sources(source, text):
    """Sources that are named by their folder, in a drawing too, and are not there."""
    folders = "|".join(sorted(f.name for f in (source / "src").iterdir() if f.is_dir()))
    named = set(re.findall(rf"(?<![\w/])(?:src/)?((?:{folders})/[\w./]*\w)", text))
    return sorted(n for n in named if not any((source / "src" / (n + end)).exists()
                                              for end in ("", ".hpp", ".cpp")))


def missing_sections(source):
    """Sections of docs/theory.md that comments name and that no chapter has."""
    titles = {title for chapter in (source / "docs" / "theory").glob("*.md")
              for title in re.findall(r"^(?:#+ +|\*\*)(.*?)(?:$|\.?\*\*)", chapter.read_text(encoding="utf-8"), flags=re.M)}
    named = set()
    for folder in ("src", "include", "tests", "bindings"):
        for path in (source / folder).rglob("*"):
            if path.suffix in (".hpp", ".cpp", ".h", ".c"):
                text = re.sub(r"\n\s*(?://|\*|#)\s*", " ", path.read_text(encoding="utf-8"))
                named.update(re.findall(r'docs/theory\.md[,:]? "([^"]+)"', text))
    return sorted(named - titles) if named else ["none is named"]


def main():
    source, documents = Path(sys.argv[1]), [Path(p) for p in sys.argv[2:]]
    header = "".join((source / "include" / "mgdt" / name).read_text(encoding="utf-8")
                     for name in ("mgdt.h", "mgdt_voronoi.h", "mgdt_domain.h", "mgdt_mesh.h", "mgdt_periodic.h"))
    functions = set(re.findall(r"^MGDT_API\b[^;(]*?\b(mgdt_\w+)\s*\(", header, flags=re.M))
    all_headers = "".join(p.read_text(encoding="utf-8") for p in (source / "include" / "mgdt").glob("*.h"))
    known = set(re.findall(r"\b(?:mgdt|MGDT)_\w+\b", all_headers))
    check("sections of theory.md that comments name", ", ".join(missing_sections(source)))
    check("the header has functions", "" if len(functions) >= 50 else str(len(functions)))
    for document in documents:
        name = document.relative_to(source)
        text = document.read_text(encoding="utf-8")
        check(f"links of {name}", " ".join(broken_links(document)))
        # Other languages' documents have names of their own.
        if document.name in ("README.md", "abi.md", "architecture.md", "c.md", "cxx.md", "trust.md"):
            named = set(re.findall(r"`(mgdt_\w+)(?:\(\))?`", prose(text)))
            check(f"functions that {name} names", " ".join(sorted(named - known)))
        check(f"paths that {name} names", " ".join(missing_paths(source, text)))
        if document.name in MOST_WORDS:
            words = len(re.findall(r"\S*\w\S*", text))
            check(f"length of {name}", "" if words <= MOST_WORDS[document.name] else f"{words} words")
        if document.name == "architecture.md":
            check(f"sources that {name} names", " ".join(missing_sources(source, text)))
        if document.name == "c.md":
            table = text.split("## Functions")[-1]
            listed = re.findall(r"`(mgdt_\w+)`", table)
            check("each function in the table, once", " ".join(sorted(functions ^ set(listed) |
                  {f for f in listed if listed.count(f) > 1})))
    check("one of the documents has the table", "" if any(d.name == "c.md" for d in documents) else "none has")
    finish()


if __name__ == "__main__":
    main()
