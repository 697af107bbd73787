#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""mgdt interpolate: values at samples in, values at places out, through files of every kind.

Usage: interpolate_test.py MGDT [unittest arguments]
"""

import csv
import math
import os
import random
import struct
import sys
import unittest

sys.dont_write_bytecode = True  # the source tree stays as it is
import cli_test
from cli_test import CliTest


def field(x, y, z):
    return 1 + 2 * x - 3 * y + z


class Interpolate(CliTest):
    def setUp(self):
        super().setUp()
        draw = random.Random(3)
        corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
        self.samples = corners + [tuple(draw.random() for _ in range(3)) for _ in range(200)]
        self.places = [tuple(draw.random() for _ in range(3)) for _ in range(50)]
        self.put("samples.csv", self.table("x,y,z,T,label,twice", self.samples,
                                           lambda *p: f"{field(*p)!r},name,{2 * field(*p)!r}"))
        self.put("places.csv", self.table("x,y,z", self.places, None))

    @staticmethod
    def table(head, points, rest):
        rows = (",".join(map(repr, p)) + ("," + rest(*p) if rest else "") for p in points)
        return "\n".join([head, *rows]) + "\n"

    def rows(self, name):
        return list(csv.DictReader(self.get(name).decode().splitlines()))

    def npy(self, name):
        content = self.get(name)
        length = struct.unpack("<H", content[8:10])[0]
        shape = eval(content[10:10 + length])["shape"]
        numbers = struct.unpack(f"<{shape[0] * shape[1]}d", content[10 + length:])
        return [numbers[i:i + shape[1]] for i in range(0, len(numbers), shape[1])]

    def put_npy(self, name, rows):
        columns = len(rows[0])
        head = f"{{'descr': '<f8', 'fortran_order': False, 'shape': ({len(rows)}, {columns}), }}\n"
        data = struct.pack(f"<{len(rows) * columns}d", *(v for row in rows for v in row))
        return self.put(name, b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head)) + head.encode() + data)

    def close(self, value, place, factor=1):
        self.assertLess(abs(float(value) - factor * field(*place)), 1e-13 * factor)

    def test_every_method_is_exact_for_a_linear_field(self):
        for method in ("linear", "sibson", "laplace", "sibson-c1"):
            self.mgdt("interpolate", "samples.csv", "places.csv", "-o", "out.csv", "--method", method)
            self.assertEqual(self.out, b"208 samples, 50 places, 0 outside: out.csv\n")
            rows = self.rows("out.csv")
            self.assertEqual(list(rows[0]), ["x", "y", "z", "T", "twice"])
            for row, place in zip(rows, self.places, strict=True):
                self.assertEqual(tuple(float(row[k]) for k in "xyz"), place)
                self.close(row["T"], place)
                self.close(row["twice"], place, 2)
        self.mgdt("interpolate", "samples.csv", "places.csv", "-o", "out.csv", "--method", "nearest")
        nearest = [min(self.samples, key=lambda s: math.dist(s, p)) for p in self.places]
        for row, sample in zip(self.rows("out.csv"), nearest, strict=True):
            self.close(row["T"], sample)

    def test_outside(self):
        self.put("far.xyz", "2 0.5 0.5\n0.25 0.5 0.5\n")
        far, at_hull = (2, 0.5, 0.5), (1, 0.5, 0.5)
        self.mgdt("interpolate", "samples.csv", "far.xyz", "-o", "out.csv")
        self.assertIn(b"2 places, 1 outside", self.out)
        self.assertEqual([row["T"] for row in self.rows("out.csv")][0], "nan")
        for outside, expected in ("linear", far), ("boundary", at_hull):
            self.mgdt("interpolate", "samples.csv", "far.xyz", "-o", "out.csv", "--outside", outside)
            self.assertLess(abs(float(self.rows("out.csv")[0]["T"]) - field(*expected)), 1e-12)
        self.mgdt("interpolate", "samples.csv", "far.xyz", "-o", "out.csv", "--outside", "nearest")
        nearest = min(self.samples, key=lambda s: math.dist(s, far))
        self.close(self.rows("out.csv")[0]["T"], nearest)

    def test_from_format_to_format(self):
        """The same values, whatever the files."""
        values = [(field(*p), 2 * field(*p)) for p in self.samples]
        self.put_npy("samples.npy", [p + v for p, v in zip(self.samples, values)])
        self.put_npy("points.npy", self.samples)
        self.put_npy("values.npy", values)
        self.mgdt("interpolate", "-q", "samples.csv", "samples.csv", "-o", "samples.vtu")
        self.mgdt("interpolate", "-q", "samples.csv", "samples.csv", "-o", "samples.txt")
        self.mgdt("interpolate", "-q", "samples.csv", "places.csv", "-o", "expected.npy")
        expected = self.npy("expected.npy")
        self.assertEqual(len(expected[0]), 5)
        for arguments in (["samples.npy"], ["samples.vtu"], ["samples.txt"],
                          ["points.npy", "--values", "values.npy"]):
            self.mgdt("interpolate", "-q", *arguments, "places.csv", "-o", "out.npy")
            self.assertEqual(self.npy("out.npy"), expected, arguments)
        # The places are the nodes of a mesh, which the output has too.
        self.mgdt("triangulate", "-q", "places.csv", "-o", "mesh.vtu")
        self.mgdt("interpolate", "-q", "samples.csv", "mesh.vtu", "-o", "out.vtu", "--fields", "twice")
        self.assertIn(b'Name="twice"', self.get("out.vtu"))
        self.assertNotIn(b'Name="T"', self.get("out.vtu"))
        self.mgdt("check", "-q", "out.vtu")
        # Pipes.
        self.mgdt("interpolate", "-", "places.csv", "--from", "csv", "-o", "-", "--to", "npy",
                  data=self.get("samples.csv"))
        self.put("out.npy", self.out)
        self.assertEqual(self.npy("out.npy"), expected)
        self.mgdt("interpolate", "samples.csv", "-", "--places-from", "csv", "-o", "out.npy", "-q",
                  data=self.get("places.csv"))
        self.assertEqual(self.npy("out.npy"), expected)

    def test_columns(self):
        self.put("s.txt", "".join(f"{field(*p)!r} {p[0]!r} {p[1]!r} {p[2]!r}\n" for p in self.samples))
        self.put("p.txt", "".join(f"7 8 {p[0]!r} {p[1]!r} {p[2]!r}\n" for p in self.places))
        self.mgdt("interpolate", "s.txt", "p.txt", "--columns", "2,3,4", "--places-columns", "3,4,5",
                  "-o", "out.csv", "--threads", 2)
        for row, place in zip(self.rows("out.csv"), self.places, strict=True):
            self.close(row["column1"], place)

    def test_refusals(self):
        self.put("flat.csv", "x,y,z,T\n0,0,0,1\n1,0,0,2\n0,1,0,3\n")
        out = ["-o", "o.csv"]
        self.fails(3, "interpolate", "flat.csv", "places.csv", *out,
                   says=["flat.csv: all points are on a plane", "--method nearest --outside nearest"])
        self.mgdt("interpolate", "-q", "flat.csv", "places.csv", "-o", "near.csv", "--method", "nearest",
                  "--outside", "nearest")
        self.assertNotIn(b"nan", self.get("near.csv"))
        self.fails(3, "interpolate", "places.csv", "places.csv", *out, says="places.csv: no values")
        self.fails(3, "interpolate", "samples.csv", "places.csv", *out, "--fields", "T,p",
                   says=["no field 'p'", "'T'", "'twice'"])
        self.fails(3, "interpolate", "samples.csv", "places.csv", *out, "--fields", "label",
                   says="line 2: column 5: 'name' is not a number")
        self.fails(2, "interpolate", "samples.csv", "places.csv", "-o", "o.ply", says="no place for values")
        self.fails(2, "interpolate", "samples.csv", "places.csv", *out, "--method", "kriging", says="--method")
        self.fails(2, "interpolate", "samples.csv", "places.csv", *out, "--outside", "zero", says="--outside")
        self.fails(2, "interpolate", "-", "-", *out, says="standard input")
        self.fails(2, "interpolate", "samples.csv", "places.csv", says="--output")
        self.fails(2, "interpolate", "samples.csv", *out, says="places")
        for name in "samples.csv", "places.csv":
            self.fails(2, "interpolate", "samples.csv", "places.csv", "-o", name, says="would overwrite")
        self.put_npy("values.npy", [(1.0,)])
        self.fails(3, "interpolate", "samples.csv", "places.csv", *out, "--values", "values.npy",
                   says=["values.npy: 1 row of values for 208 points in samples.csv"])
        self.put_npy("values.npy", [(1.0,)] * 208)
        self.fails(2, "interpolate", "samples.csv", "places.csv", "-o", "values.npy", "--values",
                   "values.npy", says="would overwrite")
        self.fails(2, "interpolate", "samples.csv", "places.csv", *out, "--values", "values.npy",
                   "--fields", "T", says="--values")
        self.put("bad.xyz", "0 0 nan\n")
        self.fails(3, "interpolate", "samples.csv", "bad.xyz", *out, says="bad.xyz: line 1")
        self.fails(5, "interpolate", "samples.csv", "places.csv", *out, "--memory-limit", "10KB")

    def test_no_places(self):
        self.put("none.csv", "x,y,z\n")
        self.mgdt("interpolate", "samples.csv", "none.csv", "-o", "out.csv")
        self.assertEqual(self.get("out.csv"), b"x,y,z,T,twice\n")
        self.mgdt("interpolate", "samples.csv", "none.csv", "-o", "out.vtu")
        self.mgdt("info", "out.vtu")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    cli_test.MGDT = os.path.abspath(sys.argv.pop(1))
    unittest.main()
