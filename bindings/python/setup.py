# SPDX-License-Identifier: MIT
"""The part of the build that pyproject.toml cannot say: a wheel that brings the library.

``MGDT_BUNDLE_LIBRARY=FILE`` puts FILE into the wheel as libmgdt.so.1, beside the package, and tags
the wheel with this platform. Without it the wheel is pure Python and uses the system's library.
"""

import os
import shutil

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py
from wheel.bdist_wheel import bdist_wheel

BUNDLED_NAME = "libmgdt.so.1"
library = os.environ.get("MGDT_BUNDLE_LIBRARY")
if library and not os.path.isfile(library):
    raise SystemExit(f"MGDT_BUNDLE_LIBRARY names no file: {library}")


class BuildWithLibrary(build_py):
    """Copies the library into the package."""

    def run(self):
        super().run()
        # What an earlier build left would make a pure wheel bring a library.
        bundled = os.path.join(self.build_lib, "mgdt", BUNDLED_NAME)
        if library and not self.editable_mode:
            shutil.copyfile(library, bundled)
        elif os.path.exists(bundled):
            os.remove(bundled)


class PlatformWheel(bdist_wheel):
    """Any Python 3, but one platform."""

    def get_tag(self):
        if not library:
            return super().get_tag()
        return "py3", "none", super().get_tag()[2]


class PlatformDistribution(Distribution):
    def has_ext_modules(self):
        return bool(library)


setup(
    cmdclass={"build_py": BuildWithLibrary, "bdist_wheel": PlatformWheel},
    distclass=PlatformDistribution,
)
