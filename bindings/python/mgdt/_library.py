# SPDX-License-Identifier: MIT
"""Finding libmgdt, checking that it fits, and declaring its functions to ctypes."""

from __future__ import annotations

import ctypes
import ctypes.util
import os
from ctypes import POINTER, c_char_p, c_double, c_int32, c_int64, c_uint64, c_void_p
from typing import Any, Iterator

ABI_VERSION = 1
"""The version of the binary interface that this package is written for."""

ENVIRONMENT_VARIABLE = "MGDT_LIBRARY"
"""Names the library file to load, and no other, when it is set."""

BUNDLED_NAMES = ("libmgdt.so.1", "libmgdt.1.dylib")
"""Names under which a wheel may bring its own library, in this package's folder."""

INSTALLED_NAME = "libmgdt.path"
"""The file in this package's folder in which ``meson install`` leaves the path of the library."""

PROGRESS = ctypes.CFUNCTYPE(c_int32, c_double, c_void_p)
"""``mgdt_progress_fn``."""

NO_PROGRESS = PROGRESS(0)
"""NULL."""

# The return type and the parameters of every function that the package calls. Arrays are passed
# as addresses.
_HANDLE = c_void_p
_STATUS = c_int32
_ARRAY = c_void_p
_SIGNATURES: dict[str, tuple[Any, list[Any]]] = {
    "mgdt_abi_version": (c_int32, []),
    "mgdt_version_string": (c_char_p, []),
    "mgdt_create": (_STATUS, [POINTER(c_void_p)]),
    "mgdt_destroy": (None, [_HANDLE]),
    "mgdt_clear": (_STATUS, [_HANDLE]),
    "mgdt_set_order_scheme": (_STATUS, [_HANDLE, c_int32]),
    "mgdt_set_order_parameter": (_STATUS, [_HANDLE, c_int32, c_double]),
    "mgdt_set_seed": (_STATUS, [_HANDLE, c_uint64]),
    "mgdt_set_threads": (_STATUS, [_HANDLE, c_int32]),
    "mgdt_set_memory_limit": (_STATUS, [_HANDLE, c_int64]),
    "mgdt_set_compact": (_STATUS, [_HANDLE, c_int32]),
    "mgdt_set_progress": (_STATUS, [_HANDLE, PROGRESS, c_void_p]),
    "mgdt_cancel": (_STATUS, [_HANDLE]),
    "mgdt_set_canonical_output": (_STATUS, [_HANDLE, c_int32]),
    "mgdt_insert_points": (_STATUS, [_HANDLE, c_int64, _ARRAY]),
    "mgdt_insert_points_strided": (_STATUS, [_HANDLE, c_int64, _ARRAY, _ARRAY, _ARRAY, c_int64]),
    "mgdt_point_count": (c_int64, [_HANDLE]),
    "mgdt_vertex_count": (c_int64, [_HANDLE]),
    "mgdt_dimension": (c_int32, [_HANDLE]),
    "mgdt_tetrahedron_count": (c_int64, [_HANDLE]),
    "mgdt_hull_facet_count": (c_int64, [_HANDLE]),
    "mgdt_edge_count": (c_int64, [_HANDLE]),
    "mgdt_get_tetrahedra_i32": (_STATUS, [_HANDLE, c_int64, _ARRAY]),
    "mgdt_get_neighbors_i32": (_STATUS, [_HANDLE, c_int64, _ARRAY]),
    "mgdt_get_hull_facets_i32": (_STATUS, [_HANDLE, c_int64, _ARRAY]),
    "mgdt_get_edges_i32": (_STATUS, [_HANDLE, c_int64, _ARRAY]),
    "mgdt_get_point_map_i32": (_STATUS, [_HANDLE, c_int64, _ARRAY]),
    "mgdt_locate_points_i32": (_STATUS, [_HANDLE, c_int64, _ARRAY, _ARRAY, _ARRAY]),
    "mgdt_nearest_vertex": (_STATUS, [_HANDLE, _ARRAY, _ARRAY]),
    "mgdt_check": (_STATUS, [_HANDLE, c_int32]),
    "mgdt_get_stat": (_STATUS, [_HANDLE, c_int32, POINTER(c_double)]),
    "mgdt_stat_name": (c_char_p, [c_int32]),
    "mgdt_status_string": (c_char_p, [_STATUS]),
    "mgdt_get_error": (_STATUS, [_HANDLE, c_int64, c_char_p]),
    "mgdt_order_scheme_name": (c_char_p, [c_int32]),
    "mgdt_isa_name": (c_char_p, [_HANDLE]),
}


class _Unsuitable(Exception):
    """A library that was found but cannot be used."""


def _installed(folder: str) -> str | None:
    """The library that was installed together with the package, if it was."""
    try:
        with open(os.path.join(folder, INSTALLED_NAME), encoding="utf-8") as file:
            # A path from the package on stays right when both are moved.
            return os.path.normpath(os.path.join(folder, file.read().rstrip("\n")))
    except FileNotFoundError:
        return None


def _candidates() -> Iterator[tuple[str, str]]:
    """Where the library may be, best first: a description and what to load."""
    named = os.environ.get(ENVIRONMENT_VARIABLE)
    if named:
        yield f"the environment variable {ENVIRONMENT_VARIABLE}", named
        return
    here = os.path.dirname(os.path.abspath(__file__))
    for name in BUNDLED_NAMES:
        bundled = os.path.join(here, name)
        if os.path.exists(bundled):
            yield "bundled with the package", bundled
    installed = _installed(here)
    if installed is not None:
        yield "installed with the package", installed
    yield "the system's loader", "libmgdt.so.1"
    found = ctypes.util.find_library("mgdt")
    if found:
        yield "ctypes.util.find_library", found


def _declare(library: ctypes.CDLL) -> None:
    # The version first: a library of another one may lack or have changed anything else.
    for name, (result, parameters) in _SIGNATURES.items():
        try:
            function = getattr(library, name)
        except AttributeError:
            raise _Unsuitable(f"it has no function {name}, so it is no mgdt 1.1 or later") from None
        function.restype = result
        function.argtypes = parameters
        if name == "mgdt_abi_version" and function() != ABI_VERSION:
            raise _Unsuitable(
                f"its binary interface has version {function()}, this package needs {ABI_VERSION}"
            )


def _load() -> tuple[ctypes.CDLL, str]:
    tried = []
    for description, path in _candidates():
        try:
            # CDLL gives up the interpreter lock during calls.
            library = ctypes.CDLL(path)
            _declare(library)
            return library, path
        except (OSError, _Unsuitable) as error:
            tried.append(f"  {path} ({description}): {error}")
    raise ImportError(
        "mgdt: cannot load the library libmgdt.so.1. Tried:\n"
        + "\n".join(tried)
        + f"\nInstall mgdt where the loader finds it, or set {ENVIRONMENT_VARIABLE} to the file."
    )


library, path = _load()


def text(value: bytes | None) -> str:
    """A string of the library's; an empty one for NULL."""
    return "" if value is None else value.decode("utf-8", "replace")
