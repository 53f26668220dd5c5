"""Charts: the store, what is read from it, pictures."""

import pathlib
import pickle

import pytest
from conftest import needed

import stridor

numpy = needed("numpy")


def test_a_chart_is_the_programs(small_chart, program):
    chart = small_chart(refine=1, out="mine")
    text = pathlib.Path("mine/chart.toml").read_text(encoding="utf-8")
    pathlib.Path("again.toml").write_text(text, encoding="utf-8")
    program("chart", "again.toml", "--out", "theirs")
    for name in ("chart.csv", "boundaries.csv"):
        assert pathlib.Path("mine", name).read_bytes() == pathlib.Path("theirs", name).read_bytes()
    opened = stridor.open_chart("theirs")
    assert (opened.categories() == chart.categories()).all()


def test_the_program_goes_on_with_a_chart_of_python(small_chart, program):
    small_chart(out="pair")
    out = program("chart", "pair/chart.toml", "--out", "pair")
    assert "pair/chart.csv" in out


def test_a_dataset_is_the_opened_file(small_chart):
    xarray = needed("xarray")
    needed("netCDF4")
    for more in ({}, {"refine": 1}, {"starts": ["rest", "sliding"]}):
        folder = f"pair{len(more)}{'s' if 'starts' in more else ''}"
        chart = small_chart(out=folder, **more)
        with xarray.open_dataset(f"{folder}/chart.nc") as file:
            assert chart.to_xarray().identical(stridor.words(file))
    named = chart.to_xarray()
    assert set(numpy.unique(named.category)) <= {"none", "squeal", "squeak", "creak", "undecided", "not_done"}
    assert (named.category.values == chart.categories()).all()
    assert 0 < (named.category == "squeal").sum() == chart.counts()["squeal"]
    assert set(numpy.unique(named.status)) <= set(stridor._stridor.words["status"])
    # words stay words, on a disk too
    named.to_netcdf("words.nc")
    with xarray.open_dataset("words.nc") as file:
        assert (file.category == named.category).all() and stridor.words(named).identical(named)


def test_a_table_has_a_row_for_each_cell(small_chart):
    needed("pandas")
    needed("netCDF4")
    chart = small_chart()
    table = chart.to_pandas()
    assert len(table) == 60
    assert {"preload", "kinetic_friction", "direction", "category", "frequency"} <= set(table.columns)
    assert (table.category == "none").sum() == chart.counts().get("none", 0)


def test_figures_are_views_over_the_grid(small_chart):
    chart = small_chart()
    frequency = chart.figure("frequency")
    assert frequency.shape == (2, 5, 6) and not frequency.flags.owndata and not frequency.flags.writeable
    with pytest.raises(stridor.InputError, match="frequency"):
        chart.figure("frequncy")
    with pytest.raises(stridor.InputError):
        chart.numbers("colour")
    assert sum(chart.counts().values()) == 60
    assert chart.x.unit == "N" and chart.x.values[-1] == 4000.0


def test_a_cell_is_found_by_its_values(small_chart):
    chart = small_chart()
    case = chart.case_at(direction="coming", preload="3.9 kN", kinetic_friction=0.41)
    assert case.contact.preload == 4000.0 and case.contact.kinetic_friction == 0.4
    assert case.drive.velocity < 0
    assert stridor.simulate(case).whole.category == chart.categories()[1, 2, 5]
    for wrong in ({"preload": 20}, {"preload": 20, "mass": 1}, {"preload": 1e9, "kinetic_friction": 0.1}):
        with pytest.raises(stridor.InputError):
            chart.case_at(**wrong)
    with pytest.raises(stridor.InputError):
        chart.case_at(direction="sideways", preload=20, kinetic_friction=0.1)


def test_others_may_open_the_store_meanwhile(small_chart, program):
    chart = small_chart(out="pair")
    program("chart", "pair/chart.toml", "--out", "pair")
    assert sum(chart.counts().values()) == 60
    assert chart.figure("slip").shape == (2, 5, 6)


def test_another_charts_folder_is_refused(small_chart):
    small_chart(out="pair")
    with pytest.raises(stridor.InputError):
        small_chart(out="pair", refine=1)
    with pytest.raises(stridor.Error):
        stridor.open_chart("nowhere")


