# SPDX-License-Identifier: MIT
"""Wheels and the source distribution, built and installed without a network."""

import os
import pathlib
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest
import zipfile

SOURCE = pathlib.Path(os.environ["MGDT_SOURCE"])
LIBRARY = os.path.realpath(os.environ["MGDT_LIBRARY"])
USE = """
import sys, mgdt
tri = mgdt.Delaunay([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]])
tri.check()
print(mgdt.__file__, mgdt.library_path(), tri.nsimplex)
"""


class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        # Builds leave files beside the sources.
        shutil.copytree(
            SOURCE / "bindings" / "python",
            cls.folder / "bindings" / "python",
            symlinks=True,
            ignore=shutil.ignore_patterns("build", "dist", "*.egg-info", "__pycache__"),
        )
        shutil.copy(SOURCE / "LICENSE", cls.folder)
        cls.source = cls.folder / "bindings" / "python"

    def run_in(self, folder, *command, **environment):
        variables = {"PATH": "/usr/bin:/bin", "HOME": str(self.folder), "LC_ALL": "C.UTF-8"}
        result = subprocess.run(
            command,
            cwd=folder,
            env={**variables, **environment},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        self.assertEqual(result.returncode, 0, f"{command}\n{result.stdout}")
        return result.stdout

    def build(self, source, what, **environment):
        out = tempfile.mkdtemp(dir=self.folder)
        self.run_in(
            source,
            *(sys.executable, "-m", "build", "--no-isolation", what, "--outdir", out, "."),
            **environment,
        )
        (built,) = pathlib.Path(out).iterdir()
        return built

    def install(self, wheel):
        """A virtual environment with the wheel; gives its Python."""
        venv = tempfile.mkdtemp(dir=self.folder)
        self.run_in(
            self.folder, sys.executable, "-m", "venv", "--system-site-packages", venv
        )
        python = os.path.join(venv, "bin", "python")
        self.run_in(
            self.folder, *(python, "-m", "pip", "install", "--no-index", "--no-deps", str(wheel))
        )
        return python

    def use(self, python, **environment):
        elsewhere = tempfile.mkdtemp(dir=self.folder)
        file, library, count = self.run_in(
            elsewhere, python, "-W", "error", "-c", USE, **environment
        ).split()
        self.assertEqual(count, "2")
        self.assertTrue(file.startswith(os.path.dirname(os.path.dirname(python))), file)
        return pathlib.Path(file).parent, library

    def test_pure_wheel(self):
        wheel = self.build(self.source, "--wheel")
        self.assertEqual(wheel.name, "mgdt-1.4.0-py3-none-any.whl")
        with zipfile.ZipFile(wheel) as archive:
            names = archive.namelist()
        sources = {p.name for p in (self.source / "mgdt").iterdir() if p.is_file()}
        self.assertEqual({n[5:] for n in names if n.startswith("mgdt/")}, sources)
        self.assertIn("py.typed", sources)
        python = self.install(wheel)
        self.assertEqual(self.use(python, MGDT_LIBRARY=LIBRARY)[1], LIBRARY)
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(LIBRARY, os.path.join(folder, "libmgdt.so.1"))
            self.assertEqual(self.use(python, LD_LIBRARY_PATH=folder)[1], "libmgdt.so.1")

    def test_wheel_with_the_library(self):
        wheel = self.build(self.source, "--wheel", MGDT_BUNDLE_LIBRARY=LIBRARY)
        self.assertRegex(wheel.name, r"^mgdt-1\.4\.0-py3-none-linux_\w+\.whl$")
        package, library = self.use(self.install(wheel))
        self.assertEqual(library, str(package / "libmgdt.so.1"))
        # A pure wheel from the same folder afterwards brings nothing of it.
        after = self.build(self.source, "--wheel")
        self.assertTrue(after.name.endswith("py3-none-any.whl"))
        with zipfile.ZipFile(after) as archive:
            self.assertNotIn("mgdt/libmgdt.so.1", archive.namelist())

    def test_no_such_library(self):
        command = (sys.executable, "setup.py", "--version")
        result = subprocess.run(
            command,
            cwd=self.source,
            env={**os.environ, "MGDT_BUNDLE_LIBRARY": "/nowhere"},
            capture_output=True,
            text=True,
        )
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("MGDT_BUNDLE_LIBRARY names no file: /nowhere", result.stderr)

    def test_source_distribution(self):
        archive = self.build(self.source, "--sdist")
        self.assertEqual(archive.name, "mgdt-1.4.0.tar.gz")
        with tarfile.open(archive) as tar:
            licence = tar.extractfile("mgdt-1.4.0/LICENSE").read()
            self.assertTrue(all(m.isfile() or m.isdir() for m in tar.getmembers()))
            tar.extractall(self.folder / "sdist")
        self.assertEqual(licence, (SOURCE / "LICENSE").read_bytes())
        wheel = self.build(self.folder / "sdist" / "mgdt-1.4.0", "--wheel")
        self.use(self.install(wheel), MGDT_LIBRARY=LIBRARY)

    def test_meson_installs_every_file(self):
        listed = (SOURCE / "bindings" / "python" / "meson.build").read_text()
        for file in (self.source / "mgdt").iterdir():
            if file.is_file():
                self.assertIn(f"'mgdt/{file.name}'", listed)


if __name__ == "__main__":
    unittest.main()
