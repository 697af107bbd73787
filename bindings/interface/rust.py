# SPDX-License-Identifier: MIT
"""Rust: the crate mgdt-sys."""

from __future__ import annotations

from header import Callback, Function, Interface, Parameter
from scripting import handles

WIDTH = 100

HEAD = """\
// SPDX-License-Identifier: MIT
// Generated from the headers of mgdt by bindings/interface/generate.py.
//! The C interface of mgdt as it is. Its manuals are the headers `mgdt/mgdt.h`,
//! `mgdt/mgdt_voronoi.h`, `mgdt/mgdt_domain.h`, `mgdt/mgdt_mesh.h` and `mgdt/mgdt_periodic.h`; the crate `mgdt` is the safe interface.
#![allow(non_camel_case_types)]

use std::marker::{PhantomData, PhantomPinned};
use std::os::raw::{c_char, c_void};

pub type mgdt_status = i32;
"""

TYPES = {"int32_t": "i32", "int64_t": "i64", "uint64_t": "u64", "double": "f64", "size_t": "usize",
         "char": "c_char", "void": "c_void"}
RESERVED = {"fn": "callback"}

HANDLE = """
/// %s; only ever behind a pointer.
#[repr(C)]
pub struct %s {
    _data: [u8; 0],
    _marker: PhantomData<(*mut u8, PhantomPinned)>,
}
"""
HANDLES = {"mgdt_triangulation": "A triangulation", "mgdt_voronoi": "A Voronoi diagram",
           "mgdt_domain": "A domain", "mgdt_mesh": "A mesh of tetrahedra",
           "mgdt_periodic": "Points in a periodic box"}


def rust_type(p: Parameter) -> str:
    name = TYPES.get(p.type, p.type)
    if p.stars == 2:
        return f"*mut *mut {name}"
    return f"*{'const' if p.is_const else 'mut'} {name}" if p.stars else name


def arguments(parameters: list[Parameter]) -> list[str]:
    return [f"{RESERVED.get(p.name, p.name)}: {rust_type(p)}" for p in parameters]


def result(p: Parameter) -> str:
    return "" if p.type == "void" and not p.stars else f" -> {rust_type(p)}"


def declaration(function: Function) -> str:
    """As rustfmt lays it out."""
    items, indent = arguments(function.parameters), " " * 4
    line = f"{indent}pub fn {function.name}({', '.join(items)}){result(function.result)};"
    if len(line) <= WIDTH:
        return line + "\n"
    rows = "".join(f"{indent}    {item},\n" for item in items)
    return f"{indent}pub fn {function.name}(\n{rows}{indent}){result(function.result)};\n"


def callback_type(callback: Callback) -> str:
    of = (f"Option<unsafe extern \"C\" fn({', '.join(arguments(callback.parameters))})"
          f"{result(callback.result)}>;")
    line = f"pub type {callback.name} = {of}"
    return line + "\n" if len(line) <= WIDTH else f"pub type {callback.name} =\n    {of}\n"


def files(interface: Interface) -> dict[str, str]:
    text = HEAD + "".join(HANDLE % (HANDLES[name], name) for name in handles(interface))
    for title, group in interface.groups():
        kind = "mgdt_status" if title == "error codes" else "i32"
        text += "\n" + "".join(f"pub const {c.name}: {kind} = {c.value};\n" for c in group)
    text += "\n" + "".join(map(callback_type, interface.callbacks))
    text += '\nextern "C" {\n' + "".join(map(declaration, interface.functions)) + "}\n"
    return {"rust/mgdt-sys/src/lib.rs": text}
