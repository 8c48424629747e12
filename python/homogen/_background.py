"""Functions that another thread compiles, while the program goes on.

A queue of functions and one thread, as LLVM works for one at a time. It ends with the queue, or after the function at hand
when the main thread ends, and passes over robots that have been dropped. What cannot be compiled is left to the call, which
says why.
"""

import contextlib
import os
import threading
import weakref
from collections import deque

from ._compile import hold, release

_queue = deque()
_is_running = False
_lock = threading.Lock()


def begin(robot, names, **options):
    """Compiles functions for calls with these options, in their order."""
    global _is_running
    own = weakref.ref(robot)
    with _lock:
        _queue.extend((own, name, options) for name in names)
        starting, _is_running = not _is_running, True
    if starting:
        # No daemon: one that is stopped amidst the engine would take the process with it.
        threading.Thread(target=_work, name="homogen", daemon=False).start()


def _work():
    global _is_running
    while True:
        with _lock:
            if not threading.main_thread().is_alive():
                _queue.clear()
            if not _queue:
                _is_running = False
                return
            of, name, options = _queue.popleft()
        robot = of()
        if robot is not None:
            with contextlib.suppress(Exception):
                getattr(robot, name).compile(**options)
        del robot


def _before_fork():
    # In this order: a thread that has the lock of the queue may wait for LLVM.
    _lock.acquire()
    hold()


def _after_fork():
    release()
    _lock.release()


def _in_child():
    """A child of a process has no such thread; it compiles functions when they are called."""
    global _is_running
    _queue.clear()
    _is_running = False
    _after_fork()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(before=_before_fork, after_in_parent=_after_fork, after_in_child=_in_child)
