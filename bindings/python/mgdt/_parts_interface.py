# SPDX-License-Identifier: MIT
# Generated from mgdt/mgdt_parts.h by bindings/interface/generate.py.
"""The functions of mgdt_parts.h for ctypes. Arrays are passed as addresses."""

from __future__ import annotations

import ctypes
from ctypes import POINTER, c_char_p, c_int32, c_int64, c_size_t, c_void_p
from typing import Any

from ._interface import ALLOC, FREE, PROGRESS

GATHER = ctypes.CFUNCTYPE(c_int32, c_void_p, c_void_p, c_void_p, c_void_p)
"""``mgdt_gather_fn``."""

EXCHANGE_NUMBERS = ctypes.CFUNCTYPE(c_int32, c_void_p, c_void_p, c_void_p)
"""``mgdt_exchange_numbers_fn``."""

EXCHANGE = ctypes.CFUNCTYPE(c_int32, c_void_p, c_void_p, c_void_p, c_void_p, c_void_p)
"""``mgdt_exchange_fn``."""

SUM = ctypes.CFUNCTYPE(c_int32, c_void_p, c_int64, c_void_p)
"""``mgdt_sum_fn``."""

LEAST = ctypes.CFUNCTYPE(c_int32, c_void_p, c_int64, c_void_p)
"""``mgdt_least_fn``."""

DESTROY_TRANSPORT = ctypes.CFUNCTYPE(None, c_void_p)
"""``mgdt_destroy_transport_fn``."""

PART = ctypes.CFUNCTYPE(c_int32, c_void_p, c_int32, c_void_p)
"""``mgdt_part_fn``."""


class Transport(ctypes.Structure):
    """``mgdt_transport``."""

    _fields_ = [
        ("size", c_size_t),
        ("processes", c_int32),
        ("process", c_int32),
        ("gather", GATHER),
        ("exchange_numbers", EXCHANGE_NUMBERS),
        ("exchange", EXCHANGE),
        ("sum", SUM),
        ("least", LEAST),
        ("destroy", DESTROY_TRANSPORT),
        ("user", c_void_p),
    ]


# The result of each function, and its parameters.
FUNCTIONS: dict[str, tuple[Any, list[Any]]] = {
    "mgdt_parts_create": (c_int32, [c_int32, POINTER(c_void_p)]),
    "mgdt_parts_create_with_allocator": (
        c_int32,
        [c_int32, ALLOC, FREE, c_void_p, POINTER(c_void_p)],
    ),
    "mgdt_parts_create_with_transport": (c_int32, [c_void_p, POINTER(c_void_p)]),
    "mgdt_parts_destroy": (None, [c_void_p]),
    "mgdt_parts_clear": (c_int32, [c_void_p]),
    "mgdt_parts_set_option": (c_int32, [c_void_p, c_int32, c_int64]),
    "mgdt_parts_get_option": (c_int32, [c_void_p, c_int32, c_void_p]),
    "mgdt_parts_set_progress": (c_int32, [c_void_p, PROGRESS, c_void_p]),
    "mgdt_parts_get_progress": (c_int32, [c_void_p, c_void_p, POINTER(c_void_p)]),
    "mgdt_parts_cancel": (c_int32, [c_void_p]),
    "mgdt_parts_insert_points": (c_int32, [c_void_p, c_int32, c_int64, c_void_p, c_void_p]),
    "mgdt_parts_build": (c_int32, [c_void_p]),
    "mgdt_parts_build_each": (c_int32, [c_void_p, PART, c_void_p]),
    "mgdt_parts_get_stat": (c_int32, [c_void_p, c_int32, c_int32, c_void_p]),
    "mgdt_parts_array_info": (c_int32, [c_int32, c_void_p, c_void_p]),
    "mgdt_parts_get_size": (c_int32, [c_void_p, c_int32, c_int32, c_void_p]),
    "mgdt_parts_get_array": (c_int32, [c_void_p, c_int32, c_int32, c_int64, c_void_p]),
    "mgdt_parts_get_coordinates": (c_int32, [c_void_p, c_int32, c_int64, c_void_p]),
    "mgdt_parts_check": (c_int32, [c_void_p, c_int32]),
    "mgdt_parts_get_error": (c_int32, [c_void_p, c_int64, c_char_p]),
}

# The constants, by group and name.
CONSTANTS: dict[str, dict[str, int]] = {
    "part": {
        "this_part": -1,
    },
    "option": {
        "index_base": 10,
        "threads": 20,
        "memory_limit": 30,
        "read_progress": 40,
    },
    "number": {
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
    },
    "array": {
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
    },
}
