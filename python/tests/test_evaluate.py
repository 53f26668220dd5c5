"""Points anywhere."""

import subprocess
import sys

import pytest
from conftest import needed

import stridor

numpy = needed("numpy")
needed("xarray")


def short(case, duration=0.3):
    case.set({"run.duration": duration, "run.window": duration})
    return case


def test_arrays_are_broadcast_and_named(squeal):
    case = short(squeal)
    doe = stridor.evaluate(case, {"contact.preload": [5.0, 50.0, 500.0], "mu_d": 0.3})
    assert doe.category.dims == ("direction", "point")
    assert doe.category.shape == (2, 3)
    assert doe.preload.units == "N" and doe.frequency.units == "Hz"
    assert set(doe.status.values.ravel()) == {"done"}
    grid = stridor.evaluate(case, {"F": numpy.ones((2, 1)) * 20, "alpha": numpy.linspace(60, 110, 3)[None, :]})
    assert grid.category.shape == (2, 2, 3)
    assert (grid.category.values[:, 0] == grid.category.values[:, 1]).all()


def test_a_point_is_what_its_case_gives(squeal):
    preloads = numpy.geomspace(5, 500, 5)
    doe = stridor.evaluate(squeal, {"contact.preload": preloads}, directions="going")
    for k, preload in enumerate(preloads):
        going = stridor.simulate(squeal.replace({"F": preload})).going
        assert doe.category.values[0, k] == going.category
        assert doe.joint_rms.values[0, k] == going.joint_rms


def test_threads_change_no_bit(squeal):
    case = short(squeal)
    values = {"contact.preload": numpy.geomspace(5, 500, 20)}
    one, three = (stridor.evaluate(case, values, threads=threads) for threads in (1, 3))
    assert one.identical(three)


def test_texts_have_units_and_a_table_has_words(squeal):
    doe = stridor.evaluate(short(squeal), {"preload": ["20 N", "0.2 kN"]})
    assert list(doe.preload.values) == [20.0, 200.0]
    needed("pandas")
    sizes = doe.to_dataframe().groupby("category").size()
    assert sizes.sum() == 4


class WithUnit:
    """Numbers with a unit, as pint, astropy and others have them: numpy drops it."""

    def __init__(self, numbers, unit, names=("magnitude", "units")):
        setattr(self, names[0], numbers)
        setattr(self, names[1], unit)
        self.numbers = numbers

    def __array__(self, dtype=None, copy=None):
        return numpy.asarray(self.numbers, dtype)

    def __float__(self):
        return float(self.numbers)


class Unit:
    """pint's long name, and its short one."""

    def __str__(self):
        return "kilonewton"

    def __format__(self, form):
        return "kN" if form == "~C" else "kilonewton"


def quantities(numbers):
    xarray = needed("xarray")
    yield xarray.DataArray(numbers, dims="k", attrs={"units": "kN"})
    yield xarray.DataArray(numpy.asarray(numbers), dims="k", attrs={"unit": "kN"})
    yield WithUnit(numpy.asarray(numbers), Unit())
    yield WithUnit(numpy.asarray(numbers), "kN", ("value", "unit"))
    yield [WithUnit(number, Unit()) for number in numbers]
    yield numpy.array([f"{number} kN" for number in numbers], dtype=object)
    yield [xarray.DataArray(number, attrs={"units": "kN"}) for number in numbers]


def test_units_of_arrays_are_read(squeal):
    case = short(squeal)
    for given in quantities([0.02, 0.2]):
        assert list(stridor.evaluate(case, {"preload": given}).preload.values) == [20.0, 200.0]
    speed = WithUnit(numpy.array([50.0]), "mm / s")
    doe = stridor.evaluate(case, {"drive.kind": "constant", "drive.velocity": speed}, directions="going")
    assert list(doe.velocity.values) == [0.05]
    # what came out goes in again, with the same bits
    first = stridor.evaluate(case, {"preload": numpy.geomspace(5, 500, 3), "mu_d": numpy.linspace(0.1, 0.7, 3)})
    assert first.preload.units == "N"
    again = stridor.evaluate(case, {"preload": first.preload, "mu_d": first.kinetic_friction})
    assert again.identical(first)


def test_units_are_read_wherever_a_number_is_taken(squeal):
    for given in list(quantities([0.2]))[:4]:
        one = given if isinstance(given, WithUnit) else given[0]
        if isinstance(one, WithUnit):
            one = WithUnit(0.2, getattr(one, "units", getattr(one, "unit", None)))
        assert squeal.replace({"preload": one}).contact.preload == 200.0
        assert stridor.axis("preload", 2, one, 5).text == "preload=2.0 N:0.2 kN:5"
    millisecond = WithUnit(2.0, "ms")
    assert stridor.simulate(squeal).trace(0, millisecond, "1 ms").sizes["time"] == 3
    with pytest.raises(stridor.InputError, match="in tonne"):
        stridor.structure(mass=WithUnit(numpy.eye(2), "tonne"), stiffness=numpy.eye(2), contacts=[], values={})


