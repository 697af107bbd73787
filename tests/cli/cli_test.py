#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The program from outside: exit codes, messages, pipes, interrupted and failing output.

Usage: cli_test.py MGDT [unittest arguments]
"""

import array
import os
import pty
import re
import resource
import select
import shutil
import signal
import stat
import struct
import subprocess
import sys
import tempfile
import time
import unittest

MGDT = ""
WRITABLE = ["npy", "xyz", "csv", "f64", "ply", "node"]


class CliTest(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.mkdtemp(prefix="mgdt-cli-")
        self.addCleanup(shutil.rmtree, self.directory)

    def path(self, name):
        return os.path.join(self.directory, name)

    def put(self, name, content):
        mode = "wb" if isinstance(content, bytes) else "w"
        with open(self.path(name), mode) as f:
            f.write(content)
        return self.path(name)

    def get(self, name):
        with open(self.path(name), "rb") as f:
            return f.read()

    def names(self):
        return sorted(os.listdir(self.directory))

    def mgdt(self, *arguments, code=0, data=None, **options):
        """Runs the program in the directory; returns what it wrote, as text unless bytes."""
        done = subprocess.run([MGDT, *map(str, arguments)], input=data, cwd=self.directory,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=300,
                              check=False, **options)
        err = done.stderr.decode()
        self.assertEqual(done.returncode, code, f"{arguments}: {err}")
        if code != 0:
            self.assertTrue(err.startswith("mgdt: "), err)
            self.assertEqual(err.count("\n"), 1, err)
        self.out, self.err = done.stdout, err
        return done.stdout

    def fails(self, code, *arguments, says=(), data=None, **options):
        before = self.names()
        self.mgdt(*arguments, code=code, data=data, **options)
        for part in [says] if isinstance(says, str) else says:
            self.assertIn(part, self.err)
        self.assertEqual(self.names(), before, "files were left behind")


    def refuses(self, *arguments, says=(), **options):
        before = {name: self.get(name) for name in self.names() if os.path.isfile(self.path(name))}
        self.fails(2, *arguments, says=says, **options)
        for name, content in before.items():
            self.assertEqual(self.get(name), content, name)

    def run_mgdt(self, code, *arguments):
        """Everything that the program prints, which must be lines of printable UTF-8."""
        done = subprocess.run([MGDT, *arguments], cwd=self.directory, check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300)
        text = done.stdout.decode("utf-8")
        self.assertEqual(done.returncode, code, text)
        hostile = {c for c in text if (ord(c) < 32 and c != "\n") or 127 <= ord(c) < 160 or
                   c in "\u2028\u2029\u202e\u2066"}
        self.assertEqual(hostile, set(), repr(text))
        return text


class Usage(CliTest):
    def test_help_and_version(self):
        self.assertIn(b"Exit codes", self.mgdt("--help"))
        for command in ["triangulate", "generate", "check", "info", "interpolate", "voronoi", "surface", "hull", "relax", "mesh", "refine", "improve", "validate"]:
            self.assertIn(b"Exit codes", self.mgdt(command, "--help"))
            self.assertIn(command, self.mgdt("--help").decode())
        self.assertRegex(self.mgdt("--version").decode(), r"^mgdt \d+\.\d+\.\d+")
        self.assertIn(b"multi-grid", self.mgdt("triangulate", "--help"))
        self.assertIn(b"galaxy", self.mgdt("generate", "--help"))

    def test_wrong_usage(self):
        points = self.put("p.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n")
        self.fails(2, says="--help")
        self.fails(2, "frobnicate", says="frobnicate")
        self.fails(2, "triangulate", says="input")
        self.fails(2, "triangulate", points, says="-o")
        self.fails(2, "triangulate", points, "-o", "m.step", says=["m.step", "--to", "vtu"])
        self.fails(2, "triangulate", points, "-o", "m.xyz", says="no place for tetrahedra")
        self.fails(2, "triangulate", points, "-o", "-", says="--to")
        self.fails(2, "triangulate", points, "-o", "m.vtu", "--to", "step", says="'step'")
        self.fails(2, "triangulate", points, "-o", "-", "--to", "tetgen", says="several files")
        self.fails(2, "triangulate", points, "-o", "m.vtu", "--scheme", "best",
                   says=["'best'", "multi-grid"])
        self.fails(2, "triangulate", points, "-o", "m.vtu", "--index-base", "2", says="--index-base")
        self.fails(2, "triangulate", points, "-o", "m.vtu", "--threads", "-1", says="--threads")
        self.fails(2, "triangulate", points, "-o", "m.vtu", "--check", "4", says="--check")
        self.fails(2, "triangulate", points, "-o", "m.vtu", "--columns", "1,2", says="--columns")
        self.fails(2, "triangulate", points, "-o", "m.vtu", "--round-ratio", "0.5",
                   says="--round-ratio")
        self.fails(2, "triangulate", points, "-o", "m.npy", "--neighbors", "m.npy", says="same file")
        self.fails(2, "generate", "uniform", "many", "-o", "p.npy", says="'many'")
        self.fails(2, "generate", "uniform", "-5", "-o", "p.npy")
        self.fails(2, "generate", "uniform", "1.5", "-o", "p.npy", says="'1.5'")
        self.fails(2, "generate", "nonsense", "5", "-o", "p.npy", says="nonsense")
        self.fails(2, "generate", "uniform", "5", "-o", "p.vtu", says="not for points")


class Pipelines(CliTest):
    def test_every_output_checks(self):
        self.mgdt("generate", "lattice", 343, "-o", "p.npy")
        for arguments in (["m.vtu"], ["m.msh"], ["m2.msh", "--to", "gmsh2"], ["m.ele"],
                          ["m1.node", "--index-base", 1]):
            self.mgdt("triangulate", "p.npy", "-o", *arguments)
            name = arguments[0].replace(".node", ".ele")
            self.assertIn(b"valid Delaunay triangulation, the canonical one",
                          self.mgdt("check", name))
            self.assertIn(b"tetrahedra     1296", self.mgdt("info", name))
        for base in 0, 1:
            self.mgdt("triangulate", "p.npy", "-o", "t.npy", "--index-base", base, "--neighbors",
                      "n.npy")
            self.mgdt("check", "t.npy", "--points", "p.npy", "--index-base", base)
            tetrahedra, neighbors = self.rows("t.npy"), self.rows("n.npy")
            self.assertEqual(len(tetrahedra), 1296)
            for t, (vertices, around) in enumerate(zip(tetrahedra, neighbors)):
                for i, n in enumerate(around):
                    if n == base - 1:
                        continue
                    facet = set(vertices[:i] + vertices[i + 1:])
                    self.assertTrue(facet < set(tetrahedra[n - base]), f"{t}, {i}")

    def rows(self, name):
        data = self.get(name)
        self.assertEqual(data[:6], b"\x93NUMPY")
        values = array.array("q", data[10 + struct.unpack("<H", data[8:10])[0]:])
        if sys.byteorder == "big":
            values.byteswap()
        return [list(values[i:i + 4]) for i in range(0, len(values), 4)]

    def test_every_point_format(self):
        expected = None
        for name in WRITABLE:
            self.mgdt("generate", "galaxy", 500, "--seed", 3, "-o", "p." + name)
            self.mgdt("triangulate", "p." + name, "-o", "t.npy", "--canonical")
            expected = expected or self.get("t.npy")
            self.assertEqual(self.get("t.npy"), expected, name)

    def test_canonical_is_one_file(self):
        self.mgdt("generate", "rounded", 2000, "-o", "p.npy")
        files = set()
        listed = re.search(r"Order of insertion: (.*)",
                           self.mgdt("triangulate", "--help").decode())
        schemes = re.findall(r"[a-z-]+", listed.group(1))
        self.assertGreaterEqual(len(schemes), 10)
        for scheme in schemes:
            self.mgdt("triangulate", "p.npy", "-o", "m.vtu", "--canonical", "--scheme", scheme,
                      "--seed", 5, "--check", 3)
            files.add(self.get("m.vtu"))
        self.assertEqual(len(files), 1)

    def test_pipes(self):
        for name, sniffed in (("npy", True), ("xyz", True), ("ply", True), ("csv", True),
                              ("f64", False), ("tetgen", False)):
            points = self.mgdt("generate", "uniform", 100, "-o", "-", "--to", name)
            source = [] if sniffed else ["--from", name]
            mesh = self.mgdt("triangulate", "-", *source, "-o", "-", "--to", "vtu", data=points)
            self.assertEqual(self.err, "")
            self.assertIn(b"the canonical one", self.mgdt("check", "-", data=mesh))
            self.assertIn(b"standard input", self.mgdt("info", "-", *source, data=points))
        self.fails(3, "info", "-", data=b"\x00\x01\x02", says=["standard input", "--from"])
        self.assertEqual(self.names(), [])

    def test_statistics_and_quiet(self):
        self.mgdt("generate", "uniform", 2000, "-o", "p.npy", "--quiet")
        self.assertEqual(self.out, b"")
        text = self.mgdt("triangulate", "p.npy", "--stats").decode()
        for line in ["walk steps per point", "removed per point", "created per point", "exact calls"]:
            self.assertIn(line, text)
        values = dict(line.rsplit(None, 1) for line in text.splitlines() if "per point" in line)
        self.assertGreater(float(values["created per point"]), 10)
        self.assertEqual(self.mgdt("triangulate", "p.npy", "-o", "m.vtu", "-q"), b"")
        self.assertEqual(self.err, "")
        self.mgdt("triangulate", "p.npy", "-o", "-", "--to", "vtu", "--stats")
        self.assertTrue(self.out.startswith(b"<?xml"))
        self.assertIn("removed per point", self.err)

    def test_flat_points_are_no_error(self):
        for kind in ["coplanar", "collinear", "one-point"]:
            self.mgdt("generate", kind, 50, "-o", "p.xyz")
            self.mgdt("triangulate", "p.xyz", "-o", "m.vtu")
            self.assertIn("no tetrahedra", self.err)
            self.mgdt("check", "m.vtu")
        self.put("empty.xyz", "")
        self.mgdt("triangulate", "empty.xyz", "--allow-empty", "-o", "e.msh")
        self.mgdt("check", "e.msh")

    def test_info(self):
        self.put("p.csv", "x,y,z\n0,0,0\n1,0,0\n0,2,0\n0,0,3\n-0,0,0\n")
        text = self.mgdt("info", "p.csv").decode()
        for line in ["points         5", "duplicates     1", "dimension      3", "z              0 to 3"]:
            self.assertIn(line, text)

    def test_output_replaces_with_care(self):
        self.put("p.xyz", "0 0 0\n1 0 0\n0 1 0\n0 0 1\n")
        self.put("old.vtu", "old")
        os.chmod(self.path("old.vtu"), 0o640)
        os.symlink("old.vtu", self.path("link.vtu"))
        self.mgdt("triangulate", "p.xyz", "-o", "link.vtu")
        self.assertTrue(os.path.islink(self.path("link.vtu")))
        self.assertTrue(self.get("old.vtu").startswith(b"<?xml"))
        self.assertEqual(stat.S_IMODE(os.stat(self.path("old.vtu")).st_mode), 0o640)
        self.mgdt("triangulate", "p.xyz", "-o", "new.vtu", umask=0o027)
        self.assertEqual(stat.S_IMODE(os.stat(self.path("new.vtu")).st_mode), 0o640)
        self.assertEqual(self.names(), ["link.vtu", "new.vtu", "old.vtu", "p.xyz"])

    @unittest.skipUnless(shutil.which("gmsh"), "gmsh is not installed")
    def test_gmsh_reads_and_writes(self):
        self.mgdt("generate", "lattice", 216, "-o", "p.npy")
        for to in "gmsh", "gmsh2":
            self.mgdt("triangulate", "p.npy", "-o", "m.msh", "--to", to)
            for arguments in (["msh22"], ["msh22", "-bin"], ["msh41"], ["msh41", "-bin"]):
                subprocess.run(["gmsh", "-0", "m.msh", "-o", "back.msh", "-format", *arguments],
                               cwd=self.directory, stdout=subprocess.DEVNULL, check=True)
                self.assertIn(b"216 points, 750 tetrahedra", self.mgdt("check", "back.msh"))


class BadInput(CliTest):
    def test_messages_name_file_and_place(self):
        self.put("a.xyz", "0 0 0\n1 0 0\n0 one 0\n")
        self.fails(3, "triangulate", "a.xyz", "-o", "m.vtu", says=["a.xyz: line 3", "'one'"])
        self.put("n.csv", "x,y,z\n0,0,nan\n")
        self.fails(3, "triangulate", "n.csv", "-o", "m.vtu", says=["n.csv: line 2", "finite"])
        self.mgdt("generate", "infinity", 10, "-o", "i.npy")
        self.fails(3, "triangulate", "i.npy", "-o", "m.vtu", says=["i.npy: byte", "finite"])
        self.put("r.f64", b"1234567")
        self.fails(3, "check", "r.f64", says=["r.f64", "24 bytes"])
        self.fails(3, "info", "missing.npy", says=["missing.npy", "check the name"])
        self.fails(3, "info", ".", says="directory")
        self.put("m.ele", "1 4 0\n1 1 2 3 4\n")
        self.fails(3, "check", "m.ele", says=["m.node", "check the name"])
        self.fails(3, "generate", "machine", 10, "-o", "p.npy", "--data", "nowhere",
                   says=["nowhere", "--data"])
        self.put("t.npy", b"not numpy")
        self.fails(3, "check", "t.npy", "--points", "a.xyz", says="line 3")

    def test_meshes_without_tetrahedra_are_not_valid(self):
        corners = [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
        numbered = [f"{i} {x} {y} {z}" for i, (x, y, z) in enumerate(corners, 1)]
        hexahedron = " ".join(map(str, range(1, 9)))
        lines = "\n".join
        self.put("h.inp", lines(["*HEADING", "*NODE", *(n.replace(" ", ", ") for n in numbered),
                                 "*ELEMENT, TYPE=C3D8", "1, " + hexahedron.replace(" ", ", "),
                                 ""]))
        self.put("h.msh", lines(["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", "8",
                                 *numbered, "$EndNodes", "$Elements", "1", "1 5 2 0 1 " + hexahedron,
                                 "$EndElements", ""]))
        self.put("h.mesh", lines(["MeshVersionFormatted 2", "Dimension 3", "Vertices", "8",
                                  *(f"{x} {y} {z} 0" for x, y, z in corners), "Hexahedra", "1",
                                  hexahedron + " 0", "End", ""]))
        for name in ("h.inp", "h.msh", "h.mesh"):
            self.fails(7, "check", name, says=[name, "1 other cell", "nothing to check"])
            self.assertIn(b"8 points", self.out)
        self.put("p.xyz", lines(f"{x} {y} {z}" for x, y, z in corners))
        self.assertIn(b"points only", self.mgdt("check", "p.xyz"))

    def test_the_program_finds_its_data_beside_itself(self):
        # A copy of the program and of its data, somewhere else.
        os.makedirs(self.path("moved/bin"))
        os.makedirs(self.path("moved/share/mgdt"))
        program = shutil.copy(MGDT, self.path("moved/bin/mgdt"))
        data = os.path.join(os.path.dirname(__file__), "..", "..", "docs", "data", "machine.msh")
        shutil.copy(data, self.path("moved/share/mgdt"))
        command = [program, "generate", "machine", "1000", "-o", self.path("p.xyz")]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, timeout=300)
        os.remove(self.path("moved/share/mgdt/machine.msh"))
        done = subprocess.run(command, stderr=subprocess.PIPE, text=True, check=False, timeout=300)
        self.assertEqual(done.returncode, 3)
        self.assertIn(self.path("moved/share/mgdt/machine.msh"), done.stderr)
        # The option still goes first.
        subprocess.run([*command, "--data", os.path.dirname(data)], check=True,
                       stdout=subprocess.DEVNULL, timeout=300)

    def test_lying_headers_allocate_nothing(self):
        header = b"{'descr': '<f8', 'fortran_order': False, 'shape': (99999999999, 3)}\n"
        self.put("p.npy", b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header)
        self.put("p.ply", b"ply\nformat binary_little_endian 1.0\nelement vertex 99999999999\n"
                          b"property double x\nproperty double y\nproperty double z\nend_header\n")
        self.put("p.node", "99999999999 3 0 0\n1 0 0 0\n")
        self.put("p.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n99999999999\n1 0 0 0\n")
        self.put("p.vtu", "<VTKFile type='UnstructuredGrid'><Piece NumberOfPoints='99999999999' "
                          "NumberOfCells='1'>")
        limit = 1 << 30
        for name in "npy", "ply", "node", "msh", "vtu":
            self.fails(3, "info", "p." + name, says="p." + name,
                       preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))

    def test_numbers_of_tetgen_follow_the_input(self):
        corners = ["0 0 0", "1 0 0", "0 1 0", "0 0 1"]
        for first in (0, 1):
            self.put("p.node", "4 3 0 0\n" + "".join(f"{i + first} {c}\n" for i, c in enumerate(corners)))
            for options, base in ((), first), (("--index-base", 0), 0), (("--index-base", 1), 1):
                self.mgdt("triangulate", "p.node", "-o", "m.ele", *options)
                for name in ("m.node", "m.ele", "m.neigh"):
                    self.assertEqual(self.get(name).split(b"\n")[1].split()[0], b"%d" % base)
                self.assertEqual(min(map(int, self.get("m.ele").split(b"\n")[1].split()[1:])), base)
                self.mgdt("check", "-q", "m.ele")
        # Of an .npy they have the default still.
        self.mgdt("triangulate", "p.node", "-o", "m.npy", "--neighbors", "n.npy")
        self.assertIn(b"m.npy", self.out)

    def test_check_finds_defects(self):
        self.mgdt("generate", "uniform", 50, "-o", "p.npy")
        self.mgdt("triangulate", "p.npy", "-o", "m.ele")
        lines = self.get("m.ele").decode().splitlines()
        os.remove(self.path("m.neigh"))
        fields = lines[3].split()
        swapped = [fields[0], fields[2], fields[1], *fields[3:]]
        self.put("m.ele", "\n".join(lines[:3] + [" ".join(swapped)] + lines[4:]) + "\n")
        self.fails(1, "check", "m.ele", says=["m.ele", "orientation", "number 2"])
        head = f"{len(lines) - 2} 4 0"
        self.put("m.ele", "\n".join([head] + lines[1:-1]) + "\n")
        self.fails(1, "check", "m.ele", says=["not a Delaunay triangulation", "hull"])


class BadOutput(CliTest):
    def setUp(self):
        super().setUp()
        self.mgdt("generate", "uniform", 3000, "-o", "p.npy")

    def test_full_device(self):
        for to in "vtu", "gmsh", "gmsh2", "npy":
            self.fails(4, "triangulate", "p.npy", "-o", "/dev/full", "--to", to,
                       says=["/dev/full", "No space left", "free some space"])
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/full").st_mode))
        with open("/dev/full", "wb") as full:
            done = subprocess.run([MGDT, "triangulate", self.path("p.npy"), "-o", "-", "--to", "vtu"],
                                  stdout=full, stderr=subprocess.PIPE, check=False)
            self.assertEqual(done.returncode, 4)
            self.assertIn(b"standard output", done.stderr)
            done = subprocess.run([MGDT, "info", self.path("p.npy")], stdout=full,
                                  stderr=subprocess.PIPE, check=False)
            self.assertEqual(done.returncode, 4)

    def test_file_size_limit(self):
        self.put("old.vtu", "old")

        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (65536, 65536))

        for name in "m.vtu", "old.vtu", "m.msh", "m.ele", "m.npy":
            self.fails(4, "triangulate", "p.npy", "-o", name, says=["File too large", "ulimit"],
                       preexec_fn=limit)
        self.fails(4, "generate", "uniform", 1e5, "-o", "q.f64", preexec_fn=limit)
        # The second of two outputs fails: the first must not appear either.
        self.fails(4, "triangulate", "p.npy", "-o", "m.npy", "--neighbors", "/dev/full",
                   says="/dev/full")
        self.assertEqual(self.get("old.vtu"), b"old")

    def test_places_that_do_not_exist(self):
        self.fails(4, "triangulate", "p.npy", "-o", "no/m.vtu", says=["no/m.vtu", "directory"])
        self.fails(4, "triangulate", "p.npy", "-o", "p.npy/m.vtu", says="p.npy/m.vtu")
        os.mkdir(self.path("d.vtu"))
        self.fails(4, "triangulate", "p.npy", "-o", "d.vtu", says="d.vtu")
        self.fails(4, "generate", "uniform", 10, "-o", "no/p.npy", says="no/p.npy")

    def test_reader_gone(self):
        read, write = os.pipe()
        os.close(read)
        done = subprocess.run([MGDT, "triangulate", self.path("p.npy"), "-o", "-", "--to", "vtu"],
                              stdout=write, stderr=subprocess.PIPE, check=False)
        os.close(write)
        self.assertEqual(done.returncode, 4)
        self.assertIn(b"Broken pipe", done.stderr)

    def test_compact(self):
        self.mgdt("generate", "uniform", 20000, "-o", "many.npy")
        limit = ["--memory-limit", "7MB"]
        self.fails(5, "triangulate", "many.npy", "-o", "m.npy", *limit, says="memory")
        self.mgdt("triangulate", "many.npy", "-o", "m.npy", "--compact", *limit)
        self.mgdt("triangulate", "many.npy", "-o", "m.npy", "--compact", "--canonical")
        self.mgdt("triangulate", "many.npy", "-o", "n.npy", "--canonical")
        self.assertEqual(self.get("m.npy"), self.get("n.npy"))
        self.mgdt("check", "--compact", "many.npy")

    def test_out_of_memory(self):
        self.fails(5, "triangulate", "p.npy", "-o", "m.vtu", "--memory-limit", "100KB",
                   says=["p.npy", "memory"])
        self.fails(5, "generate", "uniform", "1e15", "-o", "q.npy", says="memory")


class Memory(CliTest):
    def peak(self, *arguments):
        """The most memory that the program holds, in bytes."""
        child = subprocess.Popen([MGDT, *map(str, arguments)], cwd=self.directory,
                                 stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(child.returncode, 0)
        return 1024 * usage.ru_maxrss

    def test_writing_needs_no_more_than_the_triangulation(self):
        for n in 20000, 320000:
            self.mgdt("generate", "uniform", n, "-o", f"{n}.npy")
            self.mgdt("generate", "uniform", n, "-o", f"{n}.xyz")

        def bytes_a_point(source, *arguments):
            few, many = (self.peak("triangulate", "-q", f"{n}.{source}", *arguments)
                         for n in (20000, 320000))
            return (many - few) / 300000

        alone = bytes_a_point("npy", "--stats")
        self.assertLess(alone, 430)
        for source, output in (("xyz", ["m.ele"]), ("npy", ["m.vtu"]), ("npy", ["m.msh"]),
                               ("npy", ["m.npy", "--neighbors", "n.npy"])):
            with self.subTest(output=output):
                self.assertLess(bytes_a_point(source, "-o", *output), alone + 50)


class Interrupts(CliTest):
    def test_while_reading(self):
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            process = subprocess.Popen([MGDT, "triangulate", "-", "--from", "xyz", "-o", "m.vtu"],
                                       stdin=subprocess.PIPE, stderr=subprocess.PIPE,
                                       cwd=self.directory)
            process.stdin.write(b"0 0 0\n")
            process.stdin.flush()
            time.sleep(0.5)
            process.send_signal(number)
            self.assertEqual(process.wait(timeout=60), code)
            self.assertIn(b"cancelled", process.stderr.read())
            process.stdin.close()
            process.stderr.close()
            self.assertEqual(self.names(), [])

    def test_while_triangulating(self):
        """Waits for the progress bar on a terminal, then presses Ctrl-C."""
        self.mgdt("generate", "uniform", 600000, "-o", "p.npy")
        master, slave = pty.openpty()
        process = subprocess.Popen([MGDT, "triangulate", "p.npy", "-o", "m.vtu"], stderr=slave,
                                   stdout=subprocess.DEVNULL, cwd=self.directory)
        os.close(slave)
        seen = b""
        while b"triangulating [" not in seen:
            self.assertTrue(select.select([master], [], [], 60)[0], "no progress bar")
            seen += os.read(master, 4096)
        process.send_signal(signal.SIGINT)
        try:
            while select.select([master], [], [], 60)[0]:
                part = os.read(master, 4096)
                if not part:
                    break
                seen += part
        except OSError:
            pass  # the terminal closes with the program
        os.close(master)
        self.assertEqual(process.wait(timeout=60), 130)
        self.assertIn(b"cancelled", seen)
        self.assertEqual(self.names(), ["p.npy"])

    def test_in_a_loop_that_asks_nothing(self):
        """A tenth of a second ends what would take ten: seen by the processor's time, on any machine."""
        process = subprocess.Popen([MGDT, "generate", "uniform", "1e8", "-o", "p.npy"],
                                   stderr=subprocess.PIPE, cwd=self.directory)
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, 130)
        self.assertEqual(process.stderr.read(), b"mgdt: cancelled; nothing was written\n")
        process.stderr.close()
        self.assertLess(used.ru_utime + used.ru_stime, 3)
        self.assertEqual(self.names(), [])

    def test_twice_with_many_files(self):
        """No temporary file stays, of however many."""
        self.mgdt("generate", "uniform", 400000, "-o", "p.npy")
        process = subprocess.Popen([MGDT, "triangulate", "p.npy", "--parts", "24", "-o", "m.pvtu"],
                                   stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL, cwd=self.directory)
        while len(self.names()) < 12 and process.poll() is None:
            time.sleep(0.005)
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGTERM)
        self.assertIn(process.wait(timeout=60), (130, 143))
        self.assertEqual(self.names(), ["p.npy"])

    def test_no_bar_without_terminal(self):
        self.mgdt("generate", "uniform", 50000, "-o", "p.npy")
        self.mgdt("triangulate", "p.npy", "-o", "m.vtu")
        self.assertEqual(self.err, "")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    MGDT = os.path.abspath(sys.argv.pop(1))
    unittest.main()
