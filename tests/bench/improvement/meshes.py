# SPDX-License-Identifier: MIT
"""The meshes that the benchmark of improvements starts from, all as their generators leave them without an optimiser.

Gmsh makes most of them: of the repository's geometries, of simple solids, and of the demonstrations in the Debian
package gmsh-doc. Others are Delaunay triangulations of points. CGAL, which optimises only what it has meshed, makes a
few itself, and their optimised meshes come along.
"""
import contextlib
import functools
import glob
import gzip
import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
DEMOS = "/usr/share/doc/gmsh-doc/doc/gmsh/demos"
GMSH = ["gmsh", "-3", "-nt", "1", "-v", "1", "-format", "msh22", "-setnumber", "Mesh.Optimize", "0"]

CGAL_HEADER = "/usr/include/CGAL/perturb_mesh_3.h"

SOLIDS = {
    "cube": "Box(1) = {0, 0, 0, 1, 1, 1};",
    "ball": "Sphere(1) = {0, 0, 0, 0.6};",
    "torus": "Torus(1) = {0, 0, 0, 0.8, 0.25};",
    "wedge": "Wedge(1) = {0, 0, 0, 1, 1, 1, 0.5};",
    "drilled boxes": "Box(1) = {0, 0, 0, 1, 1, 0.5}; Box(2) = {0, 0, 0.5, 1, 1, 0.5}; "
                     "Cylinder(3) = {0.5, 0.5, -1, 0, 0, 3, 0.2}; "
                     "BooleanFragments{ Volume{1, 2}; Delete; }{ Volume{3}; Delete; }",
}

# Demonstrations that Gmsh meshes with at least a thousand tetrahedra, and with tetrahedra alone.
DEMONSTRATIONS = ["boolean/" + name for name in (
    "baffles boolean chamfer compsolid2 extrude fillet fillet4 fillet_chamfer neuron periodic pipe primitives "
    "revolve simple4 simple5 slicer thicksolid thrusections twist").split()]
DEMONSTRATIONS += ["simple_geo/" + name for name in "cone filter homology indheat piece".split()]


def read_gmsh(path):
    """The points, tetrahedra and regions that Gmsh has written; None if it has made other elements, or none."""
    import meshio

    with contextlib.redirect_stdout(sys.stderr):
        mesh = meshio.read(path)
    kinds = {block.type for block in mesh.cells}
    if "tetra" not in kinds or kinds & {"hexahedron", "wedge", "pyramid"}:
        return None
    tetrahedra = np.concatenate([block.data for block in mesh.cells if block.type == "tetra"])
    regions = np.concatenate([tags for block, tags in zip(mesh.cells, mesh.cell_data["gmsh:geometrical"])
                              if block.type == "tetra"])
    used, rows = np.unique(tetrahedra, return_inverse=True)
    return mesh.points[used], rows.reshape(-1, 4), regions.astype(np.int32)


def mesh_geometry(geometry, size=None, seconds=120):
    """What Gmsh makes of a geometry, in a copy of its folder, since some read files beside them."""
    with tempfile.TemporaryDirectory(prefix="mgdt-meshes-") as scratch:
        for path in glob.glob(os.path.join(os.path.dirname(geometry), "*")):
            if os.path.isfile(path) and path.endswith(".gz"):
                with gzip.open(path) as packed, open(os.path.join(scratch, os.path.basename(path)[:-3]), "wb") as plain:
                    shutil.copyfileobj(packed, plain)
            elif os.path.isfile(path):
                shutil.copy(path, scratch)
        name, mesh = os.path.basename(geometry), os.path.join(scratch, "mesh.msh")
        sizes = [] if size is None else ["-clmin", str(size), "-clmax", str(size)]
        subprocess.run([*GMSH, *sizes, name, "-o", mesh], cwd=scratch, capture_output=True, timeout=seconds, check=False)
        return read_gmsh(mesh) if os.path.exists(mesh) else None


def solid(text, tetrahedra):
    """A simple solid with about so many tetrahedra."""
    with tempfile.TemporaryDirectory(prefix="mgdt-meshes-") as scratch:
        path = os.path.join(scratch, "solid.geo")
        with open(path, "w") as file:
            file.write('SetFactory("OpenCASCADE");\n' + text + "\n")
        size = 2.1 * tetrahedra ** (-1 / 3)
        return mesh_geometry(path, size, 1000)


