# SPDX-License-Identifier: MIT
"""Fortran: the interfaces of the C functions, and the constants for Fortran 90 and for FORTRAN 77."""

from __future__ import annotations

import textwrap
from pathlib import Path

import fypp
from description import GRAPHS, LISTS, ROWS, SETTINGS
from fortran_calls import KINDS, Calls
from header import DescriptionError, Function, Interface, Parameter

WIDTH = 100

HEAD = """\
! SPDX-License-Identifier: MIT
! Generated from mgdt/%s by bindings/interface/generate.py.
!
"""

C_HEAD = """\
! The C functions of mgdt as they stand in mgdt/mgdt.h, where they are documented. Module mgdt and
! mgdt_f77.f90 are built on these; programs rarely need them.
!
! c_NAME is mgdt_NAME. Functions with 32-bit and 64-bit arrays are one generic name, except where
! the array may be null: those are c_NAME_i32 and c_NAME_i64. A result that is
! a pointer is to a static string that ends with NUL, or null. Counts are pure, so that they may give
! the bounds of automatic arrays.
module mgdt_c
    use, intrinsic :: iso_c_binding, only: c_char, c_double, c_funptr, c_int32_t, c_int64_t, &
                                           c_ptr, c_size_t
    implicit none
    public

@exports@
    interface
        pure function c_strlen(s) result(length) bind(c, name='strlen')
            import :: c_ptr, c_size_t
            type(c_ptr), value :: s
            integer(c_size_t) :: length
        end function
"""

PARTS_C_HEAD = """\
! The C functions of parts as they stand in mgdt/mgdt_parts.h. c_parts_NAME is mgdt_parts_NAME.
module mgdt_parts_c
    implicit none
    public

    interface
"""

MPI_C_HEAD = """\
! The C function of libmgdt_mpi that takes a communicator of Fortran's, as it stands in
! mgdt/mgdt_mpi.h. MPI_Fint is an INTEGER of 32 bits.
module mgdt_mpi_c
    implicit none
    public

    interface
"""

TYPES = {"int32_t": "integer(c_int32_t)", "int64_t": "integer(c_int64_t)",
         "uint64_t": "integer(c_int64_t)", "mgdt_status": "integer(c_int32_t)",
         "double": "real(c_double)", "char": "character(kind=c_char)", "size_t": "integer(c_size_t)",
         "MPI_Fint": "integer(c_int)"}


def wrapped(head: str, binding: str, indent: str) -> str:
    """The head of a procedure, continued where it is too long, last before its binding."""
    if len(indent + head + binding) < WIDTH:
        return f"{indent}{head} {binding}\n"
    lines = textwrap.wrap(head, WIDTH - len(indent) - 6, break_long_words=False,
                          break_on_hyphens=False)
    return (" &\n" + indent + "    ").join([indent + lines[0], *lines[1:], binding]) + "\n"


def declared(p: Parameter) -> str:
    """The type of a dummy argument, and its name with its shape."""
    if p.is_scalar:
        return f"{TYPES[p.type]}, value :: {p.name}"
    if p.is_callback:
        return f"type(c_funptr), value :: {p.name}"
    if p.is_of_callback:
        return f"type(c_funptr), intent(out) :: {p.name}"
    if p.stars == 2:
        return f"type(c_ptr), intent(out) :: {p.name}"
    if p.length in (None, "stride") or p.may_be_null:
        return f"type(c_ptr), value :: {p.name}"
    shape = "" if p.length == "1" else f"({p.length})" if p.length.isdigit() else "(*)"
    return f"{TYPES[p.type]}, intent({'in' if p.is_const else 'inout'}) :: {p.name}{shape}"


def answer_of(function: Function) -> tuple[str, str]:
    """The name of the result and its declaration."""
    if function.result.stars:
        return "text", "type(c_ptr) :: text"
    name = "status" if function.returns_status else "count" if function.is_count else "answer"
    return name, f"{TYPES[function.result.type]} :: {name}"


def procedure(function: Function, name: str, is_abstract: bool = False,
              imported: str = "import ::") -> str:
    """The interface body of a function, or of all that are like it."""
    indent = " " * 8
    arguments = ", ".join(p.name for p in function.parameters)
    declarations = [declared(p) for p in function.parameters]
    binding = "bind(c)" if is_abstract else f"bind(c, name='{function.name}')"
    if function.result.type == "void" and not function.result.stars:
        kind, head = "subroutine", f"subroutine {name}({arguments})"
    else:
        answer, declaration = answer_of(function)
        declarations.append(declaration)
        kind = "function"
        head = f"{'pure ' if function.is_count else ''}function {name}({arguments}) result({answer})"
    kinds = sorted({word for word in ("c_char", "c_double", "c_funptr", "c_int", "c_int32_t",
                                      "c_int64_t", "c_ptr", "c_size_t")
                    if any(word + ")" in d for d in declarations)})
    body = "".join(indent + "    " + line + "\n"
                   for line in [f"{imported} {', '.join(kinds)}", *declarations])
    return wrapped(head, binding, indent) + body + f"{indent}end {kind}\n"


