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

# The version that has brought a function, its result, and its parameters.
FUNCTIONS: dict[str, tuple[str, Any, list[Any]]] = {
    "mgdt_create": ("1.0", c_int32, [POINTER(c_void_p)]),
    "mgdt_create_with_allocator": ("1.0", c_int32, [ALLOC, FREE, c_void_p, POINTER(c_void_p)]),
    "mgdt_destroy": ("1.0", None, [c_void_p]),
    "mgdt_clear": ("1.0", c_int32, [c_void_p]),
    "mgdt_reserve": ("1.0", c_int32, [c_void_p, c_int64]),
    "mgdt_set_order_scheme": ("1.0", c_int32, [c_void_p, c_int32]),
    "mgdt_set_order_parameter": ("1.0", c_int32, [c_void_p, c_int32, c_double]),
    "mgdt_set_seed": ("1.0", c_int32, [c_void_p, c_uint64]),
    "mgdt_set_threads": ("1.0", c_int32, [c_void_p, c_int32]),
    "mgdt_set_index_base": ("1.0", c_int32, [c_void_p, c_int32]),
    "mgdt_set_memory_limit": ("1.0", c_int32, [c_void_p, c_int64]),
    "mgdt_set_compact": ("1.1", c_int32, [c_void_p, c_int32]),
    "mgdt_set_progress": ("1.0", c_int32, [c_void_p, PROGRESS, c_void_p]),
    "mgdt_cancel": ("1.0", c_int32, [c_void_p]),
    "mgdt_set_canonical_output": ("1.0", c_int32, [c_void_p, c_int32]),
    "mgdt_set_isa": ("1.0", c_int32, [c_void_p, c_char_p]),
    "mgdt_insert_points": ("1.0", c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_insert_points_strided": (
        "1.0",
        c_int32,
        [c_void_p, c_int64, c_void_p, c_void_p, c_void_p, c_int64],
    ),
    "mgdt_point_count": ("1.0", c_int64, [c_void_p]),
    "mgdt_vertex_count": ("1.0", c_int64, [c_void_p]),
    "mgdt_dimension": ("1.0", c_int32, [c_void_p]),
    "mgdt_tetrahedron_count": ("1.0", c_int64, [c_void_p]),
    "mgdt_hull_facet_count": ("1.0", c_int64, [c_void_p]),
    "mgdt_edge_count": ("1.0", c_int64, [c_void_p]),
    "mgdt_vertex_tetrahedra_count": ("1.0", c_int64, [c_void_p]),
    "mgdt_get_tetrahedra": ("1.0", c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_get_tetrahedra_i32": ("1.0", c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_get_neighbors": ("1.0", c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_get_neighbors_i32": ("1.0", c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_get_hull_facets": ("1.0", c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_get_hull_facets_i32": ("1.0", c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_get_edges": ("1.0", c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_get_edges_i32": ("1.0", c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_get_point_map": ("1.0", c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_get_point_map_i32": ("1.0", c_int32, [c_void_p, c_int64, c_void_p]),
    "mgdt_get_vertex_tetrahedra": (
        "1.0",
        c_int32,
        [c_void_p, c_int64, c_void_p, c_int64, c_void_p],
    ),
    "mgdt_get_vertex_tetrahedra_i32": (
        "1.0",
        c_int32,
        [c_void_p, c_int64, c_void_p, c_int64, c_void_p],
    ),
    "mgdt_locate": ("1.0", c_int32, [c_void_p, c_void_p, c_void_p]),
    "mgdt_locate_points": ("1.0", c_int32, [c_void_p, c_int64, c_void_p, c_void_p, c_void_p]),
    "mgdt_locate_points_i32": ("1.0", c_int32, [c_void_p, c_int64, c_void_p, c_void_p, c_void_p]),
    "mgdt_nearest_vertex": ("1.0", c_int32, [c_void_p, c_void_p, c_void_p]),
    "mgdt_check": ("1.0", c_int32, [c_void_p, c_int32]),
    "mgdt_get_stat": ("1.0", c_int32, [c_void_p, c_int32, c_void_p]),
    "mgdt_stat_name": ("1.0", c_char_p, [c_int32]),
    "mgdt_status_string": ("1.0", c_char_p, [c_int32]),
    "mgdt_get_error": ("1.0", c_int32, [c_void_p, c_int64, c_char_p]),
    "mgdt_order_scheme_name": ("1.0", c_char_p, [c_int32]),
    "mgdt_order_scheme_from_name": ("1.0", c_int32, [c_char_p, c_void_p]),
    "mgdt_version_string": ("1.0", c_char_p, []),
    "mgdt_abi_version": ("1.0", c_int32, []),
    "mgdt_isa_name": ("1.0", c_char_p, [c_void_p]),
}
