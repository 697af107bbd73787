#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Files as arguments of the program: outputs onto inputs, empty inputs, names that no terminal should
see as they are.

Usage: file_arguments_test.py MGDT [unittest arguments]
"""

import os
import subprocess
import sys
import unittest

sys.dont_write_bytecode = True  # the source tree stays as it is
import cli_test
from cli_test import CliTest

TETRAHEDRON = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "docs", "data")


class OntoAnInput(CliTest):
    """Refused as wrong usage, before anything is written."""

    def test_every_spelling(self):
        self.put("p.xyz", TETRAHEDRON)
        os.mkdir(self.path("d"))
        os.symlink("../p.xyz", self.path("d/symbolic.npy"))
        os.symlink("symbolic.npy", self.path("d/chain.npy"))
        os.symlink("d", self.path("e"))
        os.link(self.path("p.xyz"), self.path("hard.npy"))
        for output in ("p.xyz", "./p.xyz", "d/../p.xyz", self.path("p.xyz"), "d/symbolic.npy",
                       "d/chain.npy", "e/chain.npy", "hard.npy"):
            self.refuses("triangulate", "p.xyz", "-o", output, "--to", "npy",
                         says=[f"{output}: would overwrite the input", "name another output"])
            self.refuses("triangulate", output, "--from", "xyz", "-o", "p.xyz", "--to", "npy",
                         says="p.xyz: would overwrite the input")
            self.refuses("triangulate", "p.xyz", "-o", "m.npy", "--neighbors", output,
                         says=f"{output}: would overwrite the input")
        self.assertFalse(os.path.exists(self.path("m.npy")))
        # A link that leads to nothing, and a file beside the input, are no inputs.
        os.symlink("nothing.npy", self.path("loose.npy"))
        self.mgdt("triangulate", "p.xyz", "-o", "loose.npy")
        self.mgdt("triangulate", "p.xyz", "-o", "d/p.xyz", "--to", "npy")

    def test_files_that_belong_together(self):
        self.mgdt("generate", "lattice", 27, "-o", "m.node")
        # Points alone: the output brings a .node file of its own.
        for output in ("m.ele", "m.node", "m.neigh", "./m.ele"):
            self.refuses("triangulate", "m.node", "-o", output, says="m.node: would overwrite the input")
        self.mgdt("triangulate", "m.node", "-o", "n.ele")
        self.refuses("triangulate", "n.ele", "-o", "n.ele", says="would overwrite the input")
        for output in ("n.node", "n.neigh", "n.ele"):
            # One of the three is enough, whichever the output names or is named.
            self.refuses("triangulate", "n.ele", "-o", output, "--to", "npy",
                         says=f"{output}: would overwrite the input")
        os.symlink("n.node", self.path("other.node"))
        self.refuses("triangulate", "n.ele", "-o", "other.ele",
                     says=["other.node: would overwrite the input n.node"])
        os.remove(self.path("n.neigh"))
        self.mgdt("triangulate", "n.ele", "-o", "n.neigh", "--to", "npy")
        self.mgdt("triangulate", "n.node", "-o", "n.vtu")

    def test_standard_streams(self):
        self.put("p.xyz", TETRAHEDRON)
        with open(self.path("p.xyz"), "rb") as source:
            self.refuses("triangulate", "-", "-o", "p.xyz", "--to", "npy", stdin=source,
                         says="p.xyz: would overwrite the input standard input")
        with open(self.path("p.xyz"), "ab") as target:
            done = subprocess.run([cli_test.MGDT, "triangulate", "p.xyz", "-o", "-", "--to", "npy"],
                                  cwd=self.directory, stdout=target, stderr=subprocess.PIPE,
                                  check=False, timeout=300)
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"standard output: would overwrite the input p.xyz", done.stderr)
        self.assertEqual(self.get("p.xyz"), TETRAHEDRON.encode())
        # What is read from a device such as /dev/null does not change by writing to it.
        self.mgdt("triangulate", "/dev/null", "--allow-empty", "-o", "/dev/null", "--to", "npy")

    def test_data_of_generated_points(self):
        with open(os.path.join(DATA, "machine.msh"), "rb") as mesh:
            self.put("machine.msh", mesh.read())
        os.symlink("machine.msh", self.path("points.xyz"))
        for output in ("machine.msh", "points.xyz"):
            self.refuses("generate", "machine", 1000, "-o", output, "--to", "xyz", "--data", ".",
                         says=f"{output}: would overwrite the input")
        self.mgdt("generate", "machine", 1000, "-o", "new.xyz", "--data", ".")
        # Other kinds are made from nothing.
        self.mgdt("generate", "uniform", 10, "-o", "points.xyz", "--data", ".")

    def test_two_outputs(self):
        self.put("p.xyz", TETRAHEDRON)
        self.refuses("triangulate", "p.xyz", "-o", "m.npy", "--neighbors", "./m.npy",
                     says="./m.npy: the same file as another output, m.npy")
        self.refuses("triangulate", "p.xyz", "-o", "m.ele", "--neighbors", "m.neigh",
                     says="the same file as another output")


class Empty(CliTest):
    def test_nothing_is_an_error(self):
        for name, content in (("nothing", b""), ("blanks", b" \n\t\r\n\f\v"), ("mark", b"\xef\xbb\xbf\n")):
            for command in (["triangulate", "-o", "m.vtu"], ["triangulate", "--stats"], ["check"], ["info"]):
                with self.subTest(content=name, command=command):
                    says = ["is empty", "--allow-empty"]
                    self.fails(3, *command, "-", data=content, says=["standard input", *says])
                    for ending in "", ".xyz", ".csv", ".npy", ".ply", ".node", ".ele", ".msh", ".vtu":
                        self.put("p" + ending, content)
                        self.fails(3, *command, "p" + ending, says=["p" + ending, *says])
                        os.remove(self.path("p" + ending))
        self.fails(3, "check", "-", "--from", "f64", data=b"", says="is empty")
        self.fails(3, "triangulate", "/dev/null", "--stats", says="is empty")

    def test_a_producer_that_died(self):
        command = f"false | '{cli_test.MGDT}' triangulate - -o m.vtu"
        done = subprocess.run(["sh", "-c", command], cwd=self.directory, stderr=subprocess.PIPE,
                              check=False, timeout=300)
        self.assertEqual(done.returncode, 3)
        self.assertIn(b"standard input: is empty", done.stderr)
        self.assertEqual(self.names(), [])

    def test_allowed(self):
        for content in (b"", b" \n\n"):
            for form in "xyz", "csv", "npy", "f64", "ply", "tetgen", "gmsh", "vtu":
                if form == "f64" and content:
                    continue
                self.mgdt("triangulate", "-", "--from", form, "--allow-empty", "-o", "m.vtu", data=content)
                self.assertIn(b"0 points, 0 tetrahedra", self.out)
                self.assertIn("there are no points", self.err)
                self.mgdt("check", "m.vtu")
        self.assertIn(b"points         0", self.mgdt("info", "-", "--allow-empty", data=b""))
        self.mgdt("check", "-", "--allow-empty", data=b"")

    def test_files_that_say_they_have_none(self):
        """No points is a result where a file says so."""
        for name in "p.npy", "p.ply", "p.node", "p.csv":
            self.mgdt("generate", "uniform", 0, "-o", name)
            self.mgdt("triangulate", name, "-o", "m.vtu")
            self.mgdt("info", "-", "--from", {"node": "tetgen"}.get(name[2:], name[2:]), data=self.get(name))
        for content in b"# no points today\n", b"0\n":
            self.mgdt("info", "-", data=content)
        # Bare doubles of any bytes are points.
        self.assertIn(b"points         1", self.mgdt("info", "-", "--from", "f64", data=b" " * 24))


class Names(CliTest):
    """What no terminal should see as it is becomes \\xNN wherever a name is printed."""

    shown = {
        b"\x1b]0;title\x07\x1b[2J.xyz": "\\x1b]0;title\\x07\\x1b[2J.xyz",
        b"two\nlines\r.xyz": "two\\x0alines\\x0d.xyz",
        b"\x7f\xc2\x9b31m.xyz": "\\x7f\\xc2\\x9b31m.xyz",  # CSI as one character
        b"latin-\xe9\xff.xyz": "latin-\\xe9\\xff.xyz",
        b"overlong-\xc0\xaf.xyz": "overlong-\\xc0\\xaf.xyz",
        b"half-\xed\xa0\x80.xyz": "half-\\xed\\xa0\\x80.xyz",
        b"beyond-\xf4\x90\x80\x80.xyz": "beyond-\\xf4\\x90\\x80\\x80.xyz",
        b"cut-\xe2\x82": "cut-\\xe2\\x82",
        "turned-\u202ezyx.\u2066.xyz".encode(): "turned-\\xe2\\x80\\xaezyx.\\xe2\\x81\\xa6.xyz",
        "line\u2028end.xyz".encode(): "line\\xe2\\x80\\xa8end.xyz",
        "Käse-点-\U0001f9c0.xyz".encode(): "Käse-点-\U0001f9c0.xyz",
    }

    def test_inputs_and_outputs(self):
        for name, shown in self.shown.items():
            with self.subTest(name=name):
                path = os.path.join(self.directory.encode(), name)
                self.assertIn(shown + ": cannot read", self.run_mgdt(3, "info", name))
                with open(path, "wb") as file:
                    file.write(b"")
                self.assertIn(shown + ": is empty", self.run_mgdt(3, "check", name))
                with open(path, "wb") as file:
                    file.write(b"1 2 x\n")
                self.assertIn(shown + ": line 1", self.run_mgdt(3, "triangulate", name, "--stats"))
                self.assertIn(": " + shown, self.run_mgdt(0, "generate", "uniform", "9", "-o", name, "--to", "xyz"))
                text = self.run_mgdt(0, "info", name)
                self.assertIn("file           " + shown + "\n", text)
                self.assertIn(shown + ": xyz, 9 points", self.run_mgdt(0, "check", name))
                self.assertIn(shown + ": would overwrite",
                              self.run_mgdt(2, "triangulate", name, "-o", name, "--to", "npy"))
                self.assertIn(": " + shown + ".vtu\n",
                              self.run_mgdt(0, "triangulate", name, "-o", name + b".vtu"))
                self.assertIn(shown + "/m.vtu: cannot write",
                              self.run_mgdt(4, "triangulate", name, "-o", name + b"/m.vtu"))
                self.assertIn(shown, self.run_mgdt(2, "triangulate", name, "-o", name + b".step"))
                with open(path, "wb") as file:
                    file.write(b"1 1 1\n")
                self.assertIn(shown + ": all points are equal", self.run_mgdt(0, "triangulate", name, "--check", "1"))

    def test_other_words(self):
        word = b"\x1b[2J\xff"
        shown = "\\x1b[2J\\xff"
        self.put("p.xyz", TETRAHEDRON)
        for code, *arguments in ((2, word), (2, "info", "p.xyz", "--from", word), (2, "info", "p.xyz", word),
                                 (2, "info", "p.xyz", b"--" + word), (2, "generate", word, "5", "-o", "q.xyz"),
                                 (2, "generate", "uniform", word, "-o", "q.xyz"),
                                 (2, "triangulate", "p.xyz", "--stats", "--threads", word),
                                 (2, "triangulate", "p.xyz", "--stats", "--scheme", word),
                                 (3, "generate", "machine", "5", "-o", "q.xyz", "--data", word),
                                 (3, "check", "p.xyz", "--points", word)):
            with self.subTest(arguments=arguments):
                self.assertIn(shown, self.run_mgdt(code, *arguments))

    def test_names_of_files_that_belong_together(self):
        self.mgdt("generate", "lattice", 27, "-o", "p.node")
        name = b"\x1b[2J\xff"
        self.run_mgdt(0, "triangulate", "p.node", "-o", name + b".ele")
        self.assertIn("with \\x1b[2J\\xff.node, numbered from 0 and \\x1b[2J\\xff.neigh",
                      self.run_mgdt(0, "info", name + b".ele"))

    def test_contents(self):
        """Words of a file are cut at whole characters."""
        self.put("p.xyz", ("0 0 " + "ä" * 30 + "\n0 0 \x1b[2J\n").encode())
        self.assertIn("'" + "ä" * 20 + "...'", self.run_mgdt(3, "info", "p.xyz"))
        self.put("p.xyz", b"0 0 0\n0 0 \x1b[2J\n")
        self.assertIn("'\\x1b[2J'", self.run_mgdt(3, "info", "p.xyz"))

    def test_nobody_reads_messages(self):
        done = subprocess.run(["sh", "-c", f"'{cli_test.MGDT}' info missing.xyz 2>/dev/full"],
                              cwd=self.directory, check=False, timeout=300)
        self.assertEqual(done.returncode, 3)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    cli_test.MGDT = os.path.abspath(sys.argv.pop(1))
    unittest.main()
