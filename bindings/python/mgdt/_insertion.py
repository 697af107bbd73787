# SPDX-License-Identifier: MIT
"""One insertion that may take long: progress, cancelling, and Ctrl-C.

Python runs signal handlers in the main thread, between bytecodes. During a call of the library
there are none. A callback of ctypes is no place for them either: where a handler raises as the
callback is entered, the exception is printed and lost. So the main thread hands a long call to a
thread of its own and waits for it on a queue, which signals do interrupt. Whatever is raised there
stops the call, and goes on to the user when the library has returned.
"""

from __future__ import annotations

import queue
import threading
from typing import Callable, Optional

from . import _errors

ProgressFunction = Callable[[float], object]
"""Hears of progress, from 0 to 1. A true result cancels."""

SHORT = 50_000
"""Insertions of fewer points are over before anyone waits."""


class Insertion:
    """One call of ``mgdt_insert_points``.

    Parameters
    ----------
    progress : callable, optional
        Called on the thread that runs the insertion.
    cancel : callable
        ``mgdt_cancel`` for the handle.
    """

    def __init__(self, progress: Optional[ProgressFunction], cancel: Callable[[], object]) -> None:
        self._progress = progress
        self._cancel = cancel
        self._lock = threading.Lock()
        # The library keeps a request to cancel that comes when no call runs, and would stop the
        # next one. Between a call's first report and its last the request concerns that call.
        self._is_inside = False
        self._is_stopped = False
        self._ask: Callable[[float], object] = self._ask_here
        # Of the thread that makes the call.
        self._has_begun = False
        self._has_ended = False
        self._status = _errors.CANCELLED
        self._raised: Optional[BaseException] = None

    def report(self, fraction: float, _user: object = None) -> int:
        """What the library calls. Nothing may be raised from here."""
        with self._lock:
            self._is_inside = fraction < 1
            if self._is_stopped:
                return 1
        return int(self._progress is not None and bool(self._ask(fraction)))

    def stop(self) -> None:
        """Makes the call return soon. From any thread, at any time."""
        with self._lock:
            self._is_stopped = True
            if self._is_inside:
                self._cancel()

    def run(self, call: Callable[[], int], n: int) -> int:
        """Runs the call, of n points, and gives its status, or raises what stopped it."""
        is_main = threading.current_thread() is threading.main_thread()
        if is_main and (n >= SHORT or self._progress is not None):
            self._run_aside(call)
        else:
            self._status = call()
        if self._raised is not None:
            raise self._raised
        return self._status

    def _ask_here(self, fraction: float) -> object:
        try:
            assert self._progress is not None
            return bool(self._progress(fraction))
        except BaseException as error:
            self._raised = error
            return True

    def _run_aside(self, call: Callable[[], int]) -> None:
        # Fractions to report, and None when the call has returned.
        events: queue.SimpleQueue[Optional[float]] = queue.SimpleQueue()
        answers: queue.SimpleQueue[bool] = queue.SimpleQueue()

        def ask(fraction: float) -> bool:
            events.put(fraction)
            return answers.get()

        def work() -> None:
            with self._lock:
                if self._is_stopped:
                    return
                self._has_begun = True
            try:
                self._status = call()
            except BaseException as error:
                self._raised = error
            finally:
                self._has_ended = True
                events.put(None)

        self._ask = ask
        try:
            threading.Thread(target=work, name="mgdt insertion").start()
            while (fraction := events.get()) is not None:
                assert self._progress is not None
                answers.put(bool(self._progress(fraction)))
        except BaseException:
            self.stop()
            answers.put(True)
            # The library must have returned before anyone touches the handle again. Another
            # Ctrl-C changes nothing: the first is on its way. The last event may be lost to a
            # signal, so the flag decides.
            while self._has_begun and not self._has_ended:
                try:
                    events.get()
                except BaseException:
                    pass
            raise
