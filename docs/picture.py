#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws a triangulation that mgdt wrote as .vtu: the whole and its finest part, cut open.

The Delaunay triangulation fills the convex hull. For points of a solid, the tetrahedra that are not
much larger than the spacing of the points around them make up the solid, and only they are drawn
(an alpha shape with local alpha); --hull draws all.

Needs the Debian packages python3-numpy and python3-matplotlib.
"""
import argparse
import re
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import LogNorm

INK = "#1c2733"
STEEL = np.array([0.74, 0.78, 0.83])
ALPHA = 1.7  # circumradius of a drawn tetrahedron, in spacings
EDGES = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)]
FACETS = [(1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)]  # outward, opposite each vertex


def read_vtu(path):
    """Points and tetrahedra of a file with appended raw arrays, as mgdt writes it."""
    with open(path, "rb") as f:
        data = f.read()
    start = data.find(b"_", data.find(b"<AppendedData")) + 1
    if start == 0:
        sys.exit(f"picture.py: {path}: not a .vtu with appended raw arrays, as mgdt writes it")
    offsets, types = {}, {"Float64": "<f8", "Int32": "<i4", "Int64": "<i8"}
    for tag in re.findall(rb"<DataArray[^>]*>", data[:start]):
        fields = dict(re.findall(r'(\w+)="([^"]*)"', tag.decode()))
        offsets[fields["Name"]] = start + int(fields["offset"]), types.get(fields["type"])

    def array(name):
        at, dtype = offsets[name]
        length = int(np.frombuffer(data, "<u8", 1, at)[0])
        return np.frombuffer(data, dtype, length // np.dtype(dtype).itemsize, at + 8)

    return array("Points").reshape(-1, 3), array("connectivity").reshape(-1, 4)


def edge_lengths(points, tetrahedra):
    corners = points[tetrahedra]
    return np.linalg.norm(
        np.stack([corners[:, a] - corners[:, b] for a, b in EDGES], axis=1), axis=2
    )


def circumradii(points, tetrahedra):
    """From the products of opposite edges and the volume (Crelle's formula)."""
    a, b, c = (points[tetrahedra[:, i]] - points[tetrahedra[:, 0]] for i in (1, 2, 3))
    six_volumes = np.abs(np.einsum("ij,ij->i", np.cross(a, b), c))
    u, v, w = (
        np.linalg.norm(p, axis=1) * np.linalg.norm(q - r, axis=1)
        for p, q, r in ((a, b, c), (b, c, a), (c, a, b))
    )
    product = np.maximum((u + v + w) * (u + v - w) * (u - v + w) * (v + w - u), 0)
    return np.sqrt(product) / np.maximum(4 * six_volumes, 1e-300)


def solid(points, tetrahedra, lengths):
    """Mask of the tetrahedra whose circumsphere fits the spacing at their vertices."""
    spacing = np.full(len(points), np.inf)
    for (a, b), length in zip(EDGES, lengths.T):
        np.minimum.at(spacing, tetrahedra[:, a], length)
        np.minimum.at(spacing, tetrahedra[:, b], length)
    return circumradii(points, tetrahedra) < ALPHA * spacing[tetrahedra].mean(axis=1)


def boundary(tetrahedra):
    """Facets of one tetrahedron only, outward, and the number of that tetrahedron."""
    facets = np.concatenate([tetrahedra[:, f] for f in FACETS])
    owner = np.tile(np.arange(len(tetrahedra)), 4)
    key = np.sort(facets, axis=1)
    order = np.lexsort(key.T)
    same = np.all(key[order][1:] == key[order][:-1], axis=1)
    single = np.ones(len(facets), bool)
    single[order[1:][same]] = False
    single[order[:-1][same]] = False
    return facets[single], owner[single], key[single]


class Camera:
    """Orthographic view from the direction of azimuth and elevation, in degrees."""

    def __init__(self, azimuth, elevation):
        a, e = np.radians([azimuth, elevation])
        self.towards = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
        self.right = np.array([-np.sin(a), np.cos(a), 0])
        self.up = np.cross(self.towards, self.right)
        light = 0.75 * self.towards + 0.55 * self.up - 0.45 * self.right
        self.light = light / np.linalg.norm(light)

    def project(self, points):
        return np.stack([points @ self.right, points @ self.up], axis=1)


def draw(axes, camera, points, facets, colours, window, line_width):
    """Paints the facets that face the camera, far ones first; window is (centre, half height)."""
    corners = points[facets]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
    flat = camera.project(points)[facets]
    centre, half = window
    near = np.all(np.abs(flat.mean(axis=1) - centre) < 1.3 * half * np.array([1.4, 1.0]), axis=1)
    seen = np.flatnonzero((normals @ camera.towards > 0) & near)
    seen = seen[np.argsort(corners[seen].mean(axis=1) @ camera.towards)]
    shade = 0.5 + 0.55 * np.clip(normals[seen] @ camera.light, 0, 1)
    axes.add_collection(
        PolyCollection(
            flat[seen],
            facecolors=np.clip(colours[seen] * shade[:, None], 0, 1),
            edgecolors=(0.05, 0.08, 0.12, 0.55),
            linewidths=line_width,
        )
    )
    axes.set_aspect("equal")
    axes.set_ylim(centre[1] - half, centre[1] + half)
    axes.set_xticks([])
    axes.set_yticks([])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("mesh", help=".vtu written by mgdt")
    parser.add_argument("picture", help=".png, .pdf or .svg to write")
    parser.add_argument("--hull", action="store_true", help="draw every tetrahedron")
    parser.add_argument("--title", default="", help="line above the picture")
    parser.add_argument("--azimuth", type=float, default=-52)
    parser.add_argument("--elevation", type=float, default=24)
    args = parser.parse_args()

    points, tetrahedra = read_vtu(args.mesh)
    if len(tetrahedra) == 0:
        sys.exit(f"picture.py: {args.mesh} has no tetrahedra to draw")
    total = len(tetrahedra)
    lengths = edge_lengths(points, tetrahedra)
    if not args.hull:
        keep = solid(points, tetrahedra, lengths)
        tetrahedra, lengths = tetrahedra[keep], lengths[keep]
    size = lengths.mean(axis=1)

    # The quarter in front of the finest part is cut away.
    camera = Camera(args.azimuth, args.elevation)
    focus = np.median(points, axis=0)
    offset = points[tetrahedra].mean(axis=1)[:, :2] - focus[:2]
    removed = np.all(offset * np.sign(camera.towards[:2]) > 0, axis=1)
    _, _, skin = boundary(tetrahedra)
    facets, owner, key = boundary(tetrahedra[~removed])
    size = size[~removed][owner]
    code = np.array([len(points) ** 2, len(points), 1], dtype=np.float64)
    on_skin = np.isin(key @ code, skin @ code)

    norm = LogNorm(*np.quantile(size, [0.002, 0.998]))
    palette = matplotlib.colormaps["viridis"]
    colours = palette(norm(size))[:, :3]
    colours[on_skin] = 0.2 * colours[on_skin] + 0.8 * STEEL

    figure = plt.figure(figsize=(14, 7.6), facecolor="white")
    whole = figure.add_axes([0.01, 0.1, 0.56, 0.84])
    detail = figure.add_axes([0.585, 0.1, 0.405, 0.82])
    flat = camera.project(points)
    low, high = flat.min(axis=0), flat.max(axis=0)
    width, height = 1.04 * (high - low) / 2
    wide = 7.84 / 6.38  # width and height of the axes, in inches
    half = max(height, width / wide)
    centre = (low + high) / 2
    draw(whole, camera, points, facets, colours, (centre, half), 0.12)
    whole.set_xlim(centre[0] - half * wide, centre[0] + half * wide)
    whole.axis("off")

    eye = camera.project(focus[None])[0]
    reach = min(1.2 * np.median(np.linalg.norm(points - focus, axis=1)), 0.5 * half)
    draw(detail, camera, points, facets, colours, (eye, reach), 0.25)
    detail.set_xlim(eye[0] - reach * 0.96, eye[0] + reach * 0.96)
    frame = plt.Rectangle(eye - reach * np.array([0.96, 1]), 1.92 * reach, 2 * reach, fill=False)
    frame.set(edgecolor="#d1422f", linewidth=1.6, clip_on=False)
    whole.add_patch(frame)
    for side in detail.spines.values():
        side.set(edgecolor="#d1422f", linewidth=1.6)

    bar = figure.add_axes([0.06, 0.065, 0.3, 0.02])
    figure.colorbar(plt.cm.ScalarMappable(norm, palette), cax=bar, orientation="horizontal")
    ticks = np.outer(10.0 ** np.arange(-12, 12), [1, 2, 5]).ravel()
    ticks = ticks[(norm.vmin < ticks) & (ticks < norm.vmax)]
    bar.xaxis.set_ticks(ticks, [f"{t:g}" for t in ticks])
    bar.xaxis.set_ticks([], minor=True)
    bar.set_title("mean edge of a tetrahedron", fontsize=10, color=INK, loc="left")
    figure.text(0.02, 0.94, args.title, fontsize=17, color=INK, weight="bold")
    counts = f"{len(points):,} points, {total:,} tetrahedra"
    figure.text(0.99, 0.045, counts, fontsize=12, color=INK, ha="right")
    figure.savefig(args.picture, dpi=130)


if __name__ == "__main__":
    main()
