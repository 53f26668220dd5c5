"""Whatever comes in wrong goes out as a typed exception, and never ends the process."""

import copy
import datetime
import os
import pickle
import tempfile

import numpy
import pytest

import stridor

PAINLEVE = """
[structure]
rows = ["x", "y"]
mass = [[1, 0.9], [0.9, 1]]
stiffness = [[100, 0], [0, 100]]
damping = [[0.1, 0], [0, 0.1]]
[[structure.contact]]
name = "foot"
normal = "y"
tangent = "x"
[contact]
preload = "1 N"
static_friction = 1.5
kinetic_friction = 1.3
[drive]
kind = "constant"
velocity = "0.1 m/s"
[run]
initial = "rest"
"""

WRONG_VALUES = [
    ("contact.preload", -1), ("contact.preload", 0), ("contact.preload", float("nan")),
    ("contact.preload", float("inf")), ("contact.preload", "20 kg"), ("contact.preload", "twenty"),
    ("contact.preload", ""), ("contact.preload", "20 N N"), ("contact.preload", "1e999"), ("contact.preload", "\x00"),
    ("contact.preload", None), ("contact.preload", True), ("contact.preload", [1, 2]), ("contact.preload", {}),
    ("contact.preload", numpy.True_), ("contact.preload", numpy.datetime64("1970-02-01")), ("contact.preload", b"20"),
    ("contact.preload", numpy.timedelta64(20, "ns")), ("contact.preload", numpy.array(True)), ("contact.preload", 2j),
    ("contact.preload", datetime.timedelta(20)), ("contact.preload", numpy.array([20.0])),
    ("contact.preloda", 20), ("contakt.preload", 20), ("", 20), ("=", 20), ("contact.preload=1", 20), ("mass", 1),
    ("joint.lip2.mass", 1), ("run.engine", "exakt"), ("run.engine", 1), ("drive.kind", "constant"),
    ("drive.velocity", 0.1), ("drive.file", "missing.csv"), ("drive.kind", "sampled"), ("title", "two\nlines"),
    ("contact.kinetic_friction", 0.9), ("run.window", 2.0), ("run.duration", 1e-9), ("structure.mass", 1),
    ("joint.incidence_angle", 400), ("ü", 1), ("a" * 100000, 1), ("contact.preload", "9" * 100000),
]


@pytest.mark.parametrize("key, value", WRONG_VALUES, ids=str)
def test_wrong_values_are_input_errors(squeal, key, value):
    before = squeal.copy()
    with pytest.raises(stridor.InputError) as caught:
        squeal.set({key: value})
    assert isinstance(caught.value, ValueError)
    assert caught.value.what and caught.value.place is None
    assert squeal == before


def test_errors_say_what_the_program_says(squeal, program):
    import subprocess

    squeal.save("squeal.toml")
    for key, value in [("contact.preloda", "20"), ("contact.preload", "-1"), ("contact.kinetic_friction", "0.9"),
                       ("run.engine", "exakt"), ("contact.preload", "20 kg")]:
        with pytest.raises(subprocess.CalledProcessError) as said:
            program("simulate", "squeal.toml", "--set", f"{key}={value}")
        with pytest.raises(stridor.InputError) as caught:
            squeal.set({key: value})
        assert caught.value.what in said.value.stderr
        assert caught.value.suggestion in said.value.stderr


def test_texts_have_no_surrogates(squeal):
    with pytest.raises(ValueError):
        squeal.title = "\udc80"
    with pytest.raises((ValueError, AttributeError)):
        getattr(squeal.contact, "\udc80")


@pytest.mark.parametrize("text, line", [
    ("[joint]\nmas = 1\n", 2), ("[joint\n", 1), ("", 0), ("a = 1", 1), ("a." * 5000, 0), ("\x00", 1),
    ("[joint]\nmass = 1\nmass = 2\n", 3), ("x" * 70000, 0)])
def test_wrong_files_are_refused_with_their_place(text, line):
    with pytest.raises(stridor.InputError) as caught:
        stridor.from_toml(text, name="mine.toml")
    if line:
        assert any(place and (place.file, place.line) == ("mine.toml", line)
                   for _, _, _, place in caught.value.complaints), caught.value.complaints
    with pytest.raises(stridor.InputError):
        stridor.Case(text)


