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
    there = numpy.asarray(part.status != "not_computed")
    assert 0 < there.sum() == part.attrs["cells_computed"] < there.size == part.attrs["cells"]
    for name in ("preload", "kinetic_friction"):
        assert (part[name].values == whole[name].values).all() and part[name].units == whole[name].units
    assert list(part.direction.values) == list(whole.direction.values)
    for name in ("status", "category", "slip", "frequency", "joint_level", "growth_rate"):
        ours, theirs = part[name].values[there], whole[name].values[there]
        assert numpy.array_equal(ours, theirs, equal_nan=name not in ("status", "category")), name
        assert part[name].dims == whole[name].dims
    assert numpy.isnan(part.slip.values[~there]).all()
    for name in ("status", "category", "quiet_because"):
        assert set(part[name].values[~there]) == {"not_computed"}, name
    assert (part.category == "none").sum() == (whole.category.values[there] == "none").sum() > 0


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
    with pytest.raises(stridor.InputError, match="no store"):
        opened("a.sqlite")
    for name in ("missing.sqlite", "folder/missing.sqlite", "a.sqlite/b"):
        with pytest.raises(stridor.FileError, match="cannot read"):
            opened(name)


def test_what_would_be_waited_for_is_no_store(small_chart):
    from stridor.xarray_backend import StoreBackend

    os.mkfifo("pipe.sqlite")
    assert not StoreBackend().guess_can_open("pipe.sqlite")
    small_chart(out="done")
    # an owner that cannot be read tells nothing, and nobody waits for it
    os.mkfifo("done/chart.sqlite.owner")
    with pytest.raises(stridor.FileError, match="no plain file"):
        opened("done/chart.sqlite")
    os.remove("done/chart.sqlite.owner")
    pathlib.Path("done/chart.sqlite.owner").write_bytes(b"process = many\nchanges = \xff\n")
    os.utime("done/chart.sqlite.owner", (0, 0))
    assert "category" in opened("done/chart.sqlite")
