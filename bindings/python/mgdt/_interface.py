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
    "mgdt_set_order_scheme": (c_int32, [c_void_p, c_int32]),
    "mgdt_set_order_parameter": (c_int32, [c_void_p, c_int32, c_double]),
    "mgdt_set_seed": (c_int32, [c_void_p, c_uint64]),
    "mgdt_set_threads": (c_int32, [c_void_p, c_int32]),
    "mgdt_set_index_base": (c_int32, [c_void_p, c_int32]),
    "mgdt_set_memory_limit": (c_int32, [c_void_p, c_int64]),
    "mgdt_set_compact": (c_int32, [c_void_p, c_int32]),
    "mgdt_set_progress": (c_int32, [c_void_p, PROGRESS, c_void_p]),
    "mgdt_cancel": (c_int32, [c_void_p]),
    "mgdt_set_canonical_output": (c_int32, [c_void_p, c_int32]),
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
