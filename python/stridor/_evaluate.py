"""Many points of a case at once."""

from __future__ import annotations

from typing import Any, Callable, Dict, List, Mapping, Sequence, Tuple, Union

import numpy

from . import _stridor
from ._case import Case
from ._optional import needed, progress_bar
from .errors import InputError

__all__ = ["evaluate", "words"]

Progress = Union[bool, Callable[[int, int, Dict[str, int]], object]]


def _shown(progress: Progress, unit: str) -> Tuple[Any, Callable[[], None]]:
    """What is called as the work goes on, or None, and what closes it."""
    if progress is False or progress is None:
        return None, lambda: None
    if callable(progress):
        return progress, lambda: None
    bar = progress_bar(unit)
    if bar is None:
        return None, lambda: None

    def show(done: int, total: int, counts: Dict[str, int]) -> None:
        bar.total = total
        bar.set_postfix({name: count for name, count in counts.items() if count}, refresh=False)
        bar.update(done - bar.n)

    return show, bar.close


def _directions(directions: Union[str, Sequence[str]]) -> List[str]:
    return [directions] if isinstance(directions, str) else list(directions)


def _named(numbers: Any, names: Sequence[str], missing: str) -> Any:
    """Words for numbers of words; -1 is `missing`."""
    table = numpy.array([*names, missing])
    return table[numbers]


def _columns(case: Case, values: Mapping[str, object]) -> Tuple[List[str], List[Any], Tuple[int, ...]]:
    keys, arrays = [], []
    for name, column in values.items():
        key = _stridor.key_called(str(name))
        array = numpy.asarray(column)
        if array.dtype.kind in "US":  # text with units
            texts = [case.replace({key: str(text)})[key] for text in array.ravel()]
            array = numpy.array(texts, dtype=float).reshape(array.shape)
        try:
            if array.dtype.kind in "cO":
                raise TypeError
            array = array.astype(float)
        except (TypeError, ValueError):
            raise InputError(f"the values of {key} are no numbers") from None
        keys.append(key)
        arrays.append(array)
    if not arrays:
        raise InputError("there are no points (no quantity changes). Give one quantity at least.")
    try:
        arrays = numpy.broadcast_arrays(*arrays)
    except ValueError as error:
        raise InputError(f"the arrays do not fit together: {error}") from None
    return keys, arrays, arrays[0].shape


def evaluate(
    case: Case,
    values: Mapping[str, object],
    *,
    directions: Union[str, Sequence[str]] = ("going", "coming"),
    threads: int = 0,
    progress: Progress = False,
) -> Any:
    """Simulates a case at many points, on all processors: a design of experiments, or a sample of tolerances.

    Each point has what a chart's cell at these values has, bit for bit.

    Parameters
    ----------
    case : Case
        All that does not change.
    values : mapping
        For each quantity (key, last part of it or symbol) its values: numbers in its unit, or text with units. The
        arrays are broadcast against each other; the result has their shape.
    directions : "going", "coming", or both
        A constant drive is run once for each, with V = +-abs(velocity).
    threads : int
        [1] 0: one per processor this process may use.
    progress : bool or callable
        True: a bar of tqdm, where it is installed. A function is called ten times a second with the runs done, those
        to do, and an empty dictionary; what it raises ends the work.

    Returns
    -------
    xarray.Dataset
        Over direction and the arrays' dimensions ("point", or "dim_0", "dim_1", ...): category, quiet_because and
        status as words, message, and all figures with their units; NaN where there is none. The values are
        coordinates.

    Raises
    ------
    InputError
        For what is no quantity, and values out of range. Values that contradict each other make a point "invalid".
    Interrupted
        When it was stopped. Nothing is kept then.

    Examples
    --------
    >>> import numpy, stridor
    >>> doe = stridor.evaluate(stridor.case("squeal"), {"contact.preload": numpy.geomspace(5, 5000, 4), "mu_d": 0.6},
    ...                        directions="going")
    >>> list(doe.category.sel(direction="going").values)
    ['squeal', 'squeal', 'squeal', 'creak']
    """
    xarray = needed("xarray", "an evaluation")
    keys, arrays, shape = _columns(case, values)
    ways = _directions(directions)
    show, close = _shown(progress, "run")
    points = numpy.stack([array.ravel() for array in arrays], axis=-1)
    try:
        result = _stridor.evaluate(case._handle, keys, points, ways, int(threads), show)
    finally:
        close()
    inner = ("point",) if len(shape) == 1 else tuple(f"dim_{k}" for k in range(len(shape)))
    dimensions = ("direction", *inner)
    whole = (len(ways), *shape)
    units = {name: {"units": unit, "long_name": sentence} for name, unit, sentence in _stridor.cell_figures()}
    variables: Dict[str, Any] = {
        name: (dimensions, _named(result[name], _stridor.words[name], "not_done").reshape(whole))
        for name in ("category", "quiet_because", "status")
    }
    variables["message"] = (dimensions, numpy.array(result["messages"], dtype=object).reshape(whole))
    for name, array in result["figures"].items():
        variables[name] = (dimensions, array.reshape(whole), units[name])
    coordinates: Dict[str, Any] = {"direction": ways}
    about = {field["key"]: field for field in _stridor.fields()}
    for key, array in zip(keys, arrays):
        field = about.get(key, {})
        coordinates[_coordinate(key, variables)] = (
            inner, array, {"units": field.get("unit", ""), "long_name": field.get("sentence", ""), "parameter": key})
    return xarray.Dataset(variables, coordinates)


def _coordinate(key: str, taken: Mapping[str, object]) -> str:
    """The short name of a quantity, unless a figure has it."""
    name = key.split(".")[-1]
    return key.replace(".", "_") if name in taken or key.count(".") > 1 else name


def words(data: Any) -> Any:
    """A dataset of ours with words where a netCDF file has numbers of words (flags).

    Parameters
    ----------
    data : xarray.Dataset
        A chart or a trace.

    Returns
    -------
    xarray.Dataset

    Examples
    --------
    >>> import stridor
    >>> trace = stridor.words(stridor.simulate(stridor.case("squeal")).trace(0, "1 ms"))
    >>> str(trace.state.values[0])
    'slip'
    """
    named = data.copy()
    for name, variable in data.data_vars.items():
        if "flag_meanings" not in variable.attrs:
            continue
        numbers = numpy.atleast_1d(variable.attrs["flag_values"])
        meanings = variable.attrs["flag_meanings"].split()
        table = dict(zip((int(number) for number in numbers), meanings))
        found, places = numpy.unique(variable.values, return_inverse=True)
        texts = numpy.array([table[int(number)] for number in found])[places].reshape(variable.shape)
        attributes = {key: value for key, value in variable.attrs.items() if not key.startswith("flag_")}
        named[name] = (variable.dims, texts, attributes)
    return named
