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


def test_contradictions_are_points_and_ranges_are_errors(squeal):
    doe = stridor.evaluate(short(squeal), {"mu_d": [0.9, 0.1]}, directions="going")
    assert list(doe.status.values[0]) == ["invalid", "done"]
    assert list(doe.category.values[0])[0] == "not_done"
    assert "exceeds" in doe.message.values[0, 0] and numpy.isnan(doe.slip.values[0, 0])
    with pytest.raises(stridor.InputError, match="point 1"):
        stridor.evaluate(squeal, {"preload": [20.0, -1.0]})


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
