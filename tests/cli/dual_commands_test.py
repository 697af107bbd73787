#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""mgdt voronoi, surface, hull and relax: what they write, and what they refuse.

Usage: dual_commands_test.py MGDT [unittest arguments]
"""

import csv
import math
import os
import re
import struct
import sys
import unittest
from collections import Counter

sys.dont_write_bytecode = True  # the source tree stays as it is
import cli_test
from cli_test import CliTest

TETRAHEDRON = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
BOX = (-1, -2, -3, 12, 13, 14)
BOX_OPTION = "--bounds=" + ",".join(map(str, BOX))


class Dual(CliTest):
    def doubles(self, name):
        content = self.get(name)
        return struct.unpack(f"<{len(content) // 8}d", content)

    def points(self, name):
        x = self.doubles(name)
        return [x[i:i + 3] for i in range(0, len(x), 3)]

    def generate(self, kind, count, name="p.f64", seed=1):
        self.mgdt("generate", "-q", kind, count, "-o", name, "--seed", seed)
        return self.points(name)


class Cells(Dual):
    def table(self, *options, **more):
        text = self.mgdt("voronoi", *options, "--csv", "-", **more).decode()
        rows = list(csv.DictReader(text.splitlines()))
        for i, row in enumerate(rows):
            row["neighbors"] = [int(n) for n in row["neighbors"].split()]
            for name in row:
                if name != "neighbors":
                    row[name] = float(row[name])
            self.assertEqual(row["faces"], len(row["neighbors"]))
        return rows

    def test_table_of_a_corner(self):
        """The cell of the corner of a unit cube is an eighth of it."""
        rows = self.table("-", "--from", "xyz", "--bounds", "0,0,0,1,1,1", data=TETRAHEDRON.encode())
        self.assertEqual([r["point"] for r in rows], [0, 1, 2, 3])
        first = rows[0]
        self.assertEqual([first[n] for n in ("x", "y", "z", "volume", "area")], [0, 0, 0, 0.125, 1.5])
        self.assertEqual([first["centroid_" + c] for c in "xyz"], [0.25] * 3)
        # The walls of the least x, y and z have Voro++'s numbers.
        self.assertEqual(sorted(first["neighbors"]), [-5, -3, -1, 1, 2, 3])
        self.assertAlmostEqual(sum(r["volume"] for r in rows), 1, delta=1e-15)
        shifted = self.table("-", "--from", "xyz", "--bounds", "0,0,0,1,1,1", "--index-base", 1, data=TETRAHEDRON.encode())
        self.assertEqual([r["point"] for r in shifted], [1, 2, 3, 4])
        self.assertEqual(sorted(shifted[0]["neighbors"]), [-5, -3, -1, 2, 3, 4])

    def test_tables_of_sets(self):
        """Cells fill the box, and neighbours are each other's."""
        for kind, count in (("uniform", 2000), ("lattice", 512), ("spiral", 500), ("cluster", 800)):
            with self.subTest(kind=kind):
                self.generate(kind, count)
                rows = self.table("p.f64", BOX_OPTION)
                volume = math.prod(BOX[3 + k] - BOX[k] for k in range(3))
                self.assertLess(abs(math.fsum(r["volume"] for r in rows) / volume - 1), 1e-12)
                pairs = {(i, n) for i, r in enumerate(rows) for n in r["neighbors"] if n >= 0}
                self.assertEqual(pairs, {(b, a) for a, b in pairs})
                walls = {n for r in rows for n in r["neighbors"] if n < 0}
                self.assertEqual(walls, {-1, -2, -3, -4, -5, -6})

    def test_planes_are_as_a_box(self):
        self.generate("uniform", 300)
        self.put("planes", "# least x\n-1 0 0 1\n1 0 0 12\n0 -1 0 2\n0 1 0 13\n\n0 0 -1 3\n0 0 1 14\n")
        self.assertEqual(self.table("p.f64", "--planes", "planes"), self.table("p.f64", BOX_OPTION))
        own = self.points("p.f64")
        ends = [f(p[k] for p in own) for f in (min, max) for k in range(3)]
        self.assertEqual(self.table("p.f64", "--bounds", "auto"), self.table("p.f64", "--bounds=" + ",".join(map(repr, ends))))

    def test_unbounded_and_repeated(self):
        rows = self.table("-", "--from", "xyz", data=(TETRAHEDRON + "0 0 0\n").encode())
        self.assertEqual([r["volume"] for r in rows], [math.inf] * 4 + [0])
        self.assertEqual(rows[4]["neighbors"], [])
        self.mgdt("voronoi", "-", "--from", "xyz", "-o", "c.vtu", data=TETRAHEDRON.encode())
        self.assertIn("4 cells are unbounded and left out; clip with --bounds", self.err)
        self.assertIn(b"4 points, 0 cells", self.out)

    def test_small_faces(self):
        """A turned lattice has tiny faces, which a least share leaves out on both sides."""
        self.generate("lattice", 729)
        turned = []
        places = self.points("p.f64")
        ends = {x for p in places for x in p}
        inside = {i for i, p in enumerate(places) if min(ends) < min(p) and max(p) < max(ends)}
        for x, y, z in places:
            x, y = 0.6 * x - 0.8 * y, 0.8 * x + 0.6 * y
            turned.append((x, 0.28 * y - 0.96 * z, 0.96 * y + 0.28 * z))
        self.put("turned.xyz", "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in turned))
        inner = lambda rows: [r["faces"] for r in rows if r["point"] in inside]
        self.assertGreater(len(set(inner(self.table("turned.xyz")))), 1)
        for option in ("--least-share", "--least-area"):
            self.assertEqual(set(inner(self.table("turned.xyz", option, 1e-9))), {6.0})

    def test_same_bits(self):
        self.generate("galaxy", 3000)
        self.mgdt("voronoi", "-q", "p.f64", "--bounds", "auto", "-o", "a.vtu", "--csv", "a.csv")
        self.mgdt("voronoi", "-q", "p.f64", "--bounds", "auto", "-o", "b.vtu", "--csv", "b.csv", "--threads", 3, "--scheme", "random")
        self.assertEqual(self.get("a.vtu"), self.get("b.vtu"))
        self.assertEqual(self.get("a.csv"), self.get("b.csv"))

    def test_nothing_at_all(self):
        for options in ((), ("--bounds", "auto"), ("--bounds", "0,0,0,1,1,1")):
            self.assertEqual(self.table("-", "--from", "xyz", "--allow-empty", *options, data=b""), [])

    def test_few_faces_are_left(self):
        self.generate("uniform", 50)
        self.mgdt("voronoi", "p.f64", "--bounds", "auto", "--least-area", 0.05, "-o", "c.vtu", "--csv", "c.csv")
        few = [r for r in csv.DictReader(self.get("c.csv").decode().splitlines()) if int(r["faces"]) < 4]
        self.assertGreater(len(few), 3)
        self.assertIn(f"{len(few)} cells have fewer than four faces and are left out", self.err)
        self.assertIn(f"50 points, {50 - len(few)} cells", self.out.decode())

    def test_refused(self):
        four = self.put("p.xyz", TETRAHEDRON)
        flat = self.put("flat.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n")
        self.fails(2, "voronoi", four, says="--csv")
        self.fails(2, "voronoi", four, "-o", "c.msh", says="no place for polyhedra")
        self.fails(2, "voronoi", four, "-o", "c.vtu", "--csv", "c.vtu", says="same file")
        self.fails(2, "voronoi", four, "-o", "c.vtu", "--bounds", "0,0,0,1,1", says="six numbers")
        self.fails(2, "voronoi", four, "-o", "c.vtu", "--bounds", "0,0,0,1,1,1,1", says="six numbers")
        self.fails(2, "voronoi", four, "-o", "c.vtu", "--bounds", "0,0,0,1,1,inf", says="six numbers")
        self.fails(2, "voronoi", four, "-o", "c.vtu", "--bounds", "0,1,0,1,1,1", says="the largest y is 1, and the least 1")
        self.fails(2, "voronoi", four, "-o", "c.vtu", "--bounds", "auto", "--planes", "x", says="--planes")
        self.fails(2, "voronoi", four, "-o", "c.vtu", "--least-area", "nan", says="--least-area")
        self.fails(2, "voronoi", four, "-o", "c.vtu", "--least-area=-1", says="--least-area")
        self.fails(2, "voronoi", four, "-o", "c.vtu", "--least-share", "1", says="--least-share")
        self.fails(3, "voronoi", four, "-o", "c.vtu", "--bounds", "0,0,0,1,0.5,1", says=["p.xyz", "point 2"])
        self.fails(3, "voronoi", flat, "-o", "c.vtu", says=["flat.xyz", "on a plane", "no cells"])
        self.mgdt("voronoi", "-q", flat, "--bounds=-9,-9,-9,9,9,9", "-o", "flat.vtu")
        self.fails(3, "voronoi", four, "-o", "c.vtu", "--planes", "none", says="none")
        for text, why in (("", "no planes"), ("1 2 3\n", "line 1"), ("1 0 0 9\n1 2 3 4 5\n", "line 2"),
                          ("1 0 0 nan\n", "line 1"), ("0 0 0 1\n", "p.xyz"), ("1 0 0 9\n", "p.xyz")):
            self.put("planes", text)
            self.fails(3, "voronoi", four, "-o", "c.vtu", "--planes", "planes", says=why)
        self.refuses("voronoi", four, "--csv", "p.xyz", says="would overwrite")
        self.put("planes", "-1 0 0 0\n1 0 0 1\n0 -1 0 0\n0 1 0 1\n0 0 -1 0\n0 0 1 1\n")
        self.refuses("voronoi", four, "--planes", "planes", "--csv", "planes", says="would overwrite")
        for command in (("voronoi", four, "--csv", "c.csv"), ("relax", four, "-o", "r.xyz", "--steps", 1)):
            for option in ("--bounds", "--planes"):
                self.fails(2, *command, option, "", says=["it is empty", option])
        for option in (("--compress",), ("--to", "vtu")):
            self.fails(2, "voronoi", four, "--csv", "c.csv", *option, says="--compress and --to")


class Surfaces(Dual):
    """The same surface from every format."""

    @staticmethod
    def by_position(points, triangles):
        """Triangles by the places of their corners, the least one first."""
        found = []
        for t in triangles:
            corners = [tuple(points[v]) for v in t]
            k = corners.index(min(corners))
            found.append(tuple(corners[k:] + corners[:k]))
        return sorted(found)

    def read_ply(self, name):
        content = self.get(name)
        head, body = content.split(b"end_header\n", 1)
        n, m = (int(re.search(rb"element %s (\d+)" % e, head).group(1)) for e in (b"vertex", b"face"))
        self.assertEqual(len(body), 24 * n + 13 * m)
        points = [struct.unpack_from("<3d", body, 24 * i) for i in range(n)]
        faces = [struct.unpack_from("<B3i", body, 24 * n + 13 * i) for i in range(m)]
        self.assertTrue(all(f[0] == 3 for f in faces))
        return self.by_position(points, [f[1:] for f in faces])

    def read_off(self, name):
        words = self.get(name).decode().split()
        self.assertEqual(words[0], "OFF")
        n, m = int(words[1]), int(words[2])
        rest = words[4:]
        points = [tuple(map(float, rest[3 * i:3 * i + 3])) for i in range(n)]
        faces = [list(map(int, rest[3 * n + 4 * i:3 * n + 4 * i + 4])) for i in range(m)]
        self.assertEqual(len(rest), 3 * n + 4 * m)
        return self.by_position(points, [f[1:] for f in faces])

    def read_obj(self, name):
        lines = [line.split() for line in self.get(name).decode().splitlines()]
        points = [tuple(map(float, w[1:])) for w in lines if w[0] == "v"]
        return self.by_position(points, [[int(v) - 1 for v in w[1:]] for w in lines if w[0] == "f"])

    def read_stl(self, name):
        content = self.get(name)
        n = struct.unpack_from("<I", content, 80)[0]
        self.assertEqual(len(content), 84 + 50 * n)
        self.assertNotEqual(content[:5], b"solid")
        found = []
        for i in range(n):
            x = struct.unpack_from("<12fH", content, 84 + 50 * i)
            normal, a, b, c = x[:3], x[3:6], x[6:9], x[9:12]
            u, v = ([q[k] - a[k] for k in range(3)] for q in (b, c))
            cross = [u[k - 2] * v[k - 1] - u[k - 1] * v[k - 2] for k in range(3)]
            length = math.hypot(*cross)
            self.assertTrue(all(abs(normal[k] - cross[k] / length) < 1e-3 for k in range(3)))
            found.append((a, b, c))
        return self.by_position(sorted({p for t in found for p in t}),
                                [[sorted({p for t in found for p in t}).index(p) for p in t] for t in found])

    @staticmethod
    def as_floats(triangles):
        rounded = lambda p: tuple(struct.unpack("<f", struct.pack("<f", x))[0] for x in p)
        return sorted(tuple(map(rounded, t)) for t in triangles)

    def in_every_format(self, *command):
        for ending in ("ply", "off", "obj", "stl"):
            self.mgdt(*command, "-q", "-o", "s." + ending)
        triangles = self.read_ply("s.ply")
        self.assertEqual(self.read_off("s.off"), triangles)
        self.assertEqual(self.read_obj("s.obj"), triangles)
        self.assertEqual(self.read_stl("s.stl"), self.as_floats(triangles))
        return triangles

    def closed(self, triangles):
        edges = Counter((t[i], t[(i + 1) % 3]) for t in triangles for i in range(3))
        self.assertEqual(edges, Counter({(b, a): n for (a, b), n in edges.items()}))

    @staticmethod
    def volume(triangles):
        return math.fsum(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                         a[2] * (b[0] * c[1] - b[1] * c[0]) for a, b, c in triangles) / 6

    def test_hull(self):
        self.generate("uniform", 500)
        triangles = self.in_every_format("hull", "p.f64")
        self.closed(triangles)
        said = self.mgdt("hull", "p.f64", "-o", "h.ply").decode()
        n = len({p for t in triangles for p in t})
        self.assertRegex(said, rf"^500 points, {n} on the hull, {2 * n - 4} triangles, volume (\S+), area \S+: h.ply$")
        self.assertLess(abs(float(re.search(r"volume ([^,]+)", said).group(1)) - self.volume(triangles)), 1e-6)
        # The shape of an infinite radius is the hull.
        self.assertEqual(self.in_every_format("surface", "p.f64", "--alpha", "inf"), triangles)

    def test_hull_of_a_cube(self):
        self.put("c.xyz", "".join(f"{x} {y} {z}\n" for x in (0, 1, 2) for y in (0, 1, 2) for z in (0, 1, 2)))
        said = self.mgdt("hull", "c.xyz", "-o", "h.off").decode()
        self.assertIn("27 points, 26 on the hull, 48 triangles, volume 8, area 24: h.off", said)

    def test_shapes(self):
        self.generate("galaxy", 3000)
        for alpha in ("auto", "0.02", "0.1"):
            with self.subTest(alpha=alpha):
                triangles = self.in_every_format("surface", "p.f64", "--alpha", alpha)
                self.assertGreater(len(triangles), 0)
                self.closed(triangles)
                self.assertGreater(self.volume(triangles), 0)

    def test_alpha_that_is_printed(self):
        """It gives the same shape again."""
        for seed in range(6):
            self.generate("uniform", 300, seed=seed)
            said = self.mgdt("surface", "p.f64", "-o", "a.ply").decode()
            alpha = re.search(r"alpha (\S+), 1 solid", said).group(1)
            self.mgdt("surface", "p.f64", "-o", "b.ply", "--alpha", alpha)
            self.assertEqual(self.get("a.ply"), self.get("b.ply"))

    def test_alpha_whose_square_is_no_double(self):
        self.put("large.xyz", "".join(f"{1e170 * x!r} {1e170 * y!r} {1e170 * z!r}\n" for x, y, z in self.generate("uniform", 30)))
        self.fails(2, "surface", "large.xyz", "-o", "s.ply", "--alpha", "1e169", says=["--alpha", "beyond doubles"])
        self.fails(2, "surface", "large.xyz", "-o", "s.ply", "--alpha", "1e-170", says=["--alpha", "beyond doubles"])
        self.fails(3, "surface", "large.xyz", "-o", "s.ply", says=["large.xyz", "scale the points"])
        self.assertIn(b"volume beyond doubles", self.mgdt("hull", "large.xyz", "-o", "s.ply"))

    def two_cubes(self):
        """Two cubes of side 1 and 2, far apart."""
        cube = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
        places = cube + [(10 + 2 * x, 2 * y, 2 * z) for x, y, z in cube]
        self.put("two.xyz", "".join(f"{x} {y} {z}\n" for x, y, z in places))

    def test_largest_solid(self):
        self.two_cubes()
        said = self.mgdt("surface", "two.xyz", "--alpha", 1.8, "-o", "s.ply").decode()
        self.assertIn("2 solids: 24 triangles with volume 9, 0 edges that are not manifold", said)
        said = self.mgdt("surface", "two.xyz", "--alpha", 1.8, "-o", "l.ply", "--largest").decode()
        self.assertIn("2 solids, the largest: 12 triangles with volume 8, 0 edges", said)
        self.assertEqual(min(p for t in self.read_ply("l.ply") for p in t)[0], 10)
        self.mgdt("surface", "two.xyz", "--alpha", 0.1, "-o", "none.ply")
        self.assertEqual(self.read_ply("none.ply"), [])

    def test_an_edge_that_is_not_manifold(self):
        """Two tetrahedra that touch along an edge."""
        self.put("edge.xyz", "0 0 -.5\n0 0 .5\n1 .5 0\n1 -.5 0\n-1 .5 0\n-1 -.5 0\n")
        said = self.mgdt("surface", "edge.xyz", "--alpha", 0.8, "-o", "s.obj").decode()
        self.assertIn("2 solids: 8 triangles with volume 0.333333, 1 edge that is not manifold", said)

    def test_flat(self):
        self.put("flat.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n")
        for command in ("surface", "hull"):
            self.mgdt(command, "flat.xyz", "-o", "s.off")
            self.assertIn("all points are on a plane, so there is no surface", self.err)
            self.assertEqual(self.get("s.off").split(), [b"OFF", b"0", b"0", b"0"])

    def test_refused(self):
        four = self.put("p.xyz", TETRAHEDRON)
        for command in ("surface", "hull"):
            self.fails(2, command, four, says="--output")
            self.fails(2, command, four, "-o", "s.vtu", says="no place for triangles")
            self.fails(2, command, four, "-o", "s.ply", "--compress", says="--compress")
            self.refuses(command, "p.xyz", "-o", "p.xyz", "--to", "off", says="would overwrite")
        for alpha in ("x", "-1", "nan", ""):
            self.fails(2, "surface", four, "-o", "s.ply", "--alpha=" + alpha, says="--alpha")
        self.put("far.xyz", "0 0 0\n1e60 0 0\n0 1 0\n0 0 1\n")
        self.fails(2, "hull", "far.xyz", "-o", "s.stl", says=["floats", "1e+60", ".ply"])
        self.put("near.xyz", "1 0 0\n1.0000000001 0 0\n0 1 0\n0 0 1\n")
        self.fails(2, "hull", "near.xyz", "-o", "s.stl", says=["floats", ".ply"])
        self.mgdt("hull", "near.xyz", "-o", "s.off")


class Flat(Dual):
    def turned(self):
        self.generate("lattice", 343)
        rows = ((0.6 * x - 0.8 * y, 0.8 * x + 0.6 * y, z + 0.1 * x) for x, y, z in self.points("p.f64"))
        self.put("turned.xyz", "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in rows))

    def volume(self, tetrahedra, points):
        total = 0
        for t in tetrahedra:
            a, b, c, d = (points[v] for v in t)
            u, v, w = ([q[k] - a[k] for k in range(3)] for q in (b, c, d))
            total += sum(u[k] * (v[k - 2] * w[k - 1] - v[k - 1] * w[k - 2]) for k in range(3)) / 6
        return total

    def rows(self, name):
        content = self.get(name)
        length = struct.unpack("<H", content[8:10])[0]
        numbers = struct.unpack(f"<{(len(content) - 10 - length) // 8}q", content[10 + length:])
        return [numbers[i:i + 4] for i in range(0, len(numbers), 4)]

    def test_skin_of_a_turned_block(self):
        self.turned()
        points = [tuple(map(float, line.split())) for line in self.get("turned.xyz").decode().splitlines()]
        self.mgdt("triangulate", "-q", "turned.xyz", "-o", "all.npy")
        said = self.mgdt("triangulate", "turned.xyz", "-o", "t.npy", "--neighbors", "n.npy", "--drop-flat", "1e-9").decode()
        everything, kept, beside = self.rows("all.npy"), self.rows("t.npy"), self.rows("n.npy")
        dropped = len(everything) - len(kept)
        self.assertGreater(dropped, 10)
        self.assertIn(f"{dropped} flat tetrahedra taken off the hull", said)
        self.assertIn(f"{len(kept)} tetrahedra", said)
        self.assertAlmostEqual(self.volume(kept, points), 216, delta=1e-9)
        # What is flat is inside.
        for t, row in zip(kept, beside):
            self.assertTrue(min(row) >= 0 or self.volume([t], points) > 0.1)
        # Neighbours share three vertices, and each other.
        self.assertEqual(len(beside), len(kept))
        for t, row in enumerate(beside):
            for k, n in enumerate(row):
                if n >= 0:
                    self.assertEqual(set(kept[t]) - {kept[t][k]}, set(kept[t]) & set(kept[n]))
                    self.assertIn(t, beside[n])
        said = self.mgdt("triangulate", "turned.xyz", "--stats", "--drop-flat", "1e-9").decode()
        self.assertIn(f"{dropped} flat", said)

    def test_nothing_is_flat(self):
        self.generate("uniform", 100)
        for ratio in ("0", "1e-12"):
            self.mgdt("triangulate", "-q", "p.f64", "-o", "a.vtu", "--drop-flat", ratio)
            self.mgdt("triangulate", "-q", "p.f64", "-o", "b.vtu")
            self.assertEqual(self.get("a.vtu"), self.get("b.vtu"))

    def test_refused(self):
        four = self.put("p.xyz", TETRAHEDRON)
        for ratio in ("-1", "2", "x", "nan"):
            self.fails(2, "triangulate", four, "-o", "t.vtu", f"--drop-flat={ratio}", says="--drop-flat")
        self.fails(2, "triangulate", four, "-o", "t.pvtu", "--parts", 2, "--drop-flat", 1e-9, says="--drop-flat")


class Relaxation(Dual):
    def spread(self, name, box):
        """The mean square of the distance of places of a grid to the nearest point."""
        n = 12
        own, sum_ = self.points(name), 0
        for i in range(n ** 3):
            p = [box[k] + (box[3 + k] - box[k]) * (i // n ** k % n + 0.5) / n for k in range(3)]
            sum_ += min(sum((p[k] - q[k]) ** 2 for k in range(3)) for q in own)
        return sum_ / n ** 3

    def test_points_become_even(self):
        self.generate("cluster", 60)
        box = (0, 0, 0, 1, 1, 1)
        before = self.spread("p.f64", box)
        said = self.mgdt("relax", "p.f64", "-o", "r.f64", "--steps", 40, "--bounds", "0,0,0,1,1,1").decode()
        self.assertRegex(said, r"^60 points, 40 steps, moved by at most \S+ in the last: r.f64$")
        self.assertLess(self.spread("r.f64", box), 0.5 * before)
        for p in self.points("r.f64"):
            self.assertTrue(all(0 < x < 1 for x in p))

    def test_a_step_goes_to_the_centroid(self):
        self.generate("uniform", 100)
        rows = list(csv.DictReader(self.mgdt("voronoi", "p.f64", "--csv", "-", BOX_OPTION).decode().splitlines()))
        self.mgdt("relax", "-q", "p.f64", "-o", "r.f64", "--steps", 1, BOX_OPTION)
        for row, p in zip(rows, self.points("r.f64")):
            for k, c in enumerate("xyz"):
                self.assertLess(abs(float(row["centroid_" + c]) - p[k]), 1e-12)

    def test_repeats_come_apart(self):
        self.put("r.xyz", TETRAHEDRON + "0 0 0\n0 0 0\n")
        self.mgdt("relax", "-q", "r.xyz", "-o", "s.f64", "--steps", 10)
        self.assertEqual(len(set(self.points("s.f64"))), 6)

    def test_same_bits(self):
        self.generate("uniform", 400)
        for name, options in (("a.f64", ()), ("b.f64", ("--threads", 3, "--scheme", "random"))):
            self.mgdt("relax", "-q", "p.f64", "-o", name, "--steps", 5, *options)
        self.assertEqual(self.get("a.f64"), self.get("b.f64"))

    def test_numbers_of_tetgen_files(self):
        self.put("n.node", "4 3 0 0\n" + "".join(f"{i + 1} {line}\n" for i, line in enumerate(TETRAHEDRON.splitlines())))
        self.mgdt("relax", "-q", "n.node", "-o", "m.node", "--steps", 1)
        self.assertEqual([line.split()[0] for line in self.get("m.node").decode().splitlines()[1:5]], list("1234"))

    def test_no_steps(self):
        self.generate("uniform", 50)
        self.mgdt("relax", "-q", "p.f64", "-o", "r.f64", "--steps", 0)
        self.assertEqual(self.get("p.f64"), self.get("r.f64"))
        self.mgdt("relax", "-q", "-", "--from", "xyz", "--allow-empty", "-o", "e.f64", "--steps", 3, data=b"")
        self.assertEqual(self.get("e.f64"), b"")

    def test_refused(self):
        four = self.put("p.xyz", TETRAHEDRON)
        flat = self.put("flat.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n")
        self.fails(2, "relax", four, "-o", "r.xyz", says="--steps")
        self.fails(2, "relax", four, "-o", "r.xyz", "--steps", -1, says="--steps")
        self.fails(2, "relax", four, "-o", "r.vtu", "--steps", 1, says="points alone")
        self.fails(3, "relax", flat, "-o", "r.xyz", "--steps", 1, says="on a plane")
        self.fails(3, "relax", four, "-o", "r.xyz", "--steps", 1, "--bounds", "0,0,0,1,1,0.5", says="point 3")
        self.refuses("relax", "p.xyz", "-o", "p.xyz", "--steps", 1, says="would overwrite")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    cli_test.MGDT = os.path.abspath(sys.argv.pop(1))
    unittest.main()
