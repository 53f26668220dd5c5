"""Stridor predicts whether a rubbing contact squeals, squeaks, creaks or stays quiet.

Numbers are SI units, angles degrees; text carries its unit. Results are the same bits every time, and those of the
program `stridor`.

Examples
--------
>>> import stridor
>>> case = stridor.case("squeal")
>>> case.contact.preload = "20 N"
>>> stridor.simulate(case).going.category
'squeal'
"""

from . import errors
from . import _stridor
from ._axis import Axis, axis
from ._case import Case, case, case_names, from_toml, read
from ._chart_parts import Boundary, ChartAxis
from ._chart_run import chart
from ._charts import Chart, open_chart
from ._design import Advice, Stability, StabilityDirection, advise, stability
from ._evaluate import evaluate, words
from ._ends import EndState, Following, end_state, follow, read_end_state
from ._explorer import Explorer, explore
from ._motion import Margin, Motion, Phase, PhaseVerdict, simulate
from ._page import Page, page
from ._sounds import Hearing, Library, Recording, Sound, library, listen, read_sound
from ._strokes import StrokeHistory, strokes
from ._structure import structure
from ._table import Table, table
from .errors import Error, FileError, InputError, Interrupted, NumericalError, Place

__version__: str = _stridor.version

__all__ = [
    "Advice", "Axis", "Boundary", "Case", "Chart", "ChartAxis", "EndState", "Error", "Explorer", "FileError",
    "Following", "Hearing", "InputError", "Interrupted", "Library", "Margin", "Motion", "NumericalError", "Page",
    "Phase", "PhaseVerdict", "Place", "Recording", "Sound", "Stability", "StabilityDirection", "StrokeHistory", "Table",
    "advise", "axis", "case", "case_names", "chart", "end_state", "errors", "evaluate", "explore", "follow",
    "from_toml", "library", "listen", "open_chart", "page", "read", "read_end_state", "read_sound", "simulate",
    "stability", "strokes", "structure", "table", "words",
]
