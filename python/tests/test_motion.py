"""One run: verdict, figures, trace."""

import json
import math
import pathlib
import pickle

import pytest
from conftest import needed

import stridor


def test_a_verdict_is_what_the_program_says(squeal, program):
    squeal.save("squeal.toml")
    document = json.loads(program("simulate", "squeal.toml", "--json"))
    motion = stridor.simulate(squeal)
    for phase, said in zip(motion.phases, document["phases"]):
        assert phase.name == said["phase"]
        assert phase.category == said["verdict"]["category"]
        assert phase.verdict.reasons == said["verdict"]["reasons"]
        assert phase.slip == said["verdict"]["rates"]["slip"]
        mine = [None if math.isnan(margin.distance) else margin.distance for margin in phase.verdict.margins]
        assert mine == [margin["distance"] for margin in said["verdict"]["margins"]]
    assert motion.to_dict() == document


def test_every_figure_of_the_table_is_an_attribute(squeal):
    going = stridor.simulate(squeal).going
    for name, _, sentence in stridor._stridor.phase_figures():
        value = getattr(going, name)
        assert value == going.figures[name] or value != value
        assert sentence in getattr(type(going), name).__doc__
    with pytest.raises(AttributeError):
        going.loudness


def test_a_drive_one_way_has_one_phase(squeal):
    squeal.set({"drive.kind": "constant", "drive.velocity": 0.1})
    motion = stridor.simulate(squeal)
    assert motion.whole.name == "all"
    with pytest.raises(AttributeError, match="no phase going"):
        motion.going


def test_a_motion_pickles_without_running(squeal):
    motion = stridor.simulate(squeal)
    again = pickle.loads(pickle.dumps(motion))
    assert again == motion
    assert again.going.frequency == motion.going.frequency
    assert again._run is None


def test_a_motion_keeps_the_case_it_was_made_of(squeal):
    motion = stridor.simulate(squeal)
    squeal.contact.preload = 4000
    assert motion.case.contact.preload == 20.0


@pytest.mark.parametrize("name", ["squeal", "two-lips", "chain"])
def test_a_trace_is_the_programs_netcdf(name, program):
    xarray = needed("xarray")
    needed("netCDF4")
    case = stridor.case(name)
    case.save("case.toml")
    program("simulate", "case.toml", "--trace", "trace.nc", "--trace-from", "0.2 s", "--trace-to", "0.21 s")
    mine = stridor.simulate(case).trace(0.2, "210 ms")
    with xarray.open_dataset("trace.nc", decode_times=False) as file:
        theirs = file.load().drop_vars([name for name in file.variables if name.startswith("interval")])
    xarray.testing.assert_identical(mine, stridor.words(theirs))


def test_arrays_are_views_that_nobody_writes(squeal):
    numpy = needed("numpy")
    parts = stridor._stridor.trace(squeal._handle, "0 s", "1 ms", "20 us")
    for _, _, array, _, _ in parts["columns"]:
        assert not array.flags.writeable and not array.flags.owndata and array.base is not None
    trace = stridor.simulate(squeal).trace(0, "1 ms")
    assert not trace.gap.values.flags.owndata  # xarray keeps them as they are
    assert numpy.shares_memory(trace.velocity.values, trace.velocity.sel(dof="x1").values)


def test_a_history_has_no_gaps(squeal):
    needed("xarray")
    history = stridor.simulate(squeal).history()
    assert (history["from"].values[1:] == history["to"].values[:-1]).all()
    assert set(history.state.values) == {"slip", "stick", "separation"}


def test_results_say_where_they_came_from(squeal):
    needed("xarray")
    motion = stridor.simulate(squeal)
    points = stridor.evaluate(squeal, {"preload": [20.0, 30.0]}, directions="going")
    for data, schema in ((motion.trace(0, "1 ms"), "trace"), (motion.history(), "history"), (points, "points")):
        assert data.attrs["source"] == f"stridor {stridor.__version__} ({stridor._stridor.commit})"
        assert data.attrs["schema"] == f"stridor.{schema}/1" and data.attrs["title"] == squeal.title
        assert stridor.from_toml(data.attrs["case"]) == squeal and "run.engine = exact" in data.attrs["study"]
    document = motion.to_dict()
    assert document["commit"] == stridor._stridor.commit and document["engine"]["name"] == "exact"
    assert document["version"] == stridor.__version__ and document["case"]["run"]["engine"] == "exact"


def test_states_are_words(squeal):
    needed("xarray")
    motion = stridor.simulate(squeal)
    trace = motion.trace(0.2, 0.21)
    assert ((trace.state == "slip") == (trace.friction_force != 0) & (trace.state != "stick")).all()
    shares = {state: float((trace.state == state).mean()) for state in stridor._stridor.contact_states}
    assert shares["slip"] > 0.2 and shares["separation"] > 0.6 and sum(shares.values()) == pytest.approx(1.0)
    history = motion.history()
    assert (history.state == "slip").sum() > 100 and stridor.words(trace).identical(trace)


def test_the_name_of_a_ready_case_will_do(squeal):
    assert stridor.simulate("squeal") == stridor.simulate(squeal)
    with pytest.raises(stridor.InputError, match='Did you mean "squeal"'):
        stridor.simulate("squeel")
    with pytest.raises(stridor.InputError, match="stridor.read"):
        stridor.simulate("door/seal.toml")
    for wrong in (None, 3, squeal.to_dict(), ["squeal"], pathlib.Path("seal.toml")):
        with pytest.raises(stridor.InputError, match="is no case"):
            stridor.simulate(wrong)


def test_cards_show_what_is_said(squeal):
    squeal.title = "<b>"
    card = stridor.simulate(squeal)._repr_html_()
    assert "squeal" in card and "&lt;b&gt;" in card
    assert "squeal" in stridor.simulate(squeal).going.verdict._repr_html_()
    assert repr(stridor.simulate(squeal)).startswith("<motion")
