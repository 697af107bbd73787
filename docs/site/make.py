#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the site: the documents and the reference of the C and C++ headers, by Doxygen.

  make.py SOURCE FOLDER

The site is FOLDER/html/index.html. Documents are written for readers of Markdown files, with links
from file to file; before Doxygen reads them, headings get names and links lead to pages of the site.
Fails if Doxygen has a warning.
"""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

# In the order of the menu.
THEORY = ["predicates", "triangulation", "cells", "values", "domains", "improving", "refining", "boxes", "parts"]
DOCUMENTS = ["README", "installation", "periodic", "mesh", "refinement", "improvement", "gallery", "c", "cxx", "fortran", "python", "mpi", "other-languages", "program", "platforms",
             "performance", "trust", "theory", *(f"theory/{name}" for name in THEORY), "paper", "architecture", "files", "glossary", "experiments", "security", "abi",
             "contributing", "changelog"]
FENCE = re.compile(r"^ *(`{3,})(.*)$")
CODE_SPAN = re.compile(r"(`+)(?!`)(.+?)(?<!`)\1(?!`)", re.DOTALL)


def slug(title):
    """The name under which a heading is linked, as usual for Markdown."""
    return re.sub(r"[^\w -]", "", title.lower()).replace(" ", "-")


def title(document):
    return re.search(r"^# +(.*)$", document.read_text(encoding="utf-8"), re.MULTILINE).group(1)


def page(document):
    return "page-" + document.lower()


class Site:
    def __init__(self, source, folder):
        self.source, self.folder = source, folder
        self.staged = folder / "staged"
        self.files = set()  # that pages link to, below the source

    def target(self, link, document):
        """What a link leads to in the site."""
        if re.match(r"\w+:", link):
            return link
        path, _, section = link.partition("#")
        if not path:
            return f"#{page(document.stem)}-{section}"
        file = Path(os.path.normpath(document.parent / path))
        if file.suffix == ".md":
            return f"#{page(file.stem)}" + (f"-{section}" if section else "")
        if file.is_dir():
            return None
        if file.parent.name == "mgdt" and "include" in file.parts:
            return file.name.replace("_", "__").replace(".", "_8") + ".html"
        self.files.add(file)
        return file.name

    def prose(self, text, document):
        """A piece without code blocks."""
        kept = []

        def keep(match):
            span = match.group()
            # Doxygen takes `' for quotation marks, in code spans too.
            if "'" in span:
                inside = match.group(2).replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
                span = "<code>" + re.sub(r"([\\@*_#]|--)", r"\\\1", inside) + "</code>"
            kept.append(span)
            return f"\0{len(kept) - 1}\0"

        def link(match):
            shown, where = match.groups()
            target = self.target(where, document)
            if target is None:
                return shown
            if shown == where and where.endswith(".md"):
                shown = title(document.parent / where)
            # Doxygen's own reference: its Markdown has no links to sections of other pages.
            if target.startswith("#"):
                return f'@ref {target[1:]} "{shown}"'
            return f'<a href="{target}">{shown}</a>'

        text = CODE_SPAN.sub(keep, text)
        text = re.sub(r"!\[([^]]*)\]\(([^)\s]+)\)", lambda m: self.picture(*m.groups(), document), text)
        # A bar that is no border of a table stays escaped.
        text = re.sub(r"(\\(?!\|)|@)", r"\\\1", text)
        text = re.sub(r"(?<!!)\[([^]]+)\]\(([^)\s]+)\)", link, text)
        text = re.sub("\0(\\d+)\0", lambda m: kept[int(m.group(1))], text)
        return text

    def picture(self, about, path, document):
        self.files.add(Path(os.path.normpath(document.parent / path)))
        return f'<img src="{Path(path).name}" alt="{about}">'

    def stage(self, document):
        """The document as Doxygen reads it."""
        out, block, fence = [], [], None
        seen = False

        def flush():
            out.append(self.prose("\n".join(block), document))
            block.clear()

        for line in document.read_text(encoding="utf-8").split("\n"):
            match = FENCE.match(line)
            if fence is None and match:
                flush()
                fence = match.group(1)
                # Behind the language stands a file's name.
                language = match.group(2).split()
                out.append(fence + (language[0] if language and language[0] != "text" else ""))
            elif fence is not None:
                out.append(line)
                if match and match.group(1) == fence and not match.group(2).strip():
                    fence = None
            else:
                heading = re.match(r"(#+) +(.*)$", line)
                if heading:
                    name = page(document.stem) + ("-" + slug(heading.group(2)) if seen else "")
                    seen = True
                    line = f"{line} {{#{name}}}"
                block.append(line)
        flush()
        (self.staged / (document.stem + ".md")).write_text("\n".join(out), encoding="utf-8")

    def make(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        self.staged.mkdir(parents=True)
        for name in DOCUMENTS:
            document = self.source / ("README.md" if name == "README" else f"docs/{name}.md")
            if document.exists():
                self.stage(document)
        headers = sorted((self.source / "include" / "mgdt").rglob("*.h*"))
        headers += sorted((self.source / "src" / "mpi" / "include" / "mgdt").glob("*.h"))
        version = re.search(r"version: '(.*)'", (self.source / "meson.build").read_text()).group(1)
        staged = [self.staged / f"{Path(name).name}.md" for name in DOCUMENTS
                  if (self.staged / f"{Path(name).name}.md").exists()]
        settings = {
            "PROJECT_NAME": "mgdt", "PROJECT_NUMBER": version,
            "PROJECT_BRIEF": '"Exact 3D Delaunay triangulation of any set of points"',
            "OUTPUT_DIRECTORY": self.folder, "INPUT": [*staged, *headers],
            "USE_MDFILE_AS_MAINPAGE": self.staged / "README.md",
            "HTML_EXTRA_FILES": sorted(self.files),
            "HTML_EXTRA_STYLESHEET": self.source / "docs" / "site" / "site.css",
            "STRIP_FROM_PATH": [self.staged, self.source / "include", self.source],
            "STRIP_FROM_INC_PATH": self.source / "include",
            "PREDEFINED": ["MGDT_API=", "MGDT_PARTS_API=", "__cplusplus=201703L"],
            "MACRO_EXPANSION": "YES", "EXPAND_ONLY_PREDEF": "YES", "EXTRACT_ALL": "YES", "EXTRACT_STATIC": "YES",
            "JAVADOC_AUTOBRIEF": "YES", "SORT_MEMBER_DOCS": "NO", "GENERATE_LATEX": "NO", "GENERATE_TREEVIEW": "YES",
            "DISABLE_INDEX": "YES", "SEARCHENGINE": "YES", "HAVE_DOT": "NO", "QUIET": "YES",
            "TOC_INCLUDE_HEADINGS": "3", "WARN_IF_UNDOCUMENTED": "NO", "WARN_NO_PARAMDOC": "NO", "WARN_IF_INCOMPLETE_DOC": "NO",
            "WARN_LOGFILE": self.folder / "warnings", "SHOW_USED_FILES": "NO", "HTML_TIMESTAMP": "NO",
        }
        with open(self.folder / "Doxyfile", "w", encoding="utf-8") as out:
            for key, value in settings.items():
                words = value if isinstance(value, list) else [value]
                out.write(f"{key} = {' '.join(map(str, words))}\n")
        subprocess.run(["doxygen", self.folder / "Doxyfile"], check=True)
        return (self.folder / "warnings").read_text(encoding="utf-8")


def main():
    warnings = Site(*(Path(argument).resolve() for argument in sys.argv[1:3])).make()
    sys.stderr.write(warnings)
    return 1 if warnings else 0


if __name__ == "__main__":
    sys.exit(main())
