#include "stridor/integration/simulate.hpp"

#include "bindings.hpp"
#include "handles.hpp"
#include "stridor/analysis/evidence.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/integration/failure.hpp"
#include "stridor/io/chart/range_text.hpp"
#include "stridor/io/simulation/end_state_file.hpp"
#include "stridor/io/simulation/followed_motion.hpp"
#include "stridor/io/simulation/json_simulation.hpp"
#include "stridor/io/simulation/simulation_tables.hpp"
#include "stridor/io/simulation/stroke_texts.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/record/trace.hpp"
#include "stridor/sweep/following.hpp"
#include "stridor/sweep/strokes.hpp"
#include "work.hpp"

#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stridor::binding {

namespace {

using classification::Verdict;

/// A run that has a result, and what is said of it.
struct RunHandle {
    CaseHandle c;
    integration::Motion motion;
    std::vector<Verdict> verdicts;
};

// an end state that Python holds as its document; nothing of an empty one
std::optional<integration::EndState> state_of(const CaseHandle& c, const std::string& document) {
    if (document.empty()) return std::nullopt;
    io::ReadEndState read = io::read_end_state(document, "start");
    io::expect_same_case(read, *c.of, "start");
    return std::move(read.state);
}

RunHandle run(const CaseHandle& c, const record::Request& request, const std::string& start = "") {
    const std::optional<integration::EndState> from = state_of(c, start);
    return unlocked([&](const std::stop_token& stop) {
        integration::Motion motion =
            from ? integration::go_on(*c.of, *from, request, stop) : integration::simulate(*c.of, request, stop);
        if (const std::optional<Error> failure = integration::failure(*c.of, motion)) throw Error(*failure);
        std::vector<Verdict> verdicts =
            classification::classify_phases(motion.record.phases, c.of->verdict, classification::contact_names(*c.of));
        return RunHandle{c, std::move(motion), std::move(verdicts)};
    });
}

std::string end_state(const CaseHandle& c, const std::string& start) {
    const std::optional<integration::EndState> from = state_of(c, start);
    return unlocked([&](const std::stop_token& stop) {
        const integration::Ended ended = integration::run_to_end(*c.of, from ? &*from : nullptr, stop);
        const integration::Motion motion{.outcome = ended.outcome, .energy = {}, .record = {}};
        if (const std::optional<Error> failure = integration::failure(*c.of, motion)) throw Error(*failure);
        return io::end_state_json(*c.of, ended.state);
    });
}

CaseHandle begun_in(const CaseHandle& c, const std::string& start) {
    const io::ReadEndState read = io::read_end_state(start, "start");
    io::expect_same_shape(read, *c.of, "start");
    return {std::make_shared<const parameters::Case>(integration::begun_at(*c.of, read.state))};
}

std::string follow(const CaseHandle& c, const std::string& over) {
    return unlocked([&](const std::stop_token& stop) {
        return io::following_json(sweep::follow(*c.of, io::read_scan_range(over), {.stop = stop}));
    });
}

std::string strokes(const CaseHandle& c, std::int64_t count, double duration, double pause,
                    const std::optional<std::array<double, 2>>& heating,
                    const std::optional<std::array<double, 3>>& wear) {
    sweep::StrokePlan plan{count, duration, pause, {}, {}};
    if (heating) plan.heating = sweep::Heating{(*heating)[0], (*heating)[1]};
    if (wear) plan.wear = sweep::Wear{(*wear)[0], (*wear)[1], (*wear)[2]};
    return unlocked(
        [&](const std::stop_token& stop) { return io::strokes_json(sweep::run_strokes(*c.of, plan, {.stop = stop})); });
}

py::dict python_phase(const Verdict& verdict) {
    py::dict figures;
    for (const analysis::EvidenceFigure& figure : analysis::evidence_figures())
        figures[py::str(figure.name.data(), figure.name.size())] = figure.value(verdict.evidence);
    py::list margins;
    for (const classification::Margin& margin : verdict.margins)
        margins.append(py::make_tuple(margin.threshold_name, margin.figure_name, margin.figure, margin.threshold,
                                      margin.distance));
    py::dict phase;
    phase["phase"] = record::phase_names[static_cast<std::size_t>(verdict.evidence.phase)];
    phase["category"] = classification::name(verdict.category);
    phase["quiet_because"] = classification::name(verdict.quiet);
    phase["judged_time"] = verdict.evidence.judged_time;
    phase["figures"] = figures;
    phase["margins"] = margins;
    phase["reasons"] = verdict.reasons;
    phase["warnings"] = verdict.warnings;
    return phase;
}

py::list phases(const RunHandle& run) {
    py::list list;
    for (const Verdict& verdict : run.verdicts)
        list.append(python_phase(verdict));
    return list;
}

py::str document(const RunHandle& run) {
    return python_text(io::simulation_json(*run.c.of, run.motion, integration::cost(*run.c.of), run.verdicts));
}

// columns as (name, dimensions, array, unit, sentence)
py::list columns_of(const record::Trace& trace) {
    const auto samples = static_cast<py::ssize_t>(trace.time.size());
    py::list columns;
    io::visit_arrays(trace, [&](io::TraceArray& array) {
        const auto rows = samples > 0 ? static_cast<py::ssize_t>(array.values.size()) / samples : 0;
        const bool has_rows = !array.outer.empty();
        const std::vector<py::ssize_t> shape = has_rows ? std::vector{rows, samples} : std::vector{samples};
        const py::tuple dimensions = has_rows ? py::make_tuple(array.outer, "time") : py::make_tuple("time");
        columns.append(py::make_tuple(array.name, dimensions, array_of(std::move(array.values), shape), array.unit,
                                      array.sentence));
    });
    return columns;
}

py::dict trace(const CaseHandle& c, const std::string& from, const std::string& to, const std::string& interval) {
    record::Request request;
    request.trace = io::trace_request({from, to, interval}, *c.of);
    RunHandle done = run(c, request);
    record::Trace& trace = done.motion.record.trace;
    record::add_points(trace, parameters::output_weights(*c.of));
    py::dict parts;
    parts["dofs"] = io::dof_names(*c.of, trace.displacement.size());
    const auto contacts = static_cast<py::ssize_t>(trace.contacts.size());
    const auto samples = static_cast<py::ssize_t>(trace.time.size());
    parts["states"] =
        array_of(io::states_of(trace), contacts > 1 ? std::vector{contacts, samples} : std::vector{samples});
    parts["columns"] = columns_of(trace);
    return parts;
}

py::dict origin(const CaseHandle& c, const std::string& schema) {
    py::dict attributes;
    for (const auto& [name, text] : io::origin_of_run(schema, *c.of))
        attributes[py::str(name)] = python_text(text);
    return attributes;
}

// the stays of all contacts, one contact after the other: number of the contact, state, and columns of numbers as
// (name, array, unit, sentence)
py::tuple history(const CaseHandle& c) {
    record::Request request;
    request.history = record::KeepHistory::yes;
    const RunHandle done = run(c, request);
    std::vector<int> contacts;
    std::vector<signed char> states;
    std::vector<record::ContactInterval> stays;
    for (std::size_t k = 0; k < done.motion.record.histories.size(); ++k)
        for (const record::ContactInterval& stay : done.motion.record.histories[k]) {
            contacts.push_back(static_cast<int>(k + 1));
            states.push_back(static_cast<signed char>(stay.state));
            stays.push_back(stay);
        }
    const auto count = static_cast<py::ssize_t>(states.size());
    py::list columns;
    for (const io::IntervalColumn& column : io::interval_columns) {
        std::vector<double> numbers;
        for (const record::ContactInterval& stay : stays)
            numbers.push_back(stay.*column.member);
        columns.append(
            py::make_tuple(column.name, array_of(std::move(numbers), {count}), column.unit, column.sentence));
    }
    return py::make_tuple(array_of(std::move(contacts), {count}), array_of(std::move(states), {count}), columns);
}

}  // namespace

