#include "bindings.hpp"
#include "handles.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/drawing/picture.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/chart/chart_csv.hpp"
#include "stridor/io/chart/chart_exports.hpp"
#include "stridor/io/chart/chart_netcdf.hpp"
#include "stridor/io/chart/range_text.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/pictures/diagram.hpp"
#include "stridor/pictures/noise_chart.hpp"
#include "stridor/pictures/parts/chart_cells.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/storage/kept_results.hpp"
#include "stridor/sweep/boundaries.hpp"
#include "stridor/sweep/cell_choice.hpp"
#include "stridor/sweep/diagram.hpp"
#include "stridor/sweep/points.hpp"
#include "stridor/sweep/run.hpp"
#include "stridor/sweep/starts.hpp"
#include "stridor/sweep/store/store.hpp"
#include "work.hpp"

#include <pybind11/stl.h>

#include <filesystem>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace stridor::binding {

namespace {

using Bytes = std::vector<signed char>;
using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

// one of a list of names, or an error with the nearest of them
template <typename Enumeration>
std::vector<Enumeration> chosen(const std::string& what, const std::vector<std::string>& words,
                                std::span<const std::string_view> names) {
    std::vector<Enumeration> list;
    for (const std::string& word : words)
        list.push_back(static_cast<Enumeration>(base::place_of_choice(what, word, names)));
    return list;
}

std::vector<std::string_view> words(std::span<const std::string_view> names) {
    return {names.begin(), names.end()};
}

py::dict python_counts(const sweep::Counts& counts) {
    py::dict numbers;
    for (std::size_t k = 0; k < counts.categories.size(); ++k)
        numbers[py::str(std::string(classification::category_names[k]))] = counts.categories[k];
    numbers[py::str(std::string(classification::name(classification::Quiet::locks)))] = counts.locks;
    for (std::size_t k = 1; k < counts.statuses.size(); ++k)
        numbers[py::str(std::string(sweep::status_names[k]))] = counts.statuses[k];
    return numbers;
}

// number(cell) of all cells
template <typename Cells, typename Number>
py::array_t<signed char> numbers_of(const Cells& cells, const std::vector<py::ssize_t>& shape, Number number) {
    Bytes numbers;
    for (const auto& cell : cells)
        numbers.push_back(static_cast<signed char>(number(cell)));
    return array_of(std::move(numbers), shape);
}

// status, category and why it is quiet of all cells; -1 where a cell is not done
py::dict python_verdicts(const std::vector<sweep::CellVerdict>& cells, const std::vector<py::ssize_t>& shape) {
    using sweep::CellVerdict;
    const auto where_done = [](const CellVerdict& cell, auto of) {
        return cell.status == sweep::Status::done ? static_cast<int>(of) : -1;
    };
    py::dict verdicts;
    verdicts["status"] = numbers_of(cells, shape, [](const CellVerdict& cell) { return cell.status; });
    verdicts["category"] = numbers_of(cells, shape, [&](auto& cell) { return where_done(cell, cell.category); });
    verdicts["quiet_because"] = numbers_of(cells, shape, [&](auto& cell) { return where_done(cell, cell.quiet); });
    verdicts["agreement"] = numbers_of(cells, shape, [](const CellVerdict& cell) { return cell.agreement; });
    return verdicts;
}

/// What is computed of arbitrary points.
py::dict python_points(const std::vector<sweep::Cell>& cells, const std::vector<py::ssize_t>& shape) {
    std::vector<sweep::CellVerdict> verdicts;
    for (const sweep::Cell& cell : cells)
        verdicts.push_back(sweep::verdict_of(cell));
    py::dict result = python_verdicts(verdicts, shape);
    py::dict figures;
    for (const sweep::CellFigure& figure : sweep::cell_figures()) {
        std::vector<double> values;
        values.reserve(cells.size());
        for (const sweep::Cell& cell : cells)
            values.push_back(sweep::figure_of(cell, figure));
        figures[py::str(std::string(figure.name))] = array_of(std::move(values), shape);
    }
    py::list messages;
    for (const sweep::Cell& cell : cells)
        messages.append(python_text(cell.message));
    result["figures"] = figures;
    result["messages"] = messages;
    return result;
}

py::dict evaluate(const sweep::DesignPoints& points, int threads, const py::object& progress) {
    sweep::PointOptions options;
    options.crew = crew::thread_crews(threads);
    options.progress = [&](std::size_t done) {
        call_python(progress, [&] { progress(done, sweep::run_count(points), py::dict()); });
    };
    const std::vector<sweep::Cell> cells = unlocked([&](const std::stop_token& stop) {
        options.stop = stop;
        return sweep::evaluate(points, options);
    });
    const auto ways = static_cast<py::ssize_t>(points.directions.size());
    const auto count = static_cast<py::ssize_t>(sweep::point_count(points));
    py::dict result = python_points(cells, {ways, count});
    py::list by_start;  // numbers of `words["start_verdict"]`
    for (std::size_t start = 0; start < points.starts.size(); ++start)
        by_start.append(
            numbers_of(cells, {ways, count}, [&](auto& cell) { return sweep::number_of(cell.starts[start]); }));
    result["start_verdict"] = by_start;
    return result;
}

/// A finished chart. Its cells lie in the store, which is opened for as long as they are read: others may have it then.
// for whoever else fills a store: a warning after a second, and an end with the work
storage::WaitOptions waiting(std::stop_token stop = {}) {
    return {std::move(stop), [](const std::string& words) {
                const py::gil_scoped_acquire held;
                if (PyErr_WarnEx(PyExc_RuntimeWarning, words.c_str(), 1) != 0) throw py::error_already_set();
            }};
}

class ChartHandle {
public:
    const sweep::Study& study() const { return result_.study; }
    const sweep::SweepResult& verdicts() const { return result_; }

