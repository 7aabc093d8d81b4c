"""Files that appear under their final name only when they are complete."""

from __future__ import annotations

import errno
import os
import secrets
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

from rimroll.errors import RimrollError


def ensure_folder(path: str | os.PathLike[str]) -> Path:
    """Make the folder ``path``, with its parents, unless it is there; return it.

    Raises ``RimrollError`` when it cannot be made, is no folder, or cannot be written to.
    """
    folder = Path(path)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except (FileExistsError, NotADirectoryError):
        raise RimrollError(f"cannot make the folder {folder}: a file is in the way") from None
    except OSError as error:
        raise RimrollError(f"cannot make the folder {folder}: {error.strerror}") from error
    _check_access(folder)
    return folder


def place_of(path: str | os.PathLike[str]) -> Path:
    """Where a file is written: ``path``, or what it points to if it is a symbolic link.

    Raises ``RimrollError`` when there is no such folder, when it cannot be written to, and when
    the path is something other than a regular file. No folder is created, because a missing one
    is often a misspelt name.
    """
    given = Path(path)
    final = Path(os.path.realpath(given))
    folder = final.parent
    if not folder.is_dir():
        named = folder if given.is_symlink() else given.parent
        what = f"{named} is no folder" if named.exists() else f"there is no folder {named}"
        raise RimrollError(f"cannot write {given}: {what}")
    if final.is_dir():
        raise RimrollError(f"cannot write {given}: it is a folder")
    if final.exists() and not final.is_file():
        raise RimrollError(f"cannot write {given}: it is no regular file")
    _check_access(folder)
    return final


def _check_access(folder: Path) -> None:
    if not os.access(folder, os.W_OK | os.X_OK):
        raise RimrollError(f"cannot write to the folder {folder}: permission denied")


@contextmanager
def writing(path: str | os.PathLike[str]) -> Iterator[Path]:
    """Yield a temporary path beside ``path``, with its suffix, and move it into place on success.

    A symbolic link stays one: its target is written. A file that is replaced passes on its
    permissions. If the block raises, even ``KeyboardInterrupt``, what it wrote is removed and an
    older file at ``path`` stays as it was. Raises ``RimrollError`` as :func:`place_of` does.
    """
    final = place_of(path)
    part = final.with_name(f".{final.stem}.{secrets.token_hex(4)}{Path(path).suffix}")
    try:
        yield part
        if final.exists():
            shutil.copymode(final, part)
        os.replace(part, final)
    finally:
        part.unlink(missing_ok=True)


@contextmanager
def durably(path: Path) -> Iterator[BinaryIO]:
    """Yield a binary file that takes the place of ``path`` when it is complete and on the disk.

    If the block raises, nothing is left of it. If the process is killed, ``*.partial`` is.
    """
    part = path.with_name(f"{path.name}.{secrets.token_hex(4)}.partial")
    try:
        with part.open("wb") as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        os.replace(part, path)
        flush(path.parent)
    except BaseException:
        part.unlink(missing_ok=True)
        raise


def flush(path: Path) -> None:
    """Wait until a file, or the list of the files in a folder, is on the disk.

    Without the second, a file may be lost with the power although its content was on the disk.
    """
    folder = path.is_dir()
    if folder and os.name == "nt":
        return  # Windows does not open folders
    descriptor = os.open(path, os.O_RDONLY if folder else os.O_RDWR)
    try:
        os.fsync(descriptor)
    except OSError as error:
        if not folder or error.errno not in UNKNOWN:
            raise
    finally:
        os.close(descriptor)


UNKNOWN = (errno.EINVAL, errno.ENOTSUP, errno.EBADF)
"""What file systems answer that cannot flush a folder."""


def flush_all(folder: Path) -> None:
    """Wait until all that is in a folder is on the disk."""
    for path, _, files in os.walk(folder, topdown=False):
        for file in files:
            flush(Path(path, file))
        flush(Path(path))
