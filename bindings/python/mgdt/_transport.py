# SPDX-License-Identifier: MIT
"""How the parts of processes exchange bytes by a communicator of mpi4py."""

from __future__ import annotations

import ctypes
import sys
from ctypes import c_double, c_int64, c_uint64
from typing import Any, Callable, Optional

import numpy as np
from numpy.typing import NDArray

from ._parts_interface import EXCHANGE, EXCHANGE_NUMBERS, GATHER, LEAST, SUM, Transport

LARGEST_MESSAGE = 1 << 30
"""Bytes. The counts of MPI are int: what is longer goes in pieces."""

def _array(address: Optional[int], count: int, of: Any) -> NDArray[Any]:
    """The numbers at an address, where they are."""
    if count == 0:
        return np.empty(0, of)
    assert address is not None
    return np.ctypeslib.as_array((of * count).from_address(address))


class MpiTransport:
    """The functions for a communicator. It has to live as long as the handle that has them."""

    def __init__(self, communicator: Any) -> None:
        from mpi4py import MPI  # pylint: disable=import-outside-toplevel

        self._mpi = MPI
        self._communicator = communicator
        self._ranks = communicator.Get_size()
        self._rank = communicator.Get_rank()
        self.failure: Optional[BaseException] = None
        """What was raised in a call of the library's, which had to end first."""
        self.functions = Transport(
            size=ctypes.sizeof(Transport),
            processes=self._ranks,
            process=self._rank,
            gather=GATHER(self._guarded(self._gather)),
            exchange_numbers=EXCHANGE_NUMBERS(self._guarded(self._exchange_numbers)),
            exchange=EXCHANGE(self._guarded(self._exchange)),
            sum=SUM(self._guarded(lambda at, n, _: self._reduce(at, n, c_uint64, MPI.SUM))),
            least=LEAST(self._guarded(lambda at, n, _: self._reduce(at, n, c_double, MPI.MIN))),
        )

    def _guarded(self, body: Callable[..., None]) -> Callable[..., int]:
        def call(*arguments: Any) -> int:
            try:
                body(*arguments)
                return 0
            except BaseException:  # pylint: disable=broad-exception-caught
                self.failure = sys.exc_info()[1]
                return 1

        return call

    def _gather(self, mine: Optional[int], all_: Optional[int], begin: int, _: Any) -> None:
        offsets = self._offsets(begin)
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

    def _exchange(
        self, out: Optional[int], out_begin: int, into: Optional[int], in_begin: int, _: Any
    ) -> None:
        of_sent, of_received = self._offsets(out_begin), self._offsets(in_begin)
        sent = _array(out, of_sent[-1], ctypes.c_uint8)
        received = _array(into, of_received[-1], ctypes.c_uint8)
        requests = []
        for rank in range(self._ranks):
            for piece in self._pieces(received[of_received[rank] : of_received[rank + 1]]):
                requests.append(self._communicator.Irecv([piece, self._mpi.BYTE], rank))
        for rank in range(self._ranks):
            for piece in self._pieces(sent[of_sent[rank] : of_sent[rank + 1]]):
                requests.append(self._communicator.Isend([piece, self._mpi.BYTE], rank))
        self._mpi.Request.Waitall(requests)

    def _reduce(self, address: int, count: int, of: Any, operation: Any) -> None:
        number = self._mpi.DOUBLE if of is c_double else self._mpi.UINT64_T
        for piece in self._pieces(_array(address, count, of)):
            self._communicator.Allreduce(self._mpi.IN_PLACE, [piece, number], operation)

    def _offsets(self, address: int) -> list[int]:
        """In bytes: one for each rank, and the end."""
        values: list[int] = _array(address, self._ranks + 1, c_int64).tolist()
        return values

    @staticmethod
    def _pieces(values: NDArray[Any]) -> list[NDArray[Any]]:
        step = LARGEST_MESSAGE // values.itemsize
        return [values[i : i + step] for i in range(0, len(values), step)]
