"""Charts: the verdict over two quantities."""

from __future__ import annotations

import os
import pathlib
import tempfile
from typing import Any, Dict, List, Optional, Tuple, Union

import numpy

from . import _chart_parts, _html, _stridor
from ._case import Case
from ._given import files, plain_text, temporary_folder, whole_text
from ._chart_parts import Boundary, ChartAxis
from ._evaluate import _named, words
from ._optional import needed
from .errors import InputError

__all__ = ["Chart", "open_chart"]


class Chart:
    """A finished chart. `chart` and `open_chart` make it.

    Its cells lie in the store of its folder, which is open only while they are read. A chart without a folder has one
    that goes with it. Pickled, it takes all its cells along.

    Attributes
    ----------
    folder : pathlib.Path
    directions : list of str
    x, y : ChartAxis
        Of a diagram over one quantity y is None.

    Examples
    --------
    >>> import stridor
    >>> chart = stridor.chart(stridor.case("noise-chart"), x=stridor.axis("preload", 2, 4000, 4),
    ...                       y=stridor.axis("mu_d", 0.0, 0.8, 4))
    >>> chart.counts("going")["none"]
    6
    """

    def __init__(self, handle: _stridor.ChartHandle, folder: pathlib.Path, kept: object = None) -> None:
        self._handle = handle
        self.folder = folder
        self._kept = kept  # the temporary folder, which is removed with it
        self.directions: List[str] = handle.directions()
        x, y = handle.axes()
        self.x = ChartAxis(*x)
        self.y = ChartAxis(*y) if len(y[-1]) > 1 else None

    @property
    def case(self) -> Case:
        """The case that the axes vary."""
        return Case._of(self._handle.base())

    def categories(self) -> Any:
        """The category of each cell as a word, "not_done" without a result.

        Returns
        -------
        numpy.ndarray
            Shape (direction, y, x), of a diagram (direction, x); likewise of all that follows.

        Examples
        --------
        >>> import stridor
        >>> chart = stridor.chart(stridor.case("noise-chart"), x=stridor.axis("preload", 2, 4000, 4),
        ...                       y=stridor.axis("mu_d", 0.0, 0.8, 4))
        >>> chart.categories().shape
        (2, 4, 4)
        """
        return _named(self._handle.verdicts()["category"], _stridor.words["category"], "not_done")

    def numbers(self, name: str) -> Any:
        """The numbers of words of each cell, without a copy; `words` of the module says which.

        Parameters
        ----------
        name : {"category", "quiet_because", "status", "source", "agreement"}

        Returns
        -------
        numpy.ndarray
            int8, shape (direction, y, x); -1 where a cell is not done.

        Examples
        --------
        >>> import stridor
        >>> chart = stridor.chart(stridor.case("noise-chart"), x=stridor.axis("preload", 2, 4000, 4),
        ...                       y=stridor.axis("mu_d", 0.0, 0.8, 4))
        >>> chart.numbers("status").max()
        0
        """
        verdicts = self._handle.verdicts()
        if name not in verdicts:
            raise InputError(f'a chart has no numbers "{name}". Choose one of {", ".join(verdicts)}.')
        return verdicts[name]

    def figure(self, name: str) -> Any:
        """A figure of each cell; of one that was inferred that of the cell it takes after.

        Parameters
        ----------
        name : str
            As "frequency" [Hz], "joint_level" [dB re 1e-9 m/s], "separation" [1].

        Returns
        -------
        numpy.ndarray
            Shape (direction, y, x); NaN where there is none.

        Examples
        --------
        >>> import stridor
        >>> chart = stridor.chart(stridor.case("noise-chart"), x=stridor.axis("preload", 2, 4000, 4),
        ...                       y=stridor.axis("mu_d", 0.0, 0.8, 4))
        >>> float(chart.figure("slip").max())
        1.0
        """
        return self._handle.figure(name)

    def counts(self, direction: Optional[str] = None) -> Dict[str, int]:
        """How many cells there are of each category; "locks" are those of "none" whose contact locks.

        Examples
        --------
        >>> import stridor
        >>> chart = stridor.chart(stridor.case("noise-chart"), x=stridor.axis("preload", 2, 4000, 4),
        ...                       y=stridor.axis("mu_d", 0.0, 0.8, 4))
        >>> sum(chart.counts().values())
        32
        """
        locks = self.numbers("quiet_because") == _stridor.words["quiet_because"].index("locks")
        categories = numpy.where(locks, "locks", self.categories())
        chosen = categories if direction is None else categories[self._direction(direction)]
        names, numbers = numpy.unique(chosen, return_counts=True)
        return {str(name): int(number) for name, number in zip(names, numbers)}

    def _direction(self, direction: Optional[str]) -> int:
        if direction is None:
            return 0
        if direction not in self.directions:
            raise InputError(f'this chart has no direction "{direction}". It has {" and ".join(self.directions)}.')
        return self.directions.index(direction)

    def case_at(self, *, direction: Optional[str] = None, **values: Union[float, str]) -> Case:
        """The case of the cell that is nearest to two values, on the scales of the axes.

        Parameters
        ----------
        direction : str, optional
            The first one of the chart without it.
        **values
            One for each axis, by the last part of its key: ``preload=900``, in its unit or as text with one. A diagram
            has one.

        Returns
        -------
        Case
            With the cell's own values: `simulate` of it gives what the cell has.

        Examples
        --------
        >>> import stridor
        >>> chart = stridor.chart(stridor.case("noise-chart"), x=stridor.axis("preload", 2, 4000, 4),
        ...                       y=stridor.axis("mu_d", 0.0, 0.8, 5))
        >>> chart.case_at(direction="going", preload="3.9 kN", kinetic_friction=0.41).text("contact.kinetic_friction")
        '0.4'
        """
        axes = {"x": self.x, **({} if self.y is None else {"y": self.y})}
        names = {spelling: place for place, axis in axes.items() for spelling in (axis.name, axis.parameter, place)}
        if self.y is not None and self.x.name == self.y.name:
            del names[self.x.name]
        both = " and ".join(axis.name for axis in axes.values())
        # the y of a diagram has one value
        texts = {} if self.y is not None else {"y": repr(float(self._handle.axes()[1][-1][0]))}
        for name, value in values.items():
            if name not in names:
                raise InputError(f'the chart has no axis "{name}". {"Its axes are" if self.y else "It has"} {both}.')
            texts[names[name]] = plain_text(value)
        if len(texts) != 2:
            raise InputError(f"a cell has {'two values' if self.y else 'one value'}. Give {both}.")
        return Case._of(self._handle.case_at(texts["x"], texts["y"], direction or ""))

    def boundaries(self) -> List[Boundary]:
        """The lines between the categories."""
        return [Boundary(self.directions[line[0]], *line[1:]) for line in self._handle.boundaries()]

    def to_xarray(self) -> Any:
        """The chart as `words(xarray.open_dataset("chart.nc"))` gives it: categories and statuses are words.

        Returns
        -------
        xarray.Dataset
            Over (direction, y, x), the axes being named after their quantities; loaded into memory. A diagram is over
            (direction, x) and has what `plot` draws, too: `extremes` [m], the displacements x1 at which the joint
            turns, and `beat_intervals` [s], the times between its beats; rising along one dimension more, then NaN.

        Examples
        --------
        >>> import stridor
        >>> chart = stridor.chart(stridor.case("noise-chart"), x=stridor.axis("preload", 2, 4000, 4),
        ...                       y=stridor.axis("mu_d", 0.0, 0.8, 4))
        >>> float((chart.to_xarray().category == "none").mean())
        0.5625
        """
        xarray = needed("xarray", "a dataset")
        needed("netCDF4", "a dataset")
        with temporary_folder() as folder:
            path = os.path.join(folder, "chart.nc")
            self._handle.write_netcdf(path)
            data = words(xarray.load_dataset(path))
        return data if self.y is not None else _chart_parts.with_diagram(self, data)

    def to_pandas(self) -> Any:
        """A row for each cell: direction, the axes' values, category and all figures.

        Returns
        -------
        pandas.DataFrame

        Examples
        --------
        >>> import stridor
        >>> chart = stridor.chart(stridor.case("noise-chart"), x=stridor.axis("preload", 2, 4000, 4),
        ...                       y=stridor.axis("mu_d", 0.0, 0.8, 4))
        >>> int((chart.to_pandas().category == "none").sum())
        18
        """
        needed("pandas", "a table")
        return self.to_xarray().drop_dims(["extreme", "beat"], errors="ignore").to_dataframe().reset_index()

    def __arrow_c_stream__(self, requested_schema: object = None) -> Any:
        """All cells as a stream of Arrow, as `table` makes them: pyarrow, polars and others take a chart as it is."""
        from ._table import table

        return table(self).__arrow_c_stream__(requested_schema)

    def plot(self, figure: str = "category", *, direction: Optional[str] = None, ax: Any = None, **style: Any) -> Any:
        """Draws the categories, or one figure, with matplotlib.

        A diagram has the categories as a strip along x, and above it as points the `extremes` or the `beat_intervals`
        of each cell, or a figure.

        Parameters
        ----------
        figure : str
            "category" or the name of a figure. Of a diagram "category" draws "extremes".
        direction : str, optional
            The first one of the chart without it.
        ax : matplotlib.axes.Axes, optional
            Where to draw; the current ones without it.
        **style
            Goes to `Axes.pcolormesh`, of a diagram to `Axes.plot`.

        Returns
        -------
        matplotlib.axes.Axes

        Examples
        --------
        >>> import matplotlib, stridor
        >>> matplotlib.use("agg")
        >>> chart = stridor.chart(stridor.case("noise-chart"), x=stridor.axis("preload", 2, 4000, 4),
        ...                       y=stridor.axis("mu_d", 0.0, 0.8, 4))
        >>> chart.plot("category", direction="going").get_title()
        'going'
        """
        ax = _chart_parts.prepared(self, ax)
        way = self._direction(direction)
        if self.y is None:
            _chart_parts.draw_diagram(self, figure, way, ax, style)
        elif figure == "category":
            _chart_parts.draw_categories(self, way, ax, style)
        else:
            _chart_parts.draw_figure(self, figure, way, ax, style)
        ax.set_title(self.directions[way])
        return ax

    def plot_boundaries(self, *, direction: Optional[str] = None, ax: Any = None, **style: Any) -> Any:
        """Draws the lines between the categories.

        Parameters
        ----------
        direction : str, optional
            The first one of the chart without it.
        ax : matplotlib.axes.Axes, optional
        **style
            Goes to `Axes.plot`.

        Returns
        -------
        matplotlib.axes.Axes

        Examples
        --------
        >>> import matplotlib, stridor
        >>> matplotlib.use("agg")
        >>> chart = stridor.chart(stridor.case("noise-chart"), x=stridor.axis("preload", 2, 4000, 4),
        ...                       y=stridor.axis("mu_d", 0.0, 0.8, 4))
        >>> chart.plot_boundaries(direction="going", color="k").get_xscale()
        'log'
        """
        ax = _chart_parts.prepared(self, ax)
        _chart_parts.draw_boundaries(self, self._direction(direction), ax, style)
        return ax

    def svg(self, figure: str = "category") -> str:
        """The picture that `stridor chart` draws.

        Examples
        --------
        >>> import stridor
        >>> chart = stridor.chart(stridor.case("noise-chart"), x=stridor.axis("preload", 2, 4000, 4),
        ...                       y=stridor.axis("mu_d", 0.0, 0.8, 4))
        >>> chart.svg().startswith("<?xml")
        True
        """
        return self._handle.svg(whole_text(figure))

    def _repr_html_(self) -> str:
        svg = self.svg()
        svg = svg[svg.index("<svg") :].replace("<svg", '<svg style="max-width:100%;height:auto;background:white"', 1)
        rows = [(_html.escaped(way), *(f"{_html.badge(name)} {number}" for name, number in self.counts(way).items()))
                for way in self.directions]
        return f'<div style="max-width:60em">{svg}</div>{_html.table(rows)}'

    def __repr__(self) -> str:
        ways = " and ".join(self.directions)
        if self.y is None:
            return f"<diagram over {self.x.parameter}: {len(self.x.values)} cells, {ways}, in {self.folder}>"
        size = f"{len(self.x.values)} by {len(self.y.values)} cells, {ways}"
        return f"<chart over {self.x.parameter} and {self.y.parameter}: {size}, in {self.folder}>"

    def __reduce__(self) -> Tuple[object, ...]:
        with files(f"read the store in {self.folder}"):
            store = (self.folder / "chart.sqlite").read_bytes()
        return _unpickled, (self._handle.toml(), store)


