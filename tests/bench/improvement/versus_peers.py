#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Improves meshes with mgdt and with other programs, and prints a table.

usage: versus_peers.py [--meshes WORD,...] [--optimizers NAME,...] [--tetrahedra N] [--seconds N] [--runs N] [--keep FOLDER]

  --meshes WORD,...      only meshes with one of these words in their names
  --optimizers NAME,...  of gmsh, netgen, tetgen, cgal, mgdt (with its default options), mgdt-20, mgdt-25-slide, mgdt-30
                         and mgdt-30-slide; with a number, points may be removed, as the peers do. By default all
  --tetrahedra N         about how many the simple solids have; 40000 by default
  --seconds N            after which an optimiser is stopped; 300 by default
  --runs N               of which the shortest counts; 1 by default
  --keep FOLDER          leaves the meshes there, and takes those that are there

Needs the bindings for Python (PYTHONPATH, and MGDT_LIBRARY where the library is not installed), the Debian packages
gmsh, python3-meshio and python3-numpy, and for more meshes gmsh-doc. Peers that are not there are left out; Netgen is
in python3-netgen, and CGAL, which optimises only the meshes that it makes itself, in libcgal-dev. All use one thread.
An angle is the least dihedral angle of the mesh; times are microseconds of processor time for each tetrahedron of the
input, of the optimisation alone. The exit status is 1 if mgdt fails.
"""
import argparse
import os
import shutil
import statistics
import subprocess
import sys
import tempfile

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import meshes  # noqa: E402
from optimizers import MGDT  # noqa: E402

# How to find out whether a peer is there; None for a program of that name.
PEERS = {"gmsh": "import ctypes; ctypes.CDLL('libgmsh.so.4.8')", "netgen": "import netgen.meshing", "tetgen": None,
         "cgal": "import os; os.stat('/usr/include/CGAL/perturb_mesh_3.h')"}


def shapes(points, tetrahedra):
    """The least dihedral angle, the largest, and the mean of the measure V / l^3 that is 1 for regular tetrahedra."""
    a, b, c, d = (points[tetrahedra[:, i]] for i in range(4))
    normals = [np.cross(c - b, d - b), np.cross(d - a, c - a), np.cross(b - a, d - a), np.cross(c - a, b - a)]
    lengths = [np.linalg.norm(n, axis=1) for n in normals]
    cosines = []
    with np.errstate(invalid="ignore", divide="ignore"):
        for i in range(4):
            for j in range(i):
                cosines.append(-np.einsum("ij,ij->i", normals[i], normals[j]) / (lengths[i] * lengths[j]))
    angles = np.degrees(np.arccos(np.clip(np.nan_to_num(cosines, nan=1.0), -1, 1)))
    volumes = np.einsum("ij,ij->i", b - a, np.cross(c - a, d - a)) / 6
    edges = [b - a, c - a, d - a, c - b, d - b, d - c]
    squares = sum(np.einsum("ij,ij->i", e, e) for e in edges) / 6
    if (volumes > 0).mean() < 0.5:
        volumes = -volumes
    least = 0.0 if (volumes <= 0).any() else float(angles.min())
    return least, float(angles.max()), float(np.mean(6 * np.sqrt(2) * volumes / squares ** 1.5))


def improved(name, before, arguments, scratch):
    """The result of one optimiser: shapes, microseconds, tetrahedra; or a word for what has gone wrong."""
    if name == "cgal" and "cgal_points" not in np.load(before):
        return "-"
    after = os.path.join(scratch, "after.npz")
    best = None
    for _ in range(arguments.runs):
        try:
            run = subprocess.run([sys.executable, os.path.join(HERE, "optimizers.py"), name, before, after],
                                 capture_output=True, text=True, timeout=arguments.seconds, check=False)
        except subprocess.TimeoutExpired:
            return f"> {arguments.seconds} s"
        if run.returncode:
            print(f"{name}: {(run.stderr.strip().splitlines() or ['ended'])[-1]}", file=sys.stderr)
            return "fails"
        result = np.load(after)
        best = min(float(result["seconds"]), best or 1e9)
    count = len(np.load(before)["tetrahedra"])
    return (*shapes(result["points"], result["tetrahedra"]), best * 1e6 / count, len(result["tetrahedra"]))


def mesh_files(arguments, folder):
    """Names, and files with points, tetrahedra and regions."""
    words = arguments.meshes.split(",") if arguments.meshes else [""]
    for name, make in meshes.all_meshes(arguments.tetrahedra).items():
        if not any(word in name for word in words):
            continue
        path = os.path.join(folder, name.replace(" ", "-") + ".npz")
        if not os.path.exists(path):
            made = make()
            if made is None:
                print(f"{name}: no mesh", file=sys.stderr)
                continue
            points, tetrahedra, regions, *more = made
            regions = np.zeros(len(tetrahedra), np.int32) if regions is None else regions
            np.savez(path, points=points, tetrahedra=tetrahedra, regions=regions, **(more[0] if more else {}))
        yield name, path


def present(peer):
    if PEERS[peer] is None:
        return shutil.which(peer) is not None
    return subprocess.run([sys.executable, "-c", PEERS[peer]], capture_output=True, check=False).returncode == 0


def cell(result):
    if isinstance(result, str):
        return result
    return "%.1f (%s)" % (result[0], value(result[3]))


def value(number):
    """Two digits, without an exponent."""
    return "%.2g" % number if number < 99.5 else "%.0f" % number


def print_summary(rows, names):
    """How often each optimiser has the largest least angle, medians, and what of the targets is met."""
    print("\n| | least angle, median | best of all | mean of V/l³, median | µs, median | µs, largest |\n|---|---|---|---|---|---|")
    for name in names:
        done = [r[name] for r in rows if not isinstance(r[name], str)]
        if not done:
            continue
        best = sum(r[name][0] >= max(x[0] for x in r.values() if not isinstance(x, str)) - 1e-9 for r in rows
                   if not isinstance(r[name], str))
        print("| %s | %.1f | %d of %d | %.3f | %s | %s |" % (
            name, statistics.median(r[0] for r in done), best, len(rows), statistics.median(r[2] for r in done),
            value(statistics.median(r[3] for r in done)), value(max(r[3] for r in done))))
    print()
    for name in names:
        if name in MGDT:
            goal = MGDT[name].get("goal", 25)
            met = sum(not isinstance(r[name], str) and r[name][0] >= goal for r in rows)
            above = sum(not isinstance(r[name], str) and
                        all(isinstance(r[p], str) or r[name][0] > r[p][0] for p in names if p in PEERS) for r in rows)
            print("%s: the goal is reached on %d of %d, and on %d its least angle is larger than with any peer" %
                  (name, met, len(rows), above))


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1])
    parser.add_argument("--meshes")
    parser.add_argument("--optimizers", default=",".join([*PEERS, *MGDT]))
    parser.add_argument("--tetrahedra", type=int, default=40000)
    parser.add_argument("--seconds", type=int, default=300)
    parser.add_argument("--runs", type=int, default=1)
    parser.add_argument("--keep")
    arguments = parser.parse_args()
    names = []
    for name in arguments.optimizers.split(","):
        if name not in PEERS and name not in MGDT:
            parser.error(f"there is no optimizer {name}")
        if name in PEERS and not present(name):
            print(f"{name} is not installed, and left out", file=sys.stderr)
        else:
            names.append(name)
    print("| mesh | tetrahedra | before | " + " | ".join(names) + " |\n" + "|---" * (3 + len(names)) + "|")
    rows = []
    with tempfile.TemporaryDirectory(prefix="mgdt-improvement-") as scratch:
        folder = arguments.keep or scratch
        os.makedirs(folder, exist_ok=True)
        for mesh, path in mesh_files(arguments, folder):
            given = np.load(path)
            before = shapes(given["points"], given["tetrahedra"])[0]
            row = {name: improved(name, path, arguments, scratch) for name in names}
            rows.append(row)
            print("| %s | %d | %.2g | " % (mesh, len(given["tetrahedra"]), before) +
                  " | ".join(cell(row[name]) for name in names) + " |", flush=True)
    if rows:
        print_summary(rows, names)
    return 0 if rows and all(row[name] != "fails" for row in rows for name in names if name in MGDT) else 1


if __name__ == "__main__":
    sys.exit(main())
