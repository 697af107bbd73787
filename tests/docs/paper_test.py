#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""docs/paper.md and what it is made of: the published figures add up, the document and its plots are
those of the figures beside them, and the scripts make them of any others.

  paper_test.py SOURCE MGDT
"""
import csv
import json
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from collections import Counter
from pathlib import Path

from PIL import Image

SOURCE, MGDT = Path(sys.argv[1]), sys.argv[2]
PAPER = SOURCE / "docs" / "paper"
HEADING = (
    "library,version,distribution,points,seed,scheme,threads,run,status,np,nr,created,order_seconds,"
    "insert_seconds,total_seconds,bytes_per_point,peak_rss_bytes,inserted,duplicates,tetrahedra,"
    "levels,rounds,system_seconds,user_seconds,alone_percent"
)


def run(script, *arguments):
    # Without bytecode: the source tree stays as it is.
    command = [sys.executable, "-B", PAPER / script, *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=600)


def line(distribution, points, scheme, total, **more):
    """A row of `mgdt-bench`: an order that takes a tenth of the time, NP 2 and NR 20, no time in the
    system."""
    row = dict.fromkeys(HEADING.split(","), "")
    row.update(library="mgdt", version="1.2.3", distribution=distribution, points=points, seed=1)
    row.update(scheme=scheme, threads=1, run=1, status="ok")
    if total is not None:
        row.update(np=2, nr=20, order_seconds=total / 10, insert_seconds=0.9 * total)
        row.update(total_seconds=total, user_seconds=total)
    row.update(more)
    return ",".join(str(v) for v in row.values())


class PublishedFigures(unittest.TestCase):
    def setUp(self):
        with open(PAPER / "lo-2014.csv", newline="") as file:
            self.rows = list(csv.DictReader(file))

    def test_totals_are_sums(self):
        checked = 0
        for row in self.rows:
            if row["table"] == "1":
                continue
            grid, insert, total = (float(row[f"{c}_seconds"]) for c in ("grid", "insert", "total"))
            self.assertAlmostEqual(grid + insert, total, places=9, msg=row)
            checked += 1
        self.assertEqual(checked, 6 * 25 + 6 + 6)

    def test_all_are_there(self):
        count = Counter((row["table"], row["scheme"]) for row in self.rows)
        self.assertEqual(count[("1", "regular-grid")], 6)
        for table in "234567":
            sizes = [row["points"] for row in self.rows
                     if row["table"] == table and row["scheme"] == "multi-grid"]
            self.assertEqual([int(s) / 1e6 for s in sizes], [0.4, 0.8, 1.2, 1.6, 2, 4, 8, 12, 16, 20])
            self.assertEqual(count[(table, "enhanced-kd-tree")], 10)
            self.assertEqual(count[(table, "regular-grid")], 5)

    def test_both_grids_remove_as_many(self):
        # The paper prints the same NR for both in every line.
        nr = {(r["table"], r["distribution"], r["points"], r["scheme"]): r["nr"] for r in self.rows}
        for (*line, scheme), value in nr.items():
            if scheme == "regular-grid" and line[0] != "1":
                self.assertEqual(value, nr[(*line, "multi-grid")], line)


class Document(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.copy = self.folder / "paper.md"
        shutil.copy(SOURCE / "docs" / "paper.md", self.copy)

    def report(self, *arguments):
        return run("report.py", "--document", self.copy, "--plots", self.folder, *arguments)

    def of(self, *lines):
        """The report of these rows: the document's blocks by their names."""
        (self.folder / "bench.csv").write_text("\n".join([HEADING, *lines]) + "\n")
        machine = {"cpu": "Abacus", "cores": 3, "memory_bytes": 2**33}
        header = {"machine": machine, "command": "mgdt-bench", "version": "1.2.3", "rows": []}
        (self.folder / "bench.json").write_text(json.dumps(header))
        done = self.report(
            "--csv", self.folder / "bench.csv", "--json", self.folder / "bench.json",
            "--figures", self.folder / "figures.csv", "--header", self.folder / "figures.json",
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        parts = re.findall(r"<!-- ([\w ]+) -->\n(.*?)<!-- end -->", self.copy.read_text(), re.S)
        return dict(parts)

    def cells(self, block, *line):
        """The cells behind the first two of a table's line; a line without a first cell continues
        the one above."""
        above = ""
        for row in block.splitlines():
            cells = [c.strip() for c in row.strip("|").split("|")]
            above = cells[0] or above
            if row.startswith("|") and (above, cells[1]) == line:
                return cells[2:]
        self.fail(f"no line {line} in {block}")

    def test_is_what_the_figures_give(self):
        done = self.report()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.copy.read_text(), (SOURCE / "docs" / "paper.md").read_text(),
                         "run docs/paper/report.py")
        made = sorted(self.folder.glob("*.png"))
        self.assertEqual([path.name for path in made], ["cost.png", "np.png", "nr.png"])
        for path in made:
            with Image.open(path) as ours, Image.open(PAPER / path.name) as kept:
                self.assertEqual(ours.size, kept.size, path.name)
                self.assertEqual(ours.text["figures"], kept.text["figures"],
                                 f"{path.name} is of other figures: run docs/paper/report.py")

    def test_medians_ratios_and_growth(self):
        blocks = self.of(
            *[line("line", 400000, "multi-grid", t, run=r) for r, t in ((1, 1.0), (2, 9.0), (3, 2.0))],
            line("line", 400000, "auto", 0.5),
            line("line", 2000000, "auto", 5, nr=23.456),
            line("line", 20000000, "auto", 75, nr=34.56, user_seconds=50),
            line("line", 400000, "hilbert", 1.0, user_seconds=0.75),
            line("uniform", 1000000, "brio", 2.0), line("mild-line", 1000000, "brio", 5.0),
            line("ellipse", 800000, "auto", 3.0),
        )
        # The paper's columns, brio, hilbert and random; times by that of auto.
        self.assertEqual(self.cells(blocks["time"], "line", "0.4M"),
                         ["2.92 / -", "1.00 / 4.00", "1.10 / -", "-", "1.50", "-"])
        self.assertEqual(self.cells(blocks["np"], "line", "0.4M"),
                         ["212 / -", "30.6 / 2.00", "8.91 / -", "-", "2.00"])
        self.assertEqual(self.cells(blocks["nr"], "line", "2M"),
                         ["19.3 / -", "19.3 / 23.5", "37.9 / -", "-", "-"])
        self.assertEqual(self.cells(blocks["table 1"], "mild-line", "1M"),
                         ["1.06 / -", "-", "-", "2.50", "-", "-"])
        # The order takes a tenth of mgdt's time.
        self.assertEqual(self.cells(blocks["growth"], "line", "0.4M to 20M"),
                         ["1.25", "2.50", "10.0", "0.46", "24.1"])
        # From 1.25 to 2.5 µs; in the paper from 3.88 s for 0.4M to 278.48 s for 20M.
        self.assertEqual(self.cells(blocks["summary"], "line", "20M"),
                         ["21.2", "9.37", "2.00", "19.7", "38.7", "34.6", "+44%", "+100%"])
        self.assertEqual(self.cells(blocks["summary"], "ellipse", "0.8M")[-2:], ["-", "-"])
        self.assertEqual(self.cells(blocks["summary"], "uniform", "-"), ["-"] * 8)
        self.assertIn("Abacus, 3 cores, 8 GiB", blocks["header"])
        self.assertIn("medians of 1 to 3 runs", blocks["header"])
        self.assertIn("No other library", blocks["peers"])

    def test_failures_are_shown(self):
        blocks = self.of(
            line("line", 400000, "multi-grid", None, status="timeout"),
            line("line", 400000, "auto", 1.0),
            line("line", 400000, "auto", None, run=2, status="signal 11"),
            line("machine", 3318541, "hilbert", None, status="signal 9"),
            line("line", 400000, "", None, library="tetgen", status="error: exit code 1"),
            line("line", 400000, "", 4.0, library="cgal", user_seconds=3.0),
            line("sphere", 400000, "auto", 1.0), line("line", 400000, "auto", 1.0, threads=2),
        )
        self.assertEqual(self.cells(blocks["time"], "line", "0.4M")[1], "1.00 / timeout")
        self.assertIn("line, 0.4M, multi-grid: timeout.", blocks["time"])
        self.assertEqual(self.cells(blocks["np"], "line", "0.4M")[1], "30.6 / 2.00*")
        self.assertIn("* line, 0.4M, auto: 1 of 2: signal 11", blocks["np"])
        self.assertEqual(self.cells(blocks["table 9"], "NR", "machine")[-1], "signal 9")
        self.assertIn("| line | 0.4M | 3.00 | error: exit code 1 |", blocks["peers"])
        self.assertIn("sphere, 0.4M, auto", blocks["header"])
        self.assertIn("1 of several threads", blocks["header"])

    def test_other_tables_are_refused(self):
        bad = self.folder / "bad.csv"
        bad.write_text("a,b\n1,2\n")
        done = self.report("--csv", bad, "--figures", self.folder / "figures.csv")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("bad.csv", done.stderr)
        self.assertFalse((self.folder / "figures.csv").exists())
        self.copy.write_text(self.copy.read_text().replace("<!-- growth -->", ""))
        self.assertIn("growth", self.report().stderr)


class Pictures(unittest.TestCase):
    def test_are_drawn(self):
        with tempfile.TemporaryDirectory() as folder:
            done = run("pictures.py", "--mgdt", MGDT, "--out", folder, "--points", 300,
                       "--nodes", 16000)
            self.assertEqual(done.returncode, 0, done.stderr)
            made = {path.name for path in Path(folder).glob("*.png")}
            linked = re.findall(r"\(paper/([\w-]+\.png)\)", (SOURCE / "docs" / "paper.md").read_text())
            plots = {"np.png", "nr.png", "cost.png"}
            self.assertEqual(made, set(linked) - plots)
            for name in made:
                with Image.open(Path(folder) / name) as picture:
                    self.assertGreater(len(picture.convert("RGB").getcolors(1 << 20)), 5, name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