def kept_folder() -> Tuple[Any, pathlib.Path]:
    """A folder, after what it goes with."""
    with files("make a temporary folder"):
        kept = tempfile.TemporaryDirectory(prefix="stridor-chart-")
    return kept, pathlib.Path(kept.name)


def _unpickled(text: str, store: bytes) -> Chart:
    kept, folder = kept_folder()
    with files(f"write into {folder}"):
        (folder / "chart.toml").write_text(text, encoding="utf-8")
        (folder / "chart.sqlite").write_bytes(store)
    chart = open_chart(folder)
    chart._kept = kept
    return chart


def open_chart(folder: Union[str, os.PathLike[str]]) -> Chart:
    """Opens a finished chart of `chart` or of `stridor chart`, without computing anything.

    Parameters
    ----------
    folder : path
        It holds chart.toml and chart.sqlite.

    Raises
    ------
    Interrupted
        For a chart that lacks cells: `chart` goes on with it.

    Examples
    --------
    >>> import stridor
    >>> chart = stridor.chart(stridor.case("noise-chart"), x=stridor.axis("preload", 2, 4000, 4),
    ...                       y=stridor.axis("mu_d", 0.0, 0.8, 4), out="small")
    >>> stridor.open_chart("small").counts() == chart.counts()
    True
    """
    path = pathlib.Path(folder)
    study = _stridor.read_study(str(path / "chart.toml"))
    return Chart(_stridor.open_chart(study, str(path / "chart.sqlite")), path)
