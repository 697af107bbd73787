# SPDX-License-Identifier: MIT
"""The C interface as data: what mgdt.h declares, and what description.py adds."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Optional

import description
from pycparser import c_ast, c_parser

TYPEDEFS = ("int32_t", "int64_t", "uint64_t", "size_t")
HANDLE = "mgdt_triangulation"
SCALARS = {"int32_t", "int64_t", "uint64_t", "double", "mgdt_status", "size_t"}


class DescriptionError(Exception):
    """The header or the description says something that cannot be generated from."""


@dataclass
class Parameter:
    name: str
    type: str  # without const and stars: "double", "mgdt_triangulation", "mgdt_progress_fn"
    stars: int
    is_const: bool
    length: Optional[str] = None  # of an array: as in description.py, without "?"
    may_be_null: bool = False

    @property
    def is_handle(self) -> bool:
        return self.type == HANDLE and self.stars == 1

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
        has_array = any(p.is_array and not re.fullmatch(r"\d+", p.length or "")
                        for p in self.parameters)
        return (has_array or self.name in description.LONG) and self.name not in description.SHORT


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
class Interface:
    functions: list[Function] = field(default_factory=list)
    constants: list[Constant] = field(default_factory=list)
    callbacks: list[Callback] = field(default_factory=list)

    def groups(self) -> list[tuple[str, list[Constant]]]:
        """The constants of each group, in the order of description.py."""
        return [(group.title, self._of(group)) for group in description.GROUPS]

    def tables(self) -> dict[str, dict[str, int]]:
        """The constants by group and short name, for the scripting languages."""
        return {group.table: {re.sub("^MGDT_(ERR_)?", "", c.name) if group.table == "status"
                              else c.name[len(group.beginnings[0]):]: c.value
                              for c in self._of(group)} for group in description.GROUPS}

    def _of(self, group: description.Group) -> list[Constant]:
        return [c for c in self.constants if c.name.startswith(group.beginnings)]


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
            r"(?:/\*\*(?!<)((?:(?!\*/).)*)\*/\s*)?^\s*(MGDT_[A-Z0-9_]+) = \d+,?[ \t]*"
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


def _describe(function: Function, counted: set[str]) -> None:
    """Adds what description.py says, and refuses what it leaves open."""
    lengths = dict(description.LENGTHS.get(function.twin_of or function.name, {}))
    counts = {p.name for p in function.parameters if p.is_scalar and p.type == "int64_t"}
    known = SCALARS | {HANDLE, "void", "char"}
    for p in function.parameters:
        if p.type not in known and not p.is_of_callback:
            raise DescriptionError(f"{function.name}: {p.name} has the unknown type {p.type}")
        if p.is_scalar or p.is_callback or p.type in (HANDLE, "void"):
            continue
        length = lengths.pop(p.name, None)
        if length is None:
            raise DescriptionError(f"{function.name}: description.py has no length of {p.name}")
        p.may_be_null = length.startswith("?")
        p.length = length.lstrip("?")
        factors = set(p.length.split("*")) - {"text", "stride"}
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


def read(path: Path) -> Interface:
    """The interface that a header declares."""
    text = path.read_text(encoding="utf-8")
    code = re.sub(r"/\*.*?\*/", " ", text, flags=re.S)
    code = re.sub(r"\\\n", " ", code)
    code = re.sub(r"^[ \t]*#.*$", "", code, flags=re.M)
    code = re.sub(r'extern "C" \{', "", code)
    # The brace that closes it, which stands alone.
    code = re.sub(r"^\}\s*$", "", code, flags=re.M).replace("MGDT_API", "")
    types = "".join(f"typedef int {name};\n" for name in TYPEDEFS)
    interface = Interface()
    comments, since = comments_of_constants(text), _since(text)
    for node in c_parser.CParser().parse(types + code, path.name).ext:
        kind = node.type
        if isinstance(kind, c_ast.Enum):
            interface.constants += [Constant(e.name, int(e.value.value), comments.get(e.name, ""))
                                    for e in kind.values.enumerators]
        elif isinstance(node, c_ast.Typedef) and isinstance(kind, c_ast.PtrDecl):
            declaration = kind.type
            interface.callbacks.append(Callback(
                node.name, _parameter("", declaration.type), _parameters(declaration)))
        elif isinstance(kind, c_ast.FuncDecl):
            interface.functions.append(Function(
                node.name, _parameter("", kind.type), _parameters(kind), since.get(node.name, "")))
    names = {f.name for f in interface.functions}
    for name in sorted((set(description.LENGTHS) | description.LONG | description.SHORT) - names):
        raise DescriptionError(f"description.py has {name}, which {path.name} does not declare")
    for function in interface.functions:
        if not function.since:
            raise DescriptionError(f"{function.name} has no @since")
        _describe(function, {f.short_name for f in interface.functions if f.is_count})
    _check_twins(interface.functions)
    constants = {c.name for c in interface.constants}
    for name in sorted(constants ^ set(description.F77_NAMES)):
        raise DescriptionError(f"{name} is not both in {path.name} and among F77_NAMES")
    return interface
