"""One run of a case and what it leaves behind."""

from __future__ import annotations

import json
from typing import Any, Dict, List, NamedTuple, Optional, Tuple, Union

from . import _fields, _html, _stridor
from ._case import Case, CaseOrName, as_case
from ._ends import EndState
from ._evaluate import _named
from ._given import plain
from ._optional import needed
from .errors import InputError

__all__ = ["Margin", "Motion", "Phase", "PhaseVerdict", "simulate"]

Time = Union[float, str, None]


class Margin(NamedTuple):
    """A figure beside the threshold it was held against.

    Examples
    --------
    >>> import stridor
    >>> stridor.simulate(stridor.case("squeal")).going.verdict.margins[0].threshold_name
    'quiet_slip'
    """

    threshold_name: str
    """The key of the threshold in [verdict]."""
    figure_name: str
    """What was held against it, in words."""
    figure: float
    """[the threshold's unit]"""
    threshold: float
    """[its unit]"""
    distance: float
    """figure - threshold [its unit]"""


class PhaseVerdict:
    """What a phase is called, and why.

    Attributes
    ----------
    category : str
        "none", "squeal", "squeak", "creak" or "undecided".
    quiet_because : str
        "slides", "sticks" or "locks", of a phase without noise; else "no". What locks is no quiet design.
    reasons : list of str
        Sentences, in the order of the rules.
    warnings : list of str
        What to know beside the category.
    margins : list of Margin
        The figures beside their thresholds.

    Examples
    --------
    >>> import stridor
    >>> stridor.simulate(stridor.case("quiet")).going.verdict.quiet_because
    'slides'
    """

    __slots__ = ("category", "quiet_because", "reasons", "warnings", "margins")
    category: str
    quiet_because: str
    reasons: List[str]
    warnings: List[str]
    margins: List[Margin]

    def __init__(self, phase: Dict[str, Any]) -> None:
        self.category = phase["category"]
        self.quiet_because = phase["quiet_because"]
        self.reasons = phase["reasons"]
        self.warnings = phase["warnings"]
        self.margins = [Margin(*margin) for margin in phase["margins"]]

    def __repr__(self) -> str:
        return f"<verdict {self.category}: {' '.join(self.reasons)}>"

    def _repr_html_(self) -> str:
        reasons = "".join(f"<li>{_html.escaped(reason)}</li>" for reason in self.reasons)
        return f"{_html.badge(self.category)}<ul>{reasons}</ul>"


class Phase(_fields.Figures):
    """The motion while the plate goes one way: its verdict and its figures, by name.

    All figures are attributes: `frequency` [Hz], `regularity` [1], `slip`, `stick` and `separation` (shares of the
    time in each state [1]), `joint_level` [dB re 1e-9 m/s] and more; NaN where there is none.

    Attributes
    ----------
    name : str
        "going" (V > 0), "coming" (V < 0), or "all" of a drive that never turns round.
    verdict : PhaseVerdict
    judged_time : float
        The time that was judged [s].

    Examples
    --------
    >>> import stridor
    >>> going = stridor.simulate(stridor.case("squeal")).going
    >>> going.category, round(going.frequency, 1), round(going.separation, 3)
    ('squeal', 428.5, 0.679)
    """

    __slots__ = ("name", "verdict", "judged_time")
    name: str
    verdict: PhaseVerdict
    judged_time: float

    def __init__(self, phase: Dict[str, Any]) -> None:
        super().__init__(phase["figures"])
        self.name = phase["phase"]
        self.judged_time = phase["judged_time"]
        self.verdict = PhaseVerdict(phase)

    @property
    def category(self) -> str:
        """The verdict's category."""
        return self.verdict.category

    @property
    def figures(self) -> Dict[str, float]:
        """All figures by name."""
        return dict(self._figures)

    def __repr__(self) -> str:
        return f"<phase {self.name}: {_word(self)}, {self.frequency:.4g} Hz>"


