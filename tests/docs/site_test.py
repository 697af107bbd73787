#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The site is made without a warning, has every document and every function of the C interface, and
what its pages link to within it is there, sections too.

  site_test.py SOURCE
"""
import re
import subprocess
import sys
import tempfile
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

sys.dont_write_bytecode = True  # the source tree stays as it is
sys.path.append(str(Path(__file__).resolve().parents[1]))
from checks import check, finish

source = Path(sys.argv[1]).resolve()


class Page(HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.names, self.links = set(), []
        self.text = path.read_text(encoding="utf-8")
        self.feed(self.text)

    def handle_starttag(self, tag, attributes):
        for key, value in attributes:
            if key in ("id", "name"):
                self.names.add(value)
            elif key in ("href", "src") and value:
                self.links.append(value)


def broken_links(pages, folder):
    for name, page in pages.items():
        for link in page.links:
            # The second is a link of Doxygen's own, to a table that it leaves out.
            if re.match(r"\w+:", link) or link == "#nested-classes":
                continue
            path, _, section = unquote(link).partition("#")
            file = path or name
            if not (folder / file).exists():
                yield f"{name}: {link}"
            elif section and file in pages and section not in pages[file].names:
                yield f"{name}: {link} (no such section)"


def main():
    with tempfile.TemporaryDirectory() as temporary:
        done = subprocess.run([sys.executable, source / "docs" / "site" / "make.py", source, temporary],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        check("the site is made without a warning", done.stdout if done.returncode else "")
        folder = Path(temporary) / "html"
        pages = {path.name: Page(path) for path in folder.glob("*.html")}
        check("links within it", "\n".join(broken_links(pages, folder)))
        documents = {path.stem for folder_ in ("docs", "docs/theory") for path in (source / folder_).glob("*.md")}
        check("a page for each document", " ".join(sorted(d for d in documents if f"page-{d}.html" not in pages)))
        header = (source / "include" / "mgdt" / "mgdt.h").read_text(encoding="utf-8")
        functions = re.findall(r"^MGDT_API [^;]*?(mgdt_\w+)\(", header, re.MULTILINE)
        reference = pages["mgdt_8h.html"].text
        check("functions", "" if len(functions) > 80 else f"only {len(functions)} in mgdt.h")
        described = " ".join(re.sub(r"<[^>]*>", "", name) for name in re.findall(r'class="memname">(.*?)</td>', reference))
        check("each in the reference", " ".join(f for f in functions if not re.search(rf"\b{f}\b", described)))
        check("classes of C++", "" if "classmgdt_1_1cxx1_1_1Triangulation.html" in pages else "no Triangulation")
        check("search", "" if any((folder / "search").glob("all_*.js")) else "no index")
        # What Doxygen took for something else than the document meant.
        check("no markup is left over", " ".join(name for name, page in pages.items()
                                                 if name.startswith("page-") and re.search(r"ilinebr|&lt;/?td|@ref", page.text)))
        # A broken link would be seen.
        pages["index.html"].links.append("nowhere.html")
        check("a broken link is seen", "" if list(broken_links(pages, folder)) else "not")
    finish()


main()
