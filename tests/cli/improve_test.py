#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""mgdt improve, mgdt mesh --improve, and what mgdt info says of shapes.

Usage: improve_test.py MGDT [unittest arguments]
"""

import itertools
import os
import random
import struct
import sys
import unittest

sys.dont_write_bytecode = True  # the source tree stays as it is
import cli_test
from cli_test import CliTest

N = 4


def lattice():
    """The points of cubes, of which those inside are moved, and six tetrahedra for each cube."""
    draw = random.Random(1)
    points, tetrahedra = [], []
    steps = (1, N + 1, (N + 1) ** 2)
    for z, y, x in itertools.product(range(N + 1), repeat=3):
        # The points between the two materials stay in their plane.
        inner = [0 < x < N, 0 < y < N, 0 < z < N and 2 * z != N]
        points.append([c + (draw.uniform(-0.2, 0.2) if moves else 0) for c, moves in zip((x, y, z), inner)])
        if N in (x, y, z):
            continue
        for order in itertools.permutations(steps):
            v = [len(points) - 1]
            for step in order:
                v.append(v[-1] + step)
            tetrahedra.append(v)
    return points, tetrahedra


POINTS, TETRAHEDRA = lattice()
# The lower half and the upper one, and two triangles of the bottom.
MARKERS = [3 if k < len(TETRAHEDRA) // 2 else -8 for k in range(len(TETRAHEDRA))]
TRIANGLES = [[0, 1, N + 2], [0, N + 1, N + 2]]


def medit():
    rows = ["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(POINTS))]
    rows += ["{!r} {!r} {!r} 0".format(*p) for p in POINTS]
    rows += ["Triangles", "2"] + [" ".join(str(v + 1) for v in t) + " 77" for t in TRIANGLES]
    rows += ["Edges", "1", "1 2 5"]
    rows += ["Tetrahedra", str(len(TETRAHEDRA))]
    rows += [" ".join(str(v + 1) for v in t) + f" {m}" for t, m in zip(TETRAHEDRA, MARKERS)]
    return "\n".join(rows + ["End", ""])


def meshb():
    def section(keyword, body, count):
        return keyword, struct.pack("<i", count) + body
    sections = [(3, struct.pack("<i", 3)),
                section(4, b"".join(struct.pack("<3di", *p, 0) for p in POINTS), len(POINTS)),
                section(6, b"".join(struct.pack("<4i", *(v + 1 for v in t), 77) for t in TRIANGLES), 2),
                section(8, b"".join(struct.pack("<5i", *(v + 1 for v in t), m) for t, m in zip(TETRAHEDRA, MARKERS)),
                        len(TETRAHEDRA))]
    out = struct.pack("<2i", 1, 2)
    for keyword, body in sections:
        out += struct.pack("<2i", keyword, len(out) + 8 + len(body)) + body
    return out + struct.pack("<2i", 54, 0)


def gmsh2():
    rows = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "1", '2 77 "floor"', "$EndPhysicalNames",
            "$Nodes", str(len(POINTS))]
    rows += [f"{i + 1} " + " ".join(map(repr, p)) for i, p in enumerate(POINTS)]
    cells = [(2, 77, t) for t in TRIANGLES] + [(4, m, t) for t, m in zip(TETRAHEDRA, MARKERS)]
    rows += ["$EndNodes", "$Elements", str(len(cells))]
    rows += [f"{i + 1} {kind} 2 {m} 1 " + " ".join(str(v + 1) for v in t) for i, (kind, m, t) in enumerate(cells)]
    return "\n".join(rows + ["$EndElements", ""])


def node():
    return f"{len(POINTS)} 3 0 0\n" + "".join(f"{i} {p[0]!r} {p[1]!r} {p[2]!r}\n" for i, p in enumerate(POINTS))


def ele(markers=True):
    return f"{len(TETRAHEDRA)} 4 {int(markers)}\n" + "".join(
        f"{i} {' '.join(map(str, t))}" + (f" {m}" if markers else "") + "\n"
        for i, (t, m) in enumerate(zip(TETRAHEDRA, MARKERS)))


def vtk(binary, arrays="scalars", data_of_points=False):
    """A legacy file with the markers as SCALARS, or as an array of FIELD with meshio's name, for both kinds of cells."""
    n = len(TRIANGLES) + len(TETRAHEDRA)
    out = [b"# vtk DataFile Version 3.0\n", b"title\n", b"BINARY\n" if binary else b"ASCII\n",
           b"DATASET UNSTRUCTURED_GRID\n"]

    def numbers(kind, values):
        values = list(values)
        out.append((struct.pack(f">{len(values)}{kind}", *values) if binary else
                    " ".join(map(repr, values)).encode()) + b"\n")
    out.append(f"POINTS {len(POINTS)} double\n".encode())
    numbers("d", itertools.chain(*POINTS))
    out.append(f"CELLS {n} {4 * len(TRIANGLES) + 5 * len(TETRAHEDRA)}\n".encode())
    numbers("i", itertools.chain(*([len(c)] + c for c in TRIANGLES + TETRAHEDRA)))
    out.append(f"CELL_TYPES {n}\n".encode())
    numbers("i", [5] * len(TRIANGLES) + [10] * len(TETRAHEDRA))
    if data_of_points:
        out.append(f"POINT_DATA {len(POINTS)}\nVECTORS v double\n".encode())
        numbers("d", itertools.chain(*POINTS))
        out.append(b"SCALARS region float 1\nLOOKUP_TABLE default\n")
        numbers("f", [0.5] * len(POINTS))
    out.append(f"CELL_DATA {n}\n".encode())
    if arrays == "scalars":
        out.append(b"SCALARS region int\nLOOKUP_TABLE default\n")
        numbers("i", [0] * len(TRIANGLES) + MARKERS)
        out.append(b"SCALARS facet double 1\nLOOKUP_TABLE default\n")
        numbers("d", [77.0] * len(TRIANGLES) + [0.0] * len(TETRAHEDRA))
    else:
        out.append(f"FIELD FieldData 2\nother 2 {n} float\n".encode())
        numbers("f", [0.25] * 2 * n)
        out.append(f"gmsh:physical 1 {n} int\n".encode())
        numbers("i", [77] * len(TRIANGLES) + MARKERS)
    return b"".join(out)


