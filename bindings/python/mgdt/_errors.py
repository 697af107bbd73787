# SPDX-License-Identifier: MIT
"""Statuses of the library as exceptions."""

from __future__ import annotations

from ._interface import CONSTANTS

_STATUS = CONSTANTS["status"]
OK = _STATUS["ok"]
INVALID_ARGUMENT = _STATUS["invalid_argument"]
NOT_FINITE = _STATUS["not_finite"]
UNKNOWN_SCHEME = _STATUS["unknown_scheme"]
UNKNOWN_KEY = _STATUS["unknown_key"]
NOT_BUILT = _STATUS["not_built"]
BUFFER_TOO_SMALL = _STATUS["buffer_too_small"]
INDEX_RANGE = _STATUS["index_range"]
OUT_OF_MEMORY = _STATUS["out_of_memory"]
TOO_LARGE = _STATUS["too_large"]
CANCELLED = _STATUS["cancelled"]
BUSY = _STATUS["busy"]
CHECK_FAILED = _STATUS["check_failed"]
INVALID_BOUNDARY = _STATUS["invalid_boundary"]
OPEN_BOUNDARY = _STATUS["open_boundary"]


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


class NotBuiltError(Error, RuntimeError):
    """There is no result: a call that should have made it was stopped or failed.

    Since 1.3.
    """


class CheckFailed(Error):
    """`Delaunay.check` found a defect. The message says what and where."""


_CLASSES = {
    INVALID_ARGUMENT: ArgumentError,
    NOT_FINITE: ArgumentError,
    UNKNOWN_SCHEME: ArgumentError,
    UNKNOWN_KEY: ArgumentError,
    NOT_BUILT: NotBuiltError,
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
