# SPDX-License-Identifier: MIT
# Generated from mgdt/mgdt_domain.h by bindings/interface/generate.py.
"""The functions of mgdt_domain.h for ctypes. Arrays are passed as addresses."""

from __future__ import annotations

from ctypes import POINTER, c_char_p, c_int32, c_int64, c_void_p
from typing import Any

from ._interface import ALLOC, FREE, PROGRESS

# The result of each function, and its parameters.
FUNCTIONS: dict[str, tuple[Any, list[Any]]] = {
    "mgdt_domain_create": (c_int32, [POINTER(c_void_p)]),
    "mgdt_domain_create_with_allocator": (c_int32, [ALLOC, FREE, c_void_p, POINTER(c_void_p)]),
    "mgdt_domain_destroy": (None, [c_void_p]),
    "mgdt_domain_clear": (c_int32, [c_void_p]),
    "mgdt_domain_set_option": (c_int32, [c_void_p, c_int32, c_int64]),
    "mgdt_domain_get_option": (c_int32, [c_void_p, c_int32, c_void_p]),
    "mgdt_domain_set_progress": (c_int32, [c_void_p, PROGRESS, c_void_p]),
    "mgdt_domain_cancel": (c_int32, [c_void_p]),
    "mgdt_domain_set_points": (c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_domain_set_facets": (c_int32, [c_void_p, c_int64, c_void_p, c_void_p, c_void_p]),
    "mgdt_domain_set_segments": (c_int32, [c_void_p, c_int64, c_void_p, c_void_p]),
    "mgdt_domain_add_region": (c_int32, [c_void_p, c_void_p, c_int32]),
    "mgdt_domain_add_hole": (c_int32, [c_void_p, c_void_p]),
    "mgdt_domain_validate": (c_int32, [c_void_p]),
    "mgdt_domain_build": (c_int32, [c_void_p]),
    "mgdt_domain_check": (c_int32, [c_void_p]),
    "mgdt_domain_get_stat": (c_int32, [c_void_p, c_int32, c_void_p]),
    "mgdt_domain_get_size": (c_int32, [c_void_p, c_int32, c_void_p]),
    "mgdt_domain_get_array": (c_int32, [c_void_p, c_int32, c_int64, c_void_p]),
    "mgdt_domain_get_array_i32": (c_int32, [c_void_p, c_int32, c_int64, c_void_p]),
    "mgdt_domain_get_doubles": (c_int32, [c_void_p, c_int32, c_int64, c_void_p]),
    "mgdt_domain_get_error": (c_int32, [c_void_p, c_int64, c_char_p]),
}

# The constants, by group and name.
CONSTANTS: dict[str, dict[str, int]] = {
    "kind": {
        "facet": 0,
        "segment": 1,
        "point": 2,
    },
    "option": {
        "index_base": 10,
        "threads": 20,
        "memory_limit": 30,
        "round_points": 40,
    },
    "number": {
        "given_points": 10,
        "given_facets": 11,
        "given_segments": 12,
        "memory_bytes": 15,
        "steiner_points": 20,
        "tetrahedra": 21,
        "regions": 22,
        "faces": 23,
        "is_rounded": 24,
        "planar_facets": 30,
        "missing_facets": 31,
        "cavities": 32,
        "largest_cavity": 33,
    },
    "array": {
        "offending_pairs": 10,
        "tetrahedra": 20,
        "neighbors": 21,
        "regions": 22,
        "region_markers": 23,
        "faces": 30,
        "face_tetrahedra": 31,
        "face_facets": 32,
        "face_markers": 33,
        "segments": 40,
        "segment_sources": 41,
        "segment_markers": 42,
        "steiner_edges": 50,
        "points": 60,
        "steiner_parameters": 61,
    },
}
