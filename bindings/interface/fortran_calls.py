# SPDX-License-Identifier: MIT
"""Fortran: procedures that do no more than call a C function, with the types that Fortran has for its
parameters. The templates in fortran/ ask for them."""

from __future__ import annotations

import textwrap
from typing import Optional

from description import COLUMNS, ROWS
from header import DescriptionError, Function, Interface, Parameter

# The kinds of integers that arrays and large numbers have, and what each is called.
KINDS = (("i32", "int32"), ("i64", "int64"))

# What a FORTRAN 77 subroutine for a handle uses, and how it finds the handle.
F77_HANDLES = {
    "mgdt_triangulation": (["use mgdt_f77_support"], "handle_of(h)"),
    "mgdt_voronoi": (["use mgdt_f77_support"], "handle_of(h, of_voronoi)"),
    "mgdt_domain": (["use mgdt_f77_support"], "handle_of(h, of_domain)"),
    "mgdt_mesh": (["use mgdt_f77_support"], "handle_of(h, of_mesh)"),
    "mgdt_periodic": (["use mgdt_f77_support"], "handle_of(h, of_periodic)"),
    "mgdt_parts": (["use mgdt_f77_support", "use mgdt_parts_c", "use mgdt_parts_constants"],
                   "handle_of(h, of_parts)"),
}

STATUS = ["integer, intent(out), optional :: stat",
          "character(*), intent(inout), optional :: errmsg"]


def indented(lines: list[str], indent: int) -> str:
    return "".join(f"{' ' * indent}{line}\n" if line else "\n" for line in lines).rstrip("\n")


def folded(line: str, width: int = 92) -> list[str]:
    """A statement in as many lines as it needs, broken between the arguments of its call."""
    depth, kept = 0, ""
    for c in line:
        depth += {"(": 1, ")": -1}.get(c, 0)
        kept += "\0" if c == " " and depth > 1 else c
    parts = textwrap.wrap(kept, width, subsequent_indent=" " * 8, break_long_words=False) or [""]
    parts = [part.replace("\0", " ") for part in parts]
    return [part + " &" for part in parts[:-1]] + parts[-1:]


def list_of_names(line: str, indent: int, further: int) -> str:
    """A declaration that ends in a list of names, in as many lines as it needs."""
    return textwrap.fill(line, 96, initial_indent=" " * indent, subsequent_indent=" " * further,
                         break_long_words=False, break_on_hyphens=False).replace("\n", " &\n")


def is_flag(p: Parameter) -> bool:
    return p.name == "on"


def is_large(p: Parameter) -> bool:
    return p.type in ("int64_t", "uint64_t")


