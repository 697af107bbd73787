#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""mgdt mesh and mgdt validate: every format that has facets, what they write, and what they refuse.

Usage: mesh_commands_test.py MGDT [unittest arguments]
"""

import math
import os
import struct
import sys
import unittest

import meshio
import numpy as np

sys.dont_write_bytecode = True  # the source tree stays as it is
import cli_test
from cli_test import CliTest

CUBE = [(x, y, z) for z in (0, 2) for y in (0, 2) for x in (0, 2)]
SQUARES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
TRIANGLES = [(a, b, c) for s in SQUARES for a, b, c in (s[:3], (s[0], s[2], s[3]))]


def off(points, facets):
    return f"OFF\n{len(points)} {len(facets)} 0\n" + "".join(
        " ".join(map(str, row)) + "\n" for row in [*points, *((len(f), *f) for f in facets)])


def obj(points, facets, corner=lambda v: str(v + 1)):
    return "".join(f"v {x} {y} {z}\n" for x, y, z in points) + "".join(
        "f " + " ".join(map(corner, f)) + "\n" for f in facets)


def stl_text(points, triangles):
    rows = ["solid cube"]
    for t in triangles:
        rows += ["facet normal 0 0 0", "outer loop", *("vertex {} {} {}".format(*points[v]) for v in t), "endloop",
                 "endfacet"]
    return "\n".join([*rows, "endsolid cube", ""])


def stl_binary(points, triangles):
    return b" " * 80 + struct.pack("<I", len(triangles)) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *(x for v in t for x in points[v]), 0) for t in triangles)


def ply_head(form, points, facets):
    return (f"ply\nformat {form} 1.0\nelement vertex {len(points)}\nproperty float x\nproperty float y\n"
            f"property float z\nelement face {len(facets)}\nproperty uchar flag\n"
            "property list uchar int vertex_indices\nend_header\n")


def ply_text(points, facets):
    return ply_head("ascii", points, facets) + "".join("{} {} {}\n".format(*p) for p in points) + "".join(
        f"7 {len(f)} {' '.join(map(str, f))}\n" for f in facets)


def ply_binary(points, facets):
    return ply_head("binary_big_endian", points, facets).encode() + b"".join(
        struct.pack(">3f", *p) for p in points) + b"".join(
        struct.pack(f">BB{len(f)}i", 7, len(f), *f) for f in facets)


def smesh(points, facets):
    return f"{len(points)} 3 0 0\n" + "".join(f"{i + 1} {x} {y} {z}\n" for i, (x, y, z) in enumerate(points)) + \
        f"{len(facets)} 1\n" + "".join(f"{len(f)} {' '.join(str(v + 1) for v in f)} {i}\n"
                                       for i, f in enumerate(facets)) + "0\n0\n"


def gmsh2(points, facets):
    types = {2: 1, 3: 2, 4: 3}
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + f"{len(points)}\n" + "".join(
        "{} {} {} {}\n".format(10 * i + 5, *p) for i, p in enumerate(points)) + \
        f"$EndNodes\n$Elements\n{len(facets)}\n" + "".join(
            f"{i + 1} {types[len(f)]} 2 {7 + i} 1 {' '.join(str(10 * v + 5) for v in f)}\n"
            for i, f in enumerate(facets)) + "$EndElements\n"


def gmsh4(points, facets):
    rows = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$Entities", "1 0 1 0", "1 0 0 0 0",
            "1 0 0 0 2 2 2 1 42 0", "$EndEntities", "$Nodes", f"1 {len(points)} 1 {len(points)}",
            f"2 1 0 {len(points)}", *(str(i + 1) for i in range(len(points))),
            *("{} {} {}".format(*p) for p in points), "$EndNodes", "$Elements",
            f"1 {len(facets)} 1 {len(facets)}", f"2 1 3 {len(facets)}",
            *(f"{i + 1} {' '.join(str(v + 1) for v in f)}" for i, f in enumerate(facets)), "$EndElements", ""]
    return "\n".join(rows)


def vtk(points, facets, data):
    size = sum(len(f) + 1 for f in facets)
    cells = "".join(f"{len(f)} {' '.join(map(str, f))}\n" for f in facets)
    head = f"# vtk DataFile Version 3.0\nx\nASCII\nDATASET {data}\nPOINTS {len(points)} float\n" + "".join(
        "{} {} {}\n".format(*p) for p in points)
    if data == "POLYDATA":
        return head + f"POLYGONS {len(facets)} {size}\n" + cells
    return head + f"CELLS {len(facets)} {size}\n" + cells + f"CELL_TYPES {len(facets)}\n" + "9\n" * len(facets)


def vtk_xml(points, facets, surface):
    corners = " ".join(str(v) for f in facets for v in f)
    ends = " ".join(str(4 * (i + 1)) for i in range(len(facets)))
    types = "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">" + "9 " * len(facets) + "</DataArray>"
    kind, section, count = ("PolyData", "Polys", "NumberOfPolys") if surface else \
        ("UnstructuredGrid", "Cells", "NumberOfCells")
    return (f'<VTKFile type="{kind}"><{kind}><Piece NumberOfPoints="{len(points)}" {count}="{len(facets)}">'
            '<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">'
            + " ".join(str(x) for p in points for x in p) +
            f'</DataArray></Points><{section}><DataArray type="Int64" Name="connectivity" format="ascii">{corners}'
            f'</DataArray><DataArray type="Int64" Name="offsets" format="ascii">{ends}</DataArray>'
            + ("" if surface else types) + f"</{section}></Piece></{kind}></VTKFile>")


def abaqus(points, facets):
    return "*HEADING\nx\n*NODE\n" + "".join("{}, {}, {}, {}\n".format(i + 1, *p) for i, p in enumerate(points)) + \
        "*ELEMENT, TYPE=S4R, ELSET=SKIN\n" + "".join(
            f"{i + 1}, {', '.join(str(v + 1) for v in f)}\n" for i, f in enumerate(facets))


# A box with a square tunnel: the ends are facets of two polygons with a hole. One region.
TWO = """# two boxes with a wall between them
12 3 0 0
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 0 0 1
6 1 0 1
7 1 1 1
8 0 1 1
9 2 0 0
10 2 1 0
11 2 1 1
12 2 0 1
11 1
1 0 1
4 1 2 3 4
1 0 1
4 5 6 7 8
1 0 1
4 1 2 6 5
1 0 1
4 4 3 7 8
1 0 2
4 1 4 8 5
1 0 3
4 2 3 7 6
1 0 1
4 2 9 10 3
1 0 1
4 6 12 11 7
1 0 1
4 2 9 12 6
1 0 -5
4 3 10 11 7
1 0 4
4 9 10 11 12
0
2
1 0.5 0.5 0.5 10 0.1
2 1.5 0.5 0.5 -20
"""

POLY = """# a comment
16 3 0 0
0 0 0 0
1 3 0 0
2 3 3 0
3 0 3 0
4 1 1 0
5 2 1 0
6 2 2 0
7 1 2 0
8 0 0 3
9 3 0 3
10 3 3 3
11 0 3 3
12 1 1 3
13 2 1 3
14 2 2 3
15 1 2 3
10 1
2 1 5
4 0 1 2 3
4 4 5 6 7
1 1.5 1.5 0
2 1 6
4 8 9 10 11
4 12 13 14 15
1 1.5 1.5 3
1 0 1
4 0 1 9 8
1 0 1
4 1 2 10
   9
