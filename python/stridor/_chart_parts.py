"""What a finished chart is made of, and how matplotlib draws it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, List, NamedTuple, Tuple

import numpy

from . import _stridor
from ._optional import needed

if TYPE_CHECKING:
    from ._charts import Chart

__all__ = ["Boundary", "ChartAxis"]

# those of the program's own pictures
_colours = {"none": "#E6E6E6", "squeal": "#BB5566", "squeak": "#DDAA33", "creak": "#004488", "undecided": "#BBBBBB",
            "not_done": "#FFFFFF"}


class ChartAxis(NamedTuple):
    """One axis of a finished chart.

    Examples
    --------
    >>> import stridor
    >>> chart = stridor.chart(stridor.case("noise-chart"), x=stridor.axis("preload", 5, 50, 3),
    ...                       y=stridor.axis("mu_d", 0.2, 0.6, 3))
    >>> chart.x.parameter, chart.x.unit, chart.x.name
    ('contact.preload', 'N', 'preload')
    """

    parameter: str
    """Its key."""
    unit: str
    """"1" without a dimension."""
    sentence: str
    """What it is."""
    scale: str
    """"linear" or "log"."""
    values: Any
    """[unit] numpy array."""

    @property
    def name(self) -> str:
        """The last part of the key."""
        return self.parameter.split(".")[-1]

    @property
    def label(self) -> str:
        """For a figure: what it is, with its unit."""
        name = self.name.replace("_", " ")
        return name if self.unit == "1" else f"{name} [{self.unit}]"


class Boundary(NamedTuple):
    """A line between two categories.

    Examples
    --------
    >>> import stridor
    >>> chart = stridor.chart(stridor.case("noise-chart"), x=stridor.axis("preload", 2, 4000, 4),
    ...                       y=stridor.axis("mu_d", 0.0, 0.8, 4), directions="going")
    >>> line = chart.boundaries()[0]
    >>> line.direction, line.first, line.points.shape[1]
    ('going', 'none', 2)
    """

    direction: str
    first: str
    """The category on one side, or the status of cells without one."""
    second: str
    """That on the other."""
    is_closed: bool
    points: Any
    """(x, y) of each vertex in the units of the axes; numpy array, shape (vertex, 2)."""


def prepared(chart: Chart, ax: Any) -> Any:
    """The axes to draw into, with the scales and names of the chart's."""
    pyplot = needed("matplotlib.pyplot", "a plot")
    ax = pyplot.gca() if ax is None else ax
    ax.set_xscale(chart.x.scale)
    ax.set_xlabel(chart.x.label)
    if chart.y is not None:
        ax.set_yscale(chart.y.scale)
        ax.set_ylabel(chart.y.label)
    return ax


def draw_categories(chart: Chart, way: int, ax: Any, style: Dict[str, Any]) -> None:
    """Cells in the colours of their categories, and what these mean."""
    colors, patches = needed("matplotlib.colors", "a plot"), needed("matplotlib.patches", "a plot")
    words = [*_stridor.words["category"], "not_done"]
    numbers = chart.numbers("category")[way].astype(int) % len(words)  # -1 is the last word
    colours = colors.ListedColormap([_colours[word] for word in words])
    # a diagram's strip: two equal rows, for one has no height
    rows, numbers = ([0.0, 1.0], numpy.stack([numbers, numbers])) if chart.y is None else (chart.y.values, numbers)
    ax.pcolormesh(chart.x.values, rows, numbers, cmap=colours, vmin=-0.5, vmax=len(words) - 0.5,
                  **{"shading": "nearest", **style})
    there = [words[number] for number in numpy.unique(numbers)]
    handles = [patches.Patch(facecolor=_colours[word], edgecolor="0.4", label=word) for word in there]
    ax.legend(handles=handles, loc="upper left", bbox_to_anchor=(1.0, 1.0), frameon=False)


def _ragged(rows: List[List[float]], shape: Tuple[int, ...]) -> Any:
    """Rows of different length as an array; shape (*shape, most), NaN beyond the end of each."""
    whole = numpy.full((len(rows), max(map(len, rows))), numpy.nan)
    for place, row in zip(whole, rows):
        place[: len(row)] = row
    return whole.reshape((*shape, -1))


def diagram_columns(chart: Chart) -> Dict[str, Tuple[Tuple[str, ...], Any, Dict[str, str]]]:
    """What a diagram has of each cell beside a chart's figures, as a dataset has it."""
    extremes, intervals = zip(*chart._handle.diagram(0))
    shape, dimensions = (len(chart.directions), len(chart.x.values)), ("direction", chart.x.name)
    return {
        "extremes": ((*dimensions, "extreme"), _ragged(list(extremes), shape),
                     {"units": "m", "long_name": "displacements x1 at which the joint turns, in the judged part"}),
        "beat_intervals": ((*dimensions, "beat"), _ragged(list(intervals), shape),
                           {"units": "s", "long_name": "times between like changes of contact state, in that part"}),
    }


def with_diagram(chart: Chart, data: Any) -> Any:
    """A dataset over one axis: without the dimension that has one value, and with the diagram's columns."""
    rest = next(name for name, size in data.sizes.items() if size == 1 and name not in ("direction", chart.x.name))
    return data.squeeze(rest).assign(diagram_columns(chart))


def draw_diagram(chart: Chart, name: str, way: int, ax: Any, style: Dict[str, Any]) -> None:
    """Points above their places on the x axis, and the categories as a strip below them."""
    columns = diagram_columns(chart)
    name = "extremes" if name == "category" else name
    if name in columns:
        values, unit = columns[name][1][way], columns[name][2]["units"]
    else:
        values = chart.figure(name)[way][:, None]
        unit = {figure: unit for figure, unit, _ in _stridor.cell_figures()}[name]
    x = numpy.broadcast_to(chart.x.values[:, None], values.shape)
    there = numpy.isfinite(values)
    ax.plot(x[there], values[there], **{"linestyle": "none", "marker": ".", "markersize": 2.0, "color": "k", **style})
    label = name.replace("_", " ")
    ax.set_ylabel(label if unit == "1" else f"{label} [{unit}]")
    strip = ax.inset_axes([0.0, 1.02, 1.0, 0.05], sharex=ax)
    strip.set_axis_off()
    draw_categories(chart, way, strip, {})


def draw_figure(chart: Chart, name: str, way: int, ax: Any, style: Dict[str, Any]) -> None:
    """Cells coloured by a figure, and its scale."""
    assert chart.y is not None
    mesh = ax.pcolormesh(chart.x.values, chart.y.values, chart.figure(name)[way], **{"shading": "nearest", **style})
    unit = {figure: unit for figure, unit, _ in _stridor.cell_figures()}[name]
    label = name.replace("_", " ")
    ax.figure.colorbar(mesh, ax=ax, label=label if unit == "1" else f"{label} [{unit}]")


def draw_boundaries(chart: Chart, way: int, ax: Any, style: Dict[str, Any]) -> None:
    """The lines of one direction."""
    for line in chart.boundaries():
        if line.direction != chart.directions[way]:
            continue
        if chart.y is None:
            ax.axvline(line.points[0, 0], **{"color": "k", "linewidth": 1.0, **style})
            continue
        points = numpy.concatenate([line.points, line.points[:1]]) if line.is_closed else line.points
        ax.plot(points[:, 0], points[:, 1], **{"color": "k", "linewidth": 1.0, **style})
