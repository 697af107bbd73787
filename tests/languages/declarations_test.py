#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares what the bindings declare of the C interface with the header: functions, the types of
their parameters and results, and the values of constants.

  declarations_test.py SOURCE_DIRECTORY

Lua and Rust declare the interface in their sources, Julia in docs/other-languages.md. Octave's gateway
includes the header, and Ruby's own test compares what it attached."""
import re
import sys
from pathlib import Path

source = Path(sys.argv[1])
problems = []
compared = 0


def c_type(text):
    """The type of a C declarator such as `const double *xyz`, without the name."""
    text = re.sub(r"\bmgdt_status\b", "int32_t", text).strip()
    pointer = text.count("*")
    words = [w for w in re.findall(r"\w+", text)]
    constant = "const" in words
    words = [w for w in words if w != "const"]
    return ("const " if constant else "") + words[0] + "*" * pointer


def c_functions(text):
    """name -> (result, [parameters]) of the prototypes in C text."""
    text = re.sub(r"/\*.*?\*/|//[^\n]*", " ", text, flags=re.S)
    text = re.sub(r"^\s*#.*$", " ", text, flags=re.M)
    found = {}
    for result, name, parameters in re.findall(
            r"((?:const\s+)?\w+[\s*]+)(mgdt_\w+)\s*\(([^()]*)\)\s*;", text):
        if parameters.strip() == "void":
            parameters = ""
        found[name] = (c_type(result), [c_type(p) for p in parameters.split(",") if p.strip()])
    return found


header_text = "".join((source / "include/mgdt" / name).read_text(encoding="utf-8")
                      for name in ("mgdt.h", "mgdt_voronoi.h", "mgdt_domain.h", "mgdt_mesh.h", "mgdt_periodic.h"))
header = c_functions(header_text.replace("MGDT_API", " "))
constants = {name: int(value) for name, value in
             re.findall(r"^\s*(MGDT_(?:OK|ERR|ORDER|PARAMETER|SEPARATION|STAT|CHECK|MEASURE|TETRAHEDRON|INTERPOLATE|OUTSIDE|VORONOI|DOMAIN|MESH|BOUNDARY|POINTS|REASON|REFUSAL|SIZES|PERIODIC)\w*) = (\d+)", header_text, re.M)}


def expect(language, what, got, expected):
    global compared
    compared += 1
    if got != expected:
        problems.append(f"{language}: {what} is {got}; the header says {expected}")


# ------------------------------------------------------------------------------------------ Lua

lua_text = "".join(path.read_text(encoding="utf-8") for path in (source / "bindings/lua").glob("**/*.lua"))
lua_interface = (source / "bindings/lua/mgdt/interface.lua").read_text(encoding="utf-8")
lua = c_functions(re.search(r"cdef \[\[(.*?)\]\]", lua_interface, re.S).group(1))
for name, signature in lua.items():
    expect("Lua", name, signature, header.get(name))
for name in set(re.findall(r"\bC\.(mgdt_\w+)", lua_text)) - set(lua):
    problems.append(f"Lua: {name} is called and not declared")
BEGINNINGS = {"status": "MGDT_ERR_", "order": "MGDT_ORDER_", "parameter": "MGDT_PARAMETER_",
              "separation": "MGDT_SEPARATION_", "statistic": "MGDT_STAT_", "check": "MGDT_CHECK_",
              "measure": "MGDT_MEASURE_", "tetrahedron": "MGDT_TETRAHEDRON_",
              "method": "MGDT_INTERPOLATE_", "outside": "MGDT_OUTSIDE_", "voronoi_stat": "MGDT_VORONOI_STAT_",
              "voronoi_array": "MGDT_VORONOI_ARRAY_",
              "domain_kind": "MGDT_DOMAIN_KIND_", "domain_option": "MGDT_DOMAIN_OPTION_",
              "domain_stat": "MGDT_DOMAIN_STAT_", "domain_array": "MGDT_DOMAIN_ARRAY_",
              "mesh_option": "MGDT_MESH_OPTION_", "mesh_stat": "MGDT_MESH_STAT_",
              "mesh_array": "MGDT_MESH_ARRAY_", "boundary": "MGDT_BOUNDARY_", "points": "MGDT_POINTS_",
              "reason": "MGDT_REASON_", "refusal": "MGDT_REFUSAL_", "sizes": "MGDT_SIZES_",
              "periodic_option": "MGDT_PERIODIC_OPTION_", "periodic_stat": "MGDT_PERIODIC_STAT_",
              "periodic_array": "MGDT_PERIODIC_ARRAY_"}
named = {"MGDT_OK": 0}
for table, entries in re.findall(r"^    (\w+) = \{(.*?)\},$", lua_interface, re.S | re.M):
    for name, value in re.findall(r"(\w+) = (\d+)", entries):
        if name != "ok":
            named[BEGINNINGS[table] + name.upper()] = int(value)
expect("Lua", "the set of constants", named, constants)

