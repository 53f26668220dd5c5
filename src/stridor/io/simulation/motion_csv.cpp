#include "stridor/io/simulation/motion_csv.hpp"

#include "stridor/base/csv_text.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/csv_opening.hpp"
#include "stridor/io/simulation/dof_names.hpp"
#include "stridor/parameters/field.hpp"
#include "stridor/record/columns.hpp"
#include "stridor/recordings/rate.hpp"
#include "stridor/recordings/time_grid.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace stridor::io {

using base::csv_text::Facts;
using base::csv_text::Table;
using base::csv_text::TableColumn;

namespace {

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
    std::vector<TableColumn> columns{
        {"state"}, {"from", "s"}, {"to", "s"}, {"slip_velocity", "m/s"}, {"gap_velocity", "m/s"}};
    const bool has_several = histories.size() > 1;
    if (has_several) columns.insert(columns.begin(), {"contact"});
    Table table(facts, columns);
    for (std::size_t contact = 0; contact < histories.size(); ++contact)
        for (const record::ContactInterval& interval : histories[contact]) {
            if (has_several) table.number(static_cast<double>(contact + 1));
            table.word(model::contact_state_names[model::index_of(interval.state)]);
            for (const double value : {interval.from, interval.to, interval.slip_velocity, interval.gap_velocity})
                table.number(value);
            table.end_row();
        }
    return table.take();
}

}  // namespace stridor::io
