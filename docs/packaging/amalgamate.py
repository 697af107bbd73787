#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the library as one C++ file and its headers, for codes that keep the sources of what they use.

  amalgamate.py FOLDER

FOLDER gets mgdt.cpp, the folder mgdt of the headers, and LICENSE:

  g++ -std=c++17 -O3 -DNDEBUG -ffp-contract=off -I FOLDER -c FOLDER/mgdt.cpp

GCC compiles the kernels for AVX2 and AVX-512 in it too, other compilers the one without vectors; on arm64 both
have NEON's. What files of src define in namespaces without a name gets names that no other file has.
"""
import re
import shutil
import sys
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
SRC = SOURCE / "src"
# Kernels that are compiled for more than the whole, by what says that they can be.
AVX2 = "avx2,fma,bmi,bmi2,lzcnt,popcnt"
ISLANDS = {"MGDT_HAVE_X86_KERNELS": {"avx2": AVX2,
                                     "avx512": AVX2 + ",avx512f,avx512vl,avx512dq,avx512bw,prefer-vector-width=512"},
           "MGDT_HAVE_NEON_KERNEL": {"neon": ""}}
BEGIN = """#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#define MGDT_HAVE_X86_KERNELS
#include <immintrin.h>
#pragma GCC diagnostic ignored "-Wpsabi"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"
#elif defined(__GNUC__) && defined(__ARM_NEON) && defined(__aarch64__) && !defined(__AARCH64EB__)
#define MGDT_HAVE_NEON_KERNEL
#include <arm_neon.h>
#endif
namespace mgdt {
namespace scalar {}
using namespace scalar;
}  // namespace mgdt"""
LOCAL = re.compile(r'^#include "([^"]+)"\s*$')
SYSTEM = re.compile(r"^#include <([^>]+)>\s*$")
IN_ISLAND = re.compile(r"^#include MGDT_IN_ISLAND\((.*)\)\s*$")


def version():
    return re.search(r"version: '(.*)'", (SOURCE / "meson.build").read_text()).group(1)


def library_files():
    text = (SRC / "meson.build").read_text()
    lists = re.findall(r"files\((.*?)\)", text[:text.index("library_args")], re.DOTALL)
    return [SRC / name for part in lists for name in re.findall(r"'([\w/]+\.cpp)'", part)]


def private_names(text):
    """What a file defines in namespaces without a name: functions, which may have overloads elsewhere; and what is
    to be there once."""
    functions, others = set(), set()
    for start in re.finditer(r"^namespace \{$", text, re.MULTILINE):
        end = text.index("\n}  // namespace\n", start.end())
        # What is in a namespace with a name there has a name of its own.
        body = re.sub(r"^namespace (\w+) \{$.*?^\}  // namespace \1$", "", text[start.end():end],
                      flags=re.MULTILINE | re.DOTALL)
        others |= set(re.findall(r"^(?:struct|class|enum(?: class)?) (?:alignas\(\w+\) )?(\w+)", body, re.MULTILINE))
        others |= set(re.findall(r"^using (\w+) =", body, re.MULTILINE))
        for line in re.findall(r"^(?:constexpr|const|inline|std::|thread_local)[^;(]*?=[^;]*;", body, re.MULTILINE):
            others |= set(re.findall(r"[ *&](\w+)(?:\[[^]]*\])? =", line))
        functions |= set(re.findall(r"^(?!return|using|//|#|struct|class|enum|template|if|for)[\w:][^\n;={}]*?[ *&](\w+)\(",
                                    body, re.MULTILINE))
    functions |= set(re.findall(r"^static (?!_?assert)[^\n;={}]*?[ *&](\w+)\(", text, re.MULTILINE))
    return functions - {"operator", "decltype", "alignas"}, others


def renamed(text, old, new):
    """With another name for what the file defines: not members, nor what stands in other namespaces."""
    name = re.compile(rf"(?:(?<![\w.:>\"])|(?<=exact::)){old}\b")
    return "\n".join(line if line.startswith("#include") else name.sub(new, line) for line in text.split("\n"))


