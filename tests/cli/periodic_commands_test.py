#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""mgdt triangulate and voronoi with --box, and the files that have boxes.

Usage: periodic_commands_test.py MGDT [unittest arguments]
"""

import csv
import os
import struct
import sys
import unittest

sys.dont_write_bytecode = True  # the source tree stays as it is
import cli_test
from cli_test import CliTest

VECTORS = ((4, 0, 0), (1.5, 3, 0), (-0.75, 0.5, 2.5))
BOX = "4 0 0 1.5 3 0 -0.75 0.5 2.5"
EXTENDED = '2\nLattice="2 0 0 0 2 0 0 0 2" Properties=species:S:1:pos:R:3{}\nFe 0 0 0\nFe 1 1 1\n'
DUMP = """ITEM: TIMESTEP
0
ITEM: NUMBER OF ATOMS
2
ITEM: BOX BOUNDS {}
ITEM: ATOMS id type {}
1 1 {}
2 1 {}
"""
DATA = """LAMMPS data file

2 atoms
1 atom types

-1 1 xlo xhi
-1 1 ylo yhi
-1 1 zlo zhi
{}
Masses

1 55.8

Atoms {}

1 1 {} 0 0 0
2 1 {} 1 1 1 # the last

Velocities

1 0 0 0
"""
POSCAR = "iron\n{}\n{}\n{}{}\n0 0 0\n{}\n"


class Periodic(CliTest):
    def rows(self, *options, **more):
        text = self.mgdt("voronoi", "-q", *options, "--csv", "-", **more).decode()
        return list(csv.DictReader(text.splitlines()))

    def column(self, name, *options, **more):
        return [float(row[name]) for row in self.rows(*options, **more)]

    def points(self, name):
        content = self.get(name)
        x = struct.unpack(f"<{len(content) // 8}d", content)
        return [list(x[i:i + 3]) for i in range(0, len(x), 3)]

    def tetrahedra(self, name):
        content = self.get(name)
        begin = 10 + struct.unpack("<H", content[8:10])[0]
        v = struct.unpack(f"<{(len(content) - begin) // 8}q", content[begin:])
        return [v[i:i + 4] for i in range(0, len(v), 4)]

    def nodes(self, points, images):
        """The places of all nodes, with those of the table of images."""
        places = list(points)
        for row in csv.DictReader(self.get(images).decode().splitlines()):
            self.assertEqual(int(row["node"]), len(places))
            k = [int(row[name]) for name in "ijk"]
            places.append([points[int(row["point"])][c] + sum(k[i] * VECTORS[i][c] for i in range(3))
                           for c in range(3)])
        return places

    def test_tetrahedra_fill_the_box(self):
        self.mgdt("generate", "-q", "uniform", 200, "-o", "p.f64")
        said = self.mgdt("triangulate", "p.f64", "--box", BOX, "-o", "t.npy", "--images", "i.csv", "--neighbors",
                         "n.npy", "--point-map", "m.npy", "--check", 3).decode()
        self.assertIn("the check passed", said)
        self.assertIn("200 points", said)
        nodes, tetrahedra = self.nodes(self.points("p.f64"), "i.csv"), self.tetrahedra("t.npy")
        volume = 0
        for t in tetrahedra:
            a, b, c, d = (nodes[k] for k in t)
            u, v, w = ([q[k] - a[k] for k in range(3)] for q in (b, c, d))
            six = (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
                   u[2] * (v[0] * w[1] - v[1] * w[0]))
            self.assertGreater(six, 0)
            volume += six / 6
        self.assertAlmostEqual(volume, 30, places=9)
        self.assertEqual({k for row in self.tetrahedra("n.npy") for k in row}, set(range(len(tetrahedra))))
        statistics = self.mgdt("triangulate", "p.f64", "--box", BOX.replace(" ", ","), "--stats").decode()
        self.assertRegex(statistics, rf"tetrahedra +{len(tetrahedra)}\n")
        self.assertRegex(statistics, rf"edges +{len(tetrahedra) + 200}\n")

    def test_meshes_have_the_images_as_nodes(self):
        self.mgdt("generate", "-q", "uniform", 50, "-o", "p.xyz")
        for name in ("t.vtu", "t.msh", "t.ele", "t.mesh"):
            self.mgdt("triangulate", "-q", "p.xyz", "--box", "1 1 1", "-o", name, "--images", "i.csv")
            images = len(self.get("i.csv").splitlines()) - 1
            information = self.mgdt("info", name).decode()
            self.assertRegex(information, rf"points +{50 + images}\n")
        # Repeats leave, unless they are wanted.
        self.put("twice.xyz", b"0 0 0\n0.5 0.5 0.5\n1 1 1\n")
        self.mgdt("triangulate", "-q", "twice.xyz", "--box", "1 1 1", "-o", "t.vtu", "--images", "i.csv",
                  "--index-base", 1)
        first = self.get("i.csv").decode().splitlines()[1].split(",")
        self.assertEqual(first[:2], ["3", "1"])
        self.mgdt("triangulate", "-q", "twice.xyz", "--box", "1 1 1", "-o", "u.vtu", "--all-points")
        self.assertNotEqual(self.get("t.vtu"), self.get("u.vtu"))

    def test_cells(self):
        self.mgdt("generate", "-q", "uniform", 300, "-o", "p.f64")
        self.assertAlmostEqual(sum(self.column("volume", "p.f64", "--box", BOX)), 30, places=10)
        said = self.mgdt("voronoi", "p.f64", "--box", "1 1 1", "-o", "c.vtu").decode()
        self.assertIn("300 points, 300 cells", said)
        # A slab has two cells without end.
        self.assertEqual(self.column("volume", "p.f64", "--box", "1 1 1", "--periodic", "xy").count(float("inf")), 2)
        few = self.mgdt("voronoi", "p.f64", "--box", "1 1 1", "--least-area", 0.01, "-o", "f.vtu").decode()
        self.assertNotEqual(few, said)

    def test_boxes_of_files(self):
        four = [4, 4]
        self.put("a.xyz", EXTENDED.format("").encode())
        self.put("b.xyz", EXTENDED.format(" pbc=\"T T T\" comment='a=b' energy=-1.5").encode())
        self.put("c.xyz", b"2\nProperties=id:I:1:species:S:1:pos:R:3 Lattice=\"2.0 0 0 0 2 0 0 0 2\"\n"
                          b"7 Fe 0 0 0\n9 Fe 1 1 1\n")
        straight = "pp pp pp\n-1 1\n-1 1\n-1 1"
        self.put("d.dump", DUMP.format(straight, "x y z", "0 0 0", "1 1 1").encode())
        self.put("e.lammpstrj", DUMP.format(straight, "xs ys zs vx", "0.5 0.5 0.5 8", "1 1 1 8").encode())
        self.put("f.dump", DUMP.format("xy xz yz pp pp pp\n0 2 0\n0 2 0\n0 2 0", "zu yu xu", "0 0 0",
                                       "1 1 1").encode())
        self.put("g.dump", DUMP.format("abc origin pp pp pp\n2 0 0 0\n0 2 0 0\n0 0 2 0", "xu yu zu", "0 0 0",
                                       "1 1 1").encode())
        self.put("h.lmp", DATA.format("", "# atomic", "", "").encode())
        self.put("i.data", DATA.format("0 0 0 xy xz yz", "# full", "1 0.5", "1 0.5").encode())
        self.put("j.lammps", DATA.format("", "", "", "").encode())
        cube = "1 0 0\n0 1 0\n0 0 1"
        self.put("POSCAR", POSCAR.format("2", cube, "Fe\n2\n", "Direct", "0.5 0.5 0.5").encode())
        self.put("k.vasp", POSCAR.format("-8.0", cube, "2\n", "Selective dynamics\ndirect",
                                         "0.5 0.5 0.5 T T T").encode())
        self.put("l.poscar", POSCAR.format("2 2 2", cube, "Fe Co\n1 1\n", "Cartesian", "0.5 0.5 0.5").encode())
        for name in ("a.xyz", "b.xyz", "c.xyz", "d.dump", "e.lammpstrj", "f.dump", "g.dump", "h.lmp", "i.data",
                     "j.lammps", "POSCAR", "k.vasp", "l.poscar"):
            with self.subTest(name):
                rows = self.rows(name, "--box", "file")
                self.assertEqual([round(float(row["volume"]), 9) for row in rows], four)
                self.assertEqual([row["faces"] for row in rows], ["14", "14"])
        # Tilted boxes: the bounds of a dump are those of the tilted box.
        self.put("t.dump", DUMP.format("xy xz yz pp pp pp\n-0.5 2.5 0.5\n0 2.25 -0.5\n0 2 0.25", "x y z", "0 0 0",
                                       "1 1 1").encode())
        self.put("t.xyz", b"2\nLattice=\"2 0 0 0.5 2 0 -0.5 0.25 2\"\nFe 0 0 0\nFe 1 1 1\n")
        self.assertEqual(self.column("area", "t.dump", "--box", "file"),
                         self.column("area", "t.xyz", "--box", "file"))
        # What does not repeat.
        self.put("s.xyz", EXTENDED.format(' pbc="T T F"').encode())
        self.put("s.dump", DUMP.format("pp pp ff\n0 2\n0 2\n0 2", "x y z", "0 0 0", "1 1 1").encode())
        for name in ("s.xyz", "s.dump"):
            self.assertEqual(self.column("volume", name, "--box", "file"), [float("inf")] * 2)
            self.assertIn("box            2 0 0\n               0 2 0\n               0 0 2, not periodic\n",
                          self.mgdt("info", name).decode())
            volumes = self.column("volume", name, "--box", "file", "--periodic", "xyz")
            self.assertEqual([round(volume, 9) for volume in volumes], four)

    def test_what_is_refused(self):
        self.put("p.xyz", b"0 0 0\n0.5 0.5 0.5\n")
        into = ("-o", "t.vtu")
        for box in ("1 1", "1 1 1 1", "1 1 x", "auto", "1 0 0 0 1 0 0 0 1 1"):
            self.fails(2, "triangulate", "p.xyz", "--box", box, *into, says="nine numbers")
        self.fails(3, "triangulate", "p.xyz", "--box", "1 1 0", *into, says=["p.xyz", "in a plane"])
        self.fails(3, "triangulate", "p.xyz", "--box", "file", *into, says=["p.xyz", "no box"])
        for letters in ("w", "xx", "xyzx"):
            self.fails(2, "triangulate", "p.xyz", "--box", "1 1 1", "--periodic", letters, *into, says="some of x, y and z")
        self.fails(2, "triangulate", "p.xyz", "--periodic", "x", *into, says="--box")
        self.fails(2, "triangulate", "p.xyz", "--images", "i.csv", *into, says="--images")
        self.fails(2, "triangulate", "p.xyz", "--box", "1 1 1", "--parts", 2, *into, says="--parts")
        self.fails(2, "triangulate", "p.xyz", "--box", "1 1 1", "--drop-flat", 0.1, *into, says="--drop-flat")
        self.fails(2, "triangulate", "p.xyz", "--box", "1 1 1", says="nothing to do")
        self.fails(2, "triangulate", "p.xyz", "--box", "1 1 1", *into, "--images", "t.vtu", says="the same file")
        self.fails(2, "voronoi", "p.xyz", "--box", "1 1 1", "--bounds", "auto", *into, says="--bounds")
        self.put("far.xyz", b"0 0 0\n1e30 0 0\n")
        self.fails(3, "triangulate", "far.xyz", "--box", "1 1 1", *into, says=["far.xyz", "point 1"])
        self.fails(3, "voronoi", "p.xyz", "--box", "1 1 1", "--periodic", "x", *into, says="do not span space")
        self.fails(5, "triangulate", "p.xyz", "--box", "1 1 1", "--memory-limit", 5000, *into, says="memory")
        straight = "pp pp pp\n0 2\n0 2\n0 2"
        for name, content, words in (
                ("l.xyz", EXTENDED.replace(" 0 0 0 2\"", " 0 0 2\"").format(""), ["no box"]),
                ("p.xyz", EXTENDED.format(" pbc=\"T T\""), ["no box"]),
                ("o.xyz", EXTENDED.replace("pos:R:3", "pos:R:2").format(""), ["line 2", "pos"]),
                ("n.xyz", EXTENDED.format(' pbc="F F F"'), ["no direction"]),
                ("two.dump", DUMP.format(straight, "x y z", "0 0 0", "1 1 1") * 2, ["more than one frame"]),
                ("few.dump", DUMP.format(straight, "x y z", "0 0 0", "1 1"), ["line 11"]),
                ("none.dump", DUMP.format(straight, "vx vy vz", "0 0 0", "1 1 1"), ["columns x y z"]),
                ("cut.dump", "ITEM: NUMBER OF ATOMS\n9\nITEM: ATOMS x y z\n0 0 0\n", ["9 atoms"]),
                ("no.dump", "ITEM: TIMESTEP\n0\n", ["no ITEM: ATOMS"]),
                ("style.lmp", DATA.format("", "# wavepacket", "", ""), ["style", "--columns"]),
                ("cut.lmp", DATA.replace("2 atoms", "99 atoms").format("", "# atomic", "", ""), ["99 atoms"]),
                ("none.lmp", "title\n\n2 atoms\n", ["no section Atoms"]),
                ("cut.poscar", "iron\n1\n1 0 0\n0 1 0\n", ["a vector"]),
                ("count.poscar", POSCAR.format("1", "1 0 0\n0 1 0\n0 0 1", "Fe\nCo\n", "Direct", "0 0 1"),
                 ["numbers of atoms"]),
                ("flat.poscar", POSCAR.format("-1", "1 0 0\n0 1 0\n1 1 0", "Fe\n2\n", "Direct", "0 0 1"),
                 ["volume"])):
            with self.subTest(name):
                self.put(name, content.encode())
                self.fails(3, "triangulate", name, "--box", "file", *into, says=[name, *words])


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    cli_test.MGDT = os.path.abspath(sys.argv.pop(1))
    unittest.main()
