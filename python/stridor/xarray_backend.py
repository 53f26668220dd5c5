"""xarray opens stores of charts: finished ones, and those that were stopped before.

``xarray.open_dataset("pair/chart.sqlite", engine="stridor")``; where the package is not installed but lies in the
search path, `engine=stridor.xarray_backend.StoreBackend`.
"""

from __future__ import annotations

import os
import pathlib
import sqlite3
from typing import Any, Dict, Iterable, List, Tuple, Union

import numpy
import xarray
from xarray.backends import BackendEntrypoint

from . import _stridor
from ._charts import open_chart
from .errors import FileError, InputError, Interrupted

__all__ = ["StoreBackend"]

_mark = (b"SQLite format 3\x00", b"STRD")  # at 0 and at 68: SQLite's application_id
_words = ("status", "category", "quiet_because")
_texts = ("message", "starts")


class StoreBackend(BackendEntrypoint):
    """Opens chart.sqlite with the chart.toml beside it.

    A finished store gives what chart.nc holds. One with cells missing gives those that are there: `status` is -1 where
    a cell is not yet computed, figures are nan. One that a program is filling at this moment is refused: it is locked.

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
        if not self.guess_can_open(path):
            raise InputError(f"{path} is no store of a chart")
        try:
            data = open_chart(path.parent).to_xarray() if path.name == "chart.sqlite" else _unfinished(path)
        except Interrupted:
            data = _unfinished(path)
        return data.drop_vars([drop_variables] if isinstance(drop_variables, str) else drop_variables or [])

    def guess_can_open(self, filename_or_obj: Any) -> bool:
        """Whether it is a store, by its first bytes."""
        try:
            with open(os.fspath(filename_or_obj), "rb") as file:
                head = file.read(72)
        except (OSError, TypeError):
            return False
        return head.startswith(_mark[0]) and head[68:] == _mark[1]


def _unfinished(path: pathlib.Path) -> xarray.Dataset:
    """What is there of a chart, read as it is at this moment."""
    study = _stridor.read_study(str(path.parent / "chart.toml"))
    axes, directions = study.axes(), study.directions()
    shape = (len(directions), len(axes[1][4]), len(axes[0][4]))
    names, rows = _rows(path)
    cells = numpy.prod(shape)
    ids = numpy.array([row[0] for row in rows], dtype=numpy.int64)
    if ids.size and not (0 <= ids.min() and ids.max() < cells):
        raise InputError(f"{path} is the store of another chart than {path.parent / 'chart.toml'}")
    y, x = _dimension(axes[1]), _dimension(axes[0])
    variables: Dict[str, Any] = {}
    for k, name in enumerate(names[1:], start=1):
        if name in _texts:
            continue
        column = [row[k] for row in rows]
        whole = numpy.full(cells, -1, dtype="i1") if name in _words else numpy.full(cells, numpy.nan)
        attributes: Dict[str, Any] = {}
        if name in _words:
            words = _stridor.words[name]
            whole[ids] = [words.index(word) if word in words else -1 for word in column]
            missing = "not_computed" if name == "status" else "not_done"
            attributes = {"flag_values": numpy.array([*range(len(words)), -1], dtype="i1"),
                          "flag_meanings": " ".join([*(word or "none" for word in words), missing])}
        else:
            whole[ids] = numpy.array([numpy.nan if number is None else number for number in column], dtype=float)
        variables[name] = (("direction", y[0], x[0]), whole.reshape(shape), attributes)
    for name, unit, sentence in _stridor.cell_figures():
        if name in variables:
            variables[name][2].update({"units": unit, "long_name": sentence})
    coordinates: Dict[str, Any] = {"direction": numpy.array(directions, dtype=object), y[0]: y, x[0]: x}
    about = {"title": "a chart that lacks cells", "y": axes[1][0], "x": axes[0][0], "cells": int(cells),
             "cells_computed": int(ids.size)}
    return xarray.Dataset(variables, coordinates, about)


def _dimension(axis: Tuple[str, str, str, str, Any]) -> Tuple[str, Any, Dict[str, str]]:
    key, unit, sentence, _, values = axis
    return key.split(".")[-1], values, {"units": unit, "long_name": sentence, "key": key}


def _rows(path: pathlib.Path) -> Tuple[List[str], List[Tuple[Any, ...]]]:
    try:
        store = sqlite3.connect(path.absolute().as_uri() + "?mode=ro", uri=True, timeout=10)
        try:
            cursor = store.execute("SELECT * FROM cell ORDER BY id")
            return [column[0] for column in cursor.description], cursor.fetchall()
        finally:
            store.close()
    except sqlite3.Error as error:
        raise FileError(f"cannot read {path} ({error})") from None
