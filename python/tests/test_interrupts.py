"""Ctrl-C, other threads, memory."""

import hashlib
import resource
import signal
import statistics
import subprocess
import sys
import textwrap
import threading
import time

import pytest
from conftest import python

import stridor

ENDLESS = """
    import os, signal, threading, time, stridor
    case = stridor.case("squeal")
    case.set({"run.duration": 20000.0, "run.window": 1.0})
    def later(seconds, number=signal.SIGINT):
        def kill():
            global sent
            sent = time.monotonic()
            os.kill(os.getpid(), number)
        threading.Timer(seconds, kill).start()
"""


def script(text):
    return python(textwrap.dedent(ENDLESS) + textwrap.dedent(text))


def test_ctrl_c_ends_a_run_soon():
    done = script("""
        for _ in range(5):
            later(0.3)
            try:
                stridor.simulate(case)
            except KeyboardInterrupt as error:
                late = time.monotonic() - sent
                assert isinstance(error, stridor.Interrupted) and "stopped" in error.what, error
                print(late)
    """)
    delays = sorted(float(line) for line in done.stdout.split())
    assert len(delays) == 5, done.stderr
    # a tenth of a second on a machine of one's own; without the look for signals it would be minutes
    assert min(delays) < 2.0, delays


def test_ctrl_c_ends_an_evaluation_and_a_chart_which_goes_on():
    done = script("""
        import numpy, xarray
        try:
            later(0.4)
            stridor.evaluate(case, {"preload": numpy.geomspace(5, 500, 50)})
        except stridor.Interrupted:
            print("evaluation", time.monotonic() - sent < 20.0)
        axes = {"x": stridor.axis("preload", 2, 4000, 100), "y": stridor.axis("mu_d", 0, 0.8, 100)}
        chart = {"case": stridor.case("noise-chart"), "out": "pair", **axes}
        try:
            later(0.4)
            stridor.chart(**chart)
        except stridor.Interrupted as error:
            print(error.suggestion)
        first = []
        stridor.chart(**chart, progress=lambda done, total, counts: first.append(done))
        print(first[0] > 0)
    """)
    assert done.stdout.splitlines() == ["evaluation True", "Run it again to go on.", "True"], done.stderr + done.stdout


def test_a_chart_without_a_folder_says_that_nothing_is_kept():
    done = script("""
        try:
            later(0.4)
            stridor.chart(stridor.case("noise-chart"), x=stridor.axis("preload", 2, 4000, 400),
                          y=stridor.axis("mu_d", 0, 0.8, 400))
        except stridor.Interrupted as error:
            print(error.why)
    """)
    assert done.stdout == "a chart without a folder keeps nothing\n", done.stderr


def test_a_handler_that_throws_nothing_does_not_end_the_work():
    done = script("""
        heard = []
        signal.signal(signal.SIGINT, lambda *_: heard.append(1))
        case = stridor.case("squeal")
        case.set({"run.duration": 1000.0})
        expected = stridor.simulate(case)
        later(0.05)
        print(stridor.simulate(case) == expected, heard)
    """)
    assert done.stdout == "True [1]\n", done.stderr


def test_a_handler_of_its_own_throws_its_own():
    done = script("""
        class Mine(Exception): pass
        def handler(*_): raise Mine("mine")
        signal.signal(signal.SIGINT, handler)
        try:
            later(0.2)
            stridor.simulate(case)
        except Mine as error:
            print(error)
        print(signal.getsignal(signal.SIGINT) is handler)
    """)
    assert done.stdout == "mine\nTrue\n", done.stderr


def test_the_handler_of_python_is_back_after_each_run():
    done = script("""
        stridor.simulate(stridor.case("squeal"))
        try:
            later(0.05)
            time.sleep(60)
        except KeyboardInterrupt:
            print("python's")
    """)
    assert done.stdout == "python's\n", done.stderr


def test_signals_are_handled_while_a_chart_is_computed():
    done = script("""
        class Mine(Exception): pass
        def handler(*_): raise Mine("terminated")
        signal.signal(signal.SIGTERM, handler)
        try:
            later(0.3, signal.SIGTERM)
            stridor.chart(stridor.case("noise-chart"), x=stridor.axis("preload", 2, 4000, 400),
                          y=stridor.axis("mu_d", 0, 0.8, 400))
        except Mine as error:
            print(error, time.monotonic() - sent < 20.0)
    """)
    assert done.stdout == "terminated True\n", done.stderr


def test_an_exception_of_the_callback_comes_out_and_the_store_stays_good():
    axes = {"x": stridor.axis("preload", 2, 4000, 60), "y": stridor.axis("mu_d", 0, 0.8, 60)}

    def stop(done, total, counts):
        if done > 100:
            raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="mine"):
        stridor.chart(stridor.case("noise-chart"), out="pair", progress=stop, **axes)
    stridor.chart(stridor.case("noise-chart"), out="pair", **axes)
    whole = stridor.chart(stridor.case("noise-chart"), out="whole", **axes)
    assert (whole.categories() == stridor.open_chart("pair").categories()).all()
    with open("pair/chart.csv", "rb") as one, open("whole/chart.csv", "rb") as other:
        assert one.read() == other.read()


def test_threads_of_python_run_at_once():
    case = stridor.case("squeal")
    expected = stridor.simulate(case)
    failures = []

    def work():
        for _ in range(50):
            if stridor.simulate(case) != expected:
                failures.append(1)

    threads = [threading.Thread(target=work) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures


def test_another_thread_goes_on_while_a_run_is_computed():
    case = stridor.case("squeal")
    case.set({"run.duration": 1000.0})
    turns = 0
    end = False

    def count():
        nonlocal turns
        while not end:
            turns += 1

    def rate(work):
        nonlocal turns
        start, turns_before = time.perf_counter(), turns
        work()
        return (turns - turns_before) / (time.perf_counter() - start)

    thread = threading.Thread(target=count)
    thread.start()
    alone, beside = [], []
    try:
        # work of Python's own that needs no lock either, so that what others take of the machine takes from both
        for _ in range(9):
            alone.append(rate(lambda: hashlib.pbkdf2_hmac("sha256", b"word", b"salt", 500_000)))
            beside.append(rate(lambda: stridor.simulate(case)))
    finally:
        end = True
        thread.join()
    share = statistics.median(beside) / statistics.median(alone)
    print(f"turns of another thread beside a run, as a share of those beside hashing: {share:.3f}")
    assert share > 0.7, (alone, beside)


def test_a_thousand_calls_do_not_grow():
    case = stridor.case("squeal")
    case.set({"run.duration": 0.3, "run.window": 0.3})

    def work(count):
        for k in range(count):
            motion = stridor.simulate(case)
            motion.going.category
            case.contact.preload = 20.0 + k * 1e-3
            try:
                case.contact.preload = -1
            except stridor.InputError:
                pass
        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

    before = work(200)
    assert work(1000) - before < 4096  # [KiB]


def test_a_process_ends_while_a_thread_computes():
    text = textwrap.dedent(ENDLESS) + textwrap.dedent("""
        threading.Thread(target=stridor.simulate, args=(case,), daemon=True).start()
        time.sleep(0.2)
        print("end")
    """)
    done = subprocess.run([sys.executable, "-B", "-c", text], capture_output=True, text=True, timeout=60)
    assert done.stdout == "end\n" and done.returncode == 0, done
