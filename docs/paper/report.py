#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the tables of docs/paper.md, between their markers, and the plots beside them.

Without arguments: from figures.csv (medians), figures.json (what measured them) and lo-2014.csv
(the paper's), all in this folder. With --csv, figures.csv is made first, of tables that
`mgdt bench --csv` wrote, and with --json figures.json, of the header of what `mgdt bench --json`
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
TABLES = {k: i for i, k in enumerate(DISTRIBUTIONS, 2)}  # the paper's numbers
PRACTICAL = ["machine", "church"]
MILD = 1000000  # points in Table 1
NOT_RUN = "not run"


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


def against_multi_grid(source, distribution, points, scheme):
    base = cost(source, distribution, points, "multi-grid")
    own = cost(source, distribution, points, scheme)
    return own / base if own and base else None


def growth(source, distribution, points, scheme):
    first = min((n for d, n, _ in source if d == distribution), default=None)
    base = cost(source, distribution, first, scheme)
    own = cost(source, distribution, points, scheme)
    return own / base if own and base else None


def order_share(source, *key):
    known = source.get(key)
    if known is None or known.order is None or not known.total:
        return None
    return 100 * known.order / known.total


GROUPS = [
    ("NP", walked),
    ("NR", removed),
    ("time / multi-grid's", against_multi_grid),
    ("cost a point / that of the fewest", growth),
    ("grid, % of time", order_share),
]


def our_cell(study, quantity, key):
    known = study.ours.get(key)
    if known is None:
        return NOT_RUN
    text = short(quantity(study.ours, *key))
    if text is None:
        return known.status if known.total is None else "no base"
    return text if known.status == "ok" else text + "*"


def cell(study, quantity, key):
    ours = our_cell(study, quantity, key)
    if key[2] not in PAPER_SCHEMES:
        return ours
    return f"{short(quantity(study.paper, *key)) or '-'} / {ours}"


def notes(study, keys):
    """What went wrong, in words."""
    lines = []
    for key in keys:
        known = study.ours.get(key)
        if known and known.status != "ok":
            star = "* " if known.total is not None else ""
            lines.append(f"{star}{key[0]}, {count(key[1])}, {key[2]}: {known.status}.")
    return "\n\n" + "\n".join(lines) if lines else ""


def comparison(study, lines, label):
    """Blocks of rows, one a quantity; `lines` are (distribution, points)."""
    schemes = study.schemes()
    heading = ["paper / mgdt", label] + [TITLES.get(s, s) for s in schemes]
    rows = []
    for name, quantity in GROUPS:
        for i, (distribution, points) in enumerate(lines):
            if quantity is growth and points == min(n for d, n in lines if d == distribution):
                continue  # 1 by definition
            line = distribution if label == "set" else count(points)
            cells = [cell(study, quantity, (distribution, points, s)) for s in schemes]
            if any(c not in (NOT_RUN, f"- / {NOT_RUN}") for c in cells):
                rows.append([name, line] + cells)
            name = "" if rows and rows[-1][0] in (name, "") else name
    keys = [(d, n, s) for d, n in lines for s in schemes]
    return table(heading, rows) + notes(study, keys)


def mild(study):
    """Table 1: seconds beside those of the uniform set."""
    schemes = study.schemes()

    def ratio(source, distribution, points, scheme):
        uniform = "uniform" if source is study.ours else "mild-uniform"
        base = cost(source, uniform, points, scheme)
        own = cost(source, distribution, points, scheme)
        return own / base if own and base else None

    keys = [[(f"mild-{d}", MILD, s) for s in schemes] for d in DISTRIBUTIONS[1:-1]]
    rows = [[line[0][0]] + [cell(study, ratio, key) for key in line] for line in keys]
    heading = ["paper / mgdt"] + [TITLES.get(s, s) for s in schemes]
    return table(heading, rows) + notes(study, sum(keys, []))


def default_sizes(study, kind):
    """Where the default scheme was run; those of the paper if there are any."""
    sizes = [n for n in study.sizes(kind) if (kind, n, "auto") in study.ours]
    return [n for n in sizes if (kind, n, "multi-grid") in study.paper] or sizes


def summary(study):
    """The default scheme at the largest size, beside the paper's figures there."""
    rows = []
    for kind in DISTRIBUTIONS:
        points = max(default_sizes(study, kind), default=None)
        if points is None:
            rows.append([kind, NOT_RUN] + ["-"] * 6)
            continue
        key = (kind, points, "auto")

        def of_paper(scheme, quantity):
            return short(quantity(study.paper, kind, points, scheme)) or "-"

        rows.append(
            [kind, count(points)]
            + [of_paper(s, walked) for s in ("multi-grid", "enhanced-kd-tree")]
            + [our_cell(study, walked, key)]
            + [of_paper(s, removed) for s in ("multi-grid", "enhanced-kd-tree")]
            + [our_cell(study, removed, key)]
        )
    heading = ["", "points", "NP multi-grid", "NP kd-tree", "NP auto"]
    heading += ["NR multi-grid", "NR kd-tree", "NR auto"]
    return table(heading, rows)


def grown(first, last):
    return f"{100 * (last / first - 1):+.0f}%" if first != last else "-"


def linear(study):
    """How the insertion of a point grows with their number, for the default scheme."""
    rows = []
    for kind in DISTRIBUTIONS:
        known = [(n, study.ours[kind, n, "auto"]) for n in default_sizes(study, kind)]
        known = [(n, e) for n, e in known if e.total is not None]
        if not known:
            rows.append([kind] + [NOT_RUN] + ["-"] * 8)
            continue
        (least, first), (most, last) = ends = known[0], known[-1]
        each = [1e6 * e.insert / n for n, e in ends]
        system, own = "-", "-"
        if first.system is not None and last.system is not None:
            # What the program itself did, order and all.
            system = short(1e6 * last.system / most)
            own = grown(*((e.total - e.system) / n for n, e in ends))
        theirs = [study.paper.get((kind, n, "multi-grid")) for n in (least, most)]
        rows.append(
            [kind, count(least), short(each[0]), count(most), short(each[1]), grown(*each)]
            + [system, own]
            + [grown(*(e.insert / e.points for e in theirs)) if all(theirs) else "-"]
            + [f"{100 * last.order / last.total:.1f}%"]
        )
    heading = ["", "points", "µs a point", "points", "µs a point", "growth"]
    heading += ["the system's µs", "growth of all without"]
    heading += ["the paper's multi-grid", "grid, share of time"]
    return table(heading, rows)


def peers(study):
    """Seconds of other libraries by those of the default scheme."""
    names = study.peers()
    if not names:
        return "No other library was measured in this run."
    lines = sorted({(d, n) for d, n, s in study.ours if s in names}, key=lambda k: (
        (DISTRIBUTIONS.index(k[0]) if k[0] in DISTRIBUTIONS else 99), k))

    def ratio(source, distribution, points, name):
        base = cost(source, distribution, points, "auto")
        own = cost(source, distribution, points, name)
        return own / base if own and base else None

    rows = [[d, count(n)] + [our_cell(study, ratio, (d, n, p)) for p in names] for d, n in lines]
    versions = {row["library"]: row["version"] for row in study.single}
    heading = ["", "points"] + [f"{p} {versions[p]}".strip() for p in names]
    text = table(heading, rows) + notes(study, [(d, n, p) for d, n in lines for p in names])
    return text + "\n\n![Times of other libraries by those of mgdt](paper/peers.png)"


def left_out(study):
    """What was measured and is in no table."""
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
        kind = "One run each."
    else:
        kind = f"Medians of {min(runs)}" + (f" to {max(runs)}" if len(runs) > 1 else "") + " runs."
    text = f"- command: `{known['command']}`\n- mgdt {known['version']}{commit}, one thread\n"
    text += f"- machine: {machine}\n- {kind}"
    for line in [*([known["note"]] if "note" in known else []), *left_out(study)]:
        text += f"\n- {line}"
    return text


def blocks(study):
    """The text of every pair of markers, by name."""
    made = {"header": header(study), "summary": summary(study), "linear": linear(study)}
    made["table 1"] = mild(study)
    for kind, n in TABLES.items():
        made[f"table {n}"] = comparison(study, [(kind, p) for p in study.sizes(kind)], "points")
    lines = [(kind, p) for kind in PRACTICAL for p in study.sizes(kind)]
    made["table 9"] = comparison(study, lines, "set")
    made["peers"] = peers(study)
    return made


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
        known.pop("rows", None)
        known.update({k: v for k in ("commit", "note") if (v := getattr(args, k))})
        text = json.dumps(known, indent=1, ensure_ascii=False)
        Path(args.header).write_text(text + "\n", encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--csv", nargs="+", help="tables of mgdt bench to take the medians of")
    parser.add_argument("--json", help="what mgdt bench --json wrote")
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
