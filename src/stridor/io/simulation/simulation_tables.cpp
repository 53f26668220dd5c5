#include "stridor/io/simulation/simulation_tables.hpp"

#include "stridor/base/csv_text.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/hash.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/csv_opening.hpp"
#include "stridor/model/linear/sliding_motion.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/record/trace.hpp"
#include "stridor/recordings/time_grid.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <span>

namespace stridor::io {

using base::csv_text::Facts;
using base::csv_text::TableColumn;

namespace {

void put_trace(NetcdfDataset& file, const parameters::Case& c, const record::Trace& trace) {
    const std::vector<std::string> names = dof_names(c, trace.displacement.size());
    const int time = file.dimension("time", trace.time.size());
    const int dof = file.dimension("dof", names.size());
    std::vector<int> along{time};
    visit_arrays(trace, [&](const TraceArray& array) {
        if (array.outer == "contact" && along.size() == 1)
            along.insert(along.begin(), file.dimension("contact", trace.contacts.size()));
        const bool is_time = array.name == record::time_column.name;
        file.doubles(std::string(array.name), array.outer == "dof" ? std::vector{dof, time} : along, array.values,
                     {array.unit, array.sentence, is_time ? MissingNumbers::no : MissingNumbers::as_nan});
        if (is_time) file.words("dof", std::array{dof}, names, {"", "degree of freedom"});
    });
    file.flags(std::string(record::state_column), along, states_of(trace), {model::contact_state_names},
               {"", "contact state"});
}

// the stays of all contacts, one contact after the other
void put_histories(NetcdfDataset& file, const std::vector<record::ContactHistory>& histories) {
    std::vector<record::ContactInterval> stays;
    std::vector<double> contacts;
    for (std::size_t k = 0; k < histories.size(); ++k) {
        stays.insert(stays.end(), histories[k].begin(), histories[k].end());
        contacts.insert(contacts.end(), histories[k].size(), static_cast<double>(k + 1));
    }
    const std::array along{file.dimension("interval", stays.size())};
    if (histories.size() > 1)
        file.doubles("interval_contact", along, contacts, {"1", "number of the contact, from 1", MissingNumbers::no});
    std::vector<signed char> states;
    for (const record::ContactInterval& interval : stays)
        states.push_back(static_cast<signed char>(interval.state));
    file.flags("interval_state", along, states, {model::contact_state_names}, {"", "contact state"});
    for (const IntervalColumn& column : interval_columns) {
        std::vector<double> values;
        for (const record::ContactInterval& interval : stays)
            values.push_back(interval.*column.member);
        const MissingNumbers missing = column.unit == "s" ? MissingNumbers::no : MissingNumbers::as_nan;
        file.doubles("interval_" + std::string(column.name), along, values, {column.unit, column.sentence, missing});
    }
}

using analysis::SlidingStability;
using base::csv_text::Table;

// what stands at the beginning of each row of one point
struct PointWords {
    std::string_view direction;
    const double* value = nullptr;  // of the parameter; none where none is followed
};

void add_row(Table& table, const PointWords& point, const SlidingStability& stability, const analysis::Eigenmode& mode,
             std::string_view grows) {
    table.word(point.direction);
    if (point.value != nullptr) table.number(*point.value);
    table.word(analysis::stability_names[static_cast<std::size_t>(stability.kind)]);
    table.number(mode.frequency);
    table.number(mode.growth);
    table.number(-mode.growth / std::hypot(mode.growth, base::two_pi * mode.frequency));
    table.word(grows);
    table.end_row();
}

void add_point(Table& table, const PointWords& point, const SlidingStability& stability) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    // without an equilibrium its modes are none
    if (stability.modes.empty() || stability.kind == analysis::StabilityKind::locked)
        return add_row(table, point, stability, {unknown, unknown}, "");
    std::vector<std::complex<double>> eigenvalues;
    for (const analysis::Eigenmode& mode : stability.modes)
        eigenvalues.emplace_back(mode.growth, base::two_pi * mode.frequency);
    const double rounding = model::growth_rounding(eigenvalues);
    for (const analysis::Eigenmode& mode : stability.modes)
        add_row(table, point, stability, mode, mode.growth > rounding ? "yes" : "no");
}

// an engine samples at its own steps nearest to the asked ones; a single sample tells nothing of them
double rate_of(const record::Trace& trace, double interval) {
    if (trace.time.size() < 2 || !(trace.time.back() > trace.time.front()))
        return recordings::snapped_rate(interval, 1e-12).rate;
    const recordings::time_grid::Precision exact{400, 17};
    return recordings::time_grid::rate_of({trace.time, trace.time.back(), 1.0, exact}).rate;
}

}  // namespace

