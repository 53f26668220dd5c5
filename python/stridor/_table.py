"""Tables: columns that other libraries take as they are."""

from __future__ import annotations

import json
from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

import numpy

from . import _stridor
from ._evaluate import words
from ._optional import needed
from .errors import InputError

__all__ = ["Table", "table"]

_kinds = ("number", "integer", "word")  # as the library counts them
_missing = ("not_done", "not_computed")  # the words of datasets for what is not there


class _Column(NamedTuple):
    """Values as the library takes them."""

    kind: str
    """"number", "integer" or "word"."""
    values: Any
    """float64; of words their numbers; NaN where there is none."""
    words: List[str]
    about: Dict[str, str]
    """What the field says of itself: unit, long_name, parameter."""


class Table:
    """Columns of one length, with units. `table` makes it.

    It speaks Arrow's PyCapsule protocol (`__arrow_c_stream__`), so that pyarrow, polars, DuckDB, pandas and others take
    it as it is: ``pyarrow.table(t)``, ``polars.DataFrame(t)``. Units stand in the fields' metadata, words are
    dictionaries, missing values are nulls. What was taken stays when the table is gone.

    Examples
    --------
    >>> import stridor
    >>> doe = stridor.evaluate(stridor.case("squeal"), {"preload": [20, 200]}, directions="going")
    >>> t = stridor.table(doe)
    >>> len(t), t.names[:3], t.unit("preload")
    (2, ['direction', 'preload', 'category'], 'N')
    >>> t["category"]
    ['squeal', 'squeal']
    """

    def __init__(self, columns: Mapping[str, _Column], about: Mapping[str, str]) -> None:
        self._columns = dict(columns)
        self._about = dict(about)

    @property
    def names(self) -> List[str]:
        """Of the columns, in their order."""
        return list(self._columns)

    def __len__(self) -> int:
        return len(next(iter(self._columns.values())).values) if self._columns else 0

    def __getitem__(self, name: str) -> Any:
        """A column: a float64 array with NaN where a number is missing, an int64 array, or a list of words and None."""
        column = self._of(name)
        if column.kind == "word":
            return [None if number != number else column.words[int(number)] for number in column.values.tolist()]
        if column.kind == "integer" and not numpy.isnan(column.values).any():
            return column.values.astype(numpy.int64)
        return column.values

    def unit(self, name: str) -> str:
        """The unit of a column; "" for words and counts.

        Examples
        --------
        >>> import stridor
        >>> doe = stridor.evaluate(stridor.case("squeal"), {"preload": [20, 200]}, directions="going")
        >>> stridor.table(doe).unit("frequency")
        'Hz'
        """
        return self._of(name).about.get("unit", "")

    def _of(self, name: str) -> _Column:
        if name not in self._columns:
            raise InputError(f'the table has no column "{name}". It has {", ".join(self._columns)}.')
        return self._columns[name]

    def to_pandas(self) -> Any:
        """The same as a `pandas.DataFrame`; words are categories, units stand in `attrs`.

        Returns
        -------
        pandas.DataFrame

        Examples
        --------
        >>> import stridor
        >>> doe = stridor.evaluate(stridor.case("squeal"), {"preload": [20, 200]}, directions="going")
        >>> stridor.table(doe).to_pandas().attrs["frequency"]
        {'unit': 'Hz'}
        """
        pandas = needed("pandas", "a table")
        frame = pandas.DataFrame({
            name: pandas.Categorical(self[name], categories=column.words) if column.kind == "word" else self[name]
            for name, column in self._columns.items()})
        frame.attrs.update({name: {"unit": self.unit(name)} for name in self.names if self.unit(name)})
        return frame

    def __arrow_c_stream__(self, requested_schema: object = None) -> Any:
        """A PyCapsule with an ArrowArrayStream of chunks of 65,536 rows; another schema than its own is not made."""
        columns = [(name, _kinds.index(column.kind), *column[1:]) for name, column in self._columns.items()]
        return _stridor.arrow_stream(columns, self._about)

    def __repr__(self) -> str:
        return f"<table of {len(self)} rows: {', '.join(self.names)}>"


