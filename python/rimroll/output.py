"""Files that appear under their final name only when they are whole."""

from __future__ import annotations

import os
import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

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
    if not os.access(folder, os.W_OK | os.X_OK):
        raise RimrollError(f"cannot write to the folder {folder}: permission denied")
    return folder


@contextmanager
def writing(path: str | os.PathLike[str]) -> Iterator[Path]:
    """Yield a temporary path beside ``path``, with its suffix, and move it into place on success.

    The folder is made if needed. If the block raises, even ``KeyboardInterrupt``, what it wrote is
    removed and an older file at ``path`` stays as it was. Raises ``RimrollError`` when the folder
    cannot be written to or ``path`` is a folder.
    """
    final = Path(path)
    folder = ensure_folder(final.parent)
    if final.is_dir():
        raise RimrollError(f"cannot write {final}: it is a folder")
    part = folder / f".{final.stem}.{secrets.token_hex(4)}{final.suffix}"
    try:
        yield part
        os.replace(part, final)
    finally:
        part.unlink(missing_ok=True)
