"""xarray opens stores of charts: finished ones, those that were stopped before, and those that are being filled.

``xarray.open_dataset("pair/chart.sqlite", engine="stridor")``; where the package is not installed but lies in the
search path, `engine=stridor.xarray_backend.StoreBackend`.
"""

from __future__ import annotations

import errno
import os
import pathlib
import socket
import sqlite3
import stat
import time
from typing import Any, Dict, Iterable, List, NamedTuple, Optional, Tuple, Union

import numpy
import xarray
from xarray.backends import BackendEntrypoint

from . import _stridor
from ._charts import open_chart
from ._evaluate import _named
from ._given import files
from .errors import FileError, InputError, Interrupted

__all__ = ["StoreBackend"]

_mark = (b"SQLite format 3\x00", b"STRD")  # at 0 and at 68: SQLite's application_id
_words = ("status", "category", "quiet_because")
_texts = ("message", "starts")
_longest_silence = 60.0  # [s] of an owner, who is dead then
_patience = 10.0  # [s] for a moment in which the store does not change
_pause = 0.002  # [s] between looks
_longest_owner = 4096  # [bytes] of an owner's file
_at_once = 4096  # rows, which take less time than there is between two commits


class StoreBackend(BackendEntrypoint):
    """Opens chart.sqlite with the chart.toml beside it.

    A finished store gives what `Chart.to_xarray` does. One with cells missing gives those that are there: `status`,
    `category` and `quiet_because` are "not_computed" where a cell is not yet computed, figures are nan. So does
    one that another program of this machine is filling, which is not kept waiting: all cells that it had kept when
    reading began, and perhaps some that came since. One that is filled on another machine is refused.

    Examples
    --------
    >>> import stridor, xarray
    >>> from stridor.xarray_backend import StoreBackend
    >>> chart = stridor.chart(stridor.case("noise-chart"), x=stridor.axis("preload", 2, 4000, 4),
    ...                       y=stridor.axis("mu_d", 0.0, 0.8, 4), out="small")
    >>> xarray.open_dataset("small/chart.sqlite", engine=StoreBackend).identical(chart.to_xarray())
    True
    """

    description = "Stores of charts of Stridor, finished or not"
    open_dataset_parameters = ("filename_or_obj", "drop_variables")

    def open_dataset(self, filename_or_obj: Any, drop_variables: Union[str, Iterable[str], None] = None,
                     **more: Any) -> Any:
        """The chart as a dataset over (direction, y, x), loaded into memory."""
        path = pathlib.Path(os.fspath(filename_or_obj))
        with files(f"read {path}"):
            path.stat()
        if not self.guess_can_open(path):
            raise InputError(f"{path} is no store of a chart")
        try:
            is_being_filled = path.name != "chart.sqlite" or _filler(path) is not None
            data = _unfinished(path) if is_being_filled else open_chart(path.parent).to_xarray()
        except Interrupted:
            data = _unfinished(path)
        return data.drop_vars([drop_variables] if isinstance(drop_variables, str) else drop_variables or [])

    def guess_can_open(self, filename_or_obj: Any) -> bool:
        """Whether it is a store, by its first bytes."""
        try:
            head, _ = _beginning(os.fspath(filename_or_obj), 72)
        except (OSError, TypeError, ValueError):
            return False
        return head.startswith(_mark[0]) and head[68:] == _mark[1]


def _unfinished(path: pathlib.Path) -> xarray.Dataset:
    """What is there of a chart, read as it is at this moment."""
    study = _stridor.read_study(str(path.parent / "chart.toml"))
    axes, directions = study.axes(), study.directions()
    is_diagram = len(axes[1][4]) == 1
    shape = (len(directions), len(axes[0][4])) if is_diagram else (len(directions), len(axes[1][4]), len(axes[0][4]))
    names, rows = _rows(path)
    cells = numpy.prod(shape)
    ids = numpy.array([row[0] for row in rows], dtype=numpy.int64)
    if ids.size and not (0 <= ids.min() and ids.max() < cells):
        raise InputError(f"{path} is the store of another chart than {path.parent / 'chart.toml'}")
    y, x = _dimension(axes[1]), _dimension(axes[0])
    dimensions = ("direction", x[0]) if is_diagram else ("direction", y[0], x[0])
    # the one value of a diagram's y
    resting = ((), y[1][0], y[2]) if is_diagram else y
    variables: Dict[str, Any] = {}
    for k, name in enumerate(names[1:], start=1):
        if name in _texts:
            continue
        column = [row[k] for row in rows]
        whole = numpy.full(cells, -1, dtype="i1") if name in _words else numpy.full(cells, numpy.nan)
        attributes: Dict[str, Any] = {}
        if name in _words:
            words = _stridor.words[name]
            not_done = len(words)
            whole[ids] = [words.index(word) if word in words else not_done for word in column]
            whole = _named(whole, [*(word or "none" for word in words), "not_done"], "not_computed")
        else:
            whole[ids] = numpy.array([numpy.nan if number is None else number for number in column], dtype=float)
        variables[name] = (dimensions, whole.reshape(shape), attributes)
    for name, unit, sentence in _stridor.cell_figures():
        if name in variables:
            variables[name][2].update({"units": unit, "long_name": sentence})
    coordinates: Dict[str, Any] = {"direction": numpy.array(directions, dtype=object), y[0]: resting, x[0]: x}
    about = {"title": "a chart that lacks cells", "y": axes[1][0], "x": axes[0][0], "cells": int(cells),
             "cells_computed": int(ids.size)}
    return xarray.Dataset(variables, coordinates, about)