1 0 1
4 2 3 11 10
1 0 1
4 3 0 8 11
1 0 2
4 4 5 13 12
1 0 2
4 5 6 14 13
1 0 2
4 6 7 15 14
1 0 2
4 7 4 12 15
0
1
0 0.5 0.5 1.5 42 -1
"""


class Meshes(CliTest):
    def volume(self, name):
        """The volume of an .ele file's tetrahedra."""
        points = [tuple(map(float, row.split()[1:4])) for row in
                  self.get(name + ".node").decode().splitlines()[1:]]
        total = 0
        for row in self.get(name + ".ele").decode().splitlines()[1:]:
            a, b, c, d = (points[int(v)] for v in row.split()[1:5])
            u, v, w = ([q[k] - a[k] for k in range(3)] for q in (b, c, d))
            part = (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
                    u[2] * (v[0] * w[1] - v[1] * w[0]))
            self.assertGreater(part, 0)
            total += part
        return total / 6

    def test_every_format(self):
        inputs = {"s.off": off(CUBE, SQUARES), "t.off": off(CUBE, TRIANGLES), "s.obj": obj(CUBE, SQUARES),
                  "slashes.obj": obj(CUBE, SQUARES, lambda v: f"{v + 1}/1/2"),
                  "backwards.obj": obj(CUBE, SQUARES, lambda v: str(v - 8)),
                  "text.stl": stl_text(CUBE, TRIANGLES), "binary.stl": stl_binary(CUBE, TRIANGLES),
                  "text.ply": ply_text(CUBE, SQUARES), "binary.ply": ply_binary(CUBE, SQUARES),
                  "s.smesh": smesh(CUBE, SQUARES), "two.msh": gmsh2(CUBE, SQUARES), "four.msh": gmsh4(CUBE, SQUARES),
                  "poly.vtk": vtk(CUBE, SQUARES, "POLYDATA"), "grid.vtk": vtk(CUBE, SQUARES, "UNSTRUCTURED_GRID"),
                  "s.vtu": vtk_xml(CUBE, SQUARES, False), "s.vtp": vtk_xml(CUBE, SQUARES, True),
                  "s.inp": abaqus(CUBE, SQUARES)}
        for name, content in inputs.items():
            with self.subTest(name=name):
                self.put(name, content)
                said = self.mgdt("mesh", name, "-o", "m.ele", "--check", "--index-base", 0).decode()
                self.assertRegex(said, r"^(6|12) facets, 8 points, 0 added, 1 region, 6 tetrahedra, checked: m.ele\n$")
                self.assertEqual(self.volume("m"), 8)
                said = self.mgdt("validate", name).decode()
                self.assertRegex(said, r"(6|12) facets and 8 points meet in common corners and edges only\n$")
                # Other commands read the points.
                self.assertIn("8 points", self.mgdt("triangulate", name, "-o", "t.vtu").decode())

    def test_markers_and_segments(self):
        # Triangles of different groups keep their edges; so do lines.
        self.put("g.msh", gmsh2(CUBE, TRIANGLES + [(0, 7)]))
        said = self.mgdt("mesh", "g.msh", "-o", "g.ele", "--check").decode()
        self.assertIn("12 facets, 8 points, ", said)
        self.put("same.msh", gmsh4(CUBE, SQUARES))
        self.assertIn("6 facets, 8 points, 0 added", self.mgdt("mesh", "same.msh", "-o", "g.ele", "--check").decode())

    def test_obj_lines_that_go_on(self):
        text = obj(CUBE, SQUARES).replace("f 1 3 4 2", "f 1 3 \\\n 4 \\\r\n2").replace("v 0 0 2", "v 0\\\n0 2")
        self.put("c.obj", text)
        self.mgdt("mesh", "c.obj", "-o", "m.ele", "--strict")
        self.assertAlmostEqual(self.volume("m"), 8, delta=1e-12)
        self.put("end.obj", obj(CUBE, SQUARES) + "f 1 2 3\\")
        self.mgdt("validate", "end.obj", code=1)

    def test_own_surfaces(self):
        self.mgdt("generate", "-q", "sphere", 200, "-o", "p.xyz")
        for name in ("h.ply", "h.stl", "h.off", "h.obj", "h.vtp"):
            self.mgdt("hull", "-q", "p.xyz", "-o", name)
            self.assertIn("396 facets, 200 points", self.mgdt("mesh", name, "-o", "m.vtu", "--check").decode())
        self.mgdt("hull", "-q", "p.xyz", "-o", "h.vtp", "--compress")
        self.mgdt("mesh", "h.vtp", "-o", "m.vtu")

    def test_poly(self):
        self.put("tunnel.poly", POLY)
        said = self.mgdt("mesh", "tunnel.poly", "-o", "m.ele", "--check").decode()
        self.assertIn("10 facets, 16 points, ", said)
        self.assertAlmostEqual(self.volume("m"), 24, delta=1e-12)
        # The points may be in a .node file.
        head, rest = POLY.split("10 1\n", 1)
        self.put("other.node", head)
        self.put("other.poly", "0 3 0 0\n10 1\n" + rest)
        self.mgdt("mesh", "other.poly", "-o", "n.ele")
        self.assertEqual(self.get("n.ele"), self.get("m.ele"))
        self.mgdt("mesh", "tunnel.poly", "-o", "m.vtu")
        self.assertIn(b'Name="region"', self.get("m.vtu"))

    def test_markers_in_every_format(self):
        """Two boxes side by side: regions 10 and -20, facets 1 to 4 and -5."""
        self.put("two.poly", TWO)
        faces, regions = None, None
        for options in (["m.vtu"], ["m.vtk"], ["m4.msh"], ["m2.msh", "--to", "gmsh2"], ["m.mesh"]):
            self.mgdt("mesh", "-q", "two.poly", "-o", *options)
            mesh = meshio.read(self.path(options[0]))
            name = {"vtu": ("region", "facet"), "vtk": ("region", "facet"), "mesh": ("medit:ref",) * 2}.get(
                options[0].split(".")[1], ("gmsh:physical",) * 2)
            found = [{}, {}]
            for k, cells in enumerate(mesh.cells):
                kind = {"tetra": 0, "triangle": 1}[cells.type]
                for cell, marker in zip(cells.data, np.ravel(mesh.cell_data[name[kind]][k])):
                    place = tuple(sorted(map(tuple, mesh.points[cell].tolist())))
                    found[kind][place] = int(marker)
            self.assertEqual(len(found[0]), sum(len(c.data) for c in mesh.cells if c.type == "tetra"))
            if faces is None:
                regions, faces = found
                self.assertEqual((set(regions.values()), set(faces.values())), ({10, -20}, {1, 2, 3, 4, -5}))
            if "gmsh" in name[0]:
                # Gmsh's groups are positive; the names of others have the marker.
                self.assertEqual({k: tuple(v) for k, v in mesh.field_data.items()},
                                 {"region -20": (11, 3), "facets -5": (5, 2)})
                found[0] = {k: -20 if m == 11 else m for k, m in found[0].items()}
                found[1] = {k: -5 if m == 5 else m for k, m in found[1].items()}
            self.assertEqual(found[0], regions, options)
            self.assertEqual(found[1], faces, options)
        # TetGen's files keep the base of the input.
        self.mgdt("mesh", "-q", "two.poly", "-o", "m.ele")
        nodes, tets, triangles = (
            [line.split() for line in self.get(f"m.{end}").decode().splitlines()] for end in ("node", "ele", "face"))
        self.assertEqual((nodes[1][0], tets[0][1:], tets[1][0], triangles[0][1]), ("1", ["4", "1"], "1", "1"))
        place = {row[0]: tuple(map(float, row[1:4])) for row in nodes[1:]}
        found = {tuple(sorted(place[v] for v in row[1:5])): int(row[5]) for row in tets[1:]}
        self.assertEqual(found, regions)
        self.assertEqual(len(triangles) - 1, len(faces))
        self.assertEqual({int(row[4]) for row in triangles[1:]}, {1, 2, 3, 4, -5})
        self.mgdt("mesh", "-q", "two.poly", "-o", "z.ele", "--index-base", 0)
        self.assertEqual(self.get("z.node").decode().splitlines()[1].split()[0], "0")
        # Abaqus's sets and surfaces.
        self.mgdt("mesh", "-q", "two.poly", "-o", "m.inp")
        text = self.get("m.inp").decode()
        for label in ("*ELSET, ELSET=REGION_10\n", "*ELSET, ELSET=REGION_M20\n", "NAME=FACETS_1\n", "NAME=FACETS_M5\n"):
            self.assertIn(label, text)
        cells, points, surfaces = {}, {}, {}
        for part in text.split("*")[1:]:
            head, *rows = part.splitlines()
            rows = [row.split(", ") for row in rows]
            if head == "NODE":
                points = {row[0]: tuple(map(float, row[1:])) for row in rows}
            elif head.startswith("ELEMENT"):
                cells = {row[0]: row[1:] for row in rows}
            elif head.startswith("SURFACE"):
                surfaces[head.split("=")[-1]] = rows
        sides = {"S1": (0, 1, 2), "S2": (0, 3, 1), "S3": (1, 3, 2), "S4": (2, 3, 0)}
        for label, marker in (("FACETS_1", 1), ("FACETS_2", 2), ("FACETS_3", 3), ("FACETS_4", 4), ("FACETS_M5", -5)):
            found = {tuple(sorted(points[cells[e][k]] for k in sides[s])) for e, s in surfaces[label]}
            expected = {place for place, m in faces.items() if m == marker}
            self.assertEqual(found, expected, label)

    def test_names_of_groups(self):
        head = '$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n2 7 "inlet"\n2 8 "the wall"\n3 9 "body"\n' \
               "$EndPhysicalNames\n"
        rows = "".join(f"{i + 1} {x} {y} {z}\n" for i, (x, y, z) in enumerate(CUBE))
        squares = "".join(f"{k + 1} 3 2 {7 if k == 0 else 8} {k + 1} {' '.join(str(v + 1) for v in s)}\n"
                          for k, s in enumerate(SQUARES))
        self.put("groups.msh", f"{head}$Nodes\n8\n{rows}$EndNodes\n$Elements\n6\n{squares}$EndElements\n")
        for options in (["g4.msh"], ["g2.msh", "--to", "gmsh2"]):
            self.mgdt("mesh", "-q", "groups.msh", "-o", *options)
            mesh = meshio.read(self.path(options[0]))
            self.assertEqual({k: tuple(v) for k, v in mesh.field_data.items()}, {"inlet": (7, 2), "the wall": (8, 2), "region 0": (1, 3)})
        self.mgdt("mesh", "-q", "groups.msh", "-o", "g.inp")
        self.assertIn(b"NAME=inlet\n", self.get("g.inp"))
        self.assertIn(b"NAME=FACETS_8\n", self.get("g.inp"))
        # Binary files have the names as text, too.
        self.mgdt("mesh", "-q", "g4.msh", "-o", "again.msh")
        self.assertIn(b'2 7 "inlet"', self.get("again.msh"))
        self.put("bad.msh", head.replace('"inlet"', "inlet"))
        self.mgdt("mesh", "-q", "bad.msh", "-o", "b.vtu", code=3)

    def test_check_of_constrained_meshes(self):
        """A box with a notch is not convex."""
        points = [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (3, 0), (3, 2), (2, 1), (1, 2), (0, 2))]
        sides = [tuple(range(6)), tuple(range(6, 12)), *((i, (i + 1) % 6, 6 + (i + 1) % 6, 6 + i) for i in range(6))]
        self.put("notch.off", off(points, sides))
        for name in ("n.vtu", "n.msh", "n.vtk"):
            self.mgdt("mesh", "-q", "notch.off", "-o", name)
            self.assertIn("does not cross itself", self.mgdt("check", name).decode())
        self.mgdt("mesh", "-q", "notch.off", "-o", "n.ele")
        self.mgdt("check", "-q", "n.ele", code=1)
        said = self.mgdt("check", "n.ele", "--constrained").decode()
        self.assertIn("Delaunay     ok   all of", said)
        # A missing tetrahedron changes the boundary; one that comes twice, or is turned, is found.
        rows = self.get("n.ele").decode().splitlines()
        count = len(rows) - 1
        for name, bad in (("twice", [*rows[1:], rows[1]]), ("turned", [
                " ".join([*rows[1].split()[:3], rows[1].split()[4], rows[1].split()[3]]), *rows[2:]])):
            self.put(f"{name}.node", self.get("n.node").decode())
            self.put(f"{name}.ele", f"{len(bad)} 4 0\n" + "\n".join(bad) + "\n")
            self.mgdt("check", "-q", f"{name}.ele", "--constrained", code=1)
        self.assertGreater(count, 3)

    def test_facets_with_several_holes(self):
        """A slab with square holes, in each order: two of them are next to one corner."""
        holes = [(0.5, 3), (3, 0.5), (5, 5), (8, 2)]
        for order in (range(4), range(3, -1, -1), (1, 0, 3, 2)):
            squares = [(0, 0, 10)] + [(*holes[k], 0.2) for k in order]
            rows = [(x + s * dx, y + s * dy, z) for z in (0, 1) for x, y, s in squares
                    for dx, dy in ((0, 0), (1, 0), (1, 1), (0, 1))]
            facets = []
            for z in (0, 1):
                facets.append("5 4\n" + "".join(f"4 {' '.join(str(20 * z + 4 * k + i) for i in range(4))}\n"
                                                 for k in range(5)) +
                              "".join(f"{k} {x + s / 2} {y + s / 2} {z}\n" for k, (x, y, s) in enumerate(squares[1:])))
            for k in range(5):
                for i in range(4):
                    a, b = 4 * k + i, 4 * k + (i + 1) % 4
                    facets.append(f"1\n4 {a} {b} {20 + b} {20 + a}\n")
            self.put("slab.poly", f"{len(rows)} 3\n" + "".join("{} {} {} {}\n".format(i, *r) for i, r in enumerate(rows)) +
                     f"{len(facets)} 0\n" + "".join(facets) + "0\n")
            self.mgdt("mesh", "slab.poly", "-o", "m.ele", "--check", "--index-base", 0)
            self.assertAlmostEqual(self.volume("m"), 100 - 4 * 0.04, delta=1e-9)
        # Polygons that cross.
        self.put("bad.poly", "8 3\n0 0 0 0\n1 4 0 0\n2 4 4 0\n3 0 4 0\n4 1 1 0\n5 9 1 0\n6 9 2 0\n7 1 2 0\n1 0\n"
                 "2 1\n4 0 1 2 3\n4 4 5 6 7\n0 2 1.5 0\n0\n")
        self.mgdt("validate", "bad.poly", code=1)

    def test_holes_and_regions(self):
        inner = [tuple(0.5 + x / 2 for x in p) for p in CUBE]
        self.put("shell.off", off(CUBE + inner, SQUARES + [tuple(v + 8 for v in s) for s in SQUARES]))
        said = self.mgdt("mesh", "shell.off", "-o", "m.ele", "--check").decode()
        self.assertIn("2 regions", said)
        self.assertAlmostEqual(self.volume("m"), 8, delta=1e-12)
        said = self.mgdt("mesh", "shell.off", "-o", "m.ele", "--hole", "1,1,1", "--check").decode()
        self.assertIn("1 region,", said)
        self.assertAlmostEqual(self.volume("m"), 7, delta=1e-12)
        self.mgdt("mesh", "shell.off", "-o", "m.vtu", "--region=0.25,0.25,0.25,-5", "--region", "1,1,1,7")
        from_array = self.get("m.vtu")
        self.assertIn(struct.pack("<i", -5) * 8, from_array)
        self.assertIn(struct.pack("<i", 7) * 5, from_array)

    def test_kept_surface(self):
        # A prism whose sides bend inwards (Schoenhardt's polyhedron) needs a point inside.
        points = [(math.cos(t + z / 2), math.sin(t + z / 2), -2 * z)
                  for z in (0, -1) for t in (0, 2 * math.pi / 3, 4 * math.pi / 3)]
        facets = [(0, 2, 1), (3, 4, 5)]
        for i in range(3):
            k = (i + 1) % 3
            facets += [(i, k, 3 + i), (k, 3 + k, 3 + i)]
        self.put("s.off", off(points, facets))
        self.mgdt("mesh", "s.off", "-o", "m.ele", "--keep-surface", "--check")
        self.assertEqual(self.get("m.node").split()[0], b"7")
        rows = self.get("m.face").split(b"\n")
        self.assertEqual(rows[0].split()[0], b"8")

    def test_cleaning(self):
        # Two cubes of triangles with a common wall, a point in an edge, and a facet that is given twice.
        points = CUBE + [(x + 2, y, z) for x, y, z in CUBE] + [(1, 0, 0)]
        facets = TRIANGLES + [tuple(v + 8 for v in t) for t in TRIANGLES] + [(0, 2, 3), (4, 4, 5)]
        facets[facets.index((0, 1, 5))] = (0, 16, 5)
        facets.append((16, 1, 5))
        self.put("two.off", off(points, facets))
        self.mgdt("mesh", "two.off", "-o", "m.ele", code=3)
        said = self.mgdt("validate", "two.off", "--repairable", code=1).decode()
        self.assertIn("--clean: 1 facet collapsed, 3 facets covered, 1 point in an edge; no pair is left, no edge is open\n", said)
        said = self.mgdt("mesh", "two.off", "-o", "m.ele", "--clean", "--check", "--keep-surface").decode()
        self.assertIn("cleaned: 1 facet collapsed, 3 facets covered, 1 point in an edge\n", said)
        self.assertIn("2 regions", said)
        self.assertAlmostEqual(self.volume("m"), 16, delta=1e-12)
        # Each triangle has points of its own, which differ by rounding.
        torn = [(x * (1 + 1e-12 * k), y, z) for k, t in enumerate(TRIANGLES) for x, y, z in (CUBE[v] for v in t)]
        self.put("torn.off", off(torn, [(3 * k, 3 * k + 1, 3 * k + 2) for k in range(len(TRIANGLES))]))
        lines = self.mgdt("validate", "torn.off", "--repairable", code=1).decode().splitlines()
        self.assertTrue(any(line.startswith("--weld 1e-09: 12 points welded") or line.startswith("--weld 1e-09: ")
                            and line.endswith("no pair is left, no edge is open") for line in lines), lines)
        self.mgdt("mesh", "torn.off", "-o", "m.ele", "--weld", 1e-9, "--flat", 1e-6, "--check")
        self.assertAlmostEqual(self.volume("m"), 8, delta=1e-9)
        self.mgdt("mesh", "torn.off", "-o", "m.ele", "--weld", 0.5, code=2)
        self.mgdt("mesh", "torn.off", "-o", "m.ele", "--flat", "nan", code=2)

    def test_what_is_left_out(self):
        inner = [tuple(0.5 + x / 2 for x in p) for p in CUBE]
        both = SQUARES + [tuple(v + 8 for v in s) for s in SQUARES]
        self.put("open.off", off(CUBE + inner, both[1:]))
        self.mgdt("mesh", "open.off", "-o", "m.ele", "--region", "9,9,9,7", "--hole", "5,5,5")
        for said in ("10 faces of the surface at no tetrahedron", "1 region outside of the mesh",
                     "1 hole in nothing that the facets enclose", "8 points in no tetrahedron"):
            self.assertIn("warning: " + said, self.err)
        self.assertAlmostEqual(self.volume("m"), 1, delta=1e-12)
        self.assertEqual(self.get("m.node").split()[0], b"8")
        self.mgdt("mesh", "-q", "open.off", "-o", "m.ele", "--all-points")
        self.assertEqual(self.err, "")
        self.assertEqual(self.get("m.node").split()[0], b"16")
        self.fails(3, "mesh", "open.off", "-o", "n.ele", "--strict", says="facet 0 bounds nothing")
        self.put("whole.off", off(CUBE + inner, both))
        self.mgdt("mesh", "whole.off", "-o", "n.ele", "--strict", "--hole", "1,1,1")
        self.fails(3, "mesh", "whole.off", "-o", "n.ele", "--strict", "--hole", "5,5,5",
                   says="hole 0 is in nothing that the facets enclose")

    def test_deterministic(self):
        self.put("t.off", off(CUBE, TRIANGLES))
        self.put("u.off", off(CUBE, TRIANGLES[::-1]))
        self.mgdt("mesh", "t.off", "-o", "t.ele", "--threads", 2)
        self.mgdt("mesh", "u.off", "-o", "u.ele", "--rounded")
        self.assertEqual(self.get("t.ele"), self.get("u.ele"))

    def test_what_offends(self):
        piercing = CUBE + [(1, 1, 1), (1, 1.5, 3), (1.2, 1, 1)]
        self.put("bad.off", off(piercing, SQUARES + [(8, 9, 10), (0, 1, 1)]))
        said = self.mgdt("validate", "bad.off", "-o", "pairs.vtp", code=1).decode()
        self.assertEqual(said, "facet 1 meets facet 6\nfacet 7 is flat or no polygon\n")
        self.assertIn("2 pairs of facets, segments or points", self.err)
        content = self.get("pairs.vtp")
        self.assertIn(b'NumberOfPolys="3"', content)
        self.fails(3, "mesh", "bad.off", "-o", "m.vtu", says="facet 1 and facet 6 meet")
        self.assertFalse(os.path.exists(self.path("m.vtu")))
        self.put("open.off", off(CUBE, SQUARES[1:]))
        self.fails(3, "mesh", "open.off", "-o", "m.vtu",
                   says="open.off: the facets enclose nothing: facet 1 alone has the edge from point 0 to point 1")
        self.assertIn("4 edges belong to one facet alone, the first from point 0 to point 1 to facet 1\n",
                      self.mgdt("validate", "open.off").decode())
        self.put("hole.off", off(CUBE, SQUARES))
        self.fails(3, "mesh", "hole.off", "-o", "m.vtu", "--hole", "0.5,0.5,0.5",
                   says="all that the facets enclose are holes")

    def test_bad_input(self):
        self.put("p.xyz", "0 0 0\n1 1 1\n")
        self.fails(2, "mesh", "p.xyz", "-o", "m.vtu", says="facets are not read from xyz files")
        self.put("none.off", "OFF\n1 0 0\n0 0 0\n")
        self.fails(3, "mesh", "none.off", "-o", "m.vtu", says="there are no facets")
        self.put("c.off", off(CUBE, [(0, 1, 8)]))
        self.fails(3, "validate", "c.off", says="corner")
        self.put("c.obj", obj(CUBE, [(0, 1, 8)]))
        self.fails(3, "validate", "c.obj", says="there are 8 vertices")
        self.put("two.obj", obj(CUBE, [(0, 1)]))
        self.fails(3, "validate", "two.obj", says="fewer than three corners")
        self.put("zero.obj", obj(CUBE, [(0, 1, 2)], lambda v: "0"))
        self.fails(3, "validate", "zero.obj", says="no vertex of a face")
        self.put("empty.stl", "")
        self.fails(3, "mesh", "empty.stl", "-o", "m.vtu", says="empty.stl: is empty, as after a program")
        self.assertNotIn("--allow-empty", self.err)
        self.put("many.off", "OFF\n3 1000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        self.fails(3, "validate", "many.off", says="faces announced")
        self.put("c.ply", ply_text(CUBE, [(0, 1, 99)]))
        self.fails(3, "validate", "c.ply", says="the corner 99")
        self.put("cut.poly", POLY[:len(POLY) // 2])
        self.fails(3, "mesh", "cut.poly", "-o", "m.vtu", says="cut.poly")
        self.put("t.off", off(CUBE, SQUARES))
        self.fails(2, "mesh", "t.off", "-o", "m.vtu", "--hole", "1,2", says="--hole takes 3 numbers")
        self.fails(2, "mesh", "t.off", "-o", "m.vtu", "--region", "1,1,1,0.5", says="no 32-bit integer")
        self.fails(2, "mesh", "t.off", "-o", "m.stl", says="no place for tetrahedra")
        self.fails(2, "mesh", "t.off", "-o", "t.off", says="")
        self.fails(5, "mesh", "t.off", "-o", "m.vtu", "--memory-limit", "2000B", says="memory")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    cli_test.MGDT = os.path.abspath(sys.argv.pop(1))
    unittest.main()
