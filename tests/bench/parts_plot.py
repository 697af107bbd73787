#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws what `parts` prints: points that parts received and needed, over the number of parts.

  parts 1000 1,2,4,8,16,32,64,125,250,500,1000 | parts_plot.py PICTURE
"""
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

rows = {}
for line in sys.stdin:
    words = line.split()
    if len(words) == 9 and int(words[1]) > 1:
        rows.setdefault(words[0], []).append([float(w.rstrip("%")) for w in words[1:]])
if not rows or len(sys.argv) != 2:
    sys.exit(__doc__)
figure, axes = plt.subplots(figsize=(7.5, 4.5))
for name, values in rows.items():
    parts, _, received, needed = list(zip(*values))[:4]
    line, = axes.loglog(parts, received, label=name)
    axes.loglog(parts, needed, linestyle=":", color=line.get_color())
each = next(iter(rows.values()))[0][1]
axes.set_xlabel(f"parts of {each:,.0f} points")
axes.set_ylabel("percent of own points: received, needed (dotted)")
axes.grid(True, which="major", alpha=0.3)
axes.legend(fontsize="small", ncol=2)
figure.tight_layout()
figure.savefig(sys.argv[1], dpi=110, metadata={"Software": None})
