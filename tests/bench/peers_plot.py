#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
r"""Draws how many times as long as mgdt other libraries take, for each set of points.

  mgdt-bench --peers --sizes 1e6 --runs 1 --time-limit 200 --csv BENCH.csv \
      --distributions uniform,line,diagonal,ellipse,spiral,cluster,galaxy
  peers_plot.py BENCH.csv APART.csv PICTURE

APART.csv has ratios of libraries that were measured apart, a line "distribution,library,ratio" each.
"""
import csv
import sys
from collections import defaultdict
from statistics import geometric_mean, median

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

NAMES = {"cgal": "CGAL", "tetgen": "TetGen", "qhull": "Qhull, which SciPy has"}


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    times, ratios, points, stopped = defaultdict(list), {}, set(), set()
    with open(sys.argv[1], newline="") as file:
        for row in csv.DictReader(file):
            if row["status"] == "ok":
                times[row["distribution"], row["library"]].append(float(row["total_seconds"]))
                points.add(int(row["points"]))
            else:
                stopped.add((NAMES[row["library"]], row["distribution"]))
    for (distribution, library), seconds in times.items():
        if library in NAMES:
            ratios.setdefault(NAMES[library], {})[distribution] = median(seconds) / median(times[distribution, "mgdt"])
    with open(sys.argv[2], newline="") as file:
        for row in csv.DictReader(file):
            ratios.setdefault(row["library"], {})[row["distribution"]] = float(row["ratio"])
    (size,) = points
    sets = list(dict.fromkeys(distribution for distribution, _ in times))
    order = sorted(ratios, key=lambda library: geometric_mean(ratios[library].values()))
    figure, axes = plt.subplots(figsize=(9, 3.6))
    width = 0.8 / len(order)
    for i, library in enumerate(order):
        places = [s + (i - (len(order) - 1) / 2) * width for s in range(len(sets))]
        heights = [ratios[library].get(name, float("nan")) for name in sets]
        bars = axes.bar(places, heights, width, label=library, color=matplotlib.colormaps["viridis"](i / len(order)))
        for place, name in zip(places, sets):
            if (library, name) in stopped:
                axes.text(place, 1.1, "stopped", rotation=90, fontsize=6, ha="center", va="bottom")
        axes.bar_label(bars, ["" if h != h else f"{h:.1f}" if h < 10 else f"{h:.0f}" for h in heights], fontsize=6, padding=1)
    axes.axhline(1, color="black", linewidth=1)
    axes.set_yscale("log")
    axes.set_yticks([1, 2, 5, 10, 20, 50], ["1: mgdt", "2", "5", "10", "20", "50"])
    axes.set_xticks(range(len(sets)), sets)
    axes.set_title(f"time over mgdt's, {size:,} points, one thread", fontsize=11)
    axes.legend(fontsize="small", ncol=len(order), loc="upper center", bbox_to_anchor=(0.5, -0.1), frameon=False)
    axes.spines[["top", "right"]].set_visible(False)
    figure.tight_layout()
    figure.savefig(sys.argv[3], dpi=110, metadata={"Software": None})
    for library in order:
        print(f"{library}: {geometric_mean(ratios[library].values()):.2f}")


main()
