#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws the point distributions of the paper, and the two meshes that are refined locally.

  pictures.py --mgdt build/src/cli/mgdt [--out docs/paper]

The points come from `mgdt generate`. Needs the Debian packages python3-matplotlib, python3-scipy.
"""
import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from PIL import Image
from scipy.spatial import cKDTree

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import picture  # docs/picture.py, which draws triangulations
import matplotlib.pyplot as plt
from matplotlib.colors import LinearSegmentedColormap, LogNorm

INK, FRAME = "#1c2733", "#d1422f"
# Lines show on its darkest colour.
SPACING = LinearSegmentedColormap.from_list(
    "spacing", plt.colormaps["viridis"](np.linspace(0.25, 1, 256))
)
DEPTH = LinearSegmentedColormap.from_list("depth", ["#a9c3dd", "#12375f"])
MANY = 300  # times as many points where the magnified part would else have none

# The paper's figure, what is magnified about which point, and how many times.
SETS = {
    "uniform": ("Figure 15", None, 0),
    "line": ("Figure 16", (0.3, 0.3, 0.3), 1000),
    "diagonal": ("Figure 17", (0.5, 0.5, 0.5), 1000),
    "ellipse": ("Figure 18", None, 0),
    "spiral": ("Figure 19", (0.8, 0.5, 0.5), 1000),
    "cluster": ("Figure 20", (0.5, 0.5, 0.5), 50),
    "galaxy": ("Figure 30", "fullest", 200),
    "mixdiag": ("Figure 33", None, 0),
    "mixsphere": ("Figure 34", None, 0),
    "mixspiral": ("Figure 35", None, 0),
}
# Centre of refinement (as in src/cli/distributions.cpp), half the height of the part that is
# magnified, where from it is seen, nodes in the paper's Table 9, the unit of length and its figure.
SOLIDS = {
    "machine": ((0, 0, 103), 3.4, -52, 3318541, "mm", "Figure 31"),
    "church": ((29, 5.5, 3), 1.4, 132, 4824332, "m", "Figure 32"),
}
MOST = 150000  # nodes of the part that is magnified
ASPECT = 1.6  # of its width and height


class Tool:
    def __init__(self, program, folder):
        self.program, self.folder = program, Path(folder)

    def run(self, *arguments):
        subprocess.run([self.program, *map(str, arguments)], check=True)

    def points(self, kind, count):
        file = self.folder / f"{kind}.npy"
        self.run("generate", "-q", kind, count, "--data", HERE.parent / "data", "-o", file)
        return np.load(file)

    def tetrahedra(self, points):
        np.save(self.folder / "part.npy", points)
        self.run("triangulate", "-q", self.folder / "part.npy", "-o", self.folder / "part.vtu")
        return picture.read_vtu(self.folder / "part.vtu")


def save(figure, path, colours, dpi=100, means=0):
    """Indexed colours make a third of the size; means of what they stand for are truer, and larger."""
    figure.savefig(path, dpi=dpi)
    plt.close(figure)
    with Image.open(path) as whole:
        image = whole.convert("RGB")
    kind = Image.Quantize.MAXCOVERAGE
    image = image.quantize(colours, kind, kmeans=means, dither=Image.Dither.NONE)
    image.save(path, optimize=True)
    print(path)


# ------------------------------------------------------------------------------ point sets


class Perspective:
    """The unit cube seen from outside, from the left and a little from above."""

    def __init__(self):
        camera = picture.Camera(azimuth=-62, elevation=20)
        self.axes = np.stack([camera.right, camera.up, camera.towards])

    def project(self, points):
        """Positions in the plane, and the depth, larger when nearer."""
        x, y, z = self.axes @ (np.asarray(points, float) - 0.5).T
        return np.stack([x, y], axis=1) * (3 / (3 - z))[:, None], z


def cube_edges():
    corners = np.array(np.meshgrid([0, 1], [0, 1], [0, 1])).reshape(3, 8).T.astype(float)
    pairs = [(a, b) for a in corners for b in corners if tuple(a) < tuple(b)]
    return [(a, b) for a, b in pairs if abs(a - b).sum() == 1]


def scatter(axes, flat, depth, size):
    order = np.argsort(depth)
    axes.scatter(*flat[order].T, c=depth[order], cmap=DEPTH, s=size, linewidths=0)
    axes.set_aspect("equal")
    axes.set_xticks([])
    axes.set_yticks([])


def fullest(points, radius=0.02):
    """The middle of the neighbourhood with most points."""
    tree = cKDTree(points)
    around = tree.query_ball_point(points, radius, return_length=True)
    return points[tree.query_ball_point(points[np.argmax(around)], radius)].mean(axis=0)


def draw_set(axes, kind, points, magnified, centre, times):
    view = Perspective()
    for a, b in cube_edges():
        ends, depth = view.project([a, b])
        axes.plot(*ends.T, color="#c3cad2", linewidth=0.9 if min(depth) > -0.7 else 0.5, zorder=0)
    scatter(axes, *view.project(points), 1.6)
    axes.set_xlim(-0.85, 0.85)
    axes.set_ylim(-0.84, 0.8)
    axes.axis("off")
    axes.set_title(f"{SETS[kind][0]}: {kind}", fontsize=9, color=INK)
    if magnified is None:
        return
    flat, depth = view.project(magnified)
    middle = view.project([centre])[0][0]
    half = 0.5 / times
    near = np.all(np.abs(flat - middle) < half, axis=1)
    near[np.flatnonzero(near)[3000:]] = False
    # Where the set does not hide behind it.
    bottom = 0.5 if kind == "line" else 0.0
    inset = axes.inset_axes([0.0, bottom, 0.36, 0.36])
    scatter(inset, flat[near], depth[near], 1.4)
    inset.set_xlim(middle[0] - half, middle[0] + half)
    inset.set_ylim(middle[1] - half, middle[1] + half)
    for side in inset.spines.values():
        side.set_edgecolor(FRAME)
    inset.set_title(f"x {times}", fontsize=7, color=FRAME, pad=2)
    pointer = [(-0.55, 1.64 * (bottom + 0.18) - 0.84), middle]
    axes.plot(*zip(*pointer), color=FRAME, linewidth=0.6, alpha=0.7, zorder=1)


def draw_sets(tool, count, out):
    prepared = []
    for kind, (_, centre, times) in SETS.items():
        points = tool.points(kind, count)
        magnified = tool.points(kind, MANY * count) if times >= 1000 else points
        if isinstance(centre, str):
            centre = fullest(points)
        prepared.append((kind, points, magnified if times else None, centre, times))
    for name, chosen, rows, columns in (
        ("distributions.png", prepared[:7], 2, 4),
        ("mixes.png", prepared[7:], 1, 3),
    ):
        size = (2.6 * columns, 2.75 * rows)
        figure, grid = plt.subplots(rows, columns, figsize=size, layout="constrained")
        for axes in grid.flat[len(chosen) :]:
            axes.axis("off")
        for axes, one in zip(grid.flat, chosen):
            draw_set(axes, *one)
        save(figure, out / name, 32)
    for one in prepared:
        figure, axes = plt.subplots(figsize=(3.6, 3.8), layout="constrained")
        draw_set(axes, *one)
        save(figure, out / f"set-{one[0]}.png", 24)


# -------------------------------------------------------------------------- refined meshes


def read_mesh(path):
    """Nodes and tetrahedra of a mesh that docs/data/mesh.py packed."""
    data = Path(path).read_bytes()

    def counted(heading):
        start = data.index(heading) + len(heading)
        end = data.index(b"\n", start)
        return int(data[start:end]), end + 1

    node = np.dtype([("tag", "<i4"), ("xyz", "<f8", 3)])
    n, at = counted(b"$Nodes\n")
    nodes = np.frombuffer(data, node, n, at)["xyz"]
    element = np.dtype([("tag", "<i4"), ("nodes", "<i4", 4)])
    n, at = counted(b"$Elements\n")
    return nodes, np.frombuffer(data, element, n, at + 12)["nodes"] - 1


def cut_surface(points, tetrahedra, focus, camera):
    """Facets of what is left when the quarter between the focus and the eye is taken away, and
    whether each was on the surface before."""
    offset = points[tetrahedra].mean(axis=1)[:, :2] - np.asarray(focus[:2])
    kept = ~np.all(offset * np.sign(camera.towards[:2]) > 0, axis=1)
    code = np.array([len(points) ** 2, len(points), 1], dtype=np.float64)
    skin = picture.boundary(tetrahedra)[2] @ code
    facets, _, key = picture.boundary(tetrahedra[kept])
    return facets, np.isin(key @ code, skin)


def draw_part(axes, camera, mesh, focus, window, spacing, norm, line_width):
    points, tetrahedra = mesh
    facets, on_skin = cut_surface(points, tetrahedra, focus, camera)
    colours = SPACING(norm(spacing(points[facets].mean(axis=1))))[:, :3]
    colours[on_skin] = 0.55 * colours[on_skin] + 0.45 * picture.STEEL
    picture.draw(axes, camera, points, facets, colours, window, line_width)


def crowded_cell(points):
    """Points in the fullest cell of a regular grid with 8 a cell, as the paper's (4.1.1)."""
    low, extent = points.min(axis=0), np.ptp(points, axis=0)
    divisions = np.rint((len(points) / (8 * extent.prod())) ** (1 / 3) * extent).astype(int)
    cell = np.minimum(((points - low) / extent * divisions).astype(int), divisions - 1)
    return np.bincount(np.ravel_multi_index(cell.T, divisions)).max()


