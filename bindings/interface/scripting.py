# SPDX-License-Identifier: MIT
"""LuaJIT, Ruby, Python and Octave: the declarations that their foreign function interfaces load, and
the constants."""

from __future__ import annotations

import re
from typing import Optional

from header import Callback, Function, Interface, Parameter, Record

WIDTH = 100
ORIGIN = "Generated from the headers of mgdt by bindings/interface/generate.py."
ONE_ORIGIN = "Generated from mgdt/%s by bindings/interface/generate.py."


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


def table(begin: str, entry: str, constants: dict[str, int], end: str, indent: str) -> str:
    return wrapped(begin, [entry % (name.lower(), value) for name, value in constants.items()], end,
                   indent)


def handles(interface: Interface) -> list[str]:
    """The handles that the functions have, in the order of their appearance."""
    found = [p.type for f in interface.functions for p in f.parameters if p.is_handle]
    return list(dict.fromkeys(found))


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
            'require("ffi").cdef [[\n'
            + "".join(f"typedef struct {handle} {handle};\n" for handle in handles(interface))
            + "".join(map(lua_callback, interface.callbacks))
            + "".join(map(lua_declaration, interface.functions)) + "]]\n\nreturn {\n"
            + "".join(table(f"    {name} = {{ ", "%s = %d", constants, " },", " " * 8)
                      for name, constants in interface.tables().items()) + "}\n")


# Ruby's names of types.

def ruby_type(p: Parameter) -> str:
    if p.type in ("mgdt_progress_fn", "mgdt_size_fn") and p.is_callback:
        return p.type[len("mgdt_"):-len("_fn")]
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
    text += "  ].freeze\n\n  # The constants, by group and name.\n  CONSTANTS = {\n"
    for name, constants in interface.tables().items():
        text += table(f"    {name}: {{ ", "%s: %d", constants, " },", " " * 6)
    return text + "  }.freeze\n  private_constant :INTERFACE, :CONSTANTS\nend\n"


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


def ctypes_callback(callback: Callback) -> str:
    types = ", ".join(ctypes_type(p) for p in [callback.result, *callback.parameters])
    name = ctypes_type(Parameter("", callback.name, 0, False))
    return f'{name} = ctypes.CFUNCTYPE({types})\n"""``{callback.name}``."""\n\n'


def ctypes_record(record: Record) -> str:
    members = "".join(f'        ("{p.name}", {ctypes_type(p)}),\n' for p in record.members)
    name = "".join(word.capitalize() for word in record.name.split("_")[1:])
    return (f'\nclass {name}(ctypes.Structure):\n    """``{record.name}``."""\n\n'
            f"    _fields_ = [\n{members}    ]\n\n\n")


def ctypes_function(f: Function) -> str:
    parameters = ", ".join(map(ctypes_type, f.parameters))
    line = f'    "{f.name}": ({ctypes_type(f.result)}, [{parameters}]),\n'
    if len(line) <= WIDTH:
        return line
    return f'    "{f.name}": (\n        {ctypes_type(f.result)},\n        [{parameters}],\n    ),\n'


def python(interface: Interface, of_others: Optional[Interface] = None) -> str:
    """The interface of a header, which uses callbacks of another one."""
    code = ("".join(map(ctypes_callback, interface.callbacks))
            + "".join(map(ctypes_record, interface.records))
            + "# The result of each function, and its parameters.\n"
            "FUNCTIONS: dict[str, tuple[Any, list[Any]]] = {\n"
            + "".join(map(ctypes_function, interface.functions))
            + "}\n\n# The constants, by group and name.\nCONSTANTS: dict[str, dict[str, int]] = {\n")
    for name, constants in interface.tables().items():
        entries = "".join(f'        "{key.lower()}": {value},\n' for key, value in constants.items())
        code += f'    "{name}": {{\n{entries}    }},\n'
    names = [name for name in ("POINTER", "c_char_p", "c_double", "c_int32", "c_int64", "c_size_t",
                               "c_uint64", "c_void_p") if re.search(rf"\b{name}\b", code)]
    used = sorted({ctypes_type(p) for f in interface.functions for p in f.parameters if p.is_callback}
                  - {ctypes_type(Parameter("", c.name, 0, False)) for c in interface.callbacks})
    return (f"# SPDX-License-Identifier: MIT\n# {ONE_ORIGIN % interface.header if of_others else ORIGIN}\n"
            f'"""The functions of {interface.header} for ctypes. Arrays are passed as addresses."""\n\n'
            "from __future__ import annotations\n\n"
            + ("import ctypes\n" if "ctypes." in code else "") + f"from ctypes import {', '.join(names)}\nfrom typing import Any\n\n"
            + (f"from ._interface import {', '.join(used)}\n\n" if of_others else "") + code + "}\n")


# Octave's gateway is C, which has the header and loads the library itself.

def macro(head: str, items: list[str]) -> str:
    """A macro of several lines, as clang-format lays it out."""
    lines = [f"#define {head}", *("    " + item for item in items)]
    width = max(map(len, lines[:-1])) + 1
    return "".join(f"{line:<{width}}\\\n" for line in lines[:-1]) + lines[-1] + "\n"


def octave(interface: Interface) -> str:
    functions = [f"F({f.short_name});" for f in interface.functions]
    errors = [f"E({name}, {name.lower()})" for name in interface.tables()["status"] if name != "OK"]
    return (f"/* SPDX-License-Identifier: MIT\n * {ORIGIN} */\n#ifndef MGDT_OCTAVE_INTERFACE_H\n"
            "#define MGDT_OCTAVE_INTERFACE_H\n\n/* Every function, by the name that it has after "
            '"mgdt_". */\n' + macro("MGDT_FUNCTIONS(F)", functions)
            + "\n/* Every error, by its name after \"MGDT_ERR_\", large and small. */\n"
            + macro("MGDT_ERRORS(E)", errors) + "\n#endif /* MGDT_OCTAVE_INTERFACE_H */\n")


def files(interface: Interface, parts: Interface) -> dict[str, str]:
    return {"lua/mgdt/interface.lua": lua(interface),
            "ruby/lib/mgdt/interface.rb": ruby(interface),
            "python/mgdt/_interface.py": python(interface),
            "python/mgdt/_parts_interface.py": python(parts, interface),
            "octave/mgdt_interface.h": octave(interface)}