def vtu(arrays):
    """A .vtu file in text. `arrays` are the names and values of cell data."""
    cells = TRIANGLES + TETRAHEDRA
    ends = list(itertools.accumulate(map(len, cells)))

    def array(name, kind, values, components=1):
        return (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="ascii">'
                + " ".join(map(repr, values)) + "</DataArray>\n")
    return ('<VTKFile type="UnstructuredGrid" version="0.1"><UnstructuredGrid>'
            f'<Piece NumberOfPoints="{len(POINTS)}" NumberOfCells="{len(cells)}"><Points>'
            + array("Points", "Float64", itertools.chain(*POINTS), 3) + "</Points><Cells>"
            + array("connectivity", "Int32", itertools.chain(*cells)) + array("offsets", "Int32", ends)
            + array("types", "UInt8", [5 if len(c) == 3 else 10 for c in cells]) + "</Cells><CellData>"
            + "".join(array(name, kind, values) for name, kind, values in arrays)
            + "</CellData></Piece></UnstructuredGrid></VTKFile>\n")


def abaqus(kind):
    """Regions as *ELEMENT names them, as generated sets with sections, or as sets with mgdt's names."""
    half = len(TETRAHEDRA) // 2
    rows = ["*HEADING", "*NODE"] + [f"{i + 1}, " + ", ".join(map(repr, p)) for i, p in enumerate(POINTS)]
    element = [f"{i + 101}, " + ", ".join(str(v + 1) for v in t) for i, t in enumerate(TETRAHEDRA)]
    last = 100 + len(TETRAHEDRA)
    shells = ["*ELEMENT, TYPE=S3, ELSET=FLOOR"] + [
        f"{i + 1}, " + ", ".join(str(v + 1) for v in t) for i, t in enumerate(TRIANGLES)]
    if kind == "elements":
        return "\n".join(rows + shells + ["*ELEMENT, TYPE=C3D4, ELSET=LOW"] + element[:half]
                         + ["*ELEMENT, TYPE=C3D4, ELSET=HIGH"] + element[half:] + [""])
    rows += shells + ["*ELEMENT, TYPE=C3D4, ELSET=ALL"] + element
    if kind == "sections":
        rows += ["*ELSET, ELSET=LOAD", "101, 102, OTHER", "*ELSET, ELSET=LOW, GENERATE", f"101, {100 + half}, 1",
                 "*Elset, elset=High, generate", f"{101 + half}, {last}", "*SOLID SECTION, ELSET=LOW, MATERIAL=CLAY",
                 "*SOLID SECTION, ELSET=HIGH, MATERIAL=SAND"]
    else:
        rows += ["*ELSET, ELSET=REGION_3"] + [str(i) for i in range(101, 101 + half)]
        rows += ["*ELSET, ELSET=REGION_M8, GENERATE", f"{101 + half}, {last}"]
    return "\n".join(rows + [""])


