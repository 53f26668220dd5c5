"""Charts by the program for clusters: the same cells, errors as exceptions, Ctrl-C keeps the store."""

import os
import pathlib
import shutil
import signal
import stat
import subprocess
import sys
import time

import pytest

import stridor

PROGRAM = pathlib.Path(os.environ["STRIDOR_PROGRAM"]).parent / "stridor-mpi"
MPIRUN = ["mpirun", "--oversubscribe", "--bind-to", "none", "-n", "2"]
needs_mpi = pytest.mark.skipif(not PROGRAM.exists() or shutil.which("mpirun") is None,
                               reason="stridor-mpi or mpirun is not there (Debian: libopenmpi-dev openmpi-bin)")


@pytest.fixture(autouse=True)
def root_may(monkeypatch):
    """A test machine is a bare one, where all is done by root."""
    monkeypatch.setenv("OMPI_ALLOW_RUN_AS_ROOT", "1")
    monkeypatch.setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1")


@needs_mpi
def test_two_ranks_make_the_chart_of_one_process(small_chart):
    alone = small_chart(out="alone", refine=1)
    together = small_chart(out="together", refine=1, launcher=MPIRUN, threads=1)
    assert together.counts() == alone.counts() and together.to_xarray().identical(alone.to_xarray())
    for name in ("chart.csv", "boundaries.csv", "chart.nc", "chart.toml"):
        assert pathlib.Path("together", name).read_bytes() == pathlib.Path("alone", name).read_bytes(), name
    # goes on with what is there, by either
    assert small_chart(out="together", refine=1, launcher=MPIRUN).counts() == alone.counts()
    assert small_chart(out="alone", refine=1, launcher=MPIRUN).counts() == alone.counts()
    assert small_chart(out="together", refine=1).counts() == alone.counts()


@needs_mpi
def test_another_charts_folder_is_refused_and_left_alone(small_chart):
    small_chart(out="taken")
    before = pathlib.Path("taken/chart.toml").read_bytes()
    with pytest.raises(stridor.InputError, match="another chart"):
        small_chart(out="taken", refine=2, launcher=MPIRUN)
    assert pathlib.Path("taken/chart.toml").read_bytes() == before


@needs_mpi
def test_what_the_program_refuses_is_an_exception(small_chart):
    pathlib.Path("out").mkdir()
    pathlib.Path("out/chart.sqlite").write_text("no store of ours")
    with pytest.raises(stridor.Error, match="chart.sqlite") as caught:
        small_chart(out="out", launcher=MPIRUN)
    assert "mpirun" not in str(caught.value)


@needs_mpi
def test_ctrl_c_keeps_what_there_is():
    text = ("import stridor\n"
            "axes = {'x': stridor.axis('preload', 2, 4000, 300), 'y': stridor.axis('mu_d', 0.0, 0.8, 300)}\n"
            "try:\n"
            f"    stridor.chart(stridor.case('noise-chart'), **axes, out='long', launcher={MPIRUN!r}, threads=1)\n"
            "except stridor.Interrupted as error:\n"
            "    print('kept', error)\n")
    process = subprocess.Popen([sys.executable, "-B", "-c", text], stdout=subprocess.PIPE, text=True)
    end = time.monotonic() + 60
    while not pathlib.Path("long/chart.sqlite").exists() and time.monotonic() < end:
        time.sleep(0.05)
    time.sleep(1.5)
    process.send_signal(signal.SIGINT)
    out, _ = process.communicate(timeout=60)
    assert process.returncode == 0 and out.startswith("kept")
    done = subprocess.run([os.environ["STRIDOR_PROGRAM"], "chart-status", "long"], capture_output=True, text=True)
    assert int(done.stdout.split(" of ")[0].split()[-1]) > 0, done


def launcher_that(tmp_path, text):
    path = tmp_path / "launch"
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(path.stat().st_mode | stat.S_IEXEC)
    return [str(path)]


def programs(tmp_path, monkeypatch):
    """A folder in which stridor-mpi is found, whatever it is."""
    shutil.copy("/bin/true", tmp_path / "stridor-mpi")
    monkeypatch.setenv("STRIDOR_PROGRAM", str(tmp_path / "stridor"))


@pytest.mark.parametrize("text, kind, said", [
    ("echo 'stridor-mpi: error: no room' >&2; echo 'help: Make some.' >&2; exit 5", stridor.FileError, "no room\nMake"),
    ("echo 'stridor-mpi: error: a typo' >&2; exit 2", stridor.InputError, "a typo"),
    ("echo 'no slots'; exit 1", stridor.Error, "no slots"), ("exit 3", stridor.Error, "ended with 3"),
    ("kill -9 $$", stridor.Error, "ended with -9")])
def test_failures_of_launchers_are_told(small_chart, tmp_path, monkeypatch, text, kind, said):
    programs(tmp_path, monkeypatch)
    with pytest.raises(kind) as caught:
        small_chart(out="out", launcher=launcher_that(tmp_path, text))
    assert said in str(caught.value)


@pytest.mark.parametrize("more, kind", [
    ({"launcher": "mpirun -n 2", "out": "a"}, stridor.InputError), ({"launcher": ["mpirun"]}, stridor.InputError),
    ({"launcher": ["mpirun", 2], "out": "a"}, stridor.InputError),
    ({"launcher": ["mpirun"], "out": "a", "progress": True}, stridor.InputError),
    ({"launcher": ["no-such-launcher"], "out": "a"}, stridor.FileError)])
def test_what_is_no_launcher_is_refused(small_chart, tmp_path, monkeypatch, more, kind):
    programs(tmp_path, monkeypatch)
    with pytest.raises(kind):
        small_chart(**more)
