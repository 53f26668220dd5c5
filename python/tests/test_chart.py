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
            assert chart.to_xarray().identical(file)
    named = stridor.words(chart.to_xarray())
    assert set(numpy.unique(named.category)) <= {"none", "squeal", "squeak", "creak", "undecided", "not_done"}
    assert (named.category.values == chart.categories()).all()


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
