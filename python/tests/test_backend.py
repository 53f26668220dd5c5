"""xarray opens stores, finished or not."""

import os
import pathlib
import time

import numpy
import pytest
from conftest import needed

import stridor

xarray = needed("xarray")


def opened(path, **more):
    from stridor.xarray_backend import StoreBackend

    return xarray.open_dataset(path, engine=StoreBackend, **more)


def test_a_finished_store_is_the_chart(small_chart):
    chart = small_chart(out="done", refine=1)
    assert opened("done/chart.sqlite").identical(chart.to_xarray())
    assert "category" not in opened("done/chart.sqlite", drop_variables=["category"])


def stopped(**more):
    """A chart that ends early, by an exception of its callback, and the whole one."""
    axes = {"x": stridor.axis("preload", 2, 4000, 120), "y": stridor.axis("mu_d", 0, 0.8, 100)}

    began = []

    def stop(done, total, counts):
        began.append(time.monotonic())
        if began[-1] - began[0] > 1.2:  # [s] what a store has is written twice a second
            raise RuntimeError("enough")

    with pytest.raises(RuntimeError):
        stridor.chart(stridor.case("noise-chart"), **axes, out="stopped", progress=stop, threads=1, **more)
    return stridor.chart(stridor.case("noise-chart"), **axes, **more).to_xarray()


@pytest.mark.parametrize("more", [{}, {"starts": ["rest", "sliding"]}, {"directions": "coming"}])
def test_an_unfinished_one_has_what_is_there(more):
    whole = stopped(**more)
    before = pathlib.Path("stopped/chart.sqlite").read_bytes()
    part = opened("stopped/chart.sqlite")
    assert pathlib.Path("stopped/chart.sqlite").read_bytes() == before
    there = numpy.asarray(part.status) >= 0
    assert 0 < there.sum() == part.attrs["cells_computed"] < there.size == part.attrs["cells"]
    for name in ("preload", "kinetic_friction"):
        assert (part[name].values == whole[name].values).all() and part[name].units == whole[name].units
    assert list(part.direction.values) == list(whole.direction.values)
    for name in ("status", "category", "slip", "frequency", "joint_level", "growth_rate"):
        ours, theirs = part[name].values[there], whole[name].values[there]
        assert numpy.array_equal(ours, theirs, equal_nan=name not in ("status", "category")), name
        assert part[name].dims == whole[name].dims
    assert numpy.isnan(part.slip.values[~there]).all() and (part.category.values[~there] == -1).all()
    assert set(stridor.words(part).status.values[~there]) == {"not_computed"}


def test_a_damaged_one_is_told(small_chart):
    small_chart(out="torn")
    path = pathlib.Path("torn/chart.sqlite")
    data = bytearray(path.read_bytes())
    data[-2000] ^= 1
    path.write_bytes(data)
    with pytest.raises(stridor.FileError, match="damaged"):
        opened(path)


def test_what_is_no_store_is_refused(tmp_path):
    from stridor.xarray_backend import StoreBackend

    (tmp_path / "a.sqlite").write_bytes(os.urandom(200))
    assert not StoreBackend().guess_can_open("a.sqlite") and not StoreBackend().guess_can_open("missing")
    for name in ("a.sqlite", "missing.sqlite"):
        with pytest.raises(stridor.InputError, match="no store"):
            opened(name)
