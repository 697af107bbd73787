#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the raw layers of the bindings, from include/mgdt/mgdt.h and description.py.

  generate.py

Needs pycparser and fypp (Debian's python3-pycparser and fypp). docs/contributing.md shows how a function is added.
"""

from __future__ import annotations

import sys
from pathlib import Path

import fortran
import header
import parts
import rust
import scripting

BINDINGS = Path(__file__).resolve().parents[1]


def all_files(interface: header.Interface) -> dict[str, str]:
    """The files by their names below the folder of the bindings."""
    found: dict[str, str] = {}
    for writer in (fortran, rust, scripting):
        found.update(writer.files(interface))
    found.update(parts.files())
    return found


def main() -> None:
    try:
        interface = header.read(BINDINGS.parent / "include" / "mgdt" / "mgdt.h")
        texts = all_files(interface)
    except header.DescriptionError as error:
        sys.exit(f"generate.py: {error}")
    for name, text in texts.items():
        (BINDINGS / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