def test_it_pickles_with_its_cells(small_chart):
    chart = small_chart()
    folder = chart.folder
    bytes_of_it = pickle.dumps(chart)
    frequency = chart.figure("frequency")
    del chart
    assert not folder.exists()
    again = pickle.loads(bytes_of_it)
    numpy.testing.assert_array_equal(again.figure("frequency"), frequency)
    assert "chart over contact.preload" in repr(again)


def test_plots_draw_into_the_axes_they_are_given(small_chart):
    needed("matplotlib").use("agg")
    from matplotlib import pyplot

    chart = small_chart()
    figure, (left, right) = pyplot.subplots(1, 2)
    assert chart.plot("category", direction="coming", ax=left) is left
    assert left.get_title() == "coming" and left.get_xscale() == "log" and left.get_xlabel() == "preload [N]"
    assert {text.get_text() for text in left.get_legend().get_texts()} == set(chart.counts("coming"))
    assert chart.plot("frequency", ax=right) is right
    lines = [line for line in chart.boundaries() if line.direction == "coming"]
    chart.plot_boundaries(direction="coming", ax=left, color="r")
    assert len(left.lines) == len(lines) and all(line.get_color() == "r" for line in left.lines)
    assert chart.plot(ax=None) is pyplot.gca()
    figure.canvas.draw()
    with pytest.raises(stridor.InputError):
        chart.plot("loudness", ax=left)
    pyplot.close("all")


def test_its_card_is_its_picture(small_chart):
    chart = small_chart()
    card = chart._repr_html_()
    assert "<svg" in card and "<?xml" not in card and "squeal" in card
    assert chart.svg("frequency") != chart.svg()


@pytest.mark.parametrize("wrong", [
    {"x": "preload"}, {"x": stridor.axis("preloda", 1, 2)}, {"x": stridor.axis("preload", 2, 1)},
    {"x": stridor.axis("preload", 1, 2, 1)}, {"x": stridor.axis("preload", 1, 2, 10**9)},
    {"x": stridor.axis("preload", "1 kg", 2)}, {"x": stridor.axis("preload", -1, 2, scale="log")},
    {"x": stridor.axis("preload", 1, 2, scale="cubic")}, {"x": stridor.axis("mu_d", 0, 1)},
    {"directions": "up"}, {"directions": []}, {"directions": ["going", "going"]}, {"starts": ["tired"]},
    {"refine": 7}, {"refine": -1}, {"x": stridor.axis("preload", float("nan"), 2)}])
def test_wrong_charts_are_refused(small_chart, wrong):
    with pytest.raises(stridor.InputError):
        small_chart(**wrong)


@pytest.fixture
def diagram(squeal):
    """How a diagram of few cells is made."""
    squeal.set({"run.duration": 0.3, "run.window": 0.3})
    return lambda **more: stridor.chart(squeal, x=stridor.axis("mu_d", 0.2, 0.8, 12), **more)


def test_a_diagram_is_the_programs(diagram, program):
    chart = diagram(out="mine", threads=2)
    pathlib.Path("again.toml").write_text(pathlib.Path("mine/chart.toml").read_text(encoding="utf-8"), encoding="utf-8")
    program("chart", "again.toml", "--out", "theirs")
    for name in ("chart.csv", "diagram.csv", "chart.toml"):
        assert pathlib.Path("mine", name).read_bytes() == pathlib.Path("theirs", name).read_bytes()
    opened = stridor.open_chart("theirs")
    assert opened.to_xarray().identical(chart.to_xarray())
    assert chart.svg() == opened.svg() == pathlib.Path("theirs/chart.svg").read_text(encoding="utf-8")
    assert "frequency" in chart.svg("frequency") and "frequency" not in chart.svg()
    # the program goes on with what Python has kept of it, and the other way round
    assert "diagram:" not in program("chart", "mine/chart.toml", "--out", "mine")
    assert "diagram over contact.kinetic_friction: 12 cells" in repr(chart) and chart.y is None


