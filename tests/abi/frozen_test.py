#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a release declared is still declared, with the same types and values; and the clients that were
compiled with it and with earlier releases use all of it. Comments and layout are free.

  frozen_test.py --headers mgdt.h [mgdt_parts.h ...] --frozen mgdt-1.0.h [mgdt-1.1.h ...]
                 --clients CLIENT_OF_1.0 [CLIENT_OF_1.1 ...]

Frozen headers and clients are given oldest first. The last header and the last client are those of the
release; the other headers tell in which version node a function is, and the other clients call what
their releases added.
"""
import argparse
import re
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # the source tree stays as it is
sys.path.append(str(Path(__file__).resolve().parents[1]))
from checks import check, finish, output_of
import interface

# These count versions, so they grow; MGDT_API and the guard say nothing to a program's text.
FREE = {("macro", name) for name in ("MGDT_VERSION_MINOR", "MGDT_VERSION_PATCH", "MGDT_API", "MGDT_MGDT_H")}

# Changes that must be noticed: in the header, what becomes of it, what is reported.
CHANGES = [
    (r"MGDT_ERR_CANCELLED = 40", "MGDT_ERR_CANCELLED = 41", "enumerator MGDT_ERR_CANCELLED"),
    (r"MGDT_ORDER_BRIO = 40,", "", "enumerator MGDT_ORDER_BRIO"),
    (r"MGDT_STAT_ROUNDS\b", "MGDT_STAT_TURNS", "enumerator MGDT_STAT_ROUNDS"),
    (r"MGDT_CHECK_CANONICAL = 3", "MGDT_CHECK_CANONICAL", "enumerator MGDT_CHECK_CANONICAL"),
    (r"#define MGDT_VERSION_MAJOR 1", "#define MGDT_VERSION_MAJOR 2", "macro MGDT_VERSION_MAJOR"),
    (r"typedef int32_t mgdt_status;", "typedef int mgdt_status;", "type mgdt_status"),
    (r"\(double fraction, void ?\* ?user\)", "(double fraction)", "type mgdt_progress_fn"),
    (r"typedef struct mgdt_triangulation", "typedef union mgdt_triangulation", "type mgdt_triangulation"),
    (r"(mgdt_reserve\([^;]*)int64_t", r"\1int32_t", "function mgdt_reserve"),
    (r"(mgdt_insert_points\([^;]*)const double", r"\1double", "function mgdt_insert_points"),
    (r"MGDT_API mgdt_status mgdt_check\([^;]*;", "", "function mgdt_check"),
    (r"MGDT_API int32_t mgdt_dimension", "int32_t mgdt_dimension", "function mgdt_dimension"),
    (r"int32_t mgdt_abi_version\(void\)", "int64_t mgdt_abi_version(void)", "function mgdt_abi_version"),
]
# Changes of what 1.2 added.
CHANGES_1_2 = [
    (r"(int32_t processes;)(\s*)(int32_t process;)", r"\3\2\1", "type mgdt_transport"),
    (r"void ?\* ?user;\n\} mgdt_transport", "} mgdt_transport", "type mgdt_transport"),
    (r"(mgdt_move_points\([^;]*)const int64_t", r"\1int64_t", "function mgdt_move_points"),
    (r"MGDT_PARTS_THIS_PART = -1", "MGDT_PARTS_THIS_PART = 0", "enumerator MGDT_PARTS_THIS_PART"),
]
# Changes of what 1.3 added.
CHANGES_1_3 = [
    (r"MGDT_MESH_ARRAY_NEIGHBORS = 211", "MGDT_MESH_ARRAY_NEIGHBORS = 213", "enumerator MGDT_MESH_ARRAY_NEIGHBORS"),
    (r"typedef struct mgdt_mesh mgdt_mesh;", "typedef struct mgdt_domain mgdt_mesh;", "type mgdt_mesh"),
    (r"(mgdt_domain_build\([^;]*)mgdt_mesh\*\*", r"\1mgdt_mesh*", "function mgdt_domain_build"),
    (r"MGDT_API mgdt_status mgdt_periodic_check\([^;]*;", "", "function mgdt_periodic_check"),
]
# And changes that may be made.
GROWTH = [
    (r"(MGDT_ERR_INTERNAL = 90)", r"\1, MGDT_ERR_NEW = 91"),
    (r"(MGDT_API void mgdt_destroy)", r"MGDT_API int32_t mgdt_new(void);\n\1"),
    (r"(typedef int32_t mgdt_status;)", r"\1 /* more of it */ typedef int32_t mgdt_other;"),
    (r"#define MGDT_VERSION_MINOR \d+", "#define MGDT_VERSION_MINOR 99\n#define MGDT_NEW 3"),
    (r"MGDT_ERR_CANCELLED = 40,", "MGDT_ERR_CANCELLED = 40, /**< Told anew, with a comma; = 41 */"),
    (r"(MGDT_API void mgdt_destroy)", "/** Told anew.\n#define MGDT_VERSION_MAJOR 7\nMGDT_API int32_t mgdt_clear(void);\n"
     r" */\n\1"),
    (r"mgdt_status mgdt_clear\(mgdt_triangulation ?\* ?t\)", "mgdt_status\n    mgdt_clear( mgdt_triangulation *  t )"),
]


def lost(old, new):
    """What the old header declared and the new one does not, or otherwise."""
    return [f"{kind} {name}: '{old[kind, name]}' is now '{new.get((kind, name), 'nothing')}'"
            for kind, name in sorted(old)
            if ((kind, name) not in new if (kind, name) in FREE else new.get((kind, name)) != old[kind, name])]


def main():
    parser = argparse.ArgumentParser()
    for name in ("headers", "frozen", "clients"):
        parser.add_argument(f"--{name}", type=Path, nargs="+", required=True)
    options = parser.parse_args()
    header = "\n".join(path.read_text() for path in options.headers)
    frozen = options.frozen[-1].read_text()
    nodes = interface.nodes_of(options.frozen)
    old = interface.declarations(frozen)
    kinds = {kind: sum(k == kind for k, _ in old) for kind in ("function", "enumerator", "type", "macro")}
    print(kinds)
    check("the frozen header is read", "" if all(kinds[k] >= n for k, n in
          (("function", 50), ("enumerator", 44), ("type", 5), ("macro", 4))) else str(kinds))
    check("each MGDT_API is a function", "" if len(re.findall(r"^MGDT_API\b", frozen, flags=re.M)) == kinds["function"]
          else "some declarations were not understood")
    for older in options.frozen[:-1]:
        check(f"what {older.name} declared was declared",
              "; ".join(lost(interface.declarations(older.read_text()), old)))
    check("what it declared is declared", "; ".join(lost(old, interface.declarations(header))))

    changes = CHANGES + (CHANGES_1_2 if "mgdt_transport" in frozen else []) + (CHANGES_1_3 if "mgdt_mesh" in frozen else [])
    for pattern, replacement, report in changes:
        changed = re.sub(pattern, replacement, frozen)
        problems = lost(old, interface.declarations(changed))
        check(f"a change of {report} is noticed", "" if changed != frozen and len(problems) == 1 and
              problems[0].startswith(report + ":") else f"reported: {problems}")
    for pattern, replacement in GROWTH:
        changed = re.sub(pattern, replacement, frozen)
        check(f"'{replacement.strip()}' is no change", "nothing is like it" if changed == frozen else
              "; ".join(lost(old, interface.declarations(changed))))

    # The clients must ask the library for every function, by the version node that it had.
    asked = {}
    for client in options.clients:
        symbols = output_of("nm", "-D", "--undefined-only", "--with-symbol-versions", client)
        asked.update(re.findall(r"\bU (mgdt_\w+)@+(\w[\w.]*)", symbols))
    functions = {name for kind, name in old if kind == "function"}
    check("the clients call every function", " ".join(sorted(functions - set(asked))))
    check("by the version node of the release that had it first",
          " ".join(f"{n}@{node}" for n, node in asked.items() if node != nodes.get(n)))
    run = subprocess.run([str(options.clients[-1])], capture_output=True, text=True)
    print(run.stdout, end="")
    check("the client gets the results of its time", run.stdout + run.stderr if run.returncode else "")
    check("and has compared some", "" if re.search(r"\b[1-9]\d+ checks, 0 failed", run.stdout) else run.stdout)
    finish()


if __name__ == "__main__":
    main()
