"""Cases: their values, and what becomes of them as text."""

import copy
import math
import os
import pickle
import random

import pytest

import stridor
from stridor import _stridor

FIELDS = _stridor.fields()


def random_value(field, case, chance):
    """A value within its range, with all the bits of a double."""
    low = max(field["low"], -1e9)
    high = min(field["high"], 1e9)
    here = case[field["key"]]
    span = (here * 0.5, here * 1.5) if low <= here * 0.5 <= here * 1.5 <= high else (low, high)
    return chance.uniform(*sorted(span))


def random_case(chance):
    """A case far from its beginning; where values contradict each other the next ones are tried."""
    case = stridor.case(chance.choice(stridor.case_names()))
    quantities = [field for field in FIELDS if field["unit"] and field["key"] in case.keys()]
    for _ in range(chance.randint(1, 4)):
        values = {field["key"]: random_value(field, case, chance) for field in chance.sample(quantities, 2)}
        try:
            case.set(values)
        except stridor.InputError:
            continue
    if chance.random() < 0.3:
        case.title = chance.choice(['"so"', "ü – 声", "back\\slash", '"""', "'''", "\\", " blanks "])
    return case


# STRIDOR_RANDOM_CASES: so many of them; 10000 take two minutes
RANDOM_CASES = int(os.environ.get("STRIDOR_RANDOM_CASES", "1000"))


def test_random_cases_survive_toml_repr_pickle_and_copy_bit_for_bit():
    chance = random.Random(20120423)
    for _ in range(RANDOM_CASES):
        case = random_case(chance)
        kept = case.to_toml()
        for again in (stridor.from_toml(kept), eval(repr(case)), pickle.loads(pickle.dumps(case)), copy.deepcopy(case)):
            assert again == case
            assert again.to_toml() == kept
            assert all(again[key] == case[key] for key in ("run.duration", "title"))


def test_every_field_is_an_attribute_with_unit_and_sentence(squeal):
    for field in FIELDS:
        if not field["section"]:
            continue
        section = type(getattr(squeal, field["section"]))
        documented = getattr(section, field["name"]).__doc__
        assert field["sentence"] in documented
        if field["unit"] not in (None, "1"):
            assert field["unit"] in documented


def test_values_are_si_numbers_and_words(squeal):
    squeal.contact.preload = "0.2 kN"
    assert squeal.contact.preload == 200.0
    squeal.joint.incidence_angle = 110
    assert squeal["alpha"] == 110.0
    assert squeal.run.engine == "exact"
    squeal.drive.amplitude = "4 mm"
    assert squeal.text("drive.amplitude") == "0.004 m"
    squeal["mu_d"] = 0.1
    assert squeal.contact.kinetic_friction == 0.1


def test_numpy_numbers_are_taken(squeal):
    numpy = pytest.importorskip("numpy")
    squeal.contact.preload = numpy.float64(30.0)
    squeal.joint.incidence_angle = numpy.int32(80)
    assert (squeal.contact.preload, squeal.joint.incidence_angle) == (30.0, 80.0)


def test_a_refused_change_leaves_the_case_as_it_was(squeal):
    before = squeal.copy()
    with pytest.raises(stridor.InputError):
        squeal.set({"contact.preload": 50, "contact.kinetic_friction": 0.9})
    assert squeal == before


def test_several_changes_are_held_against_each_other_in_the_end(squeal):
    squeal.set({"contact.kinetic_friction": 0.9, "contact.static_friction": 1.0})
    assert squeal.contact.kinetic_friction == 0.9
    squeal.set({"drive.kind": "constant", "drive.velocity": -0.05})
    assert squeal.drive.velocity == -0.05


def test_copies_are_their_own(squeal):
    other = squeal.copy()
    other.contact.preload = 70
    assert squeal.contact.preload == 20.0
    assert other != squeal
    assert squeal != "squeal"


def test_attributes_that_a_case_lacks_are_attribute_errors_with_advice(squeal):
    assert not hasattr(squeal.contact, "restitution")
    assert not hasattr(squeal.contact, "preloda")
    with pytest.raises(AttributeError, match="sinusoidal|constant"):
        squeal.drive.velocity
    assert "amplitude" in dir(squeal.drive)
    assert "velocity" not in dir(squeal.drive)


def test_joints_have_names():
    case = stridor.case("two-lips")
    assert len(case.joints) == 2
    first, second = case.joints
    case.contact[second].preload = "7 N"
    assert case.contact[second].preload == 7.0
    assert case.contact[first].preload != 7.0
    assert not hasattr(case.contact, "preload")  # they differ
    case.contact.preload = 9
    assert case.contact.preload == 9.0
    case.joint[first].mass = 0.2
    assert case[f"joint.{first}.mass"] == 0.2
    assert pickle.loads(pickle.dumps(case)) == case
    with pytest.raises(stridor.InputError, match="no joint"):
        case.joint["lip9"]


def test_a_sampled_drive_keeps_its_samples_without_its_file(tmp_path):
    case = stridor.case("squeal")
    (tmp_path / "motion.csv").write_text("time [s],velocity [m/s]\n0,0.1\n0.6,0.2\n1.2,-0.1\n")
    case.set({"drive.kind": "sampled", "drive.file": "motion.csv"})
    (tmp_path / "sub").mkdir()
    case.save("sub/sampled.toml")
    (tmp_path / "motion.csv").rename(tmp_path / "sub" / "motion.csv")
    case = stridor.read("sub/sampled.toml")
    assert case.drive.file == "sub/motion.csv"
    expected = stridor.simulate(case).to_dict()["phases"]
    (tmp_path / "sub" / "motion.csv").unlink()
    again = pickle.loads(pickle.dumps(case))
    again.contact.preload = case.contact.preload
    assert stridor.simulate(again).to_dict()["phases"] == expected


def test_every_ready_case_is_there_and_its_card_shows(squeal):
    for name in stridor.case_names():
        case = stridor.case(name)
        assert eval(repr(case)) == case
        assert case._repr_html_().startswith("<details")
    squeal.title = "<script>alert(1)</script>"
    assert "<script>" not in squeal._repr_html_()


def test_the_program_reads_what_python_wrote(squeal, program):
    squeal.contact.preload = 0.1 + 0.2
    squeal.save("mine.toml")
    assert program("check", "mine.toml") is not None
    document = squeal.to_dict()
    assert document["contact"]["preload"] == 0.1 + 0.2
    assert math.isclose(stridor.read("mine.toml").contact.preload, 0.3)


def test_warnings_of_a_file_are_warned_of(squeal):
    text = stridor.case("squeal").to_toml().replace('kind = "sinusoidal"', 'kind = "constant"\nvelocity = "0.1 m/s"')
    with open("left.toml", "w", encoding="utf-8") as file:
        file.write(text)
    with pytest.warns(UserWarning, match="drive.amplitude"):
        assert stridor.read("left.toml").drive.velocity == 0.1
