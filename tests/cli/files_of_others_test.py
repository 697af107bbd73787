#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Files as other programs write them today: tetrahedra of higher order, VTK's newer and binary
files, surfaces, compressed files, and tables that are not what they seem.

Usage: files_of_others_test.py MGDT [unittest arguments]
"""

import gzip
import os
import sys
import unittest

sys.dont_write_bytecode = True  # the source tree stays as it is
import cli_test
import meshio
import numpy as np
from solver_files_test import MeshTest

EDGES = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]


class FilesOfOthers(MeshTest):
    def quadratic(self):
        """The same mesh with a node in the middle of each edge. The corners do not come first."""
        numbers = {}
        cells = []
        for cell in self.tetrahedra:
            cells.append([*cell, *(numbers.setdefault(frozenset((cell[a], cell[b])), len(numbers)) + len(self.points)
                                   for a, b in EDGES)])
        middle = np.array([self.points[sorted(edge)].mean(axis=0) for edge in numbers])
        points = np.concatenate([self.points, middle])
        order = np.random.default_rng(3).permutation(len(points))
        return points[order], np.argsort(order)[np.array(cells)], len(middle)

    def assert_corners_alone(self, name, n_middle):
        said = self.mgdt("info", name).decode()
        self.assertRegex(said, rf"points +{len(self.points)}\n")
        self.assertRegex(said, rf"tetrahedra +{len(self.tetrahedra)}\n")
        self.assertRegex(said, rf"mid-side nodes +{n_middle}, left out\n")
        said = self.mgdt("check", name).decode()
        self.assertIn(f"{n_middle} mid-side nodes left out", said)
        self.assertIn("the canonical one", said)
        said = self.mgdt("triangulate", name, "-o", "again.mesh").decode()
        self.assertIn(f"{len(self.points)} points", said)
        self.assertIn(f"{name}: {n_middle} mid-side nodes left out", self.err)
        self.mgdt("triangulate", "-q", name, "-o", "again.mesh")
        self.assertEqual(self.err, "")
        self.mgdt("triangulate", name, "--parts", 2, "-o", "again.pvtu")
        self.assertIn(f"{n_middle} mid-side nodes left out", self.err)

    def test_quadratic_tetrahedra(self):
        points, cells, n_middle = self.quadratic()
        mesh = meshio.Mesh(points, [("tetra10", cells)])
        options = {"m41.msh": {"file_format": "gmsh"}, "m22.msh": {"file_format": "gmsh22"},
                   "text.msh": {"file_format": "gmsh22", "binary": False}, "m.vtu": {}, "m.inp": {},
                   "m42.vtk": {"file_format": "vtk42"}, "m51.vtk": {"file_format": "vtk51"},
                   "text.vtk": {"file_format": "vtk51", "binary": False}}
        for name, how in options.items():
            with self.subTest(name=name):
                meshio.write(self.path(name), mesh, **how)
                self.assert_corners_alone(name, n_middle)

    def test_quadratic_tetrahedra_of_tetgen_and_medit(self):
        points, cells, n_middle = self.quadratic()
        rows = [" ".join(map(str, p)) for p in points.tolist()]
        with open(self.path("t.node"), "w") as f:
            f.write(f"{len(points)} 3 0 0\n" + "".join(f"{i + 1} {row}\n" for i, row in enumerate(rows)))
        numbers = [" ".join(map(str, c)) for c in (cells + 1).tolist()]
        with open(self.path("t.ele"), "w") as f:
            f.write(f"{len(cells)} 10 0\n" + "".join(f"{i + 1} {row}\n" for i, row in enumerate(numbers)))
        self.assert_corners_alone("t.ele", n_middle)
        with open(self.path("q.mesh"), "w") as f:
            f.write(f"MeshVersionFormatted 2\nDimension 3\nVertices {len(points)}\n" + "".join(row + " 0\n" for row in rows))
            f.write(f"TetrahedraP2 {len(cells)}\n" + "".join(row + " 0\n" for row in numbers) + "End\n")
        self.assert_corners_alone("q.mesh", n_middle)
        # Version 4 has integers and places of 64 bits.
        vertices = b"".join(np.array(p, "<f8").tobytes() + np.array([0], "<i8").tobytes() for p in points)
        tetrahedra = np.column_stack([cells + 1, np.zeros(len(cells), int)]).astype("<i8").tobytes()
        head = np.array([1, 4, 3], "<i4").tobytes() + np.array([24], "<i8").tobytes() + np.array([3, 4], "<i4").tobytes()
        at = len(head) + 16 + len(vertices)
        body = np.array([at, len(points)], "<i8").tobytes() + vertices + np.array([30], "<i4").tobytes()
        end = at + 4 + 16 + len(tetrahedra)
        body += np.array([end, len(cells)], "<i8").tobytes() + tetrahedra
        self.put("q.meshb", head + body + np.array([54, 0, 0], "<i4").tobytes())
        self.assert_corners_alone("q.meshb", n_middle)

    def test_variants_of_abaqus(self):
        points, cells, n_middle = self.quadratic()
        nodes = "*NODE\n" + "".join(f"{i + 1}, {x!r}, {y!r}, {z!r}\n" for i, (x, y, z) in enumerate(points.tolist()))
        for kind in ("C3D10", "C3D10M", "c3d10h", "C3D10MHT", "DC3D10", "AC3D10", "C3D10I"):
            with self.subTest(kind=kind):
                self.put("q.inp", nodes + f"*ELEMENT, TYPE={kind}, ELSET=E\n" + "".join(
                    f"{i + 1}, " + ", ".join(map(str, c)) + "\n" for i, c in enumerate((cells + 1).tolist())))
                self.assert_corners_alone("q.inp", n_middle)
        nodes = "*NODE\n" + "".join(f"{i + 1}, {x!r}, {y!r}, {z!r}\n" for i, (x, y, z) in enumerate(self.points.tolist()))
        for kind, code in (("C3D4H", 0), ("C3D4", 0), ("DC3D4", 0), ("M3D4", 7), ("R3D4", 7), ("C3D8", 7), ("SC3D4", 7), ("C3D4_", 7)):
            with self.subTest(kind=kind):
                self.put("l.inp", nodes + f"*ELEMENT, TYPE={kind}\n" + "".join(
                    f"{i + 1}, " + ", ".join(map(str, c)) + "\n" for i, c in enumerate((self.tetrahedra + 1).tolist())))
                self.mgdt("check", "l.inp", code=code)

    def test_values_at_corners(self):
        points, cells, _ = self.quadratic()
        meshio.write(self.path("q.vtu"), meshio.Mesh(points, [("tetra10", cells)], point_data={"f": points @ [1., 2, 3]}))
        np.save(self.path("places.npy"), self.points[:20])
        self.mgdt("interpolate", "-q", "q.vtu", "places.npy", "-o", "v.npy")
        values = np.load(self.path("v.npy"))
        self.assertTrue(np.allclose(values[:, 3], self.points[:20] @ [1., 2, 3]))

    def test_orders_above_two(self):
        """Lagrange's tetrahedra of VTK, of order 3 with 20 nodes, and Gmsh's of the same."""
        random = np.random.default_rng(1)
        points = np.concatenate([np.eye(4, 3), random.random((16, 3))])
        nodes = " ".join(map(str, range(20)))
        coordinates = "\n".join(" ".join(map(str, p)) for p in points.tolist())
        self.put("l.vtk", f"# vtk DataFile Version 4.2\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 20 double\n{coordinates}\n"
                 f"CELLS 1 21\n20 {nodes}\nCELL_TYPES 1\n71\n")
        self.put("g.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n20\n"
                 + "".join(f"{i} " + " ".join(map(str, p)) + "\n" for i, p in enumerate(points.tolist(), 1))
                 + "$EndNodes\n$Elements\n1\n1 29 2 0 1 " + " ".join(map(str, range(1, 21))) + "\n$EndElements\n")
        for name in ("l.vtk", "g.msh"):
            said = self.mgdt("info", name).decode()
            self.assertRegex(said, r"points +4\n")
            self.assertRegex(said, r"mid-side nodes +16, left out\n")

    def test_damaged_tetrahedra_of_higher_order(self):
        head = "# vtk DataFile Version 4.2\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0 1 0 0 0 1 0 0 0 1\n"
        for cells, says in (("CELLS 1 11\n10 0 1 2 3 0 0 0 0 0 4\nCELL_TYPES 1\n24\n", "point is 4; it must be from 0 to 3"),
                            ("CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n24\n", "type 24 with 4 points"),
                            ("CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n71\n", "type 71 with 3 points")):
            self.put("bad.vtk", head + cells)
            self.fails(3, "info", "bad.vtk", says=says)
        self.put("bad.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n$Elements\n1\n"
                 "1 11 2 0 1 1 1 1 1 1 1 1 1 1 2\n$EndElements\n")
        self.fails(3, "info", "bad.msh", says=("line 10", "no node 2"))

    def test_vtk_files_of_any_version(self):
        mesh = meshio.Mesh(self.points, [("tetra", self.tetrahedra), ("triangle", self.tetrahedra[:7, :3])],
                           point_data={"f": self.points[:, 0]})
        for version in ("vtk42", "vtk51"):
            for is_binary in (True, False):
                with self.subTest(version=version, is_binary=is_binary):
                    meshio.write(self.path("v.vtk"), mesh, file_format=version, binary=is_binary)
                    said = self.mgdt("info", "v.vtk").decode()
                    self.assertRegex(said, rf"points +{len(self.points)}\n")
                    self.assertRegex(said, r"other cells +7\n")
                    self.assertIn("binary" if is_binary else "text", said)
                    self.mgdt("check", "-q", "v.vtk")
                    self.mgdt("triangulate", "-q", "v.vtk", "-o", "again.npy")
                    self.assertTrue((np.load(self.path("again.npy")) == self.tetrahedra).all())
                    whole = self.get("v.vtk")
                    for size in range(0, whole.index(b"POINT_DATA") - 20, 997):
                        self.put("cut.vtk", whole[:size])
                        self.fails(3, "info", "cut.vtk", says="cut.vtk")

    @staticmethod
    def as_vtk_9_writes():
        """Binary of version 5.1 with what VTK adds: fields before the points, and metadata."""
        points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], ">f4")
        return (b"# vtk DataFile Version 5.1\nvtk output\nBINARY\nDATASET UNSTRUCTURED_GRID\n"
                b"FIELD FieldData 2\nTIME 1 1 double\n" + np.array([np.pi], ">f8").tobytes() + b"\n"
                b"CYCLE 1 2 vtktypeint64\n" + np.array([7, 10], ">i8").tobytes() + b"\n"
                b"POINTS 4 float\n" + points.tobytes() + b"\nMETADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\n"
                b"DATA 2 0 1 POINTS 7\n\nCELLS 2 4\nOFFSETS vtktypeint64\n" + np.array([0, 4], ">i8").tobytes()
                + b"\nCONNECTIVITY vtktypeint64\n" + np.arange(4, dtype=">i8").tobytes() + b"\nCELL_TYPES 1\n"
                + np.array([10], ">i4").tobytes() + b"\nPOINT_DATA 4\nSCALARS s float\n")

    def test_vtk_9(self):
        whole = self.as_vtk_9_writes()
        self.put("v9.vtk", whole)
        said = self.mgdt("info", "v9.vtk").decode()
        self.assertRegex(said, r"points +4\n")
        self.assertRegex(said, r"tetrahedra +1\n")
        self.assertIn("version 5.1, binary", said)
        for old, new in ((b"OFFSETS", b"OFFSET_"), (b"CELLS 2 4", b"CELLS 3 4"), (b"CELLS 2 4", b"CELLS 2 3"),
                         (b"CONNECTIVITY vtktypeint64", b"CONNECTIVITY vtktypeint65"), (b"double", b"string"),
                         (b"4 float", b"9 float"), (b"4 float", b"4611686018427387904 float"), (b"4 float", b"-1 float"),
                         (b"1 2 vtk", b"9999 9999999999 vtk")):
            self.put("bad.vtk", whole.replace(old, new, 1))
            self.fails(3, "info", "bad.vtk", says="bad.vtk")

    def test_surfaces_of_vtk(self):
        points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)
        self.put("s.vtk", b"# vtk DataFile Version 3.0\n\nBINARY\nDATASET POLYDATA\nPOINTS 4 double\n" + points.astype(">f8").tobytes()
                 + b"\nVERTICES 1 2\n" + np.array([1, 3], ">i4").tobytes()
                 + b"\nPOLYGONS 2 8\n" + np.array([3, 0, 1, 2, 3, 0, 2, 3], ">i4").tobytes() + b"\nCELL_DATA 2\n")
        coordinates = " ".join(map(str, points.ravel()))
        self.put("s.vtp", '<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian"><PolyData>'
                 '<Piece NumberOfPoints="4" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="2">'
                 '<PointData><DataArray type="Float64" Name="f" format="ascii">1 2 3 4</DataArray></PointData>'
                 f'<Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">{coordinates}</DataArray></Points>'
                 '<Polys><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 0 2 3</DataArray>'
                 '<DataArray type="Int32" Name="offsets" format="ascii">3 6</DataArray></Polys></Piece></PolyData></VTKFile>')
        for name in ("s.vtk", "s.vtp"):
            said = self.mgdt("info", name).decode()
            self.assertRegex(said, r"points +4\n")
            self.assertRegex(said, r"other cells +2\n")
            self.fails(7, "check", name, says="2 other cells")
        self.put("p.csv", "x,y,z\n0.25,0.25,0.25\n")
        self.assertIn("2.5", self.mgdt("interpolate", "s.vtp", "p.csv", "-o", "-", "--to", "csv").decode())
        self.fails(2, "triangulate", "points.npy", "-o", "out.vtp", says="no place for tetrahedra")

    def test_off(self):
        meshio.write(self.path("m.off"), meshio.Mesh(self.points, [("triangle", self.tetrahedra[:5, :3])]))
        said = self.mgdt("info", "m.off").decode()
        self.assertRegex(said, rf"points +{len(self.points)}\n")
        self.assertRegex(said, r"other cells +5\n")
        for text, n in (("OFF 3 1 3\n0 0 0\n1 0 0 # c\n\n0 1 0\n3 0 1 2\n", 3), ("# c\nCOFF\n2 0 0\n0 0 0 1 1 1 1\n1 0 0 0.5 0 0 1\n", 2),
                        ("NOFF\n1 0 0\n1 2 3 0 0 1\n", 1)):
            self.put("v.off", text)
            self.assertRegex(self.mgdt("info", "v.off").decode(), rf"points +{n}\n")
        for text, line, says in (("OFF\n3 1 3\n0 0 0\n", 2, "cut short"), ("OFF BINARY\n", 1, "binary"), ("4OFF\n1 0 0\n", 1, "three coordinates"),
                                 ("OFF\n", 1, "cut short"), ("off 3\n", 1, "not an OFF file"), ("OFF\n2 0 0\n0 0 0\n0 nan 0\n", 4, "finite"),
                                 ("OFF\n4611686018427387904 0 0\n", 2, "announced"), ("OFF\n2 0 0\n0 0 0\n 0 0\n      ", 4, "missing")):
            self.put("bad.off", text)
            self.fails(3, "info", "bad.off", says=(f"line {line}", says))
        self.put("nameless", "OFF\n1 0 0\n1 2 3\n")
        self.assertRegex(self.mgdt("info", "nameless").decode(), r"format +off")

    def test_stl_in_capitals(self):
        self.put("c.stl", "SOLID CAD\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVertex 0 1 0\nENDLOOP\nENDFACET\nENDSOLID\n"
                 + " " * 100)
        said = self.mgdt("info", "c.stl").decode()
        self.assertRegex(said, r"points +3\n")
        self.assertRegex(said, r"other cells +1\n")

    def test_compressed_files(self):
        np.savetxt(self.path("p.csv"), self.points, delimiter=",", header="x,y,z", comments="", fmt="%.17g")
        for ending in ("vtu", "msh", "mesh", "inp", "vtk", "ele"):
            self.mgdt("triangulate", "-q", "points.npy", "-o", f"m.{ending}")
        expected = [f"{len(self.points)} points"]
        for name in ("p.csv", "points.npy", "m.vtu", "m.msh", "m.mesh", "m.inp", "m.vtk", "m.ele"):
            with self.subTest(name=name):
                self.put(name + ".gz", gzip.compress(self.get(name)))
                said = self.mgdt("check", name + ".gz").decode()
                self.assertIn(expected[0], said)
        # TetGen's other files may be compressed as well.
        self.put("m.node.gz", gzip.compress(self.get("m.node")))
        os.remove(self.path("m.node"))
        os.remove(self.path("m.neigh"))
        self.assertIn("m.node.gz", self.mgdt("info", "m.ele.gz").decode())
        # Members one after the other, and zeros at the end.
        rows = self.get("p.csv")
        self.put("two.csv.GZ", gzip.compress(rows[:1000]) + gzip.compress(rows[1000:]) + b"\0" * 512)
        self.assertIn(expected[0], self.mgdt("check", "two.csv.GZ").decode())
        # Parts read it as a whole.
        self.mgdt("triangulate", "points.npy.gz", "--parts", 2, "-o", "pieces.pvtu")
        self.mgdt("triangulate", "-q", "points.npy.gz", "-o", "again.npy")
        self.assertTrue((np.load(self.path("again.npy")) == self.tetrahedra).all())
        small = gzip.compress(rows)
        for bad, says in ((small[:len(small) // 2], "cut short"), (small[:5], "cut short"), (rows, "not a gzip file"), (b"", "empty"),
                          (small[:200] + b"\x55" * 50 + small[250:], "damaged"), (small + b"more", "not a gzip file")):
            self.put("bad.csv.gz", bad)
            self.fails(3, "info", "bad.csv.gz", says=("bad.csv.gz", says))
        self.put("bad.csv", small)
        self.fails(3, "info", "bad.csv", says="bad.csv")
        self.put("empty.csv.gz", gzip.compress(b""))
        self.fails(3, "info", "empty.csv.gz", says="--allow-empty")

    def test_unknown_extensions(self):
        rows = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
        self.put("p.log", rows)
        self.fails(3, "triangulate", "p.log", "-o", "m.vtu", says=("p.log", "'.log'", "--from"))
        self.mgdt("triangulate", "p.log", "--from", "xyz", "-o", "m.vtu")
        self.put("points", rows)
        self.mgdt("check", "points")
        self.put("v.log", self.as_vtk_9_writes())
        self.mgdt("check", "v.log")
        self.mgdt("check", "-", data=rows.encode())

    def test_tables_that_are_not_what_they_seem(self):
        self.put("v.txt", "1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n")  # as Voro++ reads
        self.fails(3, "triangulate", "v.txt", "-o", "m.vtu", says=("v.txt: line 1", "--columns 2,3,4", "the first column counts"))
        self.assertRegex(self.mgdt("info", "v.txt", "--columns", "2,3,4").decode(), r"x +0 to 1\n")
        self.put("r.txt", "0 0 0\n1 0 0 7\n0 1 0\n")
        self.fails(3, "check", "r.txt", says=("r.txt: line 2", "more than 3 columns", "line 1 has 3"))
        self.put("s.csv", "x,y,z,t\n0,0,0,1\n1,0,0,2\n0,1,0,3\n0,0,1,4\n")
        self.put("q.txt", "0.1 0.1 0.1 9\n")
        self.fails(3, "interpolate", "s.csv", "q.txt", "-o", "v.csv", says="--places-columns")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    cli_test.MGDT = os.path.abspath(sys.argv.pop(1))
    unittest.main()