def own_part(text):
    """Of a header, what an island has for itself: the rest is there already, and to declare it again where other
    instructions are allowed would make another function of it."""
    includes = re.findall(r"^#include .*$", text, re.MULTILINE)
    blocks = re.findall(r"^inline namespace MGDT_ISLAND \{$.*?^\}  // namespace MGDT_ISLAND$", text, re.MULTILINE | re.DOTALL)
    return "\n".join([*includes, "namespace mgdt {", *blocks, "}"])


class Amalgamation:
    def __init__(self):
        self.seen, self.system, self.out = set(), [], []

    def header(self, name, island, here):
        """The text of a header and what it includes, where it is not there yet."""
        if name.startswith("mgdt/"):
            self.out.append(f'#include "{name}"')
            return
        path = next(p for p in (SRC / name, here / name) if p.is_file())
        text = path.read_text()
        is_of_island = ("namespace MGDT_ISLAND" in text or path.parent.parent == SRC / "kernel" or
                        "MGDT_IN_ISLAND(" in text and path.name != "island.hpp")
        key = (path, island if is_of_island else None)
        if key in self.seen:
            return
        self.seen.add(key)
        if island != "scalar" and "namespace MGDT_ISLAND" in text:
            text = own_part(text)
        self.lines(text, island, path.parent)

    def lines(self, text, island, here):
        for line in text.split("\n"):
            local, system, part = LOCAL.match(line), SYSTEM.match(line), IN_ISLAND.match(line)
            if local:
                self.header(local.group(1), island, here)
            elif part:
                self.header(f"kernel/{island}/{part.group(1)}", island, here)
            elif system and not line.startswith(" "):
                if system.group(1) not in ("cpuid.h", "immintrin.h", "arm_neon.h", "windows.h", "sys/mman.h"):
                    self.system.append(line)
                else:
                    self.out.append(line)
            elif line == "inline namespace MGDT_ISLAND {":
                # An argument's namespace brings in those that are inline in it, and so another island's functions.
                self.out.append(f"namespace {island} {{")
            elif line.startswith("#pragma once") or line.startswith("// SPDX"):
                continue
            else:
                self.out.append(line)


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    files = library_files()
    texts = {path: path.read_text() for path in files}
    # Words of each file, to see what another one has too.
    words = {path: set(re.findall(r"\w+", path.read_text())) for path in [*SRC.rglob("*.hpp"), *files]}
    private = {path: private_names(text) for path, text in texts.items()}
    whole = Amalgamation()
    for path in files:
        text = texts[path]
        functions, others = private[path]
        for name in sorted(functions | others):
            if any(name in one[0] | one[1] for file, one in private.items() if file != path) or (
                    name in others and any(name in other for file, other in words.items() if file != path)):
                text = renamed(text, name, f"{name}_of_{path.stem}")
        whole.out.append(f"// ---- {path.relative_to(SRC)}")
        whole.lines(text, "scalar", path.parent)
        whole.out += [f"#undef {macro}" for macro in re.findall(r"^#define (\w+)", text, re.MULTILINE)]
    for condition, islands in ISLANDS.items():
        whole.out.append(f"#if defined({condition})")
        for island, target in islands.items():
            whole.out += [f"// ---- kernel/{island}/kernel.cpp", "#undef MGDT_ISLAND", "#pragma GCC push_options"]
            if target:
                whole.out.append(f'#pragma GCC target("{target}")')
            text = (SRC / "kernel" / island / "kernel.cpp").read_text()
            whole.lines(text.replace("kernel_named(", f"{island}::kernel_named("), island, SRC / "kernel" / island)
            whole.out.append("#pragma GCC pop_options")
        whole.out.append("#endif")
    system = sorted(set(whole.system))
    (folder / "mgdt.cpp").write_text("\n".join(
        ["// SPDX-License-Identifier: MIT", f"// mgdt {version()}, written by docs/packaging/amalgamate.py.",
         f'#define MGDT_VERSION "{version()}"', "#define MGDT_BUILDING", *system, BEGIN, *whole.out]) + "\n")
    headers = SOURCE / "include" / "mgdt"
    shutil.copytree(headers, folder / "mgdt", ignore=shutil.ignore_patterns("mgdt_mpi.h", "meson.build"), dirs_exist_ok=True)
    shutil.copy(SOURCE / "LICENSE", folder)


main()
