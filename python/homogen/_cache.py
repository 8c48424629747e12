"""Machine code on disk: a folder with a file for each entry, up to a size.

A file holds the object code of an entry behind its hash, so that one which is cut short or changed is not used. It is written
under another name and then takes its place, so that processes can share the folder. Where nothing can be written, nothing is
kept. Files beyond the size are removed, those that were used longest ago first.

`HOMOGEN_CACHE` names another folder; where it is empty nothing is kept. `HOMOGEN_CACHE_SIZE` is another size in MiB.
"""

import contextlib
import hashlib
import os
import tempfile
import time
from pathlib import Path

import platformdirs

#: Size of all files that is not exceeded for long, in bytes.
DEFAULT_SIZE = 1 << 30

_SUFFIX = ".o"
#: Suffix of files that are being written.
_FRESH = ".new"
#: Seconds after which a file that is being written has been left behind.
_LEFT = 3600
_HASH = hashlib.sha256


def _folder():
    """The folder of the cache; `None` where nothing is to be kept, or others could put code there."""
    named = os.environ.get("HOMOGEN_CACHE")
    if named == "":
        return None
    try:
        path = Path(named) if named else platformdirs.user_cache_path("homogen")
        path.mkdir(mode=0o700, parents=True, exist_ok=True)
        if hasattr(os, "getuid"):
            status = path.stat()
            if status.st_uid != os.getuid() or status.st_mode & 0o022:
                return None
    except (OSError, RuntimeError):
        return None
    return path


def _size():
    """The size that is asked for, in bytes; the default where that is no number."""
    try:
        return int(float(os.environ["HOMOGEN_CACHE_SIZE"]) * (1 << 20))
    except (KeyError, OverflowError, ValueError):
        return DEFAULT_SIZE


#: The folder of the cache; `None` where nothing is kept.
folder = _folder()
#: Maximum size of its files, in bytes.
size = _size()

# Bytes that this process has written since it last looked at all files; it looks first when it first writes.
_written = size


def read(key):
    """The object code of an entry; `None` where there is none, or it is not whole."""
    if folder is None:
        return None
    file = folder / (key + _SUFFIX)
    try:
        kept = file.read_bytes()
    except OSError:
        return None
    hashed = _HASH().digest_size
    image = kept[hashed:]
    if kept[:hashed] != _HASH(image).digest():
        return None
    # The time of its last use, which a file system need not record by itself.
    with contextlib.suppress(OSError):
        os.utime(file)
    return image


def write(key, image):
    """Keeps the object code of an entry, as far as that is possible."""
    global _written
    if folder is None:
        return
    fresh = None
    try:
        number, fresh = tempfile.mkstemp(dir=folder, suffix=_FRESH)
        with open(number, "wb") as stream:
            stream.write(_HASH(image).digest() + image)
        os.replace(fresh, folder / (key + _SUFFIX))
    except OSError:
        # A full disk or a folder that cannot be written: the next process compiles again.
        if fresh is not None:
            with contextlib.suppress(OSError):
                os.unlink(fresh)
        return
    _written += len(image)
    # Between two looks the files of a process grow by a small part.
    if _written >= size // 16:
        _written = 0
        prune()


def prune():
    """Removes files beyond the size, those that were used longest ago first, and files that were left behind half written.

    Other processes may do the same meanwhile. One that reads a removed file compiles again.
    """
    kept, total, now = [], 0, time.time()
    try:
        entries = list(os.scandir(folder))
    except OSError:
        return
    for entry in entries:
        with contextlib.suppress(OSError):
            if not entry.name.endswith((_SUFFIX, _FRESH)) or not entry.is_file(follow_symlinks=False):
                continue
            status = entry.stat(follow_symlinks=False)
            if entry.name.endswith(_SUFFIX):
                kept.append((status.st_mtime_ns, status.st_size, entry.path))
                total += status.st_size
            elif now - status.st_mtime > _LEFT:
                os.unlink(entry.path)
    for _, own, path in sorted(kept):
        if total <= size:
            break
        with contextlib.suppress(OSError):
            os.unlink(path)
        total -= own
