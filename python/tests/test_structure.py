"""Structures of one's own as arrays: the numbers arrive as they are, and what does not fit is refused."""

import pickle

import numpy
import pytest
from conftest import needed

import stridor

MASS = numpy.diag([0.1, 0.1])
STIFFNESS = numpy.array([[1e5, -4e4], [-4e4, 2e5 / 3]])
VALUES = {"preload": "5 N", "mu_s": 0.8, "mu_d": 0.3, "drive.kind": "constant", "drive.velocity": "20 mm/s"}
FOOT = {"name": "foot", "normal": [0, 1], "tangent": [1, 0]}
BLOCK = {"mass": MASS, "stiffness": STIFFNESS, "contacts": [FOOT], "values": VALUES, "rows": ["x", "y"]}


def matrix_in(case, name):
    import tomllib

    return numpy.array(tomllib.loads(case.to_toml())["structure"][name], dtype=float)


def random_structure(rows, seed):
    random = numpy.random.default_rng(seed)
    root = random.normal(size=(rows, rows)) / 3.0
    stiffness = (root @ root.T + numpy.eye(rows)) * 1e5
    return {"mass": numpy.diag(random.uniform(0.1, 1.0, rows)), "stiffness": (stiffness + stiffness.T) / 2}


def test_it_is_what_the_file_of_the_same_numbers_is(program):
    case = stridor.structure(**BLOCK, damping_ratio=0.01, title="a block")
    with open("own.toml", "w") as file:
        file.write('title = "a block"\n[structure]\nrows = ["x", "y"]\nmass = [[0.1, 0], [0, 0.1]]\n'
                   f"stiffness = [[1e5, -4e4], [-4e4, {2e5 / 3!r}]]\ndamping_ratio = 0.01\n"
                   '[[structure.contact]]\nname = "foot"\nnormal = "y"\ntangent = "x"\n'
                   '[contact]\npreload = "5 N"\nstatic_friction = 0.8\nkinetic_friction = 0.3\n'
                   '[drive]\nkind = "constant"\nvelocity = "20 mm/s"\n')
    assert case == stridor.read("own.toml")
    case.save("python.toml")
    assert program("simulate", "python.toml") == program("simulate", "own.toml")
    assert pickle.loads(pickle.dumps(case)) == case == eval(repr(case))


@pytest.mark.parametrize("seed", range(20))
def test_numbers_arrive_bit_for_bit(seed):
    rows = 2 + seed % 5
    more = random_structure(rows, seed)
    normal, tangent = numpy.eye(rows)[0], numpy.eye(rows)[1]
    start = numpy.random.default_rng(seed).normal(size=rows) * 1e-3
    case = stridor.structure(**more, contacts=[{"name": "tip", "normal": normal, "tangent": tangent}], values=VALUES,
                             initial_velocity=start)
    for name, matrix in more.items():
        assert (matrix_in(case, name) == matrix).all()
    import tomllib

    assert tomllib.loads(case.to_toml())["structure"]["initial_velocity"] == start.tolist()


def test_sparse_and_other_arrays_are_the_same():
    sparse = needed("scipy.sparse").sparse
    dense = stridor.structure(**BLOCK)
    assert stridor.structure(**{**BLOCK, "mass": sparse.csr_matrix(MASS), "stiffness": sparse.coo_array(STIFFNESS)}) \
        == dense
    assert stridor.structure(**{**BLOCK, "mass": MASS.tolist(), "stiffness": numpy.asfortranarray(STIFFNESS)}) == dense
    rows = sparse.csr_matrix([[0.0, 1.0]])
    assert stridor.structure(**{**BLOCK, "contacts": [{**FOOT, "normal": rows, "tangent": "x"}]}) == dense


def test_many_rows_and_contacts_come_in():
    blocks = 150
    chain = 2 * numpy.eye(blocks) - numpy.eye(blocks, k=1) - numpy.eye(blocks, k=-1)
    stiffness = numpy.kron(numpy.diag([1.0, 5.0]), 1e5 * chain / 3.0)
    unit = numpy.eye(2 * blocks)
    contacts = [{"name": f"block{k}", "normal": unit[blocks + k], "tangent": unit[k], "initial_gap": 0.0}
                for k in range(0, blocks, 5)]
    pressed = {key: value for key, value in VALUES.items() if key != "preload"}
    case = stridor.structure(mass=0.1 * numpy.eye(2 * blocks), stiffness=stiffness, contacts=contacts, values=pressed,
                             load=numpy.where(numpy.arange(2 * blocks) < blocks, 0.0, -1.5))
    assert case.structure.stiffness_scale == 1.0 and case.replace({"mu_d": 0.2}).contact.kinetic_friction == 0.2


