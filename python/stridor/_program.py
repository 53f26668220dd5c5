"""The programs beside the package, where they are."""

from __future__ import annotations

import ctypes
import os
import pathlib
import shutil
import signal
import sys
from typing import Callable, Iterator

from . import _stridor
from .errors import FileError

_set_pdeathsig = 1  # PR_SET_PDEATHSIG of prctl(2)


def found(name: str) -> str:
    """The path of a program: beside what STRIDOR_PROGRAM names, in the build tree, the environment or the PATH."""
    for folder in _folders():
        path = folder / name
        if path.is_file() and os.access(path, os.X_OK):
            return str(path)
    path_in_system = shutil.which(name)
    if path_in_system is None:
        raise FileError(f"the program {name} is not found. Put its folder into PATH, or its path into STRIDOR_PROGRAM.")
    return path_in_system


def _folders() -> Iterator[pathlib.Path]:
    named = os.environ.get("STRIDOR_PROGRAM")
    if named:
        yield pathlib.Path(named).absolute().parent
    yield pathlib.Path(_stridor.__file__ or "").absolute().parents[2]
    yield pathlib.Path(sys.prefix) / "bin"


def ends_with_its_parent() -> Callable[[], None]:
    """What a child does before it becomes a program: it asks to be ended with the thread that started it."""
    prctl = ctypes.CDLL(None, use_errno=True).prctl
    parent = os.getpid()

    def ask() -> None:
        prctl(_set_pdeathsig, int(signal.SIGTERM), 0, 0, 0)
        if os.getppid() != parent:
            os._exit(1)

    return ask
