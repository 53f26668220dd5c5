"""What to expect of a design, and what to change."""

from __future__ import annotations

import json
from typing import Any, Dict, List, Mapping, Optional, Sequence, Union

import numpy

from . import _html, _stridor
from ._axis import Axis
from ._case import CaseOrName, as_case
from ._evaluate import Progress, _list, _shown
from ._given import plain_text, whole
from ._optional import needed
from .errors import InputError

__all__ = ["Advice", "Stability", "StabilityDirection", "advise", "stability"]


class _Document:
    """A document of the program; it compares and pickles as such."""

    def __init__(self, text: str) -> None:
        self._document: Dict[str, Any] = json.loads(text)

    def to_dict(self) -> Dict[str, Any]:
        """All that the program prints with --json."""
        copy: Dict[str, Any] = json.loads(json.dumps(self._document))
        return copy

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and self._document == getattr(other, "_document")

    __hash__ = None  # type: ignore[assignment]


class StabilityDirection:
    """Steady sliding in one direction.

    Attributes
    ----------
    direction : str
        "going" or "coming".
    kind : str
        "stable", "flutter" (mode coupling), "divergence" or another, as docs/methods/stability.md has it.
    growth : float
        Of the mode that grows most [1/s].
    frequency : float
        Its frequency [Hz].
    values, growths, frequencies : numpy.ndarray
        Along the quantity that was followed [its unit], [1/s], [Hz]; empty without one.
    kinds : list of str
        Their kinds, in the order of `growths`.
    boundaries : list of float
        Where the kind changes [the quantity's unit].

    Examples
    --------
    >>> import stridor
    >>> stridor.stability(stridor.case("squeal")).coming.kind
    'stable'
    """

    def __init__(self, document: Mapping[str, Any]) -> None:
        self.direction: str = document["direction"]
        self.kind: str = document["kind"]
        self.growth = _number(document["growth"])
        self.frequency = _number(document["frequency"])
        points = document["points"]
        self.values: Any = numpy.array([point["value"] for point in points], dtype=float)
        self.growths: Any = numpy.array([_number(point["growth"]) for point in points], dtype=float)
        self.frequencies: Any = numpy.array([_number(point["frequency"]) for point in points], dtype=float)
        self.kinds: List[str] = [point["kind"] for point in points]
        self.boundaries: List[float] = [boundary["value"] for boundary in document["boundaries"]]

    def __repr__(self) -> str:
        return f"<{self.direction} {self.kind}, growth {self.growth:.4g} 1/s at {self.frequency:.4g} Hz>"


def _number(value: Optional[float]) -> float:
    return float("nan") if value is None else float(value)


class Stability(_Document):
    """Stability of steady sliding. `stability` makes it.

    Examples
    --------
    >>> import stridor
    >>> stridor.stability(stridor.case("squeal")).going.kind
    'flutter'
    """

    @property
    def going(self) -> StabilityDirection:
        """With the plate's velocity positive."""
        return StabilityDirection(self._document["directions"][0])

    @property
    def coming(self) -> StabilityDirection:
        """With it negative."""
        return StabilityDirection(self._document["directions"][1])

    def plot(self, *, direction: str = "going", ax: Any = None, **style: Any) -> Any:
        """Draws the growth rate along the quantity that was followed.

        Returns
        -------
        matplotlib.axes.Axes

        Examples
        --------
        >>> import matplotlib, stridor
        >>> matplotlib.use("agg")
        >>> scan = stridor.stability(stridor.case("squeal"), over=stridor.axis("mu_d", 0, 0.8))
        >>> scan.plot(direction="going").get_ylabel()
        'growth [1/s]'
        """
        if direction not in ("going", "coming"):
            raise InputError(f'there is no direction "{direction}". Choose going or coming.')
        if "over" not in self._document:
            raise InputError("there is nothing to draw (no quantity was followed). Give `over`.")
        pyplot = needed("matplotlib.pyplot", "a plot")
        ax = pyplot.gca() if ax is None else ax
        way = self.going if direction == "going" else self.coming
        ax.plot(way.values, way.growths, **style)
        ax.axhline(0.0, color="0.5", linewidth=0.8)
        over = self._document["over"]
        unit = "" if over["unit"] == "1" else f" [{over['unit']}]"
        ax.set_xlabel(over["parameter"].split(".")[-1].replace("_", " ") + unit)
        ax.set_ylabel("growth [1/s]")
        return ax

    def __repr__(self) -> str:
        return f"<stability: {self.going!r}, {self.coming!r}>"

    def _repr_html_(self) -> str:
        rows = [(way.direction, _html.escaped(way.kind), f"{way.growth:.4g} 1/s", f"{way.frequency:.4g} Hz",
                 ", ".join(f"{value:.5g}" for value in way.boundaries)) for way in (self.going, self.coming)]
        return _html.table(rows, ("direction", "kind", "growth", "frequency", "boundaries"))


