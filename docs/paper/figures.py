# SPDX-License-Identifier: MIT
"""The figures that the report is made of: rows that `mgdt-bench` wrote, and those of the paper."""
import csv
import hashlib
import json
import statistics
import sys
from pathlib import Path
from types import SimpleNamespace

HERE = Path(__file__).resolve().parent
COLUMNS = (
    "library,version,distribution,points,seed,scheme,threads,run,status,np,nr,created,"
    "order_seconds,insert_seconds,total_seconds,bytes_per_point,peak_rss_bytes,inserted,"
    "duplicates,tetrahedra,levels,rounds,system_seconds,user_seconds"
).split(",")
MEASURED = COLUMNS[COLUMNS.index("np") :]
# Rows that differ in these alone are runs of one thing, and one row of medians.
RUNS_OF = ["library", "distribution", "points", "seed", "scheme", "threads"]

PAPER_SCHEMES = ["regular-grid", "multi-grid", "enhanced-kd-tree"]
SCHEMES = PAPER_SCHEMES + ["random", "brio", "hilbert", "auto"]
DISTRIBUTIONS = ["uniform", "line", "diagonal", "ellipse", "spiral", "cluster", "galaxy"]
PEERS = ["cgal", "tetgen", "qhull"]


def read_rows(path):
    """The rows of a table that `mgdt-bench` wrote, or of medians of such, as text."""
    with open(path, newline="", encoding="utf-8") as file:
        reader = csv.DictReader(file)
        if (reader.fieldnames or [])[: len(COLUMNS)] != COLUMNS:
            sys.exit(f"report.py: {path}: the heading is not that of `mgdt-bench --csv`")
        rows = list(reader)
    for number, row in enumerate(rows, 2):
        if None in row or None in row.values():
            sys.exit(f"report.py: {path}: line {number} has not {len(reader.fieldnames)} fields")
    # Later columns are not of the report.
    return [{c: row[c] for c in COLUMNS} for row in rows]


def median(values):
    values = [float(v) for v in values if v != ""]
    if not values:
        return ""
    middle = statistics.median(values)
    return f"{middle:.6g}" if abs(middle) < 1e5 else f"{middle:.0f}"


def medians(rows):
    """One row for all runs of each thing; `run` is how many went well. The status is ok, that of
    the first failure if none went well, or says how many did."""
    versions = {row["version"] for row in rows if row["library"] == "mgdt"}
    if len(versions) > 1:
        sys.exit(f"report.py: rows of several versions of mgdt: {', '.join(sorted(versions))}")
    groups = {}
    for row in rows:
        groups.setdefault(tuple(row[c] for c in RUNS_OF), []).append(row)
    result = []
    for group in groups.values():
        good = [row for row in group if row["status"] == "ok"]
        bad = [row for row in group if row["status"] != "ok"]
        row = dict(group[0], run=str(len(good)), status="ok")
        row.update({c: median(r[c] for r in good) for c in MEASURED})
        if bad:
            word = bad[0]["status"]
            row["status"] = f"{len(bad)} of {len(group)}: {word}" if good else word
        result.append(row)
    return result


def write_rows(path, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def number(text):
    return float(text) if text != "" else None


def entry(row, order, **more):
    return SimpleNamespace(
        np=number(row["np"]),
        nr=number(row["nr"]),
        order=number(row[order]),
        total=number(row["total_seconds"]),
        **more,
    )


class Study:
    """Everything that is known, by (distribution, points, scheme or peer)."""

    def __init__(self, figures, header, paper):
        rows = read_rows(figures)
        self.single = [row for row in rows if row["threads"] == "1"]
        self.other_threads = len(rows) - len(self.single)
        self.ours, self.paper = {}, {}
        for row in self.single:
            key = (row["distribution"], int(row["points"]), row["scheme"] or row["library"])
            if key in self.ours:
                sys.exit(f"report.py: {figures}: {' '.join(map(str, key))} is there twice")
            self.ours[key] = entry(
                row, "order_seconds", status=row["status"], runs=int(row["run"]),
                time=number(row["user_seconds"]),
            )
        with open(paper, newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                mild = "mild-" if row["table"] == "1" else ""
                key = (mild + row["distribution"], int(row["points"]), row["scheme"])
                self.paper[key] = entry(row, "grid_seconds", time=number(row["total_seconds"]))
        self.header = json.loads(Path(header).read_text(encoding="utf-8"))
        # Of all that tables and plots are made of, to tell whether a plot is theirs.
        data = Path(figures).read_bytes() + Path(paper).read_bytes()
        self.digest = hashlib.sha256(data).hexdigest()

    def sizes(self, distribution):
        return sorted({n for d, n, _ in [*self.ours, *self.paper] if d == distribution})

    def timed(self, *key):
        return getattr(self.ours.get(key), "time", None) is not None

    def schemes(self):
        """Those of the report, and what else was measured."""
        more = {row["scheme"] for row in self.single if row["scheme"]} - set(SCHEMES)
        return SCHEMES + sorted(more)

    def peers(self):
        measured = {row["library"] for row in self.single} - {"mgdt"}
        return [p for p in PEERS if p in measured] + sorted(measured - set(PEERS))


def cost(source, distribution, points, scheme):
    """Seconds per point, or None: mgdt's own processor time, the paper's CPU time."""
    known = source.get((distribution, points, scheme))
    return known.time / points if known and known.time is not None else None
