#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The types of the binary interface, by libabigail: the library has what the baseline of a release
says, and the comparison notices every kind of change.

  abidiff_test.py --library FILE --headers FILE... --frozen FILE... --baseline FILE --suppressions FILE --cc CC
  abidiff_test.py --write --frozen FILE... --baseline FILE --cc CC      makes the baseline

Frozen headers are given oldest first; the baseline is that of the last one, and the others tell in
which version node a function is. A baseline is made of the header: each of its functions, empty,
compiled as C. So it holds the public types alone, and nothing of the compiler's libraries or of the
machine. The library needs debug information, or there would be no types to compare.
"""
import argparse
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
sys.path.append(str(Path(__file__).resolve().parents[1]))
from checks import check, finish, output_of
import interface

# What a compiled program would not survive: in the header, what becomes of it.
INCOMPATIBLE = [
    ("a narrower parameter", r"int64_t n_points", "int32_t n_points"),
    ("a wider parameter", r"int32_t key, double value", "int64_t key, double value"),
    ("another kind of number", r"double value\)", "float value)"),
    ("another sign", r"uint64_t seed", "int64_t seed"),
    ("one parameter more", r"int64_t stride\)", "int64_t stride, int32_t more)"),
    ("one parameter less", r"(mgdt_check\(const mgdt_triangulation ?\* ?t), int32_t level\)", r"\1)"),
    ("parameters that changed places", r"int64_t capacity, char ?\* ?buffer", "char *buffer, int64_t capacity"),
    ("a pointer for a value", r"int32_t on\)", "int32_t *on)"),
    ("an array of other integers", r"(mgdt_get_edges\([^;]*)int64_t ?\* ?v\)", r"\1int32_t *v)"),
    ("a narrower result", r"int64_t mgdt_point_count", "int32_t mgdt_point_count"),
    ("a result where there was none", r"void mgdt_destroy", "int32_t mgdt_destroy"),
    ("another status type", r"typedef int32_t mgdt_status", "typedef int64_t mgdt_status"),
    ("another callback", r"\(double fraction, void", "(float fraction, void"),
    ("another allocator", r"\(\*mgdt_free_fn\)\(void ?\* ?p, size_t size, size_t align", "(*mgdt_free_fn)(void *p, size_t size"),
    ("a function gone", r"MGDT_API mgdt_status mgdt_clear\([^;]*;", ""),
    ("a function renamed", r"\bmgdt_nearest_vertex\b", "mgdt_closest_vertex"),
]


def describe(library):
    """The interface as XML, without any path."""
    return output_of("abidw", "--no-corpus-path", "--no-comp-dir-path", "--no-show-locs", "--no-elf-needed",
                     "--drop-private-types", "--headers-dir", library.parent, library)


def compare(baseline, library, *options):
    """Exit status of abidiff (bit 0: an error, bit 2: a change, bit 3: one that breaks) and its report."""
    run = subprocess.run(["abidiff", "--fail-no-debug-info", *options, str(baseline), str(library)],
                         capture_output=True, text=True)
    return run.returncode, run.stdout + run.stderr


def main():
    parser = argparse.ArgumentParser()
    for name in ("library", "baseline", "suppressions"):
        parser.add_argument(f"--{name}", type=Path)
    parser.add_argument("--headers", type=Path, nargs="+")
    parser.add_argument("--frozen", type=Path, nargs="+", required=True)
    parser.add_argument("--cc", required=True)
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    cc = shlex.split(options.cc)
    frozen = options.frozen[-1].read_text()
    nodes = interface.nodes_of(options.frozen)

    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        old = interface.empty_library(cc, frozen, interface.version_script(frozen, nodes), folder / "frozen")
        if options.write:
            options.baseline.write_text(describe(old))
            return 0

        text = options.baseline.read_text()
        check("the baseline has all functions of the frozen header",
              " ".join(n for _, n, _ in interface.functions(frozen)
                       if text.count(f"<function-decl name='{n}'") != 1))
        check("the baseline has no path", " ".join(re.findall(r"='[^'\n]*/[^'\n]*'", text)))
        status, report = compare(options.baseline, old, "--harmless")
        check("the baseline is that of the frozen header", report if status else "")

        rules = ["--no-added-syms", "--suppressions", str(options.suppressions)]
        # In one text; a header comes after those that it includes.
        header = re.sub(r'^#include "mgdt\w*\.h"$', "", "\n".join(path.read_text() for path in options.headers),
                        flags=re.M)
        now = interface.empty_library(cc, header, interface.version_script(header, nodes), folder / "now")
        status, report = compare(options.baseline, now, *rules)
        check("the header is compatible with the baseline", report if status else "")
        status, report = compare(options.baseline, options.library, *rules)
        check("the library is compatible with the baseline", report if status else "")

        for k, (what, pattern, replacement) in enumerate(INCOMPATIBLE):
            changed = re.sub(pattern, replacement, frozen)
            if changed == frozen:
                check(f"{what} is noticed", f"nothing in the header is like {pattern}")
                continue
            library = interface.empty_library(cc, changed, interface.version_script(changed, nodes), folder / str(k))
            status, report = compare(options.baseline, library, *rules)
            # An error of abidiff itself (bits 0 and 1) is no change that was noticed.
            check(f"{what} is noticed", "" if status & 12 and not status & 3 else f"status {status}: {report}")

        # What may be done: a new function, in a node of its own.
        more = frozen.replace("MGDT_API mgdt_status mgdt_clear(", "MGDT_API mgdt_status mgdt_new(int32_t a);\n"
                              "MGDT_API mgdt_status mgdt_clear(")
        script = interface.version_script(more, nodes)
        status, report = compare(options.baseline, interface.empty_library(cc, more, script, folder / "more"), *rules)
        check("a new function is no change", report if status else "")
        # But not a function that moved to another node: programs ask for it by the old one.
        script = interface.version_script(frozen, {**nodes, "mgdt_clear": interface.LATER})
        moved = interface.empty_library(cc, frozen, script, folder / "moved")
        status, report = compare(options.baseline, moved, *rules)
        check("a function that moved to another node is noticed",
              "" if status & 12 and not status & 3 else f"status {status}: {report}")
    finish()


if __name__ == "__main__":
    main()
