# SPDX-License-Identifier: MIT
"""Statuses of the library as exceptions."""

from __future__ import annotations

OK = 0
INVALID_ARGUMENT = 11
NOT_FINITE = 12
UNKNOWN_SCHEME = 13
UNKNOWN_KEY = 14
INDEX_RANGE = 21
OUT_OF_MEMORY = 30
TOO_LARGE = 31
CANCELLED = 40
BUSY = 41
CHECK_FAILED = 60


class Error(Exception):
    """What the library refused or could not do. The base class of this package's exceptions.

    Attributes
    ----------
    status : int
        The ``MGDT_ERR_`` value.

    Notes
    -----
    Since 1.0.
    """

    status: int = 0


class ArgumentError(Error, ValueError):
    """An argument out of its range, also a coordinate that is not finite. Nothing has changed."""


class OutOfMemoryError(Error, MemoryError):
    """The system or ``memory_limit`` refused memory. The triangulation is that of the points that
    got in."""


class TooLargeError(Error, OverflowError):
    """More points or tetrahedra than can be numbered."""


class Cancelled(Error):
    """An insertion was stopped by `Delaunay.cancel` or the progress function. The triangulation is
    that of the points that got in."""


class BusyError(Error, RuntimeError):
    """A progress function used its own triangulation, which is being changed. Nothing has changed.

    Since 1.2.
    """


class CheckFailed(Error):
    """`Delaunay.check` found a defect. The message says what and where."""


_CLASSES = {
    INVALID_ARGUMENT: ArgumentError,
    NOT_FINITE: ArgumentError,
    UNKNOWN_SCHEME: ArgumentError,
    UNKNOWN_KEY: ArgumentError,
    INDEX_RANGE: TooLargeError,
    OUT_OF_MEMORY: OutOfMemoryError,
    TOO_LARGE: TooLargeError,
    CANCELLED: Cancelled,
    BUSY: BusyError,
    CHECK_FAILED: CheckFailed,
}


def make(status: int, message: str) -> Error:
    """The exception for a status other than success."""
    error = _CLASSES.get(status, Error)(message)
    error.status = status
    return error