void visit_arrays(const record::Trace& trace, const std::function<void(TraceArray&)>& use) {
    const auto give = [&](const auto& column, std::string_view outer, const auto& rows) {
        TraceArray array{column.name, column.unit, column.sentence, outer, {}};
        for (const std::vector<double>& row : rows)
            array.values.insert(array.values.end(), row.begin(), row.end());
        use(array);
    };
    give(record::time_column, "", std::span(&trace.time, 1));
    for (const record::DofColumn& column : record::dof_columns)
        give(column, "dof", trace.*column.samples);
    give(record::surface_column, "", std::span(&trace.surface_velocity, 1));
    for (const record::ContactColumn& column : record::contact_columns) {
        std::vector<std::reference_wrapper<const std::vector<double>>> rows;
        for (const record::ContactTrace& contact : trace.contacts)
            rows.emplace_back(contact.*column.samples);
        give(column, rows.size() > 1 ? "contact" : "", rows);
    }
}

std::vector<signed char> states_of(const record::Trace& trace) {
    std::vector<signed char> states;
    for (const record::ContactTrace& contact : trace.contacts)
        for (const model::ContactState state : contact.state)
            states.push_back(static_cast<signed char>(state));
    return states;
}

std::string trace_csv(const parameters::Case& c, const record::Trace& trace, double interval) {
    Facts facts = csv_opening("trace", c);
    facts.emplace_back("rate", base::shortest(rate_of(trace, interval)) + " Hz");
    add_lines(facts, parameters::canonical_text(c));
    const std::size_t contacts = trace.contacts.size();
    const std::vector<record::NumberColumn> numbers = record::columns(trace, dof_names(c, trace.displacement.size()));
    // the states of a contact stand behind its numbers
    const std::size_t before = numbers.size() - contacts * record::contact_columns.size();
    const auto is_last_of_contact = [&](std::size_t column) {
        return column >= before &&
               (column - before) % record::contact_columns.size() == record::contact_columns.size() - 1;
    };
    const auto contact_of = [&](std::size_t column) { return (column - before) / record::contact_columns.size(); };
    std::vector<TableColumn> columns;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        columns.push_back({numbers[k].name, std::string(numbers[k].unit)});
        if (is_last_of_contact(k))
            columns.push_back({std::string(record::state_column) + record::contact_ending(contact_of(k), contacts)});
    }
    Table table(facts, columns);
    for (std::size_t sample = 0; sample < trace.time.size(); ++sample) {
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            table.number((*numbers[k].samples)[sample]);
            if (is_last_of_contact(k))
                table.word(model::contact_state_names[model::index_of(trace.contacts[contact_of(k)].state[sample])]);
        }
        table.end_row();
    }
    return table.take();
}

std::string history_csv(const parameters::Case& c, const std::vector<record::ContactHistory>& histories) {
    Facts facts = csv_opening("history", c);
    add_lines(facts, parameters::canonical_text(c));
    std::vector<TableColumn> columns{{"state"}};
    for (const IntervalColumn& column : interval_columns)
        columns.push_back({std::string(column.name), std::string(column.unit)});
    const bool has_several = histories.size() > 1;
    if (has_several) columns.insert(columns.begin(), {"contact"});
    Table table(facts, columns);
    for (std::size_t contact = 0; contact < histories.size(); ++contact)
        for (const record::ContactInterval& interval : histories[contact]) {
            if (has_several) table.number(static_cast<double>(contact + 1));
            table.word(model::contact_state_names[model::index_of(interval.state)]);
            for (const IntervalColumn& column : interval_columns)
                table.number(interval.*column.member);
            table.end_row();
        }
    return table.take();
}

Attributes origin_of_run(std::string_view schema, const parameters::Case& c) {
    const std::string canonical = parameters::canonical_text(c);
    Attributes attributes = origin_attributes(schema, c.title.empty() ? "simulated motion" : c.title);
    attributes.emplace_back("study", canonical);
    attributes.emplace_back("study_hash", base::hash_text(canonical));
    attributes.emplace_back("case", case_toml(c, {.comments = Comments::none, .heading = ""}));
    return attributes;
}

void write_trace_netcdf(const std::string& path, const parameters::Case& c, const record::Record& record) {
    NetcdfDataset file(path);
    put(file, origin_of_run("trace", c));
    if (!record.trace.time.empty()) put_trace(file, c, record.trace);
    const bool has_history = std::any_of(record.histories.begin(), record.histories.end(),
                                         [](const record::ContactHistory& history) { return !history.empty(); });
    if (has_history) put_histories(file, record.histories);
    file.finish([&](std::string_view bytes) { storage::write_file(path, bytes); });
}

std::string stability_csv(const analysis::StabilityScan& scan) {
    base::csv_text::Facts facts = csv_opening("modes", scan.base);
    add_lines(facts, parameters::canonical_text(scan.base));
    std::vector<base::csv_text::TableColumn> columns{
        {"direction"}, {"sliding"}, {"frequency", "Hz"}, {"growth", "1/s"}, {"damping_ratio", "1"}, {"grows"}};
    if (!scan.key.empty()) columns.insert(columns.begin() + 1, {scan.key, scan.unit});
    Table table(facts, columns);
    for (const analysis::DirectionScan& direction : scan.directions) {
        const std::string_view name = parameters::direction_names[static_cast<std::size_t>(direction.direction)];
        if (scan.key.empty()) add_point(table, {name}, direction.here);
        for (const analysis::StabilityPoint& point : direction.path.points)
            add_point(table, {name, &point.value}, point.stability);
    }
    return table.take();
}

}  // namespace stridor::io
