"""Many points of a case at once."""

from __future__ import annotations

from typing import Any, Callable, Dict, List, Mapping, Sequence, Tuple, Union

import numpy

from . import _stridor
from ._case import CaseOrName, as_case
from ._given import whole
from ._optional import needed, progress_bar
from ._points import Points, field_of, points_of
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


def _list(names: Union[str, Sequence[str]]) -> List[str]:
    """One name or several."""
    several = [names] if isinstance(names, str) else list(names)
    for name in several:
        if not isinstance(name, str):
            raise InputError(f"{name!r} is no name (it is no text)")
    return several


def _named(numbers: Any, names: Sequence[str], missing: str) -> Any:
    """Words for numbers of words; -1 is `missing`."""
    table = numpy.array([*names, missing])
    return table[numbers]


def evaluate(
    case: CaseOrName,
    values: Mapping[str, object],
    *,
    directions: Union[str, Sequence[str]] = ("going", "coming"),
    starts: Sequence[str] = (),
    threads: int = 0,
    progress: Progress = False,
) -> Any:
    """Simulates a case at many points, on all processors: a design of experiments, or a sample of tolerances.

    Each point has what a cell at these values has in a chart with the same starts, bit for bit.

    Parameters
    ----------
    case : Case or str
        All that does not change; the name of one that comes along will do.
    values : mapping
        By key, last part of it or symbol. Of a quantity numbers in its unit, or text with units. An array that says its
        unit (pint, astropy, the attribute `units` of xarray) is read in it. Of what is chosen words:
        ``{"run.engine": ["exact", "moreau"]}``. The arrays are broadcast against each other; the result has their
        shape. Where words leave something out (a constant drive its velocity), another array says it; what means
        nothing for a point's words changes nothing there.
    directions : "going", "coming", or both
        A constant drive is run once for each, with V = +-abs(velocity).
    starts : sequence of {"rest", "stuck", "sliding", "given"}
        Each point is run from all of them and shows the worst; without them from the case's own.
    threads : int
        [1] 0: one per processor this process may use.
    progress : bool or callable
        True: a bar of tqdm, where it is installed. A function is called ten times a second with the runs done, those
        to do, and an empty dictionary; what it raises ends the work.

    Returns
    -------
    xarray.Dataset
        Over direction and the arrays' dimensions ("point", or "dim_0", "dim_1", ...): category, quiet_because and
        status as words, message, and all figures with their units; NaN where there is none. With starts the
        `agreement` of all, and by start (dimension "start") the `start_verdict`: the category, or the status without
        one. The values are coordinates. The attributes say where it came from: the program with version and commit,
        and the case with its engine, in which the values stand in the place of its own.

    Raises
    ------
    InputError
        For wrong names, words and units, and values out of range, with the number of the point. Values that contradict
        each other make a point "invalid".
    Interrupted
        When it was stopped. Nothing is kept then.

    Examples
    --------
    >>> import numpy, stridor
    >>> doe = stridor.evaluate(stridor.case("squeal"), {"contact.preload": numpy.geomspace(5, 5000, 4), "mu_d": 0.6},
    ...                        directions="going")
    >>> list(doe.category.sel(direction="going").values)
    ['squeal', 'squeal', 'squeal', 'creak']
    >>> laws = stridor.evaluate(stridor.case("squeal"), {"contact.impact": ["plastic", "restitution"],
    ...                                                  "contact.restitution": 0.3}, directions="going")
    >>> [f"{law}: {share:.3f}" for law, share in zip(laws.impact.values, laws.separation.values[0])]
    ['plastic: 0.679', 'restitution: 0.715']
    """
    xarray = needed("xarray", "an evaluation")
    of = as_case(case)
    points = points_of(of, values)
    ways, starts = _list(directions), _list(starts)
    if starts and "run.initial" in points.columns:
        raise InputError("starts and run.initial both say where a run begins. Leave one of them out.")
    asked = _stridor.points([base._handle for base in points.bases], points.base_of, points.keys, points.values, ways,
                            starts)
    count = whole("threads", threads)
    show, close = _shown(progress, "run")
    try:
        result = _stridor.evaluate(asked, count, show)
    finally:
        close()
    return xarray.Dataset(*_dataset_parts(points, ways, starts, result), _stridor.origin(of._handle, "points"))


