"""The explorer, started from Python: in a frame, in scripts, and its end."""

import http.client
import json
import os
import pathlib
import signal
import subprocess
import sys
import time
from urllib.parse import urlsplit

import pytest
from conftest import python

import stridor
from stridor import _explorer

SOURCE = ("import stridor; e = stridor.explore(stridor.case('squeal'), browser='none')\n"
          "print(e._process.pid, flush=True)\n")


def is_alive(pid):
    try:
        return pathlib.Path(f"/proc/{pid}/stat").read_text().split(") ")[1][0] != "Z"
    except OSError:
        return False


def ends(pid, limit=10.0):
    end = time.monotonic() + limit
    while is_alive(pid) and time.monotonic() < end:
        time.sleep(0.02)
    return not is_alive(pid)


class Browser:
    """One connection with a session, as a browser's frame has it."""

    def __init__(self, url):
        self.parts = urlsplit(url)
        self.connection = http.client.HTTPConnection("127.0.0.1", self.parts.port, timeout=30)
        answer = self.ask("GET", f"{self.parts.path}?{self.parts.query}", {"Sec-Fetch-Site": "same-site"})
        self.status, self.policy = answer.status, answer.headers["Content-Security-Policy"]
        self.cookie = (answer.headers["Set-Cookie"] or "").split(";")[0]

    def ask(self, method, path, headers, body=None):
        self.connection.request(method, path, body, {"Host": self.parts.netloc, **headers})
        answer = self.connection.getresponse()
        answer.text = answer.read().decode()
        return answer

    def simulate(self, origin):
        headers = {"Cookie": self.cookie, "Origin": origin, "Content-Type": "application/json"}
        return self.ask("POST", "/api/simulate", headers, json.dumps({"preset": "file"}))


def test_the_case_is_shown_to_its_notebook_alone(squeal):
    squeal.title = "mine, with <angle> & \"quotes\""
    with stridor.explore(squeal, frame="http://localhost:8888", browser="none") as explorer:
        first = explorer.url
        card = explorer._repr_html_()
        assert f'src="{first}"' in card and 'height="720"' in card and card.startswith("<iframe")
        browser = Browser(first)
        assert browser.status == 200 and browser.policy.endswith("; frame-ancestors http://localhost:8888")
        page = browser.ask("GET", "/api/start", {"Cookie": browser.cookie})
        assert page.status == 200 and squeal.title in json.dumps(json.loads(page.text), ensure_ascii=False)\
            .replace('\\"', '"')
        assert browser.simulate(f"http://{browser.parts.netloc}").status == 200
        for origin in ("http://localhost:8888", "http://localhost:1", "http://evil.example", "null"):
            assert browser.simulate(origin).status == 403
        # the link is used, and the next one follows
        assert Browser(first).status == 403
        end = time.monotonic() + 10
        while explorer.url == first and time.monotonic() < end:
            time.sleep(0.01)
        assert explorer.url != first and Browser(explorer.url).status == 200
    assert not explorer.is_running and "ended" in repr(explorer) and "<iframe" not in explorer._repr_html_()


@pytest.mark.parametrize("frame", ["*", "", "http://evil.example", "http://localhost:8888/tree", "http://localhost *",
                                   "http://localhost:8888\0", 8888, ["http://localhost:8888"]])
def test_other_origins_are_refused(frame):
    with pytest.raises(stridor.InputError):
        stridor.explore(frame=frame, browser="none")


def test_a_case_that_is_none_is_refused_before_it_starts(squeal):
    with pytest.raises(stridor.InputError, match="none"):
        stridor.explore(squeal, browser="firefox")


def test_a_program_that_is_not_there_is_said(squeal, monkeypatch):
    monkeypatch.setattr("stridor._program._folders", lambda: iter(()))
    monkeypatch.setenv("PATH", "")
    with pytest.raises(stridor.FileError, match="STRIDOR_PROGRAM"):
        stridor.explore(squeal)


@pytest.mark.parametrize("how", ["exit", "exception", "kill", "os._exit"])
def test_it_ends_with_its_process_however_that_ends(how):
    last = {"exit": "", "exception": "1 / 0\n", "kill": "import time; time.sleep(60)\n",
            "os._exit": "import os; os._exit(3)\n"}
    process = subprocess.Popen([sys.executable, "-B", "-c", SOURCE + last[how]], stdout=subprocess.PIPE, text=True,
                               stderr=subprocess.DEVNULL)
    pid = int(process.stdout.readline())
    assert is_alive(pid) or how != "kill"
    if how == "kill":
        process.send_signal(signal.SIGKILL)
    process.wait(timeout=30)
    assert ends(pid)


def test_it_outlives_the_thread_that_asked_for_it(squeal):
    import threading

    made = []
    thread = threading.Thread(target=lambda: made.append(stridor.explore(squeal, browser="none")))
    thread.start()
    thread.join()
    time.sleep(0.3)
    try:
        assert made[0].is_running and Browser(made[0].url).status == 200
    finally:
        made[0].close()


def test_a_forked_child_does_not_end_it(squeal):
    with stridor.explore(squeal, browser="none") as explorer:
        child = os.fork()
        if child == 0:
            explorer.close()
            os._exit(0)
        os.waitpid(child, 0)
        assert explorer.is_running


def test_a_script_prints_its_link_and_waits(squeal):
    text = ("import os, signal, threading, stridor\n"
            "e = stridor.explore(stridor.case('squeal'))\n"
            "threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()\n"
            "e.wait(); print(e.is_running)\n")
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    done = python(text, env=environment)
    link, state = done.stdout.split()
    assert link.startswith("http://localhost:") and state == "False", done.stderr


@pytest.mark.parametrize("about, origin", [
    ('{"url": "http://127.0.0.1:8890/lab"}', "http://127.0.0.1:8890"),
    ('{"url": "http://localhost:8889/"}', "http://localhost:8889"),
    ('{"url": "https://0.0.0.0:9000/"}', "https://localhost:9000"), ("[]", "http://localhost:8888"),
    ("torn", "http://localhost:8888"), ('{"url": "http://a:b/"}', "http://localhost:8888")])
def test_the_notebooks_server_says_its_address(tmp_path, monkeypatch, about, origin):
    monkeypatch.setenv("JUPYTER_RUNTIME_DIR", str(tmp_path))
    monkeypatch.setenv("JPY_PARENT_PID", "4711")
    (tmp_path / "jpserver-4711.json").write_text(about)
    assert _explorer._notebook_origin() == origin
    monkeypatch.setenv("JPY_PARENT_PID", "../4711")
    assert _explorer._notebook_origin() == "http://localhost:8888"
