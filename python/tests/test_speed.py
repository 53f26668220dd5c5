"""What Python costs beside the library alone. `./dev python` prints it.

The bounds only find what is broken, for others share the machine: the numbers printed are what counts."""

import os
import subprocess
import sys
import time

import pytest
from conftest import needed, python

import stridor

numpy = needed("numpy")


@pytest.fixture(scope="module")
def without_python():
    """Seconds of a run, and wall and processor seconds of 10,000 points, in C++."""
    program = os.environ["STRIDOR_PYTHON_SPEED"]
    lines = subprocess.run([program], check=True, capture_output=True, text=True).stdout.split()
    return [float(line) for line in lines]


def shortest(call, count):
    times = []
    for _ in range(count):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return min(times)


def test_a_run_costs_little_more_than_in_cpp(squeal, without_python):
    run = shortest(lambda: stridor.simulate(squeal), 1000)
    print(f"a run: {1e6 * without_python[0]:.1f} us in C++, {1e6 * (run - without_python[0]):.1f} us more in Python")
    assert run - without_python[0] < 1e-3


def test_ten_thousand_points_cost_little_more_than_in_cpp(squeal, without_python):
    needed("xarray")
    values = {"contact.preload": 5.0 + 0.05 * numpy.arange(10000)}
    wall, cpu = time.perf_counter(), time.process_time()
    stridor.evaluate(squeal, values, threads=2)
    wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
    print(f"10,000 points: {without_python[1]:.3f} s in C++ and {wall:.3f} s in Python; of the processors "
          f"{without_python[2]:.3f} s and {cpu:.3f} s ({cpu / without_python[2]:.3f})")
    assert cpu < 2.0 * without_python[2]


def test_import_takes_little_more_than_that_of_numpy():
    def import_time(names):
        text = f"import time; t = time.perf_counter(); import {names}; print(time.perf_counter() - t)"
        return min(float(python(text).stdout) for _ in range(5))

    more = import_time("numpy, stridor") - import_time("numpy")
    print(f"import: {1e3 * more:.1f} ms more than numpy")
    assert more < 1.0


def test_a_figure_is_read_without_a_copy(small_chart):
    chart = small_chart()
    array = chart.figure("frequency")
    access = shortest(lambda: array[0, 0, 0], 1000)
    assert access < 1e-4 and array.base is not None


if __name__ == "__main__":
    sys.exit(pytest.main(["-s", "-q", __file__]))
