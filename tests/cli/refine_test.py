#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""mgdt refine, and mgdt mesh with sizes.

Usage: refine_test.py MGDT [unittest arguments]
"""

import os
import re
import struct
import sys
import unittest

sys.dont_write_bytecode = True  # the source tree stays as it is
import cli_test
import improve_test
from cli_test import CliTest


def box(n):
    """The surface of a cube of side 2 as squares, n by n on each side."""
    points, faces, number = [], [], {}

    def at(*p):
        if p not in number:
            number[p] = len(points)
            points.append(p)
        return number[p]

    for axis in range(3):
        for level in (0, n):
            for i in range(n):
                for j in range(n):
                    square = []
                    for u, v in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                        place = [0, 0, 0]
                        place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3] = level, u, v
                        square.append(at(*place))
                    faces.append(square if level else square[::-1])
    rows = ["OFF", f"{len(points)} {len(faces)} 0"]
    rows += [" ".join(str(2 * c / n) for c in p) for p in points]
    rows += ["4 " + " ".join(map(str, face)) for face in faces]
    return "\n".join(rows + [""])


def npy(values, columns=1):
    shape = f"({len(values)},)" if columns == 1 else f"({len(values) // columns}, {columns})"
    header = "{'descr': '<f8', 'fortran_order': False, 'shape': %s, }" % shape
    header = header.ljust((len(header) + 11 + 63) // 64 * 64 - 11) + "\n"
    return (b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode() +
            struct.pack(f"<{len(values)}d", *values))


def inserted(said):
    return int(re.search(r"(\d+) points? inserted", said).group(1))


def least_angle(said):
    return float(re.search(r"before, ([\d.]+) to", said).group(1))


class RefineTest(CliTest):
    def setUp(self):
        super().setUp()
        self.put("box.off", box(6))

    def test_a_surface_with_a_size(self):
        said = self.mgdt("mesh", "box.off", "-o", "a.inp", "--size", "0.33", "--keep-surface", "--check").decode()
        self.assertGreater(inserted(said), 100)
        self.assertGreaterEqual(least_angle(said), 20)
        self.assertIn("checked", said)
        twice = self.mgdt("mesh", "box.off", "-o", "b.inp", "--size", "0.33", "--keep-surface",
                          "--threads", "2").decode()
        self.assertEqual(self.get("a.inp"), self.get("b.inp"))
        self.assertEqual(inserted(twice), inserted(said))
        said = self.mgdt("mesh", "box.off", "-o", "c.vtu", "--size", "0.33", "--no-improve").decode()
        self.assertNotIn("dihedral", said)
        said = self.mgdt("mesh", "box.off", "-o", "c.vtu", "--surface-sizes", "--gradation", "0.2", "--goal", "10",
                         "--most-points", "100").decode()
        self.assertEqual(inserted(said), 100)
        self.assertIn("for the most points", said)
        said = self.mgdt("mesh", "box.off", "-o", "c.vtu", "--volume", "0.005", "--radius-edge", "0", "--check").decode()
        self.assertGreater(inserted(said), 100)

    def test_regions(self):
        said = self.mgdt("mesh", "box.off", "-o", "c.vtu", "--region", "1,1,1,7", "--region-size", "7,0.2").decode()
        self.assertGreater(inserted(said), 500)
        self.fails(2, "mesh", "box.off", "-o", "c.vtu", "--region-size", "8,0.2", says="no region has the marker 8")
        self.fails(2, "mesh", "box.off", "-o", "c.vtu", "--region-size", "8", says="2 numbers")

    def test_a_size_field(self):
        field = [0, 0, 0, 0.1, 2, 0, 0, 0.5, 0, 2, 0, 0.5, 0, 0, 2, 0.5, 2, 2, 2, 0.5]
        self.put("field.npy", npy(field, 4))
        said = self.mgdt("mesh", "box.off", "-o", "c.vtu", "--size-field", "field.npy", "--check").decode()
        self.assertGreater(inserted(said), 40)
        self.assertIn("dihedral", said)
        self.fails(3, "mesh", "box.off", "-o", "d.vtu", "--size-field", "box.off", says="box.off")
        self.put("flat.npy", npy(field[:18], 3))
        self.fails(3, "mesh", "box.off", "-o", "d.vtu", "--size-field", "flat.npy", says="3 columns")
        self.put("zero.npy", npy(field[:19] + [0], 4))
        self.fails(3, "mesh", "box.off", "-o", "d.vtu", "--size-field", "zero.npy", says="size 4 is 0")

    def test_a_mesh_of_others(self):
        self.put("a.mesh", improve_test.medit())
        count = len(improve_test.TETRAHEDRA)
        said = self.mgdt("refine", "a.mesh", "-o", "b.mesh", "--size", "0.7", "--check").decode()
        self.assertGreater(inserted(said), 50)
        text = self.get("b.mesh").decode()
        self.assertIn(" 77\n", text)
        self.assertEqual(len(set(re.findall(r"(?<=\n)\d+ \d+ \d+ \d+ (-?\d+)(?=\n)", text))), 2)
        said = self.mgdt("refine", "a.mesh", "-o", "b.vtu", "--region-size", "3,0.6", "--improve", "--goal", "15",
                         "--check").decode()
        self.assertGreaterEqual(least_angle(said), 15)
        self.put("sizes.npy", npy([0.4] + [0] * (count - 1)))
        of_one = inserted(self.mgdt("refine", "a.mesh", "-o", "b.vtu", "--sizes", "sizes.npy").decode())
        self.put("points.npy", npy([0.8] * len(improve_test.POINTS)))
        of_points = inserted(self.mgdt("refine", "a.mesh", "-o", "b.vtu", "--sizes", "points.npy").decode())
        self.assertGreater(of_one, 0)
        self.assertGreater(of_points, 0)
        self.put("few.npy", npy([1, 2, 3]))
        self.fails(3, "refine", "a.mesh", "-o", "b.vtu", "--sizes", "few.npy", says="3 sizes; the mesh has")
        self.put("bad.npy", npy([float("nan")] * count))
        self.fails(3, "refine", "a.mesh", "-o", "b.vtu", "--sizes", "bad.npy", says="size 0 is")

    def test_what_is_refused(self):
        self.put("a.mesh", improve_test.medit())
        self.put("p.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n")
        self.fails(3, "refine", "p.xyz", "-o", "o.vtu", "--size", "1", says="there are no tetrahedra")
        self.fails(5, "refine", "a.mesh", "-o", "o.vtu", "--size", "1e-9", says="the sizes would take about")
        self.fails(2, "refine", "a.mesh", "-o", "o.vtu", "--size", "-1", says="--size")
        self.fails(2, "refine", "a.mesh", "-o", "o.vtu", "--size", "nan", says="--size")
        self.fails(2, "refine", "a.mesh", "-o", "o.vtu", "--goal", "20", says="--improve")
        self.fails(2, "mesh", "box.off", "-o", "o.vtu", "--goal", "20", says="--improve")
        self.fails(2, "mesh", "box.off", "-o", "o.vtu", "--improve", "--no-improve", says="--no-improve")
        self.fails(5, "refine", "a.mesh", "-o", "o.vtu", "--size", "0.1", "--memory-limit", "200000B", says="memory")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    cli_test.MGDT = os.path.abspath(sys.argv.pop(1))
    unittest.main()