    std::vector<py::ssize_t> shape() const {
        const sweep::Study& of = result_.study;
        const auto ways = static_cast<py::ssize_t>(of.directions.size());
        return sweep::has_one_axis(of) ? std::vector<py::ssize_t>{ways, of.x.points}
                                       : std::vector<py::ssize_t>{ways, of.y.points, of.x.points};
    }

    // use(result) with the figures of the cells at hand, while other Python threads go on
    template <typename Use>
    auto with_cells(Use use) {
        const py::gil_scoped_release released;
        sweep::SweepResult whole = sweep::load(
            result_.study, std::make_shared<sweep::Store>(store_, result_.study, sweep::StoreUse::fill, waiting()));
        auto made = use(whole);
        whole.computed.reset();
        result_ = std::move(whole);
        return made;
    }

    // of a chart over one axis; kept beside the store
    const std::vector<sweep::DiagramCell>& diagram(int threads) {
        if (diagram_.empty())
            diagram_ = unlocked([&](const std::stop_token& stop) {
                const std::filesystem::path file = std::filesystem::path(store_).replace_filename("diagram.sqlite");
                storage::KeptResults kept(file, sweep::diagram_text(study()), "diagram");
                return sweep::diagram(result_, {.crew = crew::thread_crews(threads), .stop = stop, .kept = &kept});
            });
        return diagram_;
    }

