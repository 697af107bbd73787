# SPDX-License-Identifier: MIT
"""Many readers or one writer: the library's thread rule, kept for the user."""

from __future__ import annotations

import threading
from contextlib import contextmanager
from typing import Callable, Iterator, Optional


class Gate:
    """Lets any number of threads read at once, or one thread write.

    The library asks for this of its caller, who in Python expects waiting and not a crash.
    """

    def __init__(self) -> None:
        self._changed = threading.Condition(threading.Lock())
        self._readers = 0
        self._writer: Optional[int] = None
        # Readers that come after a writer wait for it: readers without a pause would keep it out.
        self._waiting_writers = 0

    @contextmanager
    def reading(self) -> Iterator[None]:
        with self._changed:
            self._wait(lambda: self._writer is None and self._waiting_writers == 0)
            self._readers += 1
        try:
            yield
        finally:
            with self._changed:
                self._readers -= 1
                self._changed.notify_all()

    @contextmanager
    def writing(self) -> Iterator[None]:
        with self._changed:
            self._waiting_writers += 1
            try:
                self._wait(lambda: self._writer is None and self._readers == 0)
            finally:
                self._waiting_writers -= 1
                self._changed.notify_all()
            self._writer = threading.get_ident()
        try:
            yield
        finally:
            with self._changed:
                self._writer = None
                self._changed.notify_all()

    def _wait(self, is_free: Callable[[], bool]) -> None:
        if self._writer == threading.get_ident():
            raise RuntimeError(
                "the triangulation is being changed: a progress function may not use it"
            )
        self._changed.wait_for(is_free)
