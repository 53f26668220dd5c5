"""What the program's tests of bad input refuse is refused here alike: their own list is read, so that it is one."""

import codecs
import os
import re
import subprocess
import sys

import pytest
from conftest import ROOT

import stridor

SOURCE = (ROOT / "tests" / "program" / "bad_input_test.cpp").read_text(encoding="utf-8")
TEXT = r'"((?:[^"\\]|\\.)*)"'
KINDS = {2: stridor.InputError, 3: stridor.NumericalError, 5: stridor.FileError}
# expect_refused(simulate(squeal_with("line", "other line")), exit code, {"words", ...})
FILES = re.findall(rf"simulate\(squeal_with\({TEXT},\s*{TEXT}\)\),\s*(\d),\s*\{{(.*?)\}}\)", SOURCE, re.DOTALL)
# expect_refused(simulate(text, {"--set", "key=value"}), ...)
CHANGES = re.findall(rf'simulate\(text, \{{"--set", {TEXT}\}}\),\s*(\d),\s*\{{(.*?)\}}\)', SOURCE, re.DOTALL)


def plain(text):
    """As C++ reads it."""
    return codecs.decode(text, "unicode_escape")


def words(text):
    return [plain(word) for word in re.findall(TEXT, text)]


def said_alike(error, stderr):
    """All that the exception says stands in what the program says."""
    said = " ".join(stderr.split())
    for what, why, suggestion, place in error.complaints:
        for text in (what, why, suggestion):
            assert " ".join(text.split()) in said, f"{text!r} is not in {stderr!r}"
        if place is not None and place.line:
            assert f"{place.file}:{place.line}" in said


def test_the_list_is_read_as_it_is_written():
    assert len(FILES) == len(re.findall(r"expect_refused\(\s*simulate\(squeal_with\(", SOURCE)) > 5
    assert len(CHANGES) == len(re.findall(r"expect_refused\(\s*simulate\(text,", SOURCE)) > 2


@pytest.mark.parametrize("line, other, code, said", FILES, ids=[file[1][:40] for file in FILES])
def test_a_bad_file_is_the_programs(program, line, other, code, said):
    text = program("init", "squeal")
    changed = re.sub("(?m)^" + re.escape(plain(line)) + ".*$", lambda _: plain(other), text, count=1)
    assert changed != text
    with open("case.toml", "w", encoding="utf-8") as file:
        file.write(changed)
    with pytest.raises(subprocess.CalledProcessError) as refused:
        program("simulate", "case.toml")
    assert refused.value.returncode == int(code)
    with pytest.raises(KINDS[int(code)]) as caught:
        stridor.simulate(stridor.read("case.toml"))
    said_alike(caught.value, refused.value.stderr)
    places = [f"{place.file}:{place.line}" for *_, place in caught.value.complaints if place is not None]
    told = " ".join([str(caught.value), *places])
    # the caret below the line is the terminal's: place.source_line and .column say the same
    assert all(word in told for word in words(said) if word != "^")


@pytest.mark.parametrize("change, code, said", CHANGES, ids=[change[0] for change in CHANGES])
def test_a_bad_change_is_the_programs(program, squeal, change, code, said):
    squeal.save("case.toml")
    with pytest.raises(subprocess.CalledProcessError) as refused:
        program("simulate", "case.toml", "--set", plain(change))
    assert refused.value.returncode == int(code)
    if "=" not in change:
        pytest.skip("no mapping lacks its value")
    with pytest.raises(KINDS[int(code)]) as caught:
        squeal.set(dict([plain(change).split("=", 1)]))
    said_alike(caught.value, refused.value.stderr)
    assert all(word in str(caught.value) for word in words(said))


def test_a_missing_file_and_a_broken_one_are_the_programs(program):
    with open("broken.toml", "w", encoding="utf-8") as file:
        file.write("[joint\nmass = 1")
    for name, kind in (("nowhere.toml", stridor.FileError), ("broken.toml", stridor.InputError)):
        with pytest.raises(subprocess.CalledProcessError) as refused:
            program("simulate", name)
        with pytest.raises(kind) as caught:
            stridor.read(name)
        assert KINDS[refused.value.returncode] is kind
        said_alike(caught.value, refused.value.stderr)


