"""Where runs end, and runs that begin there or go on."""

import pytest

import stridor


def test_goes_on_bit_for_bit(tmp_path):
    case = stridor.case("squeal")
    case.run.duration, case.run.window = 1.0, 0.5
    state = stridor.end_state(case)
    state.save(tmp_path / "end.json")
    case.run.duration = 1.5
    kept = stridor.read_end_state(tmp_path / "end.json")
    whole, gone_on = stridor.simulate(case), stridor.simulate(case, start=kept)
    assert gone_on.to_dict()["phases"] == whole.to_dict()["phases"]
    assert stridor.end_state(case, start=kept).displacement == stridor.end_state(case).displacement


def test_begins_another_run_in_a_state():
    case = stridor.case("creak")
    state = stridor.end_state(case)
    case.contact.preload = 30
    begun = state.begun(case)
    assert begun.run.initial == "given"
    assert begun.joint.initial_tangential == state.displacement[0]
    with pytest.raises(stridor.InputError, match="of another case"):
        stridor.simulate(case, start=state)


def test_refuses_what_is_no_state():
    with pytest.raises(stridor.InputError, match="no end state"):
        stridor.EndState("{}")
    spoilt = stridor.end_state("creak").to_json().replace('"time": 1.0', '"time": 2.0')
    with pytest.raises(stridor.InputError, match="checksum"):
        stridor.EndState(spoilt).begun("creak")


def test_follows_up_and_down():
    case = stridor.case("squeak")
    case.set({"drive.kind": "constant", "drive.velocity": -0.1})
    following = stridor.follow(case, "mu_d=0.1:0.3:3")
    assert [run["way"] for run in following.runs] == ["up", "up", "up", "down", "down"]
    assert list(following.hysteresis) == ["coming"]
    assert following.to_dict()["over"]["parameter"] == following.key == "contact.kinetic_friction"


def test_strokes_wear_the_preload_down():
    case = stridor.case("squeak")
    case.set({"drive.kind": "constant", "drive.velocity": -0.1})
    history = stridor.strokes(case, 50, 1.0, pause=0.5, wear=(1e-12, 1e-6, 1e-3))
    shares = [stroke["preload_share"] for stroke in history.strokes]
    assert shares[0] == 1.0 and shares == sorted(shares, reverse=True)
    assert history.strokes[-1]["number"] == 50 and history.ended is None
    assert history.stretches["coming"][0]["verdict"] == history.strokes[0]["coming"]["verdict"]
    with pytest.raises(stridor.InputError, match="neither heating nor wear"):
        stridor.strokes(case, 50, 1.0)