def test_a_diagram_is_a_dataset_with_its_columns(diagram, squeal):
    needed("xarray"), needed("netCDF4"), needed("pandas")
    chart = diagram()
    data = chart.to_xarray()
    assert chart.categories().shape == chart.figure("slip").shape == (2, 12) == data.category.shape
    assert data.category.dims == ("direction", "kinetic_friction") and float(data.preload) == 20.0
    assert data.extremes.units == "m" and data.beat_intervals.units == "s"
    noisy = (data.category == "squeal").values
    for values in (data.extremes.values, data.beat_intervals.values):
        rising = numpy.diff(values, axis=-1)
        assert (rising[numpy.isfinite(rising)] > 0).all() and numpy.isfinite(values[noisy][:, 0]).all()
    # what is told of a cell is what its motion does: where it turns, and how long a beat is
    way, k = numpy.argwhere(noisy)[0]
    case = chart.case_at(direction=chart.directions[way], x=data.kinetic_friction.values[k])
    assert case.contact.kinetic_friction == data.kinetic_friction.values[k]
    moved = stridor.simulate(case).trace(0, 0.3).displacement.sel(dof="x1").values
    assert moved.min() <= data.extremes.values[way, k, 0] and numpy.nanmax(data.extremes.values[way, k]) <= moved.max()
    stays = stridor.simulate(case).history()
    changes = list(zip(stays.state.values[:-1], stays.state.values[1:], stays["from"].values[1:]))
    between = numpy.concatenate([numpy.diff([time for *states, time in changes if states == list(kind)])
                                 for kind in {change[:2] for change in changes}])
    beats = data.beat_intervals.values[way, k]
    assert numpy.isin(beats[numpy.isfinite(beats)], between).all()
    assert len(chart.to_pandas()) == 24 and "extremes" not in chart.to_pandas()
    assert pickle.loads(pickle.dumps(chart)).to_xarray().identical(data)


def test_a_diagram_is_drawn(diagram):
    needed("matplotlib").use("agg")
    from matplotlib import pyplot

    chart = diagram(directions="going")
    for name, label in (("category", "extremes [m]"), ("beat_intervals", "beat intervals [s]"), ("slip", "slip"),
                        ("frequency", "frequency [Hz]")):
        _, own = pyplot.subplots()
        ax = chart.plot(name, ax=own, color="r")
        assert ax is own and ax.get_ylabel() == label and ax.get_xlabel() == "kinetic friction"
        drawn = ax.lines[0].get_xydata()
        assert len(drawn) and numpy.isfinite(drawn).all() and ax.lines[0].get_color() == "r"
        strip = ax.child_axes[0].collections[0].get_array().reshape(2, -1)
        assert (strip[0] == chart.numbers("category")[0]).all()
        ax.figure.canvas.draw()
        pyplot.close()
    lines = chart.plot_boundaries(ax=pyplot.subplots()[1]).lines
    assert len(lines) == len(chart.boundaries()) > 0
    assert "<svg" in chart._repr_html_()
    with pytest.raises(stridor.InputError, match='Did you mean "frequency"'):
        chart.plot("frequncy")


def test_a_stopped_diagram_is_kept_and_goes_on(diagram):
    def stop(done, total, counts):
        raise RuntimeError("mine")

    with pytest.raises(RuntimeError, match="mine"):
        diagram(out="pair", progress=stop)
    whole = diagram()
    assert diagram(out="pair").to_xarray().equals(whole.to_xarray())
    from stridor.xarray_backend import StoreBackend

    xarray = needed("xarray")
    assert xarray.open_dataset("pair/chart.sqlite", engine=StoreBackend).equals(whole.to_xarray())


@pytest.mark.parametrize("more, said", [
    ({"refine": 1}, "one axis"), ({"y": stridor.axis("mu_d", 0.2, 0.8)}, "two different"), ({"y": "mu_s"}, "no axis"),
    ({"x": stridor.axis("joint.lip9.mass", 1, 2)}, "lip9"), ({"x": stridor.axis("run.engine", 1, 2)}, "no quantity"),
    ({"x": stridor.axis("drive.velocity", 1, 2)}, "changes nothing"), ({"x": None}, "no axis")])
def test_wrong_diagrams_are_refused(diagram, squeal, more, said):
    with pytest.raises(stridor.InputError, match=said):
        stridor.chart(squeal, **{"x": stridor.axis("mu_d", 0.2, 0.8, 12), **more})
    with pytest.raises(stridor.InputError, match="one value. Give kinetic_friction"):
        diagram().case_at()
    with pytest.raises(stridor.InputError, match="It has kinetic_friction"):
        diagram().case_at(preload=3)
