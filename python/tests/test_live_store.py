"""A store is read while another process fills it."""

import os
import pathlib
import signal
import subprocess
import time

import numpy
import pytest
from conftest import needed

import stridor

xarray = needed("xarray")


def opened(path):
    from stridor.xarray_backend import StoreBackend

    return xarray.open_dataset(path, engine=StoreBackend)


def chart_arguments(out, duration):
    program = os.environ["STRIDOR_PROGRAM"]
    pathlib.Path("pair.toml").write_text(subprocess.run([program, "init", "noise-chart"], check=True,
                                                        capture_output=True, text=True).stdout)
    return [program, "chart", "pair.toml", "--out", out, "--threads", "1", "--files", "nc", "--figures", "all",
            "--set", "chart.x.points=60", "--set", "chart.y.points=50", "--set", f"run.duration={duration}",
            "--set", "run.window=0.1", "--set", "run.early_ending=never"]


def changes():
    """How often the store of the folder "live" has changed; 0 before anybody owns it."""
    try:
        return int(pathlib.Path("live/chart.sqlite.owner").read_text().rpartition("changes = ")[2])
    except (FileNotFoundError, ValueError):
        return 0


@pytest.fixture
def writer():
    """A program that fills the store of the folder "live", for some seconds."""
    process = subprocess.Popen(chart_arguments("live", 1.6), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    while changes() <= 1:  # its tables are not there yet
        assert process.poll() is None
        time.sleep(0.001)
    yield process
    process.kill()
    process.wait()


def test_what_is_kept_is_seen_while_more_comes(writer):
    looks = []
    while writer.poll() is None:
        looks.append(opened("live/chart.sqlite"))
    assert writer.wait() == 0, "it is not disturbed"
    whole = opened("live/chart.sqlite")
    counts = [look.attrs["cells_computed"] for look in looks if "cells_computed" in look.attrs]
    assert len({count for count in counts if 0 < count < 6000}) > 1, counts
    assert counts == sorted(counts)
    for look in looks:
        there = numpy.asarray(look.status != "not_computed")
        for name in ("status", "category", "slip", "frequency", "growth_rate"):
            ours, theirs = look[name].values[there], whole[name].values[there]
            assert numpy.array_equal(ours, theirs, equal_nan=name not in ("status", "category")), name


def test_one_that_changes_for_ever_or_elsewhere_is_refused(writer, monkeypatch):
    writer.send_signal(signal.SIGSTOP)
    owner = pathlib.Path("live/chart.sqlite.owner")
    text = owner.read_text()
    changes = text[text.index("changes = "):].split("\n")[0]
    from stridor import xarray_backend

    monkeypatch.setattr(xarray_backend, "_patience", 0.2)
    try:
        owner.write_text(text.replace(changes, "changes = 7"))
        with pytest.raises(stridor.FileError, match="it changed whenever it was read"):
            opened("live/chart.sqlite")
        owner.write_text(text.replace("host = ", "host = not-"))
        with pytest.raises(stridor.FileError, match="of host not-"):
            opened("live/chart.sqlite")
    finally:
        owner.write_text(text)
        writer.send_signal(signal.SIGCONT)
