#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""mgdt triangulate --parts: pieces that together are the one triangulation.

Usage: parts_test.py MGDT [unittest arguments]
"""

import os
import re
import struct
import sys
import unittest

sys.dont_write_bytecode = True  # the source tree stays as it is
import cli_test
import meshio
from cli_test import CliTest


class Pieces(CliTest):
    """What is in files of pieces."""

    def pieces(self, name):
        """The names in a .pvtu file, and the pieces as meshio reads them, which knows none without cells."""
        text = self.get(name).decode()
        names = re.findall(r'<Piece Source="([^"]*)"/>', text)
        self.assertEqual(names, [name.replace(".pvtu", f"_{i}.vtu") for i in range(len(names))])
        return names, [meshio.read(self.path(n)) for n in names if b'NumberOfCells="0"' not in self.get(n)]

    def tetrahedra(self, pieces):
        found = []
        for piece in pieces:
            points = piece.point_data["point"]
            for block in piece.cells:
                self.assertEqual(block.type, "tetra")
                found += [tuple(sorted(points[list(v)])) for v in block.data]
        return sorted(found)

    def expected(self, name):
        self.mgdt("triangulate", "-q", name, "-o", "one.npy")
        content = self.get("one.npy")
        length = struct.unpack("<H", content[8:10])[0]
        numbers = struct.unpack(f"<{(len(content) - 10 - length) // 8}q", content[10 + length:])
        return sorted(tuple(sorted(numbers[i:i + 4])) for i in range(0, len(numbers), 4))


class Parts(Pieces):
    def test_pieces_are_the_one_triangulation(self):
        for kind, count, parts in (("uniform", 3000, 7), ("lattice", 1000, 4), ("spiral", 2000, 16),
                                   ("uniform", 20, 100), ("uniform", 500, 1)):
            with self.subTest(kind=kind, count=count, parts=parts):
                self.mgdt("generate", "-q", kind, str(count), "-o", "points.npy")
                said = self.mgdt("triangulate", "points.npy", "--parts", str(parts), "-o", "out.pvtu").decode()
                self.assertIn(f"{parts} part", said)
                names, pieces = self.pieces("out.pvtu")
                self.assertEqual(len(names), parts)
                self.assertEqual(self.tetrahedra(pieces), self.expected("points.npy"))

    def test_no_tetrahedra(self):
        self.put("flat.xyz", "".join(f"{i % 7} {i // 7} 0\n" for i in range(40)))
        self.mgdt("triangulate", "flat.xyz", "--parts", "3", "-o", "flat.pvtu")
        self.assertEqual(self.pieces("flat.pvtu")[1], [])

    def test_fewer_parts_leave_no_pieces(self):
        """Those of the file that is written anew, and no others."""
        self.mgdt("generate", "-q", "uniform", "2000", "-o", "p.npy")
        for name in ("a.pvtu", "a&b.pvtu"):
            stem = name[:-5]
            self.mgdt("triangulate", "-q", "p.npy", "--parts", "4", "-o", name)
            for other in (f"{stem}_7.vtu", f"{stem}_x.vtu", f"b{stem}_3.vtu"):
                self.put(other, "of somebody else")
            self.mgdt("triangulate", "-q", "p.npy", "--parts", "2", "-o", name)
            made = sorted(n for n in self.names() if n.startswith(stem + "_"))
            self.assertEqual(made, [f"{stem}_0.vtu", f"{stem}_1.vtu", f"{stem}_7.vtu", f"{stem}_x.vtu"])
            self.assertIn(f"b{stem}_3.vtu", self.names())
            os.remove(self.path(f"{stem}_x.vtu"))
        # An index that names what it should not.
        self.put("c.pvtu", '<Piece Source="../p.npy"/><Piece Source="c_9.vtu"/><Piece Source="c_09.vtu"/><Piece Source="c_5.vtu')
        for n in ("c_9.vtu", "c_09.vtu", "c_5.vtu"):
            self.put(n, "")
        self.mgdt("triangulate", "-q", "p.npy", "--parts", "2", "-o", "c.pvtu")
        made = sorted(n for n in self.names() if n.startswith("c_"))
        self.assertEqual(made, ["c_0.vtu", "c_09.vtu", "c_1.vtu", "c_5.vtu"])

    def test_a_name_that_xml_has_other_words_for(self):
        self.put("points.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n")
        self.mgdt("triangulate", "points.xyz", "--parts", "1", "-o", "a&b.pvtu")
        self.assertIn(b'Source="a&amp;b_0.vtu"', self.get("a&b.pvtu"))

    def test_wrong_usage(self):
        self.put("points.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n")
        for arguments in (["-o", "out.vtu"], [], ["-o", "out.pvtu", "--stats"], ["-o", "out.pvtu", "--to", "vtu"],
                          ["-o", "out.pvtu", "--neighbors", "n.npy"], ["-o", "out.pvtu", "--check", "1"]):
            with self.subTest(arguments=arguments):
                self.fails(2, "triangulate", "points.xyz", "--parts", "2", *arguments)
        self.fails(2, "triangulate", "points.xyz", "--parts", "0", "-o", "out.pvtu")
        self.put("out_1.vtu", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n")
        self.fails(2, "triangulate", "--from", "xyz", "out_1.vtu", "--parts", "2", "-o", "out.pvtu")
        self.assertEqual(self.get("out_1.vtu")[:5], b"0 0 0")

    def test_failures_leave_nothing(self):
        self.put("bad.xyz", "0 0 0\n1 0 0\n0 nan 0\n0 0 1\n")
        self.fails(3, "triangulate", "bad.xyz", "--parts", "2", "-o", "bad.pvtu")
        self.mgdt("generate", "-q", "uniform", "20000", "-o", "points.npy")
        self.fails(5, "triangulate", "points.npy", "--parts", "2", "-o", "small.pvtu", "--memory-limit", "2MB")
        self.fails(4, "triangulate", "points.npy", "--parts", "2", "-o", "nowhere/out.pvtu")
        self.assertEqual(sorted(self.names()), ["bad.xyz", "points.npy"])


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    cli_test.MGDT = os.path.abspath(sys.argv.pop(1))
    unittest.main()
