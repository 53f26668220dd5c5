"""What the program's tests of bad input refuse is refused here alike: their own list is read, so that it is one."""

import codecs
import re
import subprocess

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
