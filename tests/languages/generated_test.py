#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The raw layers of the bindings are what bindings/interface/generate.py writes, byte for byte; and it
refuses a header or a description from which it cannot write them, with the function's name.

  generated_test.py SOURCE
"""
import re
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

sys.dont_write_bytecode = True  # the source tree stays as it is
source = Path(sys.argv[1])
sys.path[:0] = [str(source / "tests"), str(source / "bindings" / "interface")]
import generate
import header
from description import TRIANGULATION
from parts import PARTS
from checks import check, finish

HEADERS = source / "include" / "mgdt"
HEADER = HEADERS / "mgdt.h"


def added(declaration, comment="@since 1.2"):
    """The header with one more function."""
    text = HEADER.read_text(encoding="utf-8")
    where = text.index("/* ---", text.index("mgdt_check("))
    return f"{text[:where]}/** {comment} */\nMGDT_API {declaration};\n\n{text[where:]}"


def read(text):
    with TemporaryDirectory() as folder:
        path = Path(folder) / "mgdt.h"
        path.write_text(text, encoding="utf-8")
        return header.read(path, TRIANGULATION)


def files_of(text):
    """The files for this text of mgdt.h."""
    with TemporaryDirectory() as folder:
        for path in HEADERS.glob("*.h"):
            (Path(folder) / path.name).write_text(path.read_text(encoding="utf-8"), encoding="utf-8")
        (Path(folder) / "mgdt.h").write_text(text, encoding="utf-8")
        return generate.all_files(generate.read_all(Path(folder)))


def refused(what, text, *words, **lengths):
    """Checks that the error has the words."""
    TRIANGULATION.lengths.update(lengths)
    try:
        read(text)
        check(what, "nothing was refused")
    except header.DescriptionError as error:
        check(what, "" if all(word in str(error) for word in words) else str(error))
    for name in lengths:
        del TRIANGULATION.lengths[name]


def main():
    files = generate.all_files(generate.read_all())
    check("files are written", "" if len(files) == 32 else " ".join(files))
    for name, text in files.items():
        path = source / "bindings" / name
        is_same = path.is_file() and path.read_text(encoding="utf-8") == text
        check(name, "" if is_same else "differs; run bindings/interface/generate.py")

    handle = "mgdt_triangulation *t"
    new = "mgdt_status mgdt_new"
    refused("no length", added(f"{new}({handle}, int64_t n, const double *xyz)"), "mgdt_new", "xyz")
    refused("a length of no count", added(f"{new}({handle}, int64_t n, const double *xyz)"),
            "mgdt_new", "m", mgdt_new={"xyz": "3*m"})
    refused("an array that is not there", added(f"{new}({handle}, int64_t n)"), "mgdt_new", "xyz",
            mgdt_new={"xyz": "3*n"})
    refused("a type that is not known", added(f"{new}({handle}, float x)"), "mgdt_new", "float")
    refused("a twin alone", added(f"mgdt_status mgdt_new_i32({handle})"), "mgdt_new_i32")
    refused("a twin that differs", added(f"mgdt_status mgdt_check_i32(const {handle}, double level)"),
            "mgdt_check_i32", "mgdt_check")
    refused("no version", added(f"{new}({handle})", "Does something."), "mgdt_new", "@since")
    refused("a function that is gone", HEADER.read_text(encoding="utf-8"), "mgdt_gone",
            mgdt_gone={"v": "n"})
    refused("a constant without a name in FORTRAN 77",
            HEADER.read_text(encoding="utf-8").replace("MGDT_CHECK_CANONICAL = 3",
                                                       "MGDT_CHECK_CANONICAL = 3, MGDT_CHECK_MORE = 4"),
            "MGDT_CHECK_MORE")

    # The same of another header, which knows the types of mgdt.h.
    parts = (HEADERS / "mgdt_parts.h").read_text(encoding="utf-8")
    with TemporaryDirectory() as folder:
        path = Path(folder) / "mgdt_parts.h"
        path.write_text(parts.replace("MGDT_PARTS_RECEIVED", "MGDT_PARTS_NEW"), encoding="utf-8")
        try:
            header.read(path, PARTS, [header.read(HEADER, TRIANGULATION)])
            check("a constant of parts without a name", "nothing was refused")
        except header.DescriptionError as error:
            check("a constant of parts without a name", "" if "MGDT_PARTS_" in str(error) else str(error))

    text = HEADER.read_text(encoding="utf-8").replace("mgdt_shrink(mgdt_tri", "mgdt_shrunk(mgdt_tri")
    try:
        files_of(text)
        check("what a template asks for in vain", "nothing was refused")
    except header.DescriptionError as error:
        words = ("mgdt_f77.f90.fypp", "mgdt_life.f90.fypp", "mgdt.f90.fypp")
        good = "mgdt_shrink" in str(error) and any(word in str(error) for word in words)
        check("what a template asks for in vain", "" if good else str(error))

    # One more function is in every raw layer. The Fortran procedures wait for a line in a template.
    TRIANGULATION.lengths["mgdt_new"] = {"xyz": "3*n", "found": "n"}
    arguments = f"const {handle}, int64_t n, const double *xyz, "
    text = added(f"{new}({arguments}int64_t *found);\n/** @since 1.2 */\n"
                 f"MGDT_API mgdt_status mgdt_new_i32({arguments}int32_t *found)")
    for name, written in files_of(text).items():
        is_raw = not re.search("parts|mpi", name) and (not name.startswith("fortran/") or name.endswith("mgdt_c.f90"))
        if is_raw:
            check(f"a new function in {name}", "" if "new_i32" in written else "missing")
    finish()


if __name__ == "__main__":
    main()