    ChartHandle(sweep::Study study, std::filesystem::path store) : store_(std::move(store)) {
        result_.study = std::move(study);
        with_cells([](const sweep::SweepResult&) { return 0; });
    }

private:
    std::filesystem::path store_;
    sweep::SweepResult result_;  // without its figures
    std::vector<sweep::DiagramCell> diagram_{};
};

ChartHandle compute(const sweep::Study& study, const std::string& store_file, int threads, const py::object& progress) {
    unlocked([&](const std::stop_token& stop) {
        sweep::Store store(store_file, study, sweep::StoreUse::fill, waiting(stop));
        sweep::RunOptions options;
        options.crew = crew::thread_crews(threads);
        options.stop = stop;
        options.progress = [&](const sweep::Progress& now) {
            call_python(progress, [&] { progress(now.done, now.total, python_counts(now.counts)); });
        };
        const sweep::RunReport report = sweep::run(study, store, options);
        if (report.ending == sweep::SweepEnding::stopped)
            throw Error(ErrorKind::interrupted, {"stopped with " + std::to_string(report.progress.done) + " of " +
                                                     std::to_string(report.progress.total) + " cells done",
                                                 "all of them are kept in " + store_file, "Run it again to go on."});
        return 0;
    });
    return {study, store_file};
}

const sweep::CellFigure& figure_called(const std::string& name) {
    if (const sweep::CellFigure* found = sweep::find_cell_figure(name)) return *found;
    std::vector<std::string_view> names;
    for (const sweep::CellFigure& each : sweep::cell_figures())
        names.push_back(each.name);
    base::refuse("a chart has no figure \"" + name + "\"", "", base::did_you_mean(name, names));
}

py::array_t<double> figure(ChartHandle& chart, const std::string& name) {
    const sweep::CellFigure& figure = figure_called(name);
    return array_of(chart.with_cells([&](const auto& result) { return sweep::figure_values(result, figure); }),
                    chart.shape());
}

// of each cell the extremes [m] and the times between beats [s]
py::list diagram(ChartHandle& chart, int threads) {
    py::list list;
    for (const sweep::DiagramCell& cell : chart.diagram(threads))
        list.append(py::make_tuple(cell.extremes, cell.intervals));
    return list;
}

py::dict verdicts(const ChartHandle& chart) {
    Bytes source;
    for (std::size_t index = 0; index < chart.verdicts().cells.size(); ++index)
        source.push_back(sweep::is_inferred(chart.verdicts(), index) ? 1 : 0);
    py::dict result = python_verdicts(chart.verdicts().cells, chart.shape());
    result["source"] = array_of(std::move(source), chart.shape());
    return result;
}

// of both axes: key, unit, sentence, scale and values
py::list axes(const sweep::Study& study) {
    py::list list;
    for (const sweep::Axis* axis : {&study.x, &study.y}) {
        std::vector<double> values;
        for (int index = 0; index < axis->points; ++index)
            values.push_back(sweep::value_at(*axis, index));
        list.append(py::make_tuple(
            axis->parameter, parameters::unit_of(axis->parameter), parameters::field_of(axis->parameter)->sentence,
            sweep::scale_names[static_cast<std::size_t>(axis->scale)], array_of(std::move(values), {axis->points})));
    }
    return list;
}

// each line: direction, the verdicts that it parts, is it closed, and its points (x, y)
py::list boundaries(const ChartHandle& chart) {
    py::list list;
    for (const sweep::Boundary& line : sweep::boundaries(chart.verdicts())) {
        std::vector<double> points;
        for (const sweep::BoundaryVertex& vertex : line.vertices)
            points.insert(points.end(), {vertex.x, vertex.y});
        const auto count = static_cast<py::ssize_t>(line.vertices.size());
        list.append(py::make_tuple(line.direction, line.first, line.second, line.form == sweep::LineForm::closed,
                                   array_of(std::move(points), {count, 2})));
    }
    return list;
}

CaseHandle case_at(const ChartHandle& chart, const std::string& x, const std::string& y, const std::string& direction) {
    sweep::CellChoice choice{"x=" + x + ",y=" + y, x, y, {}};
    if (!direction.empty())
        choice.direction = chosen<parameters::Direction>("direction", {direction}, parameters::direction_names).front();
    const std::size_t index = sweep::index_of(chart.study(), sweep::nearest_cell(chart.study(), choice));
    const sweep::CellPlace place = sweep::shown_place(chart.verdicts(), index);
    return {std::make_shared<const parameters::Case>(sweep::case_at(chart.study(), place))};
}

py::str svg(ChartHandle& chart, const std::string& quantity) {
    const bool is_diagram = sweep::has_one_axis(chart.study());
    if (is_diagram && quantity != "category") figure_called(quantity);
    const std::vector<sweep::DiagramCell> cells = is_diagram ? chart.diagram(0) : std::vector<sweep::DiagramCell>();
    return python_text(chart.with_cells([&](sweep::SweepResult shown) {
        shown.study.quantities = {quantity};
        drawing::Scene scene = is_diagram ? pictures::diagram(shown, cells) : pictures::quantity_chart(shown, quantity);
        pictures::mark_design(scene, shown.study);
        return drawing::render(scene, drawing::Format::svg);
    }));
}

void write_netcdf(ChartHandle& chart, const std::string& path) {
    chart.with_cells([&](const sweep::SweepResult& result) {
        io::write_chart_netcdf(path, result);
        return 0;
    });
}

// the tables and the chart's own file, as `stridor chart` writes them
void write_tables(ChartHandle& chart, const std::string& folder) {
    storage::write_file(folder + "/chart.toml", io::study_toml(chart.study()));
    if (sweep::has_one_axis(chart.study()))
        storage::write_file(folder + "/diagram.csv", io::diagram_csv(chart.study(), chart.diagram(0)));
    chart.with_cells([&](const sweep::SweepResult& result) {
        io::write_chart_tables(result, folder, io::chart_exports(chart.study(), {}));
        return 0;
    });
}

std::vector<std::string_view> directions(const sweep::Study& study) {
    std::vector<std::string_view> names;
    for (const parameters::Direction direction : study.directions)
        names.push_back(parameters::direction_names[static_cast<std::size_t>(direction)]);
    return names;
}

void bind_words(py::module_& module) {
    py::dict all;
    all["category"] = words(classification::category_names);
    all["quiet_because"] = words(classification::quiet_names);
    all["status"] = words(sweep::status_names);
    all["source"] = words(sweep::source_names);
    all["agreement"] = words(sweep::agreement_names);
    all["start_verdict"] = words(sweep::verdict_words);
    module.attr("words") = all;
}

}  // namespace