def delaunay(points):
    import mgdt

    tri = mgdt.Delaunay(points)
    return tri.points, tri.simplices, None


def moved_lattice(n):
    steps = np.stack(np.meshgrid(*[np.arange(n)] * 3, indexing="ij"), -1).reshape(-1, 3).astype(float)
    moves = np.random.default_rng(1).uniform(-0.3, 0.3, steps.shape)
    # Points of the surface stay on it.
    moves[(steps == 0) | (steps == n - 1)] = 0
    return delaunay(steps + moves)


def random_points_in_cube(n):
    rng = np.random.default_rng(2)
    k = int(round((n / 8) ** (1 / 3)))
    grid = np.stack(np.meshgrid(*[np.arange(k + 1) / k] * 3, indexing="ij"), -1).reshape(-1, 3)
    surface = grid[((grid == 0) | (grid == 1)).any(1)]
    return delaunay(np.concatenate([surface, rng.uniform(0.02, 0.98, (n, 3))]))


@functools.lru_cache(maxsize=None)
def cgal_program():
    """The program that meshes with CGAL, and its folder, which lives as long as this process."""
    folder = tempfile.TemporaryDirectory(prefix="mgdt-cgal-")
    source = os.path.join(os.path.dirname(os.path.abspath(__file__)), "cgal_mesh.cpp")
    program = os.path.join(folder.name, "cgal_mesh")
    subprocess.run(["g++", "-O2", "-DNDEBUG", "-std=c++17", "-frounding-math", source, "-o", program, "-lmpfr", "-lgmp"],
                   check=True)
    return folder, program


def cgal_mesh(shape, volume, tetrahedra):
    """A mesh of CGAL's with about so many tetrahedra, and what its optimisers make of it."""
    _, program = cgal_program()
    # Of a tetrahedron with circumradius 1, the volume is half of that of the regular one, on average.
    size = (volume / tetrahedra / 0.25) ** (1 / 3)
    with tempfile.TemporaryDirectory(prefix="mgdt-meshes-") as scratch:
        files = [os.path.join(scratch, name) for name in ("before", "after")]
        run = subprocess.run([program, shape, str(size), *files], capture_output=True, text=True, check=True, timeout=1000)
        (points, corners), (better_points, better_corners) = map(read_counted, files)
    return points, corners, None, {"cgal_points": better_points, "cgal_tetrahedra": better_corners,
                                   "cgal_seconds": float(run.stdout)}


def read_counted(path):
    with open(path) as file:
        points, _ = map(int, file.readline().split())
        rows = file.readlines()
    return np.loadtxt(rows[:points]), np.loadtxt(rows[points:], dtype=np.int64)


def all_meshes(tetrahedra):
    """Names, and functions that make the meshes."""
    meshes = {}
    for name, text in SOLIDS.items():
        meshes[name] = lambda text=text: solid(text, tetrahedra)
    meshes["machine"] = lambda: mesh_geometry(os.path.join(ROOT, "docs/data/machine.geo"))
    meshes["church"] = lambda: mesh_geometry(os.path.join(ROOT, "docs/data/church.geo"))
    side = int((tetrahedra / 6) ** (1 / 3)) + 1
    meshes["moved lattice"] = lambda: moved_lattice(side)
    meshes["random points"] = lambda: random_points_in_cube(tetrahedra // 10)
    if shutil.which("g++") and os.path.exists(CGAL_HEADER):
        for shape, volume in (("ball", 0.90), ("torus", 0.99), ("balls", 0.49)):
            meshes["CGAL " + shape] = lambda shape=shape, volume=volume: cgal_mesh(shape, volume, tetrahedra)
    for name in DEMONSTRATIONS:
        found = sorted(glob.glob(os.path.join(DEMOS, name + ".geo*")))
        if found:
            meshes[os.path.basename(name)] = lambda name=name, path=found[0]: demonstration(path)
    return meshes


def demonstration(path):
    if not path.endswith(".gz"):
        return mesh_geometry(path)
    with tempfile.TemporaryDirectory(prefix="mgdt-meshes-") as scratch:
        plain = os.path.join(scratch, os.path.basename(path)[:-3])
        with gzip.open(path) as packed, open(plain, "wb") as file:
            shutil.copyfileobj(packed, file)
        return mesh_geometry(plain)
