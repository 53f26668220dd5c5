"""Stability, advice, sounds, the noise library: what the program says."""

import json
import pickle

import pytest
from conftest import needed

import stridor


def test_stability_is_what_the_program_says(squeal, program):
    squeal.save("squeal.toml")
    said = json.loads(program("stability", "squeal.toml", "--over", "mu_d=0:0.8:21", "--json"))
    scan = stridor.stability(squeal, over=stridor.axis("mu_d", 0, 0.8, 21, scale="linear"))
    assert scan.to_dict() == said
    assert round(scan.going.boundaries[0], 5) == 0.44942 and scan.coming.boundaries == []
    assert len(scan.going.values) == len(scan.going.growths) == len(scan.going.kinds) == 21
    assert pickle.loads(pickle.dumps(scan)) == scan
    assert "flutter" in scan._repr_html_() and "flutter" in repr(scan)


def test_stability_along_preload_has_units(squeal):
    needed("matplotlib").use("agg")
    ax = stridor.stability(squeal, over=stridor.axis("preload", "5 N", 50)).plot(direction="coming")
    assert ax.get_xlabel() == "preload [N]"
    with pytest.raises(stridor.InputError):
        stridor.stability(squeal).plot()
    for wrong in ("mu_d", stridor.axis("preload", 2, 1), stridor.axis("run.engine", 1, 2),
                  stridor.axis("preload", 1, 2, 1)):
        with pytest.raises(stridor.InputError):
            stridor.stability(squeal, over=wrong)


def test_advice_is_what_the_program_says(squeal, program):
    squeal.save("squeal.toml")
    said = json.loads(program("advise", "squeal.toml", "--over", "preload=5:50", "--tolerance", "preload=10 %",
                              "--samples", "32", "--json"))
    advice = stridor.advise(squeal, over={"preload": "5:50"}, tolerances={"preload": "10 %"}, samples=32)
    assert advice.to_dict() == said
    assert advice.category == "squeal" and advice.runs == said["runs"] and advice.chance == said["chance"]
    assert pickle.loads(pickle.dumps(advice)) == advice


@pytest.mark.parametrize("wrong", [
    {"over": ["preloda"]}, {"over": {"preload": "50:5"}}, {"over": ["preload"], "tolerances": {"preload": "ten"}},
    {"over": ["preload"], "tolerances": {"preload": "1 kg"}}, {"samples": 0, "over": ["preload"]},
    {"samples": 10**12, "over": ["preload"]}])
def test_wrong_questions_are_refused(squeal, wrong):
    with pytest.raises(stridor.InputError):
        stridor.advise(squeal, **wrong)


def test_a_sound_is_what_the_program_writes(squeal, program):
    squeal.save("squeal.toml")
    program("listen", "squeal.toml", "-o", "theirs.wav", "--seconds", "0.4 s", "--of", "plate")
    sound = stridor.listen(squeal, seconds=0.4, of="plate")
    sound.save("mine.wav")
    with open("mine.wav", "rb") as mine, open("theirs.wav", "rb") as theirs:
        assert mine.read() == theirs.read()
    assert sound.about["duration"] == 0.4 and "<audio" in sound._repr_html_()
    again = pickle.loads(pickle.dumps(sound))
    assert again.about == sound.about


def test_a_recording_is_heard_as_the_program_hears_it(squeal, program):
    stridor.listen(squeal, seconds=0.4).save("door.wav")
    heard = stridor.read_sound("door.wav").classify()
    assert heard.to_dict() == json.loads(program("classify", "door.wav", "--json"))
    assert heard.category == "squeal" and heard.segments and "squeal" in heard._repr_html_()
    assert stridor.read_sound("door.wav", channel=1).classify().category == "squeal"


def test_wrong_sounds_are_refused(squeal):
    for wrong in ({"of": "door"}, {"quantity": "loudness"}, {"component": "z"}, {"direction": "up"},
                  {"seconds": "1 kg"}, {"seconds": -1.0}, {"rate": 1.0}, {"rate": float("nan")}):
        with pytest.raises(stridor.InputError):
            stridor.listen(squeal, **wrong)
    with pytest.raises(OSError):
        stridor.read_sound("missing.wav")
    with open("text.wav", "w", encoding="utf-8") as file:
        file.write("no sound")
    for wrong in ({}, {"channel": 7}, {"full_scale": "2 kg N"}):
        with pytest.raises(stridor.Error):
            stridor.read_sound("text.wav", **wrong).classify()


def test_the_library_finds_what_the_program_finds(squeal, program):
    stridor.listen(squeal, seconds=0.4).save("door.wav")
    program("library", "add", "door.wav", "--library", "noises.sqlite")
    noises = stridor.library("noises.sqlite")
    said = json.loads(program("library", "list", "--library", "noises.sqlite", "--json"))["entries"]
    found = noises.find()
    assert [entry["id"] for entry in found] == [entry["id"] for entry in said] and len(found) == 1
    assert found[0]["category"] == "squeal"
    assert len(noises.find(category="squeal")) == 1 and noises.find(category="creak") == []
    assert noises.find("preload > 10 N and category = squeal", sort="-preload")
    needed("pandas")
    assert len(noises.to_pandas(category="squeal")) == 1
    for wrong in ({"colour": "red"}, {"where": "preload >"}, {"sort": "colour"}):
        with pytest.raises(stridor.InputError):
            noises.find(**wrong)
