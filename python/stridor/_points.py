"""Points of a case: what changes from one to the next, be it a number or a word."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, Dict, List, Mapping, NamedTuple, Sequence, Tuple

import numpy

from . import _stridor
from ._case import Case
from ._given import array, items_of
from .errors import Error, InputError

__all__: List[str] = []


class Points(NamedTuple):
    """What is evaluated."""

    bases: List[Case]
    """A case for each combination of words."""
    base_of: List[int]
    """[1] Of each point, into `bases`."""
    columns: Dict[str, Any]
    """The values of each key, all with the shape of the points: numbers in their units, or words."""

    @property
    def shape(self) -> Tuple[int, ...]:
        """That of the points."""
        shape: Tuple[int, ...] = next(iter(self.columns.values())).shape
        return shape

    @property
    def keys(self) -> List[str]:
        """Those of quantities."""
        return [key for key, column in self.columns.items() if column.dtype.kind == "f"]

    @property
    def values(self) -> Any:
        """Of the quantities; shape (point, key)."""
        columns = [self.columns[key].ravel() for key in self.keys]
        return numpy.stack(columns, axis=-1) if columns else numpy.empty((0, 0))


@lru_cache(maxsize=None)
def _fields() -> Dict[str, Dict[str, Any]]:
    return {field["key"]: field for field in _stridor.fields()}


def field_of(key: str) -> Dict[str, Any]:
    """What the field table says of a key, of a joint's too: ``joint.lip2.contact.preload``."""
    parts = key.split(".")
    inner = parts[2:] if parts[0] == "joint" and len(parts) > 2 else parts
    return _fields()["joint." + inner[0] if len(inner) == 1 < len(parts) else ".".join(inner)]


def points_of(case: Case, values: Mapping[str, object]) -> Points:
    """The points that arrays of values make of a case."""
    names: Dict[str, object] = {}
    values = dict(items_of("values by key", values))
    for name in values:
        other = names.setdefault(_stridor.key_called(str(name)), name)
        if other is not name:
            same = f"{other} and {name} set the same quantity"
            raise InputError._saying([(same, "", "Leave one of them out.", None)])
    given = _broadcast({key: array(str(name), values[name]) for key, name in names.items()})  # type: ignore[index]
    words = [key for key in given if field_of(key)["unit"] is None]
    combinations: Dict[Tuple[Any, ...], List[int]] = {}
    texts = [[_item(text) for text in given[key].ravel()] for key in words]
    for point in range(next(iter(given.values())).size):
        combinations.setdefault(tuple(column[point] for column in texts), []).append(point)
    base_of = [0] * sum(map(len, combinations.values()))
    bases = []
    for number, (combination, points) in enumerate(combinations.items()):
        bases.append(_base(case, dict(zip(words, combination)), given, points))
        for point in points:
            base_of[point] = number
    columns = {key: column if key in words else _numbers(key, column, bases, base_of) for key, column in given.items()}
    return Points(bases or [case], base_of, columns)


def numbered(point: int, error: Error) -> Error:
    """The same error, with the number of the point that has it."""
    return error._saying([(f"point {point}: {what}", why, suggestion, place)
                          for what, why, suggestion, place in error.complaints])


def _item(value: Any) -> Any:
    """As Python has it."""
    return value.item() if isinstance(value, numpy.generic) else value


def _broadcast(arrays: Mapping[str, Any]) -> Dict[str, Any]:
    if not arrays:
        raise InputError("there are no points (no quantity changes). Give one quantity at least.")
    try:
        return dict(zip(arrays, numpy.broadcast_arrays(*arrays.values())))
    except ValueError as error:
        raise InputError(f"the arrays do not fit together: {error}") from None


def _base(case: Case, words: Dict[str, Any], given: Mapping[str, Any], points: Sequence[int]) -> Case:
    """The case with these words; where they alone leave something out, with the numbers of one of their points, too."""
    if not words:
        return case
    try:
        return case.replace(words)
    except Error as error:
        alone = error
    refused: List[Error] = []
    for point in points:
        numbers = {key: _item(column.ravel()[point]) for key, column in given.items() if key not in words}
        for _ in range(2):
            try:
                return case.replace({**words, **numbers})
            except Error as error:
                refused.append(error)
                said = [what for what, *_ in error.complaints]
                numbers = {key: number for key, number in numbers.items()
                           if f"{key} means nothing for this case" not in said}
        if refused[-1].complaints == alone.complaints:
            break  # no number mends it
    raise numbered(points[0], (refused[1:] or [alone])[0]) from None


def _numbers(key: str, column: Any, bases: Sequence[Case], base_of: Sequence[int]) -> Any:
    """A column of numbers, or of texts with units."""
    if column.dtype.kind != "U":
        return column.astype(float)
    known: Dict[Tuple[str, int], object] = {}  # a text often stands at many points
    numbers = []
    for point, text in enumerate(column.ravel().tolist()):
        base = base_of[point]
        if (text, base) not in known:
            known[text, base] = _number(key, text, [bases[base], *bases], point)
        numbers.append(known[text, base])
    return numpy.array(numbers, dtype=float).reshape(column.shape)


def _number(key: str, text: str, cases: Sequence[Case], point: int) -> object:
    """In the quantity's unit; what is more than a number with a unit as the first of the cases has it that knows it."""
    errors: List[Error] = []
    try:
        return _stridor.quantity(text, _stridor.unit_of(key))
    except Error:
        pass
    for case in cases:
        try:
            return case.replace({key: text})[key]
        except Error as error:
            errors.append(error)
    raise numbered(point, errors[0]) from None