def test_a_unit_of_something_else_is_refused(squeal):
    for unit in ("kg", "parsecs", "m/s", Unit):
        with pytest.raises(stridor.InputError):
            stridor.evaluate(squeal, {"preload": WithUnit(numpy.array([1.0]), unit)})
        with pytest.raises(stridor.InputError):
            squeal.replace({"preload": WithUnit(1.0, unit)})


def test_contradictions_are_points_and_ranges_are_errors(squeal):
    doe = stridor.evaluate(short(squeal), {"mu_d": [0.9, 0.1]}, directions="going")
    assert list(doe.status.values[0]) == ["invalid", "done"]
    assert list(doe.category.values[0])[0] == "not_done"
    assert "exceeds" in doe.message.values[0, 0] and numpy.isnan(doe.slip.values[0, 0])
    with pytest.raises(stridor.InputError, match="point 1"):
        stridor.evaluate(squeal, {"preload": [20.0, -1.0]})


@pytest.mark.parametrize("drive", ["constant", "sinusoidal"])
@pytest.mark.parametrize("starts", [["sliding"], ["stuck", "rest"], ["sliding", "rest", "stuck"]], ids="-".join)
def test_with_starts_each_is_a_cell_of_such_a_chart(drive, starts, squeal):
    needed("netCDF4")
    case = short(stridor.case("noise-chart") if drive == "constant" else squeal, 0.3)
    axes = {"x": stridor.axis("preload", 2, 4000, 6), "y": stridor.axis("mu_d", 0.0, 0.8, 5)}
    chart = stridor.chart(case, **axes, starts=starts).to_xarray()
    values = {"preload": chart.preload.values[None, :], "mu_d": chart.kinetic_friction.values[:, None]}
    points = stridor.evaluate(case, values, starts=starts, threads=2)
    for name in points.data_vars:
        if name != "message":
            there = chart[name]
            assert there.shape == points[name].shape and there.dims[:-2] == points[name].dims[:-2]
            assert there.values.astype(points[name].dtype).tobytes() == points[name].values.tobytes(), name
    assert list(points.start.values) == starts


def test_starts_that_disagree_are_told_and_the_loudest_is_shown(squeal):
    case = stridor.case("noise-chart")
    grid = {"preload": numpy.geomspace(5, 2000, 6)[None, :], "mu_d": numpy.linspace(0.1, 0.75, 6)[:, None]}
    both = stridor.evaluate(case, grid, starts=["rest", "sliding"], directions="going")
    single = [stridor.evaluate(case.replace({"run.initial": start}), grid, directions="going")
              for start in ("rest", "sliding")]
    for start, alone in zip(both.start_verdict.values, single):
        assert (start == numpy.where(alone.status == "done", alone.category, alone.status)).all()
    differ = both.start_verdict.values[0] != both.start_verdict.values[1]
    assert differ.any() and ((both.agreement.values == "agree") == ~differ).all()
    order = ["none", "undecided", "creak", "squeak", "squeal"]
    loudest = numpy.maximum(*(numpy.vectorize(order.index)(alone.category.values) for alone in single))
    assert (numpy.array(order)[loudest] == both.category.values).all()
    assert "agreement" not in single[0] and "start" not in single[0].dims


@pytest.mark.parametrize("starts, said", [(["rest", "rest"], "twice"), (["rset"], 'Did you mean "rest"'), ([1], "")])
def test_wrong_starts_are_refused(squeal, starts, said):
    with pytest.raises((stridor.InputError, TypeError), match=said):
        stridor.evaluate(squeal, {"preload": [20.0]}, starts=starts)
    with pytest.raises(stridor.InputError, match="run.initial"):
        stridor.evaluate(squeal, {"run.initial": ["rest"]}, starts=["rest"])