void bind_charts(py::module_& module) {
    bind_words(module);
    py::class_<sweep::DesignPoints>(module, "PointsHandle", "Points that are to be computed.");
    module.def(
        "points",
        [](const std::vector<CaseHandle>& bases, std::vector<std::size_t> base_of, const std::vector<std::string>& keys,
           const Doubles& values, const std::vector<std::string>& directions, const std::vector<std::string>& starts) {
            sweep::DesignPoints points{{}, keys, {values.data(), values.data() + values.size()}};
            for (const CaseHandle& base : bases)
                points.bases.push_back(*base.of);
            points.base_of = std::move(base_of);
            points.directions = chosen<parameters::Direction>("directions", directions, parameters::direction_names);
            points.starts = chosen<parameters::Initial>("starts", starts, sweep::start_names());
            return points;
        },
        py::arg("bases"), py::arg("base_of"), py::arg("keys"), py::arg("values"), py::arg("directions"),
        py::arg("starts"));
    module.def("write_file", &storage::write_file, py::arg("file"), py::arg("bytes"));
    module.def("evaluate", &evaluate, py::arg("points"), py::arg("threads"), py::arg("progress"));
    py::class_<sweep::Study>(module, "StudyHandle", "A chart that is to be computed.")
        .def("directions", &directions)
        .def("axes", &axes)
        .def("starts", [](const sweep::Study& study) { return study.starts.size(); })
        .def("toml", [](const sweep::Study& study) { return python_text(io::study_toml(study)); });
    module.def(
        "study",
        [](const CaseHandle& c, const std::string& x, const std::string& y, const std::vector<std::string>& directions,
           const std::vector<std::string>& starts, const std::vector<std::string>& quantities, int refine) {
            sweep::Study study;
            study.base = *c.of;
            study.x = io::read_axis_text(*c.of, x, io::usual_points, "x");
            study.y =
                y.empty() ? sweep::resting_axis(*c.of, study.x) : io::read_axis_text(*c.of, y, io::usual_points, "y");
            study.directions = chosen<parameters::Direction>("directions", directions, parameters::direction_names);
            study.starts = chosen<parameters::Initial>("starts", starts, sweep::start_names());
            study.quantities = quantities;
            study.refine = refine;
            sweep::check(study);
            return study;
        },
        py::arg("case"), py::arg("x"), py::arg("y"), py::arg("directions"), py::arg("starts"), py::arg("quantities"),
        py::arg("refine"));
    module.def(
        "read_study", [](const std::string& path) { return io::read_study(path); }, py::arg("path"));
    module.def("compute", &compute, py::arg("study"), py::arg("store"), py::arg("threads"), py::arg("progress"));
    module.def(
        "open_chart", [](const sweep::Study& study, const std::string& store) { return ChartHandle(study, store); },
        py::arg("study"), py::arg("store"));
    py::class_<ChartHandle>(module, "ChartHandle", "A finished chart.")
        .def("directions", [](const ChartHandle& chart) { return directions(chart.study()); })
        .def("axes", [](const ChartHandle& chart) { return axes(chart.study()); })
        .def("verdicts", &verdicts)
        .def("figure", &figure, py::arg("name"))
        .def("diagram", &diagram, py::arg("threads"))
        .def("boundaries", &boundaries)
        .def("case_at", &case_at, py::arg("x"), py::arg("y"), py::arg("direction"))
        .def("base",
             [](const ChartHandle& chart) {
                 return CaseHandle{std::make_shared<const parameters::Case>(chart.study().base)};
             })
        .def("toml", [](const ChartHandle& chart) { return python_text(io::study_toml(chart.study())); })
        .def("svg", &svg, py::arg("quantity"))
        .def("write_netcdf", &write_netcdf, py::arg("path"))
        .def("write_tables", &write_tables, py::arg("folder"));
}

}  // namespace stridor::binding
