# SPDX-License-Identifier: MIT
"""One insertion, removal or move that may take long: progress, cancelling, and Ctrl-C.

Python runs signal handlers in the main thread, between bytecodes. During a call of the library
there are none. A callback of ctypes is no place for them either: where a handler raises as the
callback is entered, the exception is printed and lost. So the main thread leaves a long insertion,
with all that belongs to it, to a thread of its own, which no signal disturbs, and waits for it on a
queue, which signals do interrupt. What is raised there stops the insertion, and goes on to the user
when that has ended.
"""

from __future__ import annotations

import _thread
import enum
import queue
import threading
import warnings
from typing import Callable, Optional

import numpy as np


class _Cancel(enum.Enum):
    CANCEL = "cancel"

    def __repr__(self) -> str:
        return "mgdt.CANCEL"


CANCEL = _Cancel.CANCEL

ProgressFunction = Callable[[float], object]
"""Hears of progress, from 0 to 1. The result `CANCEL` cancels; any other means nothing."""

SHORT = 50_000
"""Insertions of fewer points are over before anyone waits."""


class Insertion:
    """One call of ``mgdt_insert_points`` or another that changes points, and the ways to stop it.

    Parameters
    ----------
    progress : callable, optional
        Called on the thread that calls `run`.
    """

    def __init__(self, progress: Optional[ProgressFunction]) -> None:
        self._progress = progress
        self._has_said_no = False
        self._ask: Optional[Callable[[float], bool]] = None
        self._lock = threading.Lock()
        # The library keeps a request to cancel that comes when no call runs, and would stop the
        # next one. Between a call's first report and its last the request concerns that call.
        self._is_inside = False
        self.is_stopped = False
        # Whoever waited was cut short. No signal comes between the exception and this, so it is
        # true even where another one cuts `stop` short.
        self.is_given_up = False
        self._cancel: Callable[[], object] = lambda: None
        self._has_begun = False
        self._has_ended = False
        self._raised: Optional[BaseException] = None

    @property
    def has_to_end(self) -> bool:
        return self.is_stopped or self.is_given_up

    def attach(self, cancel: Callable[[], object]) -> None:
        """Says how the call is cancelled, before it begins."""
        self._cancel = cancel

    def detach(self) -> None:
        """Says that the call has returned."""
        with self._lock:
            self._is_inside = False

    def report(self, fraction: float, _user: object = None) -> int:
        """What the library calls. Nothing may be raised from here."""
        with self._lock:
            self._is_inside = fraction < 1
            if self.has_to_end:
                return 1
        if self._progress is None:
            return 0
        if not (self._ask(fraction) if self._ask is not None else self._ask_here(fraction)):
            return 0
        with self._lock:
            self.is_stopped = True
        return 1

    def stop(self) -> None:
        """Makes the call return soon. From any thread, at any time."""
        with self._lock:
            # Once: a second request might come when the call has heeded the first.
            if self._is_inside and not self.is_stopped:
                self._cancel()
            self.is_stopped = True

    def run(self, work: Callable[[], None], n: int) -> None:
        """Does the work on n points, and raises what it raised or what stopped it.

        When this returns or raises, the work has ended or will never begin.
        """
        is_main = threading.current_thread() is threading.main_thread()
        try:
            if is_main and (n >= SHORT or self._progress is not None):
                self._run_aside(work)
            else:
                self._do(work)
            if self._raised is not None:
                raise self._raised
        finally:
            # Its traceback holds this object, and the triangulation.
            self._raised = None

    def _do(self, work: Callable[[], None]) -> None:
        with self._lock:
            if self.has_to_end:
                return
            self._has_begun = True
        try:
            work()
        except BaseException as error:
            # What the progress function raised comes first.
            self._raised = self._raised or error
        finally:
            self._has_ended = True

    def _means_cancel(self, result: object) -> bool:
        """Whether the progress function's result cancels.

        No result that a function may have for reasons of its own does: those of progress bars say
        whether they were drawn.
        """
        if isinstance(result, (bool, np.bool_)):
            if result and self._has_said_no:
                warnings.warn(
                    "the progress function returned True after False; that does not cancel "
                    "since mgdt 1.2: return mgdt.CANCEL",
                    RuntimeWarning,
                    stacklevel=2,
                )
            # One warning is enough.
            self._has_said_no = not result
        return result is CANCEL

    def _ask_here(self, fraction: float) -> bool:
        try:
            assert self._progress is not None
            return self._means_cancel(self._progress(fraction))
        except BaseException as error:
            self._raised = error
            return True

    def _run_aside(self, work: Callable[[], None]) -> None:
        # Fractions to report, and None when the work is done.
        events: queue.SimpleQueue[Optional[float]] = queue.SimpleQueue()
        answers: queue.SimpleQueue[bool] = queue.SimpleQueue()

        def ask(fraction: float) -> bool:
            events.put(fraction)
            return answers.get()

        def work_aside() -> None:
            self._do(work)
            events.put(None)

        self._ask = ask
        try:
            # threading.Thread waits for its thread to begin, in Python; a signal's exception there
            # leaves its locks in disorder.
            _thread.start_new_thread(work_aside, ())
            while (fraction := events.get()) is not None:
                assert self._progress is not None
                answers.put(self._means_cancel(self._progress(fraction)))
        except BaseException:
            self.is_given_up = True
            self.stop()
            answers.put(True)
            # Another Ctrl-C changes nothing: the first is on its way. The last event may be lost
            # to a signal, so the flag decides.
            while self._has_begun and not self._has_ended:
                try:
                    events.get()
                except BaseException:
                    pass
            raise