def stability(case: CaseOrName, *, over: Optional[Axis] = None) -> Stability:
    """Complex eigenvalues of steady sliding: mode coupling (flutter) and sprag-slip (divergence).

    Parameters
    ----------
    case : Case or str
        The name of one that comes along will do.
    over : Axis, optional
        A quantity to follow; its scale does not matter. Kinetic friction may go beyond static friction here.

    Returns
    -------
    Stability

    Examples
    --------
    >>> import stridor
    >>> scan = stridor.stability(stridor.case("squeal"), over=stridor.axis("contact.kinetic_friction", 0, 0.8))
    >>> [round(boundary, 5) for boundary in scan.going.boundaries]
    [0.44942]
    """
    if over is not None and not isinstance(over, Axis):
        raise InputError(f"{over!r} is no axis. Make one by stridor.axis.")
    text = "" if over is None else over._replace(scale=None).text
    return Stability(_stridor.stability(as_case(case)._handle, text))


class Advice(_Document):
    """What keeps a design quiet. `advise` makes it.

    Examples
    --------
    >>> import stridor
    >>> advice = stridor.advise(stridor.case("squeal"), over=["preload"])
    >>> advice.category, [margin["key"] for margin in advice.margins]
    ('squeal', ['contact.preload'])
    """

    @property
    def headline(self) -> str:
        """What the design does, in a few words, and how close to noise it is where it is quiet: report, page and
        `stridor advise` begin with the same.
        """
        return str(self._document["headline"])

    @property
    def category(self) -> str:
        """Of the design as it is, judged both ways and from every start: that of its loudest phase."""
        return str(self._document["present"]["category"])

    @property
    def margins(self) -> List[Dict[str, Any]]:
        """For each quantity how far it is from another verdict, below and above; `to_dict` has the units."""
        return list(self.to_dict()["margins"])

    @property
    def changes(self) -> List[Dict[str, Any]]:
        """Verified changes that make it quiet, the smallest first; none of a quiet design."""
        return list(self.to_dict()["changes"])

    @property
    def change(self) -> Optional[Dict[str, Any]]:
        """The one that is recommended."""
        change: Optional[Dict[str, Any]] = self.to_dict()["change"]
        return change

    @property
    def changed(self) -> Optional[Dict[str, Any]]:
        """The design that the recommended change leads to: its headline, what lies near, its chance of noise."""
        changed: Optional[Dict[str, Any]] = self.to_dict()["changed"]
        return changed

    @property
    def chance(self) -> Optional[Dict[str, Any]]:
        """The chance of noise within the tolerances, with the ends of its interval; without tolerances of a quiet
        design alone, within those that parts usually have.
        """
        chance: Optional[Dict[str, Any]] = self.to_dict().get("chance")
        return chance

    @property
    def runs(self) -> int:
        """How many motions were simulated."""
        return int(self._document["runs"])

    def __repr__(self) -> str:
        return f"<advice on a design that is {self.category}: {len(self.changes)} quieting changes, {self.runs} runs>"


def advise(
    case: CaseOrName,
    *,
    over: Union[Sequence[str], Mapping[str, str]] = (),
    tolerances: Optional[Mapping[str, object]] = None,
    directions: Sequence[str] = (),
    starts: Sequence[str] = (),
    samples: int = 1024,
    threads: int = 0,
    progress: Progress = False,
) -> Advice:
    """How far a design is from another verdict, the smallest change that makes it quiet, the chance of noise.

    Parameters
    ----------
    case : Case or str
        The name of one that comes along will do.
    over : sequence of str, or mapping
        Quantities that may be changed, within their usual range, or by name their range ("5:50 N"); without it all
        that have a usual range.
    tolerances : mapping, optional
        By quantity its tolerance, as text: "10 %", "2 N", "0.05 normal"; a number is in the quantity's unit.
    directions : sequence of str
        "going" or "coming": judge this way of moving alone; without it both.
    starts : sequence of str
        "rest", "stuck", "sliding": judge motions that begin so; without it all that the case can begin with.
    samples : int
        [1] Designs sampled within the tolerances.
    threads : int
        [1] 0: one per processor this process may use.
    progress : bool or callable
        As of `evaluate`; it is told percents.

    Returns
    -------
    Advice
        The same for any number of threads.

    Examples
    --------
    >>> import stridor
    >>> advice = stridor.advise(stridor.case("squeal"), over={"preload": "5:50"}, tolerances={"preload": "10 %"},
    ...                         samples=64)
    >>> advice.chance["noise"]
    1.0
    """
    of = as_case(case)
    asked = [f"{name}={ends}" for name, ends in over.items()] if isinstance(over, Mapping) else _list(over)
    amounts = [f"{name}={plain_text(amount)}" for name, amount in (tolerances or {}).items()]
    designs, count = _count(samples), whole("threads", threads)
    show, close = _shown(progress, "%")
    try:
        return Advice(
            _stridor.advise(of._handle, asked, amounts, (_list(directions), _list(starts)), designs, count, show)
        )
    finally:
        close()


def _count(samples: int) -> int:
    count = whole("samples", samples)
    if count < 1:
        raise InputError(f"samples = {samples} is out of range. Take one at least.")
    return count
