# SPDX-License-Identifier: MIT
"""The part of the build that pyproject.toml cannot say: a wheel that brings the library.

Where mgdt's C++ sources are there too, in the repository and in a source distribution made in it,
the library is built with Meson and put into the wheel as libmgdt.so.1, beside the package.
``MGDT_BUNDLE_LIBRARY=FILE`` puts FILE there instead, ``MGDT_BUNDLE_LIBRARY=none`` nothing. A wheel
without a library is pure Python and uses the system's.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py
from setuptools.command.sdist import sdist
from wheel.bdist_wheel import bdist_wheel

BUNDLED_NAME = "libmgdt.so.1"
HERE = pathlib.Path(__file__).resolve().parent
IN_DISTRIBUTION = HERE / "native"
# What Meson reads to build the library alone.
NATIVE = ["meson.build", "meson_options.txt", "LICENSE", "README.md", "include", "src", "bindings", "docs/meson.build",
          "docs/installed.py"]
OPTIONS = ["--buildtype=release", "-Ddefault_library=shared", "-Dtests=disabled", "-Dprogram=disabled",
           "-Dmpi=disabled", "-Ddocs=false", "-Dbindings=none",
           # The C++ runtime goes into the library: the one of another system may be older.
           "-Dcpp_link_args=-static-libstdc++ -static-libgcc"]


def native_sources():
    """The folder of the C++ sources, or None."""
    for folder in (IN_DISTRIBUTION, HERE.parent.parent):
        if (folder / "src" / "mgdt.map").is_file():
            return folder
    return None


library = os.environ.get("MGDT_BUNDLE_LIBRARY", "")
if library not in ("", "none") and not os.path.isfile(library):
    raise SystemExit(f"MGDT_BUNDLE_LIBRARY names no file: {library}")
# Elsewhere than on Linux the library has another name, and its runtime cannot be put into it so.
can_build = sys.platform == "linux" and native_sources() is not None
brings_library = library != "none" and (bool(library) or can_build)


def build_library(folder):
    """Builds the library in a folder; gives its file."""
    build = pathlib.Path(folder).resolve() / "libmgdt"
    if not (build / "build.ninja").is_file():
        subprocess.run(["meson", "setup", build, native_sources(), *OPTIONS], check=True)
    subprocess.run(["meson", "compile", "-C", build], check=True)
    return str(build / "src" / BUNDLED_NAME)


def platform_tag(file, plain):
    """The tag of the oldest systems that have what a library needs: manylinux_2_N of PEP 600, where that
    is the C library of version 2.N alone; else the plain tag, which says nothing of versions."""
    readelf = shutil.which("readelf")
    machine = re.fullmatch(r"linux_(\w+)", plain)
    if not readelf or not machine:
        return plain
    said = subprocess.run([readelf, "--wide", "--dynamic", "--version-info", file], check=True,
                          capture_output=True, text=True, env={**os.environ, "LC_ALL": "C"}).stdout
    needed = re.findall(r"\(NEEDED\).*\[(.*)\]", said)
    if not all(re.match(r"(libc|libm|libpthread|libdl|librt|ld-linux[\w-]*)\.so\.", name) for name in needed):
        return plain
    versions = [int(minor) for minor in re.findall(r"Name: GLIBC_2\.(\d+)", said)]
    return f"manylinux_2_{max(versions)}_{machine.group(1)}" if versions else plain


class BuildWithLibrary(build_py):
    """Puts the library into the package."""

    def run(self):
        super().run()
        # What an earlier build left would make a pure wheel bring a library.
        bundled = os.path.join(self.build_lib, "mgdt", BUNDLED_NAME)
        if brings_library and not self.editable_mode:
            built = library or build_library(self.get_finalized_command("build").build_temp)
            shutil.copyfile(built, bundled)
        elif os.path.exists(bundled):
            os.remove(bundled)


class PlatformWheel(bdist_wheel):
    """Any Python 3, but one platform."""

    def get_tag(self):
        plain = super().get_tag()
        if not brings_library:
            return plain
        bundled = os.path.join(self.get_finalized_command("build").build_lib, "mgdt", BUNDLED_NAME)
        # An editable wheel is tagged before there is anything in it.
        return "py3", "none", platform_tag(bundled, plain[2]) if os.path.exists(bundled) else plain[2]


class DistributionWithSources(sdist):
    """A source distribution, with the library's sources where they are there."""

    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        sources = native_sources()
        for name in NATIVE if sources else []:
            target = pathlib.Path(base_dir) / "native" / name
            target.parent.mkdir(parents=True, exist_ok=True)
            if (sources / name).is_dir():
                ignored = shutil.ignore_patterns("__pycache__", "*.egg-info", "build", "dist", "native")
                shutil.copytree(sources / name, target, ignore=ignored)
            else:
                shutil.copyfile(sources / name, target)
                shutil.copymode(sources / name, target)


class PlatformDistribution(Distribution):
    def has_ext_modules(self):
        return brings_library


# What builds the library is fetched only where it is needed and not there.
tools = {"meson": "meson>=1.0", "ninja": "ninja"}
needs = [package for command, package in tools.items()
         if brings_library and not library and not shutil.which(command)]
setup(
    cmdclass={"build_py": BuildWithLibrary, "bdist_wheel": PlatformWheel, "sdist": DistributionWithSources},
    distclass=PlatformDistribution,
    setup_requires=needs,
)