def changed_by_lines(text, changes):
    """Lines that begin so become others."""
    for line, other in changes.items():
        text, count = re.subn("(?m)^" + re.escape(line) + ".*$", lambda _, to=other: to, text, count=1)
        assert count == 1, line
    return text


def refused_alike(program, kind, name="case.toml"):
    """The error of reading and running a file, which is the program's."""
    with pytest.raises(subprocess.CalledProcessError) as refused:
        program("simulate", name)
    with pytest.raises(kind) as caught:
        stridor.simulate(stridor.read(name))
    assert KINDS[refused.value.returncode] is kind
    said_alike(caught.value, refused.value.stderr)
    return caught.value


def test_all_that_is_wrong_is_told_at_once(program):
    text = changed_by_lines(program("init", "squeal"), {
        "preload =": 'preload = "20,5 N"', "incidence_angle =": 'incidence_angle = "720 rpm"',
        "damping =": "dampening = 1", "quiet_slip =": "quiet_slip = 2"})
    with open("case.toml", "w", encoding="utf-8") as file:
        file.write(text)
    error = refused_alike(program, stridor.InputError)
    assert len(error.complaints) == 4


def test_a_changed_kind_of_drive_lacks_its_value(program):
    with open("case.toml", "w", encoding="utf-8") as file:
        file.write(changed_by_lines(program("init", "squeal"), {"kind =": 'kind = "constant"'}))
    error = refused_alike(program, stridor.InputError)
    assert "missing key drive.velocity" in str(error)


def test_many_errors_are_all_there(program):
    with open("case.toml", "w", encoding="utf-8") as file:
        file.write("[joint]\n" + "".join(f"nonsense_{k} = 1\n" for k in range(30)))
    with pytest.raises(stridor.InputError) as caught:
        stridor.read("case.toml")
    assert len(caught.value.complaints) > 30 - 1


def test_a_truncated_table_is_the_programs(program):
    text = changed_by_lines(program("init", "squeal"), {
        "kind =": 'kind = "sampled"\nfile = "v.csv"', "amplitude =": "", "frequency =": ""})
    with open("case.toml", "w", encoding="utf-8") as file:
        file.write(text)
    with open("v.csv", "w", encoding="utf-8") as file:
        file.write("time,velocity\ns,m/s\n0,0.1\n0.5,")
    error = refused_alike(program, stridor.InputError)
    assert [place.line for *_, place in error.complaints] == [4]


def small_chart(**options):
    case = stridor.case("noise-chart")
    case.set({"run.duration": 0.01, "run.window": 0.005, **options})
    return stridor.chart(case, x=stridor.axis("contact.preload", 2, 4000, 2),
                         y=stridor.axis("contact.kinetic_friction", 0.1, 0.7, 2), out="out")


def test_a_store_of_another_case_is_refused_by_the_first_difference():
    small_chart()
    with pytest.raises(stridor.InputError, match="contact.static_friction") as caught:
        small_chart(**{"contact.static_friction": 0.9})
    assert "0.8" in str(caught.value)
    assert "0.9" in str(caught.value)


def test_a_file_that_is_no_store_is_refused(tmp_path):
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "chart.sqlite").write_text("this is no database, but it is long enough to be looked at as one")
    os.chdir(tmp_path)
    with pytest.raises(stridor.InputError, match="chart.sqlite"):
        small_chart()


def test_a_full_disk_is_a_file_error():
    # a limit on the size of files stands for the disk
    script = """if True:
        import resource
        import stridor
        motion = stridor.simulate(stridor.case("squeal"))
        sound = stridor.listen(stridor.case("squeal"))
        resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))
        for save in (lambda: sound.save("squeal.wav"),
                     lambda: stridor.chart(stridor.case("noise-chart"), x=stridor.axis("contact.preload", 2, 4000, 24),
                                           y=stridor.axis("contact.kinetic_friction", 0.1, 0.7, 24), out="full")):
            try:
                save()
            except stridor.FileError as error:
                assert isinstance(error, OSError)
                print("refused:", error.what)
        """
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert done.stdout.count("refused:") == 2, done.stdout
    assert "squeal.wav" in done.stdout
    assert not os.path.exists("squeal.wav")
