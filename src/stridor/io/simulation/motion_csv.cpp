#include "stridor/io/simulation/motion_csv.hpp"

#include "stridor/base/csv_text.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/csv_opening.hpp"
#include "stridor/io/simulation/dof_names.hpp"
#include "stridor/parameters/field.hpp"
#include "stridor/recordings/rate.hpp"
#include "stridor/recordings/time_grid.hpp"

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::io {

using base::csv_text::Column;
using base::csv_text::Facts;
using base::csv_text::Table;

namespace {

std::vector<Column> trace_columns(const std::vector<std::string>& dofs) {
    std::vector<Column> columns{{"time", "s"}};
    constexpr std::array<std::pair<std::string_view, std::string_view>, 3> motions{
        {{"displacement_", "m"}, {"velocity_", "m/s"}, {"acceleration_", "m/s^2"}}};
    for (const auto& [name, unit] : motions)
        for (const std::string& dof : dofs)
            columns.push_back({std::string(name) + dof, std::string(unit)});
    columns.push_back({"surface_velocity", "m/s"});
    columns.push_back({"normal_force", "N"});
    columns.push_back({"friction_force", "N"});
    columns.push_back({"gap", "m"});
    columns.push_back({"state"});
    return columns;
}

// an engine samples at its own steps nearest to the asked ones; a single sample tells nothing of them
double rate_of(const record::Trace& trace, double interval) {
    if (trace.time.size() < 2 || !(trace.time.back() > trace.time.front()))
        return recordings::snapped_rate(interval, 1e-12).rate;
    const recordings::time_grid::Precision exact{400, 17};
    return recordings::time_grid::rate_of({trace.time, trace.time.back(), 1.0, exact}).rate;
}

}  // namespace

std::string trace_csv(const parameters::Case& c, const record::Trace& trace, double interval) {
    Facts facts = csv_opening("trace", c);
    facts.emplace_back("rate", base::shortest(rate_of(trace, interval)) + " Hz");
    add_lines(facts, parameters::canonical_text(c));
    Table table(facts, trace_columns(dof_names(trace.displacement.size())));
    for (std::size_t sample = 0; sample < trace.time.size(); ++sample) {
        table.number(trace.time[sample]);
        for (const auto* motion : {&trace.displacement, &trace.velocity, &trace.acceleration})
            for (const std::vector<double>& dof : *motion)
                table.number(dof[sample]);
        for (const auto* values : {&trace.surface_velocity, &trace.normal_force, &trace.friction_force, &trace.gap})
            table.number((*values)[sample]);
        table.word(model::contact_state_names[model::index_of(trace.state[sample])]);
        table.end_row();
    }
    return table.take();
}

std::string history_csv(const parameters::Case& c, const record::ContactHistory& history) {
    Facts facts = csv_opening("history", c);
    add_lines(facts, parameters::canonical_text(c));
    Table table(facts, {{"state"}, {"from", "s"}, {"to", "s"}, {"slip_velocity", "m/s"}, {"gap_velocity", "m/s"}});
    for (const record::ContactInterval& interval : history) {
        table.word(model::contact_state_names[model::index_of(interval.state)]);
        for (const double value : {interval.from, interval.to, interval.slip_velocity, interval.gap_velocity})
            table.number(value);
        table.end_row();
    }
    return table.take();
}

}  // namespace stridor::io
