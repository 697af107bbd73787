# SPDX-License-Identifier: MIT
"""How the parts of processes exchange bytes by a communicator of mpi4py."""

from __future__ import annotations

import ctypes
import sys
from ctypes import CFUNCTYPE, POINTER, c_double, c_int32, c_int64, c_uint64, c_void_p
from typing import Any, Callable, Optional

import numpy as np
from numpy.typing import NDArray

LARGEST_MESSAGE = 1 << 30
"""Bytes. The counts of MPI are int: what is longer goes in pieces."""

_GATHER = CFUNCTYPE(c_int32, c_void_p, c_void_p, POINTER(c_int64), c_void_p)
_NUMBERS = CFUNCTYPE(c_int32, c_void_p, c_void_p, c_void_p)
_EXCHANGE = CFUNCTYPE(c_int32, c_void_p, POINTER(c_int64), c_void_p, POINTER(c_int64), c_void_p)
_REDUCE = CFUNCTYPE(c_int32, c_void_p, c_int64, c_void_p)

TYPES = [c_int32, c_int32, _GATHER, _NUMBERS, _EXCHANGE, _REDUCE, _REDUCE, c_void_p]
"""Of the arguments of ``mgdt_parts_create_with_transport`` but the last."""


def _array(address: Optional[int], count: int, of: Any) -> NDArray[Any]:
    """The numbers at an address, where they are."""
    if count == 0:
        return np.empty(0, of)
    assert address is not None
    return np.ctypeslib.as_array((of * count).from_address(address))


class Transport:
    """The functions for a communicator. It has to live as long as the handle that has them."""

    def __init__(self, communicator: Any) -> None:
        from mpi4py import MPI  # pylint: disable=import-outside-toplevel

        self._mpi = MPI
        self._communicator = communicator
        self._ranks = communicator.Get_size()
        self._rank = communicator.Get_rank()
        self.failure: Optional[BaseException] = None
        """What was raised in a call of the library's, which had to end first."""
        self.arguments: list[Any] = [
            self._ranks,
            self._rank,
            _GATHER(self._guarded(self._gather)),
            _NUMBERS(self._guarded(self._exchange_numbers)),
            _EXCHANGE(self._guarded(self._exchange)),
            _REDUCE(self._guarded(lambda at, n, _: self._reduce(at, n, c_uint64, MPI.SUM))),
            _REDUCE(self._guarded(lambda at, n, _: self._reduce(at, n, c_double, MPI.MIN))),
            None,
        ]

    def _guarded(self, body: Callable[..., None]) -> Callable[..., int]:
        def call(*arguments: Any) -> int:
            try:
                body(*arguments)
                return 0
            except BaseException:  # pylint: disable=broad-exception-caught
                self.failure = sys.exc_info()[1]
                return 1

        return call

    def _gather(self, mine: Optional[int], all_: Optional[int], begin: Any, _: Any) -> None:
        offsets = begin[: self._ranks + 1]
        whole = _array(all_, offsets[-1], ctypes.c_uint8)
        own = slice(offsets[self._rank], offsets[self._rank + 1])
        part = _array(mine, own.stop - own.start, ctypes.c_uint8)
        if offsets[-1] <= LARGEST_MESSAGE:
            counts = [b - a for a, b in zip(offsets, offsets[1:])]
            self._communicator.Allgatherv(
                [part, self._mpi.BYTE], [whole, (counts, offsets[:-1]), self._mpi.BYTE]
            )
            return
        whole[own] = part
        for rank in range(self._ranks):
            for piece in self._pieces(whole[offsets[rank] : offsets[rank + 1]]):
                self._communicator.Bcast([piece, self._mpi.BYTE], rank)

    def _exchange_numbers(self, out: int, into: int, _: Any) -> None:
        number = self._mpi.UINT64_T
        self._communicator.Alltoall(
            [_array(out, self._ranks, c_uint64), 1, number],
            [_array(into, self._ranks, c_uint64), 1, number],
        )

    def _exchange(self, out: Any, out_begin: Any, into: Any, in_begin: Any, _: Any) -> None:
        sent = _array(out, out_begin[self._ranks], ctypes.c_uint8)
        received = _array(into, in_begin[self._ranks], ctypes.c_uint8)
        requests = []
        for rank in range(self._ranks):
            for piece in self._pieces(received[in_begin[rank] : in_begin[rank + 1]]):
                requests.append(self._communicator.Irecv([piece, self._mpi.BYTE], rank))
        for rank in range(self._ranks):
            for piece in self._pieces(sent[out_begin[rank] : out_begin[rank + 1]]):
                requests.append(self._communicator.Isend([piece, self._mpi.BYTE], rank))
        self._mpi.Request.Waitall(requests)

    def _reduce(self, address: int, count: int, of: Any, operation: Any) -> None:
        number = self._mpi.DOUBLE if of is c_double else self._mpi.UINT64_T
        for piece in self._pieces(_array(address, count, of)):
            self._communicator.Allreduce(self._mpi.IN_PLACE, [piece, number], operation)

    @staticmethod
    def _pieces(values: NDArray[Any]) -> list[NDArray[Any]]:
        step = LARGEST_MESSAGE // values.itemsize
        return [values[i : i + step] for i in range(0, len(values), step)]
