#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The binary interface: the headers, the version script and the library name the same functions,
the library needs the C++ runtime alone, and the headers compile as C99 and as C++.

  symbols_test.py --library libmgdt.so --headers mgdt.h mgdt_parts.h --map mgdt.map --cc CC --cxx CXX
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
from checks import check, differences, finish, output_of

# What the runtime of C and C++ brings; nothing else may be needed at run time.
RUNTIME = re.compile(r"^(libstdc\+\+|libc\+\+|libc\+\+abi|libm|libgcc_s|libc|libmvec|ld-linux[-\w]*)\.so")


def declared(header):
    text = re.sub(r"/\*.*?\*/", " ", header.read_text(), flags=re.S)
    text = re.sub(r"^\s*#.*?(?<!\\)$", " ", text, flags=re.M)
    return set(re.findall(r"MGDT_API\b[^;(]*?\b(mgdt_\w+)\s*\(", text))


def mapped(script):
    """Names by version node; anything that is not a plain name counts as a wildcard."""
    text = re.sub(r"/\*.*?\*/|#[^\n]*", " ", script.read_text(), flags=re.S)
    nodes, wildcards = {}, []
    for node, body in re.findall(r"([\w.]+)\s*\{(.*?)\}", text, flags=re.S):
        exported = re.split(r"\blocal\s*:", body)[0].replace("global:", " ")
        names = [n.strip() for n in exported.split(";") if n.strip()]
        wildcards += [n for n in names if not re.fullmatch(r"\w+", n)]
        nodes[node] = names
    return nodes, wildcards


def exported(library):
    found = {}
    for line in output_of("nm", "-D", "--defined-only", "--with-symbol-versions", library).splitlines():
        address, kind, name = line.split(maxsplit=2)
        if kind == "A":  # the version nodes themselves
            continue
        name, _, version = name.partition("@")
        found[name] = version.strip("@")
    return found


def initialisers(library):
    """Entries of .init_array: the compiler's own frame_dummy is the one that every library has."""
    match = re.search(r"\.init_array\s+INIT_ARRAY\s+[0-9a-f]+\s+[0-9a-f]+\s+([0-9a-f]+)",
                      output_of("readelf", "-SW", library))
    return int(match.group(1), 16) // 8 if match else 0


def compiles(command, source, suffix):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"header{suffix}"
        path.write_text(source)
        run = subprocess.run([*command, "-fsyntax-only", str(path)], capture_output=True, text=True)
        return run.stderr if run.returncode else ""


def with_handlers(library, names):
    """The functions whose frames have something to do when they are unwound. A thread of the asynchronous
    cancellation type is unwound through the frame of the function that it called, see run_inside()
    in src/capi/guard.hpp; a table there would end the process."""
    frames = re.findall(r" FDE .*?pc=([0-9a-f]+)\.\.[^\n]*\n(  Augmentation data:)?",
                        output_of("readelf", "--debug-dump=frames", library))
    tables = {int(address, 16): bool(data) for address, data in frames}
    symbols = re.findall(r"^([0-9a-f]+) T (mgdt_\w+)", output_of("nm", "-D", "--defined-only", library), flags=re.M)
    places = {name: int(address, 16) for address, name in symbols}
    return [name for name in sorted(names) if tables.get(places.get(name), True)]


def main():
    parser = argparse.ArgumentParser()
    for name in ("library", "map"):
        parser.add_argument(f"--{name}", type=Path, required=True)
    parser.add_argument("--headers", type=Path, nargs="+", required=True)
    parser.add_argument("--cc", required=True)
    parser.add_argument("--cxx", required=True)
    options = parser.parse_args()

    names = set().union(*map(declared, options.headers))
    nodes, wildcards = mapped(options.map)
    listed = [name for node in nodes.values() for name in node]
    symbols = exported(options.library)
    check("the headers declare functions", "" if len(names) > 40 else f"only {len(names)} found")
    check("the version script names each function once", " ".join(sorted(n for n in set(listed) if listed.count(n) > 1)))
    check("the version script has no wildcards", " ".join(wildcards))
    check("the version script names what the headers declare", differences(names, set(listed)))
    check("the library exports what the headers declare", differences(names, set(symbols)))
    check("each symbol has the version of its node",
          " ".join(f"{n}@{symbols.get(n)}" for v, node in nodes.items() for n in node if symbols.get(n) != v))

    dynamic = output_of("readelf", "-dW", options.library)
    needed = re.findall(r"\(NEEDED\).*\[(.*?)\]", dynamic)
    check("the library needs the C and C++ runtime alone", " ".join(n for n in needed if not RUNTIME.match(n)))
    check("the soname is libmgdt.so.1", "" if "[libmgdt.so.1]" in dynamic else dynamic)
    check("no code runs when the library is loaded",
          "" if initialisers(options.library) <= 1 else f"{initialisers(options.library)} initialisers")

    check("threads may be unwound through the functions", " ".join(with_handlers(options.library, names)))

    include = f"-I{options.headers[0].parent.parent}"
    strict = [include, "-Wall", "-Wextra", "-pedantic", "-Werror"]
    use = "".join(f"#include <mgdt/{header.name}>\n" for header in [*reversed(options.headers), *options.headers])
    use += "int main(void) { return mgdt_abi_version() != 1; }\n"
    cc, cxx = shlex.split(options.cc), shlex.split(options.cxx)
    check("the headers are C99", compiles([*cc, "-std=c99", *strict, "-Wstrict-prototypes", "-Wmissing-prototypes"], use, ".c"))
    check("the headers are C11", compiles([*cc, "-std=c11", *strict], use, ".c"))
    check("the headers are C++98 with <stdint.h>", compiles([*cxx, "-std=c++98", include, "-Wall", "-Werror"], use, ".cpp"))
    check("the headers are C++17", compiles([*cxx, "-std=c++17", *strict], use, ".cpp"))

    finish()


if __name__ == "__main__":
    main()
