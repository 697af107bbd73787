# SPDX-License-Identifier: MIT
# Generated from mgdt/mgdt.h by bindings/interface/generate.py.
"""The functions of the C interface for ctypes. Arrays are passed as addresses."""

from __future__ import annotations

import ctypes
from ctypes import POINTER, c_char_p, c_double, c_int32, c_int64, c_size_t, c_uint64, c_void_p
from typing import Any

ALLOC = ctypes.CFUNCTYPE(c_void_p, c_size_t, c_size_t, c_void_p)
"""``mgdt_alloc_fn``."""

FREE = ctypes.CFUNCTYPE(None, c_void_p, c_size_t, c_size_t, c_void_p)
"""``mgdt_free_fn``."""

PROGRESS = ctypes.CFUNCTYPE(c_int32, c_double, c_void_p)
"""``mgdt_progress_fn``."""

# The result of each function, and its parameters.
FUNCTIONS: dict[str, tuple[Any, list[Any]]] = {
    "mgdt_create": (c_int32, [POINTER(c_void_p)]),
    "mgdt_create_with_allocator": (c_int32, [ALLOC, FREE, c_void_p, POINTER(c_void_p)]),
    "mgdt_destroy": (None, [c_void_p]),
    "mgdt_clear": (c_int32, [c_void_p]),
    "mgdt_reserve": (c_int32, [c_void_p, c_int64]),
    "mgdt_shrink": (c_int32, [c_void_p]),
    "mgdt_set_order_scheme": (c_int32, [c_void_p, c_int32]),
    "mgdt_get_order_scheme": (c_int32, [c_void_p, c_void_p]),
    "mgdt_set_order_parameter": (c_int32, [c_void_p, c_int32, c_double]),
    "mgdt_get_order_parameter": (c_int32, [c_void_p, c_int32, c_void_p]),
    "mgdt_set_seed": (c_int32, [c_void_p, c_uint64]),
    "mgdt_get_seed": (c_int32, [c_void_p, c_void_p]),
    "mgdt_set_threads": (c_int32, [c_void_p, c_int32]),
    "mgdt_get_threads": (c_int32, [c_void_p, c_void_p]),
    "mgdt_set_index_base": (c_int32, [c_void_p, c_int32]),
    "mgdt_get_index_base": (c_int32, [c_void_p, c_void_p]),
    "mgdt_set_memory_limit": (c_int32, [c_void_p, c_int64]),
    "mgdt_get_memory_limit": (c_int32, [c_void_p, c_void_p]),
    "mgdt_set_compact": (c_int32, [c_void_p, c_int32]),
    "mgdt_get_compact": (c_int32, [c_void_p, c_void_p]),
    "mgdt_set_progress": (c_int32, [c_void_p, PROGRESS, c_void_p]),
    "mgdt_get_progress": (c_int32, [c_void_p, c_void_p, POINTER(c_void_p)]),
    "mgdt_cancel": (c_int32, [c_void_p]),
    "mgdt_set_canonical_output": (c_int32, [c_void_p, c_int32]),
    "mgdt_get_canonical_output": (c_int32, [c_void_p, c_void_p]),
    "mgdt_set_isa": (c_int32, [c_void_p, c_char_p]),
    "mgdt_insert_points": (c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_insert_points_strided": (
        c_int32,
        [c_void_p, c_int64, c_void_p, c_void_p, c_void_p, c_int64],
    ),
    "mgdt_point_count": (c_int64, [c_void_p]),
    "mgdt_vertex_count": (c_int64, [c_void_p]),
    "mgdt_dimension": (c_int32, [c_void_p]),
    "mgdt_tetrahedron_count": (c_int64, [c_void_p]),
    "mgdt_hull_facet_count": (c_int64, [c_void_p]),
    "mgdt_edge_count": (c_int64, [c_void_p]),
    "mgdt_vertex_tetrahedra_count": (c_int64, [c_void_p]),
    "mgdt_get_tetrahedra": (c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_get_tetrahedra_i32": (c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_get_neighbors": (c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_get_neighbors_i32": (c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_get_hull_facets": (c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_get_hull_facets_i32": (c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_get_edges": (c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_get_edges_i32": (c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_get_point_map": (c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_get_point_map_i32": (c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_get_vertex_tetrahedra": (c_int32, [c_void_p, c_int64, c_void_p, c_int64, c_void_p]),
    "mgdt_get_vertex_tetrahedra_i32": (c_int32, [c_void_p, c_int64, c_void_p, c_int64, c_void_p]),
    "mgdt_locate": (c_int32, [c_void_p, c_void_p, c_void_p]),
    "mgdt_locate_i32": (c_int32, [c_void_p, c_void_p, c_void_p]),
    "mgdt_locate_points": (c_int32, [c_void_p, c_int64, c_void_p, c_void_p, c_void_p]),
    "mgdt_locate_points_i32": (c_int32, [c_void_p, c_int64, c_void_p, c_void_p, c_void_p]),
    "mgdt_nearest_vertex": (c_int32, [c_void_p, c_void_p, c_void_p]),
    "mgdt_nearest_vertex_i32": (c_int32, [c_void_p, c_void_p, c_void_p]),
    "mgdt_nearest_vertices": (c_int32, [c_void_p, c_int64, c_void_p, c_void_p]),
    "mgdt_nearest_vertices_i32": (c_int32, [c_void_p, c_int64, c_void_p, c_void_p]),
    "mgdt_check": (c_int32, [c_void_p, c_int32]),
    "mgdt_get_stat": (c_int32, [c_void_p, c_int32, c_void_p]),
    "mgdt_stat_name": (c_char_p, [c_int32]),
    "mgdt_status_string": (c_char_p, [c_int32]),
    "mgdt_get_error": (c_int32, [c_void_p, c_int64, c_char_p]),
    "mgdt_order_scheme_name": (c_char_p, [c_int32]),
    "mgdt_order_scheme_from_name": (c_int32, [c_char_p, c_void_p]),
    "mgdt_order_scheme_at": (c_int32, [c_int32, c_void_p]),
    "mgdt_version_string": (c_char_p, []),
    "mgdt_abi_version": (c_int32, []),
    "mgdt_isa_name": (c_char_p, [c_void_p]),
}

# The constants, by group and name.
CONSTANTS: dict[str, dict[str, int]] = {
    "status": {
        "ok": 0,
        "null_pointer": 10,
        "invalid_argument": 11,
        "not_finite": 12,
        "unknown_scheme": 13,
        "unknown_key": 14,
        "buffer_too_small": 20,
        "index_range": 21,
        "out_of_memory": 30,
        "too_large": 31,
        "cancelled": 40,
        "busy": 41,
        "check_failed": 60,
        "internal": 90,
    },
    "order": {
        "auto": 0,
        "input": 10,
        "random": 20,
        "lexicographic": 30,
        "brio": 40,
        "hilbert": 50,
        "regular_grid": 60,
        "kd_tree": 70,
        "enhanced_kd_tree": 80,
        "multi_grid": 90,
    },
    "parameter": {
        "points_per_cell": 10,
        "threshold": 20,
        "separation": 30,
        "round_ratio": 40,
    },
    "separation": {
        "none": 0,
        "passes": 1,
        "rounds": 2,
    },
    "statistic": {
        "points_inserted": 10,
        "duplicates": 11,
        "walk_steps": 20,
        "walk_tests": 21,
        "conflict_tests": 22,
        "tetrahedra_removed": 30,
        "tetrahedra_created": 31,
        "exact_calls": 40,
        "put_off": 45,
        "inserted_alone": 46,
        "order_seconds": 50,
        "insert_seconds": 51,
        "grid_levels": 60,
        "rounds": 61,
        "threads": 62,
        "memory_bytes": 70,
        "peak_memory_bytes": 71,
    },
    "check": {
        "combinatorial": 1,
        "geometric": 2,
        "canonical": 3,
    },
}
