#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes machine.msh and church.msh from their .geo files with Gmsh (Debian package gmsh).

The meshes are in the repository, so this is needed only after a change of a geometry. Gmsh's own
output is packed: only tetrahedra and the nodes that they use, elements without tags, in the binary
MSH 2.2 format, which Gmsh opens as it does its own.

usage: mesh.py [NAME ...]
"""
import os
import subprocess
import sys
import tempfile

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
SIZE_LIMIT = 2_000_000  # bytes a file, to keep clones small
TETRAHEDRON = 4  # Gmsh's element type


def read_ascii(path):
    """Nodes and tetrahedra (indices from 0) of a text file in format 2.2."""
    with open(path) as f:
        lines = f.read().split("\n")
    start = lines.index("$Nodes")
    n = int(lines[start + 1])
    table = np.array([line.split() for line in lines[start + 2 : start + 2 + n]], dtype=float)
    number = {int(tag): i for i, tag in enumerate(table[:, 0])}
    start = lines.index("$Elements")
    n = int(lines[start + 1])
    tetrahedra = []
    for line in lines[start + 2 : start + 2 + n]:
        fields = [int(x) for x in line.split()]
        if fields[1] == TETRAHEDRON:
            tetrahedra.append([number[tag] for tag in fields[-4:]])
    return table[:, 1:4], np.array(tetrahedra)


def write_packed(path, nodes, tetrahedra):
    node = np.zeros(len(nodes), dtype=[("tag", "<i4"), ("xyz", "<f8", 3)])
    node["tag"] = np.arange(1, len(nodes) + 1)
    node["xyz"] = nodes
    element = np.zeros(len(tetrahedra), dtype=[("tag", "<i4"), ("nodes", "<i4", 4)])
    element["tag"] = np.arange(1, len(tetrahedra) + 1)
    element["nodes"] = tetrahedra + 1
    with open(path, "wb") as f:
        f.write(b"$MeshFormat\n2.2 1 8\n" + np.int32(1).astype("<i4").tobytes())
        f.write(b"\n$EndMeshFormat\n$Nodes\n%d\n" % len(nodes) + node.tobytes())
        f.write(b"\n$EndNodes\n$Elements\n%d\n" % len(tetrahedra))
        f.write(np.array([TETRAHEDRON, len(tetrahedra), 0], dtype="<i4").tobytes())
        f.write(element.tobytes() + b"\n$EndElements\n")


def main(names):
    for name in names or ["machine", "church"]:
        with tempfile.TemporaryDirectory() as scratch:
            text = os.path.join(scratch, name + ".msh")
            command = ["gmsh", "-3", os.path.join(HERE, name + ".geo"), "-o", text]
            command += ["-format", "msh22", "-v", "2"]
            subprocess.run(command, check=True)
            nodes, tetrahedra = read_ascii(text)
        used = np.unique(tetrahedra)
        tetrahedra = np.searchsorted(used, tetrahedra)
        path = os.path.join(HERE, name + ".msh")
        write_packed(path, nodes[used], tetrahedra)
        size = os.path.getsize(path)
        print(f"{path}: {len(used)} nodes, {len(tetrahedra)} tetrahedra, {size} bytes")
        if size > SIZE_LIMIT:
            sys.exit(f"mesh.py: {path} is larger than {SIZE_LIMIT} bytes: coarsen {name}.geo")


if __name__ == "__main__":
    main(sys.argv[1:])
