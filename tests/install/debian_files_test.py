#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares what Meson installs with the .install files of the Debian packages: each file is in one package, and each
line of them names a file. Needs no packaging tools, so a header that was added is missed at once.

  debian_files_test.py SOURCE BUILD
"""
import fnmatch
import json
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from checks import check, finish, output_of

# What a tested build installs and the packages leave out, and what only a build of both kinds of libraries has.
NOT_PACKAGED = ["usr/bin/mgdt-bench", "usr/share/man/man1/mgdt-bench.1"]
NOT_BUILT = ["usr/lib/*/libmgdt.a", "usr/lib/*/libmgdt_mpi.a"]


def main(source, build):
    lines = {}  # the package of each pattern
    for file in sorted((Path(source) / "docs/packaging/debian").glob("*.install")):
        for line in file.read_text(encoding="utf-8").split("\n"):
            if line.strip():
                lines[line.split()[0]] = file.stem
    options = {option["name"]: option["value"] for option in json.loads(output_of("meson", "introspect", "--buildoptions", build))}
    prefix, libraries = Path(options["prefix"]), options["libdir"]

    def packaged(name):
        """As Debian has it: below /usr, with libraries in a folder of the processor's."""
        path = Path(name).relative_to(prefix)
        if path.is_relative_to(libraries):
            path = Path("lib/any") / path.relative_to(libraries)
        return str("usr" / path)

    installed = [packaged(name) for name in json.loads(output_of("meson", "introspect", "--installed", build)).values()]
    check("files are installed", "" if len(installed) > 50 else f"only {len(installed)}")

    def is_in(name, pattern):
        return fnmatch.fnmatchcase(name, pattern) or fnmatch.fnmatchcase(name, pattern + "/*")

    for name in sorted(set(installed) - set(NOT_PACKAGED)):
        packages = {package for pattern, package in lines.items() if is_in(name, pattern)}
        check(name, "" if len(packages) == 1 else f"in {' and '.join(sorted(packages)) or 'no package'}", names_passed=False)
    for pattern, package in lines.items():
        if pattern not in NOT_BUILT:
            found = any(is_in(name, pattern) or is_in(pattern, name) for name in installed)
            check(f"{pattern} of {package}", "" if found else "is not installed", names_passed=False)
    finish()


if __name__ == "__main__":
    main(*sys.argv[1:])
