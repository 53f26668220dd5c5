#include "stridor/integration/simulate.hpp"

#include "bindings.hpp"
#include "handles.hpp"
#include "stridor/analysis/evidence.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/integration/failure.hpp"
#include "stridor/io/chart/range_text.hpp"
#include "stridor/io/simulation/json_simulation.hpp"
#include "stridor/io/simulation/simulation_tables.hpp"
#include "stridor/record/trace.hpp"
#include "work.hpp"

#include <pybind11/stl.h>

#include <string>
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

RunHandle run(const CaseHandle& c, const record::Request& request) {
    return unlocked([&](const std::stop_token& stop) {
        integration::Motion motion = integration::simulate(*c.of, request, stop);
        if (const std::optional<Error> failure = integration::failure(*c.of, motion)) throw Error(*failure);
        std::vector<Verdict> verdicts =
            classification::classify_phases(motion.record.phases, c.of->verdict, classification::contact_names(*c.of));
        return RunHandle{c, std::move(motion), std::move(verdicts)};
    });
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

// rows of one length as one piece of memory
std::vector<double> joined(const std::vector<std::vector<double>>& rows) {
    std::vector<double> numbers;
    for (const std::vector<double>& row : rows)
        numbers.insert(numbers.end(), row.begin(), row.end());
    return numbers;
}

/// Columns as (name, dimensions, array, unit, sentence).
class Columns {
public:
    explicit Columns(py::ssize_t samples) : samples_(samples) {}

    void add(std::string_view name, std::vector<double> numbers, const char* outer, const auto& column) {
        const auto rows = samples_ > 0 ? static_cast<py::ssize_t>(numbers.size()) / samples_ : 0;
        const bool has_rows = outer != nullptr;
        const std::vector<py::ssize_t> shape = has_rows ? std::vector{rows, samples_} : std::vector{samples_};
        const py::tuple dimensions = has_rows ? py::make_tuple(outer, "time") : py::make_tuple("time");
        list.append(
            py::make_tuple(name, dimensions, array_of(std::move(numbers), shape), column.unit, column.sentence));
    }

    py::list list{};

private:
    py::ssize_t samples_;
};

py::array contact_states(const std::vector<record::ContactTrace>& contacts, py::ssize_t samples) {
    std::vector<signed char> states;
    for (const record::ContactTrace& contact : contacts)
        for (const model::ContactState state : contact.state)
            states.push_back(static_cast<signed char>(state));
    const auto count = static_cast<py::ssize_t>(contacts.size());
    return array_of(std::move(states), count > 1 ? std::vector{count, samples} : std::vector{samples});
}

py::list columns_of(record::Trace trace) {
    Columns columns(static_cast<py::ssize_t>(trace.time.size()));
    columns.add(record::time_column.name, std::move(trace.time), nullptr, record::time_column);
    for (const record::DofColumn& column : record::dof_columns)
        columns.add(column.name, joined(trace.*column.samples), "dof", column);
    columns.add(record::surface_column.name, std::move(trace.surface_velocity), nullptr, record::surface_column);
    const char* outer = trace.contacts.size() > 1 ? "contact" : nullptr;
    for (const record::ContactColumn& column : record::contact_columns) {
        std::vector<std::vector<double>> rows;
        for (record::ContactTrace& contact : trace.contacts)
            rows.push_back(std::move(contact.*column.samples));
        columns.add(column.name, rows.size() == 1 ? std::move(rows.front()) : joined(rows), outer, column);
    }
    return columns.list;
}

py::dict trace(const CaseHandle& c, const std::string& from, const std::string& to, const std::string& interval) {
    record::Request request;
    request.trace = io::trace_request({from, to, interval}, *c.of);
    RunHandle done = run(c, request);
    record::Trace& trace = done.motion.record.trace;
    if (c.of->own_structure) record::add_points(trace, parameters::output_weights(*c.of->own_structure));
    py::dict parts;
    parts["dofs"] = io::dof_names(*c.of, trace.displacement.size());
    parts["states"] = contact_states(trace.contacts, static_cast<py::ssize_t>(trace.time.size()));
    parts["columns"] = columns_of(std::move(trace));
    return parts;
}

// the stays of all contacts, one contact after the other: number of the contact, state, and numbers of each stay
py::tuple history(const CaseHandle& c) {
    record::Request request;
    request.history = record::KeepHistory::yes;
    const RunHandle done = run(c, request);
    std::vector<int> contacts;
    std::vector<signed char> states;
    std::vector<double> numbers;
    for (std::size_t k = 0; k < done.motion.record.histories.size(); ++k)
        for (const record::ContactInterval& stay : done.motion.record.histories[k]) {
            contacts.push_back(static_cast<int>(k + 1));
            states.push_back(static_cast<signed char>(stay.state));
            numbers.insert(numbers.end(), {stay.from, stay.to, stay.slip_velocity, stay.gap_velocity});
        }
    const auto count = static_cast<py::ssize_t>(states.size());
    return py::make_tuple(array_of(std::move(contacts), {count}), array_of(std::move(states), {count}),
                          array_of(std::move(numbers), {count, 4}));
}

}  // namespace

void bind_simulation(py::module_& module) {
    py::class_<RunHandle>(module, "RunHandle", "A run and what it left behind.")
        .def("phases", &phases)
        .def("json", &document);
    module.def(
        "simulate", [](const CaseHandle& c) { return run(c, {}); }, py::arg("case"));
    module.def("trace", &trace, py::arg("case"), py::arg("start"), py::arg("stop"), py::arg("interval"));
    module.def("history", &history, py::arg("case"));
    module.attr("contact_states") =
        std::vector<std::string_view>(model::contact_state_names.begin(), model::contact_state_names.end());
}

}  // namespace stridor::binding
