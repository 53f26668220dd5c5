"""Computing charts."""

from __future__ import annotations

import os
import pathlib
from typing import Optional, Sequence, Union

from . import _stridor
from ._axis import Axis
from ._case import CaseOrName, as_case
from ._charts import Chart, kept_folder, open_chart
from ._evaluate import Progress, _list, _shown
from ._given import files, whole
from ._launch import launched, put_study
from .errors import InputError, Interrupted

__all__ = ["chart"]


def chart(
    case: CaseOrName,
    *,
    x: Axis,
    y: Optional[Axis] = None,
    directions: Union[str, Sequence[str]] = ("going", "coming"),
    refine: int = 0,
    starts: Sequence[str] = (),
    out: Union[str, os.PathLike[str], None] = None,
    threads: int = 0,
    progress: Progress = False,
    launcher: Sequence[str] = (),
) -> Chart:
    """Computes a chart over two quantities, on all processors, as `stridor chart` does; over one it is a diagram.

    With a folder it goes on where it was stopped, be it by Ctrl-C, by a kill or by the program; another chart's folder
    is refused. In the end chart.toml, chart.csv, boundaries.csv and chart.nc stand there, too, and of a diagram
    diagram.csv.

    Parameters
    ----------
    case : Case or str
        The name of one that comes along will do.
    x, y : Axis
        What `axis` makes. Without y each cell of the diagram also has the turns of the joint's motion and the times
        between its beats: `Chart.to_xarray`.
    directions : "going", "coming", or both
        A constant drive is run once for each, with V = +-abs(velocity).
    refine : int
        [1] 0 computes every cell; 1 to 6 begin with every 2nd to 64th point and halve that only where cells differ.
    starts : sequence of {"rest", "stuck", "sliding", "given"}
        Each cell is run from all of them and shows the worst; without them from the case's own.
    out : path, optional
        The folder. Without it the chart is kept as long as the object.
    threads : int
        [1] 0: one per processor this process may use.
    progress : bool or callable
        True: a bar of tqdm, where it is installed. A function is called ten times a second with the cells done, those
        to do as far as known, and a dictionary of how many there are of each kind; what it raises ends the work.
    launcher : sequence of str, optional
        What starts a program on several ranks: ["mpirun", "-n", "64"]. The program `stridor-mpi` then computes the
        chart in `out`, which all ranks must see; `threads` are those of a rank. Progress is what `stridor chart-status`
        says.

    Returns
    -------
    Chart

    Raises
    ------
    InputError
        For axes that make no chart, and for the folder of another one.
    Interrupted
        When it was stopped: the same call goes on.

    Examples
    --------
    >>> import stridor
    >>> chart = stridor.chart(stridor.case("noise-chart"), x=stridor.axis("contact.preload", 2, 4000, 8, scale="log"),
    ...                       y=stridor.axis("contact.kinetic_friction", 0, 0.8, 8), refine=2, out="pair")
    >>> chart.counts("going")["creak"] > 0
    True
    >>> stridor.chart(stridor.case("squeal"), x=stridor.axis("mu_d", 0.2, 0.8, 4)).to_xarray().extremes.dims
    ('direction', 'kinetic_friction', 'extreme')
    """
    study = _stridor.study(as_case(case)._handle, _axis_text(x), "" if y is None else _axis_text(y), _list(directions),
                           _list(starts), ["category"], whole("refine", refine))
    threads = whole("threads", threads)
    if launcher:
        return _of_launcher(launcher, study, out, threads, progress)
    kept, folder = (None, pathlib.Path(out)) if out is not None else kept_folder()
    _make(folder)
    if not (folder / "chart.sqlite").exists():
        put_study(study, folder / "chart.toml")
    show, close = _shown(progress, "cell")
    try:
        handle = _stridor.compute(study, str(folder / "chart.sqlite"), threads, show)
    except Interrupted as error:
        raise error if kept is None else _nothing_kept(error) from None
    finally:
        close()
    if out is not None:
        handle.write_tables(str(folder))
    return Chart(handle, folder, kept)


def _of_launcher(launcher: Sequence[str], study: _stridor.StudyHandle, out: Union[str, os.PathLike[str], None],
                 threads: int, progress: Progress) -> Chart:
    if out is None:
        raise InputError("a chart of several ranks has no folder (all of them must see it). Say out=...")
    if progress:
        raise InputError("a launcher tells no progress (its program runs elsewhere). Ask `stridor chart-status`.")
    folder = pathlib.Path(out)
    _make(folder)
    launched(launcher, study, folder, threads)
    return open_chart(folder)


def _make(folder: pathlib.Path) -> None:
    with files(f"make the folder {folder}"):
        folder.mkdir(parents=True, exist_ok=True)


def _axis_text(axis: object) -> str:
    if not isinstance(axis, Axis):
        raise InputError(f"{axis!r} is no axis. Make one by stridor.axis.")
    return axis.text


def _nothing_kept(error: Interrupted) -> Interrupted:
    """The same of a chart whose folder goes with it."""
    why, suggestion = "a chart without a folder keeps nothing", "Give `out` a folder, and it goes on from there."
    return Interrupted(f"{error.what} ({why}). {suggestion}", [(error.what, why, suggestion, None)])
