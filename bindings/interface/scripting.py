# SPDX-License-Identifier: MIT
"""LuaJIT, Ruby and Python: the declarations that their foreign function interfaces load."""

from __future__ import annotations

from header import Callback, Function, Interface, Parameter

WIDTH = 100
ORIGIN = "Generated from mgdt/mgdt.h by bindings/interface/generate.py."


def wrapped(begin: str, items: list[str], end: str, indent: str) -> str:
    """Items after a beginning, in as many lines as they need, each indented."""
    lines, line = [], begin
    for i, item in enumerate(items):
        piece = item + ("," if i + 1 < len(items) else end)
        if len(line) + len(piece) + (line[-1] != begin[-1]) > WIDTH and line != begin:
            lines.append(line.rstrip())
            line = indent
        line += piece + (" " if i + 1 < len(items) else "")
    return "\n".join([*lines, line.rstrip() if items else begin + end]) + "\n"


# LuaJIT reads C.

def c_type(p: Parameter) -> str:
    name = p.type.replace("mgdt_status", "int32_t")
    return f"{'const ' if p.is_const else ''}{name}{' ' + '*' * p.stars if p.stars else ''}"


def c_parameter(p: Parameter) -> str:
    return c_type(p) + ("" if p.stars else " ") + p.name if p.name else c_type(p)


def lua_declaration(function: Function) -> str:
    begin = c_parameter(function.result) + ("" if function.result.stars else " ") + function.name + "("
    items = [c_parameter(p) for p in function.parameters] or ["void"]
    return wrapped(begin, items, ");", " " * len(begin))


def lua_callback(callback: Callback) -> str:
    arguments = ", ".join(c_parameter(p) for p in callback.parameters)
    result = c_type(callback.result) + ("" if callback.result.stars else " ")
    return f"typedef {result}(*{callback.name})({arguments});\n"


def lua(interface: Interface) -> str:
    return (f"-- SPDX-License-Identifier: MIT\n-- {ORIGIN}\n--- The C interface of mgdt, declared.\n\n"
            'require("ffi").cdef [[\ntypedef struct mgdt_triangulation mgdt_triangulation;\n'
            + "".join(map(lua_callback, interface.callbacks))
            + "".join(map(lua_declaration, interface.functions)) + "]]\n")


# Ruby's names of types.

def ruby_type(p: Parameter) -> str:
    if p.type == "mgdt_progress_fn":
        return "progress"
    if p.type == "char" and p.is_const:
        return "string"
    if p.stars or p.is_callback:
        return "pointer"
    return p.type[:-2] if p.type.endswith("_t") else p.type.replace("mgdt_status", "int32")


def ruby(interface: Interface) -> str:
    text = (f"# SPDX-License-Identifier: MIT\n# {ORIGIN}\n# frozen_string_literal: true\n\n"
            "module Mgdt\n  # The functions of the C interface: name, parameters, result, and whether a "
            "call may take long.\n  INTERFACE = [\n")
    for f in interface.functions:
        parameters = " ".join(map(ruby_type, f.parameters))
        text += f"    [:{f.name}, %i[{parameters}], :{ruby_type(f.result)}, {str(f.is_long).lower()}],\n"
    return text + "  ].freeze\n  private_constant :INTERFACE\nend\n"


# Python's ctypes.

def ctypes_type(p: Parameter) -> str:
    if p.type == "void" and not p.stars:
        return "None"
    if p.is_callback:
        return p.type[len("mgdt_"):-len("_fn")].upper()
    if p.stars == 2:
        return "POINTER(c_void_p)"
    if p.type == "char":
        return "c_char_p"
    if p.stars:
        return "c_void_p"
    # size_t alone keeps its _t there.
    return {"size_t": "c_size_t", "mgdt_status": "c_int32"}.get(p.type, "c_" + p.type.replace("_t", ""))


def python(interface: Interface) -> str:
    text = (f"# SPDX-License-Identifier: MIT\n# {ORIGIN}\n"
            '"""The functions of the C interface for ctypes. Arrays are passed as addresses."""\n\n'
            "from __future__ import annotations\n\nimport ctypes\n"
            "from ctypes import POINTER, c_char_p, c_double, c_int32, c_int64, c_size_t, c_uint64, c_void_p\n"
            "from typing import Any\n\n")
    for callback in interface.callbacks:
        types = ", ".join(ctypes_type(p) for p in [callback.result, *callback.parameters])
        text += (f"{ctypes_type(Parameter('', callback.name, 0, False))} = ctypes.CFUNCTYPE({types})\n"
                 f'"""``{callback.name}``."""\n\n')
    text += ("# The result of each function, and its parameters.\n"
             "FUNCTIONS: dict[str, tuple[Any, list[Any]]] = {\n")
    for f in interface.functions:
        parameters = ", ".join(map(ctypes_type, f.parameters))
        line = f'    "{f.name}": ({ctypes_type(f.result)}, [{parameters}]),\n'
        if len(line) > WIDTH:
            line = (f'    "{f.name}": (\n        {ctypes_type(f.result)},\n'
                    f"        [{parameters}],\n    ),\n")
        text += line
    return text + "}\n"


def files(interface: Interface) -> dict[str, str]:
    return {"lua/mgdt/interface.lua": lua(interface),
            "ruby/lib/mgdt/interface.rb": ruby(interface),
            "python/mgdt/_interface.py": python(interface)}