def test_all_complaints_of_a_file_are_told():
    text = stridor.case("squeal").to_toml().replace('"0.1 kg"', '"0.1 N"').replace('"20 N"', '"-1 N"')
    with pytest.raises(stridor.InputError) as caught:
        stridor.from_toml(text)
    assert len(caught.value.complaints) == 2
    assert "\n" in str(caught.value)


def test_files_that_cannot_be_read_are_file_errors(tmp_path):
    for path in ("missing.toml", str(tmp_path)):
        with pytest.raises(stridor.FileError) as caught:
            stridor.read(path)
        assert isinstance(caught.value, OSError)
    with open("random.toml", "wb") as file:
        file.write(bytes(range(256)))
    with pytest.raises(stridor.InputError):
        stridor.read("random.toml")


def test_errors_are_copied_and_pickled(squeal):
    with pytest.raises(stridor.InputError) as caught:
        stridor.from_toml("[joint]\nmas = 1\n", name="mine.toml")
    for again in (pickle.loads(pickle.dumps(caught.value)), copy.copy(caught.value)):
        assert str(again) == str(caught.value)
        assert again.complaints == caught.value.complaints
        assert again.place == caught.value.place
    for kind in (stridor.NumericalError, stridor.FileError, stridor.Interrupted):
        error = kind("what is wrong")
        assert (error.what, error.why, error.suggestion, error.place) == ("what is wrong", "", "", None)
        assert str(pickle.loads(pickle.dumps(error))) == "what is wrong"


def test_every_exception_has_two_parents():
    for kind, other in [(stridor.InputError, ValueError), (stridor.NumericalError, ArithmeticError),
                        (stridor.Interrupted, KeyboardInterrupt), (stridor.FileError, OSError)]:
        assert issubclass(kind, other) and issubclass(kind, stridor.Error)


def test_a_motion_without_end_is_a_numerical_error(squeal):
    # a step far too long for a stiff joint: the scheme would grow without bound
    squeal.set({"run.engine": "beta_2", "run.step": 1e-3})
    with pytest.raises(stridor.InputError, match="stability limit"):
        stridor.simulate(squeal)
    painleve = stridor.from_toml(PAINLEVE)
    with pytest.raises(stridor.NumericalError, match="no forces obey") as caught:
        stridor.simulate(painleve)
    assert isinstance(caught.value, ArithmeticError) and caught.value.suggestion
    doe = stridor.evaluate(painleve, {"contact.preload": [1.0]}, directions="going")
    assert doe.status.values[0, 0] == "failed" and "no forces obey" in doe.message.values[0, 0]


@pytest.mark.parametrize("times", [
    ("a", None, "20 us"), (None, "1 kg", "20 us"), (0.5, 0.2, "20 us"), (0, 1, 0), (0, 1, -1e-5), (0, 1, 1e-12),
    (float("nan"), 1, 1e-5), (0, 1e9, 1e-5), (5, 6, 1e-5)])
def test_wrong_traces_are_refused(squeal, times):
    with pytest.raises(stridor.InputError):
        stridor.simulate(squeal).trace(*times)


@pytest.mark.parametrize("values", [
    {}, {"preloda": [1]}, {"preload": [1], "mu_d": [1, 2], "mu_s": [1, 2, 3]}, {"preload": ["a"]},
    {"preload": [None]}, {"preload": [float("nan")]}, {"preload": [1j]}, {"run.engine": [1.0]}, {"F": 1, "preload": 2},
    {"drive.velocity": [1.0]}, {"preload": object()}, {"preload": [True]}, {"preload": [True, 20.0]},
    {"preload": numpy.array(["2020-01-01"], "datetime64[D]")}, {"preload": numpy.array([20], "timedelta64[s]")},
    {"preload": [datetime.date(2020, 1, 1)]}, {"preload": numpy.array([b"20 N"])}, {"preload": [[1.0], [1.0, 2.0]]},
    {"preload": numpy.ma.array([20.0, 30.0], mask=[False, True])}, {"run.engine": [True]}], ids=str)
def test_wrong_points_are_refused(squeal, values):
    with pytest.raises(stridor.InputError):
        stridor.evaluate(squeal, values)