def test_outputs_and_all_the_rest_come_in():
    case = stridor.structure(**BLOCK, damping=numpy.diag([1.0, 2.0]), rayleigh_mass=0.5, rayleigh_stiffness=1e-6,
                             initial_displacement=[1e-6, 0], initial_velocity=[1, 0],
                             outputs={"lean": [1, -1], "up": "y"})
    text = case.to_toml()
    assert 'name = "lean"' in text and "initial_displacement" in text
    assert stridor.listen(case, of="lean", seconds=0.1).about["of"] == "lean"


@pytest.mark.parametrize("more, said", [
    ({"mass": [[1.0, 0.0]]}, "square"), ({"mass": numpy.eye(3)}, "rows"), ({"mass": [1, 2]}, "square"),
    ({"mass": [[1, 2], [3]]}, "real numbers"), ({"mass": [["a"]]}, "real numbers"), ({"mass": 1j * MASS}, "real"),
    ({"mass": [[numpy.nan, 0], [0, 1]]}, "finite"), ({"mass": -MASS}, "negative"), ({"mass": 5.0}, "square"),
    ({"stiffness": [[1e5, 1], [0, 1e5]]}, "symmetric"), ({"contacts": []}, ""), ({"contacts": ["foot"]}, "contact"),
    ({"contacts": [{**FOOT, "normal": [0, 0]}]}, "zero"), ({"contacts": [{**FOOT, "normal": [0, 1, 0]}]}, ""),
    ({"contacts": [{**FOOT, "slope": 1}]}, "slope"), ({"contacts": [{**FOOT, "normal": numpy.eye(2)}]}, "shape"),
    ({"rows": ["x"]}, "rows"), ({"values": {}}, "missing keys"), ({"values": {**VALUES, "prelod": 1}}, "preload"),
    ({"values": {**VALUES, "mu_d": 0.9}}, "mu_s"), ({"load": [[1, 2], [3, 4]]}, "shape"), ({"load": [1.0]}, ""),
    ({"damping_ratio": "much"}, "real"), ({"title": "\ud800"}, "half a character")])
def test_what_does_not_fit_is_refused(more, said):
    with pytest.raises(stridor.InputError) as caught:
        stridor.structure(**{**BLOCK, **more})
    assert said in str(caught.value) and "/tmp" not in str(caught.value) and caught.value.place is None


def test_a_huge_one_is_refused_before_it_takes_memory():
    sparse = needed("scipy.sparse").sparse
    with pytest.raises(stridor.InputError, match="2000 rows"):
        stridor.structure(**{**BLOCK, "mass": sparse.identity(10 ** 6)})


