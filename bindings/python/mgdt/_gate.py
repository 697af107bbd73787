# SPDX-License-Identifier: MIT
"""Many readers or one writer: the library's thread rule, kept for the user. And long reading.

Python runs signal handlers in the main thread, between bytecodes, so none run during a call of the
library. The library can stop all calls that read a handle, but not one of them. So the main thread
leaves a long one to a thread of its own, and waits on a queue, which signals do interrupt. What a
handler raises goes on to the user at once. The call goes on to its end, as a reader like any other:
who changes the triangulation waits for it. Its result is dropped.
"""

from __future__ import annotations

import _thread
import os
import queue
import threading
import time
import weakref
from contextlib import contextmanager
from functools import partial
from typing import Any, Callable, Iterator, Optional, TypeVar

from . import _errors

_T = TypeVar("_T")

# Seconds between two looks whether a thread that waits gives up.
_PATIENCE = 0.05

# Seconds in which a destructor returns that has nothing left to do.
_MOMENT = 0.005


def _never() -> bool:
    return False


# All gates, for the child of a fork.
_gates: weakref.WeakSet[Gate] = weakref.WeakSet()


def interrupt_soon() -> None:
    """Interrupts the main thread once it has left the code in which this is called."""

    def interrupt() -> None:
        time.sleep(_MOMENT)
        _thread.interrupt_main()

    _thread.start_new_thread(interrupt, ())


def free(destroy: Callable[[Any], Any], pointer: Any) -> None:
    """Frees what a handle holds, for its destructor: Python prints and drops what is raised there."""
    try:
        destroy(pointer)
    except KeyboardInterrupt:
        # Ctrl-C while the memory was freed.
        interrupt_soon()


class Gate:
    """Lets any number of threads read at once, or one write.

    The library asks for this of its caller, who in Python expects waiting and not a crash. No
    thread goes in twice.
    """

    def __init__(self) -> None:
        self._changed = threading.Condition(threading.Lock())
        _gates.add(self)
        # By thread: one whose way out was cut short by a signal takes its old place again. Each
        # says whether nobody waits for its result any more.
        self._readers: dict[int, Callable[[], bool]] = {}
        self._has_writer = False
        # Readers that come after a writer wait for it: readers without a pause would keep it out.
        self._waiting_writers = 0
        self._kept_out: set[int] = set()

    @contextmanager
    def reading(self, is_left: Callable[[], bool] = _never) -> Iterator[None]:
        """Reads, until `is_left` comes true for a result that somebody waits for."""
        me = threading.get_ident()
        with self._changed:
            if not self._wait(
                lambda: not self._has_writer and self._waiting_writers == 0, is_left
            ):
                raise RuntimeError("nobody waits for this call any more")
            self._readers[me] = is_left
        try:
            yield
        finally:
            with self._changed:
                self._readers.pop(me, None)
                self._changed.notify_all()

    @contextmanager
    def writing(
        self,
        on_behalf_of: Optional[int] = None,
        gives_up: Callable[[], bool] = _never,
        beside_left: bool = False,
    ) -> Iterator[bool]:
        """Writes for a thread, by default this one, which does not read meanwhile.

        Gives whether it got in, which it does unless `gives_up` comes true. With `beside_left` it
        does not wait for readers whose results nobody waits for. That is for taking the
        triangulation from its owner: those readers hold it until they end.
        """
        reader = threading.get_ident() if on_behalf_of is None else on_behalf_of
        with self._changed:
            self._waiting_writers += 1
            try:
                got_in = self._wait(
                    lambda: not self._has_writer
                    and all(
                        thread == reader or (beside_left and is_left())
                        for thread, is_left in self._readers.items()
                    ),
                    gives_up,
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

    def forget_other_threads(self) -> None:
        """In the child of a fork, which has none of them. Where one was in a call at the fork, the
        library refuses the calls that cannot go beside it.
        """
        me = threading.get_ident()
        self._changed = threading.Condition(threading.Lock())
        self._readers = {thread: left for thread, left in self._readers.items() if thread == me}
        # A new thread may get the identity of one that is gone.
        self._kept_out &= {me}
        self._has_writer = False
        self._waiting_writers = 0

    @contextmanager
    def keeping_out(self) -> Iterator[None]:
        """Refuses this thread, which the writer waits for: it would wait for itself."""
        me = threading.get_ident()
        self._kept_out.add(me)
        try:
            yield
        finally:
            self._kept_out.discard(me)

    def guarded(self, progress: Optional[Callable[[float], object]]) -> Optional[Callable[[float], object]]:
        """A progress function that is refused what its writer waits for."""
        if progress is None:
            return None

        def guarded(inner: Callable[[float], object], gate: Gate, fraction: float) -> object:
            with gate.keeping_out():
                return inner(fraction)

        return partial(guarded, progress, self)

    def refuse_if_kept_out(self) -> None:
        if threading.get_ident() in self._kept_out:
            raise _errors.make(
                _errors.BUSY, "the object is being changed: a progress function may not use it"
            )

    def _wait(self, is_free: Callable[[], bool], gives_up: Callable[[], bool] = _never) -> bool:
        self.refuse_if_kept_out()
        while not self._changed.wait_for(is_free, timeout=_PATIENCE):
            if gives_up():
                return False
        return True


def _forget_other_threads() -> None:
    for gate in list(_gates):
        gate.forget_other_threads()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget_other_threads)


class _Outcome:
    """What a call on a thread of its own gave or raised."""

    def __init__(self) -> None:
        # Whoever waited was cut short. No signal comes between the exception and this.
        self.is_left = False
        self.value: Any = None
        self.error: Optional[BaseException] = None


def interruptibly(work: Callable[[Callable[[], bool]], _T], is_long: bool) -> _T:
    """Does the work, such that on the main thread signals interrupt it if it is long.

    The work is given a function that says whether it has been left. It may then end early.
    """
    if not is_long or threading.current_thread() is not threading.main_thread():
        return work(_never)
    outcome = _Outcome()
    ended: queue.SimpleQueue[None] = queue.SimpleQueue()

    def work_aside() -> None:
        try:
            outcome.value = work(lambda: outcome.is_left)
        except BaseException as error:
            outcome.error = error
        ended.put(None)

    try:
        try:
            # threading.Thread waits for its thread to begin, in Python, and is waited for when the
            # program ends.
            _thread.start_new_thread(work_aside, ())
        except RuntimeError:
            # There are no more threads: the system has no more, or the program ends.
            return work(_never)
        ended.get()
        if outcome.error is not None:
            raise outcome.error
        value: _T = outcome.value
        return value
    except BaseException:
        outcome.is_left = True
        raise
    finally:
        # Its traceback holds this object, and the triangulation.
        outcome.error = None
