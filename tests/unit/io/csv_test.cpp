#include "io_support.hpp"
#include "stridor/base/version.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/io/chart/chart_csv.hpp"
#include "stridor/io/simulation/simulation_tables.hpp"

#include <gtest/gtest.h>

#include <charconv>
#include <map>
#include <sstream>

namespace stridor::io {
namespace {

// RFC 4180 taken by its word; an independent reading of what the writer wrote
std::vector<std::string> split(const std::string& row) {
    std::vector<std::string> fields(1);
    bool is_quoted = false;
    for (std::size_t k = 0; k < row.size(); ++k) {
        const bool is_escaped_quote = is_quoted && row[k] == '"' && k + 1 < row.size() && row[k + 1] == '"';
        if (is_escaped_quote) {
            fields.back() += '"';
            ++k;
        } else if (row[k] == '"') {
            is_quoted = !is_quoted;
        } else if (row[k] == ',' && !is_quoted) {
            fields.emplace_back();
        } else {
            fields.back() += row[k];
        }
    }
    return fields;
}

struct Table {
    std::map<std::string, std::string> facts;
    std::vector<std::string> names;
    std::vector<std::string> units;  // empty: none
    std::vector<std::vector<std::string>> rows;

    std::string at(std::size_t row, const std::string& name) const {
        const auto column = std::find(names.begin(), names.end(), name);
        return column == names.end() ? "no such column" : rows[row][static_cast<std::size_t>(column - names.begin())];
    }
};

// "# key: value | key: value"
std::map<std::string, std::string> facts_in(const std::string& line) {
    std::map<std::string, std::string> facts;
    EXPECT_TRUE(line.starts_with("# ")) << line;
    EXPECT_EQ(line.find('"'), std::string::npos) << "a quote would join it with the next line: " << line;
    std::size_t begin = 2;
    while (begin < line.size()) {
        const std::size_t end = std::min(line.find(" | ", begin), line.size());
        const std::string fact = line.substr(begin, end - begin);
        const std::size_t colon = fact.find(": ");
        facts[fact.substr(0, colon)] = fact.substr(colon + 2);
        begin = end + 3;
    }
    return facts;
}

// "gap [m]"
void take_apart(const std::string& heading, Table& table) {
    const std::size_t bracket = heading.find(" [");
    table.names.push_back(heading.substr(0, bracket));
    const bool has_unit = bracket != std::string::npos;
    table.units.push_back(has_unit ? heading.substr(bracket + 2, heading.size() - bracket - 3) : "");
}

Table parse(const std::string& text) {
    Table table;
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    table.facts = facts_in(line);
    std::getline(lines, line);
    for (const std::string& heading : split(line))
        take_apart(heading, table);
    while (std::getline(lines, line)) {
        table.rows.push_back(split(line));
        EXPECT_EQ(table.rows.back().size(), table.names.size()) << line;
    }
    return table;
}

std::string csv_of(const sweep::SweepResult& result, const std::string& file) {
    std::string text;
    chart_csv(result, {file}, [&](std::string_view piece) { text += piece; });
    return text;
}

double number(const std::string& text) {
    double value = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

TEST(ChartCsv, HasTheColumnsOfTheContract) {
    const Table table = parse(csv_of(small_chart(), "c.toml"));
    const std::vector<std::string> first(table.names.begin(), table.names.begin() + 8);
    EXPECT_EQ(first,
              (std::vector<std::string>{"x", "y", "direction", "status", "category", "slip", "stick", "separation"}));
    EXPECT_EQ(table.names.back(), "reproduce");
    EXPECT_EQ(table.names.size(), 5 + sweep::cell_figures().size() + 4);
    EXPECT_EQ(table.units[0], "N");
    EXPECT_EQ(table.units[1], "");
    EXPECT_EQ(table.units[2], "");
    EXPECT_EQ(table.units[5], "") << "a share of 1";
}

TEST(ChartCsv, TellsComputedCellsFromInferredOnes) {
    const Table table = parse(csv_of(refined_chart(), "c.toml"));
    EXPECT_EQ(table.at(0, "source"), "computed");
    EXPECT_EQ(table.at(1, "source"), "inferred");
    EXPECT_EQ(table.at(1, "status"), "done");
    EXPECT_EQ(table.at(1, "category"), "none");
    EXPECT_EQ(table.at(1, "slip"), "") << "nobody computed it";
}

TEST(ChartCsv, HasAColumnPerStart) {
    const Table table = parse(csv_of(chart_of_starts(), "c.toml"));
    EXPECT_EQ(table.at(5, "agreement"), "quiet_unless_disturbed");
    EXPECT_EQ(table.at(5, "start_rest"), "none");
    EXPECT_EQ(table.at(5, "start_sliding"), "squeal");
    EXPECT_EQ(table.at(6, "start_sliding"), "invalid");
    EXPECT_EQ(table.facts.at("chart.starts"), "rest sliding");
    EXPECT_NE(table.at(6, "reproduce").find("--set run.initial=rest"), std::string::npos) << "the first that failed";
}

TEST(BoundariesCsv, HasARowPerVertex) {
    const sweep::SweepResult chart = small_chart();
    const std::vector<sweep::Boundary> boundaries = sweep::boundaries(chart);
    const Table table = parse(boundaries_csv(chart.study, boundaries));
    EXPECT_EQ(table.names, (std::vector<std::string>{"line", "direction", "first", "second", "form", "x", "y",
                                                     "x_resolution", "y_resolution"}));
    EXPECT_EQ(table.units[5], "N");
    EXPECT_EQ(table.facts.at("schema"), "stridor.boundaries/1");
    EXPECT_EQ(table.facts.at("y"), "contact.kinetic_friction");
    std::size_t row = 0;
    for (std::size_t line = 0; line < boundaries.size(); ++line)
        for (const sweep::BoundaryVertex& vertex : boundaries[line].vertices) {
            EXPECT_EQ(table.at(row, "line"), std::to_string(line));
            EXPECT_EQ(table.at(row, "first"), boundaries[line].first);
            EXPECT_EQ(number(table.at(row, "x")), vertex.x);
            EXPECT_EQ(number(table.at(row, "y_resolution")), vertex.y_resolution);
            ++row;
        }
    EXPECT_EQ(table.rows.size(), row);
    EXPECT_GT(row, 0U);
}

TEST(ChartCsv, SaysWhereItComesFrom) {
    const Table table = parse(csv_of(small_chart(), "c.toml"));
    EXPECT_EQ(table.facts.at("schema"), "stridor.chart/1");
    EXPECT_EQ(table.facts.at("version"), base::version());
    EXPECT_EQ(table.facts.at("commit"), base::commit());
    EXPECT_EQ(table.facts.at("x"), "contact.preload");
    EXPECT_EQ(table.facts.at("y"), "contact.kinetic_friction");
    EXPECT_EQ(table.facts.at("joint.mass"), "0.1 kg");
    EXPECT_EQ(table.facts.at("run.engine"), "exact");
    EXPECT_EQ(table.facts.at("chart.directions"), "going coming");
}

TEST(ChartCsv, HasARowPerCellInIndexOrderWithNumbersThatReadBack) {
    const sweep::SweepResult chart = small_chart();
    const Table table = parse(csv_of(chart, "c.toml"));
    ASSERT_EQ(table.rows.size(), chart.cells.size());
    for (std::size_t index = 0; index < chart.cells.size(); ++index) {
        const sweep::CellPlace place = sweep::place_of(chart.study, index);
        EXPECT_EQ(number(table.at(index, "x")), sweep::value_at(chart.study.x, place.ix));
        EXPECT_EQ(number(table.at(index, "y")), sweep::value_at(chart.study.y, place.iy));
        EXPECT_EQ(table.at(index, "direction"), place.direction == 0 ? "going" : "coming");
        EXPECT_EQ(table.at(index, "status"), sweep::status_names[static_cast<std::size_t>(chart.cells[index].status)]);
        if (chart.cells[index].status != sweep::Status::done) continue;
        EXPECT_EQ(number(table.at(index, "joint_rms")), figure_of(sweep::computed_cell(chart, index), "joint_rms"));
    }
}

TEST(ChartCsv, GivesCategoriesToDoneCellsAndCommandsToTheOthers) {
    const sweep::SweepResult chart = small_chart();
    const Table table = parse(csv_of(chart, "my chart.toml"));
    EXPECT_EQ(table.at(5, "category"), "squeal");
    EXPECT_EQ(table.at(5, "reproduce"), "");
    EXPECT_EQ(table.at(5, "frequency"), "") << "NaN is an empty field";
    EXPECT_EQ(table.at(6, "category"), "");
    EXPECT_EQ(table.at(6, "slip"), "");
    EXPECT_EQ(table.at(6, "message"), "cell \"6\", not done");
    EXPECT_EQ(table.at(6, "reproduce"),
              sweep::reproduce_command(chart.study, sweep::place_of(chart.study, 6), "my chart.toml"));
}

TEST(ChartCsv, KeepsAnyTitleWithinItsFirstLine) {
    sweep::SweepResult chart = small_chart();
    chart.study.base.title = "one\n2,3 | \"so\": x";
    EXPECT_EQ(parse(csv_of(chart, "c.toml")).facts.at("title"), "one 2,3 / 'so': x");
}

TEST(TraceCsv, HoldsEverySampleOfARun) {
    parameters::Case c = parameters::paper_case(parameters::PaperCase::squeal);
    c.run.step = 1e-6;
    c.run.duration = 0.1;
    c.run.window = 0.1;
    record::Request request;
    request.history = record::KeepHistory::yes;
    request.trace = {0.0, 0.01, 1e-3};
    const integration::Motion motion = integration::simulate(c, request);
    const Table trace = parse(trace_csv(c, motion.record.trace, request.trace.interval));
    ASSERT_EQ(trace.rows.size(), motion.record.trace.time.size());
    ASSERT_GT(trace.rows.size(), 5U);
    EXPECT_EQ(trace.facts.at("schema"), "stridor.trace/1");
    EXPECT_EQ(trace.facts.at("rate"), "1000 Hz");
    EXPECT_EQ(number(trace.at(5, "displacement_y2")), motion.record.trace.displacement[2][5]);
    EXPECT_EQ(number(trace.at(5, "friction_force")), motion.record.trace.contacts.front().friction_force[5]);
    EXPECT_EQ(trace.at(5, "state"),
              model::contact_state_names[model::index_of(motion.record.trace.contacts.front().state[5])]);

    const Table history = parse(history_csv(c, motion.record.histories));
    ASSERT_EQ(history.rows.size(), motion.record.histories.front().size());
    EXPECT_EQ(history.names, (std::vector<std::string>{"state", "from", "to", "slip_velocity", "gap_velocity"}));
    EXPECT_EQ(number(history.at(1, "from")), motion.record.histories.front()[1].from);
}

TEST(TraceCsv, NumbersSeveralContacts) {
    using model::ContactState;
    const parameters::Case c;
    record::Trace trace = record::empty_trace(2, 2);
    const std::array still{0.0, 0.0};
    const std::array contacts{record::ContactSample{1.0, 0.1, 0.0, ContactState::slip},
                              record::ContactSample{2.0, 0.2, 0.0, ContactState::stick}};
    record::append(trace, {0.0, still, still, still, 0.5, contacts});
    const Table table = parse(trace_csv(c, trace, 1e-3));
    EXPECT_EQ(std::vector(table.names.begin() + 7, table.names.end()),
              (std::vector<std::string>{"surface_velocity", "normal_force_1", "friction_force_1", "gap_1", "state_1",
                                        "normal_force_2", "friction_force_2", "gap_2", "state_2"}));
    EXPECT_EQ(number(table.at(0, "friction_force_2")), 0.2);
    EXPECT_EQ(table.at(0, "state_2"), "stick");

    const Table history = parse(history_csv(c, {{{ContactState::slip, 0.0, 1.0}}, {{ContactState::stick, 0.0, 1.0}}}));
    EXPECT_EQ(history.names.front(), "contact");
    EXPECT_EQ(number(history.at(1, "contact")), 2.0);
}

}  // namespace
}  // namespace stridor::io