def draw_solid(tool, name, count, out):
    focus, half, azimuth, full, unit, figure_name = SOLIDS[name]
    count = count or full
    focus = np.array(focus, float)
    camera = picture.Camera(azimuth, elevation=24)
    base = read_mesh(HERE.parent / "data" / f"{name}.msh")
    nodes = tool.points(name, count)
    print(f"{name}: {count} nodes; {crowded_cell(nodes)} in the fullest of cells with 8 on average")

    def spacing_in(points):
        """The distance to the eighth neighbour is about an edge of a tetrahedron."""
        tree = cKDTree(points)
        return lambda at: tree.query(at, 8)[0][:, -1]

    before, after = spacing_in(base[0]), spacing_in(nodes)
    sample = np.concatenate([after(base[0]), before(base[0])])
    norm = LogNorm(*np.quantile(sample, [0.002, 0.998]))

    # What the detail's window shows, and behind it as much as is likely to be seen.
    middle = focus + [0, 0, 0.9 * half]
    along = np.stack([camera.right / ASPECT, camera.up, camera.towards / 3])
    distance = np.abs((nodes - middle) @ along.T).max(axis=1)
    if len(nodes) > MOST:
        half = min(half, np.partition(distance, MOST)[MOST] / 1.1)
    points, tetrahedra = tool.tetrahedra(nodes[distance < 1.1 * half])
    lengths = picture.edge_lengths(points, tetrahedra)
    within = picture.solid(points, tetrahedra, lengths)
    within &= lengths.max(axis=1) < 5 * np.median(lengths)  # slivers across the part's own faces
    refined = points, tetrahedra[within]

    figure = plt.figure(figsize=(11, 6.2), facecolor="white")
    whole = figure.add_axes([0.01, 0.12, 0.54, 0.8])
    eye = camera.project(middle[None])[0]
    flat = camera.project(base[0])
    middle = (flat.min(axis=0) + flat.max(axis=0)) / 2
    extent = 1.02 * np.ptp(flat, axis=0) / 2
    wide = 5.94 / 4.96  # of the axes, in inches
    reach = max(extent[1], extent[0] / wide)
    draw_part(whole, camera, base, focus, (middle, reach), after, norm, 0.1)
    whole.set_xlim(middle[0] - reach * wide, middle[0] + reach * wide)
    whole.axis("off")
    sides = half * np.array([ASPECT, 1])
    frame = plt.Rectangle(eye - sides, *(2 * sides), fill=False)
    frame.set(edgecolor=FRAME, linewidth=1.8, zorder=5)
    whole.add_patch(frame)
    details = (
        (0.515, base, before, 0.5, f"{len(base[0]):,} nodes"),
        (0.03, refined, after, 0.2, f"{count:,} nodes"),
    )
    for bottom, mesh, spacing, line_width, words in details:
        axes = figure.add_axes([0.56, bottom, 0.43, 0.43])
        draw_part(axes, camera, mesh, focus, (eye, half), spacing, norm, line_width)
        axes.set_xlim(eye[0] - sides[0], eye[0] + sides[0])
        axes.set_title(words, fontsize=9, color=INK, pad=3)
        for side in axes.spines.values():
            side.set(edgecolor=FRAME, linewidth=1.3)
    bar = figure.add_axes([0.04, 0.06, 0.3, 0.022])
    colour = plt.cm.ScalarMappable(norm, SPACING)
    figure.colorbar(colour, cax=bar, orientation="horizontal")
    ticks = np.outer(10.0 ** np.arange(-4, 4), [1, 2, 5]).ravel()
    ticks = ticks[(norm.vmin < ticks) & (ticks < norm.vmax)]
    bar.xaxis.set_ticks(ticks, [f"{t:g}" for t in ticks], fontsize=7)
    bar.xaxis.set_ticks([], minor=True)
    bar.set_title(f"spacing of the refined nodes, {unit}", fontsize=8, color=INK, loc="left")
    figure.text(0.02, 0.95, f"{figure_name}: {name}", fontsize=11, color=INK, weight="bold")
    # Meshes are noise to a compressor, so the picture is not larger than it must be.
    save(figure, out / f"{name}.png", 56, dpi=80, means=1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--mgdt", default="mgdt", help="the program")
    parser.add_argument("--out", default=HERE, type=Path, help="folder of the pictures")
    parser.add_argument("--points", default=6000, type=int, help="in a picture of a distribution")
    parser.add_argument("--nodes", type=int, help="of the refined meshes (default: Table 9)")
    parser.add_argument("--only", choices=["sets", *SOLIDS], help="draw these alone")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        tool = Tool(args.mgdt, scratch)
        if args.only in (None, "sets"):
            draw_sets(tool, args.points, args.out)
        for name in SOLIDS:
            if args.only in (None, name):
                draw_solid(tool, name, args.nodes, args.out)


if __name__ == "__main__":
    main()
