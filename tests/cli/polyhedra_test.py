#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Files of mgdt voronoi, surface and hull, as VTK and meshio read them.

Usage: polyhedra_test.py MGDT [unittest arguments]
"""

import csv
import os
import sys
import unittest

sys.dont_write_bytecode = True  # the source tree stays as it is
import cli_test
import meshio
import numpy as np
from cli_test import CliTest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader


def volume_of(faces):
    """The volume within polygons that are counter-clockwise seen from outside."""
    o = faces[0][0]
    cone = lambda p, k: np.dot(np.cross(p[0] - o, p[k] - o), p[k + 1] - o)
    return sum(cone(p, k) for p in faces for k in range(1, len(p) - 1)) / 6


class Polyhedra(CliTest):
    def cells_of(self, name):
        """The faces of each polyhedron as VTK reads it, and its cell data."""
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(self.path(name))
        reader.Update()
        grid = reader.GetOutput()
        points = vtk_to_numpy(grid.GetPoints().GetData())
        cells = []
        for i in range(grid.GetNumberOfCells()):
            cell = grid.GetCell(i)
            self.assertEqual(grid.GetCellType(i), 42)
            cells.append([])
            for k in range(cell.GetNumberOfFaces()):
                face = cell.GetFace(k)  # one object, which the next face overwrites
                cells[-1].append(points[[face.GetPointId(j) for j in range(face.GetNumberOfPoints())]])
            corners = {tuple(p) for face in cells[-1] for p in face}
            self.assertEqual(len(corners), cell.GetNumberOfPoints())
        data = grid.GetCellData()
        return cells, {name: vtk_to_numpy(data.GetArray(name)) for name in ("point", "volume", "area", "faces")}

    def check(self, kind, count, *options):
        self.mgdt("generate", "-q", kind, count, "-o", "p.npy")
        self.mgdt("voronoi", "p.npy", "-q", "-o", "c.vtu", "--csv", "c.csv", *options)
        cells, data = self.cells_of("c.vtu")
        rows = list(csv.DictReader(self.get("c.csv").decode().splitlines()))
        bounded = [int(r["point"]) for r in rows if float(r["volume"]) < np.inf and int(r["faces"]) > 0]
        self.assertEqual(sorted(data["point"]), bounded)
        for i, faces in zip(data["point"], cells):
            self.assertEqual(len(faces), int(rows[i]["faces"]))
            self.assertLess(abs(volume_of(faces) - float(rows[i]["volume"])), 1e-9 * float(rows[i]["volume"]))
        for name in ("volume", "area", "faces"):
            self.assertEqual(list(data[name]), [float(rows[i][name]) for i in data["point"]])
        return cells, data

    def test_vtk(self):
        for kind, count, options in (("uniform", 600, ("--bounds", "auto")), ("lattice", 216, ("--bounds", "auto")),
                                     ("uniform", 300, ()), ("lattice", 125, ("--compress",)),
                                     ("spiral", 200, ("--bounds=-9,-9,-9,9,9,9", "--compress"))):
            with self.subTest(kind=kind, options=options):
                cells, _ = self.check(kind, count, *options)
                self.assertGreater(len(cells), 20)

    def test_meshio(self):
        _, data = self.check("uniform", 400, "--bounds", "auto")
        mesh = meshio.read(self.path("c.vtu"))
        self.assertEqual(sum(len(block.data) for block in mesh.cells), 400)
        volumes = dict(zip(data["point"], data["volume"]))
        for block, points, measured in zip(mesh.cells, mesh.cell_data["point"], mesh.cell_data["volume"]):
            self.assertTrue(block.type.startswith("polyhedron"))
            for cell, point, volume in zip(block.data, points, measured):
                self.assertEqual(volume, volumes[point])
                self.assertLess(abs(volume_of([mesh.points[f] for f in cell]) - volume), 1e-9 * volume)


class Surfaces(CliTest):
    @staticmethod
    def triangles(points, corners):
        return sorted(map(tuple, np.asarray(points)[np.asarray(corners)].reshape(-1, 9).tolist()))

    def by_vtk(self, reader, name):
        reader.SetFileName(self.path(name))
        reader.Update()
        surface = reader.GetOutput()
        self.assertEqual(surface.GetNumberOfPolys(), surface.GetNumberOfCells())
        connectivity = vtk_to_numpy(surface.GetPolys().GetConnectivityArray())
        return self.triangles(vtk_to_numpy(surface.GetPoints().GetData()), connectivity.reshape(-1, 3))

    def by_meshio(self, name):
        mesh = meshio.read(self.path(name))
        self.assertEqual([block.type for block in mesh.cells], ["triangle"])
        return self.triangles(mesh.points, mesh.cells[0].data)

    def test_every_reader(self):
        self.mgdt("generate", "-q", "galaxy", 2000, "-o", "p.npy")
        for command in (("hull",), ("surface", "--alpha", 0.1)):
            for ending in ("ply", "stl", "off", "obj", "vtp"):
                self.mgdt(*command, "-q", "p.npy", "-o", "s." + ending)
            expected = self.by_vtk(vtkXMLPolyDataReader(), "s.vtp")
            self.assertGreater(len(expected), 50)
            self.mgdt(command[0], "-q", "p.npy", "-o", "z.vtp", "--compress", *command[1:])
            self.assertEqual(self.by_vtk(vtkXMLPolyDataReader(), "z.vtp"), expected)
            for ending in ("ply", "off", "obj"):
                self.assertEqual(self.by_meshio("s." + ending), expected, ending)
            near = lambda found: np.abs(np.array(found) - np.array(expected)).max() < 1e-7
            for reader, ending in ((vtkPLYReader(), "ply"), (vtkOBJReader(), "obj")):
                self.assertEqual(len(self.by_vtk(reader, "s." + ending)), len(expected))
            self.assertTrue(near(self.by_vtk(vtkSTLReader(), "s.stl")))
            self.assertTrue(near(self.by_meshio("s.stl")))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    cli_test.MGDT = os.path.abspath(sys.argv.pop(1))
    unittest.main()