void bind_simulation(py::module_& module) {
    py::class_<RunHandle>(module, "RunHandle", "A run and what it left behind.")
        .def("phases", &phases)
        .def("json", &document);
    module.def(
        "simulate", [](const CaseHandle& c, const std::string& start) { return run(c, {}, start); }, py::arg("case"),
        py::arg("start") = "");
    module.def(
        "end_state", [](const CaseHandle& c, const std::string& start) { return python_text(end_state(c, start)); },
        py::arg("case"), py::arg("start") = "");
    module.def("begun_in", &begun_in, py::arg("case"), py::arg("start"));
    module.def(
        "follow", [](const CaseHandle& c, const std::string& over) { return python_text(follow(c, over)); },
        py::arg("case"), py::arg("over"));
    module.def(
        "strokes",
        [](const CaseHandle& c, std::int64_t count, double duration, double pause,
           const std::optional<std::array<double, 2>>& heating, const std::optional<std::array<double, 3>>& wear) {
            return python_text(strokes(c, count, duration, pause, heating, wear));
        },
        py::arg("case"), py::arg("count"), py::arg("duration"), py::arg("pause"), py::arg("heating"), py::arg("wear"));
    module.def("trace", &trace, py::arg("case"), py::arg("start"), py::arg("stop"), py::arg("interval"));
    module.def("history", &history, py::arg("case"));
    module.def("origin", &origin, py::arg("case"), py::arg("schema"));
    module.attr("contact_states") =
        std::vector<std::string_view>(model::contact_state_names.begin(), model::contact_state_names.end());
}

}  // namespace stridor::binding
