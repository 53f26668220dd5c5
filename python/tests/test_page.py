"""The explorer as one HTML file: from the program, in a cell, and what is said where there is none."""

import html
import os
import pathlib
import re

import pytest

import stridor
from stridor import _html

HEAD = b'<!doctype html>\n<script type="application/json" id="stridor-case">'
TAIL = b"</script>" + bytes(range(128, 256)) + b'<p title="a & b">'


@pytest.fixture
def built(tmp_path, monkeypatch):
    """A program with a page beside it, a short one; without `PAGE` there is none."""
    program = tmp_path / "bin" / "stridor"
    program.parent.mkdir()
    source = pathlib.Path(os.environ["STRIDOR_PROGRAM"])
    try:
        os.link(source, program)
    except OSError:
        program.write_bytes(source.read_bytes())
        program.chmod(0o755)
    monkeypatch.setenv("STRIDOR_PROGRAM", str(program))

    def add():
        (program.parent / "page").mkdir()
        (program.parent / "page" / "page.html").write_bytes(HEAD + b"null" + TAIL)

    return add


def text_of(frame):
    """What a browser reads in the frame, as bytes of windows-1252; C1 letters are their own bytes."""
    found = re.search(r' srcdoc="([^"]*)"', frame)
    return b"".join(letter.encode("cp1252", "ignore") or letter.encode("latin-1")
                    for letter in html.unescape(found[1].replace("&amp;", "&#38;")))


def test_it_holds_the_case(built, squeal, tmp_path):
    built()
    squeal.title = "mine, with <angle> & \"quotes\""
    page = stridor.page(squeal)
    assert page.content.startswith(HEAD) and page.content.endswith(TAIL)
    assert b"\\u003cangle>" in page.content and b"<angle>" not in page.content
    page.save(tmp_path / "seal.html")
    assert (tmp_path / "seal.html").read_bytes() == page.content
    assert stridor.page().content == HEAD + b"null" + TAIL
    assert stridor.page("creak").content != page.content
    assert "MB" in repr(page)


def test_a_cell_has_every_letter_of_it(built):
    built()
    page = stridor.page("squeal")
    assert text_of(page._repr_html_()) == page.content
    assert "allow-" not in page._repr_html_() and _html.escaped("Stridor's explorer") in page._repr_html_()


def test_a_program_without_it_says_what_builds_it(built):
    with pytest.raises(stridor.FileError, match="no page in one file.*\n.*dev page"):
        stridor.page("squeal")


def test_what_is_no_case_is_refused(built):
    built()
    with pytest.raises(stridor.InputError, match="squeel"):
        stridor.page("squeel")
    with pytest.raises(stridor.FileError):
        stridor.page("squeal").save("no/such/folder/seal.html")
