"""A line that says what takes long: after a second, and then each second, on a terminal or in a notebook; elsewhere nothing."""

import contextlib
import sys
import threading
import time

#: Seconds before the line appears, and between its changes.
PERIOD = 1.0

_nothing = contextlib.nullcontext()
# There is one line at a time: what begins within something else, or in another thread beside it, is not shown.
_shown = threading.Lock()


def working(what):
    """A context whose line is `what`, text or a function that returns it, and the seconds since its beginning."""
    stream = _stream() if threading.current_thread() is threading.main_thread() else None
    return _nothing if stream is None else _Line(what, stream)


def _stream():
    """Where a line is seen; `None` where it would be kept, in a file or a pipe."""
    stream = sys.stderr
    try:
        if stream.isatty():
            return stream
    except (AttributeError, ValueError):
        # There is none, or it is closed.
        return None
    # A kernel of Jupyter has the stream of a cell in its place.
    return stream if type(stream).__module__.startswith("ipykernel.") else None


class _Line:
    """The line and its thread."""

    def __init__(self, what, stream):
        self._what, self._stream = what, stream
        self._ended, self._thread = threading.Event(), None

    def __enter__(self):
        if _shown.acquire(blocking=False):
            self._thread = threading.Thread(target=self._show, daemon=True)
            self._thread.start()

    def __exit__(self, *_):
        if self._thread is not None:
            self._ended.set()
            self._thread.join()
            _shown.release()

    def _show(self):
        began, width = time.monotonic(), 0
        # A stream that fails is no reason to stop what is computed.
        with contextlib.suppress(OSError, ValueError):
            while not self._ended.wait(PERIOD):
                what = self._what() if callable(self._what) else self._what
                line = f"{what}, {time.monotonic() - began:.0f} s"
                self._stream.write(f"\r{line:{width}}")
                self._stream.flush()
                width = len(line)
            if width:
                self._stream.write(f"\r{'':{width}}\r")
                self._stream.flush()