class Calls:
    """Writes procedures for the functions of several interfaces."""

    def __init__(self, interfaces: list[Interface]) -> None:
        functions = [f for interface in interfaces for f in interface.functions]
        self._constants = [constant for interface in interfaces for constant in interface.enumerations]
        self._twins = {f.twin_of for f in functions if f.twin_of}
        self._functions = {f.short_name: f for f in functions}

    def _function(self, name: str) -> Function:
        if name not in self._functions:
            raise DescriptionError(f"a Fortran template asks for mgdt_{name}, which is not declared")
        return self._functions[name]

    def _parameters(self, function: Function) -> list[Parameter]:
        """Those behind the handle, which must be single numbers."""
        for p in function.parameters[1:]:
            if not p.is_scalar and p.length != "1":
                raise DescriptionError(f"{function.name}: {p.name} is more than a number")
        return function.parameters[1:]

    def kinds(self, name: str) -> list[tuple[str, str]]:
        """The kinds of integers of a procedure, ("", "") where it has none to choose."""
        parameters = self._parameters(self._function(name))
        return [("_" + kind, integer) for kind, integer in KINDS] if any(map(is_large, parameters)) \
            else [("", "")]

    # Fortran 90

    def interface(self, name: str, called: Optional[str] = None) -> str:
        """Interface bodies of the procedures for a function."""
        function, blocks = self._function(name), []
        parameters = self._parameters(function)
        names = "".join(f", {p.name}" for p in parameters)
        intent = "in" if function.parameters[0].is_const else "inout"
        for suffix, integer in self.kinds(name):
            lines = [f"class(mgdt_triangulation), intent({intent}) :: self"]
            for p in parameters:
                kind = "logical" if is_flag(p) else "real(real64)" if p.type == "double" else \
                    f"integer({integer})" if is_large(p) else "integer"
                lines.append(f"{kind}, intent({'inout' if p.stars else 'in'}) :: {p.name}")
            head = f"module subroutine {called or name}{suffix}(self{names}, stat, errmsg)"
            blocks.append(indented([head, *("    " + line for line in lines + STATUS),
                                    "end subroutine"], 8))
        return "\n".join(blocks)

    def body(self, name: str, called: Optional[str] = None) -> str:
        """The procedures themselves."""
        function, blocks = self._function(name), []
        handle = "handle" if function.parameters[0].is_const else "self%handle"
        for suffix, integer in self.kinds(name):
            if integer == "int32" and any(p.stars for p in self._parameters(function)):
                blocks.append(self._narrowed(function, called or name))
                continue
            locals_, after, actual = ["integer(c_int32_t) :: status"], [], [handle]
            if handle == "handle":
                locals_.insert(0, "type(c_ptr) :: handle")
            for p in self._parameters(function):
                if p.stars and p.type != "double":
                    locals_.append(f"integer({'c_int64_t' if is_large(p) else 'c_int32_t'}) :: found")
                    actual.append("found")
                    after.append(f"{p.name} = found{' /= 0' if is_flag(p) else ''}")
                else:
                    actual.append(p.name if p.type == "double" else
                                  f"merge(1_c_int32_t, 0_c_int32_t, {p.name})" if is_flag(p) else
                                  f"int({p.name}, c_int64_t)" if integer == "int32" and is_large(p) else
                                  p.name if is_large(p) else f"to_c({p.name})")
            enter = "call borrow(self%handle, handle, status)" if handle == "handle" else \
                "call make(self%handle, status)"
            owned = ", owned=self%handle" if handle == "handle" else ""
            blocks.append(indented(
                [f"module procedure {called or name}{suffix}", *("    " + line for line in locals_), "",
                 f"    {enter}",
                 *("    " + line for line in folded(
                     f"if (status == mgdt_ok) status = c_{name}({', '.join(actual)})")),
                 *(f"    if (status == mgdt_ok) {line}" for line in after),
                 f"    call finish({handle}, '{name}', status, stat, errmsg{owned})", "end procedure"],
                4))
        return "\n\n".join(blocks)

    def _narrowed(self, function: Function, called: str) -> str:
        """Gets a large number for a 32-bit integer, by way of the procedure for a 64-bit one."""
        name = function.parameters[1].name
        return indented(
            [f"module procedure {called}_i32", "    integer(int64) :: found", "    integer :: status",
             "    character(256) :: message", "", "    found = 0", "    message = ''",
             f"    call self%{called}(found, status, message)",
             f"    call narrow('{called}', found, {name}, to_c(status), trim(message), stat, errmsg)",
             "end procedure"], 4)

    def rows_interface(self, name: str) -> str:
        """Interface bodies of an export of rows: for two kinds of integers and two ranks."""
        array, blocks = ROWS[name].array, []
        for kind, integer in KINDS:
            for rank, shape, last in ((1, ":", ""), (2, ":, :", ", dim")):
                lines = ["class(mgdt_triangulation), intent(in) :: self",
                         f"integer({integer}), intent(inout) :: {array}({shape})", *STATUS]
                if last:
                    lines.append("integer, intent(in), optional :: dim")
                blocks.append(indented(
                    [f"module subroutine get_{name}_{kind}_{rank}(self, {array}, stat, errmsg{last})",
                     *("    " + line for line in lines), "end subroutine"], 8))
        return "\n".join(blocks)

    def bound(self, name: str, specifics: Optional[list[str]] = None) -> str:
        """What the type says of a function's procedures: its name, and those behind it."""
        if specifics is None:
            if name.removeprefix("get_") in ROWS:
                specifics = [f"{name}_{kind}_{rank}" for kind, _ in KINDS for rank in (1, 2)]
            else:
                specifics = [name + suffix for suffix, _ in self.kinds(name)]
        if specifics == [name]:
            return f"        procedure :: {name}"
        names = ", ".join(specifics)
        return "\n".join(list_of_names(line, 8, 12)
                         for line in (f"procedure, private :: {names}", f"generic :: {name} => {names}"))

    def public_constants(self, prefix: str = "") -> str:
        """Those with a prefix, or all but those of parts, which are another module's."""
        lines = []
        for group in self._constants:
            name = group[0].name
            if not name.startswith(prefix) if prefix else name.startswith("MGDT_PARTS_"):
                continue
            names = ", ".join(c.name.lower() for c in group)
            lines.append(list_of_names(f"public :: {names}", 4, 14))
        return "\n".join(lines)

    # FORTRAN 77

    def f77(self, signature: str, name: str) -> str:
        """A subroutine for FORTRAN 77. The signature names its arguments, "mgthr(h, n)", in the order
        of C's but a part, which is that of this process; "-" stands for a NULL that the caller does not
        see."""
        function = self._function(name)
        title, _, rest = signature.partition("(")
        names = [n.strip() for n in rest.rstrip(")").split(",")][1:]
        if function.is_count:
            return self._f77_count(title, names[0], function)
        parameters = [p for p in function.parameters[1:] if p.name != "part"]
        if len(names) != len(parameters):
            raise DescriptionError(f"{signature} has not the arguments of {function.name}")
        declared: list[str] = []
        after: list[str] = []
        actual, found, counts = [F77_HANDLES[function.parameters[0].type][1]], [], []
        handle = actual[0]
        if len(parameters) < len(function.parameters) - 1:
            actual.append("to_c(mgdt_parts_this_part)")
        for n, p in zip(names, parameters):
            intent = "in" if p.is_const or p.is_scalar else "inout"
            shape = "" if p.is_scalar or p.length == "1" else \
                f"({p.length})" if (p.length or "").isdigit() else "(*)"
            by_address = p.may_be_null or p.length == "stride"
            if n == "-":
                actual.append("c_null_ptr")
            elif p.type == "double":
                target = ", target" if by_address else ""
                declared.append(f"real(c_double), intent({intent}){target} :: {n}{shape}")
                actual.append(f"c_loc({n})" if by_address else n)
            elif p.is_scalar:
                declared.append(f"integer, intent(in) :: {n}")
                if p.type == "int64_t":
                    counts.append(n)
                export = name.removeprefix("get_")
                width = COLUMNS.get(export, 0) if p.name == "capacity" else 0
                actual.append(f"columns({width}, {n})" if width else
                              f"int({n}, c_int64_t)" if is_large(p) else f"to_c({n})")
            elif shape or function.name in self._twins:
                # The function of the caller's kind of integer.
                declared.append(f"integer, intent({intent}) :: {n}{shape}")
                actual.append(n)
            else:
                declared.append(f"integer, intent(inout) :: {n}")
                found.append(f"integer({'c_int64_t' if is_large(p) else 'c_int32_t'}) :: found")
                actual.append("found")
                after.append(f"call store_count(found, {handle}, {n}, ierr)" if is_large(p)
                             else f"{n} = found")
        lines = [*declared, f"integer, intent({'inout' if counts else 'out'}) :: ierr", *found, ""]
        if counts:
            lines.append(f"if (integers_differ(h, ierr, {counts[0]})) return")
        lines.append(f"ierr = c_{name}({', '.join(actual)})")
        lines += [f"if (ierr == mgdt_ok) {line}" for line in after]
        return self._f77_subroutine(title, [n for n in names if n != "-"], lines,
                                    function.parameters[0].type)

    def f77_at(self, signature: str, name: str) -> str:
        """The same for an export of rows at any increments."""
        title, _, rest = signature.partition("(")
        _, most, array, *increments = [n.strip() for n in rest.rstrip(")").split(",")]
        call = ", ".join(["handle_of(h)", f"array_{ROWS[name].array}", most, array, *increments])
        return self._f77_subroutine(title, [most, array, *increments], [
            f"integer, intent(in) :: {', '.join([most, *increments])}",
            f"integer, intent(inout) :: {array}(*)", "integer, intent(inout) :: ierr", "",
            f"if (integers_differ(h, ierr, {most})) return", f"call export_at({call}, ierr)"])

    def _f77_count(self, title: str, n: str, function: Function) -> str:
        count = f"c_{function.short_name}(handle_of(h))"
        if not is_large(function.result):
            count = f"int({count}, c_int64_t)"
        return self._f77_subroutine(title, [n], [
            f"integer, intent(inout) :: {n}", "integer, intent(inout) :: ierr", "",
            f"if (integers_differ(h, ierr, {n})) return",
            f"call store_count({count}, handle_of(h), {n}, ierr)"])

    def _f77_subroutine(self, title: str, names: list[str], lines: list[str],
                        handle: str = "mgdt_triangulation") -> str:
        lines = [*F77_HANDLES[handle][0], "implicit none", "integer, intent(in) :: h(4)", *lines]
        lines = [part for line in lines for part in folded(line)]
        return indented([f"subroutine {title}({', '.join(['h', *names, 'ierr'])})",
                         *("    " + line if line else "" for line in lines), "end subroutine"], 0)
