#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Meshes the surfaces that collect.sh has collected, and compares with other programs.

  models.py FOLDER MGDT [--pairs PROGRAM] [--cdt PROGRAM] [--only WORD] [--seconds N]

MGDT is the program mgdt. For each surface a line says what became of it. A surface is valid if its triangles
meet in common corners and edges only, and closed if it encloses something. What must hold:

- each valid surface that is closed is meshed, and the mesh passes `mgdt mesh --check`, also with --keep-surface,
  unless doubles do not suffice to keep it, and with --flat 1e-6;
- each other surface is refused; one that encloses nothing has an edge that one triangle alone has;
- what --clean or --weld leaves without pairs, as `mgdt validate --repairable` says, and closed, is meshed and checked;
- with --pairs (facet_pairs.cpp) the pairs that `mgdt validate` lists are those that CGAL finds.

Beside it are Steiner points and processor time, files included, of `mgdt mesh --keep-surface`, of `mgdt mesh --flat
1e-6 --keep-surface`, of `tetgen -p` and `tetgen -pY`, and with --cdt of MarcoAttene/CDT.
"""

from __future__ import annotations

import argparse
import os
import re
import resource
import statistics
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple, Optional

import meshio
import numpy as np


class Run(NamedTuple):
    status: int
    seconds: float  # of the processor
    text: str  # the standard output


def run(command: list[str], folder: Path, limit: float) -> Run:
    """Runs a command, at most for so many seconds; the status is then 124."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        done = subprocess.run(command, cwd=folder, timeout=limit, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              check=False)
        status, text = done.returncode, done.stdout.decode("utf-8", "replace")
    except subprocess.TimeoutExpired:
        status, text = 124, ""
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return Run(status, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, text)


def read_off(path: Path) -> tuple[np.ndarray, list[list[int]]]:
    lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
    rows = [row for row in (line.split("#")[0].split() for line in lines) if row]
    words = iter([word for row in rows for word in row])
    kind = next(words)
    if not kind.endswith("OFF"):
        raise ValueError(f"{kind} is no OFF file that is read here")
    n, m, _ = (int(next(words)) for _ in range(3))
    width = 3 + 3 * ("N" in kind) + 4 * ("C" in kind)
    points = np.array([[float(next(words)) for _ in range(width)][:3] for _ in range(n)])
    # Colours may follow the corners of a facet, so facets are read by lines.
    facets = []
    for row in rows[-m:]:
        k = int(row[0])
        facets.append([int(word) for word in row[1:k + 1]])
    return points, facets


def read(path: Path) -> tuple[np.ndarray, list[list[int]]]:
    """Points and facets."""
    if path.suffix == ".off":
        return read_off(path)
    mesh = meshio.read(path)
    facets = [list(map(int, row)) for block in mesh.cells if block.type in ("triangle", "quad", "polygon")
              for row in block.data]
    return np.asarray(mesh.points, float), facets


