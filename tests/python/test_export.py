# SPDX-License-Identifier: MIT
"""Meshes for meshio, as Debian packages it, and PyVista, which Debian does not."""

import pathlib
import sys
import tempfile
import types
import unittest
from unittest import mock

import numpy as np
from support import random_points

import mgdt


class Export(unittest.TestCase):
    def setUp(self):
        self.tri = mgdt.Delaunay(np.concatenate([random_points(50, 1), random_points(2, 1)]))

    def test_meshio(self):
        import meshio

        mesh = self.tri.to_meshio()
        self.assertIsInstance(mesh, meshio.Mesh)
        np.testing.assert_array_equal(mesh.points, self.tri.points)
        np.testing.assert_array_equal(mesh.cells_dict["tetra"], self.tri.simplices)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "mesh.vtu"
            mesh.write(file)
            again = meshio.read(file)
        np.testing.assert_array_equal(again.points, self.tri.points)
        np.testing.assert_array_equal(again.cells_dict["tetra"], self.tri.simplices)

    def test_pyvista(self):
        # A stand-in with the interface that is used.
        grid = mock.Mock()
        with mock.patch.dict(sys.modules, pyvista=types.SimpleNamespace(UnstructuredGrid=grid)):
            self.assertIs(self.tri.to_pyvista(), grid.return_value)
        (cells, points), keywords = grid.call_args
        self.assertEqual((list(cells), keywords), ([10], {}))
        self.assertIs(cells[10], self.tri.simplices)
        np.testing.assert_array_equal(points, self.tri.points)

    def test_without_them(self):
        for name, call in (("meshio", self.tri.to_meshio), ("pyvista", self.tri.to_pyvista)):
            with mock.patch.dict(sys.modules, {name: None}):
                with self.assertRaisesRegex(ImportError, f"(?i)to_{name} needs {name}"):
                    call()
        with mock.patch.dict(sys.modules, {"scipy.spatial": None}):
            with self.assertRaisesRegex(ImportError, "to_scipy needs SciPy"):
                self.tri.to_scipy()


if __name__ == "__main__":
    unittest.main()
