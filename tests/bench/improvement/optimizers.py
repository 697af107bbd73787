# SPDX-License-Identifier: MIT
"""The optimisers that the benchmark of improvements compares: each takes a mesh in a file, and writes another.

usage: optimizers.py NAME INPUT.npz OUTPUT.npz

Each runs in a process of its own, since some end it. The time that is written beside the result is the processor
time of the optimisation alone: without reading, building and writing a mesh.
"""
import ctypes
import os
import re
import subprocess
import sys
import tempfile
import time

import numpy as np


def clock(action):
    begin = time.process_time()
    result = action()
    return time.process_time() - begin, result


def build(mesh):
    import mgdt

    return mgdt.Mesh(mesh["points"], mesh["tetrahedra"], markers=mesh["regions"])


def improve_with_mgdt(mesh, goal=25, **options):
    built = build(mesh)
    seconds, _ = clock(lambda: built.improve(goal, **options))
    return seconds, built.points, built.simplices


def surface(mesh):
    """Faces of the surface and between regions, outwards, with the numbers of their facets and of the regions
    behind and in front; -1 for the outside."""
    built = build(mesh)
    behind, front = built.face_simplices.T
    return built.faces, built.face_facets, *(np.where(s < 0, -1, built.simplex_regions[s]) for s in (behind, front))


def improve_with_gmsh(mesh):
    gmsh = ctypes.CDLL("libgmsh.so.4.8")

    def call(name, *arguments):
        error = ctypes.c_int()
        getattr(gmsh, name)(*arguments, ctypes.byref(error))
        if error.value:
            raise RuntimeError(f"{name} has returned {error.value}")

    faces, facets, _, _ = surface(mesh)
    with tempfile.TemporaryDirectory(prefix="mgdt-gmsh-") as scratch:
        before, after = (os.path.join(scratch, name) for name in ("before.msh", "after.msh"))
        write_gmsh(before, mesh, faces, facets)
        call("gmshInitialize", 0, None, 0)
        for option, value in (("General.Terminal", 0), ("General.NumThreads", 1), ("Mesh.MshFileVersion", 2.2)):
            call("gmshOptionSetNumber", option.encode(), ctypes.c_double(value))
        call("gmshOpen", before.encode())
        # Forced, since it leaves meshes without a geometry alone otherwise.
        seconds, _ = clock(lambda: call("gmshModelMeshOptimize", b"", 1, 1, None, ctypes.c_size_t(0)))
        call("gmshWrite", after.encode())
        from meshes import read_gmsh
        points, tetrahedra, _ = read_gmsh(after)
    return seconds, points, tetrahedra


def write_gmsh(path, mesh, faces, facets):
    with open(path, "w") as file:
        file.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n%d\n" % len(mesh["points"]))
        for i, point in enumerate(mesh["points"]):
            file.write("%d %r %r %r\n" % (i + 1, *point.tolist()))
        file.write("$EndNodes\n$Elements\n%d\n" % (len(faces) + len(mesh["tetrahedra"])))
        number = 0
        for kind, rows, tags in ((2, faces, facets), (4, mesh["tetrahedra"], mesh["regions"])):
            for row, tag in zip(rows.tolist(), tags.tolist()):
                number += 1
                file.write("%d %d 2 %d %d %s\n" % (number, kind, tag + 1, tag + 1, " ".join(str(i + 1) for i in row)))
        file.write("$EndElements\n")


def improve_with_netgen(mesh):
    import netgen.meshing as ng

    faces, facets, behind, front = surface(mesh)
    target = ng.Mesh()
    points = [target.Add(ng.MeshPoint(ng.Pnt(*point))) for point in mesh["points"].tolist()]
    descriptors = {}
    for face, facet, inside, outside in zip(faces.tolist(), facets.tolist(), behind.tolist(), front.tolist()):
        key = facet, inside, outside
        if key not in descriptors:
            descriptors[key] = target.Add(ng.FaceDescriptor(surfnr=facet + 1, domin=inside + 1, domout=outside + 1,
                                                           bc=len(descriptors) + 1))
        target.Add(ng.Element2D(descriptors[key], [points[i] for i in face]))
    # Netgen's tetrahedra have the other orientation.
    regions = np.unique(mesh["regions"], return_inverse=True)[1]
    for (a, b, c, d), region in zip(mesh["tetrahedra"].tolist(), regions.tolist()):
        target.Add(ng.Element3D(region + 1, [points[a], points[b], points[d], points[c]]))
    target.CalcLocalH(0.3)
    seconds, _ = clock(target.OptimizeVolumeMesh)
    after = np.array([point.p for point in target.Points()])
    return seconds, after, np.array([[v.nr - 1 for v in e.vertices] for e in target.Elements3D()])


def improve_with_tetgen(mesh):
    faces, facets, _, _ = surface(mesh)
    with tempfile.TemporaryDirectory(prefix="mgdt-tetgen-") as scratch:
        name = os.path.join(scratch, "mesh")
        write_tetgen(name + ".node", [mesh["points"]], "%d 3 0 0")
        write_tetgen(name + ".ele", [mesh["tetrahedra"], mesh["regions"]], "%d 4 1")
        write_tetgen(name + ".face", [faces, facets + 1], "%d 1")
        # Levels 9 and 7 are the most that it offers. It optimises only what it refines too, so that it gets bounds that
        # are met, and only tetrahedra with an angle above a limit, of which 130 degrees gives the best results.
        run = subprocess.run(["tetgen", "-rYq100/0O9/7o/130", name], capture_output=True, text=True, check=False)
        seconds = re.search(r"[Oo]ptimization seconds:\s*([0-9.eE+-]+)", run.stdout)
        if run.returncode or not seconds:
            raise RuntimeError("tetgen: " + (run.stdout + run.stderr)[-300:])
        points, tetrahedra = (np.loadtxt(name + ".1." + end, skiprows=1, comments="#") for end in ("node", "ele"))
    first = int(points[0, 0])
    return float(seconds.group(1)), points[:, 1:4], tetrahedra[:, 1:5].astype(np.int64) - first


def write_tetgen(path, columns, head):
    table = np.column_stack(columns)
    with open(path, "w") as file:
        file.write(head % len(table) + "\n")
        for i, row in enumerate(table.tolist()):
            file.write("%d %s\n" % (i, " ".join(map(repr, row))))


def improve_with_cgal(mesh):
    """What CGAL has made of a mesh of its own when it made that."""
    return float(mesh["cgal_seconds"]), mesh["cgal_points"], mesh["cgal_tetrahedra"]


PEERS = {"gmsh": improve_with_gmsh, "netgen": improve_with_netgen, "tetgen": improve_with_tetgen,
         "cgal": improve_with_cgal}
# The peers remove points too.
MGDT = {
    "mgdt": {},
    "mgdt-20": {"goal": 20, "keep": "none"},
    "mgdt-25-slide": {"goal": 25, "keep": "none", "slide": True},
    "mgdt-30": {"goal": 30, "keep": "none"},
    "mgdt-30-slide": {"goal": 30, "keep": "none", "slide": True, "mean_passes": 3},
}


def main(name, before, after):
    mesh = dict(np.load(before))
    result = PEERS[name](mesh) if name in PEERS else improve_with_mgdt(mesh, **MGDT[name])
    np.savez(after, **dict(zip(("seconds", "points", "tetrahedra"), result)))


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
