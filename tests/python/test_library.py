# SPDX-License-Identifier: MIT
"""How the package finds libmgdt, and what it says when it does not."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

from support import run_python

PROGRAM = "import mgdt; print(mgdt.library_path()); mgdt.Delaunay([[0, 0, 0]]).check()"
LIBRARY = os.path.realpath(os.environ["MGDT_LIBRARY"])
PACKAGE = pathlib.Path(__import__("mgdt").__file__).parent


class Finding(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def library(self, source):
        """A shared library of a few lines of C."""
        (self.folder / "other.c").write_text(source)
        file = self.folder / "libother.so"
        compiler = os.environ.get("CC", "cc").split()
        subprocess.run(
            [*compiler, "-shared", "-fPIC", self.folder / "other.c", "-o", file], check=True
        )
        return str(file)

    def copy_of_package(self):
        shutil.copytree(PACKAGE, self.folder / "mgdt", ignore=shutil.ignore_patterns("*.pyc"))
        return self.folder / "mgdt"

    def found(self, path, **environment):
        result = run_python(PROGRAM, **environment)
        self.assertEqual((result.stdout, result.stderr), (f"{path}\n", ""))

    def refused(self, words, **environment):
        result = run_python(PROGRAM, **environment)
        self.assertNotEqual(result.returncode, 0)
        self.assertRegex(result.stderr.replace("\n", " "), r"ImportError: .*" + words)

    def test_by_the_variable(self):
        self.found(LIBRARY, MGDT_LIBRARY=LIBRARY)

    def test_by_the_loader(self):
        os.symlink(LIBRARY, self.folder / "libmgdt.so.1")
        for variable in (None, ""):
            self.found("libmgdt.so.1", MGDT_LIBRARY=variable, LD_LIBRARY_PATH=str(self.folder))

    def test_bundled(self):
        bundled = self.copy_of_package() / "libmgdt.so.1"
        shutil.copy(LIBRARY, bundled)
        path = {"PYTHONPATH": str(self.folder), "LD_LIBRARY_PATH": None}
        self.found(bundled, MGDT_LIBRARY=None, **path)
        # The variable goes first.
        self.found(LIBRARY, MGDT_LIBRARY=LIBRARY, **path)
        # A bundled file that cannot be loaded is passed over, and told of.
        bundled.write_text("no library")
        os.symlink(LIBRARY, self.folder / "libmgdt.so.1")
        path["LD_LIBRARY_PATH"] = str(self.folder)
        self.found("libmgdt.so.1", MGDT_LIBRARY=None, **path)

    def test_installed_together(self):
        package = self.copy_of_package()
        library = self.folder / "libraries" / "libmgdt.so.1"
        library.parent.mkdir()
        os.symlink(LIBRARY, library)
        path = {"PYTHONPATH": str(self.folder), "LD_LIBRARY_PATH": None, "MGDT_LIBRARY": None}
        # The path that `meson install` leaves begins at the package, or at the root.
        for written in ("../libraries/libmgdt.so.1", str(library)):
            (package / "libmgdt.path").write_text(written + "\n")
            self.found(library, **path)
        # It goes before the system's loader, and after a bundled library.
        os.symlink(LIBRARY, self.folder / "libmgdt.so.1")
        self.found(library, **{**path, "LD_LIBRARY_PATH": str(self.folder)})
        os.symlink(LIBRARY, package / "libmgdt.so.1")
        self.found(package / "libmgdt.so.1", **path)
        os.remove(package / "libmgdt.so.1")
        # One that has gone is passed over, and told of.
        os.remove(library)
        self.found("libmgdt.so.1", **{**path, "LD_LIBRARY_PATH": str(self.folder)})
        os.remove(self.folder / "libmgdt.so.1")
        self.refused(r"libraries/libmgdt.so.1 \(installed with the package\)", **path)

    def test_nowhere(self):
        # A copy of the package, so that none is bundled.
        self.copy_of_package()
        self.refused(
            r"libmgdt\.so\.1.*Tried:.*loader.*cannot open shared object.*MGDT_LIBRARY",
            MGDT_LIBRARY=None,
            LD_LIBRARY_PATH=str(self.folder),
            PYTHONPATH=str(self.folder),
        )

    def test_the_variable_names_no_library(self):
        # No other is looked for then.
        os.symlink(LIBRARY, self.folder / "libmgdt.so.1")
        self.refused(
            r"Tried:\s+/nowhere/libmgdt\.so \(the environment variable MGDT_LIBRARY\): .*"
            r"No such file.*Install",
            MGDT_LIBRARY="/nowhere/libmgdt.so",
            LD_LIBRARY_PATH=str(self.folder),
        )

    def test_another_version(self):
        other = self.library("int mgdt_abi_version(void) { return 7; }")
        self.refused("interface has version 7, this package needs 1", MGDT_LIBRARY=other)

    def test_another_library(self):
        other = self.library("int something(void) { return 1; }")
        self.refused("no function mgdt_abi_version", MGDT_LIBRARY=other)
        other = self.library("int mgdt_abi_version(void) { return 1; }")
        self.refused("no function mgdt_create", MGDT_LIBRARY=other)


class Declarations(unittest.TestCase):
    def test_they_are_those_of_the_header(self):
        headers = pathlib.Path(os.environ["MGDT_SOURCE"]) / "include" / "mgdt"
        program = r"""
