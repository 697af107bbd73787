# SPDX-License-Identifier: MIT
"""The plots of the report. mgdt's figures are solid lines, the paper's dashed ones."""
import io

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, NullFormatter
from PIL import Image, PngImagePlugin

from figures import DISTRIBUTIONS, SCHEMES, cost

INK, PALE, FAILED = "#1c2733", "#d9dee4", "#b3261e"
COLOURS = dict(zip(SCHEMES, "#e08214 #2166ac #1b7837 #8c510a #9970ab #7f7f7f #d6002a".split()))
MARKERS = dict(zip(SCHEMES, "s o ^ x D v *".split()))
MORE_COLOURS = "#00808f #c51b8a #5a5a00 #1c2733".split()  # of schemes beside those


def look(scheme, study):
    """Colour and marker."""
    if scheme in COLOURS:
        return dict(color=COLOURS[scheme], marker=MARKERS[scheme])
    k = study.schemes().index(scheme) - len(SCHEMES)
    return dict(color=MORE_COLOURS[k % len(MORE_COLOURS)], marker="P")


plt.rcParams.update(
    {"font.size": 8, "axes.edgecolor": INK, "text.color": INK, "axes.titleweight": "bold"}
)


def save(figure, path, digest):
    """An indexed PNG, small enough for a repository, that names the figures it is of."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=100)
    plt.close(figure)
    image = Image.open(buffer).convert("RGB")
    image = image.quantize(64, Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE)
    text = PngImagePlugin.PngInfo()
    text.add_text("figures", digest)
    image.save(path, optimize=True, pnginfo=text)
    return path


def legend(axes, study):
    lines = [Line2D([], [], markersize=5, label=s, **look(s, study)) for s in study.schemes()]
    lines.append(Line2D([], [], color=INK, label="mgdt"))
    lines.append(Line2D([], [], color=INK, linestyle="--", label="the paper"))
    lines.append(
        Line2D([], [], color=FAILED, marker="X", linestyle="", label="failed, or too slow")
    )
    axes.axis("off")
    axes.legend(handles=lines, loc="center", fontsize=9, frameon=False)


def curve(source, distribution, scheme, quantity):
    points = sorted(n for d, n, s in source if d == distribution and s == scheme)
    values = [(n / 1e6, quantity(source, distribution, n, scheme)) for n in points]
    return [(n, v) for n, v in values if v is not None]


def panels(study, title, label, quantity):
    """One panel a distribution: `quantity` of ours and the paper's against the number of points."""
    figure, grid = plt.subplots(2, 4, figsize=(11.5, 5.9), layout="constrained")
    for axes, kind in zip(grid.flat, DISTRIBUTIONS):
        for scheme in study.schemes():
            style = dict(look(scheme, study), markersize=3.5)
            theirs = curve(study.paper, kind, scheme, quantity)
            ours = curve(study.ours, kind, scheme, quantity)
            if theirs:
                axes.plot(*zip(*theirs), linewidth=1, linestyle=(0, (3, 2)), alpha=0.7, **style)
            if ours:
                axes.plot(*zip(*ours), linewidth=1.6, **style)
        axes.set(title=kind, xscale="log", yscale="log")
        axes.grid(color=PALE, linewidth=0.5, which="both")
        axes.xaxis.set_major_formatter(FuncFormatter(lambda v, _: f"{v:g}M"))
        axes.yaxis.set_major_formatter(FuncFormatter(lambda v, _: f"{v:g}"))
        low, high = axes.get_xlim()
        ticks = (0.4, 1, 2, 4, 10, 20) if high > 4 * low else (0.4, 0.8, 1.2, 2, 3, 4, 5, 6, 8)
        axes.set_xticks([t for t in ticks if low <= t <= high])
        axes.set_yticks([t for t in TICKS if axes.get_ylim()[0] <= t <= axes.get_ylim()[1]])
        axes.xaxis.set_minor_formatter(NullFormatter())
        axes.yaxis.set_minor_formatter(NullFormatter())
        failures(study, kind, axes)
        if axes in grid[:, 0]:
            axes.set_ylabel(label)
    legend(grid.flat[-1], study)
    figure.suptitle(title, fontsize=11, weight="bold")
    return figure


TICKS = [d * 10.0**e for e in range(-3, 5) for d in (1, 1.5, 2, 3, 5)]


def failures(study, kind, axes):
    """A cross on the upper edge for each run without figures, at its size, and what went wrong."""
    words = {}
    for (distribution, points, scheme), known in study.ours.items():
        if distribution == kind and known.total is None and scheme in study.schemes():
            words.setdefault(f"{scheme}: {known.status}", []).append(points / 1e6)
    place = dict(transform=axes.get_xaxis_transform(), clip_on=False, color=FAILED)
    for i, (word, points) in enumerate(words.items()):
        axes.plot(points, [0.96] * len(points), marker="X", linestyle="", markersize=7, **place)
        at = ", ".join(f"{n:g}M" for n in sorted(points))
        axes.text(axes.get_xlim()[1], 0.88 - 0.07 * i, f"{word} at {at} ", ha="right", fontsize=6.5,
                  **place)


def relative_cost(source, distribution, points, scheme):
    """Beside multi-grid at the smallest size, in the same source."""
    first = min(n for d, n, _ in source if d == distribution)
    base = cost(source, distribution, first, "multi-grid")
    own = cost(source, distribution, points, scheme)
    return own / base if own and base else None


def draw_all(study, folder):
    def visited(source, *key):
        return getattr(source.get(key), "np", None)

    def removed(source, *key):
        return getattr(source.get(key), "nr", None)

    made = {
        "cost.png": panels(
            study,
            "Time per point, divided by multi-grid's at the smallest size in the same study",
            "relative time",
            relative_cost,
        ),
        "np.png": panels(study, "NP: tetrahedra visited to find the base", "NP", visited),
        "nr.png": panels(study, "NR: tetrahedra removed by an insertion", "NR", removed),
    }
    return [save(figure, folder / name, study.digest) for name, figure in made.items()]
