# SPDX-License-Identifier: MIT
"""Handles of the library whose options, statistics and arrays have keys: domains, meshes, boxes and
diagrams."""

from __future__ import annotations

import ctypes
from ctypes import c_int32, c_int64, c_void_p
from typing import Any, Callable

import numpy as np
from numpy.typing import NDArray

from . import _errors, _library
from ._arrays import address
from ._gate import free
from ._interface import CONSTANTS

_MESSAGE_BYTES = 512


class Keyed:
    """A handle of a kind: its functions are ``mgdt_KIND_...``, and tables have its keys."""

    kind: str

    def __init__(self, pointer: c_void_p) -> None:
        self._pointer = pointer

    @property
    def pointer(self) -> c_void_p:
        """The handle, for functions of other handles."""
        return self._pointer

    @classmethod
    def _create(cls) -> c_void_p:
        """A new handle."""
        pointer = c_void_p()
        status = cls._function("create")(ctypes.byref(pointer))
        if status != _errors.OK:
            raise _errors.make(status, f"the library made no {cls.kind}: out of memory")
        return pointer

    @classmethod
    def _function(cls, name: str) -> Callable[..., Any]:
        function: Callable[..., Any] = getattr(_library.library, f"mgdt_{cls.kind}_{name}")
        return function

    def __del__(self) -> None:
        if getattr(self, "_pointer", None):
            free(self._function("destroy"), self._pointer)

    def quiet(self, name: str, *arguments: Any) -> int:
        """Calls a function and returns its status."""
        return int(self._function(name)(self._pointer, *arguments))

    def call(self, name: str, *arguments: Any) -> None:
        """Calls a function and raises what its status means."""
        status = self.quiet(name, *arguments)
        if status == _errors.OK:
            return
        buffer = ctypes.create_string_buffer(_MESSAGE_BYTES)
        self.quiet("get_error", _MESSAGE_BYTES, buffer)
        raise self.error(status, _library.text(buffer.value))

    def error(self, status: int, message: str) -> BaseException:
        """The exception for a status."""
        return _errors.make(status, message)

    def set_option(self, name: str, value: int) -> None:
        self.call("set_option", CONSTANTS[f"{self.kind}_option"][name], value)

    def set_double_option(self, name: str, value: float) -> None:
        self.call("set_double_option", CONSTANTS[f"{self.kind}_option"][name], value)

    def statistic(self, name: str) -> int:
        value = c_int64()
        self.call("get_stat", CONSTANTS[f"{self.kind}_stat"][name], ctypes.byref(value))
        return value.value

    def array(self, name: str, integer: Any = np.int32) -> NDArray[Any]:
        """An array, with as many columns as elements belong together if these are several."""
        key = CONSTANTS[f"{self.kind}_array"][name]
        columns, is_double, size = c_int32(), c_int32(), c_int64()
        self._function("array_info")(key, ctypes.byref(columns), ctypes.byref(is_double))
        self.call("get_size", key, ctypes.byref(size))
        values: NDArray[Any] = np.empty(size.value, np.float64 if is_double.value else integer)
        function = (
            "get_doubles" if is_double.value else "get_array_i32" if integer is np.int32 else "get_array"
        )
        self.call(function, key, values.size, address(values))
        return values.reshape(-1, columns.value) if columns.value > 1 else values