import ctypes, re, sys
from mgdt import _interface, _library
text = "".join(open(name).read() for name in sys.argv[1:])
source = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
handles = {
    name + stars: kind
    for name in ("mgdt_triangulation", "mgdt_voronoi", "mgdt_domain", "mgdt_mesh", "mgdt_periodic")
    for stars, kind in (("*", "c_void_p"), ("**", "LP_c_void_p"))
}
kinds = {
    "int32_t": "c_int", "int64_t": "c_long", "uint64_t": "c_ulong", "double": "c_double",
    "char*": "c_char_p", "void*": "c_void_p", "mgdt_status": "c_int", "void": None,
    "int32_t*": "c_void_p", "int64_t*": "c_void_p", "double*": "c_void_p",
    "uint64_t*": "c_void_p", "mgdt_progress_fn*": "c_void_p", "void**": "LP_c_void_p",
    "mgdt_progress_fn": "CFunctionType", "mgdt_size_fn": "CFunctionType", "mgdt_size_fn*": "c_void_p",
    "mgdt_alloc_fn": "CFunctionType",
    "mgdt_free_fn": "CFunctionType", **handles,
}
declared = {}
for result, name, parameters in re.findall(r"MGDT_API ([^;(]*?)(mgdt_\w+)\(([^;]*?)\);", source):
    def kind(text):
        text = re.sub(r"\bconst\b", "", text).strip()
        match = re.fullmatch(r"(\w+)\s*(\**)\s*\w*", text)
        return kinds[match[1] + match[2]]
    inputs = [] if parameters == "void" else [kind(p) for p in parameters.split(",")]
    declared[name] = (kind(result + "x"), inputs)
assert len(declared) > 40
for name, (result, inputs) in _interface.FUNCTIONS.items():
    ours = [getattr(k, "__name__", None) for k in inputs]
    theirs = declared[name]
    assert (getattr(result, "__name__", None), ours) == theirs, (name, result, ours, theirs)
    function = getattr(_library.library, name)
    assert function.argtypes == inputs and function.restype == result
assert set(_interface.FUNCTIONS) == set(declared)
print(len(_interface.FUNCTIONS))
"""
        names = ("mgdt.h", "mgdt_voronoi.h", "mgdt_domain.h", "mgdt_mesh.h", "mgdt_periodic.h")
        result = run_python(program, *(str(headers / name) for name in names))
        self.assertEqual(result.stderr, "")
        self.assertGreater(int(result.stdout), 30)


if __name__ == "__main__":
    unittest.main()
