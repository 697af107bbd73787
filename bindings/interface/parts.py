# SPDX-License-Identifier: MIT
"""The constants of mgdt_parts.h, for the bindings of parts and of MPI, which are written by hand."""

from __future__ import annotations

import re
import textwrap
from pathlib import Path

from header import Constant, DescriptionError, comments_of_constants

HEADER = Path(__file__).resolve().parents[2] / "include" / "mgdt" / "mgdt_parts.h"

# What FORTRAN 77 calls them, in the order of the header.
F77_NAMES = {
    "options (MGMOPT)": {
        "INDEX_BASE": "MGQBAS", "THREADS": "MGQTHR", "MEMORY_LIMIT": "MGQMEM"},
    "numbers (MGMNUM)": {
        "PARTS": "MGQPRT", "FIRST_LOCAL": "MGQFLO", "LOCAL_PARTS": "MGQNLO", "POINTS": "MGQPTS",
        "OWN_VERTICES": "MGQOVT", "VERTICES": "MGQNVT", "ALL_VERTICES": "MGQAVT",
        "OWN_TETRAHEDRA": "MGQOTE", "TETRAHEDRA": "MGQNTE", "ALL_TETRAHEDRA": "MGQATE",
        "RECEIVED": "MGQREC", "MEMORY_BYTES": "MGQBYT"},
    "arrays (MGMARR)": {
        "POINT_MAP": "MGQMAP", "VERTEX_NUMBERS": "MGQVNU", "VERTEX_IDS": "MGQVID",
        "VERTEX_OWNERS": "MGQVOW", "VERTEX_RANGES": "MGQVRA", "CORNERS": "MGQCOR",
        "LOCAL_CORNERS": "MGQLCO", "TETRAHEDRON_NUMBERS": "MGQTNU",
        "TETRAHEDRON_OWNERS": "MGQTOW", "TETRAHEDRON_RANGES": "MGQTRA", "NEIGHBORS": "MGQNBR"},
}

ORIGIN = "Generated from mgdt/mgdt_parts.h by bindings/interface/generate.py."

FORTRAN_HEAD = f"""\
! SPDX-License-Identifier: MIT
! {ORIGIN}
!
! The options, numbers and arrays of parts. Comments are those of the header.
module mgdt_parts_constants
    implicit none
    public

"""

F77_HEAD = f"""\
! SPDX-License-Identifier: MIT
! {ORIGIN}
!
! INCLUDE this after IMPLICIT statements, beside mgdt_f77.inc. Each line says what mgdt_parts.h
! calls the number; docs/mpi.md says what each means.
"""


def constants() -> list[Constant]:
    text = HEADER.read_text(encoding="utf-8")
    comments = comments_of_constants(text)
    found = [Constant(name, int(value), comments.get(name, ""))
             for name, value in re.findall(r"^\s*(MGDT_PARTS_\w+) = (\d+)", text, flags=re.M)]
    named = ["MGDT_PARTS_" + name for group in F77_NAMES.values() for name in group]
    if [c.name for c in found] != named:
        raise DescriptionError("the constants of mgdt_parts.h are not those of parts.py, in their order")
    return found


def fortran() -> str:
    text = FORTRAN_HEAD
    for constant in constants():
        text += "".join(f"    ! {line}\n" for line in textwrap.wrap(constant.comment, 94))
        text += f"    integer, parameter :: {constant.name.lower()} = {constant.value}\n"
    return text + "end module mgdt_parts_constants\n"


def f77() -> str:
    values = {c.name: c.value for c in constants()}
    text = F77_HEAD
    for title, group in F77_NAMES.items():
        text += f"! {title}\n"
        names = list(group.values())
        for i in range(0, len(names), 6):
            text += f"      INTEGER {', '.join(names[i:i + 6])}\n"
        for name, short in group.items():
            text += f"      PARAMETER ({short} = {values['MGDT_PARTS_' + name]}) ! MGDT_PARTS_{name}\n"
    return text


def python() -> str:
    text = (f"# SPDX-License-Identifier: MIT\n# {ORIGIN}\n"
            '"""The options, numbers and arrays of parts, by name."""\n\nfrom __future__ import annotations\n\n')
    values = {c.name: c.value for c in constants()}
    for (_, group), table in zip(F77_NAMES.items(), ("OPTIONS", "NUMBERS", "ARRAYS")):
        entries = "".join(f'    "{name.lower()}": {values["MGDT_PARTS_" + name]},\n' for name in group)
        text += f"{table} = {{\n{entries}}}\n"
    return text


def files() -> dict[str, str]:
    return {"fortran/mgdt_parts_constants.f90": fortran(), "fortran/mgdt_mpi_f77.inc": f77(),
            "python/mgdt/_parts_interface.py": python()}
