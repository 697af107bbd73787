#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Files for finite-element programs, as meshio reads and writes them.

Usage: solver_files_test.py MGDT [unittest arguments]
"""

import os
import re
import sys
import unittest

sys.dont_write_bytecode = True  # the source tree stays as it is
import cli_test
import meshio
import numpy as np
from cli_test import CliTest


class MeshTest(CliTest):
    """Has 300 points and their tetrahedra, as files and as arrays."""

    def setUp(self):
        super().setUp()
        self.mgdt("generate", "-q", "galaxy", "300", "-o", "points.npy")
        self.points = np.load(self.path("points.npy"))
        self.mgdt("triangulate", "-q", "points.npy", "-o", "mesh.npy")
        self.tetrahedra = np.load(self.path("mesh.npy"))


class SolverFiles(MeshTest):
    ENDINGS = {"mesh": "medit", "meshb": "meshb", "inp": "abaqus", "vtk": "vtk"}

    def test_written_files_are_read(self):
        for ending in self.ENDINGS:
            with self.subTest(ending=ending):
                self.mgdt("triangulate", "-q", "points.npy", "-o", f"mesh.{ending}")
                mesh = meshio.read(self.path(f"mesh.{ending}"))
                self.assertTrue((mesh.points == self.points).all())
                self.assertTrue((mesh.cells_dict["tetra"] == self.tetrahedra).all())
                self.mgdt("check", "-q", f"mesh.{ending}")

    def test_files_of_meshio(self):
        cells = [("tetra", self.tetrahedra), ("triangle", self.tetrahedra[:5, :3])]
        for ending, name in self.ENDINGS.items():
            with self.subTest(ending=ending):
                mesh = meshio.Mesh(self.points, cells)
                if ending == "vtk":
                    meshio.write(self.path(f"other.{ending}"), mesh, file_format="vtk42", binary=False)
                else:
                    meshio.write(self.path(f"other.{ending}"), mesh)
                said = self.mgdt("info", f"other.{ending}").decode()
                self.assertIn(name, said)
                self.assertIn(str(len(self.tetrahedra)), said)
                self.mgdt("triangulate", "-q", f"other.{ending}", "-o", "again.npy")
                self.assertTrue((np.load(self.path("again.npy")) == self.tetrahedra).all())

    def test_compressed_vtu(self):
        """Arrays compressed and not, raw, in base64 and as text, by meshio and back."""
        self.mgdt("triangulate", "-q", "points.npy", "-o", "raw.vtu")
        self.mgdt("triangulate", "-q", "points.npy", "-o", "small.vtu", "--compress")
        self.assertLess(len(self.get("small.vtu")), len(self.get("raw.vtu")))
        self.mgdt("triangulate", "-q", "points.npy", "--parts", "2", "-o", "parts.pvtu", "--compress")
        self.mgdt("interpolate", "-q", "small.vtu", "points.npy", "-o", "field.vtu", "--compress", code=3)
        for name in ("raw.vtu", "small.vtu"):
            mesh = meshio.read(self.path(name))
            self.assertTrue((mesh.points == self.points).all())
            self.assertTrue((mesh.cells_dict["tetra"] == self.tetrahedra).all())
        for compression in ("zlib", None):
            mesh.point_data["f"] = self.points[:, 0] + 1
            meshio.vtu.write(self.path("other.vtu"), mesh, binary=True, compression=compression)
            self.mgdt("triangulate", "-q", "other.vtu", "-o", "again.npy")
            self.assertTrue((np.load(self.path("again.npy")) == self.tetrahedra).all())
            self.mgdt("interpolate", "-q", "other.vtu", "points.npy", "-o", "field.vtu", "--compress")
            field = meshio.read(self.path("field.vtu"))
            self.assertTrue(np.allclose(field.point_data["f"].ravel(), field.points[:, 0] + 1))
        whole = self.get("small.vtu")
        begin = whole.index(b'encoding="raw"')
        for at in (begin + 17, begin + 40, begin + 60, begin + 200, len(whole) - 60):
            self.put("bad.vtu", whole[:at] + bytes([whole[at] ^ 0x55]) + whole[at + 1:])
            self.fails(3, "check", "bad.vtu", says="bad.vtu")
        self.put("cut.vtu", whole[:len(whole) // 2])
        self.fails(3, "info", "cut.vtu", says="cut short")
        self.fails(2, "triangulate", "points.npy", "-o", "mesh.msh", "--compress", says="--compress is for .vtu")

    def test_short_arrays_in_base64(self):
        """Padding at the end of the shortest arrays: of one byte, and of none."""
        corners, cells = np.eye(4, 3), [("tetra", np.array([[0, 1, 2, 3]]))]
        for mesh, count in ((meshio.Mesh(corners, cells), 1), (meshio.Mesh(corners, []), 0)):
            for compression in ("zlib", None):
                meshio.vtu.write(self.path("short.vtu"), mesh, binary=True, compression=compression)
                said = self.mgdt("info", "short.vtu").decode()
                self.assertRegex(said, r"points +4\n")
                self.assertEqual("tetrahedra     1" in said, count == 1, said)
        self.mgdt("triangulate", "-q", "points.npy", "-o", "flat.vtu", "--compress")

    def test_many_sections(self):
        """What names the same bytes or numbers again and again is refused or read at once."""
        nodes = "".join(f"*NODE\n{n}, {n}, {n * n % 7}, {n * n % 11}\n*ELEMENT, TYPE=C3D4\n" for n in range(20000, 0, -1))
        self.put("falling.inp", nodes)
        self.mgdt("info", "falling.inp")
        head = [1, 2, 3, 20, 3]
        body = [4, 60, 1, 0, 0, 0, 0, 0, 0, 0, 8, 60, 0]  # the second keyword goes back to itself
        self.put("round.meshb", np.array(head + body, "<i4").tobytes())
        self.fails(3, "info", "round.meshb", says="the next keyword")

    def test_meshb(self):
        self.mgdt("triangulate", "-q", "points.npy", "-o", "mesh.meshb")
        whole = self.get("mesh.meshb")
        for change in (whole[:20] + b"\1" + whole[21:], whole[:8] + b"\x04\0\0\0\0\0\0\x80" + whole[16:], whole[:-9],
                       whole[:16] + b"\2" + whole[17:], b"\1\0\0\0\2\0\0\0" + b"\0" * 8):
            self.put("bad.meshb", change)
            self.fails(3, "info", "bad.meshb", says="bad.meshb")
        swapped = np.frombuffer(b"\1\0\0\0\1\0\0\0\3\0\0\0\x14\0\0\0\3\0\0\0\4\0\0\0\0\0\0\0\1\0\0\0", "<i4")
        self.put("big.meshb", swapped.astype(">i4").tobytes() + np.array([1, 2, 3], ">f4").tobytes() + bytes(4))
        self.assertRegex(self.mgdt("info", "--from", "meshb", "big.meshb").decode(), r"points +1\n")
        self.put("nameless", whole)
        self.assertIn("meshb", self.mgdt("info", "nameless").decode())

    def test_medit_on_any_lines(self):
        self.put("free.mesh", "MeshVersionFormatted\n1\nDimension\n3 # three\nVertices 5 0 0 0 1  2 0 0 1 0 2 0\n1 0 0 2 1\n"
                 "1 1 1 1\nRidges 2 1 2\nNormals 1 0.0 -1.5 .5\nTetrahedra\n1\n1 2 3 4 7 End")
        said = self.mgdt("info", "free.mesh").decode()
        self.assertRegex(said, r"points +5\n")
        self.assertRegex(said, r"tetrahedra +1\n")

    def test_abaqus_with_numbers_of_its_own(self):
        self.put("own.inp", "*Heading\n ** not a comment, but not of use\n** a comment\n*Node, nset=all\n 10, 0., 0., 0.\n"
                 "20, 1.D0, 0., 0.\n30,0.,1.,0.\n40,0.,0.,1.\n50,.5,0.,0.\n*Element, type = c3d10 , elset=e\n"
                 "7, 10, 20, 30, 40, 50,\n 50, 50, 50, 50, 50\n*element, TYPE=S3\n8, 10, 20, 30\n*Step\n*Static\n1., 1.\n")
        said = self.mgdt("info", "own.inp").decode()
        self.assertRegex(said, r"points +4\n")
        self.assertRegex(said, r"mid-side nodes +1, left out\n")
        self.assertRegex(said, r"tetrahedra +1\n")

    def test_abaqus_with_numbers_in_no_order(self):
        places = {9: (0, 0, 0), 2: (1, 0, 0), 900719925474099: (0, 1, 0), 4: (0, 0, 1), 1: (1, 1, 1)}
        nodes = "*NODE\n" + "".join(f"{n}, {x}, {y}, {z}\n" for n, (x, y, z) in places.items())
        self.put("order.inp", nodes + "*ELEMENT, TYPE=C3D4\n1, 9, 2, 900719925474099, 4\n2, 2, 900719925474099, 4, 1\n")
        self.mgdt("check", "order.inp")
        self.put("late.inp", nodes + "*NODE\n2, 5, 5, 5\n*ELEMENT, TYPE=C3D4\n")
        self.fails(3, "info", "late.inp", says="node 2 comes twice")
        self.put("late.inp", nodes + "2, 5, 5, 5\n")
        self.fails(3, "info", "late.inp", says="node 2 comes twice")

    def test_abaqus_with_lines_that_go_on(self):
        nodes = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n"
        for elements in ("*ELEMENT, TYPE=S3\n1, 1, 2, 3,\n*ELEMENT, TYPE=C3D4\n2, 1, 2, 3, 4\n",
                         "*ELEMENT,\nTYPE=C3D4\n1, 1, 2, 3, 4\n", "*ELEMENT, TYPE=S3\n1, 1,\n2, 3\n *ELEMENT,TYPE=C3D4\n1, 1,\n2, 3, 4",
                         "*ELEMENT, TYPE=C3D4, \nELSET=A\n1, 1, 2, 3,\n** between\n4,\n"):
            with self.subTest(elements=elements):
                self.put("on.inp", nodes + elements)
                self.assertRegex(self.mgdt("info", "on.inp").decode(), r"tetrahedra +1\n")

    def test_vtk_of_other_kinds(self):
        head = "# vtk DataFile Version 2.0\na title with POINTS 7 # in it\n"
        self.put("poly.vtk", head + "ASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0\n0 1 0\n0 0 1\nPOLYGONS 1 4\n3 0 1 2\n")
        self.assertRegex(self.mgdt("info", "poly.vtk").decode(), r"points +4\n")
        self.put("binary.vtk", head + "BINARY\nDATASET POLYDATA\n")
        self.fails(3, "info", "binary.vtk", says="has no POINTS")
        self.put("odd.vtk", head + "EBCDIC\nDATASET POLYDATA\n")
        self.fails(3, "info", "odd.vtk", says=("line 3", "ASCII or BINARY"))
        self.put("late.vtk", head + "ASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 1 float\n0 0 0\nCELL_TYPES 0\nCELLS 1 2\n1 0\n")
        self.fails(3, "info", "late.vtk", says="after their types")
        for version in ("6.0", "10.0", "0.9", "x"):
            self.put("new.vtk", f"# vtk DataFile Version {version}\n\nASCII\n")
            self.fails(3, "info", "new.vtk", says=("line 1", "up to 5.1"))
        self.put("small.vtk", head + "ascii\ndataset unstructured_grid\npoints 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\n"
                 "cells 1 5\n4 0 1 2 3\ncell_types 1\n10\npoint_data 4\nscalars s float\n")
        self.assertRegex(self.mgdt("info", "small.vtk").decode(), r"tetrahedra +1\n")

    def test_surfaces(self):
        corners = np.round(self.points[:60], 3).astype("f4").astype(float)
        corners[5] = corners[0]
        triangles = np.arange(60).reshape(-1, 3)
        distinct = len(np.unique(corners, axis=0))
        mesh = meshio.Mesh(corners, [("triangle", triangles)])
        for name, count, options in (("m.obj", 60, {}), ("text.stl", distinct, {"binary": False}),
                                     ("binary.stl", distinct, {"binary": True})):
            with self.subTest(name=name):
                meshio.write(self.path(name), mesh, **options)
                said = self.mgdt("info", name).decode()
                self.assertRegex(said, rf"points +{count}\n")
                self.mgdt("triangulate", "-q", name, "--canonical", "-o", "of.npy")
                found = np.load(self.path("of.npy"))
                self.mgdt("triangulate", "-q", name, "-o", "of.mesh")
                points = meshio.read(self.path("of.mesh")).points
                self.assertTrue((np.unique(points, axis=0) == np.unique(corners, axis=0)).all())
                self.assertGreater(len(found), distinct)
        self.put("solid.stl", "solid that is binary".ljust(80).encode() + self.get("binary.stl")[80:])
        self.assertRegex(self.mgdt("info", "solid.stl").decode(), rf"points +{distinct}\n")
        self.put("cut.stl", self.get("binary.stl")[:-1])
        self.fails(3, "info", "cut.stl", says="cut short")
        self.put("cut.stl", self.get("text.stl")[:-20])
        self.fails(3, "info", "cut.stl", says="no endsolid")
        self.put("none.obj", "f 1 2 3\n")
        self.fails(3, "info", "none.obj", says="no vertices")
        self.fails(2, "triangulate", "m.obj", "-o", "out.obj", says="no place for tetrahedra")

    def test_points_in_no_tetrahedron_are_left_out(self):
        points = np.concatenate([self.points[:50], self.points[:20], self.points[50:]])
        np.save(self.path("repeats.npy"), points)
        for ending in ("vtu", "vtk", "msh", "mesh", "inp", "ele"):
            with self.subTest(ending=ending):
                self.mgdt("triangulate", "-q", "repeats.npy", "-o", f"r.{ending}", "--point-map", "map.npy")
                name = f"r.{ending}".replace(".ele", ".node")
                mesh = meshio.read(self.path(name))
                point_map = np.load(self.path("map.npy"))
                self.assertEqual(point_map.shape, (320,))
                self.assertTrue((mesh.points[point_map] == points).all())
                self.assertTrue((np.sort(mesh.points, axis=0) == np.sort(self.points, axis=0)).all())
                self.mgdt("check", "-q", f"r.{ending}")
                self.mgdt("triangulate", "-q", "repeats.npy", "-o", f"r.{ending}", "--all-points")
                self.assertTrue((meshio.read(self.path(name)).points == points).all())
        # An .npy has the numbers of the input.
        self.mgdt("triangulate", "-q", "repeats.npy", "-o", "r.npy", "--point-map", "map.npy", "--index-base", 1)
        point_map = np.load(self.path("map.npy")) - 1
        self.assertTrue((points[point_map] == points).all())
        self.assertEqual(set(np.load(self.path("r.npy")).ravel() - 1), set(point_map))
        self.mgdt("triangulate", "-q", "repeats.npy", "--point-map", "alone.npy")
        self.assertTrue((points[np.load(self.path("alone.npy"))] == points).all())
        self.put("flat.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 0\n")
        self.mgdt("triangulate", "-q", "flat.xyz", "-o", "flat.mesh")
        self.assertEqual(len(meshio.read(self.path("flat.mesh")).points), 4)
        self.fails(2, "triangulate", "repeats.npy", "-o", "r.vtu", "--point-map", "r.vtu")
        self.fails(2, "triangulate", "repeats.npy", "-o", "r.vtu", "--point-map", "repeats.npy")

    def test_info_says_what_a_file_is(self):
        for arguments, says in ((["old.msh", "--to", "gmsh2"], "gmsh (version 2.2, ascii)"),
                                (["new.msh"], "gmsh (version 4.1, binary)"), (["m.mesh"], "medit (version 2, text)"),
                                (["m.vtk"], "vtk (version 3.0, text)")):
            self.mgdt("triangulate", "-q", "points.npy", "-o", *arguments)
            self.assertRegex(self.mgdt("info", arguments[0]).decode(), rf"(?m)^format +{re.escape(says)}$")

    def test_what_is_wrong(self):
        head = "MeshVersionFormatted 2\nDimension 3\n"
        for text, line, says in ((head + "Vertices\n2\n0 0 0 0\n", 4, "cut short"),
                                 (head + "Vertices 1\n0 x 0 0\n", 4, "'x'"),
                                 (head + "Vertices 1\n0 0 0 0\nTetrahedra 1\n1 1 1 2 0\nEnd\n", 6, "vertex"),
                                 ("MeshVersionFormatted 2\nDimension 2\n", 2, "dimension 2"),
                                 (head + "Vertices 1 0 0 0 0\n", 3, "no End")):
            with self.subTest(text=text):
                self.put("bad.mesh", text)
                self.fails(3, "info", "bad.mesh", says=(f"line {line}", says))
        nodes = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n"
        for text, line, says in (("*NODE\n1, 0, 0, 0\n1, 1, 0, 0\n", 3, "node 1 comes twice"),
                                 ("*NODE\n1, 0, 0\n2, 1, 0\n3, 0, 1\n4, 1, 1\n", 2, "the line ends"),
                                 (nodes + "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3\n2, 2, 3, 4, 1\n", 7, "the line ends"),
                                 (nodes + "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3,\n", 7, "cut short"),
                                 ("*NODE, SYSTEM=C\n1, 1, 90, 0\n", 1, "rectangular"),
                                 ("*NODE, INPUT=nodes.txt\n", 1, "INPUT"),
                                 ("*NODE\n1, 0, nan, 0\n", 2, "'nan'"),
                                 ("*NODE\n1, 0, 0, 0\n*ELEMENT, TYPE=C3D4\n1, 1, 1, 1, 2\n", 4, "no node 2"),
                                 ("*INCLUDE, INPUT=other.inp\n", 1, "includes")):
            with self.subTest(text=text):
                self.put("bad.inp", text)
                self.fails(3, "info", "bad.inp", says=(f"line {line}", says))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    cli_test.MGDT = os.path.abspath(sys.argv.pop(1))
    unittest.main()