def _word(phase: Phase) -> str:
    """Return how a phase is called in one word: a contact that locks is silent, and no quiet one."""
    return "locks" if phase.verdict.quiet_because == "locks" else phase.category


class Motion:
    """A motion: how it is called in each phase, and the motion itself on demand.

    Made by `simulate`. It pickles without being computed again.

    Attributes
    ----------
    case : Case
        A copy of what was simulated.
    phases : list of Phase

    Examples
    --------
    >>> import stridor
    >>> motion = stridor.simulate(stridor.case("squeal"))
    >>> [(phase.name, phase.category) for phase in motion.phases]
    [('going', 'squeal'), ('coming', 'none')]
    """

    __slots__ = ("case", "_run", "_phases", "_document")
    case: Case
    _run: Optional[_stridor.RunHandle]
    _phases: Optional[List[Dict[str, Any]]]
    _document: Optional[str]

    def __init__(self, case: Case, run: Optional[_stridor.RunHandle]) -> None:
        self.case = case
        self._run = run
        self._phases = None
        self._document = None

    def _read(self) -> Tuple[List[Dict[str, Any]], str]:
        if self._phases is None or self._document is None:
            assert self._run is not None
            self._phases = self._run.phases()
            self._document = self._run.json()
            self._run = None  # it holds a megabyte for each phase
        return self._phases, self._document

    @property
    def phases(self) -> List[Phase]:
        """Going and coming, or the only one."""
        return [Phase(phase) for phase in self._read()[0]]

    def _phase(self, name: str) -> Phase:
        for phase in self.phases:
            if phase.name == name:
                return phase
        names = " and ".join(phase.name for phase in self.phases)
        raise AttributeError(f"this motion has no phase {name}; it has {names}")

    @property
    def going(self) -> Phase:
        """The phase in which the plate's velocity is positive."""
        return self._phase("going")

    @property
    def coming(self) -> Phase:
        """The phase in which the plate's velocity is negative."""
        return self._phase("coming")

    @property
    def whole(self) -> Phase:
        """The only phase of a drive that never turns round."""
        return self._phase("all")

    def to_dict(self) -> Dict[str, Any]:
        """All that `stridor simulate --json` prints: case, outcome, energy, phases, contacts and units.

        Examples
        --------
        >>> import stridor
        >>> stridor.simulate(stridor.case("squeal")).to_dict()["outcome"]["reason"]
        'completed'
        """
        document: Dict[str, Any] = json.loads(self._read()[1])
        return document

    def trace(self, start: Time = None, stop: Time = None, interval: Union[float, str] = "20 us") -> Any:
        """The sampled motion. The run is done once more: a motion keeps no samples.

        Parameters
        ----------
        start, stop : float or str, optional
            From when to when [s]; without them from the beginning to the end.
        interval : float or str
            Between samples [s].

        Returns
        -------
        xarray.Dataset
            As `stridor simulate --trace FILE.nc` writes it: displacement [m], velocity [m/s] and acceleration
            [m/s^2] over (dof, time), forces [N] and gap [m] over time, and the contact's state, a word. The
            attributes say where it came from: the program with version and commit, and the case with its engine.

        Examples
        --------
        >>> import stridor
        >>> trace = stridor.simulate(stridor.case("squeal")).trace(0.2, 0.21)
        >>> trace.velocity.sel(dof="x1").shape, trace.velocity.units
        ((501,), 'm/s')
        >>> int((trace.state == "slip").sum()) > 0
        True
        """
        xarray = needed("xarray", "a trace")
        parts = _stridor.trace(self.case._handle, _time_text(start), _time_text(stop), _time_text(interval))
        if not parts["states"].size:
            raise InputError(f"a trace from {start} to {stop} has no samples (the run ends before)")
        variables = {name: (dimensions, array, {"units": unit, "long_name": sentence})
                     for name, dimensions, array, unit, sentence in parts["columns"]}
        variables["state"] = (variables["gap"][0], *_states(parts["states"]))
        dofs = ("dof", parts["dofs"], {"long_name": "degree of freedom"})
        coordinates = {"time": variables.pop("time"), "dof": dofs}
        return xarray.Dataset(variables, coordinates, _stridor.origin(self.case._handle, "trace"))

    def history(self) -> Any:
        """All stays of the contacts in their states. The run is done once more.

        Returns
        -------
        xarray.Dataset
            Over `interval`: contact (its number, from 1), state (a word), from and to [s], slip_velocity and
            gap_velocity at the beginning [m/s]; in the attributes where it came from, as of a trace.

        Examples
        --------
        >>> import stridor
        >>> history = stridor.simulate(stridor.case("squeal")).history()
        >>> float(history["from"][0]), history["to"].units
        (0.0, 's')
        """
        xarray = needed("xarray", "a history")
        contacts, states, columns = _stridor.history(self.case._handle)
        variables: Dict[str, Any] = {name: ("interval", array, {"units": unit, "long_name": sentence})
                                     for name, array, unit, sentence in columns}
        variables["contact"] = ("interval", contacts, {"units": "1", "long_name": "number of the contact, from 1"})
        variables["state"] = ("interval", *_states(states))
        return xarray.Dataset(variables, attrs=_stridor.origin(self.case._handle, "history"))

    def __getstate__(self) -> Tuple[Any, ...]:
        return (self.case, *self._read())

    def __setstate__(self, state: Tuple[Any, ...]) -> None:
        self.case, self._phases, self._document = state
        self._run = None

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Motion):
            return NotImplemented
        return self.case == other.case and self._read()[1] == other._read()[1]

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"<motion of {self.case.title!r}: " + ", ".join(f"{p.name} {_word(p)}" for p in self.phases) + ">"

    def _repr_html_(self) -> str:
        rows = [(_html.escaped(phase.name), _html.badge(phase.category), f"{phase.slip:.1%}", f"{phase.stick:.1%}",
                 f"{phase.separation:.1%}", f"{phase.frequency:.1f} Hz", _level_text(phase.joint_level),
                 _html.escaped(" ".join(phase.verdict.reasons))) for phase in self.phases]
        heading = ("phase", "category", "slip", "stick", "separation", "frequency", "level", "why")
        return f"<p><b>{_html.escaped(self.case.title)}</b></p>" + _html.table(rows, heading)