def c_module(interface: Interface) -> str:
    twins = {f.twin_of: f for f in interface.functions if f.twin_of}
    # Those whose arguments have the same types in Fortran cannot be one generic name.
    alike = {f.name for f in interface.functions if f.name in twins and
             list(map(declared, f.parameters)) == list(map(declared, twins[f.name].parameters))}
    first = "mgdt_get_" + next(iter(ROWS))
    like = [f for f in interface.functions if f.name == first]
    text = HEAD % interface.header + C_HEAD.replace("@exports@\n", "    ! What the exports of one array have in common.\n"
                          "    abstract interface\n" + procedure(twins[first], "c_export_i32", True)
                          + procedure(like[0], "c_export_i64", True) + "    end interface\n\n")
    for function in interface.functions:
        if function.name not in twins and not function.twin_of:
            text += procedure(function, "c_" + function.short_name)
        elif function.name in alike:
            name = "c_" + function.short_name
            text += procedure(twins[function.name], name + "_i32") + procedure(function, name + "_i64")
    text += "    end interface\n"
    for function in interface.functions:
        if function.name in twins and function.name not in alike:
            name = "c_" + function.short_name
            text += f"\n    interface {name}\n"
            text += procedure(twins[function.name], name + "_i32") + procedure(function, name + "_i64")
            text += "    end interface\n"
    return text + "end module mgdt_c\n"


def other_c_module(interface: Interface, head: str, name: str) -> str:
    """The functions that Fortran has types for, without generic names."""
    text = HEAD % interface.header + head
    for function in interface.functions:
        if all(p.type != "MPI_Comm" for p in function.parameters):
            text += procedure(function, "c_" + function.short_name,
                              imported="use, intrinsic :: iso_c_binding, only:")
    return text + f"    end interface\nend module {name}\n"


CONSTANTS_HEAD = """\
! The constants of mgdt's C interface, in the default integer of the flags in force. Comments are
! those of the header; stat= has the values of a status.
module mgdt_constants
    implicit none
    public
"""

PARTS_CONSTANTS_HEAD = """\
! The options, numbers and arrays of parts. Comments are those of the header.
module mgdt_parts_constants
    implicit none
    public
"""


def constants_module(interface: Interface, head: str, name: str) -> str:
    text = HEAD % interface.header + head
    for title, group in interface.groups():
        text += f"\n    ! {title[0].upper()}{title[1:].split(' (')[0]}.\n" if title else "\n"
        for constant in group:
            for line in textwrap.wrap(constant.comment, WIDTH - 6):
                text += f"    ! {line}\n"
            text += f"    integer, parameter :: {constant.name.lower()} = {constant.value}\n"
    return text + f"end module {name}\n"


F77_HEAD = """\
! INCLUDE this after IMPLICIT statements: names for the numbers that mgdt takes and gives.
! It is good for fixed and free form. Each line says what mgdt.h calls the number;
! docs/fortran.md says what each means.
"""

PARTS_F77_HEAD = """\
! INCLUDE this after IMPLICIT statements, beside mgdt_f77.inc. Each line says what mgdt_parts.h
! calls the number; docs/mpi.md says what each means.
"""

F77_TAIL = """\
! kinds (MGKIND): MGKIND compares these two with its own
      INTEGER MGKI(2)
      DOUBLE PRECISION MGKD
      PARAMETER (MGKI = (/1, 2/), MGKD = 1D0)
"""


def f77_include(interface: Interface, head: str) -> str:
    text = HEAD % interface.header + head
    for title, group in interface.groups():
        if not title:
            continue
        text += f"! {title}\n"
        names = [interface.f77_name(c) for c in group]
        for i in range(0, len(names), 6):
            text += f"      INTEGER {', '.join(names[i:i + 6])}\n"
        for constant, name in zip(group, names):
            text += f"      PARAMETER ({name} = {constant.value}) ! {constant.name}\n"
    return text


def of_kinds(name: str) -> list[str]:
    return [f"{name}_{kind}" for kind, _ in KINDS]


def of_kinds_and_ranks(name: str) -> list[str]:
    return [f"{name}_{kind}_{rank}" for kind, _ in KINDS for rank in (1, 2)]


def expanded(template: Path, calls: Calls) -> str:
    """The text of a template of fypp's."""
    names = {"calls": calls, "KINDS": KINDS, "ROWS": ROWS, "LISTS": LISTS, "GRAPHS": GRAPHS,
             "SETTINGS": SETTINGS, "of_kinds": of_kinds, "of_kinds_and_ranks": of_kinds_and_ranks}

    def evaluator(env=None):  # type: ignore[no-untyped-def]  # fypp compares the signature
        return fypp.Evaluator({**(env or {}), **names})

    options = fypp.FyppOptions()
    options.no_folding = True
    options.includes = [str(template.parent)]
    try:
        return fypp.Fypp(options, evaluator_factory=evaluator).process_text(
            template.read_text(encoding="utf-8"))
    except fypp.FyppError as error:
        raise DescriptionError(f"{template.name}: {error.__cause__ or error}") from error


def files(triangulation: Interface, parts: Interface, mpi: Interface) -> dict[str, str]:
    templates = sorted((Path(__file__).parent / "fortran").glob("*.f90.fypp"))
    calls = Calls([triangulation, parts])
    return {**{f"fortran/{t.stem}": expanded(t, calls) for t in templates},
            "fortran/mgdt_c.f90": c_module(triangulation),
            "fortran/mgdt_constants.f90":
                constants_module(triangulation, CONSTANTS_HEAD, "mgdt_constants"),
            "fortran/mgdt_f77.inc": f77_include(triangulation, F77_HEAD) + F77_TAIL,
            "fortran/mgdt_parts_c.f90": other_c_module(parts, PARTS_C_HEAD, "mgdt_parts_c"),
            "fortran/mgdt_parts_constants.f90":
                constants_module(parts, PARTS_CONSTANTS_HEAD, "mgdt_parts_constants"),
            "fortran/mgdt_mpi_c.f90": other_c_module(mpi, MPI_C_HEAD, "mgdt_mpi_c"),
            "fortran/mgdt_mpi_f77.inc": f77_include(parts, PARTS_F77_HEAD)}