def _dimension(axis: Tuple[str, str, str, str, Any]) -> Tuple[str, Any, Dict[str, str]]:
    key, unit, sentence, _, values = axis
    return key.split(".")[-1], values, {"units": unit, "long_name": sentence, "key": key}


class _Filler(NamedTuple):
    """Who fills a store, as its owner's file says (src/stridor/storage/owner_file.hpp)."""

    mark: str
    changes: int  # odd while the file changes

    def is_still(self) -> bool:
        """Whether the file may be looked at."""
        return self.changes % 2 == 0


def _filler(path: pathlib.Path) -> Optional[_Filler]:
    """Nothing where nobody does. Throws `FileError` where one does whose changes are not to be seen from here."""
    owner = path.with_name(path.name + ".owner")
    with files(f"read {owner}"):
        try:
            text, changed = _beginning(owner, _longest_owner)
        except FileNotFoundError:
            return None
    lines = text.decode("utf-8", "replace").splitlines()
    said = {key.strip(): value.strip() for key, _, value in (line.partition("=") for line in lines)}
    process = _whole(said.get("process"), 0)
    is_silent = abs(time.time() - changed) > _longest_silence  # one from the future says no more than an old one
    if is_silent or (said.get("host") == socket.gethostname() and not _is_there(process)):
        return None
    # with a descriptor of its own closed, a process gives back its locks
    if said.get("host") != socket.gethostname() or process == os.getpid():
        raise FileError(f"{path} is in use (process {process} of host {said.get('host')} fills it)")
    return _Filler(said.get("mark", ""), _whole(said.get("changes"), 1))


def _whole(text: Optional[str], otherwise: int) -> int:
    return int(text) if text and text.isascii() and text.isdigit() else otherwise


def _beginning(name: Union[str, os.PathLike[str]], most: int) -> Tuple[bytes, float]:
    """The first bytes of a plain file and when it changed [s]; a pipe or a device, which may never answer, is none."""
    with open(os.open(name, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC), "rb") as file:
        about = os.fstat(file.fileno())
        if not stat.S_ISREG(about.st_mode):
            raise OSError(errno.EINVAL, "it is no plain file")
        return file.read(most), about.st_mtime


def _is_there(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        pass
    return True


def _rows(path: pathlib.Path) -> Tuple[List[str], List[Tuple[Any, ...]]]:
    rows: List[Tuple[Any, ...]] = []
    last = -1
    while True:
        names, more = _some_rows(path, last)
        rows += more
        if len(more) < _at_once:
            return names, rows
        last = more[-1][0]


def _some_rows(path: pathlib.Path, last: int) -> Tuple[List[str], List[Tuple[Any, ...]]]:
    """The rows behind the last one, at most so many; of a store that is being filled as they were at one moment."""
    deadline = time.monotonic() + _patience
    while True:
        filler = _filler(path)
        if filler is None or filler.is_still():
            failure = None
            try:
                found = _query(path, "ro" if filler is None else "ro&immutable=1", last)
            except sqlite3.Error as error:
                failure = error
            # what was read while it changed is not what was there, whatever came of it
            if filler is None or _filler(path) == filler:
                if failure is None:
                    return found
                raise FileError(f"cannot read {path} ({failure})") from None
        if time.monotonic() > deadline:
            raise FileError(f"{path} is in use (it changed whenever it was read). Try again.")
        time.sleep(_pause)


def _query(path: pathlib.Path, mode: str, last: int) -> Tuple[List[str], List[Tuple[Any, ...]]]:
    store = sqlite3.connect(f"{path.absolute().as_uri()}?mode={mode}", uri=True, timeout=_patience)
    try:
        cursor = store.execute("SELECT * FROM cell WHERE id > ? ORDER BY id LIMIT ?", (last, _at_once))
        return [column[0] for column in cursor.description], cursor.fetchall()
    finally:
        store.close()
