# SPDX-License-Identifier: MIT
"""Builds of domains and boxes that a function of the caller hears of."""

from __future__ import annotations

from typing import Any, Callable, Optional, Protocol

from . import _errors, _library
from ._insertion import CANCEL
from ._interface import PROGRESS


class Buildable(Protocol):
    """A handle whose functions are called by their short names."""

    def quiet(self, name: str, *arguments: Any) -> int:
        """Calls a function and returns its status."""

    def call(self, name: str, *arguments: Any) -> None:
        """Calls a function and raises what its status means."""


def build(handle: Buildable, progress: Optional[Callable[[float], Any]]) -> None:
    """Builds, and reports progress. What the function raises goes on to the caller."""
    failures: list[BaseException] = []

    def report(fraction: float, _: Any) -> int:
        # Python runs the handlers of signals here, so that Ctrl-C is heard without `progress`.
        try:
            return 1 if progress is not None and progress(fraction) is CANCEL else 0
        except BaseException as error:  # pylint: disable=broad-exception-caught
            failures.append(error)
            return 1

    callback = PROGRESS(report)
    handle.call("set_progress", callback, None)
    try:
        handle.call("build")
    except _errors.Cancelled:
        if failures:
            raise failures[0] from None
        raise
    finally:
        handle.quiet("set_progress", _library.NO_PROGRESS, None)
    if failures:
        raise failures[0]
