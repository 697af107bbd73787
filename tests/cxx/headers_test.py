#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The C++ header under both compilers, both standards and the strictest warnings, without RTTI;
what must not compile, does not; and its inline functions share no symbol with the library's inside.

  headers_test.py --include DIRECTORY --library DIRECTORY --archive FILE --source FILE COMPILER...
"""
import argparse
import functools
import os
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
sys.path.append(str(Path(__file__).resolve().parents[1]))
import checks

WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wsign-conversion", "-Wshadow",
            "-Wold-style-cast", "-Werror"]
# What must be refused, and a word of the message that says why.
REFUSED = {
    "a copy": ("mgdt::Triangulation t, u(t);", "deleted"),
    "an assignment of a copy": ("mgdt::Triangulation t, u; u = t;", "deleted"),
    "points of floats": ("mgdt::Triangulation t; t.insert(std::vector<float>(3));", "no matching"),
    "points in the plane": ("mgdt::Triangulation t; t.insert(std::vector<std::array<double, 2>>(3));", "no matching"),
    "indices without sign": ("mgdt::Triangulation t; std::vector<unsigned> v(4); t.tetrahedra(v);", "std::int64_t or std::int32_t"),
    "a vector of 16-bit indices": ("mgdt::Triangulation t; auto v = t.edges<short>(); (void)v;", "std::int64_t or std::int32_t"),
    "triples for tetrahedra": ("mgdt::Triangulation t; std::vector<std::array<std::int64_t, 3>> v; t.tetrahedra(v);", "as many of them"),
    "a constant buffer": ("mgdt::Triangulation t; const std::vector<std::int64_t> v(4); t.tetrahedra(v);", ""),
    "two widths at once": ("mgdt::Triangulation t; std::vector<int32_t> a; std::vector<int64_t> b; t.vertex_tetrahedra(a, b);", "same kind"),
    "weights of floats": ("mgdt::Triangulation t; std::vector<int64_t> a; std::vector<float> w; t.locate_points(std::vector<double>(), a, w);", "weights are doubles"),
    "a callback without the fraction": ("mgdt::Triangulation t; t.set_progress([] {});", "no matching"),
    "a result that is thrown away": ("mgdt::Triangulation t; t.tetrahedra();", "nodiscard"),
    "a point of four": ("struct P { double x, y, z, w; };\ntemplate <> struct mgdt::is_point<P> : std::true_type {};\n"
                        "mgdt::Points f() { return mgdt::Points(std::vector<P>(1)); }", "three doubles"),
}

check = functools.partial(checks.check, names_passed=False)


def main():
    parser = argparse.ArgumentParser()
    for name in ("include", "library", "archive", "source"):
        parser.add_argument(f"--{name}", type=Path, required=True)
    parser.add_argument("compilers", nargs="+")
    options = parser.parse_args()
    environment = dict(os.environ, LD_LIBRARY_PATH=str(options.library))

    def compile_(compiler, *arguments):
        run = subprocess.run([compiler, f"-I{options.include}", *WARNINGS, *map(str, arguments)],
                             capture_output=True, text=True)
        return run.stderr.strip() if run.returncode else None

    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for compiler in options.compilers:
            for standard in ("17", "20"):
                flags = [f"-std=c++{standard}", "-fno-rtti"]
                what = f"{Path(compiler).name}, C++{standard}"
                problem = compile_(compiler, *flags, "-O1", options.source, "-o", folder / "use",
                                   f"-L{options.library}", "-lmgdt")
                check(f"{what}: a program without RTTI", problem)
                if problem is None:
                    run = subprocess.run([str(folder / "use")], env=environment, capture_output=True, text=True)
                    check(f"{what}: it runs", "" if run.returncode == 0 else f"status {run.returncode}: {run.stdout}{run.stderr}")
                for case, (text, word) in REFUSED.items():
                    body = text if text.startswith("struct") else f"void f() {{ {text} }}"
                    (folder / "refused.cpp").write_text(f"#include <mgdt/mgdt.hpp>\n{body}\n")
                    problem = compile_(compiler, *flags, "-fsyntax-only", folder / "refused.cpp")
                    check(f"{what}: {case} is refused",
                          "it compiles" if problem is None else
                          "" if word in problem else f"not because of '{word}': {problem}")
            (folder / "old.cpp").write_text("#include <mgdt/mgdt.hpp>\n")
            problem = compile_(compiler, "-std=c++14", "-fsyntax-only", folder / "old.cpp")
            check(f"{Path(compiler).name}: C++14 is told what it lacks", "" if problem and "needs C++17" in problem else problem or "it compiles")

            if "clang" in Path(compiler).name:
                by_rules_of_msvc(options.source, folder, compile_)

            # In a static link the library's own functions would take the place of inline ones.
            problem = compile_(compiler, "-std=c++17", "-O0", "-c", options.source, "-o", folder / "use.o")
            check(f"{Path(compiler).name}: an object file", problem)
            own = symbols("-C", folder / "use.o", prefix="mgdt::")
            inside = symbols("-C", options.archive, prefix="mgdt::")
            check("there are symbols to compare", "" if len(own) > 50 and len(inside) > 50 else f"{len(own)} and {len(inside)}")
            check(f"{Path(compiler).name}: no symbol of the library's inside", "; ".join(sorted(own & inside)))
    checks.finish()


def by_rules_of_msvc(source, folder, compile_):
    """No extension of GNU's is in the headers: C's are compiled for Microsoft's systems, without their C
    library, and C++'s with Microsoft's rules, but with this system's C++ library."""
    c, both = folder / "both.c", ["-Wgnu", "-fsyntax-only"]
    c.write_text("#include <mgdt/mgdt.h>\n#include <mgdt/mgdt_domain.h>\n#include <mgdt/mgdt_mesh.h>\n#include <mgdt/mgdt_parts.h>\n#include <mgdt/mgdt_periodic.h>\n#include <mgdt/mgdt_voronoi.h>\n")
    clang = "clang"
    for processor in ("x86_64", "aarch64"):
        target = [f"--target={processor}-pc-windows-msvc", "-ffreestanding", *both, "-x"]
        for language in (["c", "-std=c99", "-Wno-old-style-cast"], ["c++", "-std=c++17"]):
            problem = compile_(clang, *target, *language, c)
            check(f"{language[0]} for Microsoft's {processor}", problem)
    (folder / "gnu.h").write_text("__typeof__(1) f(void);\nint g(int x) { return ({ x; }); }\n")
    problem = compile_(clang, *both, "-x", "c", "-std=c99", folder / "gnu.h")
    check("an extension is seen", "" if problem else "not")
    # The library of this system asks for these two.
    problem = compile_("clang++", "-std=c++17", "-fms-compatibility", "-fms-compatibility-version=19.30",
                       "-fdelayed-template-parsing", "-D__STRICT_ANSI__", "-D__GCC_ATOMIC_TEST_AND_SET_TRUEVAL=1",
                       "-Wno-builtin-macro-redefined", *both, source)
    check("C++ by Microsoft's rules", problem)


def symbols(*arguments, prefix):
    lines = checks.output_of("nm", "--defined-only", "-f", "posix", *arguments).splitlines()
    names = (line.rsplit(" ", 3)[0] if line.count(" ") > 2 else line for line in lines)
    return {n for n in names if prefix in n}


if __name__ == "__main__":
    main()
