#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""mgdt check on the meshes of TetGen, Qhull (SciPy) and CGAL: what is a Delaunay triangulation
passes, whatever the order, the orientation and the index base; what is none is refused with what is
wrong and where.

Usage: foreign_meshes_test.py MGDT CGAL_MESH [unittest arguments]
"""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import meshio
import numpy as np
from scipy.spatial import Delaunay

MGDT = CGAL_MESH = ""


def uniform(n, seed=1):
    # Few digits, so that programs that write fewer than 17 lose nothing.
    return np.round(np.random.default_rng(seed).random((n, 3)), 9)


def lattice(n):
    return np.stack(np.meshgrid(*[np.arange(float(n))] * 3, indexing="ij"), -1).reshape(-1, 3)


def volumes(points, cells):
    a, b, c, d = (points[cells[:, i]] for i in range(4))
    return np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a)


class ForeignTest(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.mkdtemp(prefix="mgdt-foreign-")
        self.addCleanup(shutil.rmtree, self.directory)

    def path(self, name):
        return os.path.join(self.directory, name)

    def check(self, *arguments, code=0):
        done = subprocess.run([MGDT, "check", *map(str, arguments)], cwd=self.directory, timeout=300,
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def passes(self, *arguments, says="a valid Delaunay triangulation"):
        self.assertIn(says, self.check(*arguments))

    def refused(self, *arguments, says):
        """With exit status 1, and one line that names the first defect."""
        said = self.check(*arguments, code=1)
        self.assertIn("not a Delaunay triangulation of its points: " + says, said)
        return said

    def pair(self, points, cells, base=0, dtype=np.int64):
        np.save(self.path("p.npy"), points)
        np.save(self.path("t.npy"), (np.asarray(cells) + base).astype(dtype))
        return "t.npy", "--points", "p.npy", "--index-base", base

    def qhull(self, points):
        """Positive tetrahedra of a set in general position."""
        cells = Delaunay(points).simplices.astype(np.int64)
        turned = volumes(points, cells) < 0
        cells[turned, 2:] = cells[turned, 3:1:-1]
        return cells


class TetGen(ForeignTest):
    def tetgen(self, points, *options):
        with open(self.path("m.node"), "w") as f:
            f.write(f"{len(points)} 3 0 0\n")
            f.writelines(f"{i} {x!r} {y!r} {z!r}\n" for i, (x, y, z) in enumerate(points.tolist()))
        done = subprocess.run(["tetgen", *options, "m.node"], cwd=self.directory, timeout=300,
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        return "m.1.ele"

    def test_uniform(self):
        self.passes(self.tetgen(uniform(2000)), says="the canonical one")

    def test_lattice_and_neighbours(self):
        self.passes(self.tetgen(lattice(6), "-n"), says="neighbours")

    def test_from_one(self):
        # The first number of the input, 1, becomes the base of the output.
        points = uniform(100)
        with open(self.path("m.node"), "w") as f:
            f.write("100 3 0 0\n")
            f.writelines(f"{i + 1} {x!r} {y!r} {z!r}\n" for i, (x, y, z) in enumerate(points.tolist()))
        subprocess.run(["tetgen", "m.node"], cwd=self.directory, check=True, capture_output=True)
        self.passes("m.1.ele")

    def test_repeats_share_a_vertex(self):
        self.passes(self.tetgen(np.concatenate([uniform(200), uniform(200)[:20]]), "-J"))

    def constrained(self, *options):
        """A box with a square notch, whose facets the mesh has to respect."""
        outline = [(0, 0), (4, 0), (4, 4), (3, 4), (3, 1), (1, 1), (1, 4), (0, 4)]
        n = len(outline)
        with open(self.path("u.poly"), "w") as f:
            f.write(f"{2 * n} 3 0 0\n")
            for k in range(2 * n):
                x, y = outline[k % n]
                f.write(f"{k} {x} {y} {k // n}\n")
            f.write(f"{n + 2} 0\n")
            for z in range(2):
                f.write(f"1\n{n} " + " ".join(str(k + z * n) for k in range(n)) + "\n")
            for k in range(n):
                a, b = k, (k + 1) % n
                f.write(f"1\n4 {a} {b} {b + n} {a + n}\n")
            f.write("0\n")
        done = subprocess.run(["tetgen", *options, "u.poly"], cwd=self.directory,
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        return "u.1.ele"

    def test_domain_that_is_not_convex(self):
        self.refused(self.constrained("-pY"), says="hull: the boundary is concave at")

    def test_refined_for_quality(self):
        self.refused(self.constrained("-pq1.4a0.05"), says="")


class Qhull(ForeignTest):
    def test_uniform_in_every_convention(self):
        points = uniform(500)
        cells = self.qhull(points)
        self.passes(*self.pair(points, cells), says="the canonical one")
        for base, dtype in [(1, np.int32), (0, np.int32), (1, np.int64)]:
            self.passes(*self.pair(points, cells, base, dtype))
        self.passes(*self.pair(points, cells[:, [1, 0, 2, 3]]), says="negatively oriented")
        # Rows and, by even permutations, columns in any order; points too.
        random = np.random.default_rng(5)
        shuffled = random.permutation(cells)
        even = np.array([[0, 1, 2, 3], [1, 2, 0, 3], [3, 2, 1, 0], [1, 0, 3, 2]])
        shuffled = np.take_along_axis(shuffled, even[random.integers(4, size=len(cells))], axis=1)
        self.passes(*self.pair(points, shuffled), says="the canonical one")
        order = random.permutation(len(points))
        self.passes(*self.pair(points[order], np.argsort(order)[cells]), says="the canonical one")

    def test_as_it_comes(self):
        # Qhull orients as it likes.
        points = uniform(500)
        said = self.refused(*self.pair(points, Delaunay(points).simplices), says="orientation")
        self.assertIn("negatively, the first is number", said)

    def test_vtu_and_msh(self):
        points = uniform(300)
        cells = self.qhull(points)
        for name, options in [("m.vtu", {"binary": False}),
                              ("m.msh", {"file_format": "gmsh"}),
                              ("m2.msh", {"file_format": "gmsh22", "binary": False})]:
            # In two parts, as the cells of two materials come, where meshio can write that.
            parts = [cells] if name == "m.msh" else [cells[:100], cells[100:]]
            meshio.Mesh(points, [("tetra", part) for part in parts]).write(self.path(name), **options)
            self.passes(name, says="the canonical one")
            meshio.Mesh(points, [("tetra", cells[:-3])]).write(self.path(name), **options)
            self.refused(name, says="")

    def test_lattice_has_slivers(self):
        # Plain Qhull makes flat tetrahedra of cospherical points; with QJ it moves the points.
        points = lattice(6)
        cells = Delaunay(points).simplices
        self.assertGreater(np.count_nonzero(volumes(points, cells) == 0), 0)
        said = self.refused(*self.pair(points, cells), says="orientation")
        self.assertIn("have no volume, the first is number", said)
        joggled = Delaunay(points, qhull_options="QJ").simplices
        self.check(*self.pair(points, joggled), code=1)


class Cgal(ForeignTest):
    def cgal(self, points):
        points.tofile(self.path("p.f64"))
        subprocess.run([CGAL_MESH, "p.f64", "m.ele"], cwd=self.directory, check=True)
        with open(self.path("m.node"), "w") as f:
            f.write(f"{len(points)} 3 0 0\n")
            f.writelines(f"{i} {x!r} {y!r} {z!r}\n" for i, (x, y, z) in enumerate(points.tolist()))
        return "m.ele"

    def test_equal(self):
        for points in [uniform(1000), lattice(7), np.random.default_rng(2).normal(size=(500, 3))]:
            self.passes(self.cgal(points), says="the canonical one")

    def test_repeats(self):
        points = np.concatenate([lattice(4), lattice(4)])
        self.passes(self.cgal(points))


class Corrupted(ForeignTest):
    """Each kind of damage to one sound mesh, at random places."""

    def setUp(self):
        super().setUp()
        self.points = uniform(200)
        self.cells = self.qhull(self.points)
        self.random = np.random.default_rng(11)

    def each(self, says, damage, rounds=5):
        for _ in range(rounds):
            points, cells = damage(self.points.copy(), self.cells.copy())
            self.refused(*self.pair(points, cells), says=says)

    def any(self):
        return self.random.integers(len(self.cells))

    def on_hull(self):
        """Tetrahedra with a facet on the hull."""
        hull = {frozenset(f) for f in Delaunay(self.points).convex_hull.tolist()}
        return [t for t, v in enumerate(self.cells.tolist())
                if any(frozenset(v[:i] + v[i + 1:]) in hull for i in range(4))]

    def test_missing_inside(self):
        inner = list(set(range(len(self.cells))) - set(self.on_hull()))
        self.each("hull", lambda p, c: (p, np.delete(c, self.random.choice(inner), 0)))

    def test_missing_on_the_hull(self):
        self.each("", lambda p, c: (p, np.delete(c, self.random.choice(self.on_hull()), 0)))

    def test_twice(self):
        self.each("facets", lambda p, c: (p, np.concatenate([c, c[[self.any()]]])))

    def test_one_turned(self):
        def turn(p, c):
            t = self.any()
            c[t, :2] = c[t, 1::-1]
            return p, c
        self.each("orientation", turn)

    def test_another_vertex(self):
        def change(p, c):
            t = self.any()
            c[t, 0] = self.random.choice(np.setdiff1d(np.arange(len(p)), c[t]))
            return p, c
        self.each("", change)

    def test_a_vertex_twice(self):
        def change(p, c):
            t = self.any()
            c[t, 0] = c[t, 1]
            return p, c
        self.each("orientation", change)

    def test_unused_point(self):
        self.each("vertices: 1 of 201 distinct points are in no tetrahedron, the first is number 200",
                  lambda p, c: (np.concatenate([p, [[0.5, 0.5, 0.5]]]), c), rounds=1)
        # A repeat of a vertex is none.
        self.passes(*self.pair(np.concatenate([self.points, self.points[:7]]), self.cells))

    def test_not_delaunay(self):
        # Two tetrahedra that share a facet become three around a new edge.
        def flip(p, c):
            for t in self.random.permutation(len(c)):
                for m in range(len(c)):
                    shared = np.intersect1d(c[t], c[m])
                    if m == t or len(shared) != 3:
                        continue
                    d, e = np.setdiff1d(c[t], shared)[0], np.setdiff1d(c[m], shared)[0]
                    new = np.array([[d, e, *np.delete(shared, i)] for i in range(3)])
                    size = volumes(p, new)
                    whole = np.abs(volumes(p, c[[t, m]])).sum()
                    if abs(np.abs(size).sum() - whole) > 1e-9 * whole or np.abs(size).min() < 1e-9:
                        continue
                    new[size < 0, :2] = new[size < 0, 1::-1]
                    return p, np.concatenate([np.delete(c, [t, m], 0), new])
            return self.fail("no flip")
        self.each("spheres: at", flip)

    def test_moved_points(self):
        def move(p, c):
            p[self.random.integers(len(p))] += 0.2
            return p, c
        self.each("", move)

    def test_two_in_one_place(self):
        # The same mesh again, beside and on top: each sound, together not.
        for shift in [10.0, 0.001]:
            points = np.concatenate([self.points, self.points + shift])
            cells = np.concatenate([self.cells, self.cells + len(self.points)])
            self.refused(*self.pair(points, cells), says="hull" if shift == 10 else "")

    def test_no_tetrahedra(self):
        self.refused(*self.pair(self.points, np.zeros((0, 4))), says="vertices: 200 of 200")


class Large(ForeignTest):
    def test_a_million_tetrahedra(self):
        # Linear: minutes would be quadratic.
        points = np.random.default_rng(3).random((150000, 3))
        np.save(self.path("p.npy"), points)
        subprocess.run([MGDT, "triangulate", "-q", "p.npy", "-o", "t.vtu"], cwd=self.directory,
                       check=True, timeout=300)
        self.passes("t.vtu", says="the canonical one")


if __name__ == "__main__":
    MGDT, CGAL_MESH = (os.path.abspath(program) for program in sys.argv[1:3])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
