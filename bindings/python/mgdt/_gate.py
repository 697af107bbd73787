# SPDX-License-Identifier: MIT
"""Many readers or one writer: the library's thread rule, kept for the user."""

from __future__ import annotations

import threading
from contextlib import contextmanager
from typing import Callable, Iterator, Optional

# Seconds between two looks whether a writer that waits gives up.
_PATIENCE = 0.05


class Gate:
    """Lets any number of threads read at once, or one write.

    The library asks for this of its caller, who in Python expects waiting and not a crash. No
    thread goes in twice.
    """

    def __init__(self) -> None:
        self._changed = threading.Condition(threading.Lock())
        # By thread: one whose way out was cut short by a signal takes its old place again.
        self._readers: set[int] = set()
        self._has_writer = False
        # Readers that come after a writer wait for it: readers without a pause would keep it out.
        self._waiting_writers = 0
        self._kept_out: set[int] = set()

    @contextmanager
    def reading(self) -> Iterator[None]:
        me = threading.get_ident()
        with self._changed:
            self._wait(lambda: not self._has_writer and self._waiting_writers == 0)
            self._readers.add(me)
        try:
            yield
        finally:
            with self._changed:
                self._readers.discard(me)
                self._changed.notify_all()

    @contextmanager
    def writing(
        self, on_behalf_of: Optional[int] = None, gives_up: Callable[[], bool] = lambda: False
    ) -> Iterator[bool]:
        """Writes for a thread, by default this one, which does not read meanwhile.

        Gives whether it got in, which it does unless `gives_up` comes true.
        """
        reader = threading.get_ident() if on_behalf_of is None else on_behalf_of
        with self._changed:
            self._waiting_writers += 1
            try:
                got_in = self._wait(
                    lambda: not self._has_writer and not self._readers - {reader}, gives_up
                )
            finally:
                self._waiting_writers -= 1
                self._changed.notify_all()
            self._has_writer |= got_in
        try:
            yield got_in
        finally:
            if got_in:
                with self._changed:
                    self._has_writer = False
                    self._changed.notify_all()

    @contextmanager
    def keeping_out(self) -> Iterator[None]:
        """Refuses this thread, which the writer waits for: it would wait for itself."""
        me = threading.get_ident()
        self._kept_out.add(me)
        try:
            yield
        finally:
            self._kept_out.discard(me)

    def refuse_if_kept_out(self) -> None:
        if threading.get_ident() in self._kept_out:
            raise RuntimeError(
                "the triangulation is being changed: a progress function may not use it"
            )

    def _wait(
        self, is_free: Callable[[], bool], gives_up: Callable[[], bool] = lambda: False
    ) -> bool:
        self.refuse_if_kept_out()
        while not self._changed.wait_for(is_free, timeout=_PATIENCE):
            if gives_up():
                return False
        return True
