"""What users hand in: numbers with and without units, arrays, whole numbers. What is none of it is refused."""

from __future__ import annotations

import contextlib
import datetime
import inspect
import operator
import re
import tempfile
from typing import Any, Iterator, Mapping, Tuple, Union

import numpy

from .errors import Error, FileError, InputError

Value = Union[float, str]

_numbers = "fiu"  # kinds of numpy's types
_no_numbers: Tuple[type, ...] = (bool, bytes, bytearray, datetime.date, datetime.time, datetime.timedelta)
_largest_whole = 2**31 - 1


def items_of(what: str, values: Any) -> Iterator[Tuple[Any, Any]]:
    """The pairs of a mapping."""
    if not callable(getattr(values, "items", None)):
        raise InputError(f"{values!r} is no mapping (of {what}). Write it as {{'preload': '20 N'}}.")
    return iter(values.items())


def whole_text(value: str) -> str:
    """Text that the library can take."""
    if not isinstance(value, str):
        raise InputError(f"{value!r} is no text")
    try:
        value.encode()
    except UnicodeEncodeError:
        raise InputError(f"{value!r} is no text (it has half a character)") from None
    return value


def plain(value: object) -> Value:
    """A number as the library takes it, or text. What has a unit of its own becomes text with it."""
    if isinstance(value, str):
        return whole_text(value)
    inner, unit = _parted(value)
    if isinstance(inner, (bool, numpy.bool_)):
        raise InputError(f"{inner} is no number")
    kind = getattr(getattr(inner, "dtype", None), "kind", "f")
    is_one = not getattr(inner, "ndim", 0)
    try:
        if isinstance(inner, _no_numbers) or kind not in _numbers + "O" or not is_one:
            raise TypeError
        number = float(inner)
    except (TypeError, ValueError, OverflowError):
        raise InputError(f"{value!r} is neither a number nor text") from None
    return f"{number!r} {unit}" if unit else number


def plain_text(value: object) -> str:
    """The same as text: a number without a unit is in that of its quantity."""
    given = plain(value)
    return given if isinstance(given, str) else repr(given)


def array(what: str, values: object) -> Any:
    """Numbers, or texts with units, as a numpy array of floats, integers or str."""
    inner, unit = _parted(values)
    masked: Any = numpy.ma
    if masked.is_masked(inner):
        raise InputError(f"some values of {what} are masked (a point has a value of each). Leave them out.")
    try:
        made = numpy.asarray(_told(inner))
    except Error:
        raise
    except ValueError as error:
        raise InputError(f"the values of {what} are no array ({error})") from None
    if made.dtype.kind == "O":
        items = [plain(item) for item in made.ravel()]
        is_text = any(isinstance(item, str) for item in items)
        made = numpy.array([str(item) for item in items] if is_text else items).reshape(made.shape)
    if made.dtype.kind not in _numbers + "U":
        raise InputError(f"the values of {what} are no numbers ({made.dtype})")
    if unit and made.dtype.kind != "U":
        made = numpy.array([f"{float(number)!r} {unit}" for number in made.ravel()]).reshape(made.shape)
    return made


def bare(what: str, values: object, unit: str) -> Any:
    """What is taken as it is, in `unit`: numbers that say another one are refused."""
    inner, own = _parted(values)
    if own and own != unit:
        expected = f" in {unit}" if unit else ""
        raise InputError(f"{what} is in {own} (it is taken as numbers{expected}). Convert it first.")
    return inner


def whole(what: str, value: Any) -> int:
    """A whole number."""
    try:
        if isinstance(value, (bool, numpy.bool_)):
            raise TypeError
        number = int(value) if isinstance(value, float) and value.is_integer() else operator.index(value)
    except TypeError:
        raise InputError(f"{what} = {value!r} is no whole number") from None
    if abs(number) > _largest_whole:
        raise InputError(f"{what} = {number} is out of range")
    return number


@contextlib.contextmanager
def files(what: str) -> Iterator[None]:
    """Failures of the system while it does something with files, as `FileError`: "cannot make a folder (...)"."""
    try:
        yield
    except Error:
        raise
    except (OSError, ValueError) as error:
        if isinstance(error, ValueError) and "null byte" not in str(error):  # of a name
            raise
        why = getattr(error, "strerror", None) or str(error)
        raise FileError._saying([(f"cannot {what}", why, "", None)]) from None


@contextlib.contextmanager
def temporary_folder() -> Iterator[str]:
    """The path of a folder that goes when it is left."""
    with files("make a temporary folder"):
        made = tempfile.TemporaryDirectory(prefix="stridor-")
    with made as folder:
        yield folder


def _told(values: Any) -> Any:
    """Lists with their items' units told; numpy would drop them, and take True for 1 beside numbers."""
    if not isinstance(values, (list, tuple)):
        return values
    return [item if type(item) in (float, int, str) else _told(item) if isinstance(item, (list, tuple)) else
            item if getattr(item, "ndim", 0) and not _parted(item)[1] else plain(item) for item in values]


def _parted(value: Any) -> Tuple[Any, str]:
    """The numbers of what may carry a unit (pint, astropy, unyt, xarray, pandas, netCDF), and the unit; "" without."""
    attributes = getattr(value, "attrs", None)
    if isinstance(attributes, Mapping):
        inner, unit = _parted(value.data) if hasattr(value, "dims") and hasattr(value, "data") else (value, "")
        said = attributes.get("units", attributes.get("unit"))
        return inner, unit or ("" if said is None else _unit_text(said))
    units = [unit for unit in (getattr(value, name, None) for name in ("units", "unit"))
             if unit is not None and not inspect.isroutine(unit)]
    if not units:
        return value, ""
    numbers = [name for name in ("magnitude", "value") if hasattr(value, name)]
    return getattr(value, numbers[0]) if numbers else value, _unit_text(units[0])


def _unit_text(unit: Any) -> str:
    """A unit as case files have it: "m / s ** 2" is "m/s^2"."""
    try:
        said = unit if isinstance(unit, str) else format(unit, "~C")  # pint's short names
    except (TypeError, ValueError):
        said = str(unit)
    said = re.sub(r"^1(\.0)?\s+(?=\w)", "", said.strip()).replace("**", "^")
    said = re.sub(r"\s*([*/^])\s*", r"\1", said)
    said = re.sub(r"(?<=[A-Za-z])(?=-?\d)", "^", said)  # astropy's "m / s2"
    return "" if said in ("", "1", "dimensionless") else said
