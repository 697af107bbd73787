#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""No include goes against the order of folders that docs/architecture.md gives, and what is written
for one instruction set alone stands in its island, a folder below src/kernel, or in src/platform.
Within an island, intrinsics stand behind the types of the files of VECTORS.

  includes_test.py SOURCE
"""
import re
import sys
from pathlib import Path

source = Path(sys.argv[1])
sys.path.insert(0, str(source / "tests"))
from checks import check, finish

VECTORS = {"vector.hpp", "four_words.hpp", "transpose.hpp"}
# The programs call the C interface; see architecture.md. That of ranks is made with the exchange of libmgdt_mpi.
PROGRAM = {"cli", "mgdt", "predicates", "platform"}
INTRINSICS = re.compile(r"#\s*include\s*<\w*(?:intrin|arm_neon|arm_sve)\.?\w*>|\b_mm\d*_\w+\(|"
                        r"\b__(?:AVX|SSE|FMA|BMI|ARM_NEON)\w*")


def ranks():
    """Each folder's place in the order, platform first."""
    text = (source / "docs" / "architecture.md").read_text(encoding="utf-8")
    chain = re.search(r"`(capi(?: -> [\w, ]+)+)`", text).group(1)
    levels = [level.split(", ") for level in chain.split(" -> ")]
    return {folder: -place for place, level in enumerate(levels) for folder in level}


def wrong_includes(name, text, rank):
    folder = name.parts[0]
    for included in re.findall(r'#include "([^/"]*)(?:/|")', text):
        if folder in ("bench", "cli"):
            if included not in PROGRAM | {folder}:
                yield included
        elif folder == "mpi":  # a library of its own, over the C interface
            if included not in ("mpi", "mgdt"):
                yield included
        elif included not in (folder, "mgdt") and rank.get(included, 1) >= rank[folder]:
            yield included


def core_ranks():
    """The row of each file of src/core in the table of docs/architecture.md."""
    text = (source / "docs" / "architecture.md").read_text(encoding="utf-8")
    table = text[text.index("| file of `src/core/` |"):].split("\n\n")[0].splitlines()[2:]
    return {name: row for row, line in enumerate(table) for name in re.findall(r"`(\w+)`", line.split("|")[1])}


def later_in_core(name, text, rank):
    """What a file of src/core includes that stands below it in the table."""
    return [included for included in re.findall(r'#include "core/(\w+)\.hpp"', text)
            if rank.get(included, 99) > rank.get(name, -1)]


def main():
    rank = ranks()
    of_core = core_ranks()
    names = {p.stem for p in (source / "src" / "core").iterdir() if p.is_file()}
    check("the table of core has each file", " ".join(sorted(names ^ set(of_core))))
    check("a later file of core is seen", "" if later_in_core("state", '#include "core/removal.hpp"\n', of_core) else "not")
    folders = {p.name for p in (source / "src").iterdir() if p.is_dir() and any(p.glob("*.cpp"))}
    check("the order has each folder", " ".join(sorted(folders ^ (set(rank) | {"bench", "cli"}))))
    islands = {p.name for p in (source / "src" / "kernel").iterdir() if p.is_dir()}
    seen = 0
    for path in sorted((source / "src").rglob("*.[ch]*")):
        name = path.relative_to(source / "src")
        text = path.read_text(encoding="utf-8")
        problems = [f"includes {other}/" for other in wrong_includes(name, text, rank)]
        if name.parts[0] == "core":
            problems += [f"includes {later}, which is later" for later in later_in_core(name.stem, text, of_core)]
        if name.parts[:2] == ("kernel", "avx2") and "kernel/avx512/" in text:
            problems.append("includes kernel/avx512/")
        may_have_intrinsics = name.parts[0] == "platform" or (
            name.parts[0] == "kernel" and name.parts[1] in islands and name.name in VECTORS)
        if not may_have_intrinsics:
            problems += [f"has {match.group()}" for match in INTRINSICS.finditer(text)]
        check(str(name), "; ".join(problems), names_passed=False)
        seen += 1
    check("there are sources", "" if seen > 100 else f"only {seen}")
    # What is looked for is found where it is.
    vector = (source / "src" / "kernel" / "avx2" / "vector.hpp").read_text(encoding="utf-8")
    check("intrinsics are seen", "" if INTRINSICS.search(vector) else "none in avx2/vector.hpp")
    check("an include upwards is seen",
          "" if list(wrong_includes(Path("mesh"), '#include "kernel/kernel.hpp"\n', rank)) else "not")
    check("one without its folder",
          "" if list(wrong_includes(Path("mesh"), '#include "mesh.hpp"\n', rank)) else "not")
    check("and one beside", "" if list(wrong_includes(Path("order"), '#include "kernel/walk.hpp"\n', rank)) else "not")
    finish()


if __name__ == "__main__":
    main()