def _level_text(level: float) -> str:
    return f"{level:.1f} dB" if level > 0.0 else "-"


def _time_text(time: Time) -> str:
    given = "" if time is None else plain(time)
    return given if isinstance(given, str) else f"{given!r} s"


def _states(numbers: Any) -> Tuple[Any, Dict[str, str]]:
    """Words, and what they are."""
    return _named(numbers, _stridor.contact_states, ""), {"long_name": "contact state"}


def simulate(case: CaseOrName, start: Optional[EndState] = None) -> Motion:
    """Runs a case.

    Other Python threads go on meanwhile. Ctrl-C ends it within a tenth of a second.

    Parameters
    ----------
    case : Case or str
        The name of one that comes along will do.
    start : EndState, optional
        Goes on with that run of the same case: `run.duration` counts from its begin, and the window lies behind it.
        Each number is that of one run without a break.

    Returns
    -------
    Motion
        The same bits every time.

    Raises
    ------
    NumericalError
        For a motion that has no end.
    Interrupted
        When it was stopped.

    Examples
    --------
    >>> import stridor
    >>> motion = stridor.simulate(stridor.case("squeal"))
    >>> motion.going.category
    'squeal'
    >>> print(motion.going.verdict.reasons[-1])
    states alternate regularly (regularity 0.997)
    """
    of = as_case(case).copy()
    return Motion(of, _stridor.simulate(of._handle, start.to_json() if start is not None else ""))
