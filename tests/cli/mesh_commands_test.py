#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""mgdt mesh and mgdt validate: every format that has facets, what they write, and what they refuse.

Usage: mesh_commands_test.py MGDT [unittest arguments]
"""

import os
import struct
import sys
import unittest

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