def big_structure(rows=500, seed=7):
    """One whose matrices make 6 MB of text."""
    random = numpy.random.default_rng(seed)
    unit = numpy.eye(rows)
    contacts = [{"name": f"tip {k}", "normal": unit[k], "tangent": unit[k + 1], "initial_gap": 0.0, "drive_share": 0.3,
                 "position": random.normal(size=3)} for k in range(0, rows, rows // 20)]
    pressed = {key: value for key, value in VALUES.items() if key != "preload"}
    load = random.normal(size=rows) - 3.0
    return stridor.structure(**random_structure(rows, seed), contacts=contacts, values=pressed, load=load,
                             damping_ratio=0.1 / 3.0, initial_velocity=random.normal(size=rows) * 1e-4,
                             outputs={"middle": random.normal(size=rows)}, title="big")


def test_a_big_one_is_copied_compared_and_pickled_bit_for_bit():
    import copy

    case = big_structure()
    text = case.to_toml()
    assert len(text) > 50 * 65536
    for again in (copy.deepcopy(case), copy.copy(case), *(pickle.loads(pickle.dumps(case, protocol))
                                                          for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1))):
        assert again == case and again.to_toml() == text
    changed = case.replace({"mu_d": 0.2})
    assert changed != case and pickle.loads(pickle.dumps(changed)) == changed
    assert big_structure(seed=8) != case
    assert "500 rows" in repr(case) and len(repr(case)) < 200


def test_random_big_ones_survive_pickle():
    for seed in range(20):
        rows = 60 + 7 * seed
        case = stridor.structure(**random_structure(rows, seed), values=VALUES, contacts=[
            {"name": "tip", "normal": numpy.eye(rows)[seed], "tangent": numpy.eye(rows)[seed + 1]}])
        again = pickle.loads(pickle.dumps(case))
        assert again == case and again.to_toml() == case.to_toml() and len(case.to_toml()) > 65536
        quick = {"run.duration": 1e-3, "run.window": 1e-3}
        if seed % 5 == 0:
            assert stridor.simulate(again.replace(quick)) == stridor.simulate(case.replace(quick))


@pytest.mark.parametrize("way", ["fork", "spawn"])
def test_big_ones_go_to_other_processes(way):
    import multiprocessing

    case = big_structure(rows=120)
    with multiprocessing.get_context(way).Pool(1) as pool:
        assert pool.map(stridor.Case.to_toml, [case, case.replace({"mu_d": 0.1})]) == \
            [case.to_toml(), case.replace({"mu_d": 0.1}).to_toml()]
        assert pool.map(stridor.Case.copy, [case]) == [case]


@pytest.mark.parametrize("broken", [b"", b"1", b"14:stridor.case/1", b"\xff" * 100, "text"])
def test_broken_pickles_are_refused(broken):
    from stridor._case import _unpickled

    whole = big_structure(rows=60).__reduce__()[1][0]
    for packed in (broken, whole[:-1], whole[: len(whole) // 2], whole + b"x"):
        with pytest.raises((stridor.InputError, TypeError)):
            _unpickled(packed)


# what version 0.1.0 made before its bytes had the keys of contacts in them, compressed
FIRST_FORM = """
    eNqNVDFv00AUToGhugEJiSGj5Z3USZrSDiidUAdALJ2qyLqen9Mj9tm9O6e0v4C/ABsj8AuYyooEEgIxIiGxMoSNgYF3l7Np3TjhLef3vXvv3vfu
    O99szU1pyaNMdhhVsNHdvz5HNdcJePc8P4s9fQRezKXSXpzJ1CfkAHMKpgsJIyKzE4X7DkZEaR7HApQKFaM2uUsimuZcjC8g5IBlQlOmRySXkGQ0
    MqcMvEc+FqCaszCWnGmeCcSDzjaZcAFX4D7haY5FTG6eUDyamb4iyafYE6bYqngS1hTaJ1M8iXF9atCgE/S8dEOZBFmIEYkKSV1lv+shfoL52Unl
    csE1p4nxJSisBmKMTRk/zSTQAhEqk9MQRIRkbU8ym4IwlCC3deDOlmdPnIKMuGGPnUltyQzIccFBhyrhuQV2tgnDupPQ8JpY6C5JAGmGODJcwYy8
    T9RxATRBbFwkVM7pmZE5/BCoVnbo1cYcR1kNcWdQBmIJ+CGYnU8v8PbOfHceFxrklCamzhbBIU5CFAGzdxm4PRE3U7ZYDxn+U0envOoRETS1A9M8
    94lAGdl5omowcwxCOwkBZkShvcZQHVEJttHeYKE2dhq0EVy2zVJoVcUeqZ/Qr9lKGhksoeEEE45p7gQXdD18OK2arV/yZsPb7iul+CYZXrJ7fOZp
    7rnYi+fG3g5bDTaPv2+Mz/l9Ge5dBJ/83rXrsx/vLm1G/81rtPuz3dYye/Ctirv/R2vNrU/Lj9Py46ykfcvay+H60rGs9lfZtVprqMH2wo2zamrt
    Bnxx/Gqdeos33ArRGMrYxw/GflZ7N93N1HJ3S3/f2tda/NOwvVQZ388r2hksprWK9uy8Sbh/Xv36/PDwcaPY1lcIvukm12pjw/+M+N/e/gLza2UG
"""


def test_pickles_of_the_first_form_are_read():
    import base64
    import zlib

    from stridor._case import _unpickled

    tip = {"name": "tip", "normal": [0, 1, 0], "tangent": [1, 0, 0], "second_tangent": [0, 0, 1],
           "second_drive_share": 0.25, "static_friction": 0.9, "kinetic_friction": 0.1 + 0.2, "preload_share": 2,
           "drive_share": 1 / 3, "interface": "edge", "position": [0.1, 0, -0.5]}
    toe = {"name": "toe", "normal": [1, 1, 0], "tangent": [1, -1, 0], "initial_gap": 1e-3, "preload_share": 0}
    case = stridor.structure(
        rows=["x", "y", "z"], mass=numpy.diag([0.1, 0.2, 0.3]), damping_ratio=0.1 / 3, contacts=[tip, toe],
        stiffness=[[1e5, -4e4, 0], [-4e4, 2e5 / 3, 0], [0, 0, 3e4]], outputs={"lean": [1, -1, 0]},
        title="of the first form", values={**VALUES, "run.engine": "moreau"})
    old = _unpickled(zlib.decompress(base64.b64decode(FIRST_FORM)))
    assert old == case and old.to_toml() == case.to_toml()
    assert pickle.loads(pickle.dumps(old)) == case
