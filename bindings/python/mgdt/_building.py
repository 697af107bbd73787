# SPDX-License-Identifier: MIT
"""Builds of domains and boxes: one writer at a time, with progress, and stopped by Ctrl-C."""

from __future__ import annotations

import threading
from typing import Any, Callable, Optional, Protocol

from . import _errors, _library
from ._gate import Gate
from ._insertion import Insertion
from ._interface import PROGRESS


class Buildable(Protocol):
    """A handle whose functions are called by their short names."""

    def quiet(self, name: str, *arguments: Any) -> int:
        """Calls a function and returns its status."""

    def call(self, name: str, *arguments: Any) -> None:
        """Calls a function and raises what its status means."""


def build(
    handle: Buildable,
    gate: Gate,
    progress: Optional[Callable[[float], Any]],
    size: int,
    change: Callable[[], None] = lambda: None,
    function: str = "build",
) -> None:
    """Makes a change and builds what has some number of points, or calls another function of the
    handle, and reports progress.

    Waits for those who read. What stops the build is raised when it has ended: what the progress
    function raised, or a signal's handler.
    """
    insertion = Insertion(gate.guarded(progress))
    caller = threading.get_ident()

    def work() -> None:
        with gate.writing(caller, lambda: insertion.has_to_end) as got_in:
            if not got_in:
                raise _errors.make(_errors.CANCELLED, "cancelled before the build")
            change()
            insertion.attach(lambda: handle.quiet("cancel"))
            report = PROGRESS(insertion.report)
            handle.call("set_progress", report, None)
            try:
                handle.call(function)
            finally:
                insertion.detach()
                handle.quiet("set_progress", _library.NO_PROGRESS, None)

    gate.refuse_if_kept_out()
    insertion.run(work, size)
