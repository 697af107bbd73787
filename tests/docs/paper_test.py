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
    "levels,rounds,system_seconds"
)


def run(script, *arguments):
    # Without bytecode: the source tree stays as it is.
    command = [sys.executable, "-B", PAPER / script, *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=600)


def line(distribution, points, scheme, total, **more):
    """A row of `mgdt bench`: an order that takes a tenth of the time, NP 2 and NR 20."""
    row = dict.fromkeys(HEADING.split(","), "")
    row.update(library="mgdt", version="1.2.3", distribution=distribution, points=points, seed=1)
    row.update(scheme=scheme, threads=1, run=1, status="ok")
    if total is not None:
        row.update(np=2, nr=20, order_seconds=total / 10, insert_seconds=0.9 * total)
        row.update(total_seconds=total)
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
        header = {"machine": machine, "command": "mgdt bench", "version": "1.2.3", "rows": []}
        (self.folder / "bench.json").write_text(json.dumps(header))
        done = self.report(
            "--csv", self.folder / "bench.csv", "--json", self.folder / "bench.json",
            "--figures", self.folder / "figures.csv", "--header", self.folder / "figures.json",
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        parts = re.findall(r"<!-- ([\w ]+) -->\n(.*?)<!-- end -->", self.copy.read_text(), re.S)
        return dict(parts)

    def cells(self, block, quantity, first):
        """The cells of one line: of the rows from the one that names the quantity on."""
        rows = [[c.strip() for c in row.strip("|").split("|")] for row in block.splitlines()
                if row.startswith("|")]
        start = next(i for i, row in enumerate(rows) if row[0] == quantity)
        return next(row[2:] for row in rows[start:] if row[1] == first)

    def test_is_what_the_figures_give(self):
        done = self.report()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.copy.read_text(), (SOURCE / "docs" / "paper.md").read_text(),
                         "run docs/paper/report.py")
        made = sorted(self.folder.glob("*.png"))
        self.assertGreaterEqual(len(made), 4)
        for path in made:
            with Image.open(path) as ours, Image.open(PAPER / path.name) as kept:
                self.assertEqual(ours.size, kept.size, path.name)
                self.assertEqual(ours.text["figures"], kept.text["figures"],
                                 f"{path.name} is of other figures: run docs/paper/report.py")

    def test_medians_ratios_and_growth(self):
        blocks = self.of(
            *[line("line", 400000, "multi-grid", t, run=r) for r, t in ((1, 1.0), (2, 9.0), (3, 2.0))],
            line("line", 400000, "auto", 0.5, system_seconds=0.1),
            line("line", 800000, "auto", 3.0, nr=23.456, system_seconds=1.4),
            line("ellipse", 400000, "auto", 1.0), line("ellipse", 800000, "auto", 3.0),
        )
        table = blocks["table 3"]
        ratio = self.cells(table, "time / multi-grid's", "0.4M")
        self.assertEqual(ratio[:2], ["2.92 / not run", "1.00 / 1.00"])
        self.assertEqual(ratio[-1], "0.25")
        self.assertEqual(self.cells(table, "cost a point / that of the fewest", "0.8M")[-1], "3.00")
        self.assertEqual(self.cells(table, "NP", "0.4M")[0], "212 / not run")
        self.assertEqual(self.cells(table, "NR", "0.8M")[-1], "23.5")
        # Of the paper's multi-grid: 3.85 s for 0.4M and 8.3 s for 0.8M.
        self.assertRegex(blocks["linear"], r"\| line .*\| \+200% \| 1.75 \| \+100% \| \+8% \| 10.0% \|")
        self.assertRegex(blocks["linear"], r"\| ellipse .*\| \+50% \| - \| - \|")
        self.assertIn("| line | 0.8M | 28.9 | 9.06 | 2.00 | 19.0 | 38.3 | 23.5 |", blocks["summary"])
        self.assertIn("| uniform | not run |", blocks["summary"])
        self.assertIn("Abacus, 3 cores, 8 GiB", blocks["header"])
        self.assertIn("No other library", blocks["peers"])
        self.assertFalse((self.folder / "peers.png").exists())

    def test_failures_are_shown(self):
        blocks = self.of(
            line("line", 400000, "multi-grid", None, status="timeout"),
            line("line", 400000, "auto", 1.0),
            line("line", 400000, "auto", None, run=2, status="signal 11"),
            line("line", 400000, "", None, library="tetgen", status="error: exit code 1"),
            line("line", 400000, "", 4.0, library="cgal"),
            line("sphere", 400000, "auto", 1.0), line("line", 400000, "auto", 1.0, threads=2),
        )
        row = self.cells(blocks["table 3"], "NP", "0.4M")
        self.assertEqual((row[1], row[-1]), ("30.6 / timeout", "2.00*"))
        self.assertEqual(self.cells(blocks["table 3"], "time / multi-grid's", "0.4M")[-1], "no base")
        self.assertIn("1 of 2: signal 11", blocks["table 3"])
        self.assertIn("| line | 0.4M | 4.00 | error: exit code 1 |", blocks["peers"])
        self.assertIn("sphere, 0.4M, auto", blocks["header"])
        self.assertIn("1 of several threads", blocks["header"])
        self.assertTrue((self.folder / "peers.png").exists())

    def test_other_tables_are_refused(self):
        bad = self.folder / "bad.csv"
        bad.write_text("a,b\n1,2\n")
        done = self.report("--csv", bad, "--figures", self.folder / "figures.csv")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("bad.csv", done.stderr)
        self.assertFalse((self.folder / "figures.csv").exists())
        self.copy.write_text(self.copy.read_text().replace("<!-- table 5 -->", ""))
        self.assertIn("table 5", self.report().stderr)


class Pictures(unittest.TestCase):
    def test_are_drawn(self):
        with tempfile.TemporaryDirectory() as folder:
            done = run("pictures.py", "--mgdt", MGDT, "--out", folder, "--points", 300,
                       "--nodes", 16000)
            self.assertEqual(done.returncode, 0, done.stderr)
            made = {path.name for path in Path(folder).glob("*.png")}
            linked = re.findall(r"\(paper/([\w-]+\.png)\)", (SOURCE / "docs" / "paper.md").read_text())
            plots = {"np.png", "nr.png", "cost.png", "largest.png", "peers.png"}
            self.assertEqual(made, set(linked) - plots)
            for name in made:
                with Image.open(Path(folder) / name) as picture:
                    self.assertGreater(len(picture.convert("RGB").getcolors(1 << 20)), 5, name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
