# SPDX-License-Identifier: MIT
"""The C interface as data: what a header declares, and what its description adds."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Optional, Sequence

from description import HANDLES, Description
from pycparser import c_ast, c_parser

SCALARS = {"int32_t", "int64_t", "uint64_t", "double", "mgdt_status", "size_t", "MPI_Comm", "MPI_Fint"}


class DescriptionError(Exception):
    """The header or the description says something that cannot be generated from."""


@dataclass
class Parameter:
    name: str
    type: str  # without const and stars: "double", "mgdt_parts", "mgdt_progress_fn"
    stars: int
    is_const: bool
    length: Optional[str] = None  # of an array: as in description.py, without "?"
    may_be_null: bool = False

    @property
    def is_handle(self) -> bool:
        return self.type in HANDLES and self.stars == 1

    @property
    def is_callback(self) -> bool:
        return self.is_of_callback and self.stars == 0

    @property
    def is_of_callback(self) -> bool:
        return self.type.endswith("_fn")

    @property
    def is_scalar(self) -> bool:
        return self.stars == 0 and not self.is_callback

    @property
    def is_array(self) -> bool:
        return self.length not in (None, "1", "text")


@dataclass
class Function:
    name: str
    result: Parameter
    parameters: list[Parameter]
    since: str = ""
    may_take_long: Optional[bool] = None  # where the description says so

    @property
    def short_name(self) -> str:
        return self.name[len("mgdt_"):]

    @property
    def twin_of(self) -> str:
        return self.name[: -len("_i32")] if self.name.endswith("_i32") else ""

    @property
    def returns_status(self) -> bool:
        return self.result.type == "mgdt_status" and self.result.stars == 0

    @property
    def is_count(self) -> bool:
        """A number read off a handle, with no way to fail."""
        return (self.result.is_scalar and self.result.type in ("int32_t", "int64_t")
                and [p.is_handle and p.is_const for p in self.parameters] == [True])

    @property
    def is_long(self) -> bool:
        """Whether other threads of a host should go on meanwhile."""
        if self.may_take_long is not None:
            return self.may_take_long
        return any(p.is_array and not re.fullmatch(r"\d+", p.length or "") for p in self.parameters)


@dataclass
class Constant:
    name: str
    value: int
    comment: str


@dataclass
class Callback:
    name: str
    result: Parameter
    parameters: list[Parameter]


@dataclass
class Record:
    """A structure with all its members."""

    name: str
    members: list[Parameter]


@dataclass
class Interface:
    """What a header declares."""

    description: Description
    functions: list[Function] = field(default_factory=list)
    enumerations: list[list[Constant]] = field(default_factory=list)
    callbacks: list[Callback] = field(default_factory=list)
    records: list[Record] = field(default_factory=list)

    @property
    def header(self) -> str:
        return self.description.header

    @property
    def constants(self) -> list[Constant]:
        return [constant for enumeration in self.enumerations for constant in enumeration]

    def groups(self) -> list[tuple[str, list[Constant]]]:
        """The constants of each group, and what FORTRAN 77 calls it."""
        return [(group.title, constants)
                for group, constants in zip(self.description.groups, self.enumerations)]

    def tables(self) -> dict[str, dict[str, int]]:
        """The constants by group and short name, for the scripting languages."""
        return {group.table: {_without(group.prefixes, c.name): c.value for c in constants}
                for group, constants in zip(self.description.groups, self.enumerations)}

    def joined(self, other: Interface) -> Interface:
        """This interface with that of another header, for the layers that have both in one file."""
        a, b = self.description, other.description
        description = Description(f"{a.header}, {b.header}", {**a.lengths, **b.lengths},
                                  a.groups + b.groups, {**a.f77_names, **b.f77_names},
                                  a.long | b.long, a.short | b.short)
        return Interface(description, self.functions + other.functions,
                         self.enumerations + other.enumerations, self.callbacks + other.callbacks,
                         self.records + other.records)

    def f77_name(self, constant: Constant) -> str:
        return self.description.f77_names[constant.name]


def _without(prefixes: tuple[str, ...], name: str) -> str:
    """The name without the longest prefix that it has."""
    return name[max(len(prefix) for prefix in prefixes if name.startswith(prefix)):]


def _parameter(name: str, node: c_ast.Node) -> Parameter:
    stars = 0
    while isinstance(node, c_ast.PtrDecl):
        stars, node = stars + 1, node.type
    if not isinstance(node, c_ast.TypeDecl) or not isinstance(node.type, c_ast.IdentifierType):
        raise DescriptionError(f"{name} has a type that is not known")
    return Parameter(name, " ".join(node.type.names), stars, "const" in node.quals)


def _parameters(declaration: c_ast.FuncDecl) -> list[Parameter]:
    parameters = [_parameter(p.name or "", p.type)
                  for p in (declaration.args.params if declaration.args else [])]
    return [] if [p.type for p in parameters] == ["void"] and not parameters[0].stars else parameters


def _comment_text(comment: str) -> str:
    lines = [re.sub(r"^\s*\*?\s?", "", line) for line in comment.splitlines()]
    return " ".join(" ".join(lines).split())


def comments_of_constants(text: str) -> dict[str, str]:
    """The comment before a constant or behind it, as Doxygen has them."""
    found = {}
    for before, name, behind in re.findall(
            r"(?:/\*\*(?!<)((?:(?!\*/).)*)\*/\s*)?^\s*(MGDT_[A-Z0-9_]+) = -?\d+,?[ \t]*"
            r"(?:/\*\*<((?:(?!\*/).)*)\*/)?", text, flags=re.S | re.M):
        found[name] = _comment_text(behind or before)
    return found


def _since(text: str) -> dict[str, str]:
    """The version that has brought each function, by its comment."""
    found = {}
    for comment, name in re.findall(
            r"/\*\*((?:(?!\*/).)*)\*/\s*MGDT_API[^;(]*?\b(mgdt_\w+)\s*\(", text, flags=re.S):
        version = re.search(r"@since (\d+\.\d+)", comment)
        found[name] = version.group(1) if version else ""
    return found


def _describe(function: Function, description: Description, counted: set[str],
              records: set[str]) -> None:
    """Adds what the description says, and refuses what it leaves open."""
    lengths = dict(description.lengths.get(function.twin_of or function.name, {}))
    if function.name in description.long | description.short:
        function.may_take_long = function.name in description.long
    counts = {p.name for p in function.parameters if p.is_scalar and p.type in ("int32_t", "int64_t")}
    known = SCALARS | records | {*HANDLES, "void", "char"}
    for p in function.parameters:
        if p.type not in known and not p.is_of_callback:
            raise DescriptionError(f"{function.name}: {p.name} has the unknown type {p.type}")
        if p.is_scalar or p.is_callback or p.type in records | {*HANDLES, "void"}:
            continue
        length = lengths.pop(p.name, None)
        if length is None:
            raise DescriptionError(f"{function.name}: its description has no length of {p.name}")
        p.may_be_null = length.startswith("?")
        p.length = length.lstrip("?")
        factors = set(re.split(r"[*+]", p.length)) - {"text", "stride", "listed"}
        unknown = [f for f in sorted(factors) if not f.isdigit() and f not in counts | counted]
        if unknown:
            raise DescriptionError(f"{function.name}: the length of {p.name} is {p.length}, "
                                   f"but there is no count {unknown[0]}")
    if lengths:
        raise DescriptionError(f"{function.name} has no array {sorted(lengths)[0]}")


def _check_twins(functions: list[Function]) -> None:
    by_name = {f.name: f for f in functions}
    for function in functions:
        if not function.twin_of:
            continue
        if function.twin_of not in by_name:
            raise DescriptionError(f"{function.name} has no {function.twin_of}")
        shape = [[(p.name, p.stars, p.type.replace("int64_t", "int32_t")) for p in f.parameters]
                 for f in (function, by_name[function.twin_of])]
        if shape[0] != shape[1]:
            raise DescriptionError(f"{function.name} differs from {function.twin_of} in more than "
                                   "the width of integers")


def _value(node: c_ast.Node) -> int:
    return -_value(node.expr) if isinstance(node, c_ast.UnaryOp) else int(node.value)


def _code(text: str) -> str:
    """The declarations alone, as C without a preprocessor."""
    code = re.sub(r"/\*.*?\*/", " ", text, flags=re.S)
    code = re.sub(r"\\\n", " ", code)
    code = re.sub(r"^[ \t]*#.*$", "", code, flags=re.M)
    code = re.sub(r'extern "C" \{', "", code)
    # The brace that closes it, which stands alone.
    return re.sub(r"^\}\s*$", "", code, flags=re.M).replace("MGDT_API", "")


def _declare(interface: Interface, text: str, types: set[str]) -> None:
    """Adds what the text declares; the types are those that it does not declare itself."""
    comments, since = comments_of_constants(text), _since(text)
    code = "".join(f"typedef int {name};\n" for name in sorted(types)) + _code(text)
    for node in c_parser.CParser().parse(code, interface.header).ext:
        kind = node.type
        if isinstance(kind, c_ast.Enum):
            interface.enumerations.append(
                [Constant(e.name, _value(e.value), comments.get(e.name, ""))
                 for e in kind.values.enumerators])
        elif isinstance(node, c_ast.Typedef) and isinstance(kind, c_ast.PtrDecl):
            declaration = kind.type
            interface.callbacks.append(Callback(
                node.name, _parameter("", declaration.type), _parameters(declaration)))
        elif isinstance(node, c_ast.Typedef) and isinstance(kind.type, c_ast.Struct):
            if kind.type.decls:
                interface.records.append(Record(
                    node.name, [_parameter(d.name, d.type) for d in kind.type.decls]))
        elif isinstance(kind, c_ast.FuncDecl):
            interface.functions.append(Function(
                node.name, _parameter("", kind.type), _parameters(kind), since.get(node.name, "")))


def read(path: Path, description: Description, included: Sequence[Interface] = ()) -> Interface:
    """The interface that a header declares; it includes the headers of the others."""
    interface = Interface(description)
    types = SCALARS - {"double"} if included else SCALARS - {"double", "mgdt_status"}
    types |= {c.name for other in included for c in other.callbacks}
    _declare(interface, path.read_text(encoding="utf-8"), types | ({*HANDLES} if included else set()))
    names = {f.name for f in interface.functions}
    for name in sorted((set(description.lengths) | description.long | description.short) - names):
        raise DescriptionError(f"{name} is described, but {path.name} does not declare it")
    counted = {f.short_name for f in interface.functions if f.is_count}
    for function in interface.functions:
        if not function.since:
            raise DescriptionError(f"{function.name} has no @since")
        _describe(function, description, counted, {r.name for r in interface.records})
    _check_twins(interface.functions)
    if len(description.groups) != len(interface.enumerations):
        raise DescriptionError(f"{path.name} has {len(interface.enumerations)} enumerations, and "
                               f"{len(description.groups)} are described")
    constants = {c.name for title, group in interface.groups() if title for c in group}
    for name in sorted(constants ^ set(description.f77_names)):
        raise DescriptionError(f"{name} is not both in {path.name} and among its names in FORTRAN 77")
    return interface