def test_words_are_what_their_cases_give(squeal):
    case = short(squeal)
    words = {"run.engine": ["exact", "beta_2", "moreau"], "run.step": "1 us", "contact.impact": "plastic",
             "preload": [20.0, 30.0, 40.0]}
    points = stridor.evaluate(case, words, threads=2)
    assert list(points.engine.values) == words["run.engine"] and points.engine.attrs["parameter"] == "run.engine"
    assert "units" not in points.engine.attrs and points.step.units == "s"
    for k, engine in enumerate(words["run.engine"]):
        step = {} if engine == "exact" else {"run.step": "1 us"}
        phases = stridor.simulate(case.replace({"run.engine": engine, **step, "preload": words["preload"][k]})).phases
        assert [phase.category for phase in phases] == list(points.category.values[:, k])
        assert [phase.slip for phase in phases] == list(points.slip.values[:, k])
    # words alone, and words of a grid
    alone = stridor.evaluate(case, {"run.initial": numpy.array([["rest", "stuck"], ["sliding", "rest"]])})
    assert alone.slip.shape == (2, 2, 2) and alone.slip.values[0, 0, 0] == alone.slip.values[0, 1, 1]


def test_words_that_need_numbers_take_them_and_others_leave_them(squeal):
    values = {"drive.kind": ["sinusoidal", "constant", "constant"], "drive.velocity": ["1 m/s", "5 cm/s", "0.1 m/s"],
              "drive.amplitude": [0.005, 0.001, 0.002]}
    case = short(squeal)
    points = stridor.evaluate(case, values, directions="going")
    assert points.slip.values[0, 0] == stridor.evaluate(case, {"drive.amplitude": [0.005]}).slip.values[0, 0]
    even = case.replace({"drive.kind": "constant", "drive.velocity": 0.05})
    assert points.slip.values[0, 1] == stridor.simulate(even).whole.slip
    # a contradiction in one of the points that say what is missing is that point's own
    friction = {"contact.friction": "directional", "mu_sc": 0.5, "mu_dc": [0.9, 0.2]}
    assert list(stridor.evaluate(case, friction, directions="going").status.values[0]) == ["invalid", "done"]


@pytest.mark.parametrize("values, point", [
    ({"run.engine": ["exact", "exakt"]}, 1), ({"run.engine": ["exakt"]}, 0), ({"run.engine": [1.0]}, 0),
    ({"drive.kind": ["sinusoidal", "constant"]}, 1), ({"preload": ["2 N", "2 kg"]}, 1), ({"F": ["1 N", "x"]}, 1),
    ({"preload": [1.0, 2.0, -1.0]}, 2), ({"contact.friction": ["coulomb", "directional"], "mu_sc": 0.5}, 1),
    ({"run.engine": ["exact", "beta_2"], "preload": [20.0, -3.0]}, 1), ({"title": ["a", "b\nc"]}, 1)], ids=str)
def test_wrong_points_say_what_a_case_says_and_their_number(squeal, values, point):
    alone = {key: numpy.broadcast_arrays(*map(numpy.asarray, values.values()))[k][point].item()
             for k, key in enumerate(values)}
    with pytest.raises(stridor.InputError) as of_case:
        squeal.replace(alone)
    with pytest.raises(stridor.InputError) as of_point:
        stridor.evaluate(squeal, values)
    for said, wanted in zip(of_point.value.complaints, of_case.value.complaints):
        assert said == (f"point {point}: {wanted[0]}", *wanted[1:])
    assert all(text in str(of_point.value) for text in of_point.value.complaints[0][:3])


def test_no_points_give_an_empty_dataset(squeal):
    assert stridor.evaluate(squeal, {"preload": []}).category.shape == (2, 0)


def test_progress_is_told_and_its_exceptions_come_out(squeal):
    seen = []
    values = {"preload": numpy.geomspace(5, 500, 1500)}
    stridor.evaluate(short(squeal, 0.5), values, progress=lambda *told: seen.append(told))
    assert seen and seen[-1][0] == seen[-1][1] == 1500
    assert [done for done, _, _ in seen] == sorted(done for done, _, _ in seen)

    def stop(*told):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        stridor.evaluate(squeal, values, progress=stop)
    assert stridor.evaluate(short(squeal), {"preload": [20.0]}, progress=True).category.shape == (2, 1)


@pytest.mark.parametrize("way", ["fork", "spawn"])
def test_processes_of_python_compute_the_same(way):
    text = f"""
import multiprocessing, numpy, stridor
def work(case):
    return stridor.evaluate(case, {{"preload": [20.0, 40.0]}}, threads=2), stridor.simulate(case)
if __name__ == "__main__":
    case = stridor.case("squeal")
    here = work(case)
    with multiprocessing.get_context("{way}").Pool(2) as pool:
        for there in pool.map(work, [case, case]):
            assert there[0].identical(here[0]) and there[1] == here[1]
    print("same")
"""
    with open("processes.py", "w", encoding="utf-8") as file:
        file.write(text)
    done = subprocess.run([sys.executable, "-B", "processes.py"], capture_output=True, text=True, timeout=120)
    assert done.stdout == "same\n", done.stderr
