#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the raw layers of the bindings, from the headers and their descriptions.

  generate.py

Needs pycparser and fypp (Debian's python3-pycparser and fypp). docs/contributing.md shows how a function is added.
"""

from __future__ import annotations

import sys
from pathlib import Path

import fortran
import header
import rust
import scripting
from description import TRIANGULATION
from domain import DOMAIN
from mesh import MESH
from parts import MPI, PARTS
from periodic import PERIODIC
from voronoi import VORONOI

BINDINGS = Path(__file__).resolve().parents[1]
HEADERS = BINDINGS.parent / "include" / "mgdt"


def read_all(folder: Path = HEADERS) -> list[header.Interface]:
    """The interfaces of mgdt.h, mgdt_parts.h, mgdt_mpi.h, mgdt_voronoi.h, mgdt_mesh.h, mgdt_domain.h and
    mgdt_periodic.h."""
    found: list[header.Interface] = []
    for description in (TRIANGULATION, PARTS, MPI, VORONOI, MESH, DOMAIN, PERIODIC):
        found.append(header.read(folder / description.header, description, found))
    return found


def all_files(interfaces: list[header.Interface]) -> dict[str, str]:
    """The files by their names below the folder of the bindings."""
    triangulation, parts, mpi, voronoi, mesh, domain, periodic = interfaces
    whole = triangulation.joined(voronoi).joined(mesh).joined(domain).joined(periodic)
    return {**fortran.files(whole, parts, mpi), **rust.files(whole), **scripting.files(whole, parts)}


def main() -> None:
    try:
        texts = all_files(read_all())
    except header.DescriptionError as error:
        sys.exit(f"generate.py: {error}")
    for name, text in texts.items():
        (BINDINGS / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
