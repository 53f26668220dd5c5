#include "stridor/verification/table_1.hpp"

#include "stridor/integration/simulate.hpp"

#include <fmt/format.h>

#include <string_view>

namespace stridor::verification {

namespace {

void add_checks(std::vector<Check>& checks, const Table1Column& column, parameters::Engine engine) {
    parameters::Case c = parameters::paper_case(column.which);
    c.run.engine = engine;
    c.run.step = 1e-6;  // [s] beta_2
    const bool is_exact = engine == parameters::Engine::exact;
    const double tolerance = is_exact ? table_1_exact_tolerance : beta_2_tolerance(column);
    const std::string_view name = parameters::paper_case_names[static_cast<std::size_t>(column.which)];
    for (const record::Tally& tally : integration::simulate(c).record.phases) {
        const analysis::Rates computed = analysis::rates(tally.contacts.at(0).time);
        const bool is_going = tally.phase == record::Phase::going;
        const analysis::Rates& expected = column.rates[is_going ? 0 : 1];
        const auto add = [&](const char* share, double analysis::Rates::*member) {
            checks.push_back(
                {fmt::format("{} {} {}, {}", name, is_going ? "going" : "coming", share, is_exact ? "exact" : "beta_2"),
                 expected.*member, computed.*member, tolerance});
        };
        add("stick", &analysis::Rates::stick);
        add("slip", &analysis::Rates::slip);
        add("separation", &analysis::Rates::separation);
    }
}

}  // namespace

std::vector<Check> table_1_checks() {
    std::vector<Check> checks;
    for (const Table1Column& column : table_1)
        for (const auto engine : {parameters::Engine::exact, parameters::Engine::beta_2})
            add_checks(checks, column, engine);
    return checks;
}

}  // namespace stridor::verification