def _dataset_parts(points: Points, ways: List[str], starts: List[str],
                   result: Dict[str, Any]) -> Tuple[Dict[str, Any], Dict[str, Any]]:
    """Variables and coordinates."""
    shape = points.shape
    inner = ("point",) if len(shape) == 1 else tuple(f"dim_{k}" for k in range(len(shape)))
    dimensions = ("direction", *inner)
    whole = (len(ways), *shape)
    units = {name: {"units": unit, "long_name": sentence} for name, unit, sentence in _stridor.cell_figures()}
    variables: Dict[str, Any] = {
        name: (dimensions, _named(result[name], _stridor.words[name], "not_done").reshape(whole))
        for name in ("category", "quiet_because", "status", *(["agreement"] if starts else []))
    }
    variables["message"] = (dimensions, numpy.array(result["messages"], dtype=object).reshape(whole))
    for name, array in result["figures"].items():
        variables[name] = (dimensions, array.reshape(whole), units[name])
    coordinates: Dict[str, Any] = {"direction": ways}
    if starts:
        coordinates["start"] = starts
        verdicts = _named(numpy.array(result["start_verdict"]), _stridor.words["start_verdict"], "")
        variables["start_verdict"] = (("start", *dimensions), verdicts.reshape(len(starts), *whole))
    for key, array in points.columns.items():
        field = field_of(key)
        about = {"units": field["unit"]} if field["unit"] is not None else {}
        coordinates[_coordinate(key, variables)] = (
            inner, array, {**about, "long_name": field["sentence"], "parameter": key})
    return variables, coordinates


def _coordinate(key: str, taken: Mapping[str, object]) -> str:
    """The short name of a quantity, unless a figure has it."""
    name = key.split(".")[-1]
    return key.replace(".", "_") if name in taken or key.count(".") > 1 else name


def with_texts(data: Any) -> Any:
    """A dataset of a file of ours with its long texts as attributes, which HDF5 takes as variables only."""
    texts = [name for name in ("study", "case") if name in data.variables and not data[name].dims]
    named = data.drop_vars(texts).copy()
    for name in texts:
        text = data[name].item()
        named.attrs[name] = text.decode("utf-8") if isinstance(text, bytes) else str(text)
    return named


def words(data: Any) -> Any:
    """A dataset of one of our files, with words where a netCDF file has numbers of words (flags).

    What this package hands out has its words already.

    Parameters
    ----------
    data : xarray.Dataset
        A chart or a trace, as `xarray.open_dataset` reads it.

    Returns
    -------
    xarray.Dataset

    Examples
    --------
    >>> import stridor, xarray
    >>> chart = stridor.chart(stridor.case("noise-chart"), x=stridor.axis("preload", 2, 4000, 4),
    ...                       y=stridor.axis("mu_d", 0.0, 0.8, 4), out="small")
    >>> with xarray.open_dataset("small/chart.nc") as file:
    ...     stridor.words(file).identical(chart.to_xarray())
    True
    """
    if not hasattr(data, "data_vars"):
        raise InputError(f"{type(data).__name__} is no dataset. Give a chart or a trace.")
    named = with_texts(data)
    for name, variable in data.variables.items():
        if "flag_meanings" not in variable.attrs:
            continue
        numbers = numpy.atleast_1d(variable.attrs["flag_values"])
        meanings = variable.attrs["flag_meanings"].split()
        table = dict(zip((int(number) for number in numbers), meanings))
        found, places = numpy.unique(variable.values, return_inverse=True)
        texts = numpy.array([table[int(number)] for number in found])[places].reshape(variable.shape)
        attributes = {key: value for key, value in variable.attrs.items() if not key.startswith("flag_")}
        put = named.assign_coords if name in data.coords else named.assign
        named = put({name: (variable.dims, texts, attributes)})
    return named