def test_wrong_kinds_of_arguments_are_type_errors(squeal):
    for call in (lambda: stridor.case(1), lambda: stridor._stridor.simulate(None),
                 lambda: stridor._stridor.CaseHandle(), lambda: stridor._stridor.ChartHandle()):
        with pytest.raises((TypeError, AttributeError)):
            call()
    with pytest.raises(stridor.InputError):
        stridor.evaluate(squeal, {"preload": [1.0]}, directions="up")


def test_no_moment_and_no_truth_is_a_number_anywhere(squeal):
    axis = stridor.axis("mu_d", 0.2, 0.8, 4)
    for wrong in (True, numpy.True_, numpy.datetime64("2020-01-01"), numpy.timedelta64(3, "s")):
        for call in (lambda: stridor.axis("preload", 2, wrong).text, lambda: stridor.axis("preload", wrong, 20).text,
                     lambda: stridor.axis("preload", 2, 20, wrong), lambda: stridor.simulate(squeal).trace(0, wrong),
                     lambda: stridor.listen(squeal, seconds=wrong), lambda: stridor.listen(squeal, rate=wrong),
                     lambda: stridor.advise(squeal, over=["preload"], tolerances={"preload": wrong}),
                     lambda: stridor.advise(squeal, over=["preload"], samples=wrong),
                     lambda: stridor.chart(squeal, x=axis, refine=wrong),
                     lambda: stridor.chart(squeal, x=axis, threads=wrong),
                     lambda: stridor.evaluate(squeal, {"preload": 20.0}, threads=wrong),
                     lambda: stridor.explore(squeal, threads=wrong)):
            with pytest.raises(stridor.InputError, match="is (no|neither)"):
                call()


def test_what_is_no_mapping_and_no_text_is_told(squeal):
    numbers = {"mass": numpy.eye(2), "stiffness": numpy.eye(2), "contacts": []}
    for wrong in (None, 3, "preload", [20.0], object()):
        for call in (lambda: squeal.set(wrong), lambda: squeal.replace(wrong), lambda: stridor.evaluate(squeal, wrong),
                     lambda: stridor.structure(values=wrong, **numbers), lambda: stridor.words(wrong)):
            with pytest.raises(stridor.InputError, match="is no (mapping|dataset)"):
                call()
    for wrong in (None, 3, ["preload"]):
        for call in (lambda: squeal[wrong], lambda: squeal.text(wrong)):
            with pytest.raises(stridor.InputError, match="is no text"):
                call()


def test_whole_numbers_are_whole(squeal):
    for wrong in (2.5, "2", None, 10**20, [1], float("nan")):
        with pytest.raises(stridor.InputError, match="threads"):
            stridor.evaluate(squeal, {"preload": 20.0}, threads=wrong)
    assert stridor.axis("preload", 2, 20, numpy.int64(5)).points == 5 == stridor.axis("preload", 2, 20, 5.0).points


def test_what_the_system_refuses_is_a_file_error(squeal, small_chart, monkeypatch):
    axis = stridor.axis("mu_d", 0.2, 0.8, 4)
    with open("file", "w", encoding="ascii"):
        pass
    for folder in ("file", "file/below", "/proc/nowhere/chart", "a\0b"):
        with pytest.raises(stridor.FileError, match="cannot make the folder"):
            stridor.chart(squeal, x=axis, out=folder)
    chart = small_chart(out="gone")
    os.remove("gone/chart.sqlite")
    with pytest.raises(stridor.FileError, match="cannot read the store"):
        pickle.dumps(chart)
    for call in (lambda: stridor.open_chart("nowhere"), lambda: stridor.read("nowhere.toml"),
                 lambda: stridor.read_sound("nowhere.wav"), lambda: squeal.save("nowhere/case.toml"),
                 lambda: stridor.library("nowhere.sqlite").find()):
        with pytest.raises(stridor.FileError):
            call()
    monkeypatch.setattr(tempfile, "tempdir", "/nowhere")
    kept = small_chart(out="kept")
    for call in (kept.to_xarray, lambda: stridor.listen(squeal), lambda: stridor.chart(squeal, x=axis),
                 lambda: stridor.explore(squeal, browser="none")):
        with pytest.raises(stridor.FileError, match="cannot make a temporary f"):
            call()