# ------------------------------------------------------------------------------------------ Rust

RUST = {"i32": "int32_t", "i64": "int64_t", "u64": "uint64_t", "f64": "double", "usize": "size_t",
        "c_void": "void", "c_char": "char", "mgdt_status": "int32_t"}


def rust_type(text):
    text = text.strip()
    for prefix, constant in (("*const ", True), ("*mut ", False)):
        if text.startswith(prefix):
            inner = rust_type(text[len(prefix):])
            return ("const " if constant else "") + inner + "*"
    return RUST.get(text, text)


rust_text = (source / "bindings/rust/mgdt-sys/src/lib.rs").read_text(encoding="utf-8")
rust = {}
for name, parameters, result in re.findall(r"pub fn (mgdt_\w+)\(([^)]*)\)(?: -> ([^;]+))?;", rust_text):
    types = [rust_type(p.split(":", 1)[1]) for p in parameters.split(",") if p.strip()]
    rust[name] = (rust_type(result) if result else "void", types)
for name, signature in header.items():
    expect("Rust", name, rust.get(name), signature)
for name in set(rust) - set(header):
    problems.append(f"Rust: {name} is not in the header")
declared = {name: int(value) for name, value in
            re.findall(r"pub const (MGDT_\w+): \w+ = (\d+);", rust_text)}
expect("Rust", "the set of constants", declared, constants)
for kind, count in (("ORDER", "Order"), ("STAT", "Statistic"), ("PARAMETER", "Parameter"), ("SEPARATION", "Separation"), ("CHECK", "Check"),
                    ("MEASURE", "Measure"), ("TETRAHEDRON", "TetrahedronMeasure")):
    names = (source / "bindings/rust/mgdt/src/names.rs").read_text(encoding="utf-8")
    used = set(re.findall(r"= sys::(MGDT_%s_\w+)," % kind, names))
    expect("Rust", f"the variants of {count}", used, {c for c in constants if c.startswith(f"MGDT_{kind}_")})

# ----------------------------------------------------------------------------------------- Julia

JULIA = {"Int32": "int32_t", "Int64": "int64_t", "UInt64": "uint64_t", "Float64": "double",
         "Cvoid": "void", "Cstring": "const char*", "UInt8": "char"}


def julia_type(text):
    text = text.strip()
    inner = re.fullmatch(r"(?:Ptr|Ref)\{(.*)\}", text)
    return julia_type(inner.group(1)) + "*" if inner else JULIA.get(text, text)


def as_julia(c):
    """A C type as Julia's can tell it: a handle is void*, and const is not said."""
    return c.replace("mgdt_triangulation", "void").replace("const ", "")


julia_text = (source / "docs/other-languages.md").read_text(encoding="utf-8")
julia_text = julia_text[julia_text.index("## Julia"):]
calls = []
for match in re.finditer(r"@ccall[ (]libmgdt\.(mgdt_\w+)\(", julia_text):
    depth, k = 1, match.end()
    while depth:
        depth += {"(": 1, "[": 1, "{": 1, ")": -1, "]": -1, "}": -1}.get(julia_text[k], 0)
        k += 1
    inside = julia_text[match.end():k - 1]
    result = re.match(r"::([\w{}]+)", julia_text[k:]).group(1)
    calls.append((match.group(1), julia_type(result), [julia_type(t) for t in re.findall(r"::([\w{}]+)", inside)]))
for name, result, types in re.findall(r"ccall\(\(:(mgdt_\w+), libmgdt\), (\w+), \(([^)]*)\)", julia_text):
    calls.append((name, julia_type(result), [julia_type(t) for t in types.split(",")]))
for name, result, types in calls:
    expected = header.get(name)
    expect("Julia", name, (as_julia(result), [as_julia(t) for t in types]),
           expected and (as_julia(expected[0]), [as_julia(t) for t in expected[1]]))

# ------------------------------------------------------------------------------------- versions

version = re.search(r"version: '([\d.]+)'", (source / "meson.build").read_text(encoding="utf-8")).group(1)
for path, pattern in (("bindings/ruby/mgdt.gemspec", r'gem.version = "([\d.]+)"'),
                      ("bindings/rust/mgdt/Cargo.toml", r'^version = "([\d.]+)"'),
                      ("bindings/rust/mgdt-sys/Cargo.toml", r'^version = "([\d.]+)"')):
    found = re.search(pattern, (source / path).read_text(encoding="utf-8"), re.M).group(1)
    compared += 1
    if found != version:
        problems.append(f"{path} has version {found}; the project has {version}")

if len(header) < 45 or len(lua) < 40 or len(calls) < 8 or len(constants) < 40:
    problems.append(f"too little was found: {len(header)} functions in the header, {len(lua)} in Lua, "
                    f"{len(calls)} calls in Julia, {len(constants)} constants")
print("\n".join(problems))
print(f"{compared} declarations compared, {len(problems)} problems")
sys.exit(1 if problems else 0)