def table(source: Any) -> Table:
    """A table of what this package hands out, with a row for each cell, point, sample, stay or entry.

    Parameters
    ----------
    source : xarray.Dataset, Chart, or sequence of mappings
        A dataset of `evaluate`, of a chart, of a trace or of a history; or entries as `Library.find` gives them. What
        a dataset has of each start, degree of freedom or contact becomes a column of each: `velocity_x1`. A diagram's
        `extremes` and `beat_intervals`, of which each cell has another number, are left out.

    Returns
    -------
    Table

    Examples
    --------
    >>> import stridor
    >>> motion = stridor.simulate(stridor.case("squeal"))
    >>> trace = stridor.table(motion.trace(0.2, 0.21))
    >>> len(trace), trace.unit("velocity_x1")
    (501, 'm/s')
    """
    if isinstance(source, Table):
        return source
    if hasattr(source, "to_xarray"):
        source = source.to_xarray()
    if hasattr(source, "data_vars"):
        return _of_dataset(words(source))
    if isinstance(source, Sequence) and all(isinstance(row, Mapping) for row in source):
        return _of_rows(source)
    raise InputError(f"{type(source).__name__} is no table. Give a dataset, a chart, or entries of a library.")


def _of_dataset(data: Any) -> Table:
    variables = data.data_vars.values()
    widest = max(variables, key=lambda variable: len(variable.dims)).dims
    main = tuple(name for name in widest if all(name in variable.dims for variable in variables))
    columns: Dict[str, _Column] = {}
    for name, variable in {**data.coords, **data.data_vars}.items():
        extra = [dimension for dimension in variable.dims if dimension not in main]
        if not set(variable.dims) - set(extra) and name not in main and name in data.coords and extra:
            continue  # the labels of other dimensions
        for label, part in _parts(data, variable, extra):
            whole = part.broadcast_like(data[_any_over(data, main)]) if part.dims != main else part
            columns[f"{name}{label}"] = _column(whole.transpose(*main).values.ravel(), variable.attrs)
    about = {key: value for key, value in data.attrs.items() if isinstance(value, str)}
    return Table(columns, about)


def _any_over(data: Any, main: Tuple[str, ...]) -> List[str]:
    """A variable over these dimensions alone."""
    return next(name for name, variable in data.data_vars.items() if variable.dims == main)


def _parts(data: Any, variable: Any, extra: Sequence[str]) -> List[Tuple[str, Any]]:
    """A variable for each label of a dimension more; none where that has no labels."""
    if not extra:
        return [("", variable)]
    if len(extra) > 1 or extra[0] not in data.coords:
        return []
    return [(f"_{label}", variable.sel({extra[0]: label}, drop=True)) for label in data[extra[0]].values]


def _of_rows(rows: Sequence[Mapping[str, Any]]) -> Table:
    names = dict.fromkeys(name for row in rows for name in row)
    columns = {name: _column(_plain_array([row.get(name) for row in rows]), {}) for name in names}
    return Table(columns, {})


def _plain_array(values: List[Any]) -> Any:
    """Numbers where all are numbers or missing, else text; what has parts is JSON."""
    there = [value for value in values if value is not None]
    if there and all(isinstance(value, (int, float)) and not isinstance(value, bool) for value in there):
        if len(there) == len(values) and all(isinstance(value, int) for value in there):
            return numpy.array(values)
        return numpy.array([numpy.nan if value is None else float(value) for value in values])
    texts = [value if value is None or isinstance(value, str) else json.dumps(value) for value in values]
    return numpy.array(texts, dtype=object)


def _column(values: Any, attributes: Mapping[str, Any]) -> _Column:
    about = {name: str(attributes[key]) for name, key in
             (("unit", "units"), ("long_name", "long_name"), ("parameter", "parameter"), ("parameter", "key"))
             if key in attributes}
    if values.dtype.kind in "fiub":
        kind = "number" if values.dtype.kind == "f" else "integer"
        return _Column(kind, values.astype(float), [], about)
    texts: List[Optional[str]] = [None if value is None or value in _missing else str(value)
                                  for value in values.tolist()]
    there: Dict[Union[str, None], float] = {text: float(number) for number, text in
                                            enumerate(dict.fromkeys(text for text in texts if text is not None))}
    numbers = numpy.array([numpy.nan if text is None else there[text] for text in texts], dtype=float)
    return _Column("word", numbers, [text for text in there if text is not None], about)