def write_triangles(path: Path, points: np.ndarray, facets: list[list[int]]) -> tuple[int, int, bool]:
    """Writes an OFF file of distinct points that facets have, polygons as fans of triangles. Gives their numbers, and
    whether one triangle alone has an edge."""
    distinct, number = np.unique(points + 0.0, axis=0, return_inverse=True)
    number = number.reshape(-1)
    triangles = [[number[f[0]], number[f[i]], number[f[i + 1]]] for f in facets for i in range(1, len(f) - 1)]
    rows = np.array(triangles, int).reshape(-1, 3)
    rows = rows[(rows[:, 0] != rows[:, 1]) & (rows[:, 1] != rows[:, 2]) & (rows[:, 0] != rows[:, 2])]
    edges = np.sort(rows[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    _, uses = np.unique(edges, axis=0, return_counts=True)
    used, corners = np.unique(rows, return_inverse=True)
    corners = corners.reshape(-1, 3)
    with path.open("w", encoding="ascii") as out:
        out.write(f"OFF\n{len(used)} {len(corners)} 0\n")
        np.savetxt(out, distinct[used], "%.17g")
        np.savetxt(out, np.column_stack([np.full(len(corners), 3), corners]), "%d")
    return len(used), len(corners), bool((uses == 1).any())


class Model(NamedTuple):
    name: str
    points: int
    facets: int
    outcome: str  # "meshed", "open", "invalid" or what is wrong
    steiner: dict[str, int]
    seconds: dict[str, float]


def pairs_of(text: str) -> set[tuple[int, int]]:
    """Of what `mgdt validate` prints."""
    found = set()
    for line in text.splitlines():
        flat = re.fullmatch(r"facet (\d+) is flat or no polygon", line)
        pair = re.fullmatch(r"facet (\d+) meets facet (\d+)", line)
        if flat:
            found.add((int(flat[1]), int(flat[1])))
        elif pair:
            found.add((int(pair[1]), int(pair[2])))
    return found


def same_pairs(text: str, program: str, off: Path, limit: float) -> str:
    """What differs from the pairs that another program finds, or nothing."""
    other = run([program, str(off)], off.parent, limit)
    if other.status != 0:
        return f"facet_pairs: status {other.status}"
    ours, theirs = pairs_of(text), {tuple(map(int, line.split())) for line in other.text.splitlines()}
    flat = {i for i, k in theirs if i == k}
    ours = {p for p in ours if p[0] == p[1] or not flat & set(p)}
    return "" if ours == theirs else f"{len(ours - theirs)} pairs too many, {len(theirs - ours)} missing"


class Suite:
    def __init__(self, options: argparse.Namespace) -> None:
        self.options = options
        self.folder = Path(options.folder).resolve()
        self.work = self.folder / "off"
        self.work.mkdir(exist_ok=True)

    def run(self, *command: str) -> Run:
        return run(list(command), self.work, self.options.seconds)

    def model(self, path: Path) -> Optional[Model]:
        off = self.work / (path.stem + ".off")
        try:
            points, facets, is_open = write_triangles(off, *read(path))
        except (Exception, SystemExit) as error:  # pylint: disable=broad-exception-caught  # meshio raises both
            print(f"{path.name}: not read: {str(error).splitlines()[0] if str(error) else type(error).__name__}")
            return None
        if facets == 0:
            return None
        steiner: dict[str, int] = {}
        seconds: dict[str, float] = {}
        outcome = self.mesh(off, is_open, steiner, seconds)
        if outcome == "meshed":
            self.others(off, points, steiner, seconds)
        for made in self.work.glob(off.stem + ".*"):
            if made != off:
                made.unlink()
        return Model(off.stem, points, facets, outcome, steiner, seconds)

    def mesh(self, off: Path, is_open: bool, steiner: dict[str, int], seconds: dict[str, float]) -> str:
        mgdt = self.options.mgdt
        validation = self.run(mgdt, "validate", off.name)
        wrong = ""
        if self.options.pairs and validation.status in (0, 1):
            wrong = same_pairs(validation.text, self.options.pairs, off, 10 * self.options.seconds)
        if validation.status == 1:
            made = self.run(mgdt, "mesh", "-q", off.name, "-o", off.stem + ".ele")
            if made.status != 3:
                return wrong or f"invalid, but mesh has status {made.status}"
            return wrong or self.cleaned(off)
        if wrong or validation.status != 0:
            return wrong or f"validate: status {validation.status}"
        made = self.run(mgdt, "mesh", off.name, "-o", off.stem + ".ele")
        if made.status == 3 and "enclose nothing" in made.text:
            return "open" if is_open else "said to enclose nothing, though each edge has two triangles"
        if made.status != 0:
            return f"mesh: status {made.status}: {made.text.strip()[-150:]}"
        added = re.search(r", (\d+) added,", made.text)
        steiner["mgdt"] = int(added[1]) if added else -1
        seconds["mgdt"] = made.seconds
        checked = self.run(mgdt, "mesh", "-q", "--check", off.name, "-o", off.stem + ".ele")
        seconds["check"] = checked.seconds - made.seconds
        if checked.status == 0:
            checked = self.kept(off, steiner, seconds)
        return "meshed" if checked.status == 0 else f"check: status {checked.status}: {checked.text.strip()[-150:]}"

    def cleaned(self, off: Path) -> str:
        """What becomes of an invalid surface when it is cleaned."""
        found = re.search(r"^(--clean|--weld \S+): .*; no pair is left", self.run(
            self.options.mgdt, "validate", "-q", off.name, "--repairable").text, re.M)
        if not found:
            return "invalid"
        made = self.run(self.options.mgdt, "mesh", "-q", off.name, "-o", off.stem + ".ele", "--check", *found[1].split())
        if made.status == 3 and "enclose nothing" in made.text:
            return "open when cleaned"
        return "cleaned" if made.status == 0 else f"{found[1]}: status {made.status}: {made.text.strip()[-150:]}"

    def kept(self, off: Path, steiner: dict[str, int], seconds: dict[str, float]) -> Run:
        command = [self.options.mgdt, "mesh", off.name, "-o", off.stem + ".ele", "--keep-surface"]
        flat = self.run(*command, "--flat", "1e-6", "--check")
        added = re.search(r", (\d+) added,", flat.text)
        if flat.status == 0 and added:
            steiner["flat"] = int(added[1])
            seconds["flat"] = flat.seconds
        elif "cannot be kept" not in flat.text:
            return flat
        made = self.run(*command)
        if made.status == 3 and "cannot be kept" in made.text:
            return made._replace(status=0)
        added = re.search(r", (\d+) added,", made.text)
        if made.status != 0 or not added:
            return made
        steiner["kept"] = int(added[1])
        seconds["kept"] = made.seconds
        return self.run(*command, "--check", "-q")

    def others(self, off: Path, points: int, steiner: dict[str, int], seconds: dict[str, float]) -> None:
        made = self.run("tetgen", "-pY", off.name)
        inside = re.search(r"Steiner points inside domain: +(\d+)", made.text)
        if made.status == 0:
            steiner["tetgen -pY"] = int(inside[1]) if inside else 0
            seconds["tetgen -pY"] = made.seconds
        made = self.run("tetgen", "-pQ", off.name)
        node = self.work / (off.stem + ".1.node")
        if made.status == 0 and node.is_file():
            with node.open(encoding="ascii") as lines:
                steiner["tetgen"] = int(lines.readline().split()[0]) - points
            seconds["tetgen"] = made.seconds
        if not self.options.cdt:
            return
        (self.work / "cdt_log.csv").unlink(missing_ok=True)
        made = self.run(self.options.cdt, "-l", off.name)
        log = self.work / "cdt_log.csv"
        if made.status == 0 and log.is_file():
            last = log.read_text(encoding="utf-8").strip().splitlines()[-1].split(",")
            steiner["cdt"] = int(last[-6])
            seconds["cdt"] = made.seconds


FAMILIES = {
    "CGAL's demos": ("cgal-", "dragon"),
    "solids of Gmsh and Open Cascade": ("gmsh-", "occt-"),
    "OpenSCAD's examples": ("scad-", "openscad-"),
    "random unions and differences": ("csg-",),
    "STL files": ("stl-models",),
}


OUTCOMES = ("invalid", "open", "cleaned", "open when cleaned", "meshed")


def table(models: list[Model], names: list[str]) -> None:
    """By family, of the surfaces that all programs mesh: numbers, points, Steiner points, seconds."""
    keys = ["mgdt", *names]
    print("\n| surfaces | number | points | Steiner points: " + " | ".join(keys) + " | seconds: " + " | ".join(keys) + " |")
    print("|---|---|---|" + 2 * len(keys) * "---|")
    for family, prefixes in FAMILIES.items():
        of = [m for m in models if m.name.startswith(prefixes) and all(k in m.steiner for k in keys)]
        cells = [family, str(len(of)), f"{sum(m.points for m in of):,}"]
        cells += [f"{sum(m.steiner[k] for m in of):,}" for k in keys] + [f"{sum(m.seconds[k] for m in of):.1f}" for k in keys]
        print("| " + " | ".join(cells) + " |")


def summary(models: list[Model], names: list[str]) -> None:
    meshed = [m for m in models if m.outcome == "meshed"]
    count = {word: sum(m.outcome == word for m in models) for word in OUTCOMES}
    print(f"\n{len(models)} surfaces: {count['invalid']} invalid, {count['open']} enclose nothing, "
          f"{count['cleaned']} meshed when cleaned, {count['open when cleaned']} open when cleaned, "
          f"{count['meshed']} meshed and checked, {len(models) - sum(count.values())} wrong")
    if not meshed:
        return
    print(f"{sum(m.points for m in meshed)} points, {sum(m.facets for m in meshed)} facets, "
          f"{sum(m.steiner['mgdt'] for m in meshed)} Steiner points, median "
          f"{statistics.median(m.steiner['mgdt'] / m.points for m in meshed):.3f} for each point; "
          f"{sum(m.seconds['mgdt'] for m in meshed):.1f} s, the checks {sum(m.seconds['check'] for m in meshed):.1f} s")
    flat = [m for m in meshed if "flat" in m.steiner]
    print(f"--flat 1e-6 --keep-surface keeps {len(flat)} of them, with {sum(m.steiner['flat'] for m in flat)} Steiner points")
    kept = [m for m in meshed if "kept" in m.steiner]
    print(f"--keep-surface keeps {len(kept)} of them, {sum(m.steiner['kept'] == 0 for m in kept)} without Steiner points")
    for name in names:
        both = [m for m in meshed if name in m.steiner]
        if not both:
            continue
        ours, theirs = (sum(m.steiner[k] for m in both) for k in ("mgdt", name))
        times = [sum(m.seconds[k] for m in both) for k in ("mgdt", name)]
        ratios = [(m.steiner["mgdt"] + 1) / (m.steiner[name] + 1) for m in both]
        speed = statistics.median(m.seconds["mgdt"] / m.seconds[name] for m in both)
        print(f"{name}: ends on {len(both)} of them, with {theirs} Steiner points (mgdt {ours}, median ratio "
              f"{statistics.median(ratios):.2f}) in {times[1]:.1f} s (mgdt {times[0]:.1f} s, median ratio {speed:.2f})")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("mgdt")
    parser.add_argument("--pairs", help="the program of facet_pairs.cpp")
    parser.add_argument("--cdt", help="the program of MarcoAttene/CDT")
    parser.add_argument("--only", default="", help="surfaces with this word in their names")
    parser.add_argument("--least", type=int, default=1, help="fail if there are fewer surfaces")
    parser.add_argument("--seconds", type=float, default=120, help="limit for each command")
    options = parser.parse_args()
    for name in ("mgdt", "pairs", "cdt"):
        if getattr(options, name):
            setattr(options, name, os.path.abspath(getattr(options, name)))
    suite = Suite(options)
    names = ["kept", "flat", "tetgen", "tetgen -pY"] + ["cdt"] * bool(options.cdt)
    models = []
    print(f"{'surface':40} {'points':>7} {'facets':>7}  Steiner points, seconds of mgdt, {', '.join(names)}")
    for path in sorted((suite.folder / "surfaces").iterdir()):
        model = suite.model(path) if options.only in path.name else None
        if model is None:
            continue
        models.append(model)
        figures = "  ".join(f"{model.steiner.get(k, '-'):>6} {model.seconds.get(k, 0):6.2f}" for k in ["mgdt", *names])
        print(f"{model.name[:40]:40} {model.points:7} {model.facets:7}  "
              f"{figures if model.outcome == 'meshed' else model.outcome}", flush=True)
    table([m for m in models if m.outcome == "meshed"], names)
    summary(models, names)
    wrong = [m for m in models if m.outcome not in OUTCOMES]
    if len(models) < options.least:
        print(f"there are {len(models)} surfaces; {options.least} were expected")
    print(f"{len(models) - len(wrong)} passed, {len(wrong) + (len(models) < options.least)} failed")
    sys.exit(bool(wrong) or len(models) < options.least)


if __name__ == "__main__":
    main()
