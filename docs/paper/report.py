#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the tables of docs/paper.md, between their markers, and the plots beside them.

Without arguments: from figures.csv (medians), figures.json (what measured them) and lo-2014.csv
(the paper's), all in this folder. With --csv, figures.csv is made first, of tables that
`mgdt-bench --csv` wrote, and with --json figures.json, of the header of what `mgdt-bench --json`
wrote.

Needs the Debian package python3-matplotlib.
"""
import argparse
import json
import re
import sys
from pathlib import Path

from figures import (
    DISTRIBUTIONS, HERE, PAPER_SCHEMES, Study, cost, medians, read_rows, write_rows,
)

TITLES = {"regular-grid": "regular grid", "enhanced-kd-tree": "enhanced kd-tree"}
PRACTICAL = ["machine", "church"]
MILD = 1000000  # points in Table 1
SHOWN = [400000, 2000000, 3000000, 6000000]  # of Tables 2 to 8; the plots have all sizes
OTHERS = ["brio", "hilbert"]  # schemes that the paper did not measure
ABSENT = "-"


def count(n):
    """400000 as 0.4M."""
    return f"{n / 1e6:g}M" if n >= 100000 else str(n)


def short(value):
    """Three digits, or more before the point."""
    if value is None:
        return None
    return f"{value:.{2 if abs(value) < 9.995 else 1 if abs(value) < 99.95 else 0}f}"


def table(heading, rows):
    lines = [heading, ["---"] * len(heading), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


# Quantities: of a source of figures, a distribution, size and scheme, a number or None.


def walked(source, *key):
    return getattr(source.get(key), "np", None)


def removed(source, *key):
    return getattr(source.get(key), "nr", None)


def order_share(source, *key):
    known = source.get(key)
    if known is None or known.order is None or not known.total:
        return None
    return 100 * known.order / known.total


def ratio(own, base):
    return own / base if own and base else None


def relative_time(source, distribution, points, scheme):
    """By the time of the paper's multi-grid, and of mgdt's default scheme."""
    base = "auto" if (distribution, points, "auto") in source else "multi-grid"
    return ratio(cost(source, distribution, points, scheme), cost(source, distribution, points, base))


def by_uniform(source, distribution, points, scheme):
    """By the time of the uniform set, which the paper lists with the mild ones."""
    uniform = "mild-uniform" if ("mild-uniform", points, scheme) in source else "uniform"
    return ratio(cost(source, distribution, points, scheme), cost(source, uniform, points, scheme))


def our_cell(study, quantity, key):
    known = study.ours.get(key)
    if known is None:
        return ABSENT
    text = short(quantity(study.ours, *key))
    if text is None:
        return known.status if known.total is None else ABSENT
    return text if known.status == "ok" else text + "*"


def pair(study, quantity, theirs, ours):
    """A cell: the paper's figure and mgdt's, each of its own (distribution, points, scheme)."""
    cells = [short(quantity(study.paper, *theirs)) or ABSENT, our_cell(study, quantity, ours)]
    return ABSENT if cells == [ABSENT, ABSENT] else " / ".join(cells)


def notes(study, keys):
    """What went wrong, in words."""
    lines = []
    for key in keys:
        known = study.ours.get(key)
        if known and known.status != "ok":
            star = "* " if known.total is not None else ""
            lines.append(f"{star}{key[0]}, {count(key[1])}, {key[2]}: {known.status}.")
    return "\n\n" + "\n".join(lines) if lines else ""


def comparison(study, quantity, lines, multi_grid="multi-grid", others=OTHERS):
    """A row for each (distribution, points); `multi_grid` is mgdt's scheme in that column."""
    heading = ["paper / mgdt", "points"] + [TITLES.get(s, s) for s in PAPER_SCHEMES + others]
    rows, keys = [], []
    for distribution, points in lines:
        cells = []
        for scheme in PAPER_SCHEMES:
            ours = multi_grid if scheme == "multi-grid" else scheme
            keys.append((distribution, points, ours))
            cells.append(pair(study, quantity, (distribution, points, scheme), keys[-1]))
        for scheme in others:
            keys.append((distribution, points, scheme))
            cells.append(our_cell(study, quantity, keys[-1]))
        if any(cell != ABSENT for cell in cells):
            first = distribution not in [row[0] for row in rows]
            rows.append([distribution if first else "", count(points), *cells])
    return table(heading, rows) + notes(study, keys)


def shown(study):
    """The lines of Tables 2 to 8."""
    return [(d, n) for d in DISTRIBUTIONS for n in study.sizes(d) if n in SHOWN]


def default_sizes(study, kind):
    """Where the default scheme was run; those of the paper if there are any."""
    sizes = [n for n in study.sizes(kind) if study.timed(kind, n, "auto")]
    return [n for n in sizes if (kind, n, "multi-grid") in study.paper] or sizes


def grown(first, last):
    return f"{100 * (last / first - 1):+.0f}%" if first and last and first != last else ABSENT


def summary(study):
    """The default scheme at the largest size, beside the paper's figures there."""
    rows = []
    for kind in DISTRIBUTIONS:
        sizes = default_sizes(study, kind)
        if not sizes:
            rows.append([kind] + [ABSENT] * 9)
            continue
        points = sizes[-1]
        row = [kind, count(points)]
        for quantity in (walked, removed):
            row += [short(quantity(study.paper, kind, points, s)) or ABSENT for s in PAPER_SCHEMES[1:]]
            row.append(our_cell(study, quantity, (kind, points, "auto")))
        for source, scheme in ((study.paper, "multi-grid"), (study.ours, "auto")):
            row.append(grown(*(cost(source, kind, n, scheme) for n in (sizes[0], points))))
        rows.append(row)
    heading = ["", "points", "NP: paper's multi-grid", "paper's kd-tree", "mgdt's auto"]
    heading += ["NR: paper's multi-grid", "paper's kd-tree", "mgdt's auto"]
    heading += ["growth: paper's multi-grid", "mgdt's auto"]
    return table(heading, rows)


def growth(study):
    """The default scheme's time per point at its ends, and the share of the order."""
    rows = []
    for kind in DISTRIBUTIONS:
        sizes = default_sizes(study, kind)
        if not sizes:
            rows.append([kind] + [ABSENT] * 6)
            continue
        least, most = sizes[0], sizes[-1]
        row = [kind, f"{count(least)} to {count(most)}"]
        row += [short(1e6 * cost(study.ours, kind, n, "auto")) for n in (least, most)]
        row.append(our_cell(study, order_share, (kind, most, "auto")))
        for scheme in PAPER_SCHEMES[1:]:
            row.append(short(order_share(study.paper, kind, most, scheme)) or ABSENT)
        rows.append(row)
    heading = ["", "points", "µs, least", "µs, most"]
    heading += ["order, %", "paper's multi-grid", "paper's kd-tree"]
    return table(heading, rows)


def mild(study):
    """Table 1: times by those of the uniform set."""
    lines = [(f"mild-{kind}", MILD) for kind in DISTRIBUTIONS[1:-1]]
    return comparison(study, by_uniform, lines, others=OTHERS + ["auto"])


def practical(study):
    """Table 9: the nodes of two meshes, a row for each quantity."""
    heading = ["paper / mgdt", ""] + [TITLES.get(s, s) for s in PAPER_SCHEMES + OTHERS]
    rows, keys = [], []
    for name, quantity in (("NP", walked), ("NR", removed), ("time", relative_time)):
        for kind in PRACTICAL:
            for points in study.sizes(kind):
                line = [(kind, points, s) for s in PAPER_SCHEMES + OTHERS]
                keys += line if name == "NP" else []
                cells = [pair(study, quantity, key, key) for key in line[:3]]
                rows.append([name, kind, *cells, *(our_cell(study, quantity, k) for k in line[3:])])
    return table(heading, rows) + notes(study, keys)


def peers(study):
    """Times of other libraries by those of the default scheme."""
    names = study.peers()
    if not names:
        return "No other library was measured in this run."
    lines = sorted({(d, n) for d, n, s in study.ours if s in names}, key=lambda k: (
        (DISTRIBUTIONS.index(k[0]) if k[0] in DISTRIBUTIONS else 99), k))
    rows = [[d, count(n)] + [our_cell(study, relative_time, (d, n, p)) for p in names] for d, n in lines]
    versions = {row["library"]: row["version"] for row in study.single}
    heading = ["", "points"] + [f"{p} {versions[p]}".strip() for p in names]
    return table(heading, rows) + notes(study, [(d, n, p) for d, n in lines for p in names])


def left_out(study):
    """What was measured and is in no table or plot."""
    kinds = DISTRIBUTIONS + PRACTICAL
    mild_kinds = [(f"mild-{d}", MILD) for d in DISTRIBUTIONS[1:-1]]
    rest = [k for k in study.ours if k[0] not in kinds and k[:2] not in mild_kinds]
    rest = [f"{d}, {count(n)}, {s}" for d, n, s in rest if s not in study.peers()]
    if rest:
        yield f"in no table: {'; '.join(rest)}"
    if study.other_threads:
        yield f"in no table: {study.other_threads} of several threads"


def header(study):
    known = study.header
    machine = known["machine"]
    if isinstance(machine, dict):
        memory = machine["memory_bytes"] / 2**30
        machine = f"{machine['cpu']}, {machine['cores']} cores, {memory:.0f} GiB of memory"
    commit = f", commit {known['commit']}" if known.get("commit") else ""
    runs = {e.runs for e in study.ours.values() if e.total is not None}
    if runs == {1}:
        kind = "one run each"
    else:
        kind = f"medians of {min(runs)}" + (f" to {max(runs)}" if len(runs) > 1 else "") + " runs"
    text = f"- machine: {machine}\n- mgdt {known['version']}{commit}, one thread, {kind}"
    for line in [*([known["note"]] if "note" in known else []), *left_out(study)]:
        text += f"\n- {line}"
    return text


def blocks(study):
    """The text of every pair of markers, by name."""
    by_auto = dict(multi_grid="auto")
    return {
        "header": header(study),
        "summary": summary(study),
        "table 1": mild(study),
        "np": comparison(study, walked, shown(study), **by_auto),
        "nr": comparison(study, removed, shown(study), **by_auto),
        "time": comparison(study, relative_time, shown(study), others=OTHERS + ["random"]),
        "growth": growth(study),
        "table 9": practical(study),
        "peers": peers(study),
    }


def filled(text, made):
    """The document with new text between its markers; each name must be there once."""
    for name, block in made.items():
        pattern = re.compile(f"(<!-- {re.escape(name)} -->\n).*?(<!-- end -->)", re.DOTALL)
        if len(pattern.findall(text)) != 1:
            sys.exit(f"report.py: the document needs <!-- {name} --> and <!-- end -->, once")
        text = pattern.sub(lambda m: f"{m[1]}\n{block}\n\n{m[2]}", text)
    return text


def gather(args):
    if args.csv:
        write_rows(args.figures, medians([row for path in args.csv for row in read_rows(path)]))
    if args.json:
        known = json.loads(Path(args.json).read_text(encoding="utf-8"))
        for name in ("rows", "command"):  # the document has the commands
            known.pop(name, None)
        known.update({k: v for k in ("commit", "note") if (v := getattr(args, k))})
        text = json.dumps(known, indent=1, ensure_ascii=False)
        Path(args.header).write_text(text + "\n", encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--csv", nargs="+", help="tables of mgdt-bench to take the medians of")
    parser.add_argument("--json", help="what mgdt-bench --json wrote")
    parser.add_argument("--commit", help="commit that was measured, for figures.json")
    parser.add_argument("--note", help="what else to know of the measurement, for figures.json")
    parser.add_argument("--figures", default=HERE / "figures.csv", type=Path)
    parser.add_argument("--header", default=HERE / "figures.json", type=Path)
    parser.add_argument("--document", default=HERE.parent / "paper.md", type=Path)
    parser.add_argument("--plots", default=HERE, type=Path, help="folder of the plots")
    args = parser.parse_args()

    gather(args)
    study = Study(args.figures, args.header, HERE / "lo-2014.csv")
    text = args.document.read_text(encoding="utf-8")
    args.document.write_text(filled(text, blocks(study)), encoding="utf-8")
    import plots

    for path in plots.draw_all(study, args.plots):
        print(path)


if __name__ == "__main__":
    main()
