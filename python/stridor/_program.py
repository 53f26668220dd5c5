"""The programs beside the package, where they are."""

from __future__ import annotations

import ctypes
import os
import pathlib
import shutil
import signal
import site
import sys
import sysconfig
from typing import Callable, Iterator

from . import _stridor
from .errors import FileError

_set_pdeathsig = 1  # PR_SET_PDEATHSIG of prctl(2)
# why one may be missing, and what to do
_ways = {
    "stridor": ("the package was installed without it", "In a checkout `pip install --no-index .` brings it"),
    "stridor-mpi": ("pip brings it where it finds MPI",
                    "Install MPI (Debian: libopenmpi-dev openmpi-bin), then the package once more"),
}


def found(name: str) -> str:
    """The path of a program: beside what STRIDOR_PROGRAM names, with the package, in the environment or the PATH."""
    for folder in _folders():
        path = folder / name
        if path.is_file() and os.access(path, os.X_OK):
            return str(path)
    path_in_system = shutil.which(name)
    if path_in_system is None:
        why, way = _ways[name]
        suggestion = f"{way}; or put its folder into PATH, or its path into STRIDOR_PROGRAM."
        raise FileError._saying([(f"the program {name} is not found", why, suggestion, None)])
    return path_in_system


def _folders() -> Iterator[pathlib.Path]:
    named = os.environ.get("STRIDOR_PROGRAM")
    if named:
        yield pathlib.Path(named).absolute().parent
    package = pathlib.Path(_stridor.__file__ or "").absolute().parent
    yield package.parents[1]  # the build folder
    yield package.parent / "bin"  # pip install --target
    yield package.parents[3] / "bin" if len(package.parents) > 3 else package.parent
    yield pathlib.Path(sysconfig.get_path("scripts"))
    yield pathlib.Path(sys.prefix) / "bin"
    yield pathlib.Path(site.getuserbase()) / "bin"


def ends_with_its_parent() -> Callable[[], None]:
    """What a child does before it becomes a program: it asks to be ended with the thread that started it."""
    prctl = ctypes.CDLL(None, use_errno=True).prctl
    parent = os.getpid()

    def ask() -> None:
        prctl(_set_pdeathsig, int(signal.SIGTERM), 0, 0, 0)
        if os.getppid() != parent:
            os._exit(1)

    return ask
