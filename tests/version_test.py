#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every file that names the version names that of meson.build: the header, the bindings, the packages, and
the first heading of the changelog.

Usage: version_test.py SOURCE
"""
import re
import sys
from pathlib import Path

from checks import check, finish

NAMES = [
    ("bindings/fortran/fpm.toml", r'^version = "(.*)"$'),
    ("bindings/python/mgdt/__init__.py", r'^__version__ = "(.*)"$'),
    ("bindings/ruby/mgdt.gemspec", r'gem\.version = "(.*)"'),
    ("bindings/rust/mgdt-sys/Cargo.toml", r'^version = "(.*)"$'),
    ("bindings/rust/mgdt/Cargo.toml", r'^version = "(.*)"$'),
    ("docs/changelog.md", r"^## ([\d.]+) "),
    ("docs/packaging/conda/meta.yaml", r'set version = "(.*)"'),
    ("docs/packaging/debian/changelog", r"^mgdt \((.*)-\d+\)"),
    ("docs/packaging/homebrew/mgdt.rb", r"/mgdt-([\d.]+)\.tar"),
    ("docs/packaging/meson/mgdt.wrap", r"^directory = mgdt-(.*)$"),
    ("docs/packaging/spack/package.py", r'^    version\("(.*?)"'),
    ("docs/packaging/vcpkg/vcpkg.json", r'"version": "(.*)"'),
]


def main():
    source = Path(sys.argv[1])
    version = re.search(r"version: '(.*)'", (source / "meson.build").read_text(encoding="utf-8")).group(1)
    header = (source / "include" / "mgdt" / "mgdt.h").read_text(encoding="utf-8")
    numbers = re.findall(r"#define MGDT_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", header)
    check("mgdt.h", "" if ".".join(numbers) == version else f"{numbers}, not {version}")
    for name, pattern in NAMES:
        found = re.search(pattern, (source / name).read_text(encoding="utf-8"), re.MULTILINE)
        check(name, "no version" if not found else "" if found.group(1) == version else
              f"{found.group(1)}, not {version}")
    finish()


if __name__ == "__main__":
    main()