class Improve(CliTest):
    def put_all(self):
        self.put("a.mesh", medit())
        self.put("b.meshb", meshb())
        self.put("c.msh", gmsh2())
        self.put("d.node", node())
        self.put("d.ele", ele())

    def read(self, name):
        """Points, tetrahedra, their markers, triangles and their markers of a .mesh file."""
        words = self.get(name).decode().split()
        found = {}
        for keyword, width in (("Vertices", 4), ("Triangles", 4), ("Tetrahedra", 5)):
            if keyword in words:
                at = words.index(keyword)
                count = int(words[at + 1])
                found[keyword] = [words[at + 2 + width * k:at + 2 + width * (k + 1)] for k in range(count)]
        return found

    def test_every_format_with_markers(self):
        self.put_all()
        first = None
        for name in ("a.mesh", "b.meshb", "c.msh", "d.ele"):
            with self.subTest(name):
                said = self.mgdt("improve", name, "-o", "out.mesh", "--goal", "25", "--check").decode()
                self.assertRegex(said, r"^dihedral angles: \d+\.\d\d to .* before, 2[5-9]\.\d\d to .* after; mean shape")
                self.assertRegex(said, r"tetrahedra, checked: out.mesh\n$")
                self.assertNotIn("below the goal", said)
                found = self.read("out.mesh")
                self.assertEqual({row[4] for row in found["Tetrahedra"]}, {"3", "-8"})
                triangles = sorted(row[3] for row in found["Triangles"])
                if name != "d.ele":
                    self.assertEqual(triangles.count("77"), 2)
                    found["Triangles"] = []
                    if name == "a.mesh":
                        first = found
                    self.assertEqual(found, first)

    def test_markers_of_cell_data(self):
        """The regions are those of a.mesh, and so is what comes out; of both kinds of markers."""
        self.put("a.mesh", medit())
        self.mgdt("improve", "a.mesh", "-o", "out.mesh")
        first = self.read("out.mesh")
        zeros, tens = [0] * len(TRIANGLES), [0] * len(TETRAHEDRA)
        both = [77] * len(TRIANGLES) + MARKERS
        self.put("a.vtk", vtk(False))
        self.put("b.vtk", vtk(True))
        self.put("c.vtk", vtk(False, "field", True))
        self.put("d.vtk", vtk(True, "field", True))
        self.put("a.vtu", vtu([("region", "Int32", zeros + MARKERS), ("facet", "Int32", [77] * len(TRIANGLES) + tens)]))
        self.put("b.vtu", vtu([("other", "Float32", [0.5] * len(both)), ("gmsh:physical", "Int64", both)]))
        self.put("c.vtu", vtu([("MaterialIDs", "Float64", [float(m) for m in both])]))
        for name in ("a.vtk", "b.vtk", "c.vtk", "d.vtk", "a.vtu", "b.vtu", "c.vtu"):
            with self.subTest(name):
                self.mgdt("improve", name, "-o", "out.mesh", "--check")
                found = self.read("out.mesh")
                self.assertEqual(sorted(row[3] for row in found["Triangles"]).count("77"), 2)
                self.assertEqual(found["Vertices"], first["Vertices"])
                self.assertEqual(found["Tetrahedra"], first["Tetrahedra"])
        # What mgdt has written comes in again with the same markers.
        for name in ("o.vtu", "o.vtk", "o.inp"):
            with self.subTest(name):
                self.mgdt("improve", "-q", "a.mesh", "-o", name)
                self.mgdt("improve", "-q", name, "-o", "out.mesh")
                found = self.read("out.mesh")
                self.assertEqual(found["Tetrahedra"], first["Tetrahedra"])
                if name != "o.inp":
                    self.assertEqual(sorted(row[3] for row in found["Triangles"]),
                                     sorted(row[3] for row in first["Triangles"]))
        self.put("d.vtu", vtu([("region", "Float64", [0.5] * len(both))]))
        self.fails(3, "improve", "d.vtu", "-o", "o.mesh", says="region of cell 0: 0.5 is no 32-bit integer")
        self.put("e.vtk", vtk(False).replace(b"-8", b"4294967296", 1))
        self.fails(3, "improve", "e.vtk", "-o", "o.mesh", says="4294967296 is no 32-bit integer")
        self.put("f.vtk", vtk(False).replace(b"CELL_DATA ", b"CELL_DATA 1"))
        self.fails(3, "improve", "f.vtk", "-o", "o.mesh", says="cells; there are")

    def test_element_sets(self):
        self.put("a.mesh", medit())
        self.mgdt("improve", "a.mesh", "-o", "out.mesh")
        first = self.read("out.mesh")
        for kind, markers in (("elements", {"3": "1", "-8": "2"}), ("sections", {"3": "1", "-8": "2"}), ("names", {})):
            with self.subTest(kind):
                self.put("a.inp", abaqus(kind))
                self.mgdt("improve", "a.inp", "-o", "out.mesh", "--check")
                found = self.read("out.mesh")
                self.assertEqual(found["Vertices"], first["Vertices"])
                self.assertEqual(found["Tetrahedra"],
                                 [row[:4] + [markers.get(row[4], row[4])] for row in first["Tetrahedra"]])
        self.put("c.inp", abaqus("sections").replace("*ELSET, ELSET=LOW, GENERATE\n", "*ELSET, ELSET=LOW, GENERATE\n1, 9999999\n"))
        self.fails(3, "improve", "c.inp", "-o", "o.mesh", says="1 to 9999999: too many elements")

    def test_every_output(self):
        self.put_all()
        for name in ("o.vtu", "o.vtk", "o.msh", "o.inp", "o.ele", "o.meshb"):
            with self.subTest(name):
                self.mgdt("improve", "-q", "a.mesh", "-o", name, "--threads", "2", "--boundary", "slide")
                self.assertIn(b"angles", self.mgdt("info", name))
        self.assertIn(b'"floor"', self.mgdt("improve", "-q", "c.msh", "-o", "-", "--to", "gmsh"))

    def test_without_markers(self):
        self.put("d.node", node())
        self.put("d.ele", ele(False))
        self.mgdt("improve", "d.ele", "-o", "e.ele", "--goal", "28", "--keep", "all")
        self.assertTrue(self.get("e.ele").decode().splitlines()[0].endswith(" 4 0"))
        rows = self.get("e.node").decode().splitlines()[1:len(POINTS) + 1]
        self.assertEqual([list(map(float, row.split()[1:4])) for row in rows], POINTS)

    def test_a_goal_out_of_reach(self):
        self.put_all()
        said = self.mgdt("improve", "a.mesh", "-o", "o.mesh", "--goal", "60", "--passes", "2",
                         "--mean-passes", "1").decode()
        self.assertRegex(said, r"\n\d+ tetrahedra below the goal of 60 degrees: \d+ .*\n")

    def test_a_mesh_of_a_surface(self):
        cube = "OFF\n8 6 0\n" + "".join(f"{x} {y} {z}\n" for z in (0, 2) for y in (0, 2) for x in (0, 2)) + \
            "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n"
        self.put("cube.off", cube)
        said = self.mgdt("mesh", "cube.off", "-o", "cube.vtu", "--improve", "--goal", "40", "--check").decode()
        self.assertRegex(said, r"^dihedral angles: .*\n6 facets, 8 points, \d+ added")
        self.mgdt("mesh", "cube.off", "-o", "cube.vtu", "--improve", "--boundary", "fixed", "--keep", "numbers")
        self.fails(2, "mesh", "cube.off", "-o", "cube.vtu", "--goal", "40", says="--improve")

    def test_info(self):
        self.put_all()
        said = self.mgdt("info", "a.mesh").decode()
        self.assertRegex(said, r"\nangles +\d+\.?\d* to \d+\.?\d* degrees\nmean shape +0\.\d{3}\n")
        self.assertEqual(len([row for row in said.splitlines() if " % " in row + " "]), 18)
        self.put("d.node", node())
        self.put("d.ele", "2 4 0\n0 0 1 2 3\n1 0 1 2 3\n")
        self.assertRegex(self.mgdt("info", "d.ele").decode(), r"no mesh +d.ele: tetrahedr")

    def test_what_is_refused(self):
        self.put_all()
        self.put("p.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n")
        self.fails(3, "improve", "p.xyz", "-o", "o.vtu", says="there are no tetrahedra")
        self.put("f.mesh", medit().replace("1 2 7 77", "1 2 9 77"))
        self.fails(3, "improve", "f.mesh", "-o", "o.vtu", says="face 0 is no face of a tetrahedron")
        self.put("d.node", node())
        self.put("d.ele", "1 4 0\n0 0 1 2 3\n")
        self.fails(3, "improve", "d.ele", "-o", "o.vtu", says="tetrahedron 0 is flat")
        self.put("d.ele", "1 4 1\n0 0 1 6 31 0.5\n")
        self.fails(3, "improve", "d.ele", "-o", "o.vtu", says="no 32-bit integer")
        self.fails(2, "improve", "a.mesh", "-o", "o.vtu", "--goal", "71", says="--goal")
        self.fails(2, "improve", "a.mesh", "-o", "o.vtu", "--boundary", "open", says="--boundary")
        self.fails(2, "improve", "a.mesh", "-o", "o.stl", says="no place for tetrahedra")
        self.fails(2, "improve", "a.mesh", "-o", "a.mesh", says="")
        self.fails(5, "improve", "a.mesh", "-o", "o.vtu", "--memory-limit", "20000B", says="memory")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    cli_test.MGDT = os.path.abspath(sys.argv.pop(1))
    unittest.main()
