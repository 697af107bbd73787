# SPDX-License-Identifier: MIT
# Generated from mgdt/mgdt_parts.h by bindings/interface/generate.py.
"""The options, numbers and arrays of parts, by name."""

from __future__ import annotations

OPTIONS = {
    "index_base": 10,
    "threads": 20,
    "memory_limit": 30,
}
NUMBERS = {
    "parts": 10,
    "first_local": 11,
    "local_parts": 12,
    "points": 20,
    "own_vertices": 30,
    "vertices": 31,
    "all_vertices": 32,
    "own_tetrahedra": 40,
    "tetrahedra": 41,
    "all_tetrahedra": 42,
    "received": 50,
    "memory_bytes": 60,
}
ARRAYS = {
    "point_map": 10,
    "vertex_numbers": 20,
    "vertex_ids": 21,
    "vertex_owners": 22,
    "vertex_ranges": 23,
    "corners": 30,
    "local_corners": 31,
    "tetrahedron_numbers": 32,
    "tetrahedron_owners": 33,
    "tetrahedron_ranges": 34,
    "neighbors": 40,
}
